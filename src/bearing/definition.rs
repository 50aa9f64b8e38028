//! What a bearing is made of and how it sits on the shaft: plain data, before any computation.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::surface::Imperfections;
use super::{BearingError, Clearance, ClearanceClass, ContactLaw, FitState, Geometry};
use crate::physics::{Contamination, Material, PER_MINUTE, Race, SkfFriction};

/// A bearing by itself: dimensions, materials, contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Checked dimensions.
    pub geometry: Geometry,
    /// Material of both rings.
    pub ring_material: Material,
    /// Material of the balls.
    pub ball_material: Material,
    /// Load–deflection constant K_n of a ball between both races in N/m^1.5 where it is given
    /// directly, as literature models do; otherwise it follows from Hertz's theory.
    pub contact_stiffness: Option<f64>,
    /// Basic dynamic load rating C, N; the life needs it.
    pub dynamic_rating: Option<f64>,
    /// Composite root-mean-square roughness σ of ball and race, m; the film ratio λ needs it.
    pub roughness: Option<f64>,
    /// Highest permissible speed, rad/s, as catalogues print it, for cage and lubrication; where it is not given,
    /// [`Bearing::highest_permissible_speed`] estimates it.
    pub limiting_speed: Option<f64>,
    /// Angle at which the shoulders of the races end, from the radial plane, rad; where it is given,
    /// contacts that reach it are warned of.
    pub shoulder_angle: Option<f64>,
    /// The class whose middle the clearance of a deep-groove bearing is, where it was taken from there.
    pub clearance_class: Option<ClearanceClass>,
    /// Bore and outside diameter, m; fits and SKF's friction model need them.
    pub boundary: Option<[f64; 2]>,
    /// Whether balls, pitch diameter or grooves were estimated from the ratings of a catalogue.
    pub estimated: bool,
    /// Constants of SKF's friction model, where the series of the bearing is known.
    pub skf_friction: Option<SkfFriction>,
    /// Lubricant; the modified life and SKF's friction model need it.
    pub(crate) lubrication: Option<Lubrication>,
    /// The ring that turns; the other one is at rest, as the load is.
    pub rotating_ring: Race,
    /// Reliability of the modified life, per cent, 90 … 99.95; 90 where it is not given.
    pub reliability: Option<f64>,
    /// What fits and temperatures have done to it.
    pub(crate) fit: Option<FitState>,
}

/// `n d_m` of balls, mm/min, above which manufacturers ask for bearings and lubrication of special design, where they give no
/// limiting speed: a rule of thumb.
const BALL_SPEED_FACTOR: f64 = 1e6;

/// How many times as dense as the rings balls of the same material are at least.
const AS_HEAVY: f64 = 0.8;

impl Bearing {
    /// A bearing of a geometry with balls and rings of bearing steel, of which nothing else is known.
    pub fn of_steel(geometry: Geometry) -> Self {
        Self {
            geometry,
            ring_material: Material::BEARING_STEEL,
            ball_material: Material::BEARING_STEEL,
            contact_stiffness: None,
            dynamic_rating: None,
            roughness: None,
            limiting_speed: None,
            shoulder_angle: None,
            clearance_class: None,
            boundary: None,
            estimated: false,
            skf_friction: None,
            lubrication: None,
            rotating_ring: Race::Inner,
            reliability: None,
            fit: None,
        }
    }

    /// Highest permissible speed, rad/s, given or by rules of thumb for `n d_m`: 10⁶ mm/min of balls, 7·10⁵ of cylindrical
    /// rollers, 5·10⁵ of needle, tapered and spherical rollers.
    pub fn highest_permissible_speed(&self) -> f64 {
        let rollers = self.geometry.rollers();
        let factor = rollers.map_or(BALL_SPEED_FACTOR, |rollers| rollers.kind.speed_factor());
        let estimate = factor * 1e-3 / PER_MINUTE / self.geometry.pitch_diameter();
        self.limiting_speed.unwrap_or(estimate)
    }

    /// Whether its balls are much lighter than its rings, as those of ceramic are.
    pub(crate) fn is_hybrid(&self) -> bool {
        self.ball_material.density < AS_HEAVY * self.ring_material.density
    }

    /// Clearance of a deep-groove bearing; none of an angular contact bearing.
    pub fn clearance(&self) -> Option<Clearance> {
        let class = self.clearance_class;
        let diametral = self.geometry.diametral_clearance()?;
        Some(Clearance { diametral, class })
    }
}

/// Which way along Z the inner ring must move to load the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum Facing {
    /// Moving the shaft along +Z loads the bearing.
    #[default]
    #[serde(rename = "+z")]
    PlusZ,
    /// Moving the shaft along −Z loads the bearing.
    #[serde(rename = "-z")]
    MinusZ,
}

impl Facing {
    /// s = +1 or −1 of the mirror rule z, θx, θy → s·.
    pub fn sign(self) -> f64 {
        match self {
            Self::PlusZ => 1.0,
            Self::MinusZ => -1.0,
        }
    }
}

/// Axial preset of a mounted bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Preload {
    /// Inner ring displaced by this much in m the way its facing loads it: z_local = s z + offset.
    AxialOffset(f64),
    /// The offset at which the bearing alone, standing, carries this axial force in N.
    Force(f64),
    /// The outer ring floats axially and a soft spring presses it with this force in N, the way that
    /// loads the bearing, wherever the shaft is.
    Spring(f64),
}

/// Lubricating oil at the bearing's temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oil {
    /// Viscosity at ambient pressure η0, Pa s.
    pub viscosity: f64,
    /// Pressure–viscosity coefficient α_p, 1/Pa.
    pub pressure_viscosity: f64,
}

impl Oil {
    /// # Errors
    /// [`BearingError::Oil`] where a property is not positive and finite.
    pub(super) fn check(&self) -> Result<(), BearingError> {
        for (name, value) in [
            ("viscosity", self.viscosity),
            ("pressure–viscosity coefficient", self.pressure_viscosity),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(BearingError::Oil { name, value });
            }
        }
        Ok(())
    }
}

/// The lubricant at the temperature of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lubrication {
    /// Kinematic viscosity of the oil, or of the base oil of a grease, m²/s.
    pub viscosity: f64,
    /// Whether it is a grease.
    pub grease: bool,
    /// How clean it is; the modified life needs it.
    pub contamination: Option<Contamination>,
    /// The oil of its films.
    pub oil: Oil,
}

/// Hunt–Crossley damping of the contacts with both races.
///
/// ```text
/// Q_damped = Q (1 + c δ̇)   c = 3/2 α   never less than zero
/// ```
///
/// Q is the load of the ball law at a race in N, δ the elastic approach there in m, which follows
/// the motion of the ring (and the ball its balance) at once. As the force along a freedom of the
/// ring is
///
/// ```text
/// F_d = Σ_balls Σ_races Q max(c δ̇, −1) ∂δ/∂q
/// ```
///
/// the power that it takes, `Σ Q max(c δ̇, −1) δ̇`, is never negative: the damping dissipates only. A
/// ball that has left its race is not damped, and no race pulls at a ball. A sphere that meets a
/// wall at a small speed v leaves it at (1 − α v) v.
///
/// Source: K. H. Hunt & F. R. E. Crossley, *J. Applied Mechanics* 42 (1975) 440–445, who give
/// α = 0.08 … 0.32 s/m for steel, bronze and ivory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactDamping {
    /// α at the inner race, s/m; zero for none.
    pub inner: f64,
    /// α at the outer race, s/m; zero for none.
    pub outer: f64,
}

impl ContactDamping {
    /// Whether neither contact is damped.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Coefficients c of both races, inner first, s/m; none without damping.
    ///
    /// # Errors
    /// [`BearingError::ContactDamping`] where a coefficient is negative or not finite.
    pub(super) fn coefficients(&self) -> Result<Option<[f64; 2]>, BearingError> {
        for value in [self.inner, self.outer] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BearingError::ContactDamping { value });
            }
        }
        // c = 3/2 α
        let coefficients = [1.5 * self.inner, 1.5 * self.outer];
        Ok((!self.is_none()).then_some(coefficients))
    }
}

/// What the outer ring of a bearing sits in: a mass on springs and dampers to the ground, which does not tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Housing {
    /// Mass, kg.
    pub mass: f64,
    /// Stiffness to the ground along x, y and z, N/m.
    pub stiffness: [f64; 3],
    /// Damping to the ground along x, y and z, N s/m.
    pub damping: [f64; 3],
    /// What vibrates on it.
    pub resonator: Option<Resonator>,
}

/// A mass on a spring and a damper on a housing, alike along all axes: a sensor with its mount, whose resonance rings at
/// every impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonator {
    /// Mass, kg.
    pub mass: f64,
    /// Stiffness to the housing, N/m.
    pub stiffness: f64,
    /// Damping to the housing, N s/m.
    pub damping: f64,
}

/// A bearing and its place on the shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct MountedBearing {
    /// The bearing.
    pub bearing: Bearing,
    /// Force law between its rings.
    pub law: ContactLaw,
    /// Oil whose films part the surfaces; `None` leaves films out.
    pub oil: Option<Oil>,
    /// Position along the shaft from the centre of mass, m.
    pub position: f64,
    /// Orientation.
    pub facing: Facing,
    /// Axial preset.
    pub preload: Preload,
    /// Damping of the contacts.
    pub contact_damping: ContactDamping,
    /// Azimuth of ball 0 at the start, from +X towards +Y, rad.
    pub first_ball: f64,
    /// What makes its surfaces differ from perfect ones.
    pub imperfections: Imperfections,
    /// The housing around it; none on the ground.
    pub housing: Option<Housing>,
}

impl MountedBearing {
    /// The bearing at the centre of mass, loaded along +Z: dry Hertz contacts without damping, no preload, ball 0 on +X.
    pub fn new(bearing: Bearing) -> Self {
        Self {
            bearing,
            law: ContactLaw::Hertz,
            oil: None,
            position: 0.0,
            facing: Facing::PlusZ,
            preload: Preload::AxialOffset(0.0),
            contact_damping: ContactDamping::default(),
            first_ball: 0.0,
            imperfections: Imperfections::default(),
            housing: None,
        }
    }
}
