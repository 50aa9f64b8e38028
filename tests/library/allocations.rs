//! No allocation in the right-hand side nor per step, and memory that is flat in the duration,
//! seen by an allocator that counts. Counts are kept by thread: tests do not see each other.

// a global allocator is an unsafe trait
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System as SystemAllocator};
use std::cell::Cell;
use std::fs::File;
use std::io;

use crate::analysis::Channel;
use crate::bearing::{BallLoads, BearingRotation};
use crate::integrate::{Method, System};
use crate::report::TraceCsv;
use crate::rotor::load::{
    ChainDrive, Interpolation, Noise, NoiseBand, RandomShocks, Series, SeriesComponent,
    ShockStatistics, Sprocket,
};
use crate::rotor::{Damping, Freedoms, Load, LoadKind, Rotor, RotorDefinition, Sample, SpeedPoint};
use crate::simulate::{EventKind, Model, TraceSink};

use crate::tests::support::{
    back_to_back_pair, bearing, literature_bearing, model, mounted, ring, rotor, settings, shaft,
    simulate_into, thrust_rotor,
};

/// What a thread has allocated.
#[derive(Clone, Copy)]
struct Tally {
    count: u64,
    live: i64,
    peak: i64,
}

thread_local! {
    static TALLY: Cell<Tally> = const { Cell::new(Tally { count: 0, live: 0, peak: 0 }) };
}

struct Counting;

fn account(count: u64, bytes: i64) {
    // a thread that is being torn down has no tally left
    let _ = TALLY.try_with(|tally| {
        let mut now = tally.get();
        now.count += count;
        now.live += bytes;
        now.peak = now.peak.max(now.live);
        tally.set(now);
    });
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        account(1, layout.size() as i64);
        unsafe { SystemAllocator.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        account(0, -(layout.size() as i64));
        unsafe { SystemAllocator.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        account(1, size as i64 - layout.size() as i64);
        unsafe { SystemAllocator.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations and peak of live bytes of a piece of work.
pub(super) fn measured(work: impl FnOnce()) -> (u64, i64) {
    let before = TALLY.get();
    TALLY.set(Tally {
        peak: before.live,
        ..before
    });
    work();
    let after = TALLY.get();
    (after.count - before.count, after.peak - before.live)
}

#[test]
fn the_allocator_counts() {
    let (count, peak) = measured(|| drop(std::hint::black_box(vec![0_u8; 1000])));
    assert_eq!((count, peak), (1, 1000));
}

/// One load of each kind that keeps a list.
fn varying_loads() -> Vec<Load> {
    let peak = [10.0, 0.0, 0.0, 0.0, 0.0];
    let statistics = ShockStatistics {
        peak,
        least: 0.5,
        duration: 1e-3,
        rate: 1000.0,
        seed: 1,
    };
    let drive = ChainDrive {
        teeth: 8,
        pitch: 0.05,
        span: 0.5,
        force: 100.0,
        direction: 0.0,
        harmonics: 8,
    };
    let band = NoiseBand {
        rms: peak,
        low: 10.0,
        high: 100.0,
        lines: 8,
        seed: 1,
    };
    let column = SeriesComponent {
        axis: 1,
        values: vec![0.0, 5.0, 1.0],
    };
    let series = Series::new(
        vec![0.0, 0.01, 0.05],
        vec![column],
        Interpolation::MonotoneCubic,
    );
    let kinds = [
        LoadKind::RandomShocks(RandomShocks::new(&statistics, 0.1)),
        LoadKind::Sprocket(Sprocket::new(&drive)),
        LoadKind::Noise(Noise::new(&band)),
        LoadKind::Series(series.expect("a series")),
    ];
    let load = |kind| Load {
        kind,
        position: 0.01,
    };
    kinds.map(load).into()
}

#[test]
fn the_right_hand_side_allocates_nothing() {
    let pair = RotorDefinition {
        speed: 500.0,
        speed_points: vec![SpeedPoint {
            time: 0.05,
            speed: 600.0,
        }],
        loads: varying_loads(),
        ..rotor(shaft(Freedoms::All), back_to_back_pair())
    };
    let pair = Rotor::assemble(&pair).expect("a rotor");
    let single = Rotor::assemble(&thrust_rotor()).expect("a rotor");
    let (count, _) = measured(|| {
        for step in 0..10_000 {
            let time = f64::from(step) * 1e-5;
            let mut rate = [0.0; 10];
            pair.derivative(time, &[1e-6 * time; 10], &mut rate);
            std::hint::black_box(rate);
            let mut rate = [0.0; 6];
            single.derivative(time, &[1e-6 * time; 6], &mut rate);
            std::hint::black_box(rate);
        }
    });
    assert_eq!(count, 0);
}

#[test]
fn ring_force_stiffness_and_contacts_allocate_nothing() {
    let ring = ring(&bearing("7205C"));
    let mut loads = BallLoads::new(12, true);
    let (count, _) = measured(|| {
        for step in 0..1000 {
            let rotation = BearingRotation::at_start(500.0).with_cage_at(f64::from(step));
            let place = [1e-6; 5];
            std::hint::black_box(ring.force(&place, &rotation));
            std::hint::black_box(ring.force_and_stiffness(&place, &rotation));
            ring.loads(&place, &rotation, &mut loads);
            std::hint::black_box(&loads);
        }
    });
    assert_eq!(count, 0);
}

#[test]
fn sampling_allocates_nothing_after_its_room() {
    let pair = rotor(shaft(Freedoms::All), back_to_back_pair());
    let pair = Rotor::assemble(&pair).expect("a rotor");
    let mut contacts = pair.ball_contacts();
    let (count, _) = measured(|| {
        for step in 0..1000 {
            let time = f64::from(step) * 1e-5;
            std::hint::black_box(pair.sample(time, &[1e-6 * time; 10], &mut contacts));
        }
    });
    assert_eq!(count, 0);
}

/// Takes samples and forgets them.
struct Nowhere;

impl TraceSink for Nowhere {
    fn sample(&mut self, _sample: &Sample) -> io::Result<()> {
        Ok(())
    }
}

/// An unbalanced run of so many samples at a tolerance.
fn unbalanced(samples: u32, tolerance: f64) -> Model {
    let mut definition = thrust_rotor();
    definition.shaft.eccentricity = 1e-6;
    let rate = 10_000.0;
    let mut model = model(definition, (f64::from(samples) - 0.5) / rate, rate);
    model.integrator = settings(tolerance);
    model
}

/// Allocations, peak bytes and steps of a run.
fn run(model: &Model, sink: &mut dyn TraceSink) -> (u64, i64, u64) {
    let mut steps = 0;
    let (count, peak) = measured(|| {
        steps = simulate_into(model, sink).expect("it runs").counters.steps;
    });
    (count, peak, steps)
}

#[test]
fn steps_allocate_nothing() {
    // the methods of the library `ode_solvers` allocate their vectors
    let by_own_steps = |tolerance: f64| {
        let mut model = unbalanced(1024, tolerance);
        model.integrator.method = Method::Verner76;
        run(&model, &mut Nowhere)
    };
    let (few, _, few_steps) = by_own_steps(1e-4);
    let (many, _, many_steps) = by_own_steps(1e-11);
    println!("{few} allocations in {few_steps} steps, {many} in {many_steps}");
    assert!(many_steps > 3 * few_steps);
    // the equilibrium and the plan of the run are the same for both
    assert_eq!(few, many);
}

#[test]
fn memory_is_flat_in_the_duration() {
    let (_, short, _) = run(&unbalanced(4096, 1e-8), &mut Nowhere);
    let (_, long, _) = run(&unbalanced(40_960, 1e-8), &mut Nowhere);
    println!("peak {short} and {long} bytes");
    assert!(
        long as f64 <= 1.2 * short as f64,
        "{short} then {long} bytes"
    );
}

/// A bearing with clearance that chatters under unbalance and weight: events all along.
fn chattering(samples: u32) -> Model {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.mass = 2.0;
    shaft.eccentricity = 5e-4;
    shaft.gravity = true;
    let loose = literature_bearing(8, [12e-3, 50e-3], 10e-6, 8e9);
    let definition = RotorDefinition {
        speed: 300.0,
        damping: Damping::Coefficients([200.0; 5]),
        ..rotor(shaft, vec![mounted(loose)])
    };
    let mut model = model(definition, f64::from(samples) / 1e4, 1e4);
    model.integrator = settings(1e-4);
    model
}

#[test]
fn memory_is_flat_in_the_number_of_events() {
    let measure = |samples| {
        let (model, mut lost) = (chattering(samples), 0);
        let (_, peak) = measured(|| {
            let run = simulate_into(&model, &mut Nowhere).expect("it runs");
            lost = run.bearings[0].events(EventKind::ContactLost).count;
        });
        (lost, peak)
    };
    let ((few, short), (many, long)) = (measure(8192), measure(81_920));
    println!("{few} and {many} losses of contact, peak {short} and {long} bytes");
    assert!(many > 1000 && many > 5 * few);
    assert!(long as f64 <= 1.2 * short as f64);
}

#[test]
fn memory_is_flat_in_the_duration_when_the_trace_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let peak = |samples: u32| {
        let file = File::create(folder.path().join("trace.csv")).expect("a file");
        let mut sink = TraceCsv::new(file, Channel::of_trace().collect()).expect("a header");
        let (_, peak, _) = run(&unbalanced(samples, 1e-8), &mut sink);
        sink.finish().expect("the rest is written");
        peak
    };
    let (short, long) = (peak(4096), peak(40_960));
    println!("peak {short} and {long} bytes");
    assert!(
        long as f64 <= 1.2 * short as f64,
        "{short} then {long} bytes"
    );
}
