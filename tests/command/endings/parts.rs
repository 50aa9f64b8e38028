//! A run in parts is the run in one go, byte by byte.

use super::scene::{Scene, finely_sampled};

/// Names of the files that differ, with which of the two has them.
#[track_caller]
fn assert_same(name: &str, parts: &Scene, whole: &Scene) {
    let (parts, whole) = (parts.results(), whole.results());
    assert!(whole.len() >= 5, "{:?}", whole.keys());
    assert_eq!(
        parts.keys().collect::<Vec<_>>(),
        whole.keys().collect::<Vec<_>>(),
        "{name}"
    );
    for (file, bytes) in whole {
        assert!(parts[&file] == bytes, "{name}: {file} differs");
    }
}

/// Runs a scenario in one go and, one part after the other, up to every one of `stops`.
fn check(name: &str, scenario: &str, stops: &[&str]) {
    let (whole, parts) = (Scene::new(scenario), Scene::new(scenario));
    whole.run(&[]).done();
    for (index, stop) in stops.iter().enumerate() {
        let resume: &[&str] = if index == 0 { &[] } else { &["--resume"] };
        let said = parts.run(&[&["--stop-at", stop], resume].concat());
        assert!(said.done().stdout.contains("restart.bin"), "{name}, {stop}");
        let left: Vec<String> = parts.results().into_keys().collect();
        assert_eq!(left, ["restart.bin"], "{name}, {stop}");
    }
    parts.run(&["--resume"]).done();
    assert_same(name, &parts, &whole);
}

#[test]
fn a_steady_run_with_ball_passes() {
    let text = finely_sampled("steady-7205c");
    // before the first sample, in the first block, twice at one place, near the end
    let stops = ["0 s", "1 us", "50 ms", "0.25 s", "402 ms"];
    check("steady", &text, &stops);
}

#[test]
fn shocks_within_the_blocks() {
    let text = finely_sampled("coal-impact-7205c").replace(
        "samples_per_revolution = 2048",
        "samples_per_revolution = 16384",
    );
    check("coal impact", &text, &["90 ms", "0.102 s", "0.35 s"]);
}

#[test]
fn every_other_family_of_methods() {
    let text = finely_sampled("steady-7205c");
    for method in ["verner76", "dop853", "rodas", "exponential"] {
        let other = text.replace(
            "[integrator]\n",
            &format!("[integrator]\nmethod = \"{method}\"\n"),
        );
        assert_ne!(text, other);
        check(method, &other, &["0.1 s", "0.3 s"]);
    }
}

#[test]
fn a_method_that_the_rule_chooses() {
    let text = finely_sampled("run-up-7205c");
    assert!(!text.contains("method"));
    check("run-up", &text, &["100 us", "20 ms", "0.2 s", "0.27 s"]);
    let text = finely_sampled("steady-7205c");
    assert!(!text.contains("method"));
    check("steady", &text, &["1 ms", "0.2 s"]);
}

#[test]
fn a_stiff_run_whose_warning_was_earned_in_the_first_part() {
    let text = finely_sampled("steady-7205c").replace(
        "ratio = 0.02 ",
        "coefficients = { x = \"5e6 N s/m\", y = \"5e3 N s/m\", z = \"5e3 N s/m\" } ",
    );
    let text = text.replace("[integrator]\n", "[integrator]\nmethod = \"verner76\"\n");
    assert!(text.contains("verner76"));
    check("stiff", &text, &["0.2 s"]);
}

#[test]
fn balls_that_lose_contact_at_every_passage() {
    let text = finely_sampled("varying-compliance-6306")
        .replace("14.126 s", "2.0 s")
        .replace("13.582 s", "1.0 s");
    check("varying compliance", &text, &["0.3 s", "1.7 s"]);
}

#[test]
fn a_second_pass_that_failed_stays_failed() {
    // the second pass takes half again as many steps
    let text = finely_sampled("steady-7205c").replace(
        "tolerance = 1e-8",
        "method = \"verner76\"\ntolerance = 1e-8\nstep_limit = 5500",
    );
    let whole = Scene::new(&text);
    let said = whole.run(&[]).done();
    assert!(
        said.stderr.contains("5500 steps are used up"),
        "{}",
        said.stderr
    );
    check("failed second pass", &text, &["0.1 s", "0.35 s"]);
}

#[test]
fn a_stop_after_the_end_is_no_stop() {
    let text = finely_sampled("steady-7205c");
    let (whole, parts) = (Scene::new(&text), Scene::new(&text));
    whole.run(&[]).done();
    parts.run(&["--stop-at", "9 s"]).done();
    assert_same("steady", &parts, &whole);
    // the last block is not whole: the first whole block at or after this is the end
    parts.run(&["--stop-at", "0.49 s"]).done();
    assert_same("steady", &parts, &whole);
}

/// Long enough to be interrupted.
fn long() -> String {
    finely_sampled("steady-7205c").replace("\"0.5 s\"", "\"6 s\"")
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_goes_on() {
    let (whole, parts) = (Scene::new(&long()), Scene::new(&long()));
    whole.run(&[]).done();
    let said = parts.interrupt(&["--restartable"], ".restart.bin.partial", 1 << 18);
    said.says(1, "restart.bin: ");
    said.says(1, "it goes on with: jeffcott run scene.toml --resume");
    // and once more, further on
    let first = parts.results()["restart.bin"].len() as u64;
    let said = parts.interrupt(&["--resume"], ".restart.bin.partial", first + (1 << 18));
    said.says(1, "restart.bin: ");
    let left = parts.results();
    assert!(left["restart.bin"].len() as u64 > first);
    assert_eq!(left.len(), 1, "{:?}", left.keys());
    parts.run(&["--resume"]).done();
    assert_same("interrupted", &parts, &whole);
}

#[cfg(unix)]
#[test]
fn an_interrupt_while_the_states_are_read_back_loses_nothing() {
    let parts = Scene::new(&long());
    parts.run(&["--stop-at", "5 s"]).done();
    let before = parts.results();
    // the trace of what was stored is on its way
    let said = parts.interrupt(&["--resume"], ".trace.csv.partial", 1);
    said.says(1, "interrupted");
    assert!(parts.results()["restart.bin"].len() >= before["restart.bin"].len());
    assert_eq!(parts.results().len(), 1);
}

#[cfg(unix)]
#[test]
fn an_interrupt_without_a_wish_to_go_on_says_that_nothing_was_written() {
    let scene = Scene::new(&long());
    let said = scene.interrupt(&[], ".trace.csv.partial", 1);
    said.says(
        1,
        "nothing was written (--restartable keeps what it takes to go on)",
    );
    assert!(scene.results().is_empty());
}

#[test]
fn a_stop_is_told_to_programs() {
    let scene = Scene::new(&finely_sampled("steady-7205c"));
    let said = scene.run(&["--stop-at", "0.2 s", "--json"]).done();
    let told: serde_json::Value = serde_json::from_str(&said.stdout).expect("JSON");
    assert_eq!(told["samples"], 8192);
    assert_eq!(told["files"][0], "output/scene/restart.bin");
    let time = told["stopped_at_s"].as_f64().expect("a number");
    assert!((0.2..0.21).contains(&time), "{time}");
}
