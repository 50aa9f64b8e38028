//! The integrating factor of as many entries as a system takes.

use super::entries::{All, Few};
use super::factor::Factor;
use crate::integrate::{System, VelocityDependence};

/// The integrating factor, of as many entries as it takes.
#[derive(Debug, Clone)]
pub(super) enum AnyFactor<const N: usize> {
    Few(Box<Factor<Few<N>, N>>),
    All(Box<Factor<All<N>, N>>),
}

impl<const N: usize> AnyFactor<N> {
    /// The factor of a system.
    ///
    /// # Errors
    /// [`VelocityDependence`] where there is none.
    pub fn of<S: System<N>>(system: &S) -> Result<Self, VelocityDependence> {
        let slopes = system.velocity_slopes()?;
        Ok(if Few::<N>::holds(&slopes) {
            Self::Few(Box::new(Factor::new(&slopes)))
        } else {
            Self::All(Box::new(Factor::new(&slopes)))
        })
    }

    /// Largest step that the factor serves, s.
    pub fn largest_step(&self) -> f64 {
        match self {
            Self::Few(factor) => factor.largest_step(),
            Self::All(factor) => factor.largest_step(),
        }
    }
}
