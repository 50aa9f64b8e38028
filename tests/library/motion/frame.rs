//! Physics knows no X axis, and no near end of the shaft.

use std::f64::consts::FRAC_PI_2;

use crate::bearing::{Facing, MountedBearing};
use crate::rotor::load::{Harmonic, HarmonicRate};
use crate::rotor::{Damping, Freedoms, Load, LoadKind, RotorDefinition, Sample};

use super::{LAWS, apart, with_law};
use crate::tests::support::{back_to_back_pair, model, rotor, samples, shaft};

/// A load that turns with the shaft, ahead of it by a phase, as an unbalance does, at one end.
fn turning(force: f64, phase: f64) -> [Load; 2] {
    let along = |axis: usize, phase: f64| {
        let mut amplitude = [0.0; 5];
        amplitude[axis] = force;
        Load {
            kind: LoadKind::Harmonic(Harmonic {
                amplitude,
                rate: HarmonicRate::Order(1.0),
                phase,
            }),
            position: 0.02,
        }
    };
    [along(0, phase), along(1, phase - FRAC_PI_2)]
}

/// A pair with all freedoms, unlike at its ends, loaded every way.
fn loaded() -> RotorDefinition {
    let mut bearings = back_to_back_pair();
    bearings[0].first_ball = 0.1;
    bearings[1].first_ball = 0.3;
    bearings[1].position = 0.05;
    RotorDefinition {
        speed: 600.0,
        // proportional to the whole of K: a damper of each axis by itself would know X from Y
        damping: Damping::StiffnessTime(1e-5),
        loads: turned_loads(0.0),
        ..rotor(shaft(Freedoms::All), bearings)
    }
}

/// Its loads, turned about the axis.
fn turned_loads(angle: f64) -> Vec<Load> {
    let constant = turned([120.0, -260.0, 90.0, 0.7, -1.1], angle);
    let mut loads = vec![Load::constant(constant, 0.0)];
    loads.extend(turning(40.0, 0.4 + angle));
    loads
}

fn trace(definition: RotorDefinition) -> Vec<Sample> {
    samples(&model(definition, 0.03, 20_000.0), 0.0)
}

/// x, y and both tilts turned about Z.
fn turned([x, y, z, tilt_x, tilt_y]: [f64; 5], angle: f64) -> [f64; 5] {
    let (sin, cos) = angle.sin_cos();
    [
        x * cos - y * sin,
        x * sin + y * cos,
        z,
        tilt_x * cos - tilt_y * sin,
        tilt_x * sin + tilt_y * cos,
    ]
}

/// Farthest that a trace moves from where it starts, m.
fn reach(samples: &[Sample]) -> f64 {
    let start = samples[0].displacement;
    let distances = samples
        .iter()
        .map(|sample| apart(sample.displacement, start));
    distances.fold(0.0, f64::max)
}

#[test]
fn turning_all_about_the_axis_turns_the_trace() {
    let angle = 0.7;
    for law in LAWS {
        let straight = with_law(loaded(), law);
        let bearings = straight.bearings.iter();
        let turned_bearings = bearings.map(|bearing| MountedBearing {
            first_ball: bearing.first_ball + angle,
            ..bearing.clone()
        });
        let oblique = RotorDefinition {
            bearings: turned_bearings.collect(),
            loads: turned_loads(angle),
            ..straight.clone()
        };
        let (straight, oblique) = (trace(straight), trace(oblique));
        let pairs = straight.iter().zip(&oblique);
        let miss = pairs.fold(0.0, |largest, (a, b)| {
            f64::max(
                largest,
                apart(turned(a.displacement, angle), b.displacement),
            )
        });
        let reach = reach(&straight);
        println!("{law:?}: {miss:e} m of {reach:e} m");
        // errors of steps are weighed by component, so that other steps are taken: ten tolerances
        assert!(miss < 1e-9 * reach, "{law:?}: {miss:e} of {reach:e} m");
    }
}

/// z and both tilts change their signs, and so does the place of everything along the shaft. Nothing
/// else does, so that not even a rounding differs.
#[test]
fn a_mirrored_shaft_moves_as_the_mirror_image_bit_by_bit() {
    let mirrored = |[x, y, z, tilt_x, tilt_y]: [f64; 5]| [x, y, -z, -tilt_x, -tilt_y];
    for law in LAWS {
        let shaft = with_law(loaded(), law);
        let bearings = shaft.bearings.iter();
        let bearings = bearings.map(|bearing| MountedBearing {
            position: -bearing.position,
            facing: match bearing.facing {
                Facing::PlusZ => Facing::MinusZ,
                Facing::MinusZ => Facing::PlusZ,
            },
            ..bearing.clone()
        });
        let loads = shaft.loads.iter().map(|load| match load.as_constant() {
            Some(parts) => Load::constant(mirrored(*parts), -load.position),
            None => Load {
                position: -load.position,
                ..load.clone()
            },
        });
        let image = RotorDefinition {
            bearings: bearings.collect(),
            loads: loads.collect(),
            ..shaft.clone()
        };
        let (shaft, image) = (trace(shaft), trace(image));
        assert!(reach(&shaft) > 1e-8);
        for (sample, image) in shaft.iter().zip(&image) {
            assert_eq!(mirrored(sample.displacement), image.displacement, "{law:?}");
            assert_eq!(
                sample.force_on_shaft.map(mirrored),
                image.force_on_shaft,
                "{law:?}"
            );
        }
    }
}
