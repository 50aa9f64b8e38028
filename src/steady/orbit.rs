//! A motion without its stability: what the search for that of a neighbouring scene begins from.

use super::lines::ranges;
use super::periods::Periods;
use super::rotor_map::{RotorMap, Solver};
use super::samples::Observed;
use super::search::located_from;
use super::solve::NOISE;
use super::{MotionRange, Section, Steady, SteadyError, SteadyLines, SteadyQuestion};
use crate::analysis::Channel;
use crate::rotor::{CageMotion, MotionScale, Rotor};
use crate::shooting::{ReturnMap, mixed};

/// Lines and ranges of a motion, and the states that it repeats from.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Ranges of displacements and forces.
    pub ranges: Vec<MotionRange>,
    /// The spectrum.
    pub lines: SteadyLines,
    multiple: u32,
    section: Section,
}

impl From<Steady> for Orbit {
    fn from(steady: Steady) -> Self {
        Self {
            ranges: steady.ranges,
            lines: steady.lines,
            multiple: steady.multiple,
            section: steady.section,
        }
    }
}

/// Finds the motion of a scene from that of a neighbouring one: two or three corrections, and nothing of its stability.
///
/// # Errors
/// [`SteadyError`] where none is found from there.
pub(crate) fn orbit_near(
    question: &SteadyQuestion<'_>,
    near: &Orbit,
) -> Result<Orbit, SteadyError> {
    let model = question.model;
    let mut rotor = Rotor::assemble(&model.rotor)?;
    let mut periods = match Periods::new(&rotor, near.multiple) {
        Err(SteadyError::Frequencies { .. }) if model.rotor.cage == CageMotion::Operating => {
            let mut model = model.clone();
            model.rotor.cage = CageMotion::Rolling;
            let model = &model;
            return orbit_near(&SteadyQuestion { model, ..*question }, near);
        }
        periods => periods?,
    };
    if model.table {
        rotor.tabulate();
    }
    let Section {
        circle: before,
        states,
        length,
        ..
    } = &near.section;
    if periods.is_torus() {
        periods = periods.with_harmonics(before.harmonics())?;
    }
    let solver = Solver::new(model.integrator, question.stop, question.integrated);
    let mut map = RotorMap::new(rotor, periods, solver);
    map.rescale(MotionScale {
        length: length.max(map.scale.least),
        ..map.scale
    });
    // the states of the neighbour at the phases of the nodes here
    let at_nodes = before.values_at(&map.circle().angles);
    let guess = mixed(&at_nodes, &map.scaled(states), map.size());
    let located = located_from(&mut map, guess)?;
    let found = &located.returned.states;
    let Observed { samples, .. } = Observed::new(&mut map, found, model)?;
    let channels = Channel::of_motion(&model.rotor);
    let noise = NOISE * solver.settings.tolerance;
    Ok(Orbit {
        ranges: ranges(&channels, &map.periods.circle, &samples),
        lines: SteadyLines::from_samples(&map.periods, &channels, &samples, noise),
        multiple: map.periods.multiple,
        section: Section::new(&map, found),
    })
}
