//! The truth that errors are measured against: two different methods, as exact as the scene allows.

use std::fmt;
use std::sync::atomic::AtomicBool;

use serde::{Serialize, Serializer};

use super::trial::{Trial, unless_stopped, with};
use super::truth::{Scale, Truth};
use super::{AccuracyError, Errors, Question};
use crate::analysis::Moments;
use crate::integrate::Method;
use crate::rotor::Rotor;
use crate::simulate::Model;

/// Methods that share neither coefficients nor code, those before the others first: `auto` as long as the exponential method
/// carries all of it, which it does where that is cheap.
const METHODS: [Method; 4] = [
    Method::Verner76,
    Method::Auto,
    Method::Dop853,
    Method::Rodas,
];
/// Tolerances that a method is taken through, as far as time allows.
const TOLERANCES: [f64; 3] = [1e-8, 1e-10, 1e-12];
/// How much longer the next of these tolerances takes at most: two decades at order 3.5.
const NEXT_TAKES: f64 = 4.0;
/// A reference may take so many times as long as any other run.
const PATIENCE: f64 = 4.0;

/// References that differ by more than this part of the motion have diverged.
const PARTED: f64 = 1e-4;
/// Small differences that grow by more than this over the run make it irregular.
const AMPLIFIED: f64 = 1e6;
/// Parts of the run whose differences are compared.
const PARTS: usize = 16;

/// How the reference was found, and how far it can be trusted.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Agreement {
    /// Method and tolerance of the reference.
    #[serde(rename = "run")]
    pub reference: ExactRun,
    /// Method and tolerance of the run that it is compared with.
    #[serde(rename = "compared_with")]
    pub other: ExactRun,
    /// Distance of the two: the uncertainty of every error that is measured against the reference.
    pub uncertainty: Errors,
    /// Scatter of the statistics among all exact runs; as the uncertainty in all else.
    #[serde(rename = "scatter_of_statistics", serialize_with = "statistics")]
    pub scatter: Errors,
    /// Number of exact runs.
    #[serde(rename = "exact_runs")]
    pub runs: usize,
    /// How much the difference of the two grows from the first sixteenth of the run on: the largest part
    /// over the first.
    #[serde(rename = "growth_of_differences")]
    pub growth: f64,
    /// Whether traces cannot be compared: the references diverge.
    pub irregular: bool,
    /// What errors are relative to.
    #[serde(flatten)]
    pub(crate) scale: Scale,
}

/// Method and tolerance of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExactRun {
    /// Name of the method.
    pub method: String,
    /// Its tolerance.
    pub tolerance: f64,
}

impl fmt::Display for ExactRun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:e}", self.method, self.tolerance)
    }
}

/// Differences of statistics alone.
fn statistics<S: Serializer>(errors: &Errors, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map([
        ("displacement_relative", errors.statistics),
        ("force_relative", errors.force_statistics),
    ])
}

/// The truth.
#[derive(Debug, Clone)]
pub(super) struct Reference {
    pub truth: Truth,
    pub agreement: Agreement,
}

/// A method taken as far as time allows.
struct Taken {
    /// The tightest.
    run: ExactRun,
    best: Trial,
    /// The looser ones, their statistics alone.
    others: Vec<Trial>,
}

impl Reference {
    /// Runs two methods as exactly as they go within the time that a run may take.
    pub fn find(
        question: &Question<'_>,
        rotor: &Rotor,
        stop: &AtomicBool,
    ) -> Result<Self, AccuracyError> {
        let longest = PATIENCE * question.longest;
        let mut taken = Vec::new();
        let mut failures = Vec::new();
        for method in METHODS {
            if taken.len() == 2 {
                break;
            }
            match take(question.model, method, longest, stop)? {
                Ok(found) => taken.push(found),
                Err(failure) => failures.push(format!("{method}: {failure}")),
            }
        }
        // the first stays the first where both are as tight
        taken.sort_by(|a: &Taken, b| a.run.tolerance.total_cmp(&b.run.tolerance));
        let mut taken = taken.into_iter();
        let (Some(first), Some(second)) = (taken.next(), taken.next()) else {
            return Err(AccuracyError::NoReference {
                failures: failures.join("; "),
            });
        };
        let scale = scale(question.model, rotor, &first.best);
        Ok(Self::from_two(first, second, scale))
    }

    /// The first is the truth, the second tells how far that can be trusted.
    fn from_two(first: Taken, second: Taken, scale: Scale) -> Self {
        let truth = Truth {
            trial: first.best,
            scale,
            norm: Moments::magnitude,
            from: 0.0,
        };
        let uncertainty = truth.errors(&second.best);
        let others = first.others.iter().chain(&second.others);
        let scatter = others
            .clone()
            .map(|other| truth.errors(other))
            .fold(uncertainty, |widest, other| widest.widest(&other));
        let growth = truth.trial.trace.growth(&second.best.trace, PARTS);
        Self {
            agreement: Agreement {
                reference: first.run,
                other: second.run,
                uncertainty,
                scatter,
                runs: 2 + others.count(),
                growth,
                irregular: !(uncertainty.displacement_relative <= PARTED && growth <= AMPLIFIED),
                scale,
            },
            truth,
        }
    }
}

/// Largest distance of displacements and forces from their means, as far as the tolerance of the scene resolves it.
fn scale(model: &Model, rotor: &Rotor, trial: &Trial) -> Scale {
    let motion = rotor.motion_scale(model.integrator.tolerance);
    let stiffness = &rotor.equilibrium().stiffness;
    let axes = rotor.freedoms().axes().iter();
    let stiffest = axes
        .map(|&axis| stiffness[(axis, axis)] / motion.lever(axis).powi(2))
        .fold(0.0, f64::max);
    let [displacement, force] = trial.trace.excursion();
    Scale {
        displacement: displacement.max(motion.least),
        force: force.max(stiffest * motion.least).max(f64::MIN_POSITIVE),
    }
}

/// The tightest run of a method that stays within a time; why there is none, where there is none.
fn take(
    model: &Model,
    method: Method,
    longest: f64,
    stop: &AtomicBool,
) -> Result<Result<Taken, String>, AccuracyError> {
    let mut taken: Option<Taken> = None;
    for tolerance in TOLERANCES {
        let is_short = |taken: &Taken| NEXT_TAKES * taken.best.seconds <= longest;
        if !taken.as_ref().is_none_or(is_short) {
            break;
        }
        let run = Trial::run(&with(model, method, tolerance), stop);
        let run = unless_stopped(run)?.and_then(|trial| match trial.went_over() {
            true => Err("verner76 went on from it".to_owned()),
            false => Ok(trial),
        });
        match (run, &mut taken) {
            (Ok(best), None) => {
                let method = method.to_string();
                taken = Some(Taken {
                    run: ExactRun { method, tolerance },
                    best,
                    others: Vec::new(),
                });
            }
            (Ok(best), Some(taken)) => {
                let mut looser = std::mem::replace(&mut taken.best, best);
                looser.trace.forget_points();
                taken.others.push(looser);
                taken.run.tolerance = tolerance;
            }
            (Err(failure), None) => return Ok(Err(failure)),
            (Err(_), Some(_)) => break,
        }
    }
    Ok(taken.ok_or_else(|| "not run".to_owned()))
}
