//! A restart file that is of no use is refused before the run, and stays as it is.

use std::fs;

use super::scene::Scene;
use crate::support::shipped_text as shipped;

/// A scene that was stopped, with its restart file.
fn stopped() -> (Scene, Vec<u8>) {
    let scene = Scene::new(&shipped("steady-7205c"));
    scene.run(&["--stop-at", "0.2 s"]).done();
    let bytes = fs::read(scene.result("restart.bin")).expect("a restart file");
    (scene, bytes)
}

/// Resumes, expects refusal with a part of the message, and looks whether all is as it was.
#[track_caller]
fn assert_refused(scene: &Scene, part: &str) {
    let before = scene.results();
    let said = scene.run(&["--resume"]);
    said.says(2, part);
    assert!(said.stdout.is_empty());
    assert!(scene.results() == before, "the folder has changed");
}

#[test]
fn there_is_none() {
    let scene = Scene::new(&shipped("steady-7205c"));
    assert_refused(&scene, "there is no output/scene/restart.bin");
}

#[test]
fn it_is_something_else() {
    let (scene, _) = stopped();
    for text in ["", "jeff", "t_s,x_m\n0,0\n"] {
        fs::write(scene.result("restart.bin"), text).expect("a written file");
        assert_refused(&scene, "is no restart file");
    }
}

#[test]
fn it_is_cut_anywhere() {
    let (scene, bytes) = stopped();
    let long = bytes.len();
    for length in [
        8,
        11,
        12,
        20,
        100,
        1000,
        long / 2,
        long - 24,
        long - 8,
        long - 1,
    ] {
        fs::write(scene.result("restart.bin"), &bytes[..length]).expect("a written file");
        assert_refused(&scene, "is damaged: ");
    }
}

#[test]
fn one_bit_of_it_is_wrong() {
    let (scene, bytes) = stopped();
    let long = bytes.len();
    for place in [
        13,
        40,
        500,
        long / 2,
        long - 200,
        long - 20,
        long - 12,
        long - 1,
    ] {
        let mut changed = bytes.clone();
        changed[place] ^= 4;
        fs::write(scene.result("restart.bin"), changed).expect("a written file");
        assert_refused(&scene, "is damaged: ");
    }
}

#[test]
fn the_scenario_has_been_changed() {
    let (scene, _) = stopped();
    let text = shipped("steady-7205c");
    scene.change(&text.replace("mass = \"5 kg\"", "mass = \"6 kg\""));
    assert_refused(&scene, "`shaft.mass` is \"5 kg\" there and \"6 kg\" here");
    scene.change(&text.replace("0.5 s", "0.6 s"));
    assert_refused(
        &scene,
        "`time.duration` is \"0.5 s\" there and \"0.6 s\" here",
    );
    // a comment is no change
    scene.change(&format!("{text}\n# as before\n"));
    scene.run(&["--resume"]).done();
}

#[test]
fn a_file_that_the_scenario_names_has_been_changed() {
    let text = shipped("steady-7205c").replace(
        "[time]",
        "[[load]]\nseries = { file = \"force.csv\" }\n\n[time]",
    );
    let scene = Scene::new(&text);
    let series = |force: &str| {
        let rows = format!("t_s,x_N\n0,0\n0.4,{force}\n0.5,0\n");
        fs::write(scene.path("force.csv"), rows).expect("a written series");
    };
    series("5");
    scene.run(&["--stop-at", "0.2 s"]).done();
    series("6");
    assert_refused(&scene, "a file that this one names");
    series("5");
    scene.run(&["--resume"]).done();
}

/// The checksum of the format, to sign what another version would have written.
fn checksum(bytes: &[u8]) -> u64 {
    bytes
        .chunks(8)
        .fold(0xcbf2_9ce4_8422_2325, |sum: u64, given| {
            let mut word = [0; 8];
            word[..given.len()].copy_from_slice(given);
            (sum ^ u64::from_le_bytes(word)).wrapping_mul(0x0100_0000_01b3)
        })
}

#[test]
fn another_version_wrote_it() {
    let (scene, mut bytes) = stopped();
    let version = env!("CARGO_PKG_VERSION");
    let key = b"{\"version\":\"";
    let found = bytes.windows(key.len()).position(|bytes| bytes == key);
    bytes[found.expect("a version") + key.len()] = b'9';
    let signed = bytes.len() - 8;
    let sum = checksum(&bytes[..signed]).to_le_bytes();
    bytes[signed..].copy_from_slice(&sum);
    fs::write(scene.result("restart.bin"), bytes).expect("a written file");
    let said = format!(
        "was written by version 9{} of jeffcott and this is {version}",
        &version[1..]
    );
    assert_refused(&scene, &said);
}

#[test]
fn one_bad_file_of_several_stops_all_before_the_first() {
    let (scene, _) = stopped();
    fs::copy(scene.path("scene.toml"), scene.path("other.toml")).expect("a copy");
    let before = scene.results();
    let said = scene.run(&["other.toml", "--resume"]);
    said.says(2, "there is no output/other/restart.bin");
    assert!(scene.results() == before);
}

#[test]
fn a_time_without_a_unit_is_no_time_to_stop_at() {
    let scene = Scene::new(&shipped("steady-7205c"));
    scene.run(&["--stop-at", "0.2"]).says(2, "as in \"0.2 s\"");
    scene.run(&["--stop-at", "2 mm"]).says(2, "is a length");
    scene
        .run(&["--stop-at", "-1 s"])
        .says(2, "must be at least 0");
}
