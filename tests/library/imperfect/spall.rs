//! Forces over slots and dents, and when balls pass them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::bearing::{
    Angle, BearingRotation, ContactLaw, Defect, DefectProfile, ImperfectionError, MountedBearing,
    Oil, Preload, Surface, Wave, quarter_turn,
};
use crate::physics::RaceControl;

use super::{STIFFNESS, data_set_6205, fault, support, with_defects};
use crate::tests::support::{assert_near, bearing, mounted};

#[test]
fn the_force_falls_with_the_drop_exactly() {
    // ball 1 at −90° over the middle of a slot, the others unloaded
    let drops = [
        (Surface::Outer, -FRAC_PI_2, 21.0, 7.4540e-6),
        (Surface::Inner, -FRAC_PI_2, 14.0, 4.9998e-6),
        (Surface::Ball(0), 0.0, 14.0, 3.3105e-6),
        (Surface::Ball(0), PI, 14.0, 4.9998e-6),
        (Surface::Ball(4), 0.0, 14.0, 0.0),
    ];
    for (on, angle, thou, drop) in drops {
        let mounted = MountedBearing {
            first_ball: -FRAC_PI_2,
            ..mounted(data_set_6205())
        };
        let support = support(&with_defects(mounted, vec![fault(on, angle, thou)]), 0.0);
        for depth in [20e-6, 9e-6, 5e-6] {
            let place = [0.0, -depth, 0.0, 0.0, 0.0];
            let [_, y, ..] = support.force(&place, &BearingRotation::at_start(0.0));
            // the balls next to it bear by their cosines
            let next = (depth * (TAU / 9.0).cos()).powf(1.5) * (TAU / 9.0).cos()
                + (depth * (2.0 * TAU / 9.0).cos()).powf(1.5) * (2.0 * TAU / 9.0).cos();
            let expected = (depth - drop).max(0.0).powf(1.5) + 2.0 * next;
            let expected = -STIFFNESS * expected;
            assert_near("F_y", y, expected, 1e-5 * expected.abs());
        }
    }
}

#[test]
fn balls_pass_from_entry_to_impact_in_the_known_time() {
    let bearing = data_set_6205();
    let defects = vec![fault(Surface::Outer, -FRAC_PI_2, 21.0)];
    let support = support(&with_defects(mounted(bearing), defects), 0.0);
    let mut angles: Vec<f64> = support
        .passings()
        .iter()
        .map(|passing| {
            passing
                .next_angle(0.0, support.cage_ratio(), 0)
                .expect("a passage")
        })
        .collect();
    angles.sort_by(f64::total_cmp);
    let [entry, impact, exit] = angles[..] else {
        panic!("{angles:?}");
    };
    for (from, to) in [(entry, impact), (impact, exit)] {
        assert_near("τ", 1e6 * (to - from) / super::SPEED, 151.48, 0.005);
    }
}

/// Forces of every law over slots and dents at places of cage and shaft.
#[test]
fn every_law_lets_go_of_a_ball_by_the_drops_of_its_surfaces() {
    const OIL: Oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    let jones = ContactLaw::Jones(RaceControl::Outer);
    for (law, oil) in [
        (ContactLaw::Hertz, None),
        (ContactLaw::Hertz, Some(OIL)),
        (jones, None),
        (jones, Some(OIL)),
    ] {
        let perfect = MountedBearing {
            law,
            oil,
            first_ball: -FRAC_PI_2,
            ..mounted(bearing("7205C"))
        };
        let place = [0.0, -3e-6, 30e-6, 0.0, 0.0];
        let rotation = BearingRotation::at_start(800.0);
        let load = |bearing: &MountedBearing| {
            let balls = support(bearing, 800.0).around(&place, 800.0, None);
            [balls[0].contact.load_outer, balls[1].contact.load_outer]
        };
        let [whole, beside] = load(&perfect);
        let outer = Defect {
            depth: 2e-6,
            profile: DefectProfile::HalfSine,
            ..fault(Surface::Outer, -FRAC_PI_2, 40.0)
        };
        let spalled = with_defects(perfect.clone(), vec![outer]);
        let [over, same] = load(&spalled);
        assert!(
            over < 0.9 * whole && over > 0.5 * whole,
            "{over} of {whole}"
        );
        assert_eq!(same, beside);
        // and the sum over the ring says the same
        let [sound, spalled] =
            [&perfect, &spalled].map(|bearing| support(bearing, 800.0).force(&place, &rotation));
        assert!(sound[1] < spalled[1] && spalled[2] < sound[2]);
    }
}

fn somewhere(angle: f64) -> BearingRotation {
    let cage = 0.4 * angle;
    BearingRotation {
        cage: Angle::new(cage),
        shaft: Angle::new(angle),
        cage_angle: cage,
        cage_speed: 320.0,
        speed: 800.0,
    }
}

#[test]
fn surfaces_exert_the_moment_by_which_the_stored_energy_falls() {
    let [inner, outer, ball] = [Surface::Inner, Surface::Outer, Surface::Ball(3)];
    let defects = vec![
        fault(outer, 0.5, 600.0),
        fault(inner, 2.0, 500.0),
        fault(ball, 1.0, 200.0),
    ];
    let sound = MountedBearing {
        preload: Preload::AxialOffset(20e-6),
        ..mounted(bearing("7205C"))
    };
    let support = support(&with_defects(sound, defects), 800.0);
    let place = [2e-6, -3e-6, 10e-6, 1e-5, -2e-5];
    let mut most = 0.0_f64;
    for part in 0..60 {
        let angle = 0.37 * f64::from(part);
        let energy = |step: f64| support.stored_energy(&place, &somewhere(angle + step));
        let step = 1e-7;
        let by_angle = (energy(step) - energy(-step)) / (2.0 * step);
        let rotation = somewhere(angle);
        let turning: f64 = {
            let force = support.force(&place, &rotation);
            let turned = quarter_turn(&place);
            force.iter().zip(turned).map(|(a, b)| a * b).sum()
        };
        let [moment, damped] = support.surface_moments([&place, &[0.0; 5]], &rotation, 0.4);
        // dU/dψ at a fixed place
        assert_near("M", moment, -by_angle - 0.4 * turning, 1e-6);
        assert_eq!(damped, 0.0);
        most = most.max(moment.abs());
    }
    assert!(most > 0.02, "{most}");
}

#[test]
fn what_is_no_defect_is_refused_with_its_number() {
    let geometry = data_set_6205().geometry;
    let slot = fault(Surface::Outer, 0.0, 7.0);
    let refused = |defect: Defect| defect.check(&geometry).expect_err("a refusal");
    assert!(matches!(
        refused(Defect {
            depth: -1e-6,
            ..slot
        }),
        ImperfectionError::Length { name: "depth", .. }
    ));
    let around = PI * (39.04e-3 + 7.94e-3);
    let too_long = refused(Defect {
        length: 1.001 * around,
        ..slot
    });
    assert!(matches!(too_long, ImperfectionError::TooLong { .. }));
    assert!(matches!(
        refused(fault(Surface::Ball(9), 0.0, 7.0)),
        ImperfectionError::Ball {
            element: "ball",
            number: 9,
            balls: 9
        }
    ));
    assert!(
        Defect {
            length: 0.999 * around,
            ..slot
        }
        .check(&geometry)
        .is_ok()
    );
}

/// A bearing that starts turned is that bearing turned.
#[test]
fn a_turned_bearing_has_the_surfaces_of_one_that_has_turned() {
    let on = [Surface::Outer, Surface::Inner, Surface::Ball(1)];
    let mut mounted = with_defects(
        mounted(data_set_6205()),
        on.map(|on| fault(on, 0.3, 300.0)).to_vec(),
    );
    let wave = Wave {
        order: 7,
        amplitude: 1e-6,
        phase: 0.4,
    };
    mounted.imperfections.waves = on.map(|on| (on, wave)).to_vec();
    let (shaft, cage) = (2.7, 1.1);
    let turned = support(&support(&mounted, 0.0).turned(shaft, cage), 0.0);
    let place = [9e-6, 7e-6, 0.0, 0.0, 0.0];
    let found = turned.force(&place, &BearingRotation::at_start(0.0));
    let rotation = BearingRotation {
        shaft: Angle::new(shaft),
        ..BearingRotation::at_start(0.0).with_cage_at(cage)
    };
    let still = support(&mounted, 0.0);
    let expected = still.force(&place, &rotation);
    let start = still.force(&place, &BearingRotation::at_start(0.0));
    for axis in 0..2 {
        assert_near(
            "force",
            found[axis],
            expected[axis],
            1e-9 * expected[axis].abs(),
        );
        assert!((start[axis] / expected[axis] - 1.0).abs() > 1e-3);
    }
}
