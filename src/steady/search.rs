//! The search for a motion that repeats: from rest, and where that fails from later and later.

use nalgebra::{DMatrix, DVector};

use super::SteadyError;
use super::periods::Periods;
use super::rotor_map::RotorMap;
use crate::shooting::{
    Circle, MapError, Multipliers, ReturnMap, Returned, ShootingError, Slopes, Stability, mixed,
    multipliers, solve,
};

/// Periods waited for before the search is tried again.
const WAITS: [u64; 4] = [0, 8, 32, 128];
/// Harmonics of the second frequency at first.
const FIRST_HARMONICS: usize = 2;
/// Most harmonics of the second frequency.
const MOST_HARMONICS: usize = 64;
/// Highest multiple of the period that is sought without being asked for.
const MOST_PERIODS: usize = 8;
/// Periods waited for before such a multiple is sought.
const SUBHARMONIC_WAITS: [usize; 4] = [24, 48, 96, 192];
/// A state nearly repeats that comes this near to an earlier one, relative to how far the states are spread.
const NEARLY: f64 = 0.05;
/// States so many tolerances apart, in sizes of the motion, are one: of a motion of more periods they would be far apart.
const SAME: f64 = 1e3;
/// Distance from a motion that is not stable at which the wait begins, in sizes of the motion.
const PERTURBATION: f64 = 1e-2;

/// A motion that repeats.
#[derive(Clone)]
pub(super) struct Found {
    pub states: DVector<f64>,
    pub slopes: Vec<DMatrix<f64>>,
    pub multipliers: Multipliers,
    /// Distance of the states after a period from those before it, in sizes of the motion.
    pub residual: f64,
    /// Residual before every correction.
    pub history: Vec<f64>,
    /// Periods integrated before the search.
    pub waited: u64,
}

/// A motion that repeats, of which nothing but its states is known.
pub(super) struct Located {
    pub returned: Returned,
    /// Periods integrated before the search.
    waited: u64,
}

/// The motion asked for; where none is, a stable one if there is one. Beside it the multipliers of the
/// motion of a single period, `single`, where that is another one.
pub(super) fn search(
    map: &mut RotorMap<'_>,
    multiple: Option<u32>,
    asked: Periods,
    single: Located,
) -> Result<(Found, Option<Multipliers>), SteadyError> {
    let single = finished(map, single)?;
    let stable = !matches!(
        map.stability(&single.multipliers, &single.slopes),
        Stability::Unstable(_)
    );
    if asked.is_torus() || multiple == Some(1) || (stable && multiple.is_none()) {
        return Ok((single, None));
    }
    // what leaves a motion that is not stable begins near it; where a stable one has another beside it, at rest
    let start = match stable {
        true => DVector::zeros(map.size()),
        false => single.states.clone(),
    };
    let fits = |found: u32| found > 1 && multiple.is_none_or(|asked| asked.is_multiple_of(found));
    if let Some(found) = subharmonic(map, &start)?
        && fits(map.periods.multiple)
    {
        return Ok((found, Some(single.multipliers)));
    }
    map.periods = asked;
    if map.periods.multiple == 1 {
        return Ok((single, None));
    }
    let again = located_from(map, single.states, None)?;
    Ok((finished(map, again)?, Some(single.multipliers)))
}

/// Finds the motion of a map of one frequency or two from rest.
pub(super) fn locate(map: &mut RotorMap<'_>) -> Result<Located, SteadyError> {
    if map.periods.is_torus() {
        map.periods = map.periods.with_harmonics(FIRST_HARMONICS)?;
    }
    let guess = DVector::zeros(map.size() * map.circle().nodes());
    located_from(map, guess, None)
}

/// Finds the motion of a map near a guess, of two frequencies with as many harmonics as it takes; where slopes are known of one
/// state about there, with these first.
pub(super) fn located_from(
    map: &mut RotorMap<'_>,
    guess: DVector<f64>,
    slopes: Option<&DMatrix<f64>>,
) -> Result<Located, SteadyError> {
    let tolerance = map.solver.settings.tolerance;
    let slopes = slopes.map(std::slice::from_ref);
    let near = slopes.map(|slopes| solve(map, guess.clone(), Some(slopes), tolerance));
    let mut located = match near {
        Some(Ok(returned)) => Located {
            returned,
            waited: 0,
        },
        _ => returned_from(map, guess)?,
    };
    while map.periods.is_torus() {
        let sizes = harmonic_sizes(map.circle(), &located.returned.states, map.size());
        let Some(more) = more_harmonics(&sizes, tolerance) else {
            break;
        };
        let rough = SteadyError::Rough {
            harmonics: sizes.len() - 1,
            tail: sizes.last().copied().unwrap_or(f64::NAN),
            tolerance,
        };
        if sizes.len() > MOST_HARMONICS {
            return Err(rough);
        }
        let before = map.periods.circle.clone();
        map.periods = map.periods.with_harmonics(more.min(MOST_HARMONICS))?;
        let at_nodes = before.values_at(&map.circle().angles);
        let guess = mixed(&at_nodes, &located.returned.states, map.size());
        // a curve that is smooth is found at once from one with fewer harmonics
        located.returned = match solve(map, guess, slopes, tolerance) {
            Err(ShootingError::NotFound { .. } | ShootingError::Singular) => return Err(rough),
            found => found?,
        };
    }
    Ok(located)
}

/// States that return, found at once or after a wait.
pub(super) fn returned_from(
    map: &mut RotorMap<'_>,
    mut guess: DVector<f64>,
) -> Result<Located, SteadyError> {
    let tolerance = map.solver.settings.tolerance;
    let mut waited = 0;
    let mut last = ShootingError::Singular;
    for wait in WAITS {
        while waited < wait {
            guess = later(map, &guess)?;
            waited += 1;
        }
        match solve(map, guess.clone(), None, tolerance) {
            Ok(returned) => return Ok(Located { returned, waited }),
            Err(ShootingError::Map(error)) if is_final(&error) => return Err(error.into()),
            Err(error) => last = error,
        }
    }
    Err(SteadyError::NotFound {
        period: map.circle().period,
        waited,
        source: last,
    })
}

/// Whether no other guess can help.
fn is_final(error: &MapError) -> bool {
    use crate::integrate::IntegrateError::{Interrupted, StepLimit, Stiff};
    matches!(
        error,
        MapError::Integrate(Interrupted { .. } | StepLimit { .. } | Stiff { .. })
    )
}

/// The states a period later.
fn later(map: &mut dyn ReturnMap, states: &DVector<f64>) -> Result<DVector<f64>, SteadyError> {
    let end = map.image(states, Slopes::None)?.end;
    Ok(mixed(&map.circle().back(), &end, map.size()))
}

/// Harmonics of a closed curve of states above a tolerance.
pub(super) fn harmonics_above(
    tolerance: f64,
    circle: &Circle,
    states: &DVector<f64>,
    size: usize,
) -> usize {
    let sizes = harmonic_sizes(circle, states, size);
    let last = sizes.iter().rposition(|size| *size > tolerance);
    last.unwrap_or(0)
}

/// Largest component of every harmonic of the closed curve, the mean first.
fn harmonic_sizes(circle: &Circle, states: &DVector<f64>, size: usize) -> Vec<f64> {
    let coefficients = mixed(&circle.coefficients, states, size);
    let largest = |harmonic| {
        let (first, rows) = match harmonic {
            0 => (0, 1),
            k => (2 * k - 1, 2),
        };
        coefficients.rows(size * first, size * rows).amax()
    };
    (0..=circle.harmonics()).map(largest).collect()
}

/// How many harmonics are needed, by how fast they fall; `None` where there are enough.
fn more_harmonics(sizes: &[f64], tolerance: f64) -> Option<usize> {
    let (harmonics, last) = (sizes.len() - 1, *sizes.last()?);
    if last <= tolerance {
        return None;
    }
    let first = sizes[1..].iter().copied().fold(0.0, f64::max);
    let fall = (last / first).ln() / (harmonics - 1) as f64;
    let further = (tolerance / last).ln() / fall;
    let most = 4 * harmonics;
    Some(if further > 0.0 && further.is_finite() {
        (harmonics + further.ceil() as usize).min(most)
    } else {
        most
    })
}

/// With the slopes and multipliers of what was found.
fn finished(map: &mut RotorMap<'_>, located: Located) -> Result<Found, SteadyError> {
    let Located { returned, waited } = located;
    let image = map.image(&returned.states, Slopes::Exact)?;
    let shifted = mixed(&map.circle().shift, &returned.states, map.size());
    Ok(Found {
        residual: (&image.end - shifted).amax(),
        multipliers: multipliers(map.circle(), &image.slopes),
        states: returned.states,
        slopes: image.slopes,
        history: returned.history,
        waited,
    })
}

/// Waits near some states until they nearly repeat after some periods, and finds the motion of that
/// many periods: the map is then that of those; `None` where none is found that is stable.
fn subharmonic(map: &mut RotorMap<'_>, from: &DVector<f64>) -> Result<Option<Found>, SteadyError> {
    let (single, tolerance) = (map.periods.clone(), map.solver.settings.tolerance);
    let mut states = from.add_scalar(PERTURBATION);
    let mut waited = 0;
    for wait in SUBHARMONIC_WAITS {
        let mut visited = Vec::new();
        while waited < wait {
            states = later(map, &states)?;
            waited += 1;
            visited.push(states.clone());
        }
        let Some(periods) = nearly_repeats(&visited) else {
            continue;
        };
        map.periods = single.times(single.multiple * periods as u32);
        match solve(map, states.clone(), None, tolerance) {
            Ok(returned) => {
                let periods = shortest(map, &single, &returned.states, periods)?;
                map.periods = single.times(single.multiple * periods as u32);
                let waited = waited as u64;
                let found = finished(map, Located { returned, waited })?;
                if found.multipliers.is_stable() {
                    return Ok(Some(found));
                }
            }
            Err(ShootingError::Map(error)) if is_final(&error) => return Err(error.into()),
            Err(_) => {}
        }
        map.periods = single.clone();
    }
    Ok(None)
}

/// After how many periods a motion repeats that does so after some: of as many or a part of them. What decays towards a motion of
/// one period may nearly repeat after two, as a free vibration beside it does.
fn shortest(
    map: &mut RotorMap<'_>,
    single: &Periods,
    start: &DVector<f64>,
    periods: usize,
) -> Result<usize, SteadyError> {
    map.periods = single.clone();
    let mut states = start.clone();
    for passed in 1..periods {
        states = later(map, &states)?;
        let apart = (&states - start).amax();
        if periods.is_multiple_of(passed) && apart <= SAME * map.solver.settings.tolerance {
            return Ok(passed);
        }
    }
    Ok(periods)
}

/// After how many periods the last states nearly repeat.
fn nearly_repeats(visited: &[DVector<f64>]) -> Option<usize> {
    let late = &visited[visited.len().saturating_sub(2 * MOST_PERIODS)..];
    let last = late.last()?;
    let spread = late
        .iter()
        .map(|state| (state - last).amax())
        .fold(0.0, f64::max);
    (1..=MOST_PERIODS.min(late.len() - 1)).find(|periods| {
        let pairs = late.iter().zip(late.iter().skip(*periods));
        let change = pairs.map(|(a, b)| (a - b).amax()).fold(0.0, f64::max);
        change < NEARLY * spread || spread == 0.0
    })
}
