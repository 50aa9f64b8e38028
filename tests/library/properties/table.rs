//! A table stands for the law that it was compiled from.

use crate::bearing::{
    Ball, BallForce, BallLaw, BallRegion, BallTable, Bearing, BearingRotation, ContactLaw,
    ForceLaw, HertzFilmLaw, JonesFilmLaw, JonesLaw, Oil, Support, TableError, TableReport,
};
use crate::integrate::Method;
use crate::physics::RaceControl;
use crate::rotor::{Damping, Freedoms, RotorDefinition};
use crate::simulate::{Model, Run};

use crate::tests::support::{
    AT_EQUILIBRIUM, bearing, constant, model, mounted, rotor, settings, shaft, simulate_into,
    try_run,
};

const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};
const SPEED: f64 = 1000.0;
/// Load that errors refer to, N.
const LOAD: f64 = 300.0;
const TOLERANCE: f64 = 1e-9;

/// Places around those of a ball under thrust; `lowest` of them in µm below the free radial one.
fn region(bearing: &Bearing, axial: [f64; 2], radial: f64) -> BallRegion {
    let geometry = &bearing.geometry;
    BallRegion {
        axial: axial.map(|z| geometry.free_axial() + 1e-6 * z),
        radial: [-radial, radial].map(|r| geometry.free_radial() + 1e-6 * r),
    }
}

/// Loaded balls alone, and balls that unload on one side.
fn regions(bearing: &Bearing) -> [BallRegion; 2] {
    [
        region(bearing, [28.0, 36.0], 8.0),
        region(bearing, [5.0, 15.0], 20.0),
    ]
}

fn compiled<L: BallLaw>(law: &L, region: BallRegion) -> (BallTable, TableReport) {
    BallTable::compile(law, region, SPEED, LOAD, TOLERANCE).expect("a smooth law")
}

/// Whether a table stands for the law at a single place.
fn covers(table: &BallTable, axial: f64, radial: f64, speed: f64) -> bool {
    table.covers_around([axial, 0.0], [radial, 0.0], speed)
}

/// Places all over a region, on none of the table's nodes.
fn places(region: BallRegion, count: usize) -> impl Iterator<Item = [f64; 2]> {
    let between = |[low, high]: [f64; 2], part: f64| low + (high - low) * part;
    (0..count).map(move |index| {
        let golden = (0.5 + 0.618_033_988_749_894_9 * index as f64).fract();
        let part = (index as f64 + 0.5) / count as f64;
        [between(region.axial, golden), between(region.radial, part)]
    })
}

fn difference(a: &BallForce, b: &BallForce, arm: f64) -> f64 {
    let couple = (a.couple - b.couple).abs() / arm;
    (a.axial - b.axial)
        .abs()
        .max((a.radial - b.radial).abs())
        .max(couple)
}

/// Values everywhere in both regions, and what it took.
fn check_values<L: BallLaw>(law: &L, regions: &[BallRegion]) {
    let arm = bearing("7205C").geometry.groove_centre_distance();
    for &region in regions {
        let (table, report) = compiled(law, region);
        assert!(report.relative_error <= TOLERANCE, "{report:?}");
        assert!(report.evaluations < 60_000, "{report:?}");
        for [axial, radial] in places(region, 4000) {
            assert!(covers(&table, axial, radial, SPEED));
            let exact = law.force(&Ball::at(axial, radial), SPEED);
            let own = table.force(&Ball::at(axial, radial), SPEED);
            let error = difference(&own, &exact, arm);
            assert!(
                error <= TOLERANCE * LOAD,
                "{error:e} N at {axial:e}, {radial:e}"
            );
        }
    }
}

#[test]
fn every_costly_law_has_a_table_within_the_tolerance() {
    let bearing = bearing("7205C");
    let all = regions(&bearing);
    let film = HertzFilmLaw::with_film(&bearing, OIL, SPEED).expect("a law");
    check_values(&film, &all);
    let jones = JonesLaw::new(&bearing, RaceControl::Outer).expect("a law");
    check_values(&jones, &all);
    let both = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, OIL, SPEED).expect("a law");
    check_values(&both, &all);
}

#[test]
fn loaded_balls_have_a_table_under_any_race_control() {
    let bearing = bearing("7205C");
    let loaded = [regions(&bearing)[0]];
    for control in [RaceControl::Even, RaceControl::Inner] {
        check_values(&JonesLaw::new(&bearing, control).expect("a law"), &loaded);
        let film = JonesFilmLaw::with_film(&bearing, control, OIL, SPEED).expect("a law");
        check_values(&film, &loaded);
    }
}

/// Where the inner race loses its grip, its friction has a bend that no table follows: it says so.
#[test]
fn a_law_that_is_not_smooth_is_refused() {
    let bearing = bearing("7205C");
    let law = JonesLaw::new(&bearing, RaceControl::Even).expect("a law");
    let unloading = regions(&bearing)[1];
    let table = BallTable::compile(&law, unloading, SPEED, LOAD, TOLERANCE);
    assert!(matches!(table, Err(TableError::Tolerance { .. })));
    let nothing = BallTable::compile(&law, unloading, SPEED, 0.0, TOLERANCE);
    assert!(matches!(nothing, Err(TableError::NoRegion)));
    let narrow = region(&bearing, [30.0, 30.0 + 1e-5], 8.0);
    let nothing = BallTable::compile(&law, narrow, SPEED, LOAD, TOLERANCE);
    assert!(matches!(nothing, Err(TableError::NoRegion)));
}

#[test]
fn the_derivative_of_a_table_is_close_to_that_of_its_law() {
    let bearing = bearing("7205C");
    let law = JonesFilmLaw::with_film(&bearing, RaceControl::Inner, OIL, SPEED).expect("a law");
    let region = regions(&bearing)[0];
    let (table, _) = compiled(&law, region);
    let (stiffest, step) = (1e8, 1e-10);
    for [axial, radial] in places(region, 300) {
        let (force, tangent) = table.force_and_tangent(axial, radial, SPEED);
        let plain = table.force(&Ball::at(axial, radial), SPEED);
        assert!(difference(&force, &plain, 1e-4) < 1e-11 * LOAD);
        let exact = law.force_and_tangent(axial, radial, SPEED).1;
        for (row, arm) in [(0, 1.0), (1, 1.0), (2, 4e-4)] {
            for column in 0..2 {
                let error = (tangent[row][column] - exact[row][column]).abs();
                assert!(error < 1e-6 * arm * stiffest, "{row}, {column}: {error:e}");
            }
        }
        let ahead = table.force(&Ball::at(axial, radial + step), SPEED).radial;
        let behind = table.force(&Ball::at(axial, radial - step), SPEED).radial;
        let slope = (ahead - behind) / (2.0 * step);
        assert!((slope - tangent[1][1]).abs() < 1e-5 * stiffest);
    }
}

#[test]
fn both_sides_of_a_centred_ball_are_the_same() {
    let bearing = bearing("7205C");
    let law = JonesLaw::new(&bearing, RaceControl::Outer).expect("a law");
    let geometry = &bearing.geometry;
    let around = geometry.groove_centre_distance();
    let region = BallRegion {
        axial: [-4e-6, 8e-6],
        radial: [around - 10e-6, around + 20e-6],
    };
    let (table, _) = compiled(&law, region);
    // the ends of the table are in it, to the bit
    for axial in [-8e-6, -0.0, 0.0, 8e-6] {
        for radial in [region.radial[0], region.radial[1]] {
            let error = difference(
                &table.force(&Ball::at(axial, radial), SPEED),
                &law.force(&Ball::at(axial, radial), SPEED),
                1.0,
            );
            assert!(covers(&table, axial, radial, SPEED));
            assert!(error <= TOLERANCE * LOAD);
        }
    }
    for [axial, radial] in places(region, 500) {
        let [here, there] =
            [axial, -axial].map(|axial| table.force(&Ball::at(axial, radial), SPEED));
        assert_eq!(here.axial, -there.axial);
        assert_eq!(here.radial, there.radial);
        let exact = law.force(&Ball::at(axial, radial), SPEED);
        assert!(difference(&here, &exact, 1.0) <= TOLERANCE * LOAD);
    }
}

#[test]
fn elsewhere_and_at_other_speeds_a_table_covers_nothing() {
    let bearing = bearing("7205C");
    let law = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, OIL, SPEED).expect("a law");
    let region = regions(&bearing)[0];
    let (table, _) = compiled(&law, region);
    let [axial, radial] = [region.axial[1], region.radial[1]];
    assert!(covers(&table, axial, radial, SPEED));
    for (axial, radial, speed) in [
        (axial + 1e-9, radial, SPEED),
        (region.axial[0] - 1e-9, radial, SPEED),
        (axial, region.radial[0] - 1e-9, SPEED),
        (axial, radial + 1e-5, SPEED),
        (axial, radial, 999.0),
    ] {
        assert!(!covers(&table, axial, radial, speed));
    }
    assert!(!covers(&table, f64::NAN, radial, SPEED) && !covers(&table, axial, f64::NAN, SPEED));
}

/// Around a thrust that loads all balls: the table's force and slopes inside, the law's own outside.
#[test]
fn outside_its_table_a_bearing_has_the_force_of_its_law() {
    let definition = crate::bearing::MountedBearing {
        law: ContactLaw::Jones(RaceControl::Even),
        oil: Some(OIL),
        ..mounted(bearing("7205C"))
    };
    let exact = Support::new(&definition, SPEED).expect("a support");
    let mut table = exact.clone();
    let middle = [0.0, 0.0, 32e-6, 0.0, 0.0];
    let rotation = |speed| BearingRotation::at_start(speed).with_cage_at(0.7);
    let swing = [4e-6, 4e-6, 6e-6, 1e-4, 1e-4];
    let report = table.tabulate(&middle, &swing, SPEED, TOLERANCE);
    let report = report.expect("a costly law").expect("a smooth law");
    assert!(report.relative_error <= TOLERANCE, "{report:?}");
    let load = report.error / report.relative_error;
    let arm = definition.bearing.geometry.inner_groove_radius();
    let levers = [1.0, 1.0, 1.0, arm, arm];
    for place in [
        [0.0, 0.0, 32e-6, 0.0, 0.0],
        [2e-6, -3e-6, 30e-6, 4e-5, -7e-5],
        [-3e-6, 3e-6, 36e-6, -1e-4, 0.0],
    ] {
        let rotation = rotation(SPEED);
        assert!(table.is_inside_table(&place, &rotation));
        let (own, reference) = (
            table.force(&place, &rotation),
            exact.force(&place, &rotation),
        );
        assert_ne!(own, reference);
        for (axis, lever) in levers.into_iter().enumerate() {
            let error = (own[axis] - reference[axis]).abs();
            assert!(error < 12.0 * TOLERANCE * load * lever, "{axis}: {error:e}");
        }
        let own = table.tangent(&place, &rotation);
        let reference = exact.tangent(&place, &rotation);
        let difference = own.stiffness - reference.stiffness;
        assert!(difference.abs().max() < 1e-5 * reference.stiffness.abs().max());
        assert!((own.by_cage_angle[0] - reference.by_cage_angle[0]).abs() < 1e-5 * load);
    }
    for (place, speed) in [
        ([0.0, 0.0, 45e-6, 0.0, 0.0], SPEED),
        ([8e-6, 8e-6, 32e-6, 0.0, 0.0], SPEED),
        ([0.0, 0.0, 32e-6, 1e-3, 0.0], SPEED),
        (middle, 999.0),
    ] {
        let rotation = rotation(speed);
        assert!(!table.is_inside_table(&place, &rotation));
        let own = table.force(&place, &rotation);
        assert_eq!(own, exact.force(&place, &rotation));
        assert_eq!(
            table.tangent(&place, &rotation),
            exact.tangent(&place, &rotation)
        );
    }
}

/// A light thrust and a radial load: balls unload at every turn of the cage.
fn unloading(law: ContactLaw, oil: Option<Oil>) -> RotorDefinition {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.eccentricity = 1e-5;
    shaft.gravity = true;
    let bearing = crate::bearing::MountedBearing {
        law,
        oil,
        ..mounted(bearing("7205C"))
    };
    RotorDefinition {
        speed: SPEED,
        loads: constant([0.0, -1500.0, 300.0, 0.0, 0.0]),
        damping: Damping::Ratio(0.02),
        initial: AT_EQUILIBRIUM,
        ..rotor(shaft, vec![bearing])
    }
}

/// The same run with tables and without: their largest distance over the motion, and both runs.
fn table_and_exact(mut model: Model) -> (f64, [Run; 2]) {
    let run = |model: &Model| {
        let (run, samples) = try_run(model, 0.0);
        (run.expect("it runs"), samples)
    };
    model.table = true;
    let (tabulated, own) = run(&model);
    model.table = false;
    let (exact, reference) = run(&model);
    let mut distance = 0.0_f64;
    let mut motion = 0.0_f64;
    for axis in 0..3 {
        let start = reference[0].displacement[axis];
        for (own, reference) in own.iter().zip(&reference) {
            distance = distance.max((own.displacement[axis] - reference.displacement[axis]).abs());
            motion = motion.max((reference.displacement[axis] - start).abs());
        }
    }
    (distance / motion, [tabulated, exact])
}

#[test]
fn a_run_with_balls_that_unload_every_turn_is_the_same_by_table() {
    let jones = ContactLaw::Jones(RaceControl::Outer);
    for oil in [None, Some(OIL)] {
        let mut model = model(unloading(jones, oil), 0.05, 20_000.0);
        // so tight that what is left is the table's
        model.integrator = settings(1e-11);
        let (distance, [own, exact]) = table_and_exact(model);
        assert!(
            exact.bearings[0]
                .events
                .iter()
                .any(|(_, count)| count.count > 0)
        );
        let table = own.tables[0].expect("a costly law");
        assert!(
            table
                .table
                .is_ok_and(|report| report.relative_error <= 1e-9)
        );
        assert_eq!(table.samples_outside, 0);
        assert_eq!(exact.tables, []);
        assert!(distance < 1e-7, "{distance:e}");
        let work = own.counters.evaluations as f64 / exact.counters.evaluations as f64;
        assert!((work - 1.0).abs() < 0.05, "{work}");
    }
}

#[test]
fn a_stiff_method_takes_the_derivative_from_the_table() {
    let jones = ContactLaw::Jones(RaceControl::Outer);
    let mut model = model(unloading(jones, Some(OIL)), 0.01, 20_000.0);
    model.integrator = settings(1e-6);
    model.integrator.method = Method::Rodas;
    let (distance, [own, exact]) = table_and_exact(model);
    assert!(distance < 1e-5, "{distance:e}");
    let steps = own.counters.steps as f64 / exact.counters.steps as f64;
    assert!((steps - 1.0).abs() < 0.05, "{steps}");
}

#[test]
fn hertz_contacts_and_varying_speeds_have_no_table() {
    let hertz = model(unloading(ContactLaw::Hertz, None), 0.001, 20_000.0);
    let (_, [own, _]) = table_and_exact(hertz);
    assert_eq!(own.tables, [None]);
    let mut run_up = unloading(ContactLaw::Jones(RaceControl::Outer), None);
    run_up.speed_points = vec![crate::rotor::SpeedPoint {
        time: 1.0,
        speed: 1100.0,
    }];
    let (distance, [own, _]) = table_and_exact(model(run_up, 0.001, 20_000.0));
    assert_eq!(own.tables, [None]);
    assert_eq!(distance, 0.0);
}

/// Nothing is taken from an undamped, balanced shaft that swings behind its oil films.
#[test]
fn a_table_keeps_the_energy_of_an_undamped_shaft() {
    let mut definition = unloading(ContactLaw::Hertz, Some(OIL));
    definition.shaft.eccentricity = 0.0;
    definition.loads = constant([0.0, 0.0, 150.0, 0.0, 0.0]);
    definition.damping = Damping::Undamped;
    definition.cage = crate::rotor::CageMotion::Frozen;
    definition.initial.displacement[0] = Some(3e-6);
    let mut model = model(definition, 0.05, 20_000.0);
    model.integrator = settings(1e-11);
    model.energy = true;
    for table in [true, false] {
        model.table = table;
        let run = simulate_into(&model, &mut crate::tests::support::Collector::default());
        let energy = run.expect("it runs").energy.expect("an account");
        assert!(energy.conservative);
        assert!(energy.relative_residual < 1e-8, "{energy:?}");
    }
}
