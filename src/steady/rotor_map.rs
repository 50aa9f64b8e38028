//! A rotor over one period of its forcing, as shooting asks for it.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use nalgebra::{DMatrix, DVector};

use super::SteadyError;
use super::periods::Periods;
use crate::integrate::{
    Counters, Grid, IntegrateError, Integration, Prepared, Scaling, Settings, Shifted, States,
    System, linear_variation, variation,
};
use crate::rotor::{HarmonicMotion, MotionScale, Rotor, RotorDefinition};
use crate::shooting::{Circle, Image, MapError, Multipliers, ReturnMap, Slopes, Stability};
use crate::simulate::reference_settings;

/// Largest tolerance of slopes that multipliers rest on, whose signs tell where a branch changes.
const SLOPE_TOLERANCE: f64 = 1e-7;
/// Tolerance of slopes that only a search rests on: each of its corrections leaves about as much of the one before.
const ROUGH_TOLERANCE: f64 = 1e-4;

/// Multipliers that are not measured are taken for as exact as so many tolerances of their slopes.
const MULTIPLIER_FACTOR: f64 = 100.0;

/// Makes the rotor of a value of the parameter; what is wrong with it in words.
pub(super) type Source<'a> = &'a dyn Fn(f64) -> Result<RotorDefinition, String>;

/// How the periods of a map are integrated.
#[derive(Clone, Copy)]
pub(super) struct Solver<'a> {
    pub settings: Settings,
    /// Settings of the slopes by the start.
    pub slopes: Settings,
    pub stop: &'a AtomicBool,
    /// Counts the periods that were integrated.
    pub integrated: &'a AtomicU64,
}

impl<'a> Solver<'a> {
    pub fn new(settings: Settings, stop: &'a AtomicBool, integrated: &'a AtomicU64) -> Self {
        let slopes = Settings {
            tolerance: settings.tolerance.min(SLOPE_TOLERANCE),
            ..settings
        };
        Self {
            settings,
            slopes,
            stop,
            integrated,
        }
    }

    /// Settings for a motion found again to measure errors.
    pub fn reference(self) -> Self {
        Self {
            settings: reference_settings(self.settings),
            slopes: reference_settings(self.slopes),
            ..self
        }
    }
}

/// The map of a rotor over a multiple of the period of its forcing.
#[derive(Clone)]
pub(super) struct RotorMap<'a> {
    pub rotor: Rotor,
    pub periods: Periods,
    /// What zero and one unit of a scaled state are: the state of rest at the present parameter, and the
    /// size of the motion at the first.
    pub unit: Scaling,
    pub solver: Solver<'a>,
    pub scale: MotionScale,
    /// Units of the integration.
    scaling: Scaling,
    /// The motion in closed form, where there is one.
    closed: Option<HarmonicMotion>,
    /// What the latest period has prepared for others.
    prepared: Option<Prepared>,
    pub counters: Counters,
    /// Where the rotor of another parameter comes from, and that of the present one.
    pub source: Option<(Source<'a>, f64)>,
}

impl<'a> RotorMap<'a> {
    pub fn new(rotor: Rotor, periods: Periods, solver: Solver<'a>) -> Self {
        let scale = rotor.motion_scale(0.1 * solver.settings.tolerance);
        let scaling = rotor.scaling(&scale);
        Self {
            unit: scaling.clone(),
            scaling,
            closed: rotor.harmonic_motion(),
            rotor,
            periods,
            solver,
            scale,
            prepared: None,
            counters: Counters::default(),
            source: None,
        }
    }

    /// Scaled states as they are.
    pub fn states(&self, scaled: &DVector<f64>) -> Vec<Vec<f64>> {
        let states = scaled.as_slice().chunks_exact(self.size());
        states.map(|state| self.unit.state(state)).collect()
    }

    /// States scaled, one after the other.
    pub fn scaled(&self, states: &[Vec<f64>]) -> DVector<f64> {
        let scaled = states.iter().flat_map(|state| self.unit.scaled(state));
        DVector::from_vec(scaled.collect())
    }

    /// Takes another size of the motion.
    pub fn rescale(&mut self, scale: MotionScale) {
        self.scale = scale;
        self.scaling = self.rotor.scaling(&self.scale);
        self.unit = self.scaling.clone();
    }

    /// States on a grid from a time on.
    pub fn trajectory(
        &mut self,
        start: f64,
        state: &[f64],
        grid: Grid,
    ) -> Result<States, IntegrateError> {
        if let Some(closed) = &self.closed {
            return Ok(closed_trajectory(closed, start, state, grid));
        }
        let system = Shifted {
            system: &self.rotor,
            start,
        };
        let (scaling, solver) = (self.scaling.clone(), &self.solver);
        let settings = solver.settings;
        let integration = Integration::new(&system, scaling, grid, settings, solver.stop, state);
        let mut integration = integration.prepared_by(self.prepared.take());
        let mut states = States::with_capacity(state.len(), grid.count as usize);
        let result = integration.advance(grid.count as usize, &mut states);
        self.counters.add(&integration.counters());
        self.solver.integrated.fetch_add(1, Ordering::Relaxed);
        result?;
        // what failed leaves steps that are too short, or numbers that are none
        self.prepared = Some(integration.into_prepared());
        Ok(states)
    }

    /// The state a period after a time.
    fn end(&mut self, start: f64, state: &[f64]) -> Result<Vec<f64>, IntegrateError> {
        let grid = Grid {
            interval: self.periods.circle.period,
            count: 2,
        };
        let states = self.trajectory(start, state, grid)?;
        Ok(states
            .last()
            .map_or_else(|| vec![f64::NAN; state.len()], <[f64]>::to_vec))
    }

    /// The state a period after a time with its slopes, scaled.
    fn end_with_slopes(
        &mut self,
        start: f64,
        state: &[f64],
        settings: &Settings,
    ) -> Result<(Vec<f64>, DMatrix<f64>), IntegrateError> {
        let system = Shifted {
            system: &self.rotor,
            start,
        };
        let (solver, period) = (&self.solver, self.periods.circle.period);
        let scaling = &self.scaling;
        let (end, slopes) = if self.rotor.is_linear() {
            let slopes = linear_variation(&system, scaling, period);
            (self.end(start, state)?, slopes)
        } else {
            let (stop, prepared) = (solver.stop, &mut self.prepared);
            let found = variation(&system, scaling, settings, stop, period, state, prepared)?;
            self.counters.add(&found.counters);
            solver.integrated.fetch_add(1, Ordering::Relaxed);
            (found.end, found.slopes)
        };
        let scale = &self.unit.scale;
        let scaled = DMatrix::from_fn(scale.len(), scale.len(), |row, column| {
            slopes[(row, column)] * scale[column] / scale[row]
        });
        Ok((end, scaled))
    }

    /// The state a period after a time, with slopes where they are asked for.
    fn image_of(
        &mut self,
        node: usize,
        state: &[f64],
        slopes: Slopes,
    ) -> Result<(Vec<f64>, Option<DMatrix<f64>>), IntegrateError> {
        let start = self.periods.time(self.periods.circle.strobes[node]);
        let exact = self.solver.slopes;
        if slopes == Slopes::Exact || slopes == Slopes::FirstExact && node == 0 {
            let (end, slopes) = self.end_with_slopes(start, state, &exact)?;
            return Ok((end, Some(slopes)));
        }
        let end = self.end(start, state)?;
        let rough = Settings {
            tolerance: exact.tolerance.max(ROUGH_TOLERANCE),
            ..exact
        };
        let slopes = match slopes == Slopes::All || slopes == Slopes::First && node == 0 {
            true => Some(self.end_with_slopes(start, state, &rough)?.1),
            false => None,
        };
        Ok((end, slopes))
    }

    /// Whether neighbouring motions come closer, as far as the tolerance of the slopes tells.
    pub fn stability(&self, multipliers: &Multipliers, slopes: &[DMatrix<f64>]) -> Stability {
        let tolerance = match self.rotor.is_linear() {
            true => 0.0,
            false => self.solver.slopes.tolerance,
        };
        let error = MULTIPLIER_FACTOR * tolerance + self.multiplier_round_off(slopes);
        multipliers.stability(&vec![error; self.size()])
    }

    /// Round-off of multipliers: what solving for eigenvalues makes of that of the slopes, which are products of as many
    /// slopes of short times as the motion has time constants in a period.
    pub fn multiplier_round_off(&self, slopes: &[DMatrix<f64>]) -> f64 {
        let states = self.rotor.states();
        let mut jacobian = DMatrix::zeros(states, states);
        let scaling = &self.scaling;
        self.rotor
            .linearisation(0.0, &scaling.origin, &mut jacobian);
        scaling.scale_jacobian(&mut jacobian);
        let rates = jacobian.complex_eigenvalues();
        let fastest = rates.iter().map(|rate| rate.norm()).fold(0.0, f64::max);
        let time_constants = self.periods.circle.period * fastest;
        let largest = slopes.iter().map(DMatrix::norm).fold(0.0, f64::max);
        f64::EPSILON * (largest + time_constants)
    }
}

/// States on a grid from a time on: the forced motion, and the departure from it at the start, which goes on as a free
/// vibration.
fn closed_trajectory(closed: &HarmonicMotion, start: f64, state: &[f64], grid: Grid) -> States {
    let mut states = States::with_capacity(state.len(), grid.count as usize);
    let forced = closed.state(start);
    let mut departure = DVector::from_column_slice(state) - DVector::from_vec(forced);
    let over_interval = closed.departure(grid.interval);
    for number in 0..grid.count {
        let mut state = closed.state(start + grid.time(number));
        state
            .iter_mut()
            .zip(&departure)
            .for_each(|(state, departure)| *state += departure);
        states.push(&state);
        departure = &over_interval * departure;
    }
    states
}

impl ReturnMap for RotorMap<'_> {
    fn size(&self) -> usize {
        self.rotor.states()
    }

    fn circle(&self) -> &Circle {
        &self.periods.circle
    }

    fn image(&mut self, states: &DVector<f64>, slopes: Slopes) -> Result<Image, MapError> {
        let mut end = DVector::zeros(states.len());
        let mut found = Vec::new();
        for (node, state) in self.states(states).iter().enumerate() {
            let (reached, own) = self.image_of(node, state, slopes)?;
            found.extend(own);
            let size = reached.len();
            end.as_mut_slice()[size * node..size * (node + 1)]
                .copy_from_slice(&self.unit.scaled(&reached));
        }
        Ok(Image { end, slopes: found })
    }

    fn set(&mut self, parameter: f64) -> Result<(), MapError> {
        let Some((source, present)) = self.source else {
            return Ok(());
        };
        if parameter == present {
            return Ok(());
        }
        let wrong = |error: SteadyError| MapError::Parameter(error.to_string());
        let definition = source(parameter).map_err(MapError::Parameter)?;
        let rotor = Rotor::assemble(&definition).map_err(|error| wrong(error.into()))?;
        self.periods = self.periods.with_rotor(&rotor).map_err(wrong)?;
        self.scale = rotor.motion_scale(0.1 * self.solver.settings.tolerance);
        self.scaling = rotor.scaling(&self.scale);
        self.closed = rotor.harmonic_motion();
        self.prepared = self.prepared.take().map(Prepared::for_another_system);
        self.rotor = rotor;
        // the motion is followed, not the state of rest that it is about
        self.unit.origin.copy_from_slice(&self.scaling.origin);
        self.source = Some((source, parameter));
        Ok(())
    }

    fn half_return(&mut self, states: &DVector<f64>) -> Result<Option<DVector<f64>>, MapError> {
        let Some(half) = self.periods.half() else {
            return Ok(None);
        };
        let whole = std::mem::replace(&mut self.periods, half);
        let image = self.image(states, Slopes::None);
        self.periods = whole;
        Ok(Some(image?.end - states))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::integrate::Method;
    use crate::scenario;

    /// Asks the map of a shipped scenario with rolling cages by a method.
    fn with_map<T>(name: &str, method: Method, ask: impl FnOnce(&mut RotorMap<'_>) -> T) -> T {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
        let scenario = scenario::load(&file.join(name)).expect("a scenario");
        let mut model = scenario.model.expect("a motion");
        model.rotor.cage = crate::rotor::CageMotion::Rolling;
        model.integrator.method = method;
        let (stop, integrated) = (AtomicBool::new(false), AtomicU64::new(0));
        let solver = Solver::new(model.integrator, &stop, &integrated);
        let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
        let periods = Periods::new(&rotor, 1).expect("periods");
        ask(&mut RotorMap::new(rotor, periods, solver))
    }

    /// Balls part in every period, but too seldom for a change of the method within one.
    #[test]
    fn the_choice_of_a_method_goes_on_from_period_to_period() {
        let [open, explicit] = [Method::Auto, Method::Verner76].map(|method| {
            with_map("fan-6205.toml", method, |map| {
                let mut state = map.rotor.start_state();
                for period in 0..30 {
                    let start = f64::from(period) * map.periods.circle.period;
                    state = map.end(start, &state).expect("a motion");
                }
                map.counters.evaluations
            })
        });
        println!("{open} evaluations, {explicit} by the explicit pair");
        assert!(open < explicit + explicit / 4, "{open} {explicit}");
    }

    /// What a period left that broke off would break off the next one.
    #[test]
    fn a_period_that_fails_leaves_nothing_to_the_next() {
        with_map("flexible-spindle-7205c.toml", Method::Exponential, |map| {
            let rest = map.rotor.start_state();
            map.end(0.0, &vec![f64::NAN; rest.len()])
                .expect_err("no motion");
            let end = map.end(0.0, &rest).expect("a motion");
            assert!(end.iter().all(|value| value.is_finite()));
            // and what a good one left serves
            assert!(map.prepared.is_some() && map.end(0.0, &end).is_ok());
        });
    }
}
