//! Radial internal clearance of deep-groove bearings by class.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Class of the radial internal clearance of a deep-groove ball bearing as it is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum ClearanceClass {
    /// Less than normal.
    C2,
    /// Normal.
    #[default]
    CN,
    /// More than normal.
    C3,
    /// More than C3.
    C4,
    /// More than C4.
    C5,
}

/// Largest bore of a row in mm, then the least and the largest clearance of each class in µm.
type Row = (f64, [[f64; 2]; 5]);

/// The table begins above this bore, mm.
const SMALLEST_BORE: f64 = 6.0;

/// ISO 5753-1:2009, table 1, bores up to 140 mm.
#[rustfmt::skip]
const TABLE: [Row; 11] = [
    (10.0, [[0.0, 7.0], [2.0, 13.0], [8.0, 23.0], [14.0, 29.0], [20.0, 37.0]]),
    (18.0, [[0.0, 9.0], [3.0, 18.0], [11.0, 25.0], [18.0, 33.0], [25.0, 45.0]]),
    (24.0, [[0.0, 10.0], [5.0, 20.0], [13.0, 28.0], [20.0, 36.0], [28.0, 48.0]]),
    (30.0, [[1.0, 11.0], [5.0, 20.0], [13.0, 28.0], [23.0, 41.0], [30.0, 53.0]]),
    (40.0, [[1.0, 11.0], [6.0, 20.0], [15.0, 33.0], [28.0, 46.0], [40.0, 64.0]]),
    (50.0, [[1.0, 11.0], [6.0, 23.0], [18.0, 36.0], [30.0, 51.0], [45.0, 73.0]]),
    (65.0, [[1.0, 15.0], [8.0, 28.0], [23.0, 43.0], [38.0, 61.0], [55.0, 90.0]]),
    (80.0, [[1.0, 15.0], [10.0, 30.0], [25.0, 51.0], [46.0, 71.0], [65.0, 105.0]]),
    (100.0, [[1.0, 18.0], [12.0, 36.0], [30.0, 58.0], [53.0, 84.0], [75.0, 120.0]]),
    (120.0, [[2.0, 20.0], [15.0, 41.0], [36.0, 66.0], [61.0, 97.0], [90.0, 140.0]]),
    (140.0, [[2.0, 23.0], [18.0, 48.0], [41.0, 81.0], [71.0, 114.0], [105.0, 160.0]]),
];

impl ClearanceClass {
    /// All of them.
    pub(super) const ALL: [Self; 5] = [Self::C2, Self::CN, Self::C3, Self::C4, Self::C5];

    /// Least and largest diametral clearance of a bearing by its bore, both in m; none for bores up to 6 mm or
    /// above 140 mm.
    ///
    /// Source: ISO 5753-1:2009, table 1.
    ///
    /// ```
    /// use jeffcott::bearing::ClearanceClass;
    /// assert_eq!(ClearanceClass::C3.range(0.025), Some([13e-6, 28e-6]));
    /// assert_eq!(ClearanceClass::CN.middle(0.025), Some(12.5e-6));
    /// assert_eq!(ClearanceClass::CN.range(0.3), None);
    /// ```
    pub fn range(self, bore: f64) -> Option<[f64; 2]> {
        // a bore in mm that is a row's limit belongs to that row
        let bore = (1e9 * bore).round() / 1e6;
        let row = TABLE.iter().find(|(largest, _)| bore <= *largest);
        let (_, classes) = row.filter(|_| bore > SMALLEST_BORE)?;
        Some(classes[self as usize].map(|clearance| clearance / 1e6))
    }

    /// The middle of [`ClearanceClass::range`], m.
    pub fn middle(self, bore: f64) -> Option<f64> {
        self.range(bore)
            .map(|[least, largest]| 0.5 * (least + largest))
    }

    /// `CN`.
    pub fn name(self) -> &'static str {
        ["C2", "CN", "C3", "C4", "C5"][self as usize]
    }
}

/// Diametral clearance of a deep-groove bearing, and where it comes from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Clearance {
    /// Its size as mounted, m.
    #[serde(rename = "diametral_m")]
    pub diametral: f64,
    /// The class whose middle was taken; none where the clearance is given.
    pub class: Option<ClearanceClass>,
}
