//! Radial internal clearance of deep-groove and roller bearings by class.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::RollerKind;

/// Class of the radial internal clearance of a deep-groove ball bearing, or of cylindrical, needle or spherical rollers, as
/// it is made.
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

/// The bore in mm above which a table begins, and its rows.
type Table = (f64, &'static [Row]);

/// Deep-groove ball bearings, bores up to 140 mm: ISO 5753-1:2009, table 1.
#[rustfmt::skip]
const DEEP_GROOVE: Table = (6.0, &[
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
]);

/// Cylindrical and needle rollers in bearings with a cylindrical bore up to 250 mm: ISO 5753-1:2009, as makers print it.
#[rustfmt::skip]
const CYLINDRICAL: Table = (0.0, &[
    (24.0, [[0.0, 25.0], [20.0, 45.0], [35.0, 60.0], [50.0, 75.0], [65.0, 90.0]]),
    (30.0, [[0.0, 25.0], [20.0, 45.0], [35.0, 60.0], [50.0, 75.0], [70.0, 95.0]]),
    (40.0, [[5.0, 30.0], [25.0, 50.0], [45.0, 70.0], [60.0, 85.0], [80.0, 105.0]]),
    (50.0, [[5.0, 35.0], [30.0, 60.0], [50.0, 80.0], [70.0, 100.0], [95.0, 125.0]]),
    (65.0, [[10.0, 40.0], [40.0, 70.0], [60.0, 90.0], [80.0, 110.0], [110.0, 140.0]]),
    (80.0, [[10.0, 45.0], [40.0, 75.0], [65.0, 100.0], [90.0, 125.0], [130.0, 165.0]]),
    (100.0, [[15.0, 50.0], [50.0, 85.0], [75.0, 110.0], [105.0, 140.0], [155.0, 190.0]]),
    (120.0, [[15.0, 55.0], [50.0, 90.0], [85.0, 125.0], [125.0, 165.0], [180.0, 220.0]]),
    (140.0, [[15.0, 60.0], [60.0, 105.0], [100.0, 145.0], [145.0, 190.0], [200.0, 245.0]]),
    (160.0, [[20.0, 70.0], [70.0, 120.0], [115.0, 165.0], [165.0, 215.0], [225.0, 275.0]]),
    (180.0, [[25.0, 75.0], [75.0, 125.0], [120.0, 170.0], [170.0, 220.0], [250.0, 300.0]]),
    (200.0, [[35.0, 90.0], [90.0, 145.0], [140.0, 195.0], [195.0, 250.0], [275.0, 330.0]]),
    (225.0, [[45.0, 105.0], [105.0, 165.0], [160.0, 220.0], [220.0, 280.0], [305.0, 365.0]]),
    (250.0, [[45.0, 110.0], [110.0, 175.0], [170.0, 235.0], [235.0, 300.0], [330.0, 395.0]]),
]);

/// Spherical rollers in bearings with a cylindrical bore up to 250 mm: ISO 5753-1:2009, as makers print it.
#[rustfmt::skip]
const SPHERICAL: Table = (18.0, &[
    (24.0, [[10.0, 20.0], [20.0, 35.0], [35.0, 45.0], [45.0, 60.0], [60.0, 75.0]]),
    (30.0, [[15.0, 25.0], [25.0, 40.0], [40.0, 55.0], [55.0, 75.0], [75.0, 95.0]]),
    (40.0, [[15.0, 30.0], [30.0, 45.0], [45.0, 60.0], [60.0, 80.0], [80.0, 100.0]]),
    (50.0, [[20.0, 35.0], [35.0, 55.0], [55.0, 75.0], [75.0, 100.0], [100.0, 125.0]]),
    (65.0, [[20.0, 40.0], [40.0, 65.0], [65.0, 90.0], [90.0, 120.0], [120.0, 150.0]]),
    (80.0, [[30.0, 50.0], [50.0, 80.0], [80.0, 110.0], [110.0, 145.0], [145.0, 185.0]]),
    (100.0, [[35.0, 60.0], [60.0, 100.0], [100.0, 135.0], [135.0, 180.0], [180.0, 225.0]]),
    (120.0, [[40.0, 75.0], [75.0, 120.0], [120.0, 160.0], [160.0, 210.0], [210.0, 260.0]]),
    (140.0, [[50.0, 95.0], [95.0, 145.0], [145.0, 190.0], [190.0, 240.0], [240.0, 300.0]]),
    (160.0, [[60.0, 110.0], [110.0, 170.0], [170.0, 220.0], [220.0, 280.0], [280.0, 350.0]]),
    (180.0, [[65.0, 120.0], [120.0, 180.0], [180.0, 240.0], [240.0, 310.0], [310.0, 390.0]]),
    (200.0, [[70.0, 130.0], [130.0, 200.0], [200.0, 260.0], [260.0, 340.0], [340.0, 430.0]]),
    (225.0, [[80.0, 140.0], [140.0, 220.0], [220.0, 290.0], [290.0, 380.0], [380.0, 470.0]]),
    (250.0, [[90.0, 150.0], [150.0, 240.0], [240.0, 320.0], [320.0, 420.0], [420.0, 520.0]]),
]);

impl ClearanceClass {
    /// All of them.
    pub(super) const ALL: [Self; 5] = [Self::C2, Self::CN, Self::C3, Self::C4, Self::C5];

    /// Least and largest diametral clearance of a deep-groove bearing by its bore, both in m; none for bores up to 6 mm or
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
        self.within(DEEP_GROOVE, bore)
    }

    /// As [`ClearanceClass::range`] of a roller bearing; none of a tapered one, nor above 250 mm.
    ///
    /// ```
    /// use jeffcott::bearing::{ClearanceClass, RollerKind};
    /// let range = |kind| ClearanceClass::C3.roller_range(kind, 0.060);
    /// assert_eq!(range(RollerKind::Cylindrical), Some([60e-6, 90e-6]));
    /// assert_eq!(range(RollerKind::Spherical), Some([65e-6, 90e-6]));
    /// assert_eq!(range(RollerKind::Tapered), None);
    /// ```
    pub fn roller_range(self, kind: RollerKind, bore: f64) -> Option<[f64; 2]> {
        match kind {
            RollerKind::Cylindrical | RollerKind::Needle => self.within(CYLINDRICAL, bore),
            RollerKind::Spherical => self.within(SPHERICAL, bore),
            RollerKind::Tapered => None,
        }
    }

    fn within(self, (above, rows): Table, bore: f64) -> Option<[f64; 2]> {
        // a bore in mm that is a row's limit belongs to that row
        let bore = (1e9 * bore).round() / 1e6;
        let row = rows.iter().find(|(largest, _)| bore <= *largest);
        let (_, classes) = row.filter(|_| bore > above)?;
        Some(classes[self as usize].map(|clearance| clearance / 1e6))
    }

    /// The middle of [`ClearanceClass::range`], m.
    pub fn middle(self, bore: f64) -> Option<f64> {
        self.range(bore).map(middle)
    }

    /// The middle of [`ClearanceClass::roller_range`], m.
    pub(crate) fn roller_middle(self, kind: RollerKind, bore: f64) -> Option<f64> {
        self.roller_range(kind, bore).map(middle)
    }

    /// `CN`.
    pub fn name(self) -> &'static str {
        ["C2", "CN", "C3", "C4", "C5"][self as usize]
    }
}

fn middle([least, largest]: [f64; 2]) -> f64 {
    0.5 * (least + largest)
}

/// Diametral clearance of a deep-groove or roller bearing, and where it comes from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Clearance {
    /// Its size as mounted, m.
    #[serde(rename = "diametral_m")]
    pub diametral: f64,
    /// The class whose middle was taken; none where the clearance is given.
    pub class: Option<ClearanceClass>,
}
