//! Time of one static equilibrium of five freedoms with its stiffness, law by law.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use jeffcott::bearing::{Bearing, Oil};
use jeffcott::internals::{ContactLaw, MountedBearing, StaticProblem, Support};
use jeffcott::physics::RaceControl;

const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};

fn equilibria(criterion: &mut Criterion) {
    let bearing = Bearing::catalogue("7205C").expect("in the catalogue");
    let laws = [
        ("hertz", ContactLaw::Hertz, None),
        ("hertz with film", ContactLaw::Hertz, Some(OIL)),
        ("jones", ContactLaw::Jones(RaceControl::Outer), None),
        (
            "jones with film",
            ContactLaw::Jones(RaceControl::Outer),
            Some(OIL),
        ),
    ];
    for (name, law, oil) in laws {
        let mounted = MountedBearing {
            law,
            oil,
            ..MountedBearing::new(bearing)
        };
        let supports = [Support::new(&mounted, 1000.0).expect("a support")];
        let problem = StaticProblem {
            supports: &supports,
            load: [0.0, 300.0, 1000.0, 0.5, 0.0],
            free: [true; 5],
            start: [0.0; 5],
            speed: 1000.0,
        };
        let steps = problem.solve().expect("an equilibrium").newton_steps;
        let title = format!("equilibrium and K, five freedoms, {name}, {steps} steps");
        criterion.bench_function(&title, |bencher| {
            bencher.iter(|| black_box(&problem).solve())
        });
    }
}

criterion_group!(benches, equilibria);
criterion_main!(benches);
