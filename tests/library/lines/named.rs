//! Names of lines in the spectra of scenes.

use std::f64::consts::TAU;

use crate::analysis::{
    BearingFrequencies, LineKind, LineSurfaces, Sources, Window, causes, nearest_cause,
};
use crate::bearing::{Defect, DefectProfile, Imperfections, Support, Surface, Wave};
use crate::rotor::load::{ChainDrive, Sprocket};
use crate::rotor::{Load, LoadKind, Rotor};
use crate::simulate::{Model, Sampling};

use crate::tests::support::{
    assert_near, bearing, model, mounted, settings, thrust_rotor, try_run,
};

/// The balls' lines stand at the simulated cage, which keeps the nominal angle; where a bearing has them
/// whose cage follows the balls is told beside, at the angle that the thrust makes.
#[test]
fn ball_passes_are_told_at_the_nominal_and_at_the_operating_angle() {
    let model = Model {
        spectrum: Some(Window::Rectangular),
        settle: 0.1,
        integrator: settings(1e-8),
        ..model(thrust_rotor(), 0.3, 20_000.0)
    };
    let (run, _) = try_run(&model, 0.0);
    let run = run.expect("a run");
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let support: &Support = &rotor.supports()[0];
    let state = support.state(&rotor.equilibrium().displacement, 500.0);
    let angle = state.balls[0].inner.angle.abs();
    assert!(angle > 15f64.to_radians(), "{angle}");
    let gamma = 7.938 / 38.5 * angle.cos();
    let [nominal, operating] = [run.ball_pass[0], run.operating_ball_pass[0]];
    // FTF = (f/2)(1 − γ), BPFO = Z FTF
    let cage = 0.5 * 500.0 / TAU * (1.0 - gamma);
    assert_near("operating cage", operating.cage, cage, 1e-9 * cage);
    assert_near("operating outer", operating.outer, 12.0 * cage, 1e-8 * cage);
    assert!(
        operating.outer - nominal.outer > 1.0,
        "{operating:?} {nominal:?}"
    );
}

/// A chain shakes the shaft at the teeth's frequency and its multiples.
#[test]
fn the_meshing_of_a_sprocket_is_named() {
    let mut definition = thrust_rotor();
    definition.speed = 100.0;
    definition.loads.push(Load {
        kind: LoadKind::Sprocket(Sprocket::new(&ChainDrive {
            teeth: 17,
            pitch: 12.7e-3,
            span: 0.3,
            force: 200.0,
            direction: 0.3,
            harmonics: 3,
        })),
        position: 0.0,
    });
    let model = Model {
        spectrum: Some(Window::Rectangular),
        settle: 1.0,
        sampling: Sampling::PerRevolution(256),
        integrator: settings(1e-8),
        ..model(definition, 1.0 + 10.2 * TAU / 100.0, 1.0)
    };
    let (run, _) = try_run(&model, 0.0);
    let peaks = run.expect("a run").peaks;
    let meshing = |multiple| {
        let kind = LineKind::Meshing {
            sprocket: 0,
            multiple,
        };
        peaks
            .iter()
            .find(|peak| peak.line.is_some_and(|line| line.kind == kind))
            .map(|peak| peak.frequency)
    };
    // 17 is also a shaft order, which is the simpler name; 34 is beyond those looked for
    let second = meshing(2).expect("a line at twice the meshing frequency");
    assert_near("second harmonic", second, 34.0 * 100.0 / TAU, 1e-6 * second);
    let first = peaks
        .iter()
        .find(|peak| {
            peak.line
                .is_some_and(|line| line.kind == LineKind::ShaftOrder(17))
        })
        .expect("a line at order 17");
    let others = first.others.iter().map(|line| line.kind);
    assert!(
        others
            .clone()
            .any(|kind| matches!(kind, LineKind::Meshing { multiple: 1, .. }))
    );
}

/// Free vibration shows at the damped natural frequency.
#[test]
fn a_natural_frequency_names_its_line_and_says_how_it_whirls() {
    let mut definition = thrust_rotor();
    definition.bearings = vec![mounted(bearing("7205C"))];
    let rotor = Rotor::assemble(&definition).expect("a rotor");
    let modes = rotor.natural_frequencies();
    for mode in &modes {
        let ratio = mode.damped_frequency / mode.frequency;
        let expected = (1.0 - mode.damping_ratio.powi(2)).sqrt();
        assert_near("damped frequency", ratio, expected, 1e-12);
    }
}

/// Under a radial load many multiples of the ball pass stand out: they are named as far as orders of the shaft are.
#[test]
fn multiples_of_the_ball_pass_are_named_up_to_the_twentieth() {
    let pass = bearing("6205").geometry.ball_pass(TAU * 24.6667);
    let lines = causes(&Sources {
        shaft: 24.6667,
        bearings: vec![BearingFrequencies {
            simulated: pass,
            operating: pass,
        }],
        ..Sources::default()
    });
    for multiple in [7, 13, 20] {
        let line = nearest_cause(f64::from(multiple) * pass.outer, 0.5, &lines);
        let name = line.map(|line| line.kind.to_string());
        assert_eq!(name, Some(format!("{multiple}×BPFO")));
    }
}

/// Of 12 balls: waves of orders that no two of them share a frequency by chance.
#[test]
fn lines_of_waves_bear_the_name_of_their_surface_and_order() {
    let pass = bearing("7205C").geometry.ball_pass(TAU * 100.0);
    let own = BearingFrequencies {
        simulated: pass,
        operating: pass,
    };
    let wave = |order| Wave {
        order,
        amplitude: 1e-8,
        phase: 0.0,
    };
    let imperfections = Imperfections {
        waves: vec![
            (Surface::Inner, wave(13)),
            (Surface::Outer, wave(23)),
            (Surface::Outer, wave(24)),
            (Surface::Outer, wave(30)),
            (Surface::Ball(2), wave(4)),
        ],
        ..Imperfections::default()
    };
    let lines = causes(&Sources {
        shaft: 100.0,
        bearings: vec![own, own],
        surfaces: vec![
            LineSurfaces::default(),
            LineSurfaces::new(12, &imperfections),
        ],
        ..Sources::default()
    });
    let name = |frequency: f64| {
        let line = nearest_cause(frequency, 0.1, &lines);
        line.map(|line| line.kind.to_string()).unwrap_or_default()
    };
    assert_eq!(
        name(pass.inner + 100.0),
        "waviness of the inner race of bearing 2, order 13"
    );
    assert_eq!(
        name(2.0 * pass.outer),
        "waviness of the outer race of bearing 2, order 23"
    );
    assert_eq!(
        name(4.0 * pass.spin - pass.cage),
        "waviness of ball 3 of bearing 2, order 4 − 1×cage"
    );
    // 30 waves are no multiple of the balls, nor one beside it
    assert_eq!(name(3.0 * pass.outer), "3×BPFO");
}

/// A dented ball turns as the simulation turns it, at the nominal contact angle; a sound one is not simulated to.
#[test]
fn lines_of_a_dented_ball_stand_where_it_spins() {
    let geometry = bearing("7205C").geometry;
    let simulated = geometry.ball_pass(TAU * 100.0);
    let operating = simulated.with_slip(0.01);
    let defect = Defect {
        on: Surface::Ball(0),
        angle: 0.0,
        length: 1e-4,
        depth: 1e-5,
        profile: DefectProfile::Edges,
    };
    let dented = Imperfections {
        defects: vec![defect],
        ..Imperfections::default()
    };
    for (imperfections, spin) in [
        (&dented, simulated.spin),
        (&Imperfections::default(), operating.spin),
    ] {
        let lines = causes(&Sources {
            shaft: 100.0,
            bearings: vec![BearingFrequencies {
                simulated,
                operating,
            }],
            surfaces: vec![LineSurfaces::new(12, imperfections)],
            ..Sources::default()
        });
        let line = nearest_cause(2.0 * spin, 0.1, &lines).expect("a line");
        assert_eq!(line.kind.to_string(), "2×BSF");
        assert_eq!(line.operating, Some(2.0 * operating.spin));
    }
}
