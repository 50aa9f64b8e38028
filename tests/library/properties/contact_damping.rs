//! Damping of the contacts: it takes energy, it pulls at nothing, and stiff or not its motion is one.

use crate::bearing::{ContactDamping, ContactLaw, MountedBearing, Profile, RollerKind};
use crate::integrate::{Method, Settings};
use crate::physics::RaceControl;
use crate::rotor::{CageMotion, Damping, Freedoms, InitialState, RotorDefinition, Sample};
use crate::simulate::Model;

use crate::tests::published::rollers::roller_bearing;
use crate::tests::support::{
    AT_EQUILIBRIUM, assert_near, bearing, literature_bearing, model, mounted, rotor, samples,
    settings, shaft, thrust_rotor,
};

/// A shaft in the middle of three balls' clearance, thrown at ball 0.
fn thrown(loss: f64, speed: f64) -> RotorDefinition {
    let three = literature_bearing(3, [11.9062e-3, 52e-3], 20e-6, 1e10);
    thrown_in(mounted(three), loss, speed)
}

fn thrown_in(bearing: MountedBearing, loss: f64, speed: f64) -> RotorDefinition {
    RotorDefinition {
        cage: CageMotion::Frozen,
        initial: InitialState {
            displacement: [Some(0.0); 5],
            velocity: [Some(speed), Some(0.0), None, None, None],
            ..AT_EQUILIBRIUM
        },
        ..rotor(
            shaft(Freedoms::Radial),
            vec![MountedBearing {
                contact_damping: ContactDamping {
                    inner: loss,
                    outer: loss,
                },
                ..bearing
            }],
        )
    }
}

/// Speed after the first impact.
fn rebound(definition: RotorDefinition, speed: f64) -> f64 {
    let samples = samples(&model(definition, 800e-6 / speed, 4e6 * speed), 0.0);
    let back = samples.iter().position(|sample| sample.velocity[0] < 0.0);
    let free = samples[back.expect("a rebound")..]
        .iter()
        .find(|sample| sample.balls_loaded == Some(0));
    -free.expect("a free flight").velocity[0]
}

/// m v dv/dx = −K x^(3/2) (1 + a v) has the integral u − ln(1 + u), u = a v, which is the same where
/// the contact begins and where it ends; there −1 < u < 0: the damping only brakes, and no race holds a
/// ball that leaves.
fn expected_rebound(a: f64, speed: f64) -> f64 {
    let integral = |u: f64| u - u.ln_1p();
    let begin = integral(a * speed);
    let (mut low, mut high) = (-1.0, 0.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if integral(middle) > begin {
            low = middle;
        } else {
            high = middle;
        }
    }
    -high / a
}

#[test]
fn an_impact_loses_speed_as_hunt_and_crossley_say() {
    let speed = 0.1;
    let rebound = |loss| rebound(thrown(loss, speed), speed);
    for loss in [0.02, 0.2, 5.0, 100.0] {
        // 3/2 α (½² + ½²): both races share the approach
        let expected = expected_rebound(0.75 * loss, speed);
        // a kink in the slope of the force at either end of the contact
        assert_near("rebound", rebound(loss), expected, 1e-6 * speed);
    }
    assert_near("elastic", rebound(0.0), speed, 1e-7 * speed);
    // 1 − e = α_12 v for small speeds
    let lost = 1.0 - rebound(0.02) / speed;
    assert_near("restitution", lost, 0.001, 2e-6);
}

/// The integral of an impact does not know the exponent of the contact.
#[test]
fn an_impact_of_a_roller_loses_speed_as_that_of_a_ball() {
    let speed = 0.1;
    let sizes = (3, 9.0, 13.6, 43.5);
    let three = roller_bearing(RollerKind::Cylindrical, sizes, 0.0, 20.0, Profile::Flat, 30);
    for loss in [0.2, 5.0] {
        let expected = expected_rebound(0.75 * loss, speed);
        let found = rebound(thrown_in(mounted(three), loss, speed), speed);
        assert_near("rebound", found, expected, 1e-6 * speed);
    }
}

/// A decaying motion with contact damping only.
fn decaying(law: ContactLaw, loss: f64) -> RotorDefinition {
    let mut definition = thrust_rotor();
    definition.damping = Damping::Undamped;
    definition.initial.displacement = [Some(2e-7), Some(-1e-7), None, None, None];
    definition.bearings[0].law = law;
    definition.bearings[0].contact_damping = ContactDamping {
        inner: loss,
        outer: loss,
    };
    definition
}

fn excursion(samples: &[Sample]) -> f64 {
    let reach = samples.iter().map(|sample| sample.displacement[0].abs());
    reach.fold(0.0, f64::max)
}

/// Small motions know no difference between a law and its tangent.
#[test]
fn in_small_motions_the_linear_law_is_damped_as_hertz() {
    let mut definition = decaying(ContactLaw::Hertz, 20.0);
    definition.cage = CageMotion::Frozen;
    definition.initial.displacement = [Some(1e-9), Some(-2e-9), None, None, None];
    let hertz = samples(&model(definition.clone(), 0.01, 20_000.0), 0.0);
    definition.bearings[0].law = ContactLaw::Linear;
    let linear = samples(&model(definition, 0.01, 20_000.0), 0.0);
    for (hertz, linear) in hertz.iter().zip(&linear) {
        // second order in a nanometre over the approach of a contact, 10 µm
        assert_near("x", hertz.displacement[0], linear.displacement[0], 1e-12);
    }
    let (early, late) = linear.split_at(20);
    assert!(excursion(&late[100..]) < 0.5 * excursion(early));
}

/// Two methods that have nothing in common but the equations.
#[test]
fn explicit_and_implicit_methods_agree_on_damped_contacts() {
    for law in [ContactLaw::Hertz, ContactLaw::Jones(RaceControl::Outer)] {
        let with = |method, tolerance| Model {
            integrator: Settings {
                method,
                ..settings(tolerance)
            },
            ..model(decaying(law, 5.0), 0.005, 20_000.0)
        };
        let explicit = samples(&with(Method::Dop853, 1e-11), 0.0);
        let implicit = samples(&with(Method::Rodas, 1e-8), 0.0);
        let reach = excursion(&explicit);
        for (explicit, implicit) in explicit.iter().zip(&implicit) {
            let [expected, found] = [explicit, implicit].map(|sample| sample.displacement[0]);
            assert_near("x", found, expected, 1e-6 * reach);
        }
    }
}

/// 1.5 α Q (∂δ/∂q)² summed over the balls, over the mass: 1e6 1/s and more, where explicit steps are
/// bound to a microsecond, and the implicit method walks as if nothing were stiff.
#[test]
fn contacts_damped_to_a_million_per_second_are_walked_through() {
    let definition = decaying(ContactLaw::Hertz, 5000.0);
    let model = Model {
        integrator: Settings {
            method: Method::Rodas,
            ..settings(1e-6)
        },
        ..model(definition, 0.01, 20_000.0)
    };
    let run = crate::tests::support::simulate_into(
        &model,
        &mut crate::tests::support::Collector::default(),
    )
    .expect("a run");
    assert!(run.counters.steps < 4000, "{:?}", run.counters);
    println!("{:?} {:?}", run.counters, bearing("7205C").geometry.balls());
}
