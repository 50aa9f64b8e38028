//! Which method integrates a scene at the least cost, by trial.

use std::sync::atomic::AtomicBool;

use crate::bearing::{ContactLaw, MountedBearing};
use crate::integrate::{Counters, IntegrateError, Method};
use crate::rotor::RotorDefinition;
use crate::simulate::{BareRun, Model, SimulateError};

/// Part of the duration that the explicit method is tried over: its cost is even.
const EXPLICIT_PART: f64 = 0.02;
/// Part of the duration that other methods are tried over: theirs falls as the motion settles.
const OTHER_PART: f64 = 0.1;
/// A trial of another method ends where it has cost this part of the whole run by the explicit one.
const DEAR: f64 = 0.1;
/// Fewest steps that a trial may take.
const FEWEST_STEPS: u64 = 100;
/// Most steps of the explicit trial, which end it.
const EXPLICIT_STEPS: u64 = 50_000;

/// What a method was found to cost.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodCost {
    /// The method.
    pub method: Method,
    /// Evaluations over the trial.
    pub evaluations: u64,
    /// What the whole run is expected to take, s: at the prices that `benches/right_hand_side` found on
    /// one server, so that only ratios are of use. None where the trial was given up.
    pub expected: Option<f64>,
    /// Simulated time of the trial, s.
    pub tried: f64,
}

/// The method that was chosen, and what it was chosen from.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodChoice {
    /// The cheapest method of those that were tried.
    pub chosen: Method,
    /// Those that were tried; the explicit one first.
    pub tried: Vec<MethodCost>,
    /// Why another method was not tried, where none was.
    pub alone: Option<&'static str>,
}

/// Tries the methods that can be the cheapest one on the first part of a run, and picks by their
/// evaluations, the steps of both halves of the trial and what an evaluation costs under the laws of the
/// scene. No clock is read: the same model gives the same choice.
///
/// [`Method::Verner76`] is always tried, [`Method::Exponential`] where no drive decides the speed (its
/// cost is taken to grow with the speed), and [`Method::Rodas`] where contacts are damped.
///
/// # Errors
/// [`SimulateError`] where the scene cannot be assembled.
pub fn choose_method(model: &Model) -> Result<MethodChoice, SimulateError> {
    let explicit = trial(model, Method::Verner76, EXPLICIT_PART, EXPLICIT_STEPS)?;
    let mut choice = MethodChoice {
        chosen: Method::Verner76,
        tried: vec![explicit],
        alone: why_alone(&model.rotor),
    };
    if choice.alone.is_none() {
        let damped = is_damped(&model.rotor);
        let others = [Method::Exponential, Method::Rodas];
        for method in others.into_iter().take(if damped { 2 } else { 1 }) {
            let limit = step_limit(model, method, choice.least());
            choice.tried.push(trial(model, method, OTHER_PART, limit)?);
        }
        let cheapest = choice.tried.iter().min_by(|a, b| {
            let cost = |tried: &MethodCost| tried.expected.unwrap_or(f64::INFINITY);
            cost(a).total_cmp(&cost(b))
        });
        choice.chosen = cheapest.map_or(Method::Verner76, |cheapest| cheapest.method);
    }
    Ok(choice)
}

impl MethodChoice {
    /// Least cost that is expected so far.
    fn least(&self) -> f64 {
        let expected = self.tried.iter().filter_map(|tried| tried.expected);
        expected.fold(f64::INFINITY, f64::min)
    }
}

fn why_alone(rotor: &RotorDefinition) -> Option<&'static str> {
    let driven = "a drive decides the speed: the first part of a run tells nothing of the rest";
    rotor.drive.is_some().then_some(driven)
}

fn is_damped(rotor: &RotorDefinition) -> bool {
    let mut bearings = rotor.bearings.iter();
    bearings.any(|bearing| !bearing.contact_damping.is_none())
}

/// Steps after which another method is dearer than `least` seconds for the whole run allow.
fn step_limit(model: &Model, method: Method, least: f64) -> u64 {
    let price = Price::of(model, method);
    let steps = DEAR * least / (price.evaluation * price.evaluations_per_step);
    if steps.is_finite() {
        (steps as u64).max(FEWEST_STEPS)
    } else {
        EXPLICIT_STEPS
    }
}

/// Integrates the first part of a run; what its second half costs goes on to the end.
fn trial(
    model: &Model,
    method: Method,
    part: f64,
    limit: u64,
) -> Result<MethodCost, SimulateError> {
    let whole = (part * model.duration)
        .max(Price::LEAST_TRIAL)
        .min(model.duration);
    let price = Price::of(model, method);
    let mut cost = MethodCost {
        method,
        evaluations: 0,
        expected: None,
        tried: whole,
    };
    let Some([half, both]) = integrate(model, method, whole, limit)? else {
        return Ok(cost);
    };
    cost.evaluations = both.evaluations;
    let seconds = |evaluations: u64| evaluations as f64 * price.evaluation;
    let rate = seconds(both.evaluations - half.evaluations) / (0.5 * whole);
    let growth = if method == Method::Exponential {
        faster(model, whole)
    } else {
        1.0
    };
    let rest = growth * rate * (model.duration - whole);
    cost.expected = Some(price.start + seconds(both.evaluations) + rest);
    Ok(cost)
}

/// Mean speed of the run after a trial that ends at `tried` in s, over that in its second half.
fn faster(model: &Model, tried: f64) -> f64 {
    let Ok(profile) = model.rotor.speed_profile() else {
        return 1.0;
    };
    let angle = |time: f64| profile.at(time).angle;
    let mean = |from: f64, to: f64| (angle(to) - angle(from)) / (to - from);
    let growth = mean(tried, model.duration) / mean(0.5 * tried, tried);
    // none where the trial is the whole run, or the shaft stands still
    if growth.is_nan() { 1.0 } else { growth }
}

/// Work over the first half of the first `duration` in s and over all of it; none where the method takes
/// too many steps.
fn integrate(
    model: &Model,
    method: Method,
    duration: f64,
    limit: u64,
) -> Result<Option<[Counters; 2]>, SimulateError> {
    let mut model = model.clone();
    model.duration = duration;
    model.settle = 0.0;
    model.integrator.method = method;
    model.integrator.step_limit = limit.min(model.integrator.step_limit);
    match BareRun::new(&model)?.integrate_in_parts(0.5, &AtomicBool::new(false)) {
        Ok(counters) => Ok(Some(counters)),
        // whatever else ends it will end the run, too, and be told there
        Err(SimulateError::Integrate(
            IntegrateError::StepLimit { .. }
            | IntegrateError::StepUnderflow { .. }
            | IntegrateError::NotFinite { .. },
        )) => Ok(None),
        Err(error) => Err(error),
    }
}

/// What a method costs on one core, s, by `benches/right_hand_side` on one server. Only ratios matter.
struct Price {
    /// Of an evaluation, with its share of the step.
    evaluation: f64,
    evaluations_per_step: f64,
    /// Of the matrices that a run begins with.
    start: f64,
}

impl Price {
    /// Shortest trial, s: shorter ones are all transient.
    const LEAST_TRIAL: f64 = 2e-3;

    fn of(model: &Model, method: Method) -> Self {
        let bearings = model.rotor.bearings.iter();
        let force: f64 = bearings
            .map(|bearing| ring_price(bearing, model.table))
            .sum();
        let derivative = 45e-9 + force;
        match method {
            Method::Exponential => Self {
                evaluation: derivative + 300e-9,
                evaluations_per_step: 6.0,
                start: 300e-6,
            },
            // four stages share one matrix, which costs about as many derivatives, and its factors
            Method::Rodas => Self {
                evaluation: 3.0 * derivative + 300e-9,
                evaluations_per_step: 6.0,
                start: 0.0,
            },
            _ => Self {
                evaluation: derivative + 55e-9,
                evaluations_per_step: 9.0,
                start: 0.0,
            },
        }
    }
}

/// Of the force of a bearing, s.
fn ring_price(bearing: &MountedBearing, table: bool) -> f64 {
    let ball = match (bearing.law, bearing.oil.is_some()) {
        (ContactLaw::Linear, _) => 0.0,
        (ContactLaw::Hertz, false) => 5e-9,
        _ if table => 18e-9,
        (ContactLaw::Hertz, true) => 65e-9,
        (ContactLaw::Jones(_), false) => 270e-9,
        (ContactLaw::Jones(_), true) => 630e-9,
    };
    ball * bearing.bearing.geometry.balls() as f64
}
