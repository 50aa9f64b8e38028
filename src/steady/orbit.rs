//! A motion without its stability: what the search for that of a neighbouring scene begins from.

use nalgebra::{DMatrix, DVector};

use super::lines::ranges;
use super::periods::Periods;
use super::rotor_map::{RotorMap, Solver};
use super::samples::{Observed, peak_warnings};
use super::search::{harmonics_above, located_from};
use super::solve::{NOISE, located_in_scale};
use super::{MotionRange, Section, Steady, SteadyError, SteadyLines, SteadyQuestion};
use crate::analysis::{Channel, Line};
use crate::rotor::{CageMotion, MotionScale, Rotor, check_constraints};
use crate::shooting::{ReturnMap, Slopes, mixed, multipliers};
use crate::simulate::{Model, line_causes};

/// Lines and ranges of a motion, and the states that it repeats from.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Ranges of displacements and forces.
    pub ranges: Vec<MotionRange>,
    /// The spectrum.
    pub lines: SteadyLines,
    /// What can cause the lines.
    pub causes: Vec<Line>,
    multiple: u32,
    section: Section,
    /// Slopes of the first state over a period, scaled, where the search went by these alone.
    slopes: Option<DMatrix<f64>>,
}

impl Orbit {
    fn new(
        map: &RotorMap<'_>,
        model: &Model,
        states: &DVector<f64>,
        observed: &Observed,
        slopes: Option<DMatrix<f64>>,
    ) -> Self {
        let (channels, samples) = (Channel::of_motion(&model.rotor), &observed.samples);
        let noise = NOISE * map.solver.settings.tolerance;
        Self {
            ranges: ranges(&channels, &map.periods.circle, samples),
            lines: SteadyLines::from_samples(&map.periods, &channels, samples, noise),
            causes: line_causes(model, &map.rotor),
            multiple: map.periods.multiple,
            section: Section::new(map, states),
            slopes,
        }
    }

    /// The motion of a model as it was found with its stability.
    pub fn from_steady(steady: Steady, model: &Model) -> Self {
        Self {
            causes: steady.lines.causes(model),
            ranges: steady.ranges,
            lines: steady.lines,
            multiple: steady.multiple,
            section: steady.section,
            slopes: None,
        }
    }
}

/// Multipliers up to this tell beyond doubt that a motion is stable, also where those of one state stand for all.
const PLAINLY_STABLE: f64 = 0.9;

/// The map of a scene over a multiple of its period, and the scene with the cages that the map has.
fn mapped<'a>(
    question: &SteadyQuestion<'a>,
    multiple: u32,
) -> Result<(RotorMap<'a>, Model), SteadyError> {
    let mut model = question.model.clone();
    let mut rotor = Rotor::assemble(&model.rotor)?;
    let periods = match Periods::new(&rotor, multiple) {
        Err(SteadyError::Frequencies { .. }) if model.rotor.cage == CageMotion::Operating => {
            model.rotor.cage = CageMotion::Rolling;
            rotor = Rotor::assemble(&model.rotor)?;
            Periods::new(&rotor, multiple)?
        }
        periods => periods?,
    };
    check_constraints(&model.rotor, &rotor)?;
    if model.table {
        rotor.tabulate();
    }
    let solver = Solver::new(model.integrator, question.stop, question.integrated);
    Ok((RotorMap::new(rotor, periods, solver), model))
}

/// Finds the motion of a single period of a scene by itself; none where it is not plainly stable, so that another one may be
/// what the scene settles to.
///
/// # Errors
/// [`SteadyError`] where none is found.
pub(crate) fn orbit_alone(question: &SteadyQuestion<'_>) -> Result<Option<Orbit>, SteadyError> {
    let (mut map, model) = mapped(question, 1)?;
    let (located, observed) = located_in_scale(&mut map, &model)?;
    peak_warnings(&map, &observed.trajectories)?;
    let slopes = map.image(&located.returned.states, Slopes::FirstExact)?;
    let slopes = slopes.slopes.into_iter().next();
    let of_all = vec![slopes.clone(); map.circle().nodes()];
    let of_all: Option<Vec<_>> = of_all.into_iter().collect();
    let multipliers = of_all.map(|slopes| multipliers(map.circle(), &slopes));
    let is_stable = multipliers.is_some_and(|found| found.largest() < PLAINLY_STABLE);
    Ok(is_stable.then(|| Orbit::new(&map, &model, &located.returned.states, &observed, slopes)))
}

/// Finds the motion of a scene from that of a neighbouring one: two or three corrections, and nothing of its stability.
///
/// # Errors
/// [`SteadyError`] where none is found from there.
pub(crate) fn orbit_near(
    question: &SteadyQuestion<'_>,
    near: &Orbit,
) -> Result<Orbit, SteadyError> {
    let (mut map, model) = mapped(question, near.multiple)?;
    let Section {
        circle: before,
        states,
        length,
        ..
    } = &near.section;
    map.rescale(MotionScale {
        length: length.max(map.scale.least),
        ..map.scale
    });
    let states = map.scaled(states);
    if map.periods.is_torus() {
        let tolerance = map.solver.settings.tolerance;
        let harmonics = harmonics_above(tolerance, before, &states, map.size());
        map.periods = map.periods.with_harmonics(harmonics + 1)?;
    }
    // the states of the neighbour at the phases of the nodes here
    let at_nodes = before.values_at(&map.circle().angles);
    let guess = mixed(&at_nodes, &states, map.size());
    let returned = located_from(&mut map, guess, near.slopes.as_ref())?.returned;
    let observed = Observed::new(&mut map, &returned.states, &model)?;
    let slopes = match &returned.slopes[..] {
        [of_first] => Some(of_first.clone()),
        _ => near.slopes.clone(),
    };
    Ok(Orbit::new(
        &map,
        &model,
        &returned.states,
        &observed,
        slopes,
    ))
}
