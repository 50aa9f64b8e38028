//! The errors of a steady motion: of its integration, and of the reduction of a shaft that bends.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::SteadyError;
use super::rotor_map::RotorMap;
use super::samples::sampled;
use super::search::{Found, returned_from};
use crate::rotor::{MotionScale, Sample};
use crate::shooting::{Multipliers, ReturnMap, ShootingError, Slopes, multipliers, solve_within};
use crate::simulate::{Model, Recorded, Reduction, ReductionError, finer_rotor};

/// A motion is found again within so many square roots of its tolerance.
const FURTHEST: f64 = 10.0;

/// Distance of the motion from one found again at a tenth of the tolerance, with the round-off that both share.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Measured {
    /// Largest difference of a displacement (tilts times their arm), and the round-off of one, m.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// That difference relative to the motion: the largest distance of a displacement from its mean.
    pub relative: f64,
    /// Error of every Floquet multiplier, in their order: its distance from that of the motion found again, in the complex plane.
    pub multipliers: Vec<f64>,
    /// Tolerance of the second search.
    pub reference_tolerance: f64,
}

/// Finds the motion again more exactly, and tells how far apart both are.
pub(super) fn measured(
    map: &mut RotorMap<'_>,
    found: &Found,
    sampled_before: &[Vec<Sample>],
    model: &Model,
) -> Result<Measured, SteadyError> {
    let asked = map.solver;
    map.solver = asked.reference();
    let tolerance = map.solver.settings.tolerance;
    let (states, multipliers) =
        found_again(map, &found.states, &found.slopes, asked.settings.tolerance)?;
    let reference = sampled(map, &states, model, false)?;
    map.solver = asked;
    let round_off = map.multiplier_round_off(&found.slopes);
    let [apart, size] = distance(map, sampled_before, &reference);
    let displacement = apart + map.rotor.displacement_round_off();
    Ok(Measured {
        displacement,
        relative: displacement / size,
        multipliers: found.multipliers.distances(&multipliers, round_off),
        reference_tolerance: tolerance,
    })
}

/// The states and multipliers of a motion that is found again with the present settings, from one that was found to a
/// tolerance, with its slopes: a correction within that leaves about its square.
///
/// Where two motions meet, a residual ε moves the states by some √ε of their size. Corrections far beyond that lead to other
/// motions, or to none.
pub(super) fn found_again(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    slopes: &[DMatrix<f64>],
    tolerance: f64,
) -> Result<(DVector<f64>, Multipliers), ShootingError> {
    let reach = FURTHEST * tolerance.sqrt() * states.amax().max(1.0);
    let again = solve_within(map, states.clone(), Some(slopes), tolerance, reach)?;
    // of a closed curve what the first slopes change by is taken for all
    let first = map.image(&again.states, Slopes::FirstExact)?.slopes;
    let mut changed = slopes.to_vec();
    if let [first] = &first[..] {
        let change = first - &slopes[0];
        changed.iter_mut().for_each(|slopes| *slopes += &change);
    }
    Ok((again.states, multipliers(map.circle(), &changed)))
}

/// What is kept of a shaft that bends; of a verified motion also how far that of a shaft with more modes is from it, where
/// that one is found from it.
pub(super) fn reduction(
    map: &mut RotorMap<'_>,
    found: &Found,
    sampled_before: &[Vec<Sample>],
    model: &Model,
) -> Result<Option<Reduction>, SteadyError> {
    let Some(modes) = map.rotor.bending_modes() else {
        return Ok(None);
    };
    let reduction = Reduction {
        modes,
        degrees_of_freedom: map.rotor.dofs(),
        error: None,
    };
    let Some(finer) = finer_rotor(model, &map.rotor)? else {
        return Ok(Some(reduction));
    };
    let mut finer = RotorMap::new(finer, map.periods.clone(), map.solver);
    finer.rescale(MotionScale {
        length: map.scale.length,
        ..finer.scale
    });
    let states = map.states(&found.states).into_iter();
    let alike = states.map(|state| finer.rotor.state_of(&map.rotor, &state));
    let guess = finer.scaled(&alike.collect::<Vec<_>>());
    let sampled = returned_from(&mut finer, guess)
        .and_then(|again| sampled(&mut finer, &again.returned.states, model, false));
    map.counters.add(&finer.counters);
    let error = match sampled {
        Err(error) if error.is_interrupted() => return Err(error),
        Err(_) => None,
        Ok(reference) => {
            let [displacement, size] = distance(map, sampled_before, &reference);
            Some(ReductionError {
                displacement,
                relative: displacement / size,
                modes: finer.rotor.bending_modes().unwrap_or_default(),
            })
        }
    };
    Ok(Some(Reduction { error, ..reduction }))
}

/// The largest difference of a displacement of two motions, and the size of the second, m; tilts count by their arm.
fn distance(map: &RotorMap<'_>, first: &[Vec<Sample>], second: &[Vec<Sample>]) -> [f64; 2] {
    let mut apart = 0.0_f64;
    for (first, second) in first.iter().flatten().zip(second.iter().flatten()) {
        let both = first.displacement.iter().zip(&second.displacement);
        for (axis, (first, second)) in both.enumerate() {
            apart = apart.max(map.scale.lever(axis) * (first - second).abs());
        }
    }
    [apart, size(map, second).max(map.scale.least)]
}

/// Size of a motion by its samples, m.
pub(super) fn size(map: &RotorMap<'_>, sampled: &[Vec<Sample>]) -> f64 {
    let mut recorded = Recorded::default();
    for sample in sampled.iter().flatten() {
        recorded.take(&sample.displacement);
    }
    recorded.size(&map.scale)
}
