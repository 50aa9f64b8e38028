//! Steady motions along a parameter: turning points, both branches of a hysteresis, doubled periods.

use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::Complex;
use serde::Serialize;

use super::lines::ranges;
use super::measured::found_again;
use super::periods::Periods;
use super::rotor_map::{RotorMap, Solver};
use super::samples::sampled;
use super::search::locate;
use super::solve::rolling_cages;
use super::{MotionRange, SteadyError};
use crate::analysis::Channel;
use crate::integrate::Counters;
use crate::keys;
use crate::rotor::{CageMotion, Rotor, RotorDefinition};
use crate::shooting::{
    Branch, BranchEnd, BranchPoint, Continuation, ReturnMap, SpecialKind, Stability, Unrefined,
    follow, follow_doubled,
};
use crate::simulate::{Model, speed_warnings};

/// Steps that the range of the parameter is divided into at least, and the least part of one.
const STEPS: f64 = 50.0;
const LEAST_PART: f64 = 1e-5;
/// Part of the tolerance that motions are integrated with: where two motions meet, the residual
/// is far smaller than the error of the states.
const EXACTER: f64 = 0.1;
const TIGHTEST: f64 = 1e-13;
/// Doublings of the period that are followed, one out of the other.
const MOST_DOUBLINGS: u32 = 3;

/// What to follow.
pub struct ResponseQuestion<'a> {
    /// The scene: method, tolerance and sampling.
    pub model: &'a Model,
    /// The rotor at a value of the parameter, or what is wrong with it.
    pub family: &'a dyn Fn(f64) -> Result<RotorDefinition, String>,
    /// First and last value of the parameter.
    pub range: [f64; 2],
    /// How many periods of the forcing the motion takes.
    pub multiple: u32,
    /// Most motions of a branch.
    pub points: usize,
    /// Whether motions of doubled period are followed as well.
    pub doubled: bool,
    /// Set to end the search at its next step.
    pub stop: &'a AtomicBool,
    /// Counts the periods that were integrated, for whoever watches the search.
    pub integrated: &'a AtomicU64,
}

impl ResponseQuestion<'_> {
    /// Value of the parameter at a part of its range.
    fn value(&self, part: f64) -> f64 {
        let [from, to] = self.range;
        from + (to - from) * part
    }

    /// Tolerance that motions are found to.
    fn tolerance(&self) -> f64 {
        self.model.integrator.tolerance.max(10.0 * TIGHTEST)
    }

    /// The rotor at a value of the parameter, its cages as asked for or rolling at the free contact angle.
    fn rotor(&self, value: f64, rolling: bool) -> Result<RotorDefinition, String> {
        let rotor = (self.family)(value)?;
        let cage = if rolling {
            CageMotion::Rolling
        } else {
            rotor.cage
        };
        Ok(RotorDefinition { cage, ..rotor })
    }

    /// Why cages have to roll at the free contact angle: with those of the loaded balls the forcing has more than two
    /// frequencies at an end of the range, or two that change their ratio, and with these it has not.
    fn against_operating_cages(&self) -> Option<SteadyError> {
        let operating = self.model.rotor.cage == CageMotion::Operating;
        let refusal = operating.then(|| self.refusal(false)).flatten();
        refusal.filter(|_| self.refusal(true).is_none())
    }

    /// Why a motion cannot be followed from end to end of the range, as far as the frequencies of the forcing say.
    fn refusal(&self, rolling: bool) -> Option<SteadyError> {
        let [first, last] = self.range.map(|value| {
            let rotor = self.rotor(value, rolling).map_err(SteadyError::Parameter)?;
            Ok(Rotor::assemble(&rotor)?)
        });
        let periods = first.and_then(|rotor| Periods::new(&rotor, self.multiple));
        let both = periods.and_then(|periods| periods.with_rotor(&last?));
        both.err().filter(|error| {
            matches!(
                error,
                SteadyError::Frequencies { .. } | SteadyError::RatioChanges
            )
        })
    }
}

/// Distance of the ranges of a motion from those of the same one found again at a tenth of the tolerance, with the round-off
/// that both share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeError {
    /// Largest difference of a mean or a peak-to-peak range of a displacement, m.
    pub displacement: f64,
    /// That difference over the largest peak-to-peak range.
    pub relative: f64,
    /// Tolerance of the motion that was found again.
    pub reference_tolerance: f64,
}

impl RangeError {
    /// Of a motion whose smallest change over a period is such a part of a departure from it: what a state errs by, by
    /// round-off, is so much more; none where nothing moves.
    fn between(
        ranges: &[MotionRange],
        exact: &[MotionRange],
        (round_off, change): (f64, f64),
        reference_tolerance: f64,
    ) -> Option<Self> {
        let (mut displacement, mut size, mut mean) = (0.0_f64, 0.0_f64, 0.0_f64);
        let pairs = ranges.iter().zip(exact);
        for (range, exact) in pairs.filter(|(range, _)| range.channel.unit() == "m") {
            let apart = [
                range.mean - exact.mean,
                range.peak_to_peak - exact.peak_to_peak,
            ];
            displacement = displacement.max(apart[0].abs()).max(apart[1].abs());
            size = size.max(exact.peak_to_peak);
            mean = mean.max(exact.mean.abs());
        }
        displacement += round_off + f64::EPSILON * (mean + size / change.min(1.0));
        (size > 0.0).then(|| Self {
            displacement,
            relative: displacement / size,
            reference_tolerance,
        })
    }
}

/// A motion of a branch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ResponsePoint {
    /// Value of the parameter.
    pub value: f64,
    /// Period of the motion, s.
    #[serde(rename = "period_s")]
    pub period: f64,
    /// Ranges of displacements and forces.
    pub ranges: Vec<MotionRange>,
    /// Floquet multipliers over the period, magnitudes where it has two frequencies.
    #[serde(serialize_with = "keys::complex")]
    pub multipliers: Vec<Complex<f64>>,
    /// Error of every multiplier, in their order; none where it was not measured or the motion not found again.
    pub multiplier_errors: Vec<f64>,
    /// Error of the ranges; none where it was not measured or the motion not found again.
    #[serde(skip)]
    pub range_error: Option<RangeError>,
    /// Whether neighbouring motions come closer.
    pub stable: bool,
    /// Whether they neither do nor go away, as far as the errors of the multipliers tell.
    pub neutral: bool,
}

/// Where a branch turns or its motion changes its kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ResponseSpecial {
    /// How.
    #[serde(serialize_with = "keys::name")]
    pub kind: SpecialKind,
    /// Number of points of the branch before it.
    #[serde(rename = "after_points")]
    pub after: usize,
    /// The motion there.
    #[serde(flatten)]
    pub point: ResponsePoint,
}

/// A branch of motions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Response {
    /// How many periods of the forcing its motions take.
    pub multiple: u32,
    /// Its motions, in their order along it.
    #[serde(serialize_with = "keys::count")]
    pub points: Vec<ResponsePoint>,
    /// Where it turns or its motion changes its kind.
    pub specials: Vec<ResponseSpecial>,
    /// Where they seem to between two values of the parameter, without a point that could be found.
    pub unrefined: Vec<Unrefined>,
    /// Why it ends, in words.
    pub end: String,
    /// Whether it goes on beyond its last motion: it was lost, or has as many motions as asked for.
    pub incomplete: bool,
    /// Work done.
    pub counters: Counters,
}

/// Follows the motion of a scene along a parameter, and from every doubling of its period the motion of
/// twice the period.
///
/// `progress` is called with the parameter of the present motion, 0 … 1 along the range.
///
/// # Errors
/// [`SteadyError`] where there is no motion at the first value, or somebody stopped the search; a branch
/// that is lost on its way says so.
pub fn response(
    question: &ResponseQuestion<'_>,
    progress: &mut dyn FnMut(f64),
) -> Result<Vec<Response>, SteadyError> {
    let rolling = question.against_operating_cages().is_some();
    let first = question.rotor(question.range[0], rolling);
    let first = first.map_err(SteadyError::Parameter)?;
    let rotor = Rotor::assemble(&first)?;
    let periods = Periods::new(&rotor, question.multiple)?;
    let source = |parameter: f64| question.rotor(question.value(parameter), rolling);
    let mut settings = question.model.integrator;
    settings.tolerance = (EXACTER * settings.tolerance).max(TIGHTEST);
    let solver = Solver::new(settings, question.stop, question.integrated);
    let mut map = RotorMap::new(rotor, periods, solver);
    let guess = locate(&mut map)?.returned.states;
    map.source = Some((&source, 0.0));
    let plan = Continuation {
        tolerance: question.tolerance(),
        step: 1.0 / STEPS,
        least_step: LEAST_PART / STEPS,
        points: question.points,
    };
    let mut watch = |point: &BranchPoint| progress(point.parameter.clamp(0.0, 1.0));
    let main = follow(&mut map, guess, &plan, &mut watch)?;
    stopped(&main)?;
    let mut found = vec![answer(&mut map, &main, question)?];
    let mut doublings = doublings(&main, 1);
    while let Some((point, doubled)) = doublings.pop() {
        let multiple = question.multiple << doubled;
        if !question.doubled
            || map.periods.is_torus()
            || is_on_another(&found, multiple, &point, question)
        {
            continue;
        }
        let mut twice = map.clone();
        twice.periods = map.periods.times(multiple);
        twice.counters = Counters::default();
        let branch = follow_doubled(&mut twice, &point, &plan, &mut watch)
            .unwrap_or_else(|error| Branch::without_points(BranchEnd::Lost(error)));
        stopped(&branch)?;
        found.push(answer(&mut twice, &branch, question)?);
        if doubled < MOST_DOUBLINGS {
            doublings.extend(self::doublings(&branch, doubled + 1));
        }
    }
    Ok(found)
}

/// What the reader of the branches should know: of the scene at both ends of the range, then what ends a branch early.
pub fn response_warnings(question: &ResponseQuestion<'_>, branches: &[Response]) -> Vec<String> {
    let ends = question
        .range
        .into_iter()
        .filter_map(|end| (question.family)(end).ok());
    let at_ends = ends.flat_map(|rotor| rotor.warnings_with(speed_warnings(&rotor)));
    let refusal = question.against_operating_cages();
    let rolling = refusal.as_ref().map(rolling_cages);
    let incomplete = branches.iter().filter(|branch| branch.incomplete);
    let ended_early = incomplete.map(|branch| branch.end.clone());
    question
        .model
        .rotor
        .warnings_with(at_ends.chain(rolling).chain(ended_early))
}

/// Ends the search where somebody stopped it.
fn stopped(branch: &Branch) -> Result<(), SteadyError> {
    match &branch.end {
        BranchEnd::Lost(error) if error.is_interrupted() => Err(error.clone().into()),
        _ => Ok(()),
    }
}

/// The doublings of a branch, the last first, with how often the period of their motion is doubled.
fn doublings(branch: &Branch, doubled: u32) -> Vec<(BranchPoint, u32)> {
    let specials = branch.specials.iter().rev();
    specials
        .filter(|special| special.kind == SpecialKind::PeriodDoubling)
        .map(|special| (special.point.clone(), doubled))
        .collect()
}

/// Whether a branch of doubled period that was followed already ends at this doubling.
fn is_on_another(
    found: &[Response],
    multiple: u32,
    point: &BranchPoint,
    question: &ResponseQuestion<'_>,
) -> bool {
    let [from, to] = question.range;
    let value = question.value(point.parameter);
    let near =
        |point: &ResponsePoint| (point.value - value).abs() < 1.5 * (to - from).abs() / STEPS;
    let ends = |response: &&Response| response.multiple == multiple;
    let mut same = found.iter().filter(ends);
    same.any(|response| response.points.last().is_some_and(near))
}

/// What there is to tell of a branch.
fn answer(
    map: &mut RotorMap<'_>,
    branch: &Branch,
    question: &ResponseQuestion<'_>,
) -> Result<Response, SteadyError> {
    let mut points = Vec::new();
    for point in &branch.points {
        points.push(response_point(map, point, question)?);
    }
    let mut specials = Vec::new();
    for special in &branch.specials {
        specials.push(ResponseSpecial {
            kind: special.kind,
            after: special.after,
            point: response_point(map, &special.point, question)?,
        });
    }
    let unrefined = branch.unrefined.iter().map(|unrefined| Unrefined {
        between: unrefined.between.map(|part| question.value(part)),
        ..*unrefined
    });
    Ok(Response {
        multiple: map.periods.multiple,
        points,
        specials,
        unrefined: unrefined.collect(),
        end: match &branch.end {
            BranchEnd::Reached => "the parameter reached its last value".to_owned(),
            BranchEnd::CameBack => "the branch came back to the first value".to_owned(),
            BranchEnd::Closed => "the period became single again".to_owned(),
            BranchEnd::Points => format!(
                "the branch goes on beyond its {} motions: raise --points, or narrow --from and --to",
                branch.points.len()
            ),
            BranchEnd::Lost(error) => format!("the branch was lost: {error}"),
        },
        incomplete: matches!(branch.end, BranchEnd::Lost(_) | BranchEnd::Points),
        counters: map.counters,
    })
}

fn response_point(
    map: &mut RotorMap<'_>,
    point: &BranchPoint,
    question: &ResponseQuestion<'_>,
) -> Result<ResponsePoint, SteadyError> {
    map.set(point.parameter)?;
    let sampled = sampled(map, &point.states, question.model, true)?;
    let channels = Channel::of_motion(&question.model.rotor);
    let ranges = ranges(&channels, &map.periods.circle, &sampled);
    let measured = match question.model.verify {
        true => measured_point(map, point, &ranges, question),
        false => None,
    };
    let (multiplier_errors, range_error) = measured.unwrap_or_default();
    let stability = match multiplier_errors.is_empty() {
        true => map.stability(&point.multipliers, &point.slopes),
        false => point.multipliers.stability(&multiplier_errors),
    };
    Ok(ResponsePoint {
        value: question.value(point.parameter),
        period: map.periods.circle.period,
        ranges,
        multipliers: point.multipliers.values(),
        multiplier_errors,
        range_error,
        stable: stability == Stability::Stable,
        neutral: stability == Stability::Neutral,
    })
}

/// Errors of the multipliers of a motion and of its ranges: their distances from those of the same one found again at a tenth of
/// the tolerance; none where it is not found again, as where two motions meet.
fn measured_point(
    map: &mut RotorMap<'_>,
    point: &BranchPoint,
    ranges: &[MotionRange],
    question: &ResponseQuestion<'_>,
) -> Option<(Vec<f64>, Option<RangeError>)> {
    let asked = map.solver;
    map.solver = asked.reference();
    let tolerance = map.solver.settings.tolerance;
    let again = found_again(map, &point.states, &point.slopes, question.tolerance());
    let again = again.ok().map(|(states, multipliers)| {
        let sampled = sampled(map, &states, question.model, false);
        (sampled, multipliers)
    });
    map.solver = asked;
    let (sampled, multipliers) = again?;
    let round_off = map.multiplier_round_off(&point.slopes);
    let errors = point.multipliers.distances(&multipliers, round_off);
    let changes = point.multipliers.values().into_iter();
    let change = changes.map(|own| (1.0 - own).norm()).fold(1.0, f64::min);
    let channels = ranges.iter().map(|range| range.channel);
    let range_error = sampled.ok().and_then(|sampled| {
        let channels: Vec<_> = channels.collect();
        let exact = self::ranges(&channels, &map.periods.circle, &sampled);
        let round_off = (map.rotor.displacement_round_off(), change);
        RangeError::between(ranges, &exact, round_off, tolerance)
    });
    Some((errors, range_error))
}
