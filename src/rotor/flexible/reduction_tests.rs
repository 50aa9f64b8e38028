//! The element and its reduction against book cases, by the eigenvalues of a rotor on linear springs.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix};

use super::*;
use crate::physics::{BeamElement, Material};
use crate::rotor::flexible::{Disc, FlexibleShaft};

/// Of the book cases: G = 81.2 GPa.
const STEEL: Material = Material {
    youngs_modulus: 211e9,
    poisson_ratio: 211.0 / (2.0 * 81.2) - 1.0,
    density: 7810.0,
};

/// A shaft of 1.5 m and 50 mm with discs at its thirds.
///
/// Source: Friswell et al., *Dynamics of Rotating Machines* (2010), example 5.9.1.
fn book_shaft() -> FlexibleShaft {
    FlexibleShaft {
        sections: vec![BeamElement {
            length: 1.5,
            outer_diameter: 0.05,
            inner_diameter: 0.0,
            material: STEEL,
        }],
        discs: [(0.5, 0.28), (1.0, 0.35)]
            .map(|(position, diameter)| Disc::of_size(position, 0.07, [diameter, 0.05], 7810.0))
            .to_vec(),
        ..FlexibleShaft::default()
    }
}

/// Whirl frequencies of a plane laid out twice, on springs at some of its deflections, lowest first, rad/s.
fn whirl(plane: &Plane, springs: &[(usize, f64)], speed: f64) -> Vec<f64> {
    let size = plane.mass.nrows();
    let mut stiffness = plane.stiffness.clone();
    for (deflection, spring) in springs {
        stiffness[(*deflection, *deflection)] += spring;
    }
    // with u = x, v = y as deflection and slope of both planes: M ü + ω P v̇ + K u = 0, M v̈ − ω P u̇ + K v = 0; of
    // u + i v with frequency s this is one complex problem
    let mass = plane.mass.clone().cholesky().expect("a mass matrix").l();
    let normal = |matrix: &DMatrix<f64>| {
        let half = mass.solve_lower_triangular(matrix).expect("solved");
        mass.solve_lower_triangular(&half.transpose())
            .expect("solved")
    };
    let (stiffness, polar) = (normal(&stiffness), normal(&plane.polar));
    // w = u + i v: ẅ − i ω P ẇ + K w = 0; w ~ e^{i s t}: −s² + ω P s + K = 0, a real problem in s
    // in units of the highest frequency, so that no digits are lost
    let unit = stiffness.diagonal().amax().sqrt();
    let mut matrix = DMatrix::zeros(2 * size, 2 * size);
    matrix.view_mut((0, size), (size, size)).fill_diagonal(unit);
    matrix
        .view_mut((size, 0), (size, size))
        .copy_from(&(stiffness / unit));
    matrix
        .view_mut((size, size), (size, size))
        .copy_from(&(polar * speed));
    let values: Vec<Complex<f64>> = matrix.complex_eigenvalues().iter().copied().collect();
    let mut frequencies: Vec<f64> = values.iter().map(|value| value.re.abs()).collect();
    frequencies.sort_by(f64::total_cmp);
    frequencies
}

fn near(found: &[f64], expected: &[f64], relative: f64) {
    for (found, expected) in found.iter().zip(expected) {
        let apart = (found / expected - 1.0).abs();
        assert!(apart <= relative, "{found}, not {expected}: {apart:.1e}");
    }
}

/// As printed, where the last of the `decimals` may be cut or rounded.
fn printed(found: &[f64], expected: &[f64], decimals: i32) {
    for (found, expected) in found.iter().zip(expected) {
        let apart = (found - expected).abs();
        assert!(apart <= 10f64.powi(-decimals), "{found}, not {expected}");
    }
}

#[test]
fn six_elements_have_the_whirl_frequencies_of_the_book() {
    let shaft = book_shaft();
    let mesh = shaft.mesh(&[0.0, 1.5], Some(0.25)).expect("a mesh");
    assert_eq!(mesh.nodes.len(), 7);
    let springs = [(0, 1e6), (12, 1e6)];
    let standing = [86.658, 86.658, 274.313, 274.313, 716.786, 716.786, 1066.156];
    printed(&whirl(&mesh.plane, &springs, 0.0), &standing, 3);
    let turning = [
        85.389, 87.796, 251.785, 294.713, 600.179, 827.075, 1038.996, 1088.193,
    ];
    let speed = 4000.0 / 60.0 * TAU;
    printed(&whirl(&mesh.plane, &springs, speed), &turning, 3);
    let fine = shaft.mesh(&[0.0, 1.5], Some(1.5 / 48.0)).expect("a mesh");
    let springs = [(0, 1e6), (2 * (fine.nodes.len() - 1), 1e6)];
    printed(
        &whirl(&fine.plane, &springs, speed)[4..],
        &[600.082, 826.659],
        3,
    );
}

#[test]
fn a_pinned_shaft_vibrates_a_little_slower_than_eulers() {
    let shaft = FlexibleShaft {
        sections: vec![BeamElement {
            length: 1.0,
            outer_diameter: 0.025,
            inner_diameter: 0.0,
            material: STEEL,
        }],
        ..FlexibleShaft::default()
    };
    let mesh = shaft.mesh(&[], None).expect("a mesh");
    let last = 2 * (mesh.nodes.len() - 1);
    let frequencies = whirl(&mesh.plane, &[(0, 1e13), (last, 1e11)], 0.0);
    let hertz: Vec<f64> = frequencies.iter().map(|value| value / TAU).collect();
    printed(&hertz[..1], &[50.990], 3);
    printed(&[hertz[2], hertz[4]], &[203.50, 456.18], 2);
}

#[test]
fn a_reduction_errs_as_its_modes_allow_and_not_in_statics() {
    let mesh = book_shaft().mesh(&[0.0, 1.5], None).expect("a mesh");
    let speed = 4000.0 / 60.0 * TAU;
    let last = 2 * (mesh.nodes.len() - 1);
    let exact = whirl(&mesh.plane, &[(0, 1e8), (last, 1e8)], speed);
    // largest errors of whirl frequencies 1–2, 3–4 and 5–6, independently found
    let bounds = [
        (2, [1.3e-3, 4.7e-3, 1.0]),
        (4, [2e-5, 8e-5, 3e-3]),
        (6, [8e-6, 3e-6, 7e-4]),
    ];
    for (modes, bounds) in bounds {
        let plane = mesh
            .clone()
            .reduced(&[0.0, 1.5], |_| modes)
            .expect("a reduction")
            .plane;
        assert_eq!(plane.mass.nrows(), 4 + modes);
        let found = whirl(&plane, &[(0, 1e8), (2, 1e8)], speed);
        for (pair, bound) in bounds.into_iter().enumerate() {
            let error = |at: usize| (found[at] / exact[at] - 1.0).abs();
            let largest = error(2 * pair).max(error(2 * pair + 1));
            assert!(
                largest < 2.0 * bound,
                "{modes} modes, pair {pair}: {largest:.2e}"
            );
        }
    }
    // a force at a point that is kept
    let points = [0.0, 0.6, 1.5];
    let mesh = book_shaft().mesh(&points, None).expect("a mesh");
    let compliance = |plane: &Plane, ends: [usize; 2], at: usize| {
        let mut stiffness = plane.stiffness.clone();
        for end in ends {
            stiffness[(end, end)] += 1e7;
        }
        let inverse = stiffness.try_inverse().expect("held");
        inverse[(at, at)]
    };
    let last = 2 * (mesh.nodes.len() - 1);
    let whole = compliance(&mesh.plane, [0, last], 2 * mesh.node_at(0.6));
    let few = compliance(
        &mesh.reduced(&points, |_| 1).expect("a reduction").plane,
        [0, 4],
        2,
    );
    near(&[few], &[whole], 1e-8);
}

/// Pinned at its ends, with a hub in the middle: both ends bend and shear as cantilevers clamped there.
#[test]
fn a_hub_leaves_the_shaft_beside_it_to_bend() {
    let (length, width, diameter): (f64, f64, f64) = (1.0, 0.3, 0.03);
    let section = BeamElement {
        length,
        outer_diameter: diameter,
        inner_diameter: 0.0,
        material: STEEL,
    };
    let disc = Disc::of_size(0.5, width, [0.2, diameter], 7810.0);
    let shaft = FlexibleShaft {
        sections: vec![section],
        discs: vec![Disc {
            hub_width: width,
            ..disc
        }],
        observed: 0.5,
        ..FlexibleShaft::default()
    };
    let points = [0.0, 0.5, 1.0];
    let mesh = shaft.mesh(&points, None).expect("a mesh");
    let reduced = mesh.reduced(&points, |_| 3).expect("a reduction");
    let all = reduced.plane.stiffness.nrows();
    // deflections of the ends are held
    let free: Vec<usize> = (0..all).filter(|row| ![0, 4].contains(row)).collect();
    let stiffness = reduced.plane.stiffness.select_rows(&free);
    let compliance = stiffness.select_columns(&free).try_inverse();
    let compliance = compliance.expect("held");
    let (end, nu) = (0.5 * (length - width), STEEL.poisson_ratio);
    let shear = STEEL.youngs_modulus / (2.0 * (1.0 + nu)) * section.area() * 6.0 * (1.0 + nu)
        / (7.0 + 6.0 * nu);
    let bending = STEEL.youngs_modulus * section.second_moment();
    let tip = end.powi(3) / (3.0 * bending) + end / shear;
    near(&[compliance[(1, 1)]], &[0.5 * tip], 1e-8);
    near(&[compliance[(2, 2)]], &[2.0 * tip / length.powi(2)], 1e-8);
    // the hub is straight, and the shaft within it has its mass
    let rows = reduced
        .nodes
        .iter()
        .zip(reduced.transformation.row_iter().step_by(2));
    for (at, row) in rows.filter(|(at, _)| (**at - 0.5).abs() < 0.15) {
        assert!((row[2] - 1.0).abs() < 1e-12 && (row[3] - at + 0.5).abs() < 1e-12);
    }
    let along: Vec<f64> = [1.0, 0.0, 1.0, 0.0, 1.0, 0.0]
        .into_iter()
        .chain([0.0; 3])
        .collect();
    let along = nalgebra::DVector::from_vec(along);
    let mass = (&reduced.plane.mass * &along).dot(&along);
    near(&[mass], &[shaft.mass()], 1e-9);
}

#[test]
fn a_rigid_motion_has_the_inertia_of_the_whole_shaft() {
    let shaft = book_shaft();
    let points = [0.2, 1.1];
    let plane = shaft
        .mesh(&points, None)
        .expect("a mesh")
        .reduced(&points, |_| 3)
        .expect("a reduction")
        .plane;
    let along: Vec<f64> = [1.0, 0.0, 1.0, 0.0].into_iter().chain([0.0; 3]).collect();
    let along = nalgebra::DVector::from_vec(along);
    near(&[(&plane.mass * &along).dot(&along)], &[shaft.mass()], 1e-9);
    let tilt: Vec<f64> = [0.2, 1.0, 1.1, 1.0].into_iter().chain([0.0; 3]).collect();
    let tilt = nalgebra::DVector::from_vec(tilt);
    near(
        &[(&plane.polar * &tilt).dot(&tilt)],
        &[shaft.inertia_polar()],
        1e-9,
    );
    let energy = (&plane.stiffness * &tilt).norm() / plane.stiffness.norm();
    assert!(
        energy < 1e-9,
        "a rigid motion strains the shaft by {energy:e}"
    );
}

/// Rows of numbers of the table in the chapter on shafts that bend whose header begins so.
fn documented(header: &str) -> Vec<Vec<f64>> {
    let chapter = include_str!("../../../docs/flexible-shafts.md");
    let rows = chapter.lines().skip_while(|line| !line.starts_with(header));
    let rows = rows.skip(2).take_while(|line| line.starts_with('|'));
    let numbers = |row: &str| {
        let cells = row.trim_matches('|').split('|');
        cells
            .map(|cell| cell.trim().parse().expect("a number"))
            .collect()
    };
    rows.map(numbers).collect()
}

/// The largest relative difference of whirl frequencies 1–2, 3–4 and 5–6.
fn differences(found: &[f64], expected: &[f64]) -> Vec<f64> {
    let pairs = found.chunks(2).zip(expected.chunks(2)).take(3);
    let apart = |(found, expected): (&f64, &f64)| (found / expected - 1.0).abs();
    pairs
        .map(|(found, expected)| found.iter().zip(expected).map(apart).fold(0.0, f64::max))
        .collect()
}

fn as_documented(row: &[f64], found: &[f64]) {
    for (written, found) in row[1..].iter().zip(found) {
        // two digits are written
        assert!(
            (found / written - 1.0).abs() < 0.1,
            "{found:.1e} beside {row:?}"
        );
    }
}

#[test]
fn frequencies_converge_over_modes_as_the_chapter_says() {
    let points = [0.0, 1.0, 1.5];
    let mesh = book_shaft().mesh(&points, None).expect("a mesh");
    let with = |modes: usize| {
        let plane = mesh
            .clone()
            .reduced(&points, |_| modes)
            .expect("a reduction")
            .plane;
        whirl(&plane, &[(0, 1e8), (4, 1e8)], 0.0)
    };
    let exact = with(30);
    let table = documented("| modes a plane | 1st pair");
    assert!(table.len() >= 4);
    for row in table {
        as_documented(&row, &differences(&with(row[0] as usize), &exact));
    }
}

#[test]
fn frequencies_converge_over_elements_as_the_chapter_says() {
    let with = |elements: f64| {
        let mesh = book_shaft()
            .mesh(&[0.0, 1.5], Some(1.5 / elements * (1.0 + 1e-9)))
            .expect("a mesh");
        let last = 2 * (mesh.nodes.len() - 1);
        whirl(&mesh.plane, &[(0, 1e6), (last, 1e6)], 4000.0 / 60.0 * TAU)
    };
    let exact = with(96.0);
    let table = documented("| elements | 1st pair");
    assert!(table.len() >= 3);
    for row in table {
        as_documented(&row, &differences(&with(row[0]), &exact));
    }
}
