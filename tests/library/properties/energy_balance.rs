//! The account of energy closes, whatever the law of the balls and whatever acts.

use crate::bearing::{ContactDamping, ContactLaw, MountedBearing, Oil, Preload};
use crate::physics::RaceControl;
use crate::rotor::load::{Harmonic, HarmonicRate, Load, LoadKind};
use crate::rotor::{CageMotion, Damping, Freedoms, RotorDefinition, SpeedPoint};
use crate::scenario::Scenario;
use crate::simulate::{EnergyReport, Model};

use crate::tests::support::{
    Collector, back_to_back_pair, bearing, constant, model, mounted, rotor, settings, shaft,
    simulate_into,
};

const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};
const OUTER: ContactLaw = ContactLaw::Jones(RaceControl::Outer);
/// Tolerance of the runs; the balance closes to ten times as much.
const TOLERANCE: f64 = 1e-9;

/// Everything at once: unbalance, weight, a harmonic load off the centre, two kinds of damping,
/// rolling cages.
fn busy(bearings: Vec<MountedBearing>) -> RotorDefinition {
    let mut unbalanced = shaft(Freedoms::All);
    unbalanced.eccentricity = 10e-6;
    unbalanced.gravity = true;
    let harmonic = Harmonic {
        amplitude: [50.0, -20.0, 10.0, 0.1, 0.2],
        rate: HarmonicRate::Frequency(130.0),
        phase: 0.3,
    };
    RotorDefinition {
        speed: 800.0,
        damping: Damping::Ratio(0.02),
        loads: vec![
            Load::constant([100.0, -200.0, 50.0, 0.2, -0.1], 0.0),
            Load {
                kind: LoadKind::Harmonic(harmonic),
                position: 0.02,
            },
        ],
        ..rotor(unbalanced, bearings)
    }
}

fn pair(law: ContactLaw, oil: Option<Oil>) -> Vec<MountedBearing> {
    let with_law = |bearing| MountedBearing {
        law,
        oil,
        contact_damping: ContactDamping {
            inner: 0.5,
            outer: 0.3,
        },
        ..bearing
    };
    back_to_back_pair().into_iter().map(with_law).collect()
}

/// The account of a definition over 20 ms.
fn account(definition: RotorDefinition) -> EnergyReport {
    let model = Model {
        energy: true,
        integrator: settings(TOLERANCE),
        ..model(definition, 0.02, 20_000.0)
    };
    let run = simulate_into(&model, &mut Collector::default()).expect("a run");
    run.energy.expect("an account")
}

#[track_caller]
fn assert_closes(words: &str, energy: &EnergyReport) {
    println!("{words}: {energy:?}");
    assert!(
        energy.relative_residual < 10.0 * TOLERANCE,
        "{words}: {:e}",
        energy.relative_residual
    );
    let works = &energy.works;
    assert!(works.viscous > 0.0 && works.contact >= 0.0, "{words}");
}

#[test]
fn energy_closes_to_the_tolerance_under_every_law() {
    let laws = [
        ("linear", ContactLaw::Linear, None, true),
        ("hertz", ContactLaw::Hertz, None, true),
        ("hertz with film", ContactLaw::Hertz, Some(OIL), true),
        ("jones", OUTER, None, false),
        ("jones with film", OUTER, Some(OIL), false),
    ];
    for (words, law, oil, conservative) in laws {
        let energy = account(busy(pair(law, oil)));
        assert_closes(words, &energy);
        assert_eq!(energy.conservative, conservative, "{words}");
        assert!(energy.works.contact > 0.0, "{words}");
    }
}

/// The balls' inertia exchanges energy with the rotation: a part of what the contacts store.
#[test]
fn work_on_bearings_with_ball_inertia_is_not_what_they_store() {
    let energy = account(busy(pair(OUTER, None)));
    let exchanged = (energy.works.bearings - energy.stored_change).abs();
    let stored = energy.stored_change.abs();
    assert!(
        exchanged > 1e-4 * stored && exchanged < stored,
        "{energy:?}"
    );
}

#[test]
fn energy_closes_with_a_floating_ring_and_with_frozen_cages() {
    let floating = MountedBearing {
        preload: Preload::Spring(300.0),
        contact_damping: ContactDamping {
            inner: 0.5,
            outer: 0.3,
        },
        ..mounted(bearing("7205C"))
    };
    let fixed = mounted(bearing("7205C"));
    let mut definition = busy(vec![
        MountedBearing {
            position: -0.03,
            ..floating
        },
        MountedBearing {
            position: 0.03,
            preload: Preload::Force(200.0),
            ..fixed
        },
    ]);
    // light enough for every ball to stay in contact
    definition.shaft.gravity = false;
    definition.shaft.eccentricity = 1e-6;
    definition.loads = constant([20.0, 0.0, 300.0, 0.0, 0.0]);
    definition.initial.velocity = [Some(1e-3), Some(-2e-3), Some(1e-3), Some(0.01), Some(0.02)];
    assert_closes("floating ring", &account(definition.clone()));
    definition.cage = CageMotion::Frozen;
    let energy = account(definition);
    assert_closes("frozen cages", &energy);
    assert_eq!(energy.works.rotation, 0.0);
}

/// A film that grows with the speed lifts the shaft: its energy comes from the rotation.
#[test]
fn energy_closes_in_a_run_up_with_films() {
    let mut definition = busy(pair(ContactLaw::Hertz, Some(OIL)));
    definition.speed_points = vec![SpeedPoint {
        time: 0.015,
        speed: 1200.0,
    }];
    let energy = account(definition);
    assert_closes("run-up", &energy);
    assert!(!energy.conservative);
}

/// Two bearings on a shaft that is rigid or bends, the first of them in a housing or on the ground, a bearing of
/// constant stiffness beside them or none.
fn scene((contact, film): (&str, bool), bends: bool, housed: bool, beside: bool) -> String {
    let shaft = match bends {
        false => {
            "mass = \"6 kg\"\ninertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.01 kg m^2\"\n\
             freedoms = \"all\"\neccentricity = \"4 um\"\ngravity = true"
        }
        true => {
            "gravity = true\nmodes = 1\n[[shaft.section]]\nlength = \"300 mm\"\nouter_diameter = \"40 mm\"\n\
             [[unbalance]]\namount = \"30 g mm\"\nposition = \"120 mm\""
        }
    };
    let places = if bends { [30, 270] } else { [-90, 90] };
    let bearing = |place: i32| {
        format!(
            "[[bearing]]\ncatalogue = \"6205\"\nposition = \"{place} mm\"\n\
             oil = {{ viscosity = \"0.04 Pa s\", pressure_viscosity = \"22 1/GPa\" }}\n"
        )
    };
    let housing = match housed {
        false => "",
        true => {
            "[bearing.housing]\nmass = \"2 kg\"\nstiffness = { x = \"300 N/um\", y = \"400 N/um\", z = \"200 N/um\" }\n"
        }
    };
    let linear = match beside {
        false => "",
        true => {
            "[[element]]\nposition = \"60 mm\"\nlinear = { stiffness = { x = \"50 N/um\", y = \"80 N/um\", z = \"20 N/um\" } }\n"
        }
    };
    format!(
        "[shaft]\n{shaft}\n[speed]\nconstant = \"3000 rpm\"\n{}{housing}{}{linear}\
         [model]\ncontact = \"{contact}\"\nfilm = {film}\n[damping]\nratio = 0.02\n\
         [[load]]\nconstant = {{ x = \"200 N\", y = \"-300 N\", z = \"400 N\" }}\n\
         [time]\nduration = \"4 ms\"\n[integrator]\nverify = false\n\
         [output]\nenergy = true\nspectrum = false\nmotion = false\nsample_rate = \"5 kHz\"\n",
        bearing(places[0]),
        bearing(places[1]),
    )
}

/// The residual is that of the integration, at most a hundred tolerances, whatever stores energy beside the balls: shaft,
/// housing, bearing of constant stiffness.
#[test]
fn energy_closes_in_every_combination_of_what_stores_it() {
    let laws = ["linear", "hertz", "jones"].map(|contact| (contact, false));
    for law in laws.into_iter().chain([("hertz", true), ("jones", true)]) {
        for bits in 0..8 {
            let [bends, housed, beside] = [0, 1, 2].map(|bit| bits >> bit & 1 == 1);
            let scene = scene(law, bends, housed, beside);
            let words = format!("{law:?}, bends {bends}, housing {housed}, linear {beside}");
            let scenario =
                Scenario::from_toml(&scene).unwrap_or_else(|error| panic!("{words}: {error}"));
            let run = scenario.simulate().expect("a run").run;
            let energy = run.energy.expect("an account");
            println!("{words}: {:e}", energy.relative_residual);
            assert!(energy.relative_residual < 1e-6, "{words}: {energy:?}");
            let open = run.warnings.iter().find(|text| text.contains("energy"));
            assert_eq!(open, None, "{words}");
        }
    }
}
