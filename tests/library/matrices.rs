//! The exported matrices: their eigenvalues, receptances and files against the answers of the shaft itself.

use std::f64::consts::TAU;

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix};

use crate::ask::MatricesQuestion;
use crate::rotor::{Pickup, Rotor};
use crate::scenario::position;
use crate::tests::support::scenario;

/// A rigid shaft that tilts, on a film by coefficients that drive a whirl, a squeeze film and springs off its middle.
const RIGID: &str = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"lateral\"\ninertia_transverse = \"0.05 kg m^2\"\ninertia_polar = \"0.03 kg m^2\"\n\
                     [speed]\nconstant = \"6000 rpm\"\n[[element]]\nposition = \"-80 mm\"\nlinear = { stiffness = { x = \"4 N/um\", y = \"5 \
                     N/um\", xy = \"1 N/um\", yx = \"-1 N/um\" }, damping = { x = \"400 N s/m\", y = \"300 N s/m\" } }\n[[element]]\nposition \
                     = \"100 mm\"\nlinear = { stiffness = { x = \"2 N/um\", y = \"2 N/um\" } }\n[[element]]\nposition = \"100 \
                     mm\"\nsqueeze_film = { diameter = \"100 mm\", length = \"20 mm\", clearance = \"0.1 mm\", viscosity = \"5 mPa s\" }\n";
/// A shaft that bends and damps itself, on balls in a housing and on springs.
const BENDING: &str = r#"
[shaft]
internal_damping = "5 us"
[[shaft.section]]
length = "500 mm"
outer_diameter = "30 mm"
[[disc]]
position = "200 mm"
outer_diameter = "200 mm"
width = "40 mm"
[[bearing]]
catalogue = "7205C"
position = "20 mm"
preload = "200 N"
[bearing.housing]
mass = "3 kg"
stiffness = { x = "50 N/um", y = "80 N/um", z = "60 N/um" }
damping = { x = "500 N s/m", y = "500 N s/m" }
[[element]]
position = "480 mm"
linear = { stiffness = { x = "10 N/um", y = "10 N/um" } }
[[load]]
constant = { z = "100 N" }
position = "0 mm"
[damping]
ratio = 0.02
[speed]
constant = "9000 rpm"
"#;

/// λ of the modes and of A; (K − ω² M + iω (C + ΩG))⁻¹ and the receptances.
#[test]
fn matrices_have_the_modes_and_receptances_of_the_shaft() {
    for (text, names) in [
        (RIGID, ["x", "tilt_y"]),
        (
            BENDING,
            [
                "y of the shaft at 480.0 mm",
                "tilt_x of the shaft at 20.0 mm",
            ],
        ),
    ] {
        let rotor = Rotor::assemble(&scenario(text).question.rotor).expect("a rotor");
        let found = rotor.linear_matrices();
        // units of very different size, which other programs balance by themselves
        let mut balanced = found.state.clone();
        balance_parlett_reinsch(&mut balanced);
        let eigenvalues = balanced.complex_eigenvalues();
        let modes = rotor.modes();
        assert!(modes.len() > 1);
        let largest = eigenvalues.iter().map(|own| own.norm()).fold(0.0, f64::max);
        for mode in modes {
            let apart = eigenvalues.iter().map(|own| (own - mode.eigenvalue).norm());
            let nearest = apart.fold(f64::INFINITY, f64::min);
            // what the largest eigenvalue rounds
            let room = 1e-9 * mode.eigenvalue.norm() + 1e-14 * largest;
            assert!(nearest < room, "{nearest:e} of {}", mode.eigenvalue);
        }
        assert!(found.stiffness != found.stiffness.transpose(), "{text}");
        let index = |name: &str| {
            let known = found.coordinates.iter().position(|own| own.0 == name);
            known.unwrap_or_else(|| panic!("{name} among {:?}", found.coordinates))
        };
        let [at, by] = names.map(index);
        let pickup = |name: &str| {
            let position = name.split(" at ").nth(1).map_or(0.0, |text| {
                1e-3 * text
                    .trim_end_matches(" mm")
                    .parse::<f64>()
                    .expect("a number")
            });
            let axis = ["x", "y", "z", "tilt_x", "tilt_y"];
            let axis = axis
                .iter()
                .position(|own| Some(*own) == name.split(' ').next());
            Pickup {
                position,
                axis: axis.expect("an axis"),
            }
        };
        for omega in [60.0 * TAU, 400.0 * TAU] {
            let rate = &found.damping + &found.gyroscopic * found.speed;
            let dynamic = DMatrix::from_fn(rate.nrows(), rate.ncols(), |row, column| {
                let place = found.stiffness[(row, column)];
                let inertia = omega * omega * found.mass[(row, column)];
                Complex::new(place - inertia, omega * rate[(row, column)])
            });
            let receptance = dynamic.try_inverse().expect("damped")[(at, by)];
            let [at, by] = names.map(pickup);
            let model = rotor.linear_model();
            let expected = model.to_force(omega, by, &[at]).expect("damped")[0];
            assert!(
                (receptance - expected).norm() < 1e-9 * expected.norm(),
                "{receptance} {expected}"
            );
        }
    }
}

/// The archive of arrays, by its own directory: shapes and numbers of what stands in it.
#[test]
fn arrays_are_read_back() {
    let scenario = scenario(BENDING);
    let question = MatricesQuestion::new(&scenario, &[0.3], None).expect("a question");
    let folder = tempfile::tempdir().expect("a folder");
    let findings = question.answer().expect("matrices");
    findings.write(folder.path()).expect("files");
    let archive = std::fs::read(folder.path().join("matrices.npz")).expect("an archive");
    let word = |at: usize, bytes: usize| {
        let own = archive[at..at + bytes].iter().rev();
        own.fold(0_usize, |sum, byte| 256 * sum + *byte as usize)
    };
    let end = archive.len() - 22;
    assert_eq!(archive[end..end + 4], *b"PK\x05\x06");
    let (count, mut entry) = (word(end + 10, 2), word(end + 16, 4));
    let mut names = Vec::new();
    let csv = std::fs::read_to_string(folder.path().join("stiffness.csv")).expect("a table");
    let rows: Vec<Vec<f64>> = csv
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .map(|own| own.parse().expect("a number"))
                .collect()
        })
        .collect();
    for _ in 0..count {
        assert_eq!(archive[entry..entry + 4], *b"PK\x01\x02");
        let (crc, size, length) = (
            word(entry + 16, 4),
            word(entry + 24, 4),
            word(entry + 28, 2),
        );
        let name = String::from_utf8_lossy(&archive[entry + 46..entry + 46 + length]);
        let local = word(entry + 42, 4);
        let file = &archive[local + 30 + length..][..size];
        assert_eq!(crc32fast::hash(file) as usize, crc, "{name}");
        assert_eq!(file[..8], *b"\x93NUMPY\x01\x00");
        if name == "K.npy" {
            let header = 10 + u16::from_le_bytes([file[8], file[9]]) as usize;
            assert_eq!(header % 64, 0);
            let said = String::from_utf8_lossy(&file[10..header]);
            let shape = format!("'shape': ({}, {}), }}", rows.len(), rows.len());
            assert!(said.contains(&shape) && said.ends_with('\n'), "{said}");
            let numbers = file[header..].chunks_exact(8);
            for (index, bytes) in numbers.enumerate() {
                let own = f64::from_le_bytes(bytes.try_into().expect("eight bytes"));
                assert_eq!(own, rows[index % rows.len()][index / rows.len()]);
            }
        }
        names.push(name.into_owned());
        entry += 46 + length;
    }
    assert_eq!(names.len(), 8, "{names:?}");
    assert!(csv.starts_with("x_of_the_shaft_at_"), "{csv}");
    assert!(position("y@250 mm").is_err());
    let refused = MatricesQuestion::new(&scenario, &[0.6], None);
    assert!(refused.is_err());
}
