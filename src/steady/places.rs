//! When the periods of a map begin.

use std::f64::consts::TAU;

use super::{Base, SteadyError, bases};
use crate::rotor::Rotor;
use crate::shooting::Circle;

/// Two ratios of frequencies are the same to this part of a turn.
const SAME_RATIO: f64 = 1e-9;
/// Periods that are looked through for phases.
const PERIODS: u64 = 1 << 14;

/// The periods of a forcing of one or two frequencies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Places {
    /// One or two frequencies; the period is that of the first.
    pub bases: Vec<Base>,
    /// How many of these make one of the map.
    pub multiple: u32,
    /// Where the states stand on the second phase.
    pub circle: Circle,
}

impl Places {
    /// What repeats in a rotor, over a multiple of its period.
    pub fn new(rotor: &Rotor, multiple: u32) -> Result<Self, SteadyError> {
        let bases = bases(&rotor.forcing()?);
        match bases.len() {
            0 => Err(SteadyError::Rest),
            1 | 2 => Ok(Self {
                circle: Circle::point(bases[0].period() * f64::from(multiple)),
                bases,
                multiple,
            }),
            _ => Err(SteadyError::Frequencies {
                frequencies: hertz(&bases),
            }),
        }
    }

    /// The same with so many harmonics of the second frequency.
    pub fn with_harmonics(&self, harmonics: usize) -> Result<Self, SteadyError> {
        let circle = Circle::around(self.circle.period(), self.rotation(), harmonics);
        Ok(Self {
            circle: circle.ok_or_else(|| SteadyError::NearlyCommon {
                frequencies: self.frequencies(),
                periods: PERIODS,
            })?,
            ..self.clone()
        })
    }

    /// The same places of another rotor whose frequencies have the same ratio.
    pub fn of_rotor(&self, rotor: &Rotor) -> Result<Self, SteadyError> {
        let other = Self::new(rotor, self.multiple)?;
        let turn = (other.rotation() - self.rotation()).abs();
        if other.bases.len() != self.bases.len() || turn > SAME_RATIO * TAU {
            return Err(SteadyError::RatioChanges {
                key: "the parameter".to_owned(),
            });
        }
        Ok(Self {
            circle: self.circle.with_period(other.circle.period()),
            ..other
        })
    }

    /// The same over another multiple of the period; a single frequency only.
    pub fn times(&self, multiple: u32) -> Self {
        Self {
            circle: Circle::point(self.bases[0].period() * f64::from(multiple)),
            multiple,
            ..self.clone()
        }
    }

    /// Half the period, where the forcing repeats with it.
    pub fn half(&self) -> Option<Self> {
        let even = self.multiple.is_multiple_of(2) && !self.is_torus();
        even.then(|| self.times(self.multiple / 2))
    }

    /// Whether there are two frequencies.
    pub fn is_torus(&self) -> bool {
        self.bases.len() == 2
    }

    /// The frequencies, Hz.
    pub fn frequencies(&self) -> Vec<f64> {
        hertz(&self.bases)
    }

    /// How far the second phase turns in a period, rad.
    fn rotation(&self) -> f64 {
        match &self.bases[..] {
            [_, second] => second.frequency * self.circle.period(),
            _ => 0.0,
        }
    }

    /// Time after whole periods, s, where everything repeats already.
    pub fn time(&self, strobe: u64) -> f64 {
        (self.first() + strobe as f64) * self.circle.period()
    }

    /// Whole periods until everything repeats.
    fn first(&self) -> f64 {
        let from = self.bases.iter().map(|base| base.from).fold(0.0, f64::max);
        (from / self.circle.period()).ceil()
    }

    /// Phase of the second frequency at the time of strobe 0, rad.
    pub fn first_phase(&self) -> f64 {
        self.circle.phase(self.first() as u64)
    }
}

fn hertz(bases: &[Base]) -> Vec<f64> {
    bases.iter().map(|base| base.frequency / TAU).collect()
}
