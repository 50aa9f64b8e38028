//! The balls' lines and the support's force say the same.

use crate::bearing::{
    BearingState, CageMotion, ContactLaw, Facing, MountedBearing, Preload, Support,
};

use super::{LAWS, state_at};
use crate::tests::support::{assert_near, bearing, mounted};

/// Force on the rings of the outer contacts: for every law the balls press onto the outer race with
/// what the inner ring presses onto them and their own centrifugal force.
#[test]
fn the_loads_of_the_balls_add_up_to_the_force() {
    let place = [12e-6, -7e-6, 25e-6, 2e-4, -3e-4];
    for (law, oil) in LAWS {
        let definition = MountedBearing {
            law,
            oil,
            first_ball: 0.3,
            ..mounted(bearing("7205C"))
        };
        let state = state_at(&definition, place, 800.0);
        let force = sum(&state, law);
        for (axis, sum) in force.into_iter().enumerate() {
            let scale = state.force[2].abs();
            let name = format!("force {axis} of {law:?}");
            assert_near(&name, sum, state.force[axis], 1e-11 * scale);
        }
    }
}

/// F_a = Q_i sin α_i + T_i cos α_i, F_r = Q_i cos α_i − T_i sin α_i, T_i = λ_i M_g/D.
fn sum(state: &BearingState, law: ContactLaw) -> [f64; 3] {
    let share = match law {
        ContactLaw::Jones(control) => match control {
            crate::physics::RaceControl::Outer => 0.0,
            crate::physics::RaceControl::Inner => 2.0,
            crate::physics::RaceControl::Even => 1.0,
        },
        ContactLaw::Hertz | ContactLaw::Linear => 0.0,
    };
    let mut force = [0.0; 3];
    for ball in &state.balls {
        let (sin, cos) = ball.inner.angle.sin_cos();
        let friction = share * ball.gyroscopic_moment / 7.938e-3;
        let radial = ball.inner.load * cos - friction * sin;
        force[0] += radial * ball.azimuth.cos();
        force[1] += radial * ball.azimuth.sin();
        force[2] += ball.inner.load * sin + friction * cos;
    }
    force
}

#[test]
fn force_and_stiffness_are_those_of_the_support() {
    for (law, oil) in LAWS {
        let definition = MountedBearing {
            law,
            oil,
            ..mounted(bearing("7205C"))
        };
        let support = Support::new(&definition, 600.0).expect("a bearing");
        let place = [5e-6, 3e-6, 20e-6, 0.0, 1e-4];
        let rotation = crate::bearing::BearingRotation::at_start(600.0);
        let tangent = support.tangent(&place, &rotation);
        let state = support.state(&place, 0.0, 600.0, CageMotion::default());
        assert_eq!(state.force, tangent.force);
        assert_eq!(state.stiffness, tangent.stiffness);
        assert_eq!(state.displacement, place);
    }
}

#[test]
fn a_frozen_bearing_shows_the_balls_of_the_hertz_law() {
    let place = [5e-6, 3e-6, 20e-6, 0.0, 1e-4];
    let hertz = mounted(bearing("7205C"));
    let linear = MountedBearing {
        law: ContactLaw::Linear,
        ..hertz.clone()
    };
    let mut support = Support::new(&linear, 0.0).expect("a bearing");
    support.freeze(&[0.0, 0.0, 20e-6, 0.0, 0.0], 0.0);
    let state = support.state(&place, 0.0, 0.0, CageMotion::default());
    assert_eq!(state, state_at(&hertz, place, 0.0));
}

/// A mirrored bearing pushed the way that loads it is in the same state, in its own orientation.
#[test]
fn facing_mirrors_the_state() {
    let plus = mounted(bearing("7205C"));
    let minus = MountedBearing {
        facing: Facing::MinusZ,
        ..plus.clone()
    };
    let [a, b] = [
        state_at(&plus, [1e-6, 0.0, 20e-6, 0.0, 1e-4], 0.0),
        state_at(&minus, [1e-6, 0.0, -20e-6, 0.0, -1e-4], 0.0),
    ];
    assert_eq!(a, b);
}

/// A spring presses the outer ring with its force wherever the shaft is; the state shows it.
#[test]
fn a_spring_preload_is_the_axial_force() {
    let sprung = MountedBearing {
        preload: Preload::Spring(300.0),
        ..mounted(bearing("7205C"))
    };
    let state = state_at(&sprung, [0.0, 0.0, 40e-6, 0.0, 0.0], 0.0);
    assert_near("F_z", state.force[2], 300.0, 1e-9);
    assert_eq!(state.balls_loaded, 12);
}
