//! Time of whole runs: the shipped scenarios, with their measured error, without files.

use std::io;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use criterion::{Criterion, criterion_group, criterion_main};
use jeffcott::integrate::Method;
use jeffcott::rotor::Sample;
use jeffcott::scenario;
use jeffcott::simulate::{Model, Monitor, Run, TraceSink, simulate};

/// Takes samples and forgets them.
struct Nowhere;

impl TraceSink for Nowhere {
    fn sample(&mut self, _sample: &Sample) -> io::Result<()> {
        Ok(())
    }
}

fn run(model: &Model) -> Run {
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_part| {},
    };
    simulate(model, &mut Nowhere, &mut monitor).expect("a shipped scenario runs")
}

fn shipped(criterion: &mut Criterion) {
    for name in [
        "steady-7205c",
        "linear-7205c",
        "balanced-7205c",
        "back-to-back-7205c",
    ] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenarios/{name}.toml"));
        let mut model = scenario::load(&file)
            .expect("a shipped scenario")
            .model
            .expect("a motion");
        for method in [
            Method::Verner76,
            Method::Dop853,
            Method::Tsit5,
            Method::Dopri5,
        ] {
            model.integrator.method = method;
            model.verify = true;
            let error = run(&model)
                .measured_error
                .map_or(f64::NAN, |error| error.relative);
            model.verify = false;
            let title = format!("{name}, {method:?}, error {error:.0e}");
            criterion.bench_function(&title, |bencher| bencher.iter(|| run(&model)));
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = shipped
}
criterion_main!(benches);
