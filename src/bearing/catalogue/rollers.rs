//! Roller bearings of catalogues.

use super::{Catalogue, all, matching, normal};
use crate::bearing::{ClearanceClass, RollerLine};

/// A roller bearing of the catalogue.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RollerEntry {
    /// Designation, for instance `NU206`.
    pub designation: String,
    /// The designation as those that are looked up are compared with it.
    pub(super) key: String,
    /// Maker whose ratings are printed.
    pub maker: String,
    /// Where the numbers come from.
    pub source: String,
    /// What is printed or known.
    pub line: RollerLine,
}

/// Suffixes of roller bearings that change neither rollers nor races of these designations: designs, cages, grooves for
/// oil. A tapered bore, K, is another bearing: its clearance differs.
const SUFFIXES: &str = "ECP ECJ ECML ECM ECPH EC ETN9 ET EW E1 E CC CJ CA CW33 W33 W20 TVP2 TVPB TVPA XL J2 JR J A Q RHR R MB MA M C";

/// The roller bearing of a designation, and the class of clearance that its suffixes name; none where there is none.
pub(crate) fn look_up_rollers<'a>(
    file: &'a Catalogue,
    designation: &str,
) -> Option<(&'a RollerEntry, Option<ClearanceClass>)> {
    let wanted = normal(designation);
    let entries = all(file).flat_map(|catalogue| &catalogue.rollers);
    matching(entries, |entry| &entry.key, &wanted, SUFFIXES).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::BearingError;
    use crate::bearing::catalogue::{CATALOGUE, EMPTY};

    #[test]
    fn every_shipped_roller_bearing_has_rollers_of_its_ratings() -> Result<(), BearingError> {
        assert!(CATALOGUE.rollers.len() >= 60);
        for entry in &CATALOGUE.rollers {
            let line = &entry.line;
            let estimate = line.estimate().map_err(Box::new)?;
            let off = estimate.best.static_rating / line.static_rating - 1.0;
            assert!(off.abs() < 0.02, "{}: {off}", entry.designation);
            let found = look_up_rollers(&EMPTY, &entry.designation).map(|(found, _)| found);
            assert_eq!(found, Some(entry));
        }
        Ok(())
    }

    /// The 2 and the 22 series of a bore have the same raceways, and the ratings of both find as many rollers.
    #[test]
    fn ratings_of_two_series_find_the_same_rollers() {
        for bore in ["05", "06", "07", "08", "10", "12"] {
            let [narrow, wide] = ["NU2", "NU22"].map(|series| {
                let (entry, _) =
                    look_up_rollers(&EMPTY, &format!("{series}{bore}")).expect("an entry");
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
            let (entry, found) = look_up_rollers(&EMPTY, text).expect(text);
            assert_eq!((entry.designation.as_str(), found), (designation, class));
        }
        for unknown in ["22212 K", "NU20", "NU2060", "N206"] {
            assert!(look_up_rollers(&EMPTY, unknown).is_none(), "{unknown}");
        }
    }
}
