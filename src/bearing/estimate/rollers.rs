//! Rollers whose ratings come closest to those that a catalogue prints.

use serde::Serialize;

use super::EstimateError;
use super::checks::{check_print, near_as_well, off_print};
use super::search::{BY_ISO, LARGEST_STATIC, UNUSUAL, dynamic_deviation, is_rated_within};
use crate::bearing::{Geometry, GeometryError, Profile, RollerKind, Rollers};
use crate::physics::{roller_dynamic_rating, roller_static_rating};

/// What a catalogue prints of a roller bearing; the rollers where they are known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollerLine {
    /// Kind of the bearing.
    pub kind: RollerKind,
    /// Bore, outside diameter and width of the inner ring, m.
    pub boundary: [f64; 3],
    /// Nominal contact angle, rad.
    pub contact_angle: f64,
    /// Basic dynamic load rating C, N.
    pub dynamic_rating: f64,
    /// Basic static load rating C_0, N.
    pub static_rating: f64,
    /// Number of rollers of a row.
    pub rollers: Option<usize>,
    /// Diameter of a roller, m.
    pub diameter: Option<f64>,
    /// Effective length of a roller, m.
    pub length: Option<f64>,
    /// Pitch diameter, m.
    pub pitch_diameter: Option<f64>,
}

/// Rollers that may be those of a bearing, and the ratings that they have.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RollerCandidate {
    /// Number of rollers of a row.
    pub rollers: usize,
    /// Diameter, m.
    #[serde(rename = "roller_diameter_m")]
    pub diameter: f64,
    /// Effective length, m.
    #[serde(rename = "roller_length_m")]
    pub length: f64,
    /// C by ISO 281, N.
    #[serde(rename = "dynamic_rating_N")]
    pub dynamic_rating: f64,
    /// C_0 by ISO 76, N.
    #[serde(rename = "static_rating_N")]
    pub static_rating: f64,
    /// How far they are from the print, by the rules of [`RollerLine::estimate`].
    pub deviation: f64,
}

impl std::fmt::Display for RollerCandidate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [diameter, length] =
            [self.diameter, self.length].map(|size| (1e6 * size).round() / 1e3);
        write!(
            f,
            "{} rollers of {diameter} × {length} mm (C {:.0} N, C0 {:.0} N, {:.1} % off)",
            self.rollers,
            self.dynamic_rating,
            self.static_rating,
            1e2 * self.deviation
        )
    }
}

/// Rollers that belong to a catalogue line.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RollerEstimate {
    /// Kind of the bearing.
    pub kind: RollerKind,
    /// The rollers that are taken.
    #[serde(flatten)]
    pub best: RollerCandidate,
    /// Pitch diameter, m.
    #[serde(rename = "pitch_diameter_m")]
    pub pitch_diameter: f64,
    /// Whether the rollers were searched for.
    pub estimated: bool,
    /// The next best rollers, where they were searched for.
    pub runner_up: Option<RollerCandidate>,
    /// What the reader should know, each with its numbers.
    pub notes: Vec<String>,
}

/// Steps of diameters and lengths, m.
const STEP: f64 = 0.5e-3;
/// Diameters that are looked at, of the height of the section.
const DIAMETERS: [f64; 2] = [0.3, 0.65];
/// C as makers print it over C by ISO 281: many rate their newer roller bearings higher.
const DYNAMIC_RATIO: [f64; 2] = [0.97, 1.20];
/// Part of the pitch circle that rollers of bearings as they are made fill.
const FILLING: [f64; 2] = [0.62, 0.96];
/// Their length over the width of a row.
const LENGTHS: [f64; 2] = [0.3, 0.85];
/// Their length over their diameter.
const SLENDERNESS: [f64; 2] = [0.7, 2.0];
/// Other rollers whose deviation is larger by less than this are named.
const CLOSE: f64 = 0.01;

impl RollerLine {
    /// Finds number, diameter and length of the rollers as far as the line does not give them.
    ///
    /// The pitch diameter is (d + D_o)/2; diameters and lengths are whole or half millimetres. C_0 decides, by
    /// [`roller_static_rating`], which lies within 4 %; C counts where it is that of [`roller_dynamic_rating`] to 1 %: makers
    /// print 0.97 to 1.2 times that, and within these limits any other C is 1 % off. The least |C_0/C_0,printed − 1| + |C/C_printed − 1|
    /// is taken; rollers that fill less than 0.62 or more than 0.96 of the pitch circle, are shorter than 0.3 or longer than 0.85 of
    /// their row, or than 0.7 and 2 diameters, have 5 % on top each. Others that deviate by at most 1 % more are named in the notes:
    /// number and length enter both ratings by nearly the same product, so that there are often some.
    ///
    /// ```
    /// use jeffcott::bearing::{RollerKind, RollerLine};
    /// let line = RollerLine {
    ///     kind: RollerKind::Cylindrical,
    ///     boundary: [0.030, 0.062, 0.016],
    ///     contact_angle: 0.0,
    ///     dynamic_rating: 29_300.0,
    ///     static_rating: 28_700.0,
    ///     rollers: None,
    ///     diameter: None,
    ///     length: None,
    ///     pitch_diameter: None,
    /// };
    /// let best = line.estimate()?.best;
    /// assert_eq!((best.rollers, best.diameter, best.length), (13, 7.5e-3, 8e-3));
    /// # Ok::<(), jeffcott::bearing::EstimateError>(())
    /// ```
    ///
    /// # Errors
    /// [`EstimateError`] says what would settle it.
    pub fn estimate(&self) -> Result<RollerEstimate, EstimateError> {
        self.check()?;
        let [bore, outside, _] = self.boundary;
        let mut found = self.candidates();
        found.sort_by(|a, b| a.deviation.total_cmp(&b.deviation));
        let place = found.iter().position(|candidate| self.fits(candidate));
        let Some(place) = place else {
            let error = EstimateError::Rollers {
                dynamic: self.dynamic_rating,
                statical: self.static_rating,
                closest: found.first().copied(),
            };
            return Err(error.for_want_of_room(self.pitch(), [bore, outside]));
        };
        let best = found.remove(place);
        let given = [self.diameter, self.length].iter().all(Option::is_some);
        let estimated = !(given && self.rollers.is_some());
        let mut estimate = RollerEstimate {
            kind: self.kind,
            best,
            pitch_diameter: self.pitch(),
            estimated,
            runner_up: found.first().copied(),
            notes: Vec::new(),
        };
        estimate
            .geometry(self.contact_angle)?
            .check_section([bore, outside])?;
        if estimated {
            estimate.notes = self.notes(&best, &found);
        }
        Ok(estimate)
    }

    fn check(&self) -> Result<(), EstimateError> {
        let [bore, outside_diameter, width] = self.boundary;
        let others = [
            ("width", Some(width)),
            ("dynamic load rating", Some(self.dynamic_rating)),
            ("static load rating", Some(self.static_rating)),
            ("roller diameter", self.diameter),
            ("roller length", self.length),
            ("pitch diameter", self.pitch_diameter),
        ];
        check_print([bore, outside_diameter], self.contact_angle, &others)?;
        Ok(self.kind.check_angle(self.contact_angle)?)
    }

    fn pitch(&self) -> f64 {
        let [bore, outside, _] = self.boundary;
        self.pitch_diameter.unwrap_or(0.5 * (bore + outside))
    }

    /// All rollers that the line leaves open.
    fn candidates(&self) -> Vec<RollerCandidate> {
        let [bore, outside, _] = self.boundary;
        let steps = |least: f64, most: f64| {
            let [least, most] = [least / STEP, most / STEP];
            (least.ceil().max(1.0) as usize..=most as usize).map(|step| step as f64 * STEP)
        };
        let section = 0.5 * (outside - bore);
        let [least, most] = DIAMETERS.map(|part| part * section);
        let diameters = self
            .diameter
            .map_or_else(|| steps(least, most).collect(), |given| vec![given]);
        let mut found = Vec::new();
        for diameter in diameters {
            let most = Geometry::most_balls(diameter, self.pitch()).min(Geometry::MOST_BALLS);
            let numbers = self
                .rollers
                .map_or(Geometry::FEWEST_BALLS..=most, |n| n..=n);
            for rollers in numbers.filter(|rollers| *rollers <= most) {
                // C_0 grows with the length
                let exact = self.static_rating / self.static_rating_of(rollers, diameter, 1.0);
                let rounded = (exact / STEP).round().max(1.0) * STEP;
                found.push(self.candidate(rollers, diameter, self.length.unwrap_or(rounded)));
            }
        }
        found
    }

    fn static_rating_of(&self, rollers: usize, diameter: f64, length: f64) -> f64 {
        let all = rollers * self.kind.rows();
        roller_static_rating(all, diameter, length, self.pitch(), self.contact_angle)
    }

    fn candidate(&self, rollers: usize, diameter: f64, length: f64) -> RollerCandidate {
        let (rows, pitch) = (self.kind.rows(), self.pitch());
        let dynamic_rating = roller_dynamic_rating(
            self.kind.material_factor(),
            [rows, rollers],
            diameter,
            length,
            pitch,
            self.contact_angle,
        );
        let static_rating = self.static_rating_of(rollers, diameter, length);
        let dynamic = dynamic_deviation([dynamic_rating, self.dynamic_rating], DYNAMIC_RATIO);
        let room = self.boundary[2] / (rows as f64 * self.contact_angle.cos());
        let filling = rollers as f64 * (diameter / pitch).min(1.0).asin() / std::f64::consts::PI;
        let unusual = [
            (FILLING, filling),
            (LENGTHS, length / room),
            (SLENDERNESS, length / diameter),
        ];
        let outside = |([least, most], part): &([f64; 2], f64)| !(*least..=*most).contains(part);
        let unusual = unusual.iter().filter(|own| outside(own)).count() as f64;
        RollerCandidate {
            rollers,
            diameter,
            length,
            dynamic_rating,
            static_rating,
            deviation: (static_rating / self.static_rating - 1.0).abs()
                + dynamic
                + UNUSUAL * unusual,
        }
    }

    fn fits(&self, candidate: &RollerCandidate) -> bool {
        let dynamic = [candidate.dynamic_rating, self.dynamic_rating];
        (candidate.static_rating / self.static_rating - 1.0).abs() <= LARGEST_STATIC
            && is_rated_within(dynamic, DYNAMIC_RATIO)
    }

    fn notes(&self, best: &RollerCandidate, others: &[RollerCandidate]) -> Vec<String> {
        let ratings = [
            ("C", [best.dynamic_rating, self.dynamic_rating]),
            ("C0", [best.static_rating, self.static_rating]),
        ];
        let off = ratings
            .into_iter()
            .filter_map(|(name, ratings)| off_print(name, "rollers", ratings, BY_ISO));
        let is_near =
            |other: &&RollerCandidate| other.deviation - best.deviation < CLOSE && self.fits(other);
        let keys = "`rollers`, `diameter` and `length` in [bearing.roller]";
        off.chain(near_as_well(others.iter().filter(is_near), keys))
            .collect()
    }
}

/// Radius of the barrels of an estimated spherical roller bearing over that of its outer race.
const OSCULATION: f64 = 0.98;

impl RollerEstimate {
    /// The dimensions, checked, with a contact angle in rad and no clearance.
    ///
    /// # Errors
    /// [`GeometryError`] where they make no bearing.
    pub fn geometry(&self, contact_angle: f64) -> Result<Geometry, GeometryError> {
        let best = &self.best;
        let rollers = Rollers {
            kind: self.kind,
            length: best.length,
            profile: self.profile(contact_angle),
            laminae: Rollers::STANDARD_LAMINAE,
            clearance: 0.0,
        };
        Geometry::of_rollers(
            best.rollers,
            best.diameter,
            self.pitch_diameter,
            contact_angle,
            rollers,
        )
    }

    /// Profile of the rollers: that of the standard, and of spherical ones barrels of 0.98 of the radius of the outer race,
    /// d_m/(2 cos α) + D/2.
    pub fn profile(&self, contact_angle: f64) -> Profile {
        match self.kind {
            RollerKind::Spherical => {
                let race_radius =
                    0.5 * self.pitch_diameter / contact_angle.cos() + 0.5 * self.best.diameter;
                Profile::Barrel {
                    roller_radius: OSCULATION * race_radius,
                    race_radius,
                }
            }
            _ => Profile::Logarithmic,
        }
    }
}
