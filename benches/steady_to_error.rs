//! What each method needs to come to an error on motion that has settled: evaluations and time over
//! speeds, with three and with five freedoms.
//!
//! A 7205C under 1000 N of thrust, sampled 128 times a revolution as scenarios are by default. The run
//! begins when the start is forgotten; the error is the largest distance from a reference over all
//! samples, relative to the largest excursion from the static equilibrium.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::integrate::{
    Counters, Grid, Integration, Linearised, Method, Scaling, Settings, Square, System,
};
use jeffcott::rotor::{MotionScale, Moving, Rotor};
use jeffcott::scenario::{self, Format};
use nalgebra::{Const, SMatrix};

const METHODS: [Method; 4] = [
    Method::Exponential,
    Method::Verner76,
    Method::Dop853,
    Method::Rodas,
];
const SPEEDS: [f64; 5] = [50.0, 100.0, 200.0, 500.0, 1000.0];
const TARGETS: [f64; 3] = [1e-4, 1e-6, 1e-8];
/// Time after which the start is forgotten, and the time that is measured, s.
const SETTLED: f64 = 0.5;
const DURATION: f64 = 0.5;
const STIFF_DURATION: f64 = 0.2;
const SAMPLES_PER_REVOLUTION: f64 = 128.0;

/// A rotor from a time on.
struct Later {
    rotor: Rotor,
    begin: f64,
}

impl<const N: usize> System<N> for Later {
    fn derivative(&self, time: f64, state: &[f64; N], rate: &mut [f64; N]) {
        self.rotor.derivative(self.begin + time, state, rate);
    }

    fn is_second_order(&self) -> bool {
        true
    }
}

impl<const N: usize> Linearised<N> for Later {
    fn linearisation(&self, time: f64, state: &[f64; N]) -> (SMatrix<f64, N, N>, [f64; N]) {
        self.rotor.linearisation(self.begin + time, state)
    }
}

/// Damping of the contacts that makes eigenvalues beyond −1e6 1/s.
const STIFF: &str = "contact = { inner = \"5000 s/m\", outer = \"5000 s/m\" }";
const LIGHT: &str = "ratio = 0.02";

fn rotor(speed: f64, freedoms: &str, damping: &str) -> Rotor {
    let tilts = if freedoms == "all" {
        "inertia_transverse = \"2e-3 kg m^2\"\ninertia_polar = \"1.5e-3 kg m^2\"\n"
    } else {
        ""
    };
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"10 um\"\nfreedoms = \"{freedoms}\"\ngravity = true\n{tilts}\
         [speed]\nconstant = \"{speed} rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         [damping]\n{damping}\n[[load]]\nconstant = {{ z = \"1000 N\" }}\n[time]\nduration = \"1 s\"\n"
    );
    let scene = scenario::parse(&text, "steady.toml", Format::Toml);
    let model = scene
        .unwrap_or_else(|error| panic!("{}", error.render(false)))
        .model
        .expect("a motion");
    Rotor::assemble(&model.rotor).expect("a rotor")
}

struct Scene<const N: usize> {
    system: Later,
    start: [f64; N],
    grid: Grid,
}

impl<const N: usize> Scene<N>
where
    Const<N>: Square,
{
    fn run<S: Linearised<N>, const M: usize>(
        system: &S,
        rotor: &Rotor,
        grid: Grid,
        settings: Settings,
        start: &[f64; N],
        states: &mut Vec<[f64; N]>,
    ) -> Counters {
        let scale = rotor.motion_scale(settings.tolerance);
        let scaling: Scaling<N> = Moving::<N>::scaling(rotor, &scale);
        let stop = AtomicBool::new(false);
        let mut integration =
            Integration::<_, N, M>::new(system, scaling, grid, settings, &stop, start);
        states.clear();
        while integration.done() < grid.count {
            integration.advance(1024, states).expect("a run");
        }
        integration.counters()
    }

    /// A rotor over a time that begins later, and goes on from where the start is forgotten by then.
    fn new<const M: usize>(rotor: Rotor, begin: f64, duration: f64) -> Self {
        let interval = std::f64::consts::TAU / (rotor.speed() * SAMPLES_PER_REVOLUTION);
        let mut start = Moving::<N>::start(&rotor);
        if begin > 0.0 {
            let grid = Grid {
                interval: begin,
                count: 2,
            };
            let (exact, mut states) = (settings(Method::Dop853, 1e-12), Vec::new());
            Self::run::<_, M>(&rotor, &rotor, grid, exact, &start, &mut states);
            start = states[1];
        }
        Self {
            system: Later { rotor, begin },
            start,
            grid: Grid {
                interval,
                count: (duration / interval) as u64 + 1,
            },
        }
    }

    fn trace<const M: usize>(
        &self,
        method: Method,
        tolerance: f64,
        states: &mut Vec<[f64; N]>,
    ) -> Counters {
        let rotor = &self.system.rotor;
        Self::run::<_, M>(
            &self.system,
            rotor,
            self.grid,
            settings(method, tolerance),
            &self.start,
            states,
        )
    }

    fn distance(&self, scale: &MotionScale, left: &[[f64; N]], right: &[[f64; N]]) -> f64 {
        left.iter()
            .zip(right)
            .flat_map(|(a, b)| (0..N / 2).map(move |k| scale.lever(k) * (a[k] - b[k]).abs()))
            .fold(0.0, f64::max)
    }
}

fn settings(method: Method, tolerance: f64) -> Settings {
    Settings {
        method,
        tolerance,
        step_limit: 100_000_000,
    }
}

struct Measured {
    error: f64,
    seconds: f64,
    work: Counters,
}

/// The cheapest of the runs that reach an error.
fn cheapest(measured: &[Measured], error: f64, cost: impl Fn(&Measured) -> f64) -> f64 {
    let reached = measured.iter().filter(|run| run.error <= error);
    reached.map(cost).fold(f64::INFINITY, f64::min)
}

fn report<const N: usize, const M: usize>(name: &str, scene: &Scene<N>, methods: &[Method])
where
    Const<N>: Square,
{
    let verbose = std::env::var_os("VERBOSE").is_some();
    let scale = scene.system.rotor.motion_scale(1e-13);
    let (mut truth, mut other, mut states) = (Vec::new(), Vec::new(), Vec::new());
    let [exact, close] = if methods.contains(&Method::Dop853) {
        [(Method::Dop853, 1e-13), (Method::Verner76, 1e-13)]
    } else {
        [(Method::Rodas, 1e-11), (Method::Exponential, 1e-11)]
    };
    scene.trace::<M>(exact.0, exact.1, &mut truth);
    scene.trace::<M>(close.0, close.1, &mut other);
    let place = scene.system.rotor.equilibrium().displacement;
    let rest = [std::array::from_fn(
        |i| if i < N / 2 { place[i] } else { 0.0 },
    )];
    let motion = truth
        .iter()
        .map(|state| scene.distance(&scale, &[*state], &rest))
        .fold(0.0, f64::max);
    let uncertain = scene.distance(&scale, &truth, &other) / motion;
    println!(
        "\n{name}, {} samples: motion {motion:.1e} m, reference uncertain by {uncertain:.0e}",
        scene.grid.count
    );
    for &method in methods {
        let mut measured = Vec::new();
        for exponent in 4..=24 {
            let tolerance = 10.0_f64.powf(-0.5 * f64::from(exponent));
            if method == Method::Rodas && tolerance < 1e-8 {
                break;
            }
            let work = scene.trace::<M>(method, tolerance, &mut states);
            let error = scene.distance(&scale, &states, &truth) / motion;
            let mut seconds = f64::INFINITY;
            let begin = Instant::now();
            while begin.elapsed().as_secs_f64() < 0.02 {
                let start = Instant::now();
                scene.trace::<M>(method, tolerance, &mut states);
                seconds = seconds.min(start.elapsed().as_secs_f64());
            }
            if verbose {
                println!(
                    "{:<12} {tolerance:8.1e} error {error:8.1e} e/tol {:8.2} steps {:6} rejected {:5} evaluations {:7} {:8.1} us {:6.1} ns/eval",
                    format!("{method:?}"),
                    error / tolerance,
                    work.steps,
                    work.rejected,
                    work.evaluations,
                    1e6 * seconds,
                    1e9 * seconds / work.evaluations as f64
                );
            }
            measured.push(Measured {
                error,
                seconds,
                work,
            });
        }
        let cells: Vec<String> = TARGETS
            .into_iter()
            .map(|error| {
                let evaluations = cheapest(&measured, error, |run| run.work.evaluations as f64);
                let seconds = cheapest(&measured, error, |run| run.seconds);
                format!("{error:.0e}: {evaluations:6} in {:7.1} us", 1e6 * seconds)
            })
            .collect();
        println!("{:<12} {}", format!("{method:?}"), cells.join("   "));
    }
}

fn main() {
    let only = std::env::var("SPEED").ok();
    let only: Option<f64> = only.and_then(|text| text.parse().ok());
    for speed in SPEEDS {
        if only.is_some_and(|only| only != speed) {
            continue;
        }
        let three = Scene::new::<7>(rotor(speed, "translational", LIGHT), SETTLED, DURATION);
        report::<6, 7>(&format!("{speed} rad/s, 3 freedoms"), &three, &METHODS);
        let five = Scene::new::<11>(rotor(speed, "all", LIGHT), SETTLED, DURATION);
        report::<10, 11>(&format!("{speed} rad/s, 5 freedoms"), &five, &METHODS);
    }
    let stiff = Scene::new::<11>(rotor(1000.0, "all", STIFF), 0.0, STIFF_DURATION);
    let name = "1000 rad/s, 5 freedoms, stiff damping of the contacts, from the start";
    report::<10, 11>(name, &stiff, &[Method::Exponential, Method::Rodas]);
}
