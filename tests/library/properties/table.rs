//! A table stands for the law that it was compiled from.

use fearless_simd::{Level, Simd, SimdBase, dispatch};
use jeffcott::bearing::{
    BallForce, BallLaw, BallRegion, Bearing, CageAngle, ContactLaw, HertzFilmLaw, JonesFilmLaw,
    JonesLaw, Lanes, Oil, Ring, TableError, TableLaw, TableReport,
};
use jeffcott::integrate::Method;
use jeffcott::physics::RaceControl;
use jeffcott::rotor::{Damping, Freedoms, RotorDefinition};
use jeffcott::simulate::{Model, Run};

use crate::support::{
    AT_EQUILIBRIUM, bearing, model, mounted, rotor, settings, shaft, simulate_into, try_run,
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

fn compiled<L: BallLaw + Clone, const COUPLE: bool>(
    law: &L,
    region: BallRegion,
) -> (TableLaw<L, COUPLE>, TableReport) {
    TableLaw::compile(law.clone(), region, SPEED, LOAD, TOLERANCE).expect("a smooth law")
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
fn check_values<L: BallLaw + Clone, const COUPLE: bool>(law: &L, regions: &[BallRegion]) {
    let arm = bearing("7205C").geometry.groove_centre_distance();
    for &region in regions {
        let (table, report) = compiled::<L, COUPLE>(law, region);
        assert!(report.relative_error <= TOLERANCE, "{report:?}");
        assert!(report.evaluations < 8000, "{report:?}");
        for [axial, radial] in places(region, 4000) {
            assert!(table.covers(axial, radial, SPEED));
            let exact = law.force(axial, radial, SPEED);
            let own = table.force(axial, radial, SPEED);
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
    let film = HertzFilmLaw::new(&bearing, OIL, SPEED).expect("a law");
    check_values::<_, false>(&film, &all);
    let jones = JonesLaw::new(&bearing, RaceControl::Outer).expect("a law");
    check_values::<_, false>(&jones, &all);
    let both = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, OIL, SPEED).expect("a law");
    check_values::<_, false>(&both, &all);
}

#[test]
fn loaded_balls_have_a_table_of_force_and_couple_under_any_race_control() {
    let bearing = bearing("7205C");
    let loaded = [regions(&bearing)[0]];
    for control in [RaceControl::Even, RaceControl::Inner] {
        check_values::<_, true>(&JonesLaw::new(&bearing, control).expect("a law"), &loaded);
        let film = JonesFilmLaw::with_film(&bearing, control, OIL, SPEED).expect("a law");
        check_values::<_, true>(&film, &loaded);
    }
}

/// Where the inner race loses its grip, its friction has a bend that no table follows: it says so.
#[test]
fn a_law_that_is_not_smooth_is_refused() {
    let bearing = bearing("7205C");
    let law = JonesLaw::new(&bearing, RaceControl::Even).expect("a law");
    let unloading = regions(&bearing)[1];
    let table = TableLaw::<_, true>::compile(law, unloading, SPEED, LOAD, TOLERANCE);
    assert!(matches!(table, Err(TableError::Tolerance { .. })));
    let nothing = TableLaw::<_, true>::compile(law, unloading, SPEED, 0.0, TOLERANCE);
    assert!(matches!(nothing, Err(TableError::NoRegion)));
    let narrow = region(&bearing, [30.0, 30.0 + 1e-5], 8.0);
    let nothing = TableLaw::<_, true>::compile(law, narrow, SPEED, LOAD, TOLERANCE);
    assert!(matches!(nothing, Err(TableError::NoRegion)));
}

#[test]
fn the_derivative_is_that_of_the_table_and_close_to_that_of_the_law() {
    let bearing = bearing("7205C");
    let law = JonesFilmLaw::with_film(&bearing, RaceControl::Inner, OIL, SPEED).expect("a law");
    let region = regions(&bearing)[0];
    let (table, _) = compiled::<_, true>(&law, region);
    let (stiffest, step) = (1e8, 1e-10);
    for [axial, radial] in places(region, 300) {
        let (force, tangent) = table.force_and_tangent(axial, radial, SPEED);
        let plain = table.force(axial, radial, SPEED);
        assert!(difference(&force, &plain, 1e-4) < 1e-11 * LOAD);
        let exact = law.force_and_tangent(axial, radial, SPEED).1;
        for (row, arm) in [(0, 1.0), (1, 1.0), (2, 4e-4)] {
            for column in 0..2 {
                let error = (tangent[row][column] - exact[row][column]).abs();
                assert!(error < 1e-6 * arm * stiffest, "{row}, {column}: {error:e}");
            }
        }
        let ahead = table.force(axial, radial + step, SPEED).radial;
        let behind = table.force(axial, radial - step, SPEED).radial;
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
    let (table, _) = compiled::<_, false>(&law, region);
    // the ends of the table are in it, to the bit
    for axial in [-8e-6, -0.0, 0.0, 8e-6] {
        for radial in [region.radial[0], region.radial[1]] {
            let error = difference(
                &table.force(axial, radial, SPEED),
                &law.force(axial, radial, SPEED),
                1.0,
            );
            assert!(table.covers(axial, radial, SPEED));
            assert!(error <= TOLERANCE * LOAD);
        }
    }
    for [axial, radial] in places(region, 500) {
        let [here, there] = [axial, -axial].map(|axial| table.force(axial, radial, SPEED));
        assert_eq!(here.axial, -there.axial);
        assert_eq!(here.radial, there.radial);
        let exact = law.force(axial, radial, SPEED);
        assert!(difference(&here, &exact, 1.0) <= TOLERANCE * LOAD);
    }
}

#[test]
fn outside_the_region_and_at_other_speeds_the_law_itself_answers() {
    let bearing = bearing("7205C");
    let law = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, OIL, SPEED).expect("a law");
    let region = regions(&bearing)[0];
    let (table, _) = compiled::<_, false>(&law, region);
    let [axial, radial] = [region.axial[1], region.radial[1]];
    for (axial, radial, speed) in [
        (axial + 1e-9, radial, SPEED),
        (region.axial[0] - 1e-9, radial, SPEED),
        (axial, region.radial[0] - 1e-9, SPEED),
        (axial, radial + 1e-5, SPEED),
        (axial, radial, 999.0),
    ] {
        assert!(!table.covers(axial, radial, speed));
        let exact = law.force_and_tangent(axial, radial, speed);
        assert_eq!(table.force(axial, radial, speed), exact.0);
        assert_eq!(table.force_and_tangent(axial, radial, speed), exact);
    }
    assert!(!table.covers(f64::NAN, radial, SPEED) && !table.covers(axial, f64::NAN, SPEED));
    // a ball outside leaves the others where they are
    let places: [f64; 4] = [axial, axial + 1e-5, axial, axial];
    let lanes = dispatch!(Level::new(), simd => {
        let radial = Lanes::splat(simd, radial);
        *table.forces(simd.load_array_f64x4(places), radial, SPEED).axial
    });
    let exact = law.force(places[1], radial, SPEED);
    assert_eq!(lanes[1], exact.axial);
    assert_eq!(lanes[0], table.force(axial, radial, SPEED).axial);
}

#[test]
fn a_ring_of_tables_is_the_ring_of_laws() {
    let bearing = bearing("7205C");
    let law = JonesFilmLaw::with_film(&bearing, RaceControl::Even, OIL, SPEED).expect("a law");
    let (table, _) = compiled::<_, true>(&law, region(&bearing, [25.0, 40.0], 6.0));
    let rings = (
        Ring::new(&bearing.geometry, 0.1, table),
        Ring::new(&bearing.geometry, 0.1, law),
    );
    let (place, cage) = ([2e-6, -3e-6, 32e-6, 4e-5, -7e-5], CageAngle::new(0.7));
    let (own, exact) = (
        rings.0.force(&place, cage, SPEED),
        rings.1.force(&place, cage, SPEED),
    );
    let arm = bearing.geometry.inner_groove_radius();
    for (axis, lever) in [1.0, 1.0, 1.0, arm, arm].into_iter().enumerate() {
        let error = (own[axis] - exact[axis]).abs();
        assert!(error < 12.0 * TOLERANCE * LOAD * lever, "{axis}: {error:e}");
    }
}

/// A light thrust and a radial load: balls unload at every turn of the cage.
fn unloading(law: ContactLaw, oil: Option<Oil>) -> RotorDefinition {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.eccentricity = 1e-5;
    shaft.gravity = true;
    let bearing = jeffcott::bearing::MountedBearing {
        law,
        oil,
        ..mounted(bearing("7205C"))
    };
    RotorDefinition {
        speed: SPEED,
        load: [0.0, -1500.0, 300.0, 0.0, 0.0],
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
fn hertz_contacts_without_film_have_no_table_and_a_varying_speed_none() {
    let hertz = model(unloading(ContactLaw::Hertz, None), 0.001, 20_000.0);
    let (_, [own, _]) = table_and_exact(hertz);
    assert_eq!(own.tables, [None]);
    let mut run_up = unloading(ContactLaw::Jones(RaceControl::Outer), None);
    run_up.speed_points = vec![jeffcott::rotor::SpeedPoint {
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
    definition.load = [0.0, 0.0, 150.0, 0.0, 0.0];
    definition.damping = Damping::Undamped;
    definition.cage = jeffcott::rotor::CageMotion::Frozen;
    definition.initial.displacement[0] = Some(3e-6);
    let mut model = model(definition, 0.05, 20_000.0);
    model.integrator = settings(1e-11);
    model.energy = true;
    for table in [true, false] {
        model.table = table;
        let run = simulate_into(&model, &mut crate::support::Collector::default());
        let energy = run.expect("it runs").energy.expect("an account");
        assert!(energy.conservative);
        assert!(energy.relative_residual < 1e-8, "{energy:?}");
    }
}
