//! What each method needs to come to an error of 1e-6 of the motion, over the shipped scenarios and hard cases.
//!
//! Half decades of tolerance are run. Evaluations and times are interpolated between the cheapest of them that
//! reaches the error and the one before it; times are the shortest of some bare integrations. `ONLY=text` measures
//! the scenes alone whose name contains it.

use std::fs;
use std::io;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::internals::{BareRun, MotionScale, time};
use jeffcott::scenario::{self, Format};
use jeffcott::simulate::{Model, Monitor, Sample, TraceSink, simulate};
use serde_json::Value;

const ERROR: f64 = 1e-6;
/// Exponents of the loosest and of the finest tolerance, in half decades.
const TOLERANCES: std::ops::RangeInclusive<i32> = 5..=17;
const EXACT: f64 = 1e-12;
/// Simulated time of a shipped scenario at most, s.
const LONGEST: f64 = 1.0;
/// Steps after which a method is out of the race.
const MOST_STEPS: u64 = 1_000_000;
/// Columns of the table.
const METHODS: [&str; 4] = ["auto", "verner76", "exponential", "dop853"];
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

/// A scene without its settle time, and the folder that files named in it stand in.
struct Scene {
    echo: Value,
    /// Its file.
    name: String,
}

impl Scene {
    /// None of a scene without motion.
    fn load(file: &Path) -> Option<Self> {
        let loaded = scenario::load(file).expect("a scenario");
        loaded.model?;
        let mut echo = loaded.echo;
        let written = echo["time"]["duration"].as_str().unwrap_or_default();
        let duration = time(written).expect("a time").min(LONGEST);
        echo["time"] = serde_json::json!({ "duration": format!("{duration} s") });
        echo["output"]["spectrum"] = false.into();
        if let Value::Object(tables) = &mut echo {
            tables.remove("spectrum");
        }
        let name = file.display().to_string();
        Some(Self { echo, name })
    }

    fn with(&self, method: &str, tolerance: f64) -> Model {
        let mut echo = self.echo.clone();
        echo["integrator"] = serde_json::json!({
            "method": method,
            "tolerance": tolerance,
            "step_limit": MOST_STEPS,
            "verify": false,
        });
        let scenario = scenario::parse(&echo.to_string(), &self.name, Format::Json);
        scenario.expect("a scenario").model.expect("a motion")
    }
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
    active: usize,
    motion: f64,
}

impl Truth {
    /// By Dormand and Prince, and how far Verner is from it.
    fn of(scene: &Scene) -> Option<(Self, f64)> {
        let model = scene.with("dop853", EXACT);
        let bare = BareRun::new(&model).ok()?;
        let rotor = bare.rotor();
        let (other, _) = trace(&scene.with("verner76", EXACT))?;
        let mut truth = Self {
            trace: trace(&model)?.0,
            scale: rotor.motion_scale(EXACT),
            active: rotor.freedoms().axes().len(),
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
            (0..self.active).map(of).fold(0.0, f64::max)
        };
        let pairs = trace.0.iter().zip(&self.trace.0);
        pairs.map(distance).fold(0.0, f64::max) / self.motion
    }
}

struct Cost {
    method: &'static str,
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
fn cheapest(scene: &Scene, truth: &Truth, method: &str) -> Option<[Tried; 2]> {
    let (mut before, mut best) = (None::<Tried>, None::<[Tried; 2]>);
    for exponent in TOLERANCES {
        let tolerance = 10.0_f64.powf(-0.5 * f64::from(exponent));
        let Some((trace, evaluations)) = trace(&scene.with(method, tolerance)) else {
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

/// The costs of the methods that reach the error, or why there are none.
fn costs(scene: &Scene) -> Result<Vec<Cost>, String> {
    let (truth, uncertain) = Truth::of(scene).ok_or("no reference")?;
    if uncertain > 0.1 * ERROR {
        return Err(format!("reference uncertain by {uncertain:.0e}"));
    }
    let methods = METHODS.into_iter();
    let found: Vec<_> = methods
        .filter_map(|method| Some((method, cheapest(scene, &truth, method)?)))
        .collect();
    let models = found
        .iter()
        .flat_map(|(method, pair)| pair.map(|tried| scene.with(method, tried.tolerance)));
    let times = times(&models.collect::<Vec<_>>());
    let costs = found.iter().zip(times.as_chunks::<2>().0);
    Ok(costs
        .map(|((method, pair), times)| {
            let weight = weight(pair);
            let evaluations = pair.map(|tried| tried.evaluations as f64);
            Cost {
                method,
                evaluations: between(evaluations, weight),
                seconds: between(*times, weight),
            }
        })
        .collect())
}

/// A row of the table: evaluations and milliseconds by each method.
fn row(name: &str, scene: &Scene) -> String {
    let costs = match costs(scene) {
        Ok(costs) => costs,
        Err(reason) => return format!("| `{name}` | {reason} |"),
    };
    let cell = |method: &str| {
        let cost = costs.iter().find(|cost| cost.method == method);
        cost.map_or("–".to_owned(), |cost| {
            format!("{:.0}, {:.2}", cost.evaluations, 1e3 * cost.seconds)
        })
    };
    format!("| `{name}` | {} |", METHODS.map(cell).join(" | "))
}

fn is_wanted(name: &str) -> bool {
    std::env::var("ONLY").map_or(true, |only| name.contains(&only))
}

fn main() {
    println!("| scene | `auto` | `verner76` | `exponential` | `dop853` |\n|---|---|---|---|---|");
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
        if !is_wanted(&name) {
            continue;
        }
        let Some(scene) = Scene::load(&file) else {
            continue;
        };
        println!("{}", row(&name, &scene));
    }
}
