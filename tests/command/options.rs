//! Options that all verbs share: what is told, in which colours, from which input, and where it is shown.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Output, Stdio};

use crate::support::{done, jeffcott, jeffcott_in, loaded_7205c, text, told};

fn folder_with(name: &str, scenario: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), scenario).unwrap();
    folder
}

fn scenario() -> String {
    loaded_7205c("contact = \"hertz\"", "")
}

/// What the command says to arguments and a text on standard input.
fn fed(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = jeffcott()
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let stdin = child.stdin.take();
    stdin.unwrap().write_all(input.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn a_scenario_comes_from_standard_input_in_either_language() {
    let folder = tempfile::tempdir().unwrap();
    let toml = scenario();
    let table: toml::Table = toml.parse().unwrap();
    let json = serde_json::to_string(&table).unwrap();
    for input in [&toml, &json] {
        let output = done(fed(folder.path(), &["check", "-"], input));
        assert!(text(&output.stdout).starts_with("stdin: ok, stdin"));
    }
    done(fed(folder.path(), &["bearing", "-"], &toml));
    assert!(folder.path().join("output/stdin/bearing.json").exists());
    let wrong = fed(folder.path(), &["check", "-"], "[shaft]\nmass = 5\n");
    assert_eq!(wrong.status.code(), Some(2));
    assert!(told(&wrong).contains("stdin:2:8"), "{}", told(&wrong));
}

#[test]
fn a_record_or_its_description_comes_from_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let rows = (0..64).map(|n| format!("{},{}\n", f64::from(n) / 64.0, n % 7));
    let table = format!("time [s],a [g]\n{}", rows.collect::<String>());
    fs::write(folder.path().join("a.csv"), &table).unwrap();
    let list = done(fed(folder.path(), &["analyze", "-", "--list"], &table));
    assert!(text(&list.stdout).contains(" a "), "{list:?}");
    for input in [&table, "[record]\nfile = \"a.csv\"\n"] {
        done(fed(folder.path(), &["analyze", "-"], input));
        let document = folder.path().join("output/stdin/record.json");
        fs::remove_file(document).unwrap();
    }
}

#[test]
fn quiet_says_nothing_and_verbose_says_how() {
    let folder = folder_with("a.toml", &scenario());
    let quiet = done(jeffcott_in(&folder, &["run", "a.toml", "-q"]));
    assert!(quiet.stdout.is_empty() && !told(&quiet).contains("done in"));
    let json = done(jeffcott_in(&folder, &["run", "a.toml", "-q", "--json"]));
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert!(json["files"].is_array());
    let plain = text(&done(jeffcott_in(&folder, &["run", "a.toml"])).stdout);
    let verbose = text(&done(jeffcott_in(&folder, &["run", "a.toml", "-v"])).stdout);
    for detail in ["  integration", "  method", "--no-verify saves them"] {
        assert!(verbose.contains(detail), "{detail} in\n{verbose}");
        assert!(!plain.contains(detail), "{detail} in\n{plain}");
    }
    assert_eq!(plain.matches("wrote").count(), 1, "{plain}");
    let both = jeffcott_in(&folder, &["run", "a.toml", "-q", "-v"]);
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn colours_are_as_asked_for() {
    let folder = folder_with("a.toml", "title = 5\n");
    let told = |color: &str| {
        let arguments = ["check", "a.toml", "--color", color];
        told(&jeffcott_in(&folder, &arguments))
    };
    assert!(told("always").contains("\u{1b}["));
    assert!(!told("never").contains('\u{1b}'));
    // here stderr is no terminal
    assert!(!told("auto").contains('\u{1b}'));
}

#[test]
fn a_browser_is_told_the_page_or_the_reader_where_it_is() {
    let folder = folder_with("a.toml", &scenario());
    let opened = |browser: &str| {
        let mut command = jeffcott();
        command.args(["run", "a.toml", "--open", "--no-verify"]);
        let output = command
            .current_dir(&folder)
            .env("BROWSER", browser)
            .output();
        told(&done(output.unwrap()))
    };
    assert!(!opened("true").contains("does not open"));
    for browser in ["false", "no-such-browser"] {
        let told = opened(browser);
        assert!(told.contains("does not open the page"), "{told}");
        assert!(
            told.contains("open output/a/report.html in a browser"),
            "{told}"
        );
    }
}

#[test]
fn orders_of_bearings_mix_with_numbers() {
    let scene = loaded_7205c("contact = \"hertz\"\ncage = \"rolling\"", "");
    let folder = folder_with("a.toml", &scene);
    let arguments = "campbell a.toml --to 60000rpm --count 5 --json --orders 1,bpfo,BPFI,ftf,bsf";
    let output = done(jeffcott_in(
        &folder,
        &arguments.split(' ').collect::<Vec<_>>(),
    ));
    let campbell: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let orders = campbell["orders"].as_array().unwrap();
    let orders: Vec<f64> = orders.iter().filter_map(|order| order.as_f64()).collect();
    // 12 balls of 7.938 mm on 38.5 mm at 15 degrees
    let gamma = 7.938 / 38.5 * 15_f64.to_radians().cos();
    let cage = 0.5 * (1.0 - gamma);
    let spin = 38.5 / (2.0 * 7.938) * (1.0 - gamma * gamma);
    let expected = [1.0, 12.0 * cage, 12.0 * (1.0 - cage), cage, spin];
    assert_eq!(orders.len(), expected.len());
    for (order, expected) in orders.iter().zip(expected) {
        assert!((order - expected).abs() < 1e-12, "{order} {expected}");
    }
    let named = &campbell["orders_of_bearings"][0];
    let named = named.as_str().unwrap();
    assert!(named.starts_with("BPFO of bearing 1 is order 4.80"));
    let wrong = jeffcott_in(
        &folder,
        &["campbell", "a.toml", "--to", "9rpm", "--orders", "x"],
    );
    assert_eq!(wrong.status.code(), Some(2));
}

/// A negative quantity is a value of its option, of which the range says what is wrong, and no unknown option.
#[test]
fn negative_quantities_come_to_their_checks() {
    let folder = folder_with("a.toml", &scenario());
    fs::write(folder.path().join("a.csv"), "t [s],a [g]\n0,1\n1,2\n2,3\n").unwrap();
    for (arguments, option) in [
        ("analyze a.csv", "duration=-2 s"),
        ("analyze a.csv", "speed=-3000 rpm"),
        ("new -", "mass=-3 kg"),
        ("new -", "speed=-3000 rpm"),
        ("campbell a.toml", "to=-1 rpm"),
        ("response a.toml --at 0mm --to 9rpm", "from=-1 rpm"),
        (
            "estimate --outside-diameter 9mm --dynamic 1N --static 1N",
            "bore=-1 mm",
        ),
    ] {
        let (name, value) = option.split_once('=').unwrap();
        let option = format!("--{name}");
        let all: Vec<&str> = arguments.split(' ').chain([&option[..], value]).collect();
        let output = jeffcott_in(&folder, &all);
        let told = told(&output);
        assert_eq!(output.status.code(), Some(2), "{all:?}: {told}");
        assert!(
            told.contains(value) && !told.contains("unexpected"),
            "{told}"
        );
    }
}

#[test]
fn check_warns_of_what_a_run_would_find_out_late() {
    let fast = scenario().replace("500 rad/s", "300000 rpm");
    let still = scenario().replace("ratio = 0.02", "ratio = 0");
    for (scenario, key, remedy) in [
        (
            fast,
            "contact = \"hertz\" leaves out",
            "contact = \"jones\"",
        ),
        (still, "`damping.ratio` is 0", "ratio = 0.02 to 0.04"),
    ] {
        let folder = folder_with("a.toml", &scenario);
        let told = told(&done(jeffcott_in(&folder, &["check", "a.toml"])));
        assert!(told.contains(key) && told.contains(remedy), "{told}");
    }
}
