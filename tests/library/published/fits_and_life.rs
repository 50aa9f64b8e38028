//! Fits, temperatures, lubrication and friction: closed forms of Lamé, ISO 281 and SKF's catalogue, by independent
//! calculation.

use crate::bearing::{Bearing, BearingState};
use crate::physics::{
    FrictionFactors, LifeModification, Material, STEEL_EXPANSION, SkfFriction, SkfOperation,
    VibrationZone, ViscosityLaw, equivalent_load, inner_ring_fit, outer_ring_fit, rating_factor,
    reference_viscosity, reliability_factor, roller_equivalent_load, thermal_clearance_change,
};
use crate::quasi_static::{QuasiStatic, quasi_static};
use crate::scenario::Scenario;
use crate::tests::support::{assert_near, inside};

const PER_MINUTE: f64 = std::f64::consts::PI / 30.0;

/// E = 206 GPa, as the pressures below take it.
const STEEL: Material = Material {
    youngs_modulus: 206e9,
    ..Material::BEARING_STEEL
};

#[test]
fn interference_fits_of_steel() {
    let inner = |bore: f64, raceway: f64, hole: f64| {
        inner_ring_fit(bore, raceway, hole, 1e-6, &STEEL, &STEEL)
    };
    let outer = |outside: f64, raceway: f64, housing: f64| {
        outer_ring_fit(outside, raceway, housing, 1e-6, &STEEL, &STEEL).clearance_loss / 1e-6
    };
    // 6205-like: d_m = 38.5 mm, D = 7.938 mm
    let solid = inner(0.025, 0.030_562, 0.0);
    assert_near("solid", solid.clearance_loss / 1e-6, 0.8180, 5e-5);
    assert_near("MPa a µm", solid.pressure / 1e6, 1.363, 5e-4);
    assert_near(
        "hollow",
        inner(0.025, 0.030_562, 0.0125).clearance_loss / 1e-6,
        0.7368,
        5e-5,
    );
    assert_near(
        "outer",
        outer(0.052, 0.046_438, f64::INFINITY),
        0.8930,
        5e-5,
    );
    assert_near("thin housing", outer(0.052, 0.046_438, 0.078), 0.7685, 5e-5);
    // 6306: d_m = 51 mm, D = 11.906 mm
    assert_near(
        "6306",
        inner(0.030, 0.039_094, 0.0).clearance_loss / 1e-6,
        0.7674,
        5e-5,
    );
    assert_near("6306", outer(0.072, 0.062_906, f64::INFINITY), 0.8737, 5e-5);
    assert_eq!(
        inner_ring_fit(0.025, 0.03, 0.0, -1e-6, &STEEL, &STEEL).pressure,
        0.0
    );
}

#[test]
fn a_warmer_inner_ring_takes_clearance() {
    // 10 K over the outer ring, balls between them: 12.5e-6 (10 F_i + 2·5 D)
    let change = thermal_clearance_change(7.938e-3, 38.5e-3, [10.0, 5.0, 0.0], STEEL_EXPANSION);
    assert_near(
        "µm",
        change / 1e-6,
        -12.5e-6 * (10.0 * 30.562e3 + 10.0 * 7.938e3),
        1e-9,
    );
}

#[test]
fn rating_factors_of_iso_281() {
    for (gamma, factor) in [
        (0.05, 46.7),
        (0.1, 55.5),
        (0.16, 59.6),
        (0.2, 59.9),
        (0.28, 57.1),
        (0.4, 48.4),
    ] {
        assert!(
            (rating_factor(gamma) / factor - 1.0).abs() < 1.5e-3,
            "{gamma}"
        );
    }
}

#[test]
fn reference_viscosities_and_life_factors() {
    for (rpm, expected) in [(500.0, 41.72), (1500.0, 18.73), (3000.0, 13.24)] {
        let found = 1e6 * reference_viscosity(rpm * PER_MINUTE, 38.5e-3);
        assert_near("ν1", found, expected, 5.1e-3);
    }
    // the standard jumps by 2.3 % at 1000 rpm
    let at = |rpm: f64| reference_viscosity(rpm * PER_MINUTE, 38.5e-3);
    assert_near("jump", at(999.9999) / at(1000.0), 1.023, 1e-3);
    for (ratio, dirty, clean) in [
        (0.2, 0.1647, 0.2237),
        (0.5, 0.366, 0.8617),
        (1.0, 1.1437, 6.9181),
        (2.0, 1.7018, 15.11),
    ] {
        assert_near(
            "a_ISO",
            LifeModification::BALLS.factor(ratio, 0.05),
            dirty,
            5.1e-5,
        );
        let digits = if clean > 10.0 { 5.1e-3 } else { 5.1e-5 };
        assert_near(
            "a_ISO",
            LifeModification::BALLS.factor(ratio, 0.2),
            clean,
            digits,
        );
    }
    let factors = [95.0, 96.0, 97.0, 98.0, 99.0].map(reliability_factor);
    assert_eq!(factors, [0.64, 0.55, 0.47, 0.37, 0.25]);
    let factors = [99.2, 99.4, 99.6, 99.8, 99.9, 99.92, 99.94, 99.95].map(reliability_factor);
    let printed = [0.22, 0.19, 0.16, 0.12, 0.093, 0.087, 0.080, 0.077];
    assert_eq!(factors, printed);
    assert!(
        [50.0, 99.99, 100.0]
            .iter()
            .all(|at| reliability_factor(*at).is_nan())
    );
}

#[test]
fn what_is_not_a_number_leads_to_none() {
    const NAN: f64 = f64::NAN;
    let boundaries = [1.4e-3, 2.8e-3, 4.5e-3];
    assert_eq!(VibrationZone::from_velocity(NAN, &boundaries), None);
    let groove = FrictionFactors::DEEP_GROOVE;
    let [balls, rollers] = [LifeModification::BALLS, LifeModification::ROLLERS];
    let contact = Bearing::catalogue("6205").unwrap().inner_contact().unwrap();
    let ellipse = contact.ellipse(NAN);
    let answers = [
        equivalent_load(1000.0, NAN, 0.0, 1.0),
        equivalent_load(NAN, 500.0, 0.0, 1.0),
        equivalent_load(1000.0, 500.0, NAN, 1.0),
        equivalent_load(1000.0, 500.0, 0.0, NAN),
        roller_equivalent_load(1000.0, NAN, 0.0, 1),
        roller_equivalent_load(1000.0, NAN, 0.2, 2),
        balls.factor(NAN, 0.05),
        rollers.factor(1.0, NAN),
        reliability_factor(NAN),
        groove.load_moment(1e3, NAN, 32e3, 0.05),
        groove.viscous_moment(NAN, 100.0, 0.05),
        ViscosityLaw::from_grade(NAN, 95.0).at(50.0),
        ViscosityLaw::from_grade(68e-6, NAN).at(50.0),
        // an index that no oil of the grade has, and two points at one temperature
        ViscosityLaw::from_grade(68e-6, 1e6).at(50.0),
        ViscosityLaw::through([(40.0, 68e-6), (40.0, 68e-6)]).at(40.0),
        ViscosityLaw::through([(40.0, 68e-6), (40.0, 8.6e-6)]).at(40.0),
        ViscosityLaw::through([(40.0, 68e-6), (100.0, 8.6e-6)]).at(NAN),
        ellipse.peak_pressure,
        ellipse.approach,
    ];
    for (index, answer) in answers.into_iter().enumerate() {
        assert!(answer.is_nan(), "{index}: {answer}");
    }
}

#[test]
fn friction_of_a_6205_after_skf() {
    let operation = SkfOperation {
        boundary: [0.025, 0.052],
        static_rating: 7850.0,
        loads: [1000.0, 0.0],
        viscosity: 20e-6,
        speed: 3000.0 * PER_MINUTE,
        grease: false,
    };
    let series = SkfFriction::from_designation("6205").expect("a series");
    let [rolling, sliding] = series.moment(&operation);
    assert_near("N mm", 1e3 * (rolling + sliding), 20.631, 5.1e-4);
    let under = |axial| {
        let loads = [1000.0, axial];
        series.moment(&SkfOperation { loads, ..operation })
    };
    // what round-off leaves of a force along the shaft is none
    assert_eq!(under(-1e-9), [rolling, sliding]);
    // a real one moves G_sl by d_m^0.115, the form with axial loads
    assert_near("jump", under(0.01)[1] / sliding, 38.5f64.powf(0.115), 1e-6);
    assert_eq!(SkfFriction::from_designation("7205C"), None);
}

#[test]
fn viscosities_of_iso_vg_grades() {
    // ASTM D2270: 73.30 and 8.86 mm²/s have the index 92, 22.83 and 5.05 mm²/s 156
    let law = ViscosityLaw::from_grade(73.30e-6, 92.0);
    assert_near("index 92", 1e6 * law.at(100.0), 8.86, 0.02);
    let law = ViscosityLaw::from_grade(22.83e-6, 156.0);
    assert_near("index 156", 1e6 * law.at(100.0), 5.05, 0.02);
}

#[test]
fn equivalent_loads_of_iso_281() {
    assert_eq!(equivalent_load(1000.0, 100.0, 0.0, 0.689), 1000.0);
    assert_near("P", equivalent_load(1000.0, 800.0, 0.0, 1.38), 1720.0, 1e-9);
    assert_near(
        "P",
        equivalent_load(0.0, 1000.0, 15f64.to_radians(), 1.38),
        1190.0,
        10.0,
    );
}

/// A scenario of a pair of 7208C that is preloaded by 490 N, with a table after the bearing.
fn pair(table: &str) -> BearingState {
    let [first, _] = pair_at(0.0, table);
    first
}

/// The bearings of a set at a position in mm.
fn pair_at(position: f64, table: &str) -> [BearingState; 2] {
    let keys = format!(
        "arrangement = \"back-to-back\"\nspacing = \"100 mm\"\npreload = \"490 N\"\n{table}"
    );
    let scenario = scenario("7208C", &format!("position = \"{position} mm\"\n{keys}"));
    answer(&scenario).bearings.try_into().expect("two bearings")
}

/// A shaft on a bearing.
fn scenario(catalogue: &str, keys: &str) -> Scenario {
    let text = format!(
        "[shaft]\nmass = \"5 kg\"\nfreedoms = \"translational\"\n[speed]\nconstant = \"3000 rpm\"\n\
         [[bearing]]\ncatalogue = \"{catalogue}\"\n{keys}"
    );
    Scenario::from_toml(&text).expect("a scenario")
}

fn answer(scenario: &Scenario) -> QuasiStatic {
    quasi_static(&scenario.question).expect("an answer")
}

/// The shaft finds its axial place: where a set sits from the centre of mass does not matter to its preload.
#[test]
fn the_preload_of_a_warm_set_does_not_go_by_its_position() {
    let warm = "[bearing.fit]\ninner_temperature = \"50 degC\"\nouter_temperature = \"40 degC\"\n";
    let [first, second] = pair_at(0.0, warm).map(|state| state.preload);
    assert_near("N", first, second, 1e-6);
    assert!((first - 490.0).abs() > 50.0, "{first}");
    for position in [-200.0, 100.0, 1000.0] {
        for state in pair_at(position, warm) {
            assert_near("N", state.preload, first, 1e-6);
        }
    }
}

/// The shaft gives way to a single tapered bearing that is free axially.
#[test]
fn a_single_bearing_has_no_preload() {
    let load = "[[load]]\nconstant = { y = \"-500 N\", z = \"2000 N\" }\n";
    let fit = "[bearing.fit]\ninner_interference = \"10 um\"\n";
    let alone = answer(&scenario("30206", &format!("{fit}{load}")));
    assert_eq!(alone.bearings[0].preload, 0.0);
    assert!(alone.bearings[0].warnings.is_empty(), "{alone:?}");
    let set = format!("arrangement = \"back-to-back\"\nspacing = \"60 mm\"\n{fit}");
    let [first, second] = [0, 1].map(|index| {
        let state = answer(&scenario("30206", &set)).bearings[index].clone();
        assert!(state.warnings[0].contains("squeezed by 3.8"), "{state:?}");
        state.preload
    });
    assert!(first > 500.0, "{first}");
    assert_near("N", first, second, 1e-6);
}

/// Balls of silicon nitride grow less than the rings: a set that is 40 K warmer loses its preload.
#[test]
fn ceramic_balls_lose_the_preload_of_a_warm_set() {
    let warm = |kelvin: f64, expansion: &str| {
        let celsius = 20.0 + kelvin;
        let table = format!(
            "[bearing.ball_material]\nyoungs_modulus = \"310 GPa\"\npoisson_ratio = 0.26\ndensity = \"3200 kg/m^3\"\n\
             [bearing.fit]\ninner_temperature = \"{celsius} degC\"\nouter_temperature = \"{celsius} degC\"\n{expansion}"
        );
        pair(&table)
    };
    let given = "ball_expansion = \"3.2e-6 1/K\"\n";
    let lost = warm(60.0, given);
    assert_eq!(lost.preload, 0.0);
    // 2 × 11.906 mm × 60 K × (12.5 − 3.2)e-6
    let change = lost.fit.expect("a fit").thermal_change;
    assert_near("µm", change / 1e-6, 13.287, 1e-3);
    let less = warm(20.0, given).preload;
    assert!(less > 100.0 && less < 450.0, "{less}");
    assert_near("as steel", warm(40.0, "").preload, 490.0, 1e-6);
}

#[test]
fn fits_raise_the_preload_of_a_pair_and_a_warm_shaft_lowers_it() {
    let bare = pair("");
    assert!(bare.geometry.estimated && bare.fit.is_none());
    assert_near("N", bare.preload, 490.0, 1e-6);
    let fitted = pair("[bearing.fit]\ninner_interference = \"5 um\"\n");
    let fit = fitted.fit.expect("a fit");
    assert!(fit.angle < fit.angle_before);
    assert!(fitted.preload > 490.0, "{}", fitted.preload);
    let [before, after] = fit.axial_offset.expect("a preset");
    let shift = inside(&bare).contact_angle.sin() - inside(&fitted).contact_angle.sin();
    // A = 0.05 D
    let expected = 0.05 * inside(&bare).ball_diameter * shift;
    assert_near("µm", (after - before) / 1e-6, expected / 1e-6, 1e-6);
    // back to back, the shaft with its inner rings 10 K warmer: apart by α_T L/2 a side, and tighter by the rings
    let warm =
        pair("[bearing.fit]\nshaft_temperature = \"30 degC\"\ninner_temperature = \"20 degC\"\n");
    let [before, after] = warm.fit.expect("a fit").axial_offset.expect("a preset");
    let growth = -12.5e-6 * 10.0 * 0.05;
    // the shaft grows into the ring as well, by 5 µm on 40 mm
    let fit = warm.fit.expect("a fit");
    assert_near("µm", fit.interference[0] / 1e-6, 5.0, 1e-9);
    let turned = 0.05 * inside(&warm).ball_diameter * (fit.angle_before.sin() - fit.angle.sin());
    assert_near(
        "µm",
        (after - before) / 1e-6,
        (growth + turned) / 1e-6,
        1e-6,
    );
}

/// By a lubricant alone no modified life follows: ISO 281 needs the cleanliness, too.
#[test]
fn oil_alone_tells_its_viscosity_ratio_and_no_life() {
    let load = "[[load]]\nconstant = { y = \"-2000 N\" }\n";
    let thin = pair(&format!("[bearing.oil]\nviscosity = \"5 mm^2/s\"\n{load}"));
    let modified = thin.rating_lives.expect("lives").modified.expect("κ");
    // ν1 of 60 mm at 3000 rpm: 4500/√(3000·60) = 10.607 mm²/s
    let ratio = modified.viscosity_ratio.expect("κ");
    assert_near("κ", ratio, 5.0 / 10.607, 1e-4);
    assert_eq!(
        [
            modified.life,
            modified.hours,
            modified.life_modification_factor
        ],
        [None; 3]
    );
}

#[test]
fn ratings_and_lives_beyond_what_the_standard_covers_are_told() {
    let load = "[[load]]\nconstant = { y = \"-2000 N\" }\n";
    let oil = |viscosity: u32| {
        format!("[bearing.oil]\nviscosity = \"{viscosity} mm^2/s\"\ncontamination = \"normal\"\n")
    };
    let warned = |table: &str, words: &str| {
        let warnings = pair(&format!("{table}{load}")).warnings;
        warnings.iter().filter(|it| it.contains(words)).count()
    };
    // κ = 1/10.6, and 2/10.6
    assert_eq!(warned(&oil(1), "viscosity ratio"), 1);
    assert_eq!(warned(&oil(2), "viscosity ratio"), 0);
    let ceramic = |density: u32| {
        format!(
            "ball_material = {{ youngs_modulus = \"310 GPa\", poisson_ratio = 0.26, density = \"{density} kg/m^3\" }}\n{}",
            oil(20)
        )
    };
    assert_eq!(warned(&ceramic(3200), "hybrid"), 1);
    assert_eq!(warned(&ceramic(7850), "hybrid"), 0);
    let rating = |newtons: u32| format!("dynamic_rating = \"{newtons} N\"\n");
    for (newtons, count) in [
        (37, 1),
        (20_000, 1),
        (30_000, 0),
        (36_500, 0),
        (44_000, 0),
        (60_000, 1),
    ] {
        let words = format!("load rating is {newtons} N");
        assert_eq!(warned(&rating(newtons), &words), count, "{newtons} N");
    }
}

/// 60°: ISO 281 has no radial rating of it, and a rating that is given is axial.
#[test]
fn thrust_bearings_have_no_life_of_radial_ones() {
    let text = |angle: u32| {
        format!(
            "[shaft]\nmass = \"5 kg\"\nfreedoms = \"translational\"\n[speed]\nconstant = \"3000 rpm\"\n\
             [[bearing]]\ndynamic_rating = \"16.6 kN\"\n[bearing.geometry]\nballs = 14\nball_diameter = \"7.938 mm\"\n\
             pitch_diameter = \"38.5 mm\"\ngroove_factor_inner = 0.52\ngroove_factor_outer = 0.52\n\
             contact_angle = \"{angle} deg\"\n[[load]]\nconstant = {{ y = \"-300 N\", z = \"1 kN\" }}\n"
        )
    };
    for (angle, has_life) in [(45, true), (46, false), (60, false)] {
        let scenario = Scenario::from_toml(&text(angle)).expect("a scenario");
        let answer = crate::quasi_static::quasi_static(&scenario.question).expect("an answer");
        assert_eq!(
            answer.bearings[0].rating_lives.is_some(),
            has_life,
            "{angle}°"
        );
        let warned = answer
            .warnings
            .iter()
            .any(|warning| warning.contains("thrust bearing"));
        assert_eq!(warned, !has_life, "{angle}°: {:?}", answer.warnings);
    }
}

#[test]
fn lives_with_oil_and_contamination() {
    let oil = "[[load]]\nconstant = { y = \"-2000 N\" }\n";
    let plain = pair(oil);
    let lives = plain.rating_lives.expect("lives");
    assert!(lives.modified.is_none());
    let hours = lives.reference_hours.expect("hours");
    assert_near(
        "h",
        hours,
        lives.reference * 1e6 / (3000.0 * 60.0),
        1e-6 * hours,
    );
    let table = format!(
        "reliability = 95.0\n[bearing.oil]\niso_vg = 68.0\ntemperature = \"70 degC\"\ncontamination = \"normal\"\n{oil}"
    );
    let lives = pair(&table).rating_lives.expect("lives");
    let modified = lives.modified.expect("a life");
    let factor = modified.life_modification_factor.expect("a_ISO");
    let load = 36_500.0 / lives.reference.cbrt();
    let ratio = modified.viscosity_ratio.expect("κ");
    let expected = LifeModification::BALLS.factor(ratio, 0.55 * modified.fatigue_load_limit / load);
    assert_near("a_ISO", factor, expected, 1e-9);
    assert_near(
        "L5",
        modified.life.expect("a life") / (0.64 * factor * lives.reference),
        1.0,
        1e-12,
    );
}

#[test]
fn unbalance_as_people_have_it() {
    let scene = |shaft: &str, planes: &str| {
        let text = format!(
            "[shaft]\nmass = \"8 kg\"\ninertia_transverse = \"0.05 kg m^2\"\ninertia_polar = \"0.01 kg m^2\"\n\
             freedoms = \"all\"\n{shaft}\n[speed]\nconstant = \"1480 rpm\"\n\
             [[bearing]]\ncatalogue = \"6205\"\nposition = \"-60 mm\"\n\
             [[bearing]]\ncatalogue = \"6205-2RS/C3\"\nposition = \"60 mm\"\n{planes}"
        );
        Scenario::from_toml(&text).map(|scenario| scenario.question.rotor)
    };
    let unbalance =
        |shaft: &str, planes: &str| scene(shaft, planes).expect("a scenario").shaft.unbalance;
    let speed = 1480.0 * PER_MINUTE;
    let [x, y] = unbalance("unbalance = \"20 g mm\"", "").moment;
    assert_near("kg m", x, 20e-6, 1e-12);
    assert_eq!(y, 0.0);
    // G 6.3: U = m G/ω
    let [x, _] = unbalance("unbalance = \"G 6.3\"", "").moment;
    assert_near("kg m", x, 8.0 * 6.3e-3 / speed, 1e-9);
    let planes = "[[unbalance]]\namount = \"10 g mm\"\nposition = \"50 mm\"\n\
                  [[unbalance]]\namount = \"10 g mm\"\nposition = \"-50 mm\"\nangle = \"180 deg\"\n";
    let sum = unbalance("", planes);
    let largest = |parts: [f64; 2]| parts[0].abs().max(parts[1].abs());
    assert!(largest(sum.moment) < 1e-18);
    assert_near("kg m²", sum.couple[0], 2.0 * 10e-6 * 0.05, 1e-12);
    assert!(sum.couple[1].abs() < 1e-18);
    for wrong in [
        "unbalance = \"20\"",
        "unbalance = \"G x\"",
        "unbalance = \"3 kg\"",
    ] {
        assert!(scene(wrong, "").is_err(), "{wrong}");
    }
}

/// A moment alone, or a negative clearance alone, loads the balls and leaves P of ISO 281 no force.
#[test]
fn no_basic_life_without_a_force() {
    let state = |table: &str, moment: &str| {
        let text = format!(
            "[shaft]\nmass = \"5 kg\"\nfreedoms = \"all\"\ninertia_transverse = \"0.1 kg m^2\"\ninertia_polar = \"0.01 kg m^2\"\n\
             [speed]\nconstant = \"3000 rpm\"\n[[bearing]]\ncatalogue = \"6206\"\n{table}\
             [[load]]\nconstant = {{ {moment} }}\n"
        );
        answer(&Scenario::from_toml(&text).expect("a scenario")).bearings[0].clone()
    };
    let squeezed = "[bearing.geometry]\ndiametral_clearance = \"-8 um\"\n";
    for (table, moment) in [("", "tilt_x = \"10 N m\""), (squeezed, "y = \"0 N\"")] {
        let lives = state(table, moment).rating_lives.expect("lives");
        assert!(lives.reference > 0.0);
        assert_eq!((lives.basic, lives.equivalent_load), (None, None));
    }
    let lives = state(squeezed, "y = \"-1 N\"").rating_lives.expect("lives");
    assert_near("P", lives.equivalent_load.expect("a load"), 1.0, 1e-6);
    // (C/P)³ by the printed C, which is not that of the dimensions
    let ratio = lives.dynamic_rating / lives.equivalent_load.expect("a load");
    assert_near(
        "L10",
        lives.basic.expect("a life") / ratio.powi(3),
        1.0,
        1e-12,
    );
    assert_eq!(lives.dynamic_rating, 19_500.0);
}
