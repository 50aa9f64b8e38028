//! Bearings by their designation: what catalogues print, and what is known of their inside.

mod designation;
mod file;
mod kind;
mod unknown;

pub(crate) use designation::Suffixes;
pub(crate) use file::read;
pub use unknown::UnknownBearing;

use std::sync::{LazyLock, OnceLock};

use designation::{Elements, has_other_rollers, normal, suffixes};

use super::{Bearing, BearingError, CatalogueLine, ClearanceClass, FreePosition, RollerLine};
use crate::physics::SkfFriction;

/// A bearing of a catalogue, and what is printed or known of its balls or rollers.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CatalogueEntry<L = CatalogueLine> {
    /// Designation, for instance `7205C`.
    pub designation: String,
    /// The designation as those that are looked up are compared with it.
    pub(super) key: String,
    /// Maker whose ratings are printed; empty where the numbers come from elsewhere.
    pub maker: String,
    /// Where the numbers come from.
    pub source: String,
    /// What is printed or known.
    pub line: L,
}

/// A roller bearing of a catalogue.
pub type RollerEntry = CatalogueEntry<RollerLine>;

/// The bearings of a catalogue.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Catalogue {
    /// Ball bearings.
    pub balls: Vec<CatalogueEntry>,
    /// Roller bearings.
    pub rollers: Vec<RollerEntry>,
}

/// The catalogue that is shipped, as a file of the user's own has it.
pub(crate) const SHIPPED: &str = include_str!("../bearings.csv");

/// All bearings that are shipped; of two with one designation the first one, whose inside is known, is found.
pub static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(|| read(SHIPPED).unwrap_or_default());

/// The catalogue of a scenario that names none.
pub(crate) static EMPTY: Catalogue = Catalogue {
    balls: Vec::new(),
    rollers: Vec::new(),
};

/// The user's own bearings, which come first.
static OWN: OnceLock<Catalogue> = OnceLock::new();

/// Lets the user's own bearings be found wherever a designation is looked up, from now on; once.
pub(crate) fn add_own(catalogue: Catalogue) {
    let _ = OWN.set(catalogue);
}

/// All catalogues: the file that a scenario names, the user's own one, the one that is shipped.
pub(crate) fn all(file: &Catalogue) -> impl Iterator<Item = &Catalogue> {
    [Some(file), OWN.get(), Some(&CATALOGUE)]
        .into_iter()
        .flatten()
}

/// All ball bearings.
fn all_balls(file: &Catalogue) -> impl Iterator<Item = &CatalogueEntry> {
    all(file).flat_map(|catalogue| &catalogue.balls)
}

/// All roller bearings.
fn all_rollers(file: &Catalogue) -> impl Iterator<Item = &RollerEntry> {
    all(file).flat_map(|catalogue| &catalogue.rollers)
}

/// A bearing that was looked up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Found<'a> {
    Balls(&'a CatalogueEntry),
    Rollers(&'a RollerEntry),
}

/// The bearing of a designation, that of balls where there are two, and what its suffixes say;
/// letter case, blanks and the maker's name do not matter, and suffixes of seals, cages and tolerances change nothing.
///
/// # Errors
/// [`UnknownBearing`] says what comes near.
pub(crate) fn look_up<'a>(
    file: &'a Catalogue,
    designation: &str,
) -> Result<(Found<'a>, Suffixes), UnknownBearing> {
    let wanted = normal(designation);
    let odd = match matching(all_balls(file), &wanted, Elements::Balls) {
        Ok((entry, said)) => return Ok((Found::Balls(entry), said)),
        Err(odd) => odd,
    };
    matching(all_rollers(file), &wanted, Elements::Rollers)
        .map(|(entry, said)| (Found::Rollers(entry), said))
        .map_err(|rollers| {
            let other = rollers.filter(|(_, suffix)| has_other_rollers(suffix));
            match other {
                Some(other) => UnknownBearing::of_other_rollers(designation, other),
                None => UnknownBearing::new(file, designation, odd),
            }
        })
}

/// An entry, and what the suffixes of its designation say.
type Matched<'a, L> = (&'a CatalogueEntry<L>, Suffixes);

/// An entry, and the suffix that is not known of it.
type Odd<'a, 'w, L> = (&'a CatalogueEntry<L>, &'w str);

/// The entry with the longest key that a designation in capital letters without blanks is, but for suffixes, and what these
/// say; or else an entry with the suffix that is not known.
fn matching<'a, 'w, L>(
    entries: impl Iterator<Item = &'a CatalogueEntry<L>>,
    wanted: &'w str,
    elements: Elements,
) -> Result<Matched<'a, L>, Option<Odd<'a, 'w, L>>> {
    let mut found: Option<Matched<'_, L>> = None;
    let mut odd: Option<Odd<'_, '_, L>> = None;
    for entry in entries {
        let base = entry.key.as_str();
        let Some(rest) = wanted.strip_prefix(base) else {
            continue;
        };
        let is_number = rest.starts_with(|c: char| c.is_ascii_digit());
        if base.is_empty() || is_number && suffixes(rest, elements).is_err() {
            continue;
        }
        let is_longer = |found: &Matched<'_, L>| base.len() > found.0.key.len();
        match suffixes(rest, elements) {
            Ok(said) if found.as_ref().is_none_or(is_longer) => found = Some((entry, said)),
            Ok(_) => {}
            Err(part) => odd = odd.or(Some((entry, part))),
        }
    }
    found.ok_or(odd)
}

/// The entry of a designation that is shipped or the user's own.
#[cfg(test)]
pub(crate) fn find(designation: &str) -> Option<CatalogueEntry> {
    match look_up(&EMPTY, designation) {
        Ok((Found::Balls(entry), _)) => Some(entry.clone()),
        _ => None,
    }
}

impl Bearing {
    /// The ball bearing of a designation, in SI units, balls and rings of bearing steel; letter case and blanks do not
    /// matter, and suffixes of seals, cages, tolerances and clearance are understood.
    ///
    /// # Errors
    /// [`UnknownBearing`] says what comes near.
    pub fn catalogue(designation: &str) -> Result<Self, UnknownBearing> {
        let (Found::Balls(entry), said) = look_up(&EMPTY, designation)? else {
            return Err(UnknownBearing::new(&EMPTY, designation, None));
        };
        let bearing = entry.of_class(said.class.unwrap_or_default());
        bearing.map_err(|error| UnknownBearing {
            designation: designation.to_owned(),
            help: error.to_string(),
        })
    }
}

impl CatalogueLine {
    /// Where the races are without load: by the contact angle, or by the middle of a class of clearance of a
    /// deep-groove bearing; none where the class has no clearance for the bore.
    pub(crate) fn free_position(&self, class: ClearanceClass) -> Option<FreePosition> {
        if self.contact_angle > 0.0 {
            return Some(FreePosition::ContactAngle(self.contact_angle));
        }
        let clearance = class.middle(self.bore)?;
        Some(FreePosition::DiametralClearance(clearance))
    }
}

impl CatalogueEntry {
    /// The bearing in SI units, balls and rings of bearing steel, a deep-groove bearing with the clearance of
    /// class CN.
    ///
    /// # Errors
    /// [`BearingError`], which no shipped entry gives.
    pub(crate) fn bearing(&self) -> Result<Bearing, BearingError> {
        self.of_class(ClearanceClass::CN)
    }

    fn of_class(&self, class: ClearanceClass) -> Result<Bearing, BearingError> {
        let estimate = self.line.estimate().map_err(Box::new)?;
        let free = self.line.free_position(class);
        let free = free.unwrap_or(FreePosition::DiametralClearance(0.0));
        let angular = self.line.contact_angle > 0.0;
        Ok(Bearing {
            dynamic_rating: Some(self.line.dynamic_rating),
            clearance_class: (!angular).then_some(class),
            boundary: Some([self.line.bore, self.line.outside_diameter]),
            estimated: estimate.is_estimated(),
            skf_friction: SkfFriction::from_designation(&self.designation),
            ..Bearing::of_steel(estimate.geometry(free)?)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suffixes_change_nothing_but_the_clearance() {
        for (text, designation, class) in [
            ("6205-2RS", "6205", None),
            ("6205/C3", "6205", Some(ClearanceClass::C3)),
            ("6205 ZZ C3", "6205", Some(ClearanceClass::C3)),
            ("6205-2RS1/C4", "6205", Some(ClearanceClass::C4)),
            ("6306DDUC3", "6306", Some(ClearanceClass::C3)),
            ("7205 c", "7205C", None),
            ("7205C-P4", "7205C", None),
            ("6205-2RS JEM", "6205", None),
            ("SKF 6205-2RSH", "6205", None),
            ("6205-2rs jem skf", "6205", None),
            ("nsk 6205dduc3", "6205", Some(ClearanceClass::C3)),
            ("6205 LLU/5K", "6205", None),
            ("6205-ZZ", "6205", None),
            ("6205 2RS1", "6205", None),
            ("6205.2ZR.C4", "6205", Some(ClearanceClass::C4)),
        ] {
            let (found, named) = look_up(&EMPTY, text).expect(text);
            let expected = find(designation).expect(designation);
            assert_eq!((found, named.class), (Found::Balls(&expected), class));
        }
    }

    #[test]
    fn seals_that_rub_are_known() {
        let rubs = |text: &str| look_up(&EMPTY, text).expect(text).1.rubs;
        for sealed in [
            "6205-2RS1",
            "6205-2RS/C3",
            "6306DDUC3",
            "6205 LLU/5K",
            "SKF 6205-RSH",
        ] {
            assert!(rubs(sealed), "{sealed}");
        }
        for open in [
            "6205",
            "6205 ZZ C3",
            "6205-2RZ",
            "6205-2RSL",
            "6205VV",
            "7205C-P4",
        ] {
            assert!(!rubs(open), "{open}");
        }
    }

    fn rollers(designation: &str) -> Option<(&'static RollerEntry, Option<ClearanceClass>)> {
        match look_up(&EMPTY, designation) {
            Ok((Found::Rollers(entry), said)) => Some((entry, said.class)),
            _ => None,
        }
    }

    #[test]
    fn suffixes_of_roller_bearings() {
        for (text, designation, class) in [
            ("NU 206 P", "NU206", None),
            ("SKF NU206 M/C3", "NU206", Some(ClearanceClass::C3)),
            ("NU206-TVP2", "NU206", None),
            ("NU206J", "NU206", None),
            ("22212 CC/W33/C3", "22212", Some(ClearanceClass::C3)),
            ("22212RHR", "22212", None),
            ("30206 J2/Q", "30206", None),
            ("30206JR", "30206", None),
        ] {
            let (entry, found) = rollers(text).expect(text);
            assert_eq!((entry.designation.as_str(), found), (designation, class));
        }
        for unknown in ["22212 K", "NU20", "NU2060", "N206"] {
            assert!(rollers(unknown).is_none(), "{unknown}");
        }
    }

    /// The design E of NU 206 has C 44 kN (SKF, NU 206 ECP), the standard one 23.5 kN.
    #[test]
    fn designs_with_other_rollers_are_refused() {
        for text in [
            "NU 206 ECP/C3",
            "NU206E",
            "NU206EM",
            "NU206-EE",
            "NU206EW C3",
            "NU206ETN9",
            "NU206-E-XL-TVP2",
            "NU206 P6 ECP",
            "NU206R",
            "NU206V",
        ] {
            let help = look_up(&EMPTY, text).expect_err(text).help;
            let line = ["kind = \"cylindrical\"", "bore = \"30 mm\"", "static = "];
            assert!(line.iter().all(|part| help.contains(part)), "{help}");
        }
        for text in ["22212 E", "22212-E1-XL", "22212EK"] {
            let help = look_up(&EMPTY, text).expect_err(text).help;
            assert!(help.contains("contact_angle = \"9.09 deg\""), "{help}");
        }
    }

    #[test]
    fn a_catalogue_line_of_a_high_capacity_design_is_found() {
        let table = "designation,kind,bore_mm,outside_diameter_mm,width_mm,contact_angle_deg,\
                     dynamic_rating_N,static_rating_N\n\
                     NU 206 E,cylindrical,30,62,16,0,44000,36500\n";
        let own = read(table).expect("a catalogue");
        for text in ["NU206E", "NU 206 ECP/C3", "NU206ETVP2"] {
            let (found, _) = look_up(&own, text).expect(text);
            assert_eq!(found, Found::Rollers(&own.rollers[0]));
        }
        let (found, _) = look_up(&own, "NU206").expect("the standard design");
        assert!(matches!(found, Found::Rollers(entry) if entry.designation == "NU206"));
    }

    #[test]
    fn every_shipped_roller_bearing_has_rollers_of_its_ratings() -> Result<(), BearingError> {
        assert!(CATALOGUE.rollers.len() >= 60);
        for entry in &CATALOGUE.rollers {
            let line = &entry.line;
            let estimate = line.estimate().map_err(Box::new)?;
            let off = estimate.best.static_rating / line.static_rating - 1.0;
            assert!(off.abs() < 0.02, "{}: {off}", entry.designation);
            let found = rollers(&entry.designation).map(|(found, _)| found);
            assert_eq!(found, Some(entry));
        }
        Ok(())
    }

    /// The 2 and the 22 series of a bore have the same raceways, and the ratings of both find as many rollers.
    #[test]
    fn ratings_of_two_series_find_the_same_rollers() {
        for bore in ["05", "06", "07", "08", "10", "12"] {
            let [narrow, wide] = ["NU2", "NU22"].map(|series| {
                let (entry, _) = rollers(&format!("{series}{bore}")).expect("an entry");
                entry.line.estimate().expect("rollers").best
            });
            assert_eq!(narrow.rollers, wide.rollers, "{bore}");
            assert!(narrow.length < wide.length);
        }
    }

    /// Lists of makers for oil: NU 206 some 14 000 rpm, 30206 9000 to 12 000, 22212 6300.
    #[test]
    fn rollers_run_slower_than_balls_of_their_size() {
        let limit = |designation: &str| {
            let (entry, _) = rollers(designation).expect(designation);
            let estimate = entry.line.estimate().expect("rollers");
            let geometry = estimate.geometry(entry.line.contact_angle);
            let bearing = Bearing::of_steel(geometry.expect("a geometry"));
            bearing.highest_permissible_speed() * crate::physics::PER_MINUTE
        };
        for (designation, least, most) in [
            ("NU206", 13_000.0, 16_000.0),
            ("30206", 9000.0, 12_000.0),
            ("22212", 5500.0, 6500.0),
        ] {
            let limit = limit(designation);
            assert!((least..most).contains(&limit), "{designation}: {limit}");
        }
    }

    #[test]
    fn only_the_same_number_is_suggested() {
        let help = |text| look_up(&EMPTY, text).expect_err(text).help;
        assert!(help("7205").contains("\"7205C\""));
        assert!(help("6205C").contains("the suffix \"C\" is not known"));
        assert!(help("6299").contains("6200 to 6220"), "{}", help("6299"));
        assert!(!help("62089").contains("did you mean"));
    }

    #[test]
    fn other_kinds_of_bearing_are_named() {
        let help = |text| Bearing::catalogue(text).expect_err(text).help;
        for (kind, designations) in [
            (
                "a cylindrical roller",
                "NU206,NJ 206 ECP,N206,NUP2206,nu 206",
            ),
            ("a tapered roller", "32008 X,30205,33205"),
            ("a spherical roller", "22208 E,22312,23024 CC/W33"),
            ("a needle roller", "RNA4905,HK1612,K 12x15x10,NA4905"),
            ("a self-aligning ball", "1205 ETN9,2205-2RS1,1306 K"),
            (
                "an angular contact ball bearing with two rows",
                "3205 A-2Z,5206",
            ),
            ("a thrust ball bearing", "51105,51105 J"),
            ("a toroidal roller", "C 2205"),
        ] {
            for designation in designations.split(',') {
                let help = help(designation);
                assert!(
                    help.starts_with(&format!("it is {kind}")),
                    "{designation}: {help}"
                );
                assert!(!help.contains("catalogue line"), "{designation}: {help}");
            }
        }
        for (designation, angle) in [
            ("7205B", 40),
            ("7205 AC", 25),
            ("7205BECBP", 40),
            ("7205ACD/P4A", 25),
        ] {
            let help = help(designation);
            assert!(
                help.contains(&format!("contact_angle = \"{angle} deg\"")),
                "{help}"
            );
            assert!(
                help.contains("7205C") && !help.contains("did you mean"),
                "{help}"
            );
        }
    }

    #[test]
    fn every_shipped_bearing_is_one() {
        assert!(CATALOGUE.balls.len() >= 120);
        for entry in &CATALOGUE.balls {
            assert!(entry.bearing().is_ok(), "{}", entry.designation);
        }
    }
}
