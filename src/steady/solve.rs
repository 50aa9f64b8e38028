//! The motion of a scene: found, measured and reported.

use super::lines::ranges;
use super::measured::{self, Measured, measured, reduction};
use super::periods::Periods;
use super::rotor_map::{RotorMap, Solver};
use super::samples::{Observed, peak_warnings, trace};
use super::search::{Found, Located, locate, located_from, search};
use super::{Section, Stability, Steady, SteadyError, SteadyLines, SteadyQuestion};
use crate::analysis::Channel;
use crate::rotor::{CageMotion, Rotor, check_constraints};
use crate::simulate::{Model, PROMISE, Reduction, StaticState, assembled_warnings};

/// Lines below this part of the largest, in tolerances, are left out; so are those below the measured error.
pub(super) const NOISE: f64 = 0.1;

/// Warning where cages do not roll as asked for, as `refusal` of the forcing.
pub(super) fn rolling_cages(refusal: &SteadyError) -> String {
    let reason = match refusal {
        SteadyError::RatioChanges => {
            "the parameter changes the ratio of the two frequencies of the forcing"
        }
        _ => "the forcing has more than two independent frequencies",
    };
    format!(
        "the cages of the bearings roll at the angles of their loaded balls, and with them {reason}: here they roll at the \
         free contact angle, as with cage = \"rolling\" in [model]"
    )
}

/// Finds the motion that a scene settles to.
///
/// # Errors
/// [`SteadyError`] where there is none, or none is found.
pub fn steady(question: &SteadyQuestion<'_>) -> Result<Steady, SteadyError> {
    let model = question.model;
    let mut rotor = Rotor::assemble(&model.rotor)?;
    let unconstrained = check_constraints(&model.rotor, &rotor)?;
    let periods = match Periods::new(&rotor, question.multiple.unwrap_or(1)) {
        Err(error @ SteadyError::Frequencies { .. })
            if model.rotor.cage == CageMotion::Operating =>
        {
            return with_rolling_cages(question, error);
        }
        periods => periods?,
    };
    if periods.is_torus() && periods.multiple > 1 {
        return Err(SteadyError::NoPeriod {
            frequencies: periods.frequencies(),
            multiple: periods.multiple,
        });
    }
    if model.table {
        rotor.tabulate();
    }
    let mut answer = answer(question, rotor, periods)?;
    let further = unconstrained.into_iter().chain(answer.warnings);
    answer.warnings = model.rotor.warnings_with(further);
    Ok(answer)
}

/// The motion with cages that roll at the free contact angle, at which bearings of one kind have one ball-pass frequency;
/// `refusal` where that does not help.
fn with_rolling_cages(
    question: &SteadyQuestion<'_>,
    refusal: SteadyError,
) -> Result<Steady, SteadyError> {
    let mut model = question.model.clone();
    model.rotor.cage = CageMotion::Rolling;
    let rolling = SteadyQuestion {
        model: &model,
        ..*question
    };
    let mut steady = match steady(&rolling) {
        Err(SteadyError::Frequencies { .. }) => return Err(refusal),
        found => found?,
    };
    steady.warnings.push(rolling_cages(&refusal));
    Ok(steady)
}

fn answer(
    question: &SteadyQuestion<'_>,
    rotor: Rotor,
    periods: Periods,
) -> Result<Steady, SteadyError> {
    let solver = Solver::new(
        question.model.integrator,
        question.stop,
        question.integrated,
    );
    let mut map = RotorMap::new(rotor, periods.clone(), solver);
    let (located, mut observed) = located_in_scale(&mut map, question.model)?;
    let (found, single_period) = search(&mut map, question.multiple, periods, located)?;
    if single_period.is_some() {
        observed = Observed::new(&mut map, &found.states, question.model)?;
    }
    let Observed {
        trajectories,
        samples,
    } = observed;
    let measured = match question.model.verify {
        true => Some(measured(&mut map, &found, &samples, question.model)?),
        false => None,
    };
    let reduction = reduction(&mut map, &found, &samples, question.model)?;
    let trace = trace(&map, &trajectories, &samples, question.model);
    let channels = Channel::of_motion(&question.model.rotor);
    let error = measured.as_ref().map_or(0.0, |error| error.relative);
    let noise = error.max(NOISE * solver.settings.tolerance);
    let stability = match &measured {
        Some(error) => found.multipliers.stability(&error.multipliers),
        None => map.stability(&found.multipliers, &found.slopes),
    };
    let mut warnings = peak_warnings(&map, &trajectories)?;
    warnings.extend(assembled_warnings(&question.model.rotor, &map.rotor));
    warnings.extend(reduction.as_ref().and_then(Reduction::warning));
    let error = measured.as_ref();
    warnings.extend(self::warnings(
        &found,
        stability,
        error,
        solver.settings.tolerance,
    ));
    Ok(Steady {
        equilibrium: StaticState::from_rotor(&map.rotor),
        period: map.periods.circle.period,
        multiple: map.periods.multiple,
        stability,
        single_period,
        residual: found.residual,
        history: found.history,
        waited: found.waited,
        harmonics: map.periods.circle.harmonics(),
        ranges: ranges(&channels, &map.periods.circle, &samples),
        lines: SteadyLines::from_samples(&map.periods, &channels, &samples, noise),
        trace,
        measured,
        reduction,
        counters: map.counters,
        warnings,
        section: Section::new(&map, &found.states),
        bases: map.periods.bases,
        multipliers: found.multipliers,
    })
}

/// The motion of a single period as it is observed, to a tolerance of its own size.
pub(super) fn located_in_scale(
    map: &mut RotorMap<'_>,
    model: &Model,
) -> Result<(Located, Observed), SteadyError> {
    if !map.periods.is_torus() {
        map.periods = map.periods.times(1);
    }
    let mut located = locate(map)?;
    let mut observed = Observed::new(map, &located.returned.states, model)?;
    // the tolerance is relative to the motion found, not to the one assumed
    if let Some(scale) = map.scale.corrected(measured::size(map, &observed.samples)) {
        let states = map.states(&located.returned.states);
        map.rescale(scale);
        let guess = map.scaled(&states);
        located = located_from(map, guess, None)?;
        observed = Observed::new(map, &located.returned.states, model)?;
    }
    Ok((located, observed))
}

fn warnings(
    found: &Found,
    stability: Stability,
    measured: Option<&Measured>,
    tolerance: f64,
) -> Vec<String> {
    let largest = found.multipliers.largest();
    let left = match stability {
        Stability::Stable => None,
        Stability::Neutral => Some(
            "the motion is neutral: a multiplier of magnitude 1, as without damping; a long run stays on it only where it \
             starts there, as every free vibration beside it lasts"
                .to_owned(),
        ),
        Stability::Unstable(kind) => Some(format!(
            "the motion is not stable: a multiplier of magnitude {largest:.6} ({kind}); a long run leaves it"
        )),
    };
    let missed = measured.filter(|error| error.relative > PROMISE * tolerance);
    let missed = missed.map(|error| {
        format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: the motion rests on contact changes; tighten the tolerance",
            error.relative
        )
    });
    left.into_iter().chain(missed).collect()
}
