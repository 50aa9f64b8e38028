//! The roller bearings that are shipped.

use std::sync::LazyLock;

use serde::Deserialize;

use super::{matching, normal};
use crate::bearing::{ClearanceClass, RollerKind, RollerLine};

/// A roller bearing of the catalogue.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RollerEntry {
    /// Designation, for instance `NU206`.
    pub designation: String,
    /// Maker whose ratings are printed.
    pub maker: String,
    /// Where the numbers come from.
    pub source: String,
    /// What is printed or known.
    pub line: RollerLine,
}

/// A row of the file.
#[derive(Deserialize)]
struct Row {
    designation: String,
    kind: RollerKind,
    bore_mm: f64,
    outside_diameter_mm: f64,
    width_mm: f64,
    contact_angle_deg: f64,
    #[serde(rename = "dynamic_rating_N")]
    dynamic_rating: f64,
    #[serde(rename = "static_rating_N")]
    static_rating: f64,
    roller_diameter_mm: Option<f64>,
    pitch_diameter_mm: Option<f64>,
    maker: String,
    source: String,
}

impl From<Row> for RollerEntry {
    fn from(row: Row) -> Self {
        let boundary = [row.bore_mm, row.outside_diameter_mm, row.width_mm];
        let metres = |length: f64| length / 1e3;
        Self {
            line: RollerLine {
                kind: row.kind,
                boundary: boundary.map(metres),
                contact_angle: row.contact_angle_deg.to_radians(),
                dynamic_rating: row.dynamic_rating,
                static_rating: row.static_rating,
                rollers: None,
                diameter: row.roller_diameter_mm.map(metres),
                length: None,
                pitch_diameter: row.pitch_diameter_mm.map(metres),
            },
            designation: row.designation,
            maker: row.maker,
            source: row.source,
        }
    }
}

/// All roller bearings that are shipped.
pub static ROLLER_CATALOGUE: LazyLock<Vec<RollerEntry>> = LazyLock::new(|| {
    let mut reader = csv::Reader::from_reader(include_bytes!("../rollers.csv").as_slice());
    let rows = reader.deserialize::<Row>().flatten();
    rows.map(RollerEntry::from).collect()
});

/// Suffixes of roller bearings that change neither rollers nor races of these designations: designs, cages, grooves for
/// oil. A tapered bore, K, is another bearing: its clearance differs.
const SUFFIXES: &str = "ECP ECJ ECML ECM ECPH EC ETN9 ET EW E1 E CC CJ CA CW33 W33 W20 TVP2 TVPB TVPA XL J2 JR J A Q RHR R MB MA M C";

/// The roller bearing of a designation, and the class of clearance that its suffixes name; none where there is none.
pub(crate) fn look_up_rollers(
    designation: &str,
) -> Option<(&'static RollerEntry, Option<ClearanceClass>)> {
    let wanted = normal(designation);
    let entries = ROLLER_CATALOGUE.iter();
    matching(entries, |entry| &entry.designation, &wanted, SUFFIXES).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::BearingError;

    #[test]
    fn every_shipped_roller_bearing_has_rollers_of_its_ratings() -> Result<(), BearingError> {
        assert!(ROLLER_CATALOGUE.len() >= 60);
        for entry in ROLLER_CATALOGUE.iter() {
            let line = &entry.line;
            let estimate = line.estimate().map_err(Box::new)?;
            let off = estimate.best.static_rating / line.static_rating - 1.0;
            assert!(off.abs() < 0.02, "{}: {off}", entry.designation);
            let found = look_up_rollers(&entry.designation).map(|(found, _)| found);
            assert_eq!(found, Some(entry));
        }
        Ok(())
    }

    /// The 2 and the 22 series of a bore have the same raceways, and the ratings of both find as many rollers.
    #[test]
    fn ratings_of_two_series_find_the_same_rollers() {
        for bore in ["05", "06", "07", "08", "10", "12"] {
            let [narrow, wide] = ["NU2", "NU22"].map(|series| {
                let (entry, _) = look_up_rollers(&format!("{series}{bore}")).expect("an entry");
                entry.line.estimate().expect("rollers").best
            });
            assert_eq!(narrow.rollers, wide.rollers, "{bore}");
            assert!(narrow.length < wide.length);
        }
    }

    #[test]
    fn suffixes_of_roller_bearings() {
        for (text, designation, class) in [
            ("NU 206 ECP", "NU206", None),
            ("SKF NU206 ECM/C3", "NU206", Some(ClearanceClass::C3)),
            ("22212 E/C3", "22212", Some(ClearanceClass::C3)),
            ("22212-E1-XL", "22212", None),
            ("30206 J2/Q", "30206", None),
        ] {
            let (entry, found) = look_up_rollers(text).expect(text);
            assert_eq!((entry.designation.as_str(), found), (designation, class));
        }
        for unknown in ["22212 K", "NU20", "NU2060", "N206"] {
            assert!(look_up_rollers(unknown).is_none(), "{unknown}");
        }
    }
}
