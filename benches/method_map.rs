//! Which method wins where: what each needs to come to an error of 1e-6 of the motion, over the shipped
//! scenarios, hard cases, and speed, preload and damping, and how far the choice on the way is off the best.
//!
//! Half decades of tolerance are run. Evaluations and times are interpolated between the cheapest of them that
//! reaches the error and the one before it; times are the shortest of some bare integrations. `VERBOSE=1` prints every method of every scene
//! of the map, `ONLY=text` measures the scenes alone whose name contains it.

use std::fs;
use std::io;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::integrate::Method;
use jeffcott::rotor::{MotionScale, Rotor, Sample};
use jeffcott::scenario::{self, Format};
use jeffcott::simulate::{BareRun, Model, Monitor, TraceSink, simulate};

const ERROR: f64 = 1e-6;
/// Exponents of the loosest and of the finest tolerance, in half decades.
const TOLERANCES: std::ops::RangeInclusive<i32> = 5..=17;
const EXACT: f64 = 1e-12;
/// Simulated time of a shipped scenario at most, s.
const LONGEST: f64 = 1.0;
/// Steps after which a method is out of the race.
const MOST_STEPS: u64 = 1_000_000;
const SPEEDS: [f64; 6] = [10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0];
const PRELOADS: [f64; 3] = [0.0, 200.0, 2000.0];
const RATIOS: [f64; 3] = [0.002, 0.02, 0.1];
/// Time that the integrations of a scene are repeated over, s each.
const REPEATED: f64 = 0.03;

#[derive(Default)]
struct Trace(Vec<[f64; 5]>);

impl TraceSink for Trace {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.0.push(sample.displacement);
        Ok(())
    }
}

fn with(model: &Model, method: Method, tolerance: f64) -> Model {
    let mut model = model.clone();
    model.integrator.method = method;
    model.integrator.tolerance = tolerance;
    model.integrator.step_limit = MOST_STEPS;
    (model.verify, model.settle, model.spectrum) = (false, 0.0, None);
    model
}

fn trace(model: &Model) -> Option<(Trace, u64)> {
    let (mut trace, stop) = (Trace::default(), AtomicBool::new(false));
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    let run = simulate(model, &mut trace, &mut monitor).ok()?;
    Some((trace, run.counters.evaluations))
}

/// Shortest times of bare integrations, s: all in turn, so that what else the machine does hits all alike.
fn times(models: &[Model]) -> Vec<f64> {
    let runs: Vec<_> = models
        .iter()
        .map(|model| BareRun::new(model).expect("a rotor"))
        .collect();
    let stop = AtomicBool::new(false);
    let mut best = vec![f64::INFINITY; runs.len()];
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < REPEATED * runs.len() as f64 {
        for (run, best) in runs.iter().zip(&mut best) {
            let start = Instant::now();
            run.integrate(&stop).expect("it ran before");
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    best
}

struct Truth {
    trace: Trace,
    scale: MotionScale,
    kept: usize,
    motion: f64,
}

impl Truth {
    /// By Dormand and Prince, and how far Verner is from it.
    fn of(model: &Model) -> Option<(Self, f64)> {
        let rotor = Rotor::assemble(&model.rotor).ok()?;
        let exact = |method| trace(&with(model, method, EXACT)).map(|(trace, _)| trace);
        let other = exact(Method::Verner76)?;
        let mut truth = Self {
            trace: exact(Method::Dop853)?,
            scale: rotor.motion_scale(EXACT),
            kept: rotor.kept(),
            motion: 1.0,
        };
        let place = rotor.equilibrium().displacement;
        truth.motion = truth.error(&Trace(vec![place; truth.trace.0.len()]));
        let uncertain = truth.error(&other);
        Some((truth, uncertain))
    }

    fn error(&self, trace: &Trace) -> f64 {
        let distance = |(a, b): (&[f64; 5], &[f64; 5])| {
            let of = |axis: usize| self.scale.lever(axis) * (a[axis] - b[axis]).abs();
            (0..self.kept).map(of).fold(0.0, f64::max)
        };
        let pairs = trace.0.iter().zip(&self.trace.0);
        pairs.map(distance).fold(0.0, f64::max) / self.motion
    }
}

struct Cost {
    name: String,
    method: Method,
    evaluations: f64,
    seconds: f64,
}

/// A run at a tolerance.
#[derive(Clone, Copy)]
struct Tried {
    tolerance: f64,
    error: f64,
    evaluations: u64,
}

/// The cheapest tolerance by which a method reaches the error, after the one before it; by itself where there is
/// none.
fn cheapest(model: &Model, truth: &Truth, method: Method) -> Option<[Tried; 2]> {
    let (mut before, mut best) = (None::<Tried>, None::<[Tried; 2]>);
    for exponent in TOLERANCES {
        let tolerance = 10.0_f64.powf(-0.5 * f64::from(exponent));
        let Some((trace, evaluations)) = trace(&with(model, method, tolerance)) else {
            break;
        };
        let least = best.map_or(u64::MAX, |[_, best]| best.evaluations);
        if evaluations / 2 > least {
            break;
        }
        let tried = Tried {
            tolerance,
            error: truth.error(&trace),
            evaluations,
        };
        if tried.error <= ERROR && evaluations < least {
            best = Some([before.unwrap_or(tried), tried]);
        }
        before = Some(tried);
    }
    best
}

/// Weight of the tolerance that reaches the error against the one before it, in the logarithm.
fn weight([before, best]: &[Tried; 2]) -> f64 {
    if before.error > ERROR {
        (before.error / ERROR).ln() / (before.error / best.error).ln()
    } else {
        1.0
    }
}

fn between([from, to]: [f64; 2], weight: f64) -> f64 {
    from * (to / from).powf(weight)
}

/// The costs of all methods that reach the error, or why there are none.
fn costs(model: &Model) -> Result<Vec<Cost>, String> {
    let (truth, uncertain) = Truth::of(model).ok_or("no reference")?;
    if uncertain > 0.1 * ERROR {
        return Err(format!("reference uncertain by {uncertain:.0e}"));
    }
    let methods = scenario::methods().iter();
    let found: Vec<_> = methods
        .filter_map(|named| Some((named, cheapest(model, &truth, named.method)?)))
        .collect();
    let models = found
        .iter()
        .flat_map(|(named, pair)| pair.map(|tried| with(model, named.method, tried.tolerance)));
    let times = times(&models.collect::<Vec<_>>());
    let costs = found.iter().zip(times.as_chunks::<2>().0);
    Ok(costs
        .map(|((named, pair), times)| {
            let weight = weight(pair);
            let evaluations = pair.map(|tried| tried.evaluations as f64);
            Cost {
                name: named.name.clone(),
                method: named.method,
                evaluations: between(evaluations, weight),
                seconds: between(*times, weight),
            }
        })
        .collect())
}

fn print(name: &str, costs: &[Cost]) {
    println!("{name}");
    for cost in costs {
        println!(
            "    {:<20} {:>8.0} evaluations {:>9.3} ms",
            cost.name,
            cost.evaluations,
            1e3 * cost.seconds
        );
    }
}

/// The named method of least time, its evaluations, and the ratios of the method left open to it in
/// evaluations and in time.
fn verdict(costs: &[Cost]) -> Option<String> {
    let fixed = || costs.iter().filter(|cost| cost.method != Method::Auto);
    let auto = costs.iter().find(|cost| cost.method == Method::Auto)?;
    let best = fixed().min_by(|a, b| a.seconds.total_cmp(&b.seconds))?;
    Some(format!(
        "{}, {:.0} evaluations, {:.3} ms; auto {:.2} of its evaluations, {:.2} of its time",
        best.name,
        best.evaluations,
        1e3 * best.seconds,
        auto.evaluations / best.evaluations,
        auto.seconds / best.seconds
    ))
}

fn tell(name: &str, model: &Model, verbose: bool) {
    let said = costs(model).map(|costs| {
        if verbose {
            print(name, &costs);
        }
        verdict(&costs).unwrap_or("none reaches the error".to_owned())
    });
    println!("{name}: {}", said.unwrap_or_else(|reason| reason));
}

fn is_wanted(name: &str) -> bool {
    std::env::var("ONLY").map_or(true, |only| name.contains(&only))
}

fn files() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders =
        ["scenarios", "benches/scenes", "benches/scenes/hard"].map(|name| root.join(name));
    let folders = folders.iter();
    let entries = folders.flat_map(|folder| fs::read_dir(folder).expect("a folder"));
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "toml"));
    files.sort();
    for file in files {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let loaded = scenario::load(&file).expect("a scenario");
        let Some(mut model) = loaded.model.filter(|_| is_wanted(&name)) else {
            continue;
        };
        model.duration = model.duration.min(LONGEST);
        tell(&name, &model, true);
    }
}

/// A shaft on a pair of 7205C back to back under its weight.
fn map_scene(speed: f64, preload: f64, ratio: f64) -> Model {
    let duration = (20.0 * std::f64::consts::TAU / speed).clamp(0.1, 2.0);
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"2 um\"\nfreedoms = \"all\"\ngravity = true\n\
         inertia_transverse = \"0.01 kg m^2\"\ninertia_polar = \"0.004 kg m^2\"\n\
         [speed]\nconstant = \"{speed} rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         arrangement = \"back-to-back\"\nspacing = \"60 mm\"\npreload = \"{preload} N\"\n\
         [damping]\nratio = {ratio}\n[time]\nduration = \"{duration} s\"\n\
         [output]\nspectrum = false\nsamples_per_revolution = 64\n"
    );
    let scene = scenario::parse(&text, "map.toml", Format::Toml);
    let scene = scene.unwrap_or_else(|error| panic!("{}", error.render(false)));
    scene.model.expect("a motion")
}

fn map() {
    let verbose = std::env::var_os("VERBOSE").is_some();
    for preload in PRELOADS {
        for ratio in RATIOS {
            for speed in SPEEDS {
                let name = format!("{speed} rad/s, {preload} N, ratio {ratio}");
                if is_wanted(&name) {
                    tell(&name, &map_scene(speed, preload, ratio), verbose);
                }
            }
        }
    }
}

fn main() {
    files();
    map();
}
