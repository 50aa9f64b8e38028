//! Equilibrium from anywhere: random loads over five orders of magnitude, all laws, all freedoms.

use crate::bearing::{
    Bearing, BearingError, ContactDamping, ContactLaw, Facing, FreePosition, Geometry,
    GeometryError, Imperfections, MountedBearing, Oil, Preload, Profile, RollerKind, Rollers,
    Support, catalogue,
};
use crate::physics::RaceControl;
use crate::quasi_static::{QuasiStatic, quasi_static};
use crate::rotor::{RotorError, StaticProblem};
use crate::scenario::{self, Format};
use crate::tests::support;

/// Contacts, dimensions and loads out of all proportion end in an error that names them, and nothing panics.
#[test]
fn bearings_out_of_proportion_have_typed_errors() {
    let sound = catalogue::find("7205C").unwrap().bearing().unwrap();
    let load = [0.0, 100.0, 1000.0, 0.0, 0.0];
    for stiffness in [f64::NAN, f64::INFINITY, -1.0, 0.0] {
        let bearing = Bearing {
            contact_stiffness: Some(stiffness),
            ..sound
        };
        let Err(RotorError::Bearing { source, .. }) = bearing.equilibrium(load) else {
            panic!("{stiffness} is a stiffness");
        };
        assert!(matches!(source, BearingError::ContactStiffness { .. }));
    }
    for stiffness in [f64::MIN_POSITIVE, 1e-30, 1e200, f64::MAX] {
        let contact_stiffness = Some(stiffness);
        let bearing = Bearing {
            contact_stiffness,
            ..sound
        };
        for load in [load, [1e300; 5]] {
            if let Ok(found) = bearing.equilibrium(load) {
                assert!(found.displacement.iter().all(|at| at.is_finite()));
            }
        }
    }
    let angle = FreePosition::ContactAngle(0.3);
    for [ball, pitch] in [[1e-300, 1e300], [1e-3, 1e300], [f64::NAN, 1.0]] {
        let geometry = Geometry::new(3, ball, pitch, angle, 0.52, 0.53);
        assert!(matches!(geometry, Err(GeometryError::Length { .. })));
    }
    let barrels = |roller_radius, race_radius| {
        let profile = Profile::Barrel {
            roller_radius,
            race_radius,
        };
        let rollers = Rollers {
            kind: RollerKind::Spherical,
            length: 0.01,
            profile,
            laminae: 30,
            clearance: 0.0,
        };
        Geometry::of_rollers(18, 0.01, 0.085, 0.16, rollers)
    };
    for [roller, race] in [[f64::NAN, 0.1], [0.1, f64::NAN], [0.0, 0.0], [0.1, 0.05]] {
        let geometry = barrels(roller, race);
        assert!(matches!(geometry, Err(GeometryError::Barrel { .. })));
    }
    let rollers = Bearing::of_steel(barrels(0.05, 0.051).unwrap());
    let contacts = [rollers.inner_contact(), rollers.outer_contact()];
    let all_refused = |contact| matches!(contact, Err(BearingError::Rollers { .. }));
    assert!(contacts.into_iter().all(all_refused));
}

/// Cases over all laws together.
const CASES: u64 = 10_000;
/// Residual that the equilibrium promises, relative to the forces in play.
const PROMISED_RESIDUAL: f64 = 1e-9;

/// Uniform numbers in 0 … 1 from a seed: SplitMix64.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform between two limits.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    /// Either sign, magnitude uniform in its logarithm.
    fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        let value = self.between(low.ln(), high.ln()).exp();
        if self.roll() < 0.5 { -value } else { value }
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.roll() * count as f64) as usize).min(count - 1)
    }
}

/// An angular contact or a deep-groove bearing, with or without clearance.
fn bearing(dice: &mut Dice) -> Bearing {
    let names = ["7205C", "6204", "6205", "6305", "6306"];
    let entry = catalogue::find(names[dice.below(names.len())]).expect("a designation");
    let bearing = entry.bearing().expect("a sound bearing");
    if entry.line.contact_angle > 0.0 || dice.roll() < 0.3 {
        return bearing;
    }
    let clearance = FreePosition::DiametralClearance(dice.between(0.0, 40e-6));
    let old = &bearing.geometry;
    let geometry = Geometry::new(
        old.balls(),
        old.ball_diameter(),
        old.pitch_diameter(),
        clearance,
        old.groove_factors()[0],
        old.groove_factors()[1],
    );
    Bearing {
        geometry: geometry.expect("a small clearance"),
        ..bearing
    }
}

fn law(dice: &mut Dice) -> (ContactLaw, Option<Oil>) {
    let controls = [RaceControl::Outer, RaceControl::Inner, RaceControl::Even];
    let law = match dice.below(3) {
        0 => ContactLaw::Hertz,
        _ => ContactLaw::Jones(controls[dice.below(3)]),
    };
    let oil = Oil {
        viscosity: 0.04,
        pressure_viscosity: 2.2e-8,
    };
    (law, (dice.roll() < 0.5).then_some(oil))
}

struct Case {
    supports: Vec<Support>,
    load: [f64; 5],
    free: [bool; 5],
    speed: f64,
    words: String,
}

fn case(seed: u64) -> Case {
    let mut dice = Dice(seed);
    let (bearing, (law, oil)) = (bearing(&mut dice), law(&mut dice));
    let speed = if dice.roll() < 0.2 {
        0.0
    } else {
        dice.between(0.0, 3000.0)
    };
    let pair = dice.roll() < 0.3;
    let mut mounted = MountedBearing {
        bearing,
        law,
        oil,
        position: 0.0,
        facing: Facing::PlusZ,
        preload: Preload::AxialOffset(0.0),
        contact_damping: ContactDamping::default(),
        first_ball: dice.between(0.0, std::f64::consts::TAU),
        imperfections: Imperfections::default(),
        housing: None,
    };
    let mut definitions = vec![mounted.clone()];
    if pair {
        mounted.preload = Preload::AxialOffset(dice.between(0.0, 20e-6));
        definitions = vec![mounted.clone(), mounted];
        definitions[0].position = dice.between(0.01, 0.2);
        definitions[1].position = -definitions[0].position;
        definitions[1].facing = Facing::MinusZ;
    }
    let supports = definitions
        .iter()
        .map(|definition| Support::new(definition, speed).expect("a sound support"))
        .collect();
    let free = std::array::from_fn(|_| dice.roll() < 0.75);
    let load = std::array::from_fn(|axis| {
        let force = if dice.roll() < 0.3 {
            0.0
        } else {
            dice.magnitude(0.3, 3e4)
        };
        if axis < 3 { force } else { 5e-3 * force }
    });
    Case {
        supports,
        load,
        free,
        speed,
        words: format!("{law:?} oil {} speed {speed} pair {pair}", oil.is_some()),
    }
}

#[test]
fn random_loads_converge_or_say_what_nothing_carries() {
    let (mut most, mut total) = (0, 0);
    for seed in 0..CASES {
        let case = case(seed);
        let problem = StaticProblem {
            supports: &case.supports,
            load: case.load,
            free: case.free,
            start: [0.0; 5],
            speed: case.speed,
        };
        let words = || {
            format!(
                "seed {seed}: {:?} {:?} {}",
                case.load, case.free, case.words
            )
        };
        match problem.solve() {
            Ok(equilibrium) => {
                let residual = equilibrium.residual;
                assert!(residual <= PROMISED_RESIDUAL, "{}: {residual}", words());
                most = most.max(equilibrium.newton_steps);
                total += equilibrium.newton_steps;
            }
            // grooves carry load along every freedom, so none of these loads may be refused
            Err(error) => panic!("{}: {error}", words()),
        }
    }
    // measured: at most 69, and 7.9 in the mean
    assert!(most <= 80, "{most} Newton steps");
    assert!(
        total <= 10 * CASES as usize,
        "{total} Newton steps in {CASES} cases"
    );
}

#[test]
fn a_loose_shaft_is_told_by_the_names_of_its_freedoms() {
    let text = r#"
        [shaft]
        mass = "5 kg"
        freedoms = "translational"
        [speed]
        constant = "100 rad/s"
        [[bearing]]
        catalogue = "6205"
        [bearing.geometry]
        diametral_clearance = "10 um"
    "#;
    let scenario = scenario::parse(text, "loose.toml", Format::Toml).expect("a sound scenario");
    let answer = quasi_static(&scenario.question).expect("many equilibria are not none");
    assert!(answer.condition.is_infinite());
    let [warning] = &answer.warnings[..] else {
        panic!("{:?}", answer.warnings)
    };
    assert!(
        warning.contains("nothing resists the shaft along x, y, z:"),
        "{warning}"
    );
}

/// The static answer to a scenario of a rigid shaft that moves along these freedoms.
#[track_caller]
fn at_rest(freedoms: &str, bearings: &str) -> QuasiStatic {
    let text = format!(
        "[shaft]\nmass = \"10 kg\"\nfreedoms = \"{freedoms}\"\n[speed]\nconstant = \"3000 rpm\"\n{bearings}\n\
         [[load]]\nconstant = {{ y = \"-1000 N\" }}\n"
    );
    quasi_static(&support::scenario(&text).question).expect("an equilibrium")
}

/// Whether z moves or is held: the bearings bear what their axial forces leave them, in any order.
#[test]
fn bearings_share_axial_forces_where_z_is_held() {
    let spring_loaded = "[[bearing]]\ncatalogue = \"6205\"\nposition = \"-80 mm\"\n\
        [[bearing]]\ncatalogue = \"6205\"\nposition = \"80 mm\"\nspring_preload = \"200 N\"\n";
    let [angular, deep] = [
        "[[bearing]]\ncatalogue = \"7205C\"\nposition = \"-50 mm\"\n",
        "[[bearing]]\ncatalogue = \"6205\"\nposition = \"50 mm\"\n",
    ];
    let warm =
        "[bearing.fit]\nshaft_temperature = \"60 degC\"\nhousing_temperature = \"40 degC\"\n";
    let apart = ["100 mm", "300 mm"].map(|position| {
        format!("[[bearing]]\ncatalogue = \"6205\"\nposition = \"{position}\"\n{warm}")
    });
    for bearings in [
        spring_loaded.to_owned(),
        angular.to_owned() + deep,
        deep.to_owned() + angular,
        apart.concat(),
    ] {
        let [held, moving] = ["radial", "translational"].map(|own| at_rest(own, &bearings));
        assert!(held.force[2].abs() < 1e-6, "{:?}", held.force);
        for (held, moving) in held.bearings.iter().zip(&moving.bearings) {
            assert!((held.force[2] - moving.force[2]).abs() < 1e-6 * 200.0);
            assert_eq!(held.balls_loaded, moving.balls_loaded);
            let [held, moving] = [held, moving].map(|own| own.stiffness[(0, 0)]);
            assert!((held / moving - 1.0).abs() < 1e-9, "{held:e}, {moving:e}");
        }
    }
    let pressed = at_rest("radial", spring_loaded);
    let forces = [0, 1].map(|bearing: usize| pressed.bearings[bearing].force[2]);
    assert!((forces[0] + 200.0).abs() < 1e-6 && (forces[1] - 200.0).abs() < 1e-6);
}

/// Two springs that press one way, and nothing that presses back.
#[test]
fn a_push_that_nothing_answers_is_held_with_a_warning() {
    let spring = |position: &str| {
        format!(
            "[[bearing]]\ncatalogue = \"7205C\"\nposition = \"{position}\"\nspring_preload = \"200 N\"\n"
        )
    };
    let found = at_rest("radial", &(spring("-80 mm") + &spring("80 mm")));
    assert!(
        (found.force[2].abs() - 400.0).abs() < 1e-6,
        "{:?}",
        found.force
    );
    let said = |warning: &String| warning.contains("400.0 N");
    assert!(found.warnings.iter().any(said), "{:?}", found.warnings);
}
