//! Instructions of the hot parts, against the committed table `benches/instructions.csv`.
//!
//! `cargo bench --bench instructions` counts them with Valgrind, where that is installed: unlike times,
//! counts are the same on a busy machine. Set `JEFFCOTT_KEEP_INSTRUCTIONS=1` to write the table anew.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;

use jeffcott::bearing::{CageAngle, HertzLaw, Ring, catalogue};
use jeffcott::integrate::System;
use jeffcott::rotor::{Freedoms, Rotor};
use jeffcott::scenario;
use jeffcott::simulate::Model;

/// A hot part: what it is, and what calls it so many times.
type Part = (&'static str, fn(u64));

const PARTS: [Part; 7] = [
    ("ring of 12, hertz", ring),
    ("right-hand side, linear, 3 freedoms", |calls| {
        right_hand_side::<6>("linear-7205c.toml", Freedoms::Translational, calls);
    }),
    ("right-hand side, 12 balls, hertz, 2 freedoms", |calls| {
        right_hand_side::<4>("steady-7205c.toml", Freedoms::Radial, calls);
    }),
    ("right-hand side, 12 balls, hertz, 3 freedoms", |calls| {
        right_hand_side::<6>("steady-7205c.toml", Freedoms::Translational, calls);
    }),
    ("right-hand side, 12 balls, hertz, 5 freedoms", |calls| {
        right_hand_side::<10>("steady-7205c.toml", Freedoms::All, calls);
    }),
    ("right-hand side, pair of 12, hertz, 5 freedoms", |calls| {
        right_hand_side::<10>("back-to-back-7205c.toml", Freedoms::All, calls);
    }),
    ("right-hand side, 12 balls, jones and film", |calls| {
        right_hand_side::<6>("bearing-7205c.toml", Freedoms::Translational, calls);
    }),
];

/// Calls of the short and the long run; their difference is free of what comes before and after.
const CALLS: [u64; 2] = [200, 1200];

fn ring(calls: u64) {
    let bearing = catalogue::find("7205C").expect("in the catalogue");
    let bearing = bearing.bearing().expect("a bearing");
    let law = HertzLaw {
        load_deflection_constant: bearing.load_deflection_constant().expect("a contact"),
        distance: bearing.geometry.groove_centre_distance(),
    };
    let ring = Ring::new(&bearing.geometry, 0.0, law);
    let (place, cage) = ([1e-7, -2e-7, 32e-6, 1e-6, 2e-6], CageAngle::new(0.3));
    for _ in 0..calls {
        black_box(ring.force(black_box(&place), black_box(cage), 0.0));
    }
}

fn right_hand_side<const N: usize>(name: &str, freedoms: Freedoms, calls: u64) {
    let mut model = model(name);
    model.rotor.shaft.freedoms = freedoms;
    model.rotor.shaft.inertia_transverse = 0.01;
    model.rotor.shaft.inertia_polar = 0.004;
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let place = rotor.equilibrium().displacement;
    let state: [f64; N] = std::array::from_fn(|i| if i < N / 2 { place[i] } else { 1e-4 });
    let mut rate = [0.0; N];
    for call in 0..calls {
        let time = 1e-5 * call as f64;
        System::<N>::derivative(&rotor, black_box(time), black_box(&state), &mut rate);
        black_box(&rate);
    }
}

fn model(name: &str) -> Model {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let scenario = scenario::load(&file.join(name)).expect("a shipped scenario");
    scenario.model.expect("a motion")
}

/// Instructions of this program when it makes so many calls of a part; none without Valgrind.
fn count(part: usize, calls: u64) -> Option<u64> {
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no"])
        .arg("--cachegrind-out-file=/dev/null")
        .arg(env::current_exe().ok()?)
        .args(["--part", &part.to_string(), &calls.to_string()])
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text
        .lines()
        .find(|line| line.contains("I ") && line.contains("refs:"))?;
    let digits: String = line
        .rsplit(':')
        .next()?
        .chars()
        .filter(char::is_ascii_digit)
        .collect();
    digits.parse().ok()
}

fn per_call(part: usize) -> Option<u64> {
    let [few, many] = CALLS;
    Some((count(part, many)? - count(part, few)?) / (many - few))
}

fn table() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/instructions.csv")
}

/// Instructions of a part as they are kept.
fn kept(table: &str, name: &str) -> Option<u64> {
    let row = |line: &str| {
        let (part, number) = line.rsplit_once(',')?;
        (part.trim_matches('"') == name).then(|| number.parse().ok())?
    };
    table.lines().find_map(row)
}

fn main() {
    let arguments: Vec<String> = env::args().collect();
    if let [_, flag, part, calls] = &arguments[..]
        && flag == "--part"
    {
        let part: usize = part.parse().expect("the number of a part");
        return PARTS[part].1(calls.parse().expect("a number of calls"));
    }
    let before = fs::read_to_string(table()).unwrap_or_default();
    let mut now = "part,instructions\n".to_owned();
    for (number, (name, _)) in PARTS.iter().enumerate() {
        let Some(count) = per_call(number) else {
            println!("no instructions counted: Valgrind is not there");
            return;
        };
        let change = kept(&before, name).map(|kept| 100.0 * (count as f64 / kept as f64 - 1.0));
        let change = change.map_or("new".to_owned(), |change| format!("{change:+.1} %"));
        println!("{name:<50} {count:>8} {change:>8}");
        writeln!(now, "\"{name}\",{count}").expect("a String takes everything");
    }
    if env::var_os("JEFFCOTT_KEEP_INSTRUCTIONS").is_some() {
        fs::write(table(), now).expect("the table can be written");
    }
}
