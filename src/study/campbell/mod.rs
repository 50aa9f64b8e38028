//! Natural frequencies over the speed: the Campbell diagram of the linearised rotor.

mod branches;
mod critical;

use serde::Serialize;

use crate::keys;
pub use crate::rotor::Mode;
use crate::rotor::{Rotor, RotorDefinition, RotorError, Whirl};
use branches::follow;
use critical::critical_speeds;

/// A question about natural frequencies over the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct CampbellQuestion {
    /// The shaft; of its speed nothing is used.
    pub rotor: RotorDefinition,
    /// Lowest speed, rad/s, zero or positive.
    pub from: f64,
    /// Highest speed, rad/s, above the lowest.
    pub to: f64,
    /// Number of evenly spaced speeds, at least 2.
    pub count: usize,
    /// Multiples of the shaft's frequency whose crossings are sought, positive.
    pub orders: Vec<f64>,
}

/// A mode followed over the speeds by its shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// The mode at every speed; none where it is overdamped or has become another.
    pub modes: Vec<Option<Mode>>,
}

impl Branch {
    /// How the shaft goes round in it: where it does so most clearly.
    pub fn whirl(&self) -> Whirl {
        let known = self.modes.iter().flatten();
        let clearest = known.max_by(|a, b| {
            let clear = |mode: &Mode| mode.forward_share().abs();
            clear(a).total_cmp(&clear(b))
        });
        clearest.map_or(Whirl::Straight, Mode::whirl)
    }
}

/// A speed at which a natural frequency is a multiple of the shaft's frequency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CriticalSpeed {
    /// The multiple.
    pub order: f64,
    /// The branch, from 0.
    #[serde(serialize_with = "keys::from_one")]
    pub branch: usize,
    /// The speed, rad/s.
    #[serde(rename = "speed_rad_s")]
    pub speed: f64,
    /// Frequency of the damped vibration there, Hz: order × speed/2π.
    #[serde(rename = "frequency_Hz")]
    pub frequency: f64,
    /// Damping ratio there.
    pub damping_ratio: f64,
    /// How the shaft goes round there.
    pub whirl: Whirl,
    /// How much more it goes round with the rotation than against it, −1 … 1.
    pub forward_share: f64,
}

/// Natural frequencies over the speed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Campbell {
    /// The speeds, rad/s, rising.
    pub speeds: Vec<f64>,
    /// Modes that belong together, by their frequency at the lowest speed.
    pub branches: Vec<Branch>,
    /// The orders that were asked for.
    pub orders: Vec<f64>,
    /// Crossings of branches and orders, by speed.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// The least likeness, [`Mode::assurance`], by which two modes were taken for the same.
    pub least_assurance: f64,
}

/// Why there is no diagram.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CampbellError {
    /// The range holds no two speeds.
    #[error(
        "a diagram from {from} to {to} rad/s at {count} speeds has no range: give a first speed of \
         zero or more, a higher last one, and at least 2 speeds"
    )]
    Range {
        /// First speed, rad/s.
        from: f64,
        /// Last speed, rad/s.
        to: f64,
        /// Number of speeds.
        count: usize,
    },
    /// An order that no frequency has.
    #[error("order {0}: give orders above zero")]
    Order(f64),
    /// The shaft cannot be assembled at a speed.
    #[error("at {speed} rad/s: {source}")]
    Rotor {
        /// The speed, rad/s.
        speed: f64,
        /// Why.
        source: RotorError,
    },
}

/// Whether a diagram from one speed to another in rad/s has a range, and all orders a frequency.
///
/// # Errors
/// [`CampbellError::Range`] and [`CampbellError::Order`].
pub(crate) fn check_range(
    [from, to]: [f64; 2],
    count: usize,
    orders: &[f64],
) -> Result<(), CampbellError> {
    let rising = from >= 0.0 && to > from && to.is_finite();
    if !rising || count < 2 {
        return Err(CampbellError::Range { from, to, count });
    }
    let wrong = |order: &&f64| !(order.is_finite() && **order > 0.0);
    match orders.iter().find(wrong) {
        Some(order) => Err(CampbellError::Order(*order)),
        None => Ok(()),
    }
}

impl CampbellQuestion {
    /// Linearises the shaft at every speed, about the static equilibrium there, and follows its modes.
    ///
    /// `M q̈ + (C + ωG) q̇ + K q = 0` with K and C of the equilibrium at that speed, cages where they
    /// start; damping of contacts is left out. Modes belong together whose shapes are most alike
    /// ([`Mode::assurance`]); between speeds whose shapes differ too much further ones are put in. A
    /// critical speed is found by a search for the root of `f(ω) − order ω/2π` between two speeds.
    ///
    /// # Errors
    /// [`CampbellError`] where the range is empty, or the shaft has no equilibrium at a speed.
    pub fn solve(&self) -> Result<Campbell, CampbellError> {
        check_range([self.from, self.to], self.count, &self.orders)?;
        let speeds = self.speeds();
        let (branches, least_assurance) = follow(self, &speeds)?;
        let critical_speeds = critical_speeds(self, &speeds, &branches)?;
        Ok(Campbell {
            speeds,
            branches,
            orders: self.orders.clone(),
            critical_speeds,
            least_assurance,
        })
    }

    fn speeds(&self) -> Vec<f64> {
        let step = (self.to - self.from) / (self.count - 1) as f64;
        let inside = (0..self.count - 1).map(|index| self.from + index as f64 * step);
        inside.chain([self.to]).collect()
    }

    /// Modes of the shaft at a speed in rad/s.
    fn modes(&self, speed: f64) -> Result<Vec<Mode>, CampbellError> {
        let rotor = Rotor::assemble(&self.rotor.at_constant_speed(speed));
        match rotor {
            Ok(rotor) => Ok(rotor.modes()),
            Err(source) => Err(CampbellError::Rotor { speed, source }),
        }
    }
}
