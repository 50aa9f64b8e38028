//! Internal geometry from what a catalogue prints.

mod checks;
mod error;
mod rating;
mod rollers;
mod search;

pub use error::EstimateError;

use serde::Serialize;

use super::{FreePosition, Geometry, GeometryError, InternalGeometry};
use checks::filling_angle;
pub(crate) use rating::REFERENCE_GROOVES;
pub use rollers::{RollerCandidate, RollerEstimate, RollerLine};

/// What a catalogue prints of a bearing; the internal dimensions where they are known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CatalogueLine {
    /// Bore d, m.
    pub bore: f64,
    /// Outside diameter D_o, m.
    pub outside_diameter: f64,
    /// Width, m.
    pub width: Option<f64>,
    /// Nominal contact angle, rad; zero of a deep-groove bearing.
    pub contact_angle: f64,
    /// Basic dynamic load rating C, N.
    pub dynamic_rating: f64,
    /// Basic static load rating C_0, N.
    pub static_rating: Option<f64>,
    /// Factor f0 of C_0 = f0 Z D² cos α (N, mm), as catalogues print it with the ratings.
    pub static_factor: Option<f64>,
    /// Number of balls.
    pub balls: Option<usize>,
    /// Ball diameter, m.
    pub ball_diameter: Option<f64>,
    /// Pitch diameter, m.
    pub pitch_diameter: Option<f64>,
    /// Groove factors, inner race first.
    pub groove_factors: Option<[f64; 2]>,
}

/// Balls that may be those of a bearing, and the ratings that they have.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Candidate {
    /// Number of balls.
    pub balls: usize,
    /// Ball diameter, m.
    #[serde(rename = "ball_diameter_m")]
    pub ball_diameter: f64,
    /// C by ISO 281, N.
    #[serde(rename = "dynamic_rating_N")]
    pub dynamic_rating: f64,
    /// C_0 by the contact pressure of ISO 76, N.
    #[serde(rename = "static_rating_N")]
    pub static_rating: f64,
    /// How far they are from the print, by the rules of [`CatalogueLine::estimate`].
    pub deviation: f64,
}

impl std::fmt::Display for Candidate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{} balls of {:.3} mm (C {:.0} N, C0 {:.0} N, {:.1} % off)",
            self.balls,
            1e3 * self.ball_diameter,
            self.dynamic_rating,
            self.static_rating,
            1e2 * self.deviation
        )
    }
}

/// Internal geometry that belongs to a catalogue line.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Estimate {
    /// Balls, races and ratings.
    #[serde(flatten)]
    pub internal: InternalGeometry,
    /// C_0 as printed over Z D² cos α, N/mm².
    pub static_factor: Option<f64>,
    /// Filling angle (Z − 1)·2 asin(D/d_m), degrees.
    #[serde(rename = "filling_angle_deg")]
    pub filling_angle: f64,
    /// Which of the numbers above are estimated; none where the line gives all.
    pub estimated: Vec<&'static str>,
    /// The next best balls, where balls were searched for.
    pub runner_up: Option<Candidate>,
    /// What the reader should know, each with its numbers.
    pub notes: Vec<String>,
}

impl CatalogueLine {
    /// Finds balls, ball diameter, pitch diameter and grooves as far as the line does not give them.
    ///
    /// The pitch diameter is (d + D_o)/2, ball diameters are steps of 1/32 in with 15/64 and 17/64 in, or, 1 % off for being
    /// rare, further steps of 1/64 in to 35/64 in, and of 0.5 mm where none of those fits to 3 %. C_0 decides, by the contact pressure of ISO 76 in grooves of 0.52 and 0.53, and f0 where it
    /// is printed, with its rounding (0.5 of a whole one, else 0.05): C_0 lies within 4 % and f0 within 0.2. C counts
    /// where it is that of [`crate::physics::dynamic_rating`] to 1 %; makers print 0.98 to 1.10 times that, and within these
    /// limits any other C is 1 % off. The least deviation |C0/C0_printed − 1| + |C/C_printed − 1| + |f0 − f0_printed|/f0_printed
    /// is taken; deep-groove bearings with a filling angle outside 180° to 202°, and balls larger than 0.65 of the section,
    /// have 5 % on top; balls that fill more than 0.92 of the pitch circle leave no room for a cage and are not looked at. Where
    /// grooves are given, both ratings are of these; makers may also print, as ISO 76 has it, the C_0 of reference grooves for
    /// narrower ones. Other balls that deviate by at most 3 % more (1 % where C is that of ISO 281 and f0 is met to 0.1) are
    /// named in the notes. Of balls that are given in number and diameter both grooves follow from C_0.
    ///
    /// Real pitch diameters are up to 1.4 % larger, and makers differ: an estimate.
    ///
    /// ```
    /// use jeffcott::bearing::CatalogueLine;
    /// // 6205 as NSK prints it: 9 balls of 5/16 in
    /// let line = CatalogueLine::printed([0.025, 0.052], 0.0, 14_000.0, 7850.0);
    /// let estimate = line.estimate()?;
    /// assert_eq!(estimate.internal.balls, 9);
    /// assert!((estimate.internal.ball_diameter - 7.9375e-3).abs() < 1e-12);
    /// # Ok::<(), jeffcott::bearing::EstimateError>(())
    /// ```
    ///
    /// # Errors
    /// [`EstimateError`] says what would settle it.
    pub fn estimate(&self) -> Result<Estimate, EstimateError> {
        self.check()?;
        let pitch = self
            .pitch_diameter
            .unwrap_or(0.5 * (self.bore + self.outside_diameter));
        let (best, others) = match (self.balls, self.ball_diameter) {
            (Some(balls), Some(diameter)) => (self.candidate(balls, diameter, pitch), Vec::new()),
            _ => self.search(pitch).map_err(|error| {
                error.for_want_of_room(pitch, [self.bore, self.outside_diameter])
            })?,
        };
        let grooves = match (self.groove_factors, self.balls, self.ball_diameter) {
            (Some(given), ..) => given,
            (None, Some(_), Some(_)) => [self.groove_of_static_rating(&best, pitch)?; 2],
            _ => REFERENCE_GROOVES,
        };
        let estimated = [
            ("balls", self.balls.is_some()),
            ("ball_diameter", self.ball_diameter.is_some()),
            ("pitch_diameter", self.pitch_diameter.is_some()),
            ("groove_factor_inner", self.groove_factors.is_some()),
            ("groove_factor_outer", self.groove_factors.is_some()),
        ];
        let estimated = estimated.into_iter().filter(|(_, given)| !given);
        let mut estimate = Estimate {
            internal: InternalGeometry {
                balls: best.balls,
                ball_diameter: best.ball_diameter,
                pitch_diameter: pitch,
                contact_angle: self.contact_angle,
                groove_factor_inner: grooves[0],
                groove_factor_outer: grooves[1],
                dynamic_rating: self.dynamic_rating_of(
                    best.balls,
                    best.ball_diameter,
                    pitch,
                    grooves,
                ),
                static_rating: self.static_rating_of(
                    best.balls,
                    best.ball_diameter,
                    pitch,
                    grooves,
                ),
            },
            static_factor: self.static_factor_of(best.balls, best.ball_diameter),
            filling_angle: filling_angle(best.balls, best.ball_diameter, pitch),
            estimated: estimated.map(|(name, _)| name).collect(),
            runner_up: others.first().copied(),
            notes: Vec::new(),
        };
        // refuses balls that overlap and the like
        estimate
            .geometry(FreePosition::ContactAngle(self.contact_angle))?
            .check_section([self.bore, self.outside_diameter])?;
        if estimate.is_estimated() {
            estimate.notes = self.notes(&estimate, &best, &others);
        }
        Ok(estimate)
    }

    /// A line of a bore and an outside diameter in m, a contact angle in rad and the ratings C and C_0 in N.
    pub fn printed(
        [bore, outside_diameter]: [f64; 2],
        contact_angle: f64,
        dynamic_rating: f64,
        static_rating: f64,
    ) -> Self {
        Self {
            bore,
            outside_diameter,
            contact_angle,
            dynamic_rating,
            static_rating: Some(static_rating),
            ..Self::default()
        }
    }
}

impl Estimate {
    /// Whether balls or grooves are estimated.
    pub fn is_estimated(&self) -> bool {
        !self.estimated.is_empty()
    }

    /// The dimensions, checked, with the races where `free` puts them.
    ///
    /// # Errors
    /// [`GeometryError`] where the free position does not fit the grooves.
    pub fn geometry(&self, free: FreePosition) -> Result<Geometry, GeometryError> {
        let internal = &self.internal;
        Geometry::new(
            internal.balls,
            internal.ball_diameter,
            internal.pitch_diameter,
            free,
            internal.groove_factor_inner,
            internal.groove_factor_outer,
        )
    }
}
