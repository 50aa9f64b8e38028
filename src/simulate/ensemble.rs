//! Runs side by side: a few models whose rotors share the steps of one integration.

use std::sync::atomic::AtomicBool;

use nalgebra::Const;

use super::observers::Observers;
use super::reference::{Reference, reference_settings};
use super::tables::TableAudit;
use super::{BLOCK, Model, Monitor, Run, SimulateError, TraceSink, Work, answer, sampling};
use crate::bearing::{CageAngle, ContactLaw, LANES, MountedBearing, Preload};
use crate::integrate::{
    Counters, EnsembleIntegration, Grid, Integration, Linearised, Method, Settings, Square,
    evaluation_price,
};
use crate::rotor::{Damping, MotionScale, Moving, Rotor, RotorEnsemble, check_loose};

/// Number of runs side by side.
pub const SIDE_BY_SIDE: usize = LANES;

/// Cost of a run side by side as a part of its cost by itself, by the same method: measured.
const SIDE_BY_SIDE_COST: f64 = 0.5;

/// Part of the tolerance that steps are held to where balls come and go at every turn, which they step over:
/// errors are then about those of methods whose steps end there. Measured on the 6306 with clearance.
const COMING_AND_GOING: f64 = 0.3;

/// Part of the samples of all runs that must be asked for: what is beyond a run's end is integrated for nothing.
const LEAST_USE: f64 = 0.75;

/// Runs models side by side, each to its own sink: what comes of each is what [`super::simulate`] answers to
/// the tolerance, by Dormand–El-Mikkawy–Prince 8(6) with steps in common.
///
/// None where they do not go side by side, or where any of them fails: then each is to be run by itself, with a
/// sink that has seen nothing. They do where their shafts turn at constant speeds in plain Hertz bearings, under
/// loads without jumps and diagonal damping, with equally many balls, bearings and freedoms, at the same
/// tolerance, and where each leaves the method open and asks for no energies.
pub fn simulate_side_by_side(
    models: &[Model; SIDE_BY_SIDE],
    sinks: [&mut dyn TraceSink; SIDE_BY_SIDE],
    monitor: &mut Monitor<'_>,
) -> Option<[Run; SIDE_BY_SIDE]> {
    let mut settings = settings(models)?;
    let mut rotors = Vec::with_capacity(SIDE_BY_SIDE);
    for model in models {
        rotors.push(Rotor::assemble(&model.rotor).ok()?);
    }
    let rotors: &[Rotor; SIDE_BY_SIDE] = rotors.as_slice().try_into().ok()?;
    if rotors.iter().any(has_unloaded_balls) {
        settings.tolerance *= COMING_AND_GOING;
    }
    // N states of the kept freedoms of each, and M of all
    match rotors[0].kept() {
        2 => run::<4, 5, 16>(models, rotors, settings, sinks, monitor),
        3 => run::<6, 7, 24>(models, rotors, settings, sinks, monitor),
        _ => run::<10, 11, 40>(models, rotors, settings, sinks, monitor),
    }
}

/// Whether a model may be run beside others of its kind: what is certain before its rotor is assembled.
pub fn may_go_side_by_side(model: &Model) -> bool {
    let rotor = &model.rotor;
    let plain = |bearing: &MountedBearing| {
        let springs = matches!(bearing.preload, Preload::Spring(_));
        bearing.law == ContactLaw::Hertz
            && bearing.oil.is_none()
            && bearing.contact_damping.is_none()
            && !springs
    };
    is_open(model)
        && rotor.drive.is_none()
        && rotor.speed_points.is_empty()
        && !matches!(rotor.damping, Damping::StiffnessTime(_))
        && rotor.bearings.iter().all(plain)
}

/// Whether runs like that of a model cost less side by side than by themselves: by the evaluations that one of
/// them has taken by itself and another beside copies of it, at fixed prices, so that the answer is always the
/// same.
pub fn pays_side_by_side(model: &Model, alone: &Run, beside: &Run) -> bool {
    let Ok(rotor) = Rotor::assemble(&model.rotor) else {
        return false;
    };
    let states = 2 * rotor.kept();
    let effort = match states {
        4 => Linearised::<4>::effort(&rotor),
        6 => Linearised::<6>::effort(&rotor),
        _ => Linearised::<10>::effort(&rotor),
    };
    let cost = |method, counters: &Counters| {
        evaluation_price(method, effort, states) * counters.evaluations as f64
    };
    let stretches = alone.method_use.iter().flat_map(|used| &used.stretches);
    let by_itself: f64 = stretches
        .map(|stretch| cost(stretch.method, &stretch.counters))
        .sum();
    SIDE_BY_SIDE_COST * cost(Method::Dprkn8, &beside.counters) < by_itself
}

/// Whether the method is left to the integration, which finds nothing but the motion.
fn is_open(model: &Model) -> bool {
    let method = model.integrator.method;
    matches!(method, Method::Auto | Method::Dprkn8) && !model.energy && !model.table
}

/// Whether any ball bears nothing at the static equilibrium.
fn has_unloaded_balls(rotor: &Rotor) -> bool {
    let (place, speed) = (&rotor.equilibrium().displacement, rotor.speed());
    let mut unloaded = false;
    for support in rotor.supports() {
        support.for_each_contact(place, CageAngle::START, speed, &mut |ball| {
            unloaded |= ball.load_inner <= 0.0;
        });
    }
    unloaded
}

/// Settings of the integration, where the models agree and leave the rest to it.
fn settings(models: &[Model; SIDE_BY_SIDE]) -> Option<Settings> {
    let first = models[0].integrator;
    let agree = |model: &Model| model.integrator == first && is_open(model);
    models.iter().all(agree).then_some(Settings {
        method: Method::Dprkn8,
        ..first
    })
}

/// One of the runs.
struct Lane<'a, const N: usize, const M: usize> {
    model: &'a Model,
    rotor: &'a Rotor,
    grid: Grid,
    scale: MotionScale,
    reference: Option<Reference<'a, Rotor, N, M>>,
    observers: Observers<'a>,
    loose: Vec<String>,
    states: Vec<[f64; N]>,
}

impl<'a, const N: usize, const M: usize> Lane<'a, N, M>
where
    Const<N>: Square,
{
    fn new(
        model: &'a Model,
        rotor: &'a Rotor,
        sink: &'a mut dyn TraceSink,
        stop: &'a AtomicBool,
    ) -> Result<Self, SimulateError> {
        let loose = check_loose(&model.rotor, rotor)?;
        let grid = sampling::grid(model, rotor)?;
        let tolerance = reference_settings(model).tolerance;
        let scale = rotor.motion_scale(tolerance);
        let reference = model.verify.then(|| {
            let scaling = Moving::<N>::scaling(rotor, &scale);
            let (settings, state) = (reference_settings(model), Moving::<N>::start(rotor));
            Reference::new(Integration::new(
                rotor, scaling, grid, settings, stop, &state,
            ))
        });
        Ok(Self {
            model,
            rotor,
            grid,
            scale,
            reference,
            observers: Observers::new(model, rotor, grid, sink, TableAudit::new(Vec::new())),
            loose,
            states: Vec::with_capacity(BLOCK),
        })
    }

    /// Takes the states from sample number `first` on.
    fn take(&mut self, first: u64) -> Result<(), SimulateError> {
        let left = self.grid.count.saturating_sub(first);
        self.states
            .truncate(usize::try_from(left).unwrap_or(usize::MAX));
        if let Some(reference) = &mut self.reference {
            reference.compare(&self.states, self.rotor, &self.scale)?;
        }
        self.observers.take(self.rotor, first, &self.states)
    }

    fn answer(self, counters: Counters) -> Run {
        let (model, scale) = (self.model, &self.scale);
        let reference = self.reference.as_ref();
        let work = Work {
            counters,
            method_use: None,
            stiffness: None,
            samples: self.grid.count,
            measured_error: reference.and_then(|reference| reference.measured(model, scale)),
            error_unknown: reference.and_then(Reference::failure),
        };
        answer(model, self.rotor, work, self.observers, self.loose)
    }
}

fn run<const N: usize, const N1: usize, const M: usize>(
    models: &[Model; SIDE_BY_SIDE],
    rotors: &[Rotor; SIDE_BY_SIDE],
    settings: Settings,
    sinks: [&mut dyn TraceSink; SIDE_BY_SIDE],
    monitor: &mut Monitor<'_>,
) -> Option<[Run; SIDE_BY_SIDE]>
where
    Const<N>: Square,
{
    let stop = monitor.stop;
    let mut lanes = Vec::with_capacity(SIDE_BY_SIDE);
    for ((model, rotor), sink) in models.iter().zip(rotors).zip(sinks) {
        lanes.push(Lane::<N, N1>::new(model, rotor, sink, stop).ok()?);
    }
    let grid = common_grid(&lanes)?;
    // every rotor has the samples of the first in its own unit of time
    let units = std::array::from_fn(|lane| lanes[lane].grid.interval / grid.interval);
    let ensemble = RotorEnsemble::new(rotors.each_ref(), units)?;
    let scaling = ensemble.scaling::<N, M>(&std::array::from_fn(|lane| lanes[lane].scale));
    let start = ensemble.start::<N, M>();
    let mut integration = EnsembleIntegration::<_, M, SIDE_BY_SIDE>::new(
        &ensemble, scaling, grid, settings, stop, &start,
    )
    .ok()?;
    let mut states = Vec::with_capacity(BLOCK);
    while integration.done() < grid.count {
        let first = integration.done();
        states.clear();
        integration.advance(BLOCK, &mut states).ok()?;
        for (number, lane) in lanes.iter_mut().enumerate() {
            let own = states
                .iter()
                .map(|states| ensemble.state_of(number, states));
            lane.states.clear();
            lane.states.extend(own);
            lane.take(first).ok()?;
        }
        (monitor.progress)(integration.done() as f64 / grid.count as f64);
    }
    let counters = integration.counters();
    let runs = lanes.into_iter().map(|lane| lane.answer(counters));
    runs.collect::<Vec<_>>().try_into().ok()
}

/// The grid of the first run, as long as that of the longest, where little of it is beyond their ends.
fn common_grid<const N: usize, const M: usize>(lanes: &[Lane<'_, N, M>]) -> Option<Grid> {
    let counts = || lanes.iter().map(|lane| lane.grid.count as f64);
    let longest = lanes.iter().map(|lane| lane.grid.count).max()?;
    let used = counts().sum::<f64>() / (longest as f64 * lanes.len() as f64);
    (used >= LEAST_USE).then_some(Grid {
        interval: lanes[0].grid.interval,
        count: longest,
    })
}
