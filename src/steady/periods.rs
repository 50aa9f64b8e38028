//! The independent frequencies of a forcing, and when the periods of a map over it begin.

use std::f64::consts::TAU;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::SteadyError;
use crate::keys;
use crate::rotor::{Forcing, ForcingCause, Rotor};
use crate::shooting::Circle;

/// Two frequencies have a common period where their ratio is a fraction to this part of it.
const EXACT: f64 = 1e-11;
/// A common period is used where it is at most so many times the shorter one; beyond, two frequencies
/// are cheaper.
const LONGEST: u32 = 12;
/// Two ratios of frequencies are the same to this part of a turn.
const SAME_RATIO: f64 = 1e-9;

/// A frequency of which one or more forcings are multiples.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Base {
    /// Angular frequency, rad/s.
    pub frequency: f64,
    /// The forcings.
    pub(crate) parts: Vec<BasePart>,
    /// Time from which on it repeats, s.
    pub from: f64,
}

/// A forcing, and which multiple of a base it is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct BasePart {
    #[serde(serialize_with = "keys::name")]
    pub cause: ForcingCause,
    pub multiple: u32,
}

impl Serialize for Base {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut keys = serializer.serialize_struct("Base", 3)?;
        keys.serialize_field("frequency_Hz", &(self.frequency / TAU))?;
        keys.serialize_field("period_s", &self.period())?;
        keys.serialize_field("causes", &self.parts)?;
        keys.end()
    }
}

impl Base {
    /// Period, s.
    pub fn period(&self) -> f64 {
        TAU / self.frequency
    }

    /// Whether balls that pass belong to it.
    pub(crate) fn has_ball_pass(&self) -> bool {
        let mut causes = self.parts.iter().map(|part| part.cause);
        causes.any(|cause| matches!(cause, ForcingCause::BallPass(_) | ForcingCause::Cage(_)))
    }

    /// Takes in a forcing that has a common period with what is here; whether it has one.
    fn take(&mut self, forcing: &Forcing) -> bool {
        let Some((own, multiple)) = fraction(self.frequency, forcing.frequency) else {
            return false;
        };
        self.frequency /= f64::from(own);
        for part in &mut self.parts {
            part.multiple *= own;
        }
        let cause = forcing.cause;
        self.parts.push(BasePart { cause, multiple });
        self.from = self.from.max(forcing.from);
        true
    }
}

/// `[p, q]` with `first/second = p/q`.
fn fraction(first: f64, second: f64) -> Option<(u32, u32)> {
    let ratio = first / second;
    (1..=LONGEST).find_map(|q| {
        let p = (ratio * f64::from(q)).round();
        let fits = (p / (ratio * f64::from(q)) - 1.0).abs() < EXACT;
        (fits && p >= 1.0 && p <= f64::from(LONGEST)).then_some((p as u32, q))
    })
}

/// The independent frequencies of some forcings, that of passing balls first, then the highest first.
pub fn bases(forcings: &[Forcing]) -> Vec<Base> {
    let mut found: Vec<Base> = Vec::new();
    for forcing in forcings {
        if !found.iter_mut().any(|base| base.take(forcing)) {
            let (cause, multiple) = (forcing.cause, 1);
            found.push(Base {
                frequency: forcing.frequency,
                parts: vec![BasePart { cause, multiple }],
                from: forcing.from,
            });
        }
    }
    found.sort_by(|a, b| {
        let passing = b.has_ball_pass().cmp(&a.has_ball_pass());
        passing.then(b.frequency.total_cmp(&a.frequency))
    });
    found
}

/// The periods of a forcing of one or two frequencies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Periods {
    /// One or two frequencies; the period is that of the first.
    pub bases: Vec<Base>,
    /// How many of these make one of the map.
    pub multiple: u32,
    /// The states over the phase of the second frequency.
    pub circle: Circle,
}

impl Periods {
    /// What repeats in a rotor, over a multiple of its period.
    pub fn new(rotor: &Rotor, multiple: u32) -> Result<Self, SteadyError> {
        if multiple == 0 {
            return Err(SteadyError::NoPeriods);
        }
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

    /// These periods with so many harmonics of the second frequency.
    pub fn with_harmonics(&self, harmonics: usize) -> Result<Self, SteadyError> {
        let circle = Circle::around(self.circle.period, self.rotation(), harmonics);
        Ok(Self {
            circle: circle.ok_or_else(|| SteadyError::NearlyCommon {
                frequencies: self.frequencies(),
                searched: Circle::searched(harmonics),
            })?,
            ..self.clone()
        })
    }

    /// The periods of another rotor whose frequencies have the same ratio.
    pub fn with_rotor(&self, rotor: &Rotor) -> Result<Self, SteadyError> {
        let other = Self::new(rotor, self.multiple)?;
        let turn = (other.rotation() - self.rotation()).abs();
        if other.bases.len() != self.bases.len() || turn > SAME_RATIO * TAU {
            return Err(SteadyError::RatioChanges);
        }
        Ok(Self {
            circle: Circle {
                period: other.circle.period,
                ..self.circle.clone()
            },
            ..other
        })
    }

    /// These frequencies over another multiple of the period; a single frequency only.
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
            [_, second] => second.frequency * self.circle.period,
            _ => 0.0,
        }
    }

    /// Time after whole periods, s, where everything repeats already.
    pub fn time(&self, strobe: u64) -> f64 {
        (self.first() + strobe as f64) * self.circle.period
    }

    /// Whole periods until everything repeats.
    fn first(&self) -> f64 {
        let from = self.bases.iter().map(|base| base.from).fold(0.0, f64::max);
        (from / self.circle.period).ceil()
    }

    /// Phase of the second frequency at the time of strobe 0, rad.
    pub fn first_phase(&self) -> f64 {
        self.circle.phase(self.first() as u64)
    }
}

fn hertz(bases: &[Base]) -> Vec<f64> {
    bases.iter().map(|base| base.frequency / TAU).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequencies_in_whole_ratios_share_one() {
        let forcing = |number, frequency| Forcing {
            cause: ForcingCause::Load(number),
            frequency,
            from: 0.0,
        };
        let common = bases(&[forcing(0, 100.0), forcing(1, 150.0)]);
        assert_eq!(common[0].frequency, 50.0);
        let apart = bases(&[forcing(0, 100.0), forcing(1, 141.42)]);
        assert_eq!(apart.len(), 2);
    }
}
