//! A run that cannot go on keeps its trace up to there, and nothing that looks whole.

use super::scene::{Scene, finely_sampled};

/// A steady run that may take so many steps, by one method throughout: some 5000 to its end.
fn limited(steps: u32) -> String {
    let limit = format!("method = \"verner76\"\ntolerance = 1e-8\nstep_limit = {steps}");
    finely_sampled("steady-7205c").replace("tolerance = 1e-8", &limit)
}

#[test]
fn the_trace_up_to_a_failure_begins_the_whole_one() {
    let (failing, whole) = (Scene::new(&limited(2000)), Scene::new(&limited(100_000)));
    let said = failing.run(&[]);
    said.says(1, "2000 steps are used up at t = ");
    said.says(
        1,
        "kept output/scene/trace.until-failure.csv and output/scene/failure.json",
    );
    whole.run(&[]).done();
    let left = failing.results();
    assert_eq!(
        left.keys().collect::<Vec<_>>(),
        ["failure.json", "trace.until-failure.csv"]
    );
    let part = &left["trace.until-failure.csv"];
    let rows = part.iter().filter(|byte| **byte == b'\n').count() - 1;
    assert!(rows > 1000, "{rows} rows");
    // up to the block that failed, whose steps end elsewhere, the bytes are the same
    let whole = whole.results();
    let same = part
        .iter()
        .zip(&whole["trace.csv"])
        .take_while(|(a, b)| a == b);
    assert!(same.count() > part.len() * 9 / 10);
    let told: serde_json::Value = serde_json::from_slice(&left["failure.json"]).expect("JSON");
    assert_eq!(told["kind"], "step_limit");
    assert_eq!(told["samples"], rows);
    assert_eq!(told["jeffcott"], env!("CARGO_PKG_VERSION"));
    assert_eq!(told["scenario"]["shaft"]["mass"], "5 kg");
    assert_eq!(told["trace"], "trace.until-failure.csv");
    assert_eq!(told["of_an_earlier_run"].as_array().map(Vec::len), Some(0));
    let tried = told["counters"]["steps"]
        .as_u64()
        .zip(told["counters"]["rejected"].as_u64());
    assert_eq!(tried.map(|(steps, rejected)| steps + rejected), Some(2000));
    let time = told["time_s"].as_f64().expect("a number");
    assert!((0.1..0.4).contains(&time), "{time}");
}

#[test]
fn an_earlier_whole_run_stands_beside_and_is_named() {
    let scene = Scene::new(&limited(100_000));
    scene.run(&[]).done();
    let before = scene.results();
    scene.change(&limited(2000));
    scene
        .run(&[])
        .says(1, "the other results there are those of an earlier run");
    let mut after = scene.results();
    let failure = after.remove("failure.json").expect("a failure");
    assert!(after.remove("trace.until-failure.csv").is_some());
    assert!(after == before, "the earlier run has changed");
    let told: serde_json::Value = serde_json::from_slice(&failure).expect("JSON");
    assert_eq!(told["of_an_earlier_run"][0], "summary.json");
    // and the next whole run takes the failure away
    scene.change(&limited(100_000));
    scene.run(&[]).done();
    assert!(scene.results() == before);
}

#[test]
fn a_failure_replaces_the_failure_before_it() {
    let scene = Scene::new(&limited(2000));
    scene.run(&[]).says(1, "2000 steps");
    scene.change(&limited(1000).replace("[output]", "[output]\ntrace = false"));
    scene.run(&[]).says(1, "1000 steps");
    let left: Vec<String> = scene.results().into_keys().collect();
    assert_eq!(left, ["failure.json"]);
}

/// Long enough to be interrupted.
#[cfg(unix)]
#[test]
fn an_interrupt_says_that_nothing_was_written() {
    let scene = Scene::new(&finely_sampled("steady-7205c").replace("\"0.5 s\"", "\"6 s\""));
    let said = scene.interrupt(&[], ".trace.csv.partial", 1);
    said.says(1, "interrupted at t = ");
    said.says(1, "nothing was written");
    assert!(scene.results().is_empty());
}

#[test]
fn what_made_a_run_in_parts_is_answered_with_a_way() {
    let scene = Scene::new(&limited(2000));
    for gone in ["--stop-at=0.1 s", "--restartable", "--resume"] {
        scene.run(&[gone]).says(2, "tip: a run is made in one go");
    }
}

#[test]
fn other_formats_of_figures_are_answered_with_a_way() {
    let scene = Scene::new(&limited(2000));
    let said = scene.run(&["--figure-format=pdf"]);
    said.says(2, "tip: figures are written as SVG");
}
