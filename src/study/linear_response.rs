//! The response of the linearised shaft: to a harmonic force at a point over its frequency, or to its unbalances over the speed.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::Complex;

use super::campbell::CampbellQuestion;
use super::resonance_places::{Place, between};
use crate::numerics::minimum::minimum;
use crate::numerics::root::root;
use crate::physics::PER_MINUTE;
use crate::rotor::{Excursion, GrowingMotion, Pickup, Rotor, RotorDefinition, RotorError};
use crate::simulate::{finer_modes, range_warnings};

/// A question about the linear response.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearResponseQuestion {
    /// The shaft; a force acts on it at the speed of its start, of its unbalances that speed is left out.
    pub rotor: RotorDefinition,
    /// Where it is looked at.
    pub at: Vec<Pickup>,
    /// Where a harmonic force acts; without one the unbalances act.
    pub by: Option<Pickup>,
    /// First and last angular frequency of the force, or speed, rad/s.
    pub range: [f64; 2],
    /// Number of them, at least 3.
    pub count: usize,
}

/// Angular frequency of the force, or speed, rad/s, with the motion of every pickup; none at an undamped resonance.
pub type Motions = (f64, Option<Vec<Complex<f64>>>);

/// Speed, rad/s, with the free motion that grows there, if any.
type Growing = (f64, Option<GrowingMotion>);

/// Motions of some pickups as complex amplitudes, m and rad, or of a force per N or N m.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearResponse {
    /// Of every frequency or speed.
    pub points: Vec<Motions>,
    /// Those with further ones about the resonances, close enough that a curve through them is smooth.
    pub drawn: Vec<Motions>,
    /// Resonances, by pickup and speed or frequency.
    pub resonances: Vec<Resonance>,
    /// Of a shaft that bends: largest difference from the response with fewer modes of bending, of the largest motion of the
    /// pickup.
    pub reduction_error: Option<f64>,
    /// What the reader should know.
    pub warnings: Vec<String>,
}

/// A peak of the response.
///
/// `AF = N/(N₂ − N₁)`, with N₁ and N₂ where the amplitude is 1/√2 of that of the peak at N.
///
/// Source: API Standard 617, 7th edition (2002), chapter 1, 2.6.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    /// Number of the pickup, from 0.
    pub pickup: usize,
    /// N, rad/s.
    pub peak: f64,
    /// Amplitude there, m or rad.
    pub amplitude: f64,
    /// Amplification factor AF; none where the range ends, or another peak begins, before the amplitude has fallen that far.
    pub amplification: Option<f64>,
}

/// Amplification factor above which the amplitude of a peak is that of where it was looked for, as without damping.
const UNBOUNDED: f64 = 0.1 / FOUND;

/// Amplification factor below which a resonance counts as critically damped.
const CRITICALLY_DAMPED: f64 = 2.5;

impl Resonance {
    /// Whether nothing bounds the amplitude, as without damping: the one that was found says nothing.
    pub fn is_unbounded(&self) -> bool {
        let unbounded = |factor: f64| factor > UNBOUNDED;
        !self.amplitude.is_finite() || self.amplification.is_some_and(unbounded)
    }

    /// Separation margin from an operating speed in rad/s, and the margin that is asked for, as parts of that speed.
    ///
    /// ```text
    /// below:  min(0.17 (1 − 1/(AF − 1.5)), 0.16)      above:  min(0.10 + 0.17 (1 − 1/(AF − 1.5)), 0.26)
    /// ```
    ///
    /// and none where AF < 2.5. Source: API Standard 617, 7th edition (2002), chapter 1, 2.6.2.10.
    pub fn separation(&self, operating: f64) -> (f64, Option<f64>) {
        let margin = (self.peak - operating).abs() / operating;
        let factor = match self.is_unbounded() {
            true => Some(f64::INFINITY),
            false => self.amplification,
        };
        let asked = factor.map(|factor| {
            let part = 0.17 * (1.0 - 1.0 / (factor - 1.5));
            match factor {
                factor if factor < CRITICALLY_DAMPED => 0.0,
                _ if self.peak < operating => part.min(0.16),
                _ => (0.10 + part).min(0.26),
            }
        });
        (margin, asked)
    }
}

/// Why there is no response.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LinearResponseError {
    /// The shaft cannot be assembled at a speed.
    #[error("at {speed} rad/s: {source}")]
    Rotor {
        /// The speed, rad/s.
        speed: f64,
        /// Why.
        source: RotorError,
    },
    /// A force on a place without mass.
    #[error(
        "nothing has a mass at {:.3} mm, where the force is to act: give the shaft a mass there, as by a disc",
        1e3 * position
    )]
    Massless {
        /// The position, m.
        position: f64,
    },
    /// It was to stop.
    #[error("the response was stopped before its end")]
    Stopped,
}

impl LinearResponseQuestion {
    /// Linearises the shaft about its static equilibrium, of the unbalances at every speed anew, and finds the resonances,
    /// until `stop` is set.
    ///
    /// # Errors
    /// [`LinearResponseError`] where the shaft has no equilibrium at a speed, a force acts where nothing has a mass, or it
    /// was stopped.
    pub fn solve(&self, stop: &AtomicBool) -> Result<LinearResponse, LinearResponseError> {
        let coarse = Solver::new(self, false, stop)?;
        let finer = coarse.modes.map(|_| Solver::new(self, true, stop));
        let finer = finer.transpose()?;
        let solver = finer.as_ref().unwrap_or(&coarse);
        let Followed {
            points,
            growing,
            mut excursions,
        } = solver.followed(self.values())?;
        let reduction_error = match &finer {
            Some(_) => Some(self.difference(&coarse, &points)?),
            None => None,
        };
        let looked_at = solver.with_resonances(&points)?;
        let mut resonances = Vec::new();
        for pickup in self.moving(&looked_at) {
            solver.add_resonances(pickup, &looked_at, &mut resonances)?;
        }
        let drawn = solver.about_resonances(looked_at, &resonances)?;
        let speeds = match self.by {
            Some(_) => [self.rotor.speed; 2],
            None => self.range,
        };
        let mut warnings = range_warnings(&self.rotor, speeds);
        warnings.extend(unstable(&growing));
        // by a force, and without clearances, nothing is known of excursions
        let has_gaps = excursions.iter().any(|(_, own)| !own.is_empty());
        for resonance in resonances
            .iter()
            .filter(|own| has_gaps && !own.is_unbounded())
        {
            let rotor = at_speed(&solver.rotor, resonance.peak)?;
            excursions.push((resonance.peak, rotor.linear_model().excursions()));
        }
        warnings.extend(beyond_clearances(excursions));
        Ok(LinearResponse {
            points,
            drawn,
            resonances,
            reduction_error,
            warnings: self.rotor.warnings_with(warnings),
        })
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        let ([from, to], last) = (self.range, self.count - 1);
        let step = (to - from) / last as f64;
        (0..=last).map(move |index| {
            if index == last {
                to
            } else {
                from + index as f64 * step
            }
        })
    }

    /// Largest difference of a response from some points, of the largest motion of the same pickup.
    fn difference(
        &self,
        solver: &Solver<'_>,
        points: &[Motions],
    ) -> Result<f64, LinearResponseError> {
        let mut apart = vec![0.0_f64; self.at.len()];
        for (value, found) in points {
            let other = solver.motions(*value)?;
            let pairs = found.iter().flatten().zip(other.iter().flatten());
            for (apart, (found, other)) in apart.iter_mut().zip(pairs) {
                *apart = apart.max((found - other).norm());
            }
        }
        let sizes = self.sizes(points);
        let parts = self
            .moving(points)
            .map(|pickup| apart[pickup] / sizes[pickup]);
        Ok(parts.fold(0.0, f64::max))
    }

    /// Largest amplitude of every pickup, as far as it is bounded.
    fn sizes(&self, points: &[Motions]) -> Vec<f64> {
        let mut sizes = vec![0.0_f64; self.at.len()];
        for motions in points.iter().filter_map(|(_, motions)| motions.as_ref()) {
            for (size, motion) in sizes.iter_mut().zip(motions) {
                *size = size.max(motion.norm());
            }
        }
        sizes
    }

    /// The pickups whose motion is more than round-off compared with the largest displacement, or tilt.
    fn moving(&self, points: &[Motions]) -> impl Iterator<Item = usize> {
        let sizes = self.sizes(points);
        let is_length = |pickup: usize| self.at[pickup].axis < 3;
        let largest = |pickup: usize| {
            let alike = (0..sizes.len()).filter(|other| is_length(*other) == is_length(pickup));
            alike.map(|other| sizes[other]).fold(0.0, f64::max)
        };
        let moves = |pickup: &usize| sizes[*pickup] > ROUND_OFF * largest(*pickup);
        let moving: Vec<usize> = (0..sizes.len()).filter(moves).collect();
        moving.into_iter()
    }
}

/// What is found along a range.
struct Followed {
    /// At every frequency of the force, or speed.
    points: Vec<Motions>,
    /// At every speed of the shaft.
    growing: Vec<Growing>,
    /// At every speed of a shaft that its unbalances move.
    excursions: Vec<(f64, Vec<Excursion>)>,
}

/// A question with so many modes of bending.
struct Solver<'a> {
    question: &'a LinearResponseQuestion,
    rotor: RotorDefinition,
    /// At the speed that a force acts at.
    assembled: Rotor,
    modes: Option<usize>,
    stop: &'a AtomicBool,
}

impl<'a> Solver<'a> {
    fn new(
        question: &'a LinearResponseQuestion,
        finer: bool,
        stop: &'a AtomicBool,
    ) -> Result<Self, LinearResponseError> {
        let mut rotor = question.rotor.clone();
        let pickups = question.at.iter().chain(&question.by);
        rotor.points.extend(pickups.map(|pickup| pickup.position));
        let highest = match question.by {
            Some(_) => rotor.speed,
            None => question.range[1],
        };
        let mut assembled = at_speed(&rotor, highest)?;
        let modes = assembled.bending_modes();
        if let Some(modes) = modes {
            let modes = if finer { finer_modes(modes) } else { modes };
            rotor = rotor.with_modes(modes);
            assembled = at_speed(&rotor, highest)?;
        }
        let refused = question
            .by
            .filter(|by| !assembled.linear_model().has_mass(*by));
        match refused {
            Some(Pickup { position, .. }) => Err(LinearResponseError::Massless { position }),
            None => Ok(Self {
                question,
                rotor,
                assembled,
                modes,
                stop,
            }),
        }
    }

    /// Follows the question over frequencies of the force, or speeds, in rad/s.
    fn followed(&self, values: impl Iterator<Item = f64>) -> Result<Followed, LinearResponseError> {
        let (mut points, mut growing, mut excursions) = (Vec::new(), Vec::new(), Vec::new());
        let at_force = self.question.by.map(|_| &self.assembled);
        growing.extend(at_force.map(|rotor| (rotor.speed(), rotor.growing_motion())));
        for value in values {
            self.go_on()?;
            match at_force {
                Some(rotor) => points.push((value, self.motions_of(rotor, value))),
                None => {
                    let rotor = at_speed(&self.rotor, value)?;
                    points.push((value, self.motions_of(&rotor, value)));
                    growing.push((value, rotor.growing_motion()));
                    excursions.push((value, rotor.linear_model().excursions()));
                }
            }
        }
        Ok(Followed {
            points,
            growing,
            excursions,
        })
    }

    fn go_on(&self) -> Result<(), LinearResponseError> {
        match self.stop.load(Ordering::Relaxed) {
            true => Err(LinearResponseError::Stopped),
            false => Ok(()),
        }
    }

    /// Motions of all pickups at a frequency of the force, or a speed, in rad/s.
    fn motions(&self, value: f64) -> Result<Option<Vec<Complex<f64>>>, LinearResponseError> {
        self.go_on()?;
        Ok(match self.question.by {
            Some(_) => self.motions_of(&self.assembled, value),
            None => self.motions_of(&at_speed(&self.rotor, value)?, value),
        })
    }

    fn motions_of(&self, rotor: &Rotor, value: f64) -> Option<Vec<Complex<f64>>> {
        let (model, at) = (rotor.linear_model(), &self.question.at);
        match self.question.by {
            Some(by) => model.to_force(value, by, at),
            None => model.to_unbalance(at),
        }
    }

    /// Amplitude of a pickup; infinite at an undamped resonance.
    fn amplitude(&self, pickup: usize, value: f64) -> Result<f64, LinearResponseError> {
        let motions = self.motions(value)?;
        Ok(motions.map_or(f64::INFINITY, |own| own[pickup].norm()))
    }

    /// The points with further ones about the modes, by which no peak is missed that is sharper than the grid.
    fn with_resonances(&self, points: &[Motions]) -> Result<Vec<Motions>, LinearResponseError> {
        let values: Vec<f64> = points.iter().map(|(value, _)| *value).collect();
        let places = between(&values, &self.resonance_places());
        let further = places
            .into_iter()
            .map(|value| Ok((value, self.motions(value)?)));
        let further = further.collect::<Result<Vec<_>, _>>()?;
        let mut all = [points, &further].concat();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(all)
    }

    /// The points with further ones about every resonance, evenly in the phase of a single mode: its loop in the plane is round.
    fn about_resonances(
        &self,
        mut points: Vec<Motions>,
        resonances: &[Resonance],
    ) -> Result<Vec<Motions>, LinearResponseError> {
        let [from, to] = self.question.range;
        let bounded = resonances.iter().filter(|own| !own.is_unbounded());
        for (own, factor) in bounded.filter_map(|own| Some((own, own.amplification?))) {
            for step in -PHASE_STEPS..=PHASE_STEPS {
                let phase = f64::from(step) * PHASE_STEP;
                let value = own.peak * (1.0 + 0.5 * phase.tan() / factor);
                if (from..to).contains(&value) {
                    points.push((value, self.motions(value)?));
                }
            }
        }
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.dedup_by(|a, b| a.0 == b.0);
        Ok(points)
    }

    /// Natural frequencies at the speed of a force, or critical speeds of unbalances; none where they cannot be followed.
    fn resonance_places(&self) -> Vec<Place> {
        if self.question.by.is_some() {
            return self.assembled.modes().iter().map(Place::from).collect();
        }
        let [from, to] = self.question.range;
        let critical = CampbellQuestion {
            rotor: self.rotor.clone(),
            from,
            to,
            count: FOLLOWED,
            orders: vec![1.0],
            highest_frequency: None,
        };
        let critical = critical.critical_speeds(self.stop).unwrap_or_default();
        let place = critical.iter().map(|own| Place {
            at: own.speed,
            damping_ratio: own.damping_ratio,
        });
        place.collect()
    }

    /// Adds the peaks of a pickup.
    fn add_resonances(
        &self,
        pickup: usize,
        points: &[Motions],
        resonances: &mut Vec<Resonance>,
    ) -> Result<(), LinearResponseError> {
        let amplitudes = points.iter().map(|(value, motions)| {
            let amplitude = motions
                .as_ref()
                .map_or(f64::INFINITY, |own| own[pickup].norm());
            (*value, amplitude)
        });
        let amplitudes: Vec<_> = amplitudes.collect();
        for middle in 1..amplitudes.len().max(1) - 1 {
            let [before, own, after] = [0, 1, 2].map(|step| amplitudes[middle + step - 1].1);
            if !(own > before && own >= after) {
                continue;
            }
            let ends = [amplitudes[middle - 1].0, amplitudes[middle + 1].0];
            let (peak, amplitude) = self.highest(pickup, ends)?;
            let below = amplitudes[..middle].iter().rev();
            let above = amplitudes[middle + 1..].iter();
            let sides = [
                self.half_power(pickup, (peak, amplitude), below)?,
                self.half_power(pickup, (peak, amplitude), above)?,
            ];
            let amplification = match sides {
                [Some(low), Some(high)] if amplitude.is_finite() => Some(peak / (high - low)),
                _ => None,
            };
            resonances.push(Resonance {
                pickup,
                peak,
                amplitude,
                amplification,
            });
        }
        Ok(())
    }

    /// The highest amplitude between two values, and where it is.
    fn highest(&self, pickup: usize, ends: [f64; 2]) -> Result<(f64, f64), LinearResponseError> {
        let depth = |value: f64| Ok(-self.amplitude(pickup, value)?);
        let (place, depth) = minimum(depth, ends, FOUND * ends[1])?;
        Ok((place, -depth))
    }

    /// Where the amplitude has fallen to 1/√2 of a peak on one of its sides; none where it rises above the peak before.
    fn half_power<'b>(
        &self,
        pickup: usize,
        (peak, amplitude): (f64, f64),
        side: impl Iterator<Item = &'b (f64, f64)>,
    ) -> Result<Option<f64>, LinearResponseError> {
        let level = FRAC_1_SQRT_2 * amplitude;
        let mut before = (peak, amplitude);
        for next in side {
            if next.1 > amplitude {
                return Ok(None);
            }
            if next.1 <= level {
                let mut sides = [before, *next];
                sides.sort_by(|a, b| a.0.total_cmp(&b.0));
                let (ends, values) = (sides.map(|own| own.0), sides.map(|own| own.1 - level));
                // what cannot be assembled between two speeds where it can is no root
                let height = |value: f64| self.amplitude(pickup, value).unwrap_or(f64::NAN) - level;
                return Ok(root(height, ends, values, FOUND * peak));
            }
            before = *next;
        }
        Ok(None)
    }
}

/// Speeds at which modes are looked at for critical speeds.
const FOLLOWED: usize = 41;

/// Phases from that of a peak at which its surroundings are drawn: up to 85° to either side.
const PHASE_STEP: f64 = 5.0 * TAU / 360.0;
const PHASE_STEPS: i32 = 17;

/// A pickup that moves less than this part of the largest motion is still.
const ROUND_OFF: f64 = 1e-9;

/// Part of a frequency to which peaks and sides are found: the amplitude about a peak is flat.
const FOUND: f64 = 1e-7;

/// The shaft at a constant speed in rad/s.
fn at_speed(rotor: &RotorDefinition, speed: f64) -> Result<Rotor, LinearResponseError> {
    Rotor::assemble(&rotor.at_constant_speed(speed))
        .map_err(|source| LinearResponseError::Rotor { speed, source })
}

/// Where the linearised shaft has no steady response, as free motions grow there.
fn unstable(growing: &[Growing]) -> Option<String> {
    let known = growing
        .iter()
        .filter_map(|(speed, own)| Some((*speed, (*own)?)));
    let (worst, motion) = known.min_by(|a, b| {
        let [a, b] = [a, b].map(|(_, motion)| motion.damping_ratio());
        a.total_cmp(&b)
    })?;
    let ranges = growing.chunk_by(|a, b| a.1.is_some() == b.1.is_some());
    let ranges = ranges.filter(|range| range[0].1.is_some()).map(|range| {
        let [first, last] = [range[0], range[range.len() - 1]].map(|(speed, _)| in_rpm(speed));
        match first == last {
            true => format!("at {first} rpm"),
            false => format!("from {first} to {last} rpm"),
        }
    });
    Some(format!(
        "the linearised shaft is not stable {}: at {} rpm {motion}; the response given there is no motion that it settles to",
        ranges.collect::<Vec<_>>().join(", "),
        in_rpm(worst)
    ))
}

/// Elements whose clearance the response exceeds, of which it knows nothing.
fn beyond_clearances(mut excursions: Vec<(f64, Vec<Excursion>)>) -> Vec<String> {
    excursions.sort_by(|a, b| a.0.total_cmp(&b.0));
    let elements = excursions.first().map_or(0, |(_, own)| own.len());
    let reported = (0..elements).filter_map(|index| {
        let of_element = excursions.iter().filter_map(|(speed, own)| Some((*speed, own.get(index)?)));
        let beyond = of_element.filter(|(_, own)| own.distance > own.clearance);
        let beyond: Vec<_> = beyond.collect();
        let (first, own) = beyond.first()?;
        let farthest = beyond.iter().max_by(|a, b| a.1.distance.total_cmp(&b.1.distance))?;
        let [distance, clearance] = [farthest.1.distance, own.clearance].map(|own| 1e6 * own);
        Some(format!(
            "from {} rpm on the response takes the shaft beyond the clearance of element {}, {clearance:.1} µm: at {} rpm {distance:.1} \
             µm from its middle; the linear response knows no clearance, `run` and `steady` do",
            in_rpm(*first),
            own.element,
            in_rpm(farthest.0)
        ))
    });
    reported.collect()
}

/// A speed in rpm, to a tenth.
fn in_rpm(speed: f64) -> String {
    format!("{:.1}", speed * PER_MINUTE)
}
