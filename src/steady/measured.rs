//! The errors of a steady motion: of its integration, and of the reduction of a shaft that bends.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::SteadyError;
use super::rotor_map::RotorMap;
use super::samples::sampled;
use super::search::{Found, returned_from};
use crate::rotor::Sample;
use crate::shooting::{Multipliers, ReturnMap, ShootingError, Slopes, multipliers, solve};
use crate::simulate::{Model, Reduction, ReductionError, finer_rotor};

/// Distance of the motion from one found again at a tenth of the tolerance, with the round-off that both share.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Measured {
    /// Largest difference of a displacement (tilts times their arm), and the round-off of one, m.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// The same relative to the largest excursion from the static equilibrium.
    pub relative: f64,
    /// Error of every Floquet multiplier, in their order: its distance from that of the motion found again.
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
    let (states, multipliers) = found_again(map, &found.states, &found.slopes)?;
    let reference = sampled(map, &states, model, false)?;
    map.solver = asked;
    let round_off = map.multiplier_round_off(&found.slopes);
    let [apart, excursion] = distance(map, sampled_before, &reference);
    let displacement = apart + map.rotor.displacement_round_off();
    Ok(Measured {
        displacement,
        relative: displacement / excursion,
        multipliers: found.multipliers.distances(&multipliers, round_off),
        reference_tolerance: tolerance,
    })
}

/// The states and multipliers of a motion that is found again with the present settings.
pub(super) fn found_again(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    slopes: &[DMatrix<f64>],
) -> Result<(DVector<f64>, Multipliers), ShootingError> {
    let tolerance = map.solver.settings.tolerance;
    let again = solve(map, states.clone(), Some(slopes), tolerance)?;
    let slopes = map.image(&again.states, Slopes::All)?.slopes;
    Ok((again.states, multipliers(map.circle(), &slopes)))
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
    let guess = map.states(&found.states).into_iter().flat_map(|state| {
        let alike = finer.rotor.state_of(&map.rotor, &state);
        finer.unit.scaled(&alike)
    });
    let guess: Vec<f64> = guess.collect();
    let sampled = returned_from(&mut finer, DVector::from_vec(guess))
        .and_then(|(again, _)| sampled(&mut finer, &again.states, model, false));
    map.counters.add(&finer.counters);
    let error = match sampled {
        Err(error) if error.is_interrupted() => return Err(error),
        Err(_) => None,
        Ok(reference) => {
            let [displacement, excursion] = distance(map, sampled_before, &reference);
            Some(ReductionError {
                displacement,
                relative: displacement / excursion,
                modes: finer.rotor.bending_modes().unwrap_or_default(),
            })
        }
    };
    Ok(Some(Reduction { error, ..reduction }))
}

/// The largest difference of a displacement of two motions, and the largest excursion of the second from the static
/// equilibrium, m; tilts count by their arm.
fn distance(map: &RotorMap<'_>, first: &[Vec<Sample>], second: &[Vec<Sample>]) -> [f64; 2] {
    let rest = map.rotor.equilibrium().displacement;
    let (mut apart, mut excursion) = (0.0_f64, map.scale.length);
    for (first, second) in first.iter().flatten().zip(second.iter().flatten()) {
        let both = first.displacement.iter().zip(&second.displacement);
        for (axis, ((first, second), rest)) in both.zip(&rest).enumerate() {
            let lever = map.scale.lever(axis);
            apart = apart.max(lever * (first - second).abs());
            excursion = excursion.max(lever * (second - rest).abs());
        }
    }
    [apart, excursion]
}
