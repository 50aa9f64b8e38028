//! The frequencies that a forcing is made of.

use std::f64::consts::TAU;

use serde::{Serialize, Serializer};

use crate::rotor::{Forcing, ForcingCause};

/// Two frequencies have a common period where their ratio is a fraction to this part of it.
const EXACT: f64 = 1e-11;
/// A common period is used where it is at most so many times the shorter one; beyond, two frequencies
/// are cheaper.
const LONGEST: u32 = 12;

/// A frequency of which one or more forcings are multiples.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Base {
    /// Angular frequency, rad/s.
    pub frequency: f64,
    /// Forcings and which multiple of it each is.
    pub(crate) parts: Vec<(ForcingCause, u32)>,
    /// Time from which on it repeats, s.
    pub from: f64,
}

impl Serialize for Base {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        #[allow(non_snake_case)]
        struct Keys {
            frequency_Hz: f64,
            period_s: f64,
            causes: Vec<Cause>,
        }
        #[derive(Serialize)]
        struct Cause {
            cause: String,
            multiple: u32,
        }
        let cause = |(cause, multiple): &(ForcingCause, u32)| Cause {
            cause: cause.to_string(),
            multiple: *multiple,
        };
        let keys = Keys {
            frequency_Hz: self.frequency / TAU,
            period_s: self.period(),
            causes: self.parts.iter().map(cause).collect(),
        };
        keys.serialize(serializer)
    }
}

impl Base {
    /// Period, s.
    pub fn period(&self) -> f64 {
        TAU / self.frequency
    }

    /// Whether balls that pass belong to it.
    pub(crate) fn has_ball_pass(&self) -> bool {
        let passes = |(cause, _): &(ForcingCause, u32)| {
            matches!(
                cause,
                ForcingCause::BallPass { .. } | ForcingCause::Cage { .. }
            )
        };
        self.parts.iter().any(passes)
    }

    /// Takes in a forcing that has a common period with what is here; whether it has one.
    fn take(&mut self, forcing: &Forcing) -> bool {
        let Some((own, other)) = fraction(self.frequency, forcing.frequency) else {
            return false;
        };
        self.frequency /= f64::from(own);
        for (_, multiple) in &mut self.parts {
            *multiple *= own;
        }
        self.parts.push((forcing.cause, other));
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
            found.push(Base {
                frequency: forcing.frequency,
                parts: vec![(forcing.cause, 1)],
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequencies_in_whole_ratios_share_one() {
        let forcing = |number, frequency| Forcing {
            cause: ForcingCause::Load { number },
            frequency,
            from: 0.0,
        };
        let common = bases(&[forcing(0, 100.0), forcing(1, 150.0)]);
        assert_eq!(common[0].frequency, 50.0);
        let apart = bases(&[forcing(0, 100.0), forcing(1, 141.42)]);
        assert_eq!(apart.len(), 2);
    }
}
