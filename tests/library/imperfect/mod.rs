//! Bearings whose surfaces are not perfect.

mod housing;
mod spall;
mod spalled_motion;
mod waviness;

use crate::bearing::{
    Bearing, Defect, DefectProfile, Imperfections, MountedBearing, Support, Surface,
};
use crate::rotor::{Damping, Freedoms, InitialPosition, InitialState, RotorDefinition, Shaft};

use super::support::{constant, literature_bearing, mounted, rotor, shaft};

/// K_n of both races, N/m^1.5.
const STIFFNESS: f64 = 9.2e9;
/// rad/s.
const SPEED: f64 = 1797.0 * std::f64::consts::TAU / 60.0;
/// A thousandth of an inch, m.
const THOU: f64 = 25.4e-6;

/// 6205 of a well-known data set, without clearance.
fn data_set_6205() -> Bearing {
    literature_bearing(9, [7.94e-3, 39.04e-3], 0.0, STIFFNESS)
}

/// A fault of so many thousandths of an inch, 0.011 in deep.
fn fault(on: Surface, angle: f64, thou: f64) -> Defect {
    Defect {
        on,
        angle,
        length: thou * THOU,
        depth: 11.0 * THOU,
        profile: DefectProfile::Edges,
    }
}

fn with_defects(bearing: MountedBearing, defects: Vec<Defect>) -> MountedBearing {
    MountedBearing {
        imperfections: Imperfections {
            defects,
            ..Imperfections::default()
        },
        ..bearing
    }
}

/// That bearing under 1 kg, −200 N and 300 N s/m at 1797 rpm from (0, −5 µm) on at rest.
fn golden(defects: Vec<Defect>) -> RotorDefinition {
    let mut displacement = [None; 5];
    (displacement[0], displacement[1]) = (Some(0.0), Some(-5e-6));
    RotorDefinition {
        speed: SPEED,
        damping: Damping::Coefficients([300.0, 300.0, 0.0, 0.0, 0.0]),
        loads: constant([0.0, -200.0, 0.0, 0.0, 0.0]),
        initial: InitialState {
            from: InitialPosition::Origin,
            displacement,
            velocity: [None; 5],
        },
        ..rotor(
            Shaft {
                mass: 1.0,
                ..shaft(Freedoms::Radial)
            },
            vec![with_defects(mounted(data_set_6205()), defects)],
        )
    }
}

fn support(bearing: &MountedBearing, speed: f64) -> Support {
    Support::new(bearing, speed).expect("a bearing that can be mounted")
}
