//! The bearing is the same again when its cage has turned by 2π/Z.

use std::f64::consts::TAU;

use crate::bearing::{ContactLaw, MountedBearing, Oil};
use crate::rotor::{Damping, Freedoms, Rotor, RotorDefinition};

use super::{LAWS, apart, traces_apart, with_law};
use crate::tests::support::{
    bearing, constant, model, mounted, peak_to_peak, rotor, samples, shaft,
};

/// A 6305 of seven balls, balanced, under a radial load that half of them bear: the ball pass is plain
/// to see.
fn uneven(law: (ContactLaw, Option<Oil>)) -> RotorDefinition {
    let definition = RotorDefinition {
        speed: 300.0,
        damping: Damping::Ratio(0.1),
        loads: constant([100.0, -400.0, 0.0, 0.0, 0.0]),
        ..rotor(shaft(Freedoms::Radial), vec![mounted(bearing("6305"))])
    };
    with_law(definition, law)
}

fn pass(definition: &RotorDefinition) -> f64 {
    let rotor = Rotor::assemble(definition).expect("a rotor");
    TAU / (7.0 * rotor.supports().next().expect("a bearing").cage_ratio() * definition.speed)
}

#[test]
fn a_balanced_shaft_repeats_its_motion_with_every_ball_pass() {
    const PER_PASS: usize = 50;
    for law in LAWS.into_iter().skip(1) {
        let definition = uneven(law);
        let pass = pass(&definition);
        // free motion, at 400 Hz or more, has died to e^(−50)
        let (settled, duration) = (0.2, 0.2 + 6.0 * pass);
        let model = model(definition, duration, PER_PASS as f64 / pass);
        let samples = samples(&model, settled);
        let swing = peak_to_peak(samples.iter().map(|sample| sample.displacement[1]));
        let later = samples.iter().skip(PER_PASS);
        let change = samples.iter().zip(later);
        let change = change.fold(0.0, |largest, (a, b)| {
            f64::max(largest, apart(a.displacement, b.displacement))
        });
        let half = samples.iter().zip(samples.iter().skip(PER_PASS / 2));
        let half = half.fold(0.0, |largest, (a, b)| {
            f64::max(largest, apart(a.displacement, b.displacement))
        });
        println!("{law:?}: {change:e} of {swing:e} m, half a pass {half:e}");
        // the tolerance of 1e-10 of a motion of 1.5e-7 m, added up over a pass, times ten
        // where balls leave and meet the races
        assert!(change < 1e-7 * swing, "{law:?}: {change:e} of {swing:e} m");
        assert!(half > 0.1 * swing, "{law:?}: {half:e} of {swing:e} m");
    }
}

#[test]
fn a_first_ball_one_spacing_further_changes_no_trace() {
    for law in LAWS {
        let definition = uneven(law);
        let mut further = definition.clone();
        further.bearings = vec![MountedBearing {
            first_ball: TAU / 7.0,
            ..definition.bearings[0].clone()
        }];
        let mut between = definition.clone();
        between.bearings = vec![MountedBearing {
            first_ball: 0.5 * TAU / 7.0,
            ..definition.bearings[0].clone()
        }];
        let trace = |definition: RotorDefinition| samples(&model(definition, 0.1, 5000.0), 0.0);
        let first = trace(definition);
        let swing = peak_to_peak(first.iter().map(|sample| sample.displacement[1]));
        let same = traces_apart(&first, &trace(further));
        let other = traces_apart(&first, &trace(between));
        println!("{law:?}: {same:e} m, half a spacing {other:e} m, swing {swing:e} m");
        assert!(same < 1e-7 * other, "{law:?}: {same:e} m");
        assert!(other > 1e-11, "{law:?}: {other:e} m");
    }
}
