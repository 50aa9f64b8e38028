//! Surfaces that are not perfect: defects, waviness and balls of unequal size, as drops under the balls.

mod cage_jitter;
mod passing;
mod slot;
mod surfaces;
mod waves;

pub use cage_jitter::CageJitter;
pub use passing::{Passing, RaceSpall, SideView};
pub use slot::DefectProfile;
pub use surfaces::TurningSurfaces;
pub(super) use surfaces::{BallIdentity, ImperfectSurfaces};
pub use waves::Wave;

use std::fmt;

use super::Geometry;
use crate::physics::Race;

/// Which surface of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Surface {
    /// Outer race; angles count from +X towards +Y.
    Outer,
    /// Inner race; angles count from the mark of the unbalance, which points along +X at the start.
    Inner,
    /// The ball of this number, from 0; angles count from where it meets the outer race at the start, the way it rolls.
    Ball(usize),
}

/// A slot across a race, or a dent of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Defect {
    /// Where it is.
    pub on: Surface,
    /// Angle of its middle, rad.
    pub angle: f64,
    /// Length along the surface, m.
    pub length: f64,
    /// Depth of its floor, m.
    pub depth: f64,
    /// How the drop of a ball follows from them.
    pub profile: DefectProfile,
}

/// Everything that makes a bearing differ from a perfect one; nothing by default.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Imperfections {
    /// Slots and dents.
    pub defects: Vec<Defect>,
    /// Waves with the surface that they go around.
    pub waves: Vec<(Surface, Wave)>,
    /// How much larger than nominal the diameter of each ball is, m; empty where all are nominal.
    pub oversizes: Vec<f64>,
    /// How much slower the cage turns than it would roll, as a part of that speed.
    pub cage_slip: f64,
    /// Angles that the cage gains, one with every ball pass and then again, rad; empty where it turns evenly.
    pub cage_steps: Vec<f64>,
}

/// Why a surface cannot be as it is described.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ImperfectionError {
    /// A dimension of a defect is not a positive length.
    #[error("the {name} of a defect is {value:e} m; it must be positive and finite")]
    Length {
        /// Which dimension.
        name: &'static str,
        /// Value as given, m.
        value: f64,
    },
    /// A defect is longer than the surface is around.
    #[error("a defect of {:.3} mm is longer than its surface, which is {:.3} mm around", 1e3 * length, 1e3 * around)]
    TooLong {
        /// Length as given, m.
        length: f64,
        /// Circumference, m.
        around: f64,
    },
    /// The bearing has no such ball or roller.
    #[error("there is no {element} {}: the {element}s count from 1 to {balls}", number + 1)]
    Ball {
        /// `ball` or `roller`.
        element: &'static str,
        /// Number as given, from 0.
        number: usize,
        /// Number of balls.
        balls: usize,
    },
    /// A wave has no order, or too high a one.
    #[error("a wave of order {order}: it must be 1 to {largest}", largest = Imperfections::LARGEST_ORDER)]
    Order {
        /// Order as given.
        order: u32,
    },
    /// Not one deviation for each ball.
    #[error("{given} deviations of diameters are given for {balls} rolling elements")]
    Oversizes {
        /// Number as given.
        given: usize,
        /// Number of balls.
        balls: usize,
    },
    /// A cage gains too much with a ball pass.
    #[error(
        "the cage gains {:.3}° with a ball pass; it can gain or lose at most {:.3}°, half the spacing of its rolling elements",
        step.to_degrees(),
        largest.to_degrees()
    )]
    CageStep {
        /// Angle as given, rad.
        step: f64,
        /// Largest one, rad.
        largest: f64,
    },
    /// A number is not finite.
    #[error("{name} is {value}; it must be finite")]
    NotFinite {
        /// Which number.
        name: &'static str,
        /// Value as given.
        value: f64,
    },
}

impl Imperfections {
    /// Highest order of a wave.
    pub const LARGEST_ORDER: u32 = 10_000;
    /// Largest step of a cage over the spacing of its balls: it never turns backwards.
    pub const LARGEST_STEP: f64 = 0.5;

    /// Whether all surfaces are perfect.
    pub fn has_perfect_surfaces(&self) -> bool {
        self.defects.is_empty() && self.waves.is_empty() && self.oversizes.is_empty()
    }

    /// Whether they fit a bearing.
    ///
    /// # Errors
    /// [`ImperfectionError`] names the first number that does not.
    pub fn check(&self, geometry: &Geometry) -> Result<(), ImperfectionError> {
        for defect in &self.defects {
            defect.check(geometry)?;
        }
        for (on, wave) in &self.waves {
            check_ball(*on, geometry)?;
            finite("the amplitude of a wave in m", wave.amplitude)?;
            finite("the phase of a wave in rad", wave.phase)?;
            let order = wave.order;
            if !(1..=Self::LARGEST_ORDER).contains(&order) {
                return Err(ImperfectionError::Order { order });
            }
        }
        finite("the slip of the cage", self.cage_slip)?;
        let largest = std::f64::consts::TAU / geometry.balls() as f64 * Self::LARGEST_STEP;
        for step in &self.cage_steps {
            finite("a step of the cage in rad", *step)?;
            if step.abs() > largest {
                let step = *step;
                return Err(ImperfectionError::CageStep { step, largest });
            }
        }
        let (given, balls) = (self.oversizes.len(), geometry.all_balls());
        if given != 0 && given != balls {
            return Err(ImperfectionError::Oversizes { given, balls });
        }
        let mut oversizes = self.oversizes.iter();
        oversizes.try_for_each(|size| finite("the deviation of a diameter in m", *size))
    }

    /// Imperfections with the turning race and the balls turned by angles in rad, the balls past the place where they meet
    /// the outer race.
    pub(in crate::bearing) fn turned(&self, turning: Race, race: f64, balls: f64) -> Self {
        let mut turned = self.clone();
        let by = |on: Surface| match on {
            Surface::Outer | Surface::Inner => -on.by_shaft(turning) * race,
            Surface::Ball(_) => -balls,
        };
        for defect in &mut turned.defects {
            defect.angle += by(defect.on);
        }
        for (on, wave) in &mut turned.waves {
            // A cos(n (θ − ψ) + φ)
            wave.phase -= f64::from(wave.order) * by(*on);
        }
        turned
    }
}

impl Defect {
    /// Whether it fits a bearing.
    ///
    /// # Errors
    /// [`ImperfectionError`] names the first number that does not.
    pub fn check(&self, geometry: &Geometry) -> Result<(), ImperfectionError> {
        for (name, value) in [("length", self.length), ("depth", self.depth)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(ImperfectionError::Length { name, value });
            }
        }
        finite("the angle of a defect in rad", self.angle)?;
        check_ball(self.on, geometry)?;
        let around = std::f64::consts::TAU * self.on.radius(geometry);
        if self.length > around {
            let length = self.length;
            return Err(ImperfectionError::TooLong { length, around });
        }
        Ok(())
    }
}

impl Surface {
    /// Whether it is the race of the turning ring.
    pub(crate) fn turns_with(self, turning: Race) -> bool {
        self.by_shaft(turning) != 0.0
    }

    /// Change of a ball's angle past it by the angle of the turning ring: −1 on the race of that ring.
    pub(super) fn by_shaft(self, turning: Race) -> f64 {
        match (self, turning) {
            (Self::Inner, Race::Inner) | (Self::Outer, Race::Outer) => -1.0,
            _ => 0.0,
        }
    }

    /// Radius of the circle on which balls meet it, m: (d_m ± D cos α)/2 of the races, D/2 of a ball.
    pub(super) fn radius(self, geometry: &Geometry) -> f64 {
        let (pitch, gamma) = (geometry.pitch_diameter(), geometry.gamma());
        match self {
            Self::Outer => 0.5 * pitch * (1.0 + gamma),
            Self::Inner => 0.5 * pitch * (1.0 - gamma),
            Self::Ball(_) => 0.5 * geometry.ball_diameter(),
        }
    }
}

/// `the outer race`, `the inner race`, `ball 1`.
impl fmt::Display for Surface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outer => f.write_str("the outer race"),
            Self::Inner => f.write_str("the inner race"),
            Self::Ball(number) => write!(f, "ball {}", number + 1),
        }
    }
}

pub(crate) fn check_ball(on: Surface, geometry: &Geometry) -> Result<(), ImperfectionError> {
    let (element, balls) = (geometry.element(), geometry.all_balls());
    match on {
        Surface::Ball(number) if number >= balls => Err(ImperfectionError::Ball {
            element,
            number,
            balls,
        }),
        _ => Ok(()),
    }
}

fn finite(name: &'static str, value: f64) -> Result<(), ImperfectionError> {
    let error = ImperfectionError::NotFinite { name, value };
    value.is_finite().then_some(()).ok_or(error)
}
