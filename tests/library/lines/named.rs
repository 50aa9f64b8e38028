//! Names of lines in the spectra of scenes.

use std::f64::consts::TAU;

use crate::analysis::{
    BearingFrequencies, LineKind, LineSurfaces, Peak, Sources, Window, causes, nearest_cause,
};
use crate::bearing::{CageMotion, ContactLaw, Defect, DefectProfile, Imperfections, Surface, Wave};
use crate::physics::RaceControl;
use crate::rotor::load::{ChainDrive, Sprocket};
use crate::rotor::{Load, LoadKind, Rotor};
use crate::scenario::{self, Format};
use crate::simulate::{Model, Sampling};

use crate::tests::support::{
    assert_near, bearing, constant, model, mounted, settings, supports, thrust_rotor, try_run,
};

/// A 6205 of class C4, whose free contact angle is 13.7°, under a radial load: its balls touch at 0°.
const RADIAL_6205: &str = r#"
[shaft]
mass = "2 kg"
gravity = true
freedoms = "radial"
[[bearing]]
catalogue = "6205"
clearance_class = "C4"
[[load]]
constant = { y = "-500 N" }
[damping]
ratio = 0.03
[speed]
constant = "1797 rpm"
[time]
duration = "0.4 s"
settle = "0.1 s"
[output]
window = "hann"
samples_per_revolution = 64
[integrator]
tolerance = 1e-6
"#;

/// BPFO = 9/2 (1 − 7.94/39.04) 1797/60 = 107.364 Hz in the spectrum, its names and the numbers of the run.
#[test]
fn the_cage_rolls_at_the_angle_of_the_loaded_balls() {
    let outer = 4.5 * (1.0 - 7.94 / 39.04) * 1797.0 / 60.0;
    let scene = scenario::parse(RADIAL_6205, "c4.toml", Format::Toml).expect("it is good");
    let mut model = scene.model.expect("a motion");
    let run = try_run(&model, 0.0).0.expect("a run");
    assert_near("BPFO", run.ball_pass[0].outer, outer, 1e-3);
    assert_eq!(run.ball_pass, run.nominal_ball_pass);
    let line = run.peaks.iter().find(|peak| named(peak, "BPFO"));
    let peak = line.expect("a line of passing balls");
    assert_near("peak", peak.frequency, outer, 0.05);
    assert_near("name", peak.line.expect("a name").frequency, outer, 1e-3);
    // the free contact angle: cos α0 = 1 − P_d/(2A)
    model.rotor.cage = CageMotion::Rolling;
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let rolling = rotor
        .supports()
        .next()
        .expect("a bearing")
        .ball_pass(model.rotor.speed)
        .outer;
    assert_near("rolling", rolling, 108.469, 1e-3);
    model.rotor.cage = CageMotion::Frozen;
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    assert_eq!(
        rotor
            .supports()
            .next()
            .expect("a bearing")
            .ball_pass(model.rotor.speed)
            .outer,
        0.0
    );
}

fn named(peak: &Peak, name: &str) -> bool {
    peak.line.is_some_and(|line| line.kind.to_string() == name)
}

/// Thrust raises the contact angle of the 7205C from 15° to 19.35927° (independent implementations); with ball inertia the
/// mean of both races counts. Without load the cage keeps the nominal angle.
#[test]
fn the_cage_follows_thrust_under_every_law() {
    let order = |law, thrust: f64, speed| {
        let mut definition = thrust_rotor();
        definition.cage = CageMotion::Operating;
        definition.speed = speed;
        definition.loads = constant([0.0, 0.0, thrust, 0.0, 0.0]);
        definition.bearings[0].law = law;
        let supports = definition.rolling_supports().expect("bearings");
        let rotor = Rotor::assemble(&definition);
        if let Ok(rotor) = rotor {
            let found = rotor.supports().next().expect("a bearing").cage_ratio();
            assert_eq!(found, supports[0].cage_ratio());
        }
        supports[0].ball_pass(TAU).outer
    };
    let expected = |cosine: f64| 6.0 * (1.0 - 7.938 / 38.5 * cosine);
    let loaded = expected(19.35927f64.to_radians().cos());
    for law in [ContactLaw::Linear, ContactLaw::Hertz] {
        assert_near("BPFO", order(law, 1000.0, 500.0), loaded, 1e-7);
        let nominal = expected(15f64.to_radians().cos());
        assert_near("BPFO", order(law, 0.0, 500.0), nominal, 1e-12);
    }
    let angles = [19.45580f64, 19.28689].map(|angle| angle.to_radians().cos());
    let mean = expected(0.5 * (angles[0] + angles[1]));
    let jones = order(ContactLaw::Jones(RaceControl::Outer), 1000.0, 500.0);
    assert_near("BPFO", jones, mean, 1e-7);
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
    // 17 is also a shaft order, but the shaft has no unbalance
    let second = meshing(2).expect("a line at twice the meshing frequency");
    assert_near("second harmonic", second, 34.0 * 100.0 / TAU, 1e-6 * second);
    let first = meshing(1).expect("a line at the meshing frequency");
    assert_near("first", first, 17.0 * 100.0 / TAU, 1e-6 * first);
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
            nominal: pass,
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
        nominal: pass,
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
        surfaces: vec![LineSurfaces::default(), surfaces(&imperfections)],
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

/// Of a 7205C with imperfections.
fn surfaces(imperfections: &Imperfections) -> LineSurfaces {
    let mut mounted = mounted(bearing("7205C"));
    mounted.imperfections = imperfections.clone();
    LineSurfaces::new(&supports(&[mounted])[0])
}

/// A pair under random shocks: perfect balls have no lines, neither has what is random.
const SHAKEN_PAIR: &str = r#"
[shaft]
mass = "5 kg"
freedoms = "translational"
gravity = true
[speed]
constant = "600 rpm"
[[bearing]]
catalogue = "7205C"
arrangement = "back-to-back"
spacing = "60 mm"
preload = "300 N"
[damping]
ratio = 0.03
[[load]]
random_shocks = { peak = { x = "-200 N", y = "-200 N" }, duration = "2 ms", rate = "40 Hz", seed = 7 }
[time]
duration = "0.5 s"
settle = "0.1 s"
[integrator]
tolerance = 1e-6
"#;

#[test]
fn perfect_bearings_under_shocks_by_chance_show_no_balls() {
    let scene = scenario::parse(SHAKEN_PAIR, "shaken.toml", Format::Toml).expect("it is good");
    let model = scene.model.expect("a motion");
    let run = try_run(&model, 0.0).0.expect("a run");
    let names = run.peaks.iter().filter_map(|peak| peak.line);
    let names: Vec<_> = names.map(|line| line.kind.to_string()).collect();
    let own = |name: &String| name.starts_with("natural") || name.ends_with("BPFO");
    assert!(!run.peaks.is_empty() && names.iter().all(own), "{names:?}");
}

/// A dented ball shows where the simulation turns it; a sound one does not show.
#[test]
fn lines_of_a_dented_ball_stand_where_it_spins() {
    let geometry = bearing("7205C").geometry;
    let simulated = geometry.ball_pass(TAU * 100.0);
    let nominal = geometry.ball_pass(TAU * 101.0);
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
    let line = |imperfections: &Imperfections| {
        let lines = causes(&Sources {
            shaft: 100.0,
            bearings: vec![BearingFrequencies { simulated, nominal }],
            surfaces: vec![surfaces(imperfections)],
            ..Sources::default()
        });
        nearest_cause(2.0 * simulated.spin, 0.1, &lines)
    };
    let dent = line(&dented).expect("a line");
    assert_eq!(dent.kind.to_string(), "2×BSF");
    assert_eq!(dent.nominal, Some(2.0 * nominal.spin));
    assert_eq!(line(&Imperfections::default()), None);
}
