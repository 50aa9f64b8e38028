//! Internal geometry of a ball or roller bearing.

use std::ops::RangeInclusive;

use super::free_position::position_of_clearance;
use super::{FreePosition, GeometryError, RollerKind, Rollers};
use crate::physics::{BallPass, ball_pass_frequencies, dynamic_rating, open_groove_factor};

/// Dimensions of a bearing, checked at construction. Its rolling elements, balls or [`Rollers`], are called balls.
///
/// The frame, the symbols and the distances A and R_i are those of the crate's front page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    balls: usize,
    ball_diameter: f64,
    pitch_diameter: f64,
    contact_angle: f64,
    squeeze: f64,
    /// As made, before any change of clearance.
    free_position: FreePosition,
    /// f = r/D of the inner and the outer race; infinite of rollers, whose races are straight.
    groove_factors: [f64; 2],
    /// What it has in place of balls.
    rollers: Option<Rollers>,
}

impl Geometry {
    /// Fewest balls that are taken for a bearing.
    pub const FEWEST_BALLS: usize = 3;
    /// Most balls that are taken for a bearing.
    pub const MOST_BALLS: usize = 200;
    /// Largest squeeze of a ball between its races without load, in parts of the distance of the groove centres: about
    /// 3 GPa.
    pub const LARGEST_SQUEEZE: f64 = 0.1;
    /// Lengths that are taken for dimensions of a bearing, m.
    pub const LENGTHS: RangeInclusive<f64> = 1e-5..=1e3;
    /// Largest free contact angle, rad.
    pub const LARGEST_CONTACT_ANGLE: f64 = std::f64::consts::FRAC_PI_3;

    /// Checks the dimensions: lengths in m, groove factors f = r/D dimensionless.
    ///
    /// # Errors
    /// [`GeometryError`] with the offending number and the range that it must be in.
    pub fn new(
        balls: usize,
        ball_diameter: f64,
        pitch_diameter: f64,
        free_position: FreePosition,
        groove_factor_inner: f64,
        groove_factor_outer: f64,
    ) -> Result<Self, GeometryError> {
        if !(Self::FEWEST_BALLS..=Self::MOST_BALLS).contains(&balls) {
            return Err(GeometryError::Balls { balls });
        }
        for (name, value) in [
            ("diameter of the rolling elements", ball_diameter),
            ("pitch diameter", pitch_diameter),
        ] {
            Self::check_length(name, value)?;
        }
        for (race, value) in [
            ("inner", groove_factor_inner),
            ("outer", groove_factor_outer),
        ] {
            if !(value > 0.5 && value <= 1.0) {
                return Err(GeometryError::GrooveFactor { race, value });
            }
        }
        let largest = Self::most_balls(ball_diameter, pitch_diameter);
        if balls > largest {
            return Err(GeometryError::Overlap {
                balls,
                ball_diameter,
                pitch_diameter,
                largest,
            });
        }
        let distance = (groove_factor_inner + groove_factor_outer - 1.0) * ball_diameter;
        let [contact_angle, squeeze] = match free_position {
            FreePosition::ContactAngle(angle) => {
                if !(0.0..=Self::LARGEST_CONTACT_ANGLE).contains(&angle) {
                    let degrees = angle.to_degrees();
                    return Err(GeometryError::ContactAngle { degrees });
                }
                [angle, 0.0]
            }
            FreePosition::DiametralClearance(clearance) => {
                position_of_clearance(clearance, distance)?
            }
            FreePosition::RadialClearance(clearance) => {
                position_of_clearance(2.0 * clearance, distance)?
            }
        };
        Ok(Self {
            balls,
            ball_diameter,
            pitch_diameter,
            contact_angle,
            squeeze,
            free_position,
            groove_factors: [groove_factor_inner, groove_factor_outer],
            rollers: None,
        })
    }

    /// Checks the dimensions of a roller bearing: `count` rollers a row, lengths in m, contact angle in rad.
    ///
    /// # Errors
    /// [`GeometryError`] with the offending number and the range that it must be in.
    pub fn of_rollers(
        count: usize,
        diameter: f64,
        pitch_diameter: f64,
        contact_angle: f64,
        rollers: Rollers,
    ) -> Result<Self, GeometryError> {
        let angle = FreePosition::ContactAngle(contact_angle);
        let alike = Self::new(count, diameter, pitch_diameter, angle, 1.0, 1.0)?;
        Self::check_length("roller length", rollers.length)?;
        rollers.kind.check_angle(contact_angle)?;
        rollers.check_barrel()?;
        let laminae = rollers.laminae;
        if !(Rollers::FEWEST_LAMINAE..=Rollers::MOST_LAMINAE).contains(&laminae) {
            return Err(GeometryError::Laminae { laminae });
        }
        let geometry = Self {
            groove_factors: [f64::INFINITY; 2],
            rollers: Some(rollers),
            ..alike
        };
        geometry.with_roller_clearance(rollers)
    }

    fn check_length(name: &'static str, value: f64) -> Result<(), GeometryError> {
        match Self::LENGTHS.contains(&value) {
            true => Ok(()),
            false => Err(GeometryError::Length { name, value }),
        }
    }

    /// The bearing with rollers whose clearance fits it.
    fn with_roller_clearance(self, rollers: Rollers) -> Result<Self, GeometryError> {
        let (clearance, diameter) = (rollers.clearance, self.ball_diameter);
        if clearance.is_nan() || clearance.abs() > self.length_scale() {
            return Err(GeometryError::RollerClearance {
                clearance,
                diameter,
            });
        }
        Ok(Self {
            squeeze: 0.5 * (-clearance).max(0.0),
            rollers: Some(rollers),
            ..self
        })
    }

    /// Whether the rings of a bearing of a bore and an outside diameter in m have room beside its balls or rollers.
    ///
    /// # Errors
    /// [`GeometryError::Section`] where they reach beyond one of them.
    pub(crate) fn check_section(&self, boundary: [f64; 2]) -> Result<(), GeometryError> {
        let (diameter, pitch) = (self.ball_diameter, self.pitch_diameter);
        GeometryError::check_section(self.element(), [diameter, pitch], boundary)
    }

    /// How many balls there is room for on the pitch circle.
    pub(super) fn most_balls(ball_diameter: f64, pitch_diameter: f64) -> usize {
        Self::most_balls_filling(1.0, ball_diameter, pitch_diameter)
    }

    /// How many balls fill at most a share of the pitch circle, Z asin(D/d_m)/π.
    pub(super) fn most_balls_filling(share: f64, ball_diameter: f64, pitch_diameter: f64) -> usize {
        let each = (ball_diameter / pitch_diameter).min(1.0).asin();
        (share * std::f64::consts::PI / each) as usize
    }

    /// The bearing with its diametral clearance changed by `change` in m, as fits, temperature or a
    /// speed that widens the rings do; negative tightens.
    ///
    /// `A cos α0' = A cos α0 − ΔP_d/2`: the change moves the groove centres radially. Where the right side exceeds A the
    /// balls are squeezed without load, at a contact angle of zero.
    ///
    /// # Errors
    /// [`GeometryError::ClearanceChange`] where the contact angle exceeds 60°, or the squeeze
    /// [`Geometry::LARGEST_SQUEEZE`].
    pub fn with_clearance_change(&self, change: f64) -> Result<Self, GeometryError> {
        if change == 0.0 {
            return Ok(*self);
        }
        if let Some(rollers) = self.rollers {
            let clearance = rollers.clearance + change;
            return self.with_roller_clearance(Rollers {
                clearance,
                ..rollers
            });
        }
        let distance = self.groove_centre_distance();
        // A − A cos α0, negative of squeezed balls
        let free = 2.0 * distance * (0.5 * self.contact_angle).sin().powi(2) - self.squeeze;
        let [contact_angle, squeeze] = position_of_clearance(2.0 * free + change, distance)
            .map_err(|error| match error {
                GeometryError::Clearance {
                    smallest, largest, ..
                } => GeometryError::ClearanceChange {
                    change,
                    smallest: smallest - 2.0 * free,
                    largest: largest - 2.0 * free,
                },
                other => other,
            })?;
        Ok(Self {
            contact_angle,
            squeeze,
            ..*self
        })
    }

    /// What the bearing has in place of balls.
    pub fn rollers(&self) -> Option<&Rollers> {
        self.rollers.as_ref()
    }

    /// Basic dynamic radial load rating C of ISO 281 by balls or rollers, N.
    pub(crate) fn dynamic_rating(&self) -> f64 {
        match &self.rollers {
            Some(rollers) => rollers.dynamic_rating(self),
            None => {
                let [ball, pitch] = [self.ball_diameter, self.pitch_diameter];
                open_groove_factor(self.nominal_gamma(), self.groove_factors)
                    * dynamic_rating(self.balls, ball, pitch, self.nominal_angle())
            }
        }
    }

    /// What a rolling element is called.
    pub(crate) fn element(&self) -> &'static str {
        match self.rollers {
            Some(_) => "roller",
            None => "ball",
        }
    }

    /// Rows of balls or rollers.
    pub fn rows(&self) -> usize {
        self.rollers.as_ref().map_or(1, Rollers::rows)
    }

    /// Number of balls or rollers in all rows.
    pub(crate) fn all_balls(&self) -> usize {
        self.rows() * self.balls
    }

    /// Number of balls Z, of one row.
    pub fn balls(&self) -> usize {
        self.balls
    }

    /// Ball diameter D, m.
    pub fn ball_diameter(&self) -> f64 {
        self.ball_diameter
    }

    /// Pitch diameter d_m, m.
    pub fn pitch_diameter(&self) -> f64 {
        self.pitch_diameter
    }

    /// Free contact angle α0, rad.
    pub fn contact_angle(&self) -> f64 {
        self.contact_angle
    }

    /// Nominal contact angle α of the standards' ratings (ISO 281, ISO/TS 16281), rad: the free
    /// contact angle of an angular contact bearing as made, before any change of clearance; zero
    /// for a bearing given by its clearance.
    ///
    /// ```
    /// use jeffcott::bearing::{FreePosition, Geometry};
    /// let angular = FreePosition::ContactAngle(15f64.to_radians());
    /// let angular = Geometry::new(12, 7.938e-3, 38.5e-3, angular, 0.52, 0.53)?;
    /// assert_eq!(angular.nominal_angle(), 15f64.to_radians());
    /// let tightened = angular.with_clearance_change(-5e-6)?;
    /// assert_eq!(tightened.nominal_angle(), 15f64.to_radians());
    /// let groove = FreePosition::DiametralClearance(10e-6);
    /// let groove = Geometry::new(7, 11.5e-3, 43.5e-3, groove, 0.52, 0.53)?;
    /// assert_eq!(groove.nominal_angle(), 0.0);
    /// # Ok::<(), jeffcott::bearing::GeometryError>(())
    /// ```
    pub fn nominal_angle(&self) -> f64 {
        match self.free_position {
            FreePosition::ContactAngle(angle) => angle,
            _ => 0.0,
        }
    }

    /// Whether the bearing is alike in both directions along its axis, as a deep-groove bearing is: the groove
    /// centres are opposite each other at zero displacement, in the middle of the axial play.
    pub fn is_symmetric(&self) -> bool {
        match &self.rollers {
            Some(rollers) => rollers.kind != RollerKind::Tapered,
            None => !matches!(self.free_position, FreePosition::ContactAngle(_)),
        }
    }

    /// Whether the bearing holds its inner ring along its axis: all but cylindrical rollers, whose flanges are not modelled.
    pub(crate) fn carries_axial_load(&self) -> bool {
        let kind = self.rollers.as_ref().map(|rollers| rollers.kind);
        kind != Some(RollerKind::Cylindrical)
    }

    /// Diametral clearance P_d = 2A(1 − cos α0) of a deep-groove bearing, or G_r of rollers, m; none of an angular contact
    /// or tapered bearing. Negative where the balls are squeezed.
    pub fn diametral_clearance(&self) -> Option<f64> {
        if let Some(rollers) = &self.rollers {
            return self.is_symmetric().then_some(rollers.clearance);
        }
        let half = (0.5 * self.contact_angle).sin();
        // 1 − cos α0 = 2 sin²(α0/2)
        let clearance = 4.0 * self.groove_centre_distance() * half * half;
        self.is_symmetric()
            .then_some(clearance - 2.0 * self.squeeze)
    }

    /// How much a ball is squeezed between its races without load, m: half of a negative diametral clearance, zero of any
    /// other bearing.
    pub fn squeeze(&self) -> f64 {
        self.squeeze
    }

    /// Groove factors f = r/D of the inner and the outer race.
    pub fn groove_factors(&self) -> [f64; 2] {
        self.groove_factors
    }

    /// γ = D cos α/d_m with the nominal contact angle.
    pub(super) fn nominal_gamma(&self) -> f64 {
        self.gamma_at(self.nominal_angle().cos())
    }

    /// γ = D cos α/d_m, the ratio that governs rolling and curvature.
    pub fn gamma(&self) -> f64 {
        let angle = match self.free_position {
            FreePosition::RadialClearance(_) => 0.0,
            _ => self.contact_angle,
        };
        self.gamma_at(angle.cos())
    }

    /// γ of another contact angle, by its cosine.
    pub(super) fn gamma_at(&self, cosine: f64) -> f64 {
        self.ball_diameter * cosine / self.pitch_diameter
    }

    /// Ball-pass frequencies at the nominal contact angle, as handbooks print them, and a shaft speed in rad/s.
    pub fn ball_pass(&self, speed: f64) -> BallPass {
        ball_pass_frequencies(
            speed,
            self.balls,
            self.ball_diameter,
            self.pitch_diameter,
            self.nominal_gamma(),
        )
    }

    /// Length that displacements between the rings compare with, m: the distance of the groove centres of balls, a
    /// twentieth of the diameter of rollers.
    pub fn length_scale(&self) -> f64 {
        match self.rollers {
            Some(_) => 0.05 * self.ball_diameter,
            None => self.groove_centre_distance(),
        }
    }

    /// Radius that turns tilts into displacements where the balls are, m: that of the inner groove centres or the pitch
    /// radius of rollers.
    pub fn lever(&self) -> f64 {
        match self.rollers {
            Some(_) => 0.5 * self.pitch_diameter,
            None => self.inner_groove_radius(),
        }
    }

    /// Radius on which axial forces act and tilts move the contacts, m: the [`Geometry::lever`]; none of spherical rollers,
    /// whose outer race turns about the middle of the bearing.
    pub(super) fn arm(&self) -> f64 {
        match &self.rollers {
            Some(rollers) if rollers.kind == RollerKind::Spherical => 0.0,
            _ => self.lever(),
        }
    }

    /// Distance of the groove centres in the unloaded bearing, A = (f_i + f_o − 1)D, m.
    pub fn groove_centre_distance(&self) -> f64 {
        let [inner, outer] = self.groove_factors;
        (inner + outer - 1.0) * self.ball_diameter
    }

    /// Radius of the circle of inner groove centres, R_i = d_m/2 + (f_i − 1/2)D cos α0, m.
    pub fn inner_groove_radius(&self) -> f64 {
        0.5 * self.pitch_diameter
            + (self.groove_factors[0] - 0.5) * self.ball_diameter * self.contact_angle.cos()
    }

    /// Axial distance of the groove centres at zero displacement, m: A sin α0 of an angular contact bearing, whose
    /// free contact angle just closes there; 0 of a deep-groove bearing in the middle of its play.
    /// Of rollers, whose approach is counted from zero displacement, 0.
    pub fn free_axial(&self) -> f64 {
        match self.is_symmetric() || self.rollers.is_some() {
            true => 0.0,
            false => self.groove_centre_distance() * self.contact_angle.sin(),
        }
    }

    /// Radial distance of the groove centres at zero displacement, A cos α0 and what the balls are squeezed by, m. Of
    /// rollers, −G_r/2.
    pub fn free_radial(&self) -> f64 {
        if let Some(rollers) = &self.rollers {
            return -0.5 * rollers.clearance;
        }
        self.groove_centre_distance() * self.contact_angle.cos() + self.squeeze
    }
}
