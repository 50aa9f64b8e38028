//! `jeffcott fit` and `--sensitivity` as a user meets them.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::{done, jeffcott_in, root, scenarios, told};

fn document(folder: &Path, arguments: &[&str]) -> Value {
    let out = folder.to_str().expect("a path of letters");
    let output = jeffcott_in(root(), &[arguments, &["--out", out, "--json"]].concat());
    serde_json::from_slice(&done(output).stdout).expect("JSON")
}

/// An unknown of a fit: its value and its standard error.
fn found(document: &Value, unknown: usize) -> [f64; 2] {
    let own = &document["unknowns"][unknown];
    ["value", "standard_error"].map(|key| own[key].as_f64().expect("a number"))
}

#[test]
fn the_clearance_of_the_shipped_twin_is_found() {
    let out = tempfile::tempdir().expect("a folder");
    let file = "scenarios/studies/clearance-fit-6205.toml";
    let told = document(out.path(), &["fit", file, "--set", "starts=1"]);
    for (unknown, truth, known) in [(0, -4e-6, 0.1e-6), (1, 0.045, 0.005)] {
        let [value, error] = found(&told, unknown);
        assert!(
            (value - truth).abs() < 3.0 * error && error < known,
            "{value} ± {error}"
        );
    }
    assert_eq!(told["warnings"], serde_json::json!([]));
    let folder = out.path().join("clearance-fit-6205");
    let fitted = folder.join("fitted.toml");
    done(jeffcott_in(
        root(),
        &["check", fitted.to_str().expect("a path")],
    ));
    let page = fs::read_to_string(folder.join("fit.html")).expect("a page");
    for figure in ["fit_observations", "fit_residuals", "fit_profiles"] {
        assert!(page.contains(figure), "{figure}");
    }
}

/// A fit of where a pair stands, written into a folder, with some text in place of another.
fn pair(folder: &Path, replaced: &str, by: &str) -> String {
    let base = scenarios().join("back-to-back-7205c.toml");
    let text = format!(
        "base = '{}'\n\
         [[unknown]]\nkey = 'bearing[1].preload'\nfrom = '50 N'\nto = '900 N'\n\
         [[unknown]]\nkey = 'shaft.mass'\nfrom = '2 kg'\nto = '9 kg'\n\
         [[observation]]\nnumber = 'stiffness_z_N_m'\nvalue = '60 N/um'\nsigma = '2 %'\n\
         [[observation]]\nnumber = 'y_m'\nvalue = '-0.16 um'\nsigma = '2 %'\n\
         [[observation]]\nchannel = 'x'\nline = '1x'\namplitude = '24 nm'\nsigma = '5 %'\n",
        base.display()
    );
    assert!(text.contains(replaced), "{replaced}");
    let file = folder.join("pair.toml");
    fs::write(&file, text.replacen(replaced, by, 1)).expect("a writable folder");
    file.to_str().expect("a path of letters").to_owned()
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = pair(folder.path(), "", "");
    let answers = ["1", "3"].map(|threads| {
        let out = folder.path().join(threads);
        let out = out.to_str().expect("a path");
        done(jeffcott_in(
            root(),
            &["fit", &file, "--threads", threads, "--out", out],
        ));
        fs::read(Path::new(out).join("pair/fit.json")).expect("a document")
    });
    assert!(answers[0] == answers[1]);
}

#[test]
fn wrong_fits_are_refused_with_a_word_on_what_to_do() {
    let folder = tempfile::tempdir().expect("a folder");
    for (replaced, by, code, says) in [
        (
            "from = '50 N'",
            "from = '950 N'",
            2,
            "`to` must be above `from`",
        ),
        (
            "to = '900 N'",
            "to = '900 N'\nstart = '2 kN'",
            2,
            "between `from` and `to`",
        ),
        (
            "key = 'shaft.mass'
from = '2 kg'
to = '9 kg'",
            "key = 'bearing[*].preload'
from = '2 N'
to = '9 N'",
            2,
            "is sought already",
        ),
        (
            "[[unknown]]",
            "[[set]]\nkey = 'shaft.mass'\nvalue = '3 kg'\n[[unknown]]",
            2,
            "`shaft.mass` is sought, and the value here has no effect",
        ),
        (
            "key = 'shaft.mass'",
            "key = 'shaft.masss'",
            2,
            "did you mean `shaft.mass`",
        ),
        ("number = 'y_m'", "number = 'y_mm'", 2, "did you mean `y_m`"),
        (
            "value = '60 N/um'",
            "value = '60 N'",
            2,
            "a stiffness is written like",
        ),
        ("sigma = '5 %'", "", 2, "give `sigma` of all, or of none"),
        (
            "amplitude = '24 nm'",
            "amplitude = '24 N'",
            2,
            "is no amplitude of `x`",
        ),
        (
            "channel = 'x'",
            "channel = 'housing1_x'",
            2,
            "are not computed here",
        ),
        (
            "line = '1x'",
            "line = 'BPFI'",
            1,
            "nothing here causes `x BPFI`",
        ),
    ] {
        let file = pair(folder.path(), replaced, by);
        let output = jeffcott_in(folder.path(), &["fit", &file]);
        let message = told(&output);
        assert_eq!(output.status.code(), Some(code), "{by}: {message}");
        assert!(message.contains(says), "{by}: {message}");
    }
    // fewer observations than unknowns
    let file = pair(folder.path(), "[[observation]]", "[[observation]]");
    let text = fs::read_to_string(&file).expect("a file");
    let (few, _) = text
        .split_once("[[observation]]\nnumber = 'y_m'")
        .expect("two tables");
    fs::write(&file, few).expect("a writable folder");
    let refused = told(&jeffcott_in(folder.path(), &["fit", &file]));
    assert!(
        refused.contains("1 observations cannot tell 2 unknowns"),
        "{refused}"
    );
    for verb in ["run", "study"] {
        let refused = told(&jeffcott_in(folder.path(), &[verb, &file]));
        assert!(refused.contains("fit"), "{refused}");
    }
}

/// The derivative of a number by a key that a verb tells.
fn derivative(document: &Value, number: &str, key: &str) -> f64 {
    let mut rows = document["sensitivity"].as_array().expect("rows").iter();
    let row = rows.find(|row| row["number"] == number && row["key"] == key);
    row.expect("a row")["derivative"]
        .as_f64()
        .expect("a number")
}

#[test]
fn sensitivities_are_the_differences_of_answers() {
    let out = tempfile::tempdir().expect("a folder");
    let file = "scenarios/back-to-back-7205c.toml";
    let preload = |value: f64| format!("bearing[1].preload={value} N");
    let asked = document(
        out.path(),
        &[
            "bearing",
            file,
            "--sensitivity",
            "bearing[1].preload,shaft.mass",
        ],
    );
    let stiffness = |force: f64| {
        let answer = document(out.path(), &["bearing", file, "--set", &preload(force)]);
        answer["stiffness"]["named"]["stiffness_z_N_m"]
            .as_f64()
            .expect("a number")
    };
    // five points: the error falls with the fourth power of the step
    let step = 4.0;
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|place| stiffness(200.0 + step * place));
    let differences = (a - 8.0 * b + 8.0 * c - d) / (12.0 * step);
    let own = derivative(&asked, "stiffness_z_N_m", "bearing[1].preload");
    assert!(
        (own / differences - 1.0).abs() < 1e-5,
        "{own} {differences}"
    );
    // the weight hangs on the bearings
    assert!((derivative(&asked, "force_y_N", "shaft.mass") + 9.80665).abs() < 1e-6);

    let tight = "integrator.tolerance=1e-11";
    let steady = document(
        out.path(),
        &[
            "steady",
            file,
            "--no-verify",
            "--sensitivity",
            "bearing[1].preload",
        ],
    );
    let tornado = out.path().join("back-to-back-7205c/steady_tornado.svg");
    let tornado = fs::read_to_string(tornado).expect("a figure");
    assert!(tornado.contains("preload of bearing 1"));
    let range = |force: f64| {
        let force = preload(force);
        let answer = document(
            out.path(),
            &[
                "steady",
                file,
                "--no-verify",
                "--set",
                &force,
                "--set",
                tight,
            ],
        );
        let ranges = answer["ranges"].as_array().expect("ranges");
        let own = ranges
            .iter()
            .find(|own| own["channel"] == "x_m")
            .expect("x");
        own["rms"].as_f64().expect("a number")
    };
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|place| range(200.0 + step * place));
    let differences = (a - 8.0 * b + 8.0 * c - d) / (12.0 * step);
    let own = derivative(&steady, "x_rms_m", "bearing[1].preload");
    assert!(
        (own / differences - 1.0).abs() < 1e-5,
        "{own} {differences}"
    );
}

/// A shaft on springs and dampers under an unbalance, which has settled after 0.4 s.
const ON_SPRINGS: &str = "[shaft]\nmass = '5 kg'\nfreedoms = 'radial'\n[speed]\nconstant = '3000 rpm'\n\
    [[unbalance]]\namount = '70 g mm'\n\
    [[element]]\n[element.linear]\nstiffness = { x = '2 N/um', y = '3 N/um' }\ndamping = { x = '500 N s/m', y = '400 N s/m' }\n\
    [time]\nduration = '0.6 s'\nsettle = '0.4 s'\n";

#[test]
fn a_settled_run_is_differentiated_as_in_closed_form() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("scene.toml"), ON_SPRINGS).expect("a file");
    let run = |further: &[&str]| {
        let keys = "element[1].linear.stiffness.x,unbalance[1].amount";
        let asked = ["run", "scene.toml", "--json", "--sensitivity", keys];
        jeffcott_in(folder.path(), &[&asked, further].concat())
    };
    let found: Value = serde_json::from_slice(&done(run(&[])).stdout).expect("JSON");
    // a = u ω²/|k − m ω² + i c ω|
    let (k, m, c, speed) = (2e6, 5.0, 500.0, 50.0 * std::f64::consts::TAU);
    let [real, imaginary] = [k - m * speed * speed, c * speed];
    let square = real * real + imaginary * imaginary;
    let rms = 70e-6 * speed * speed / (2.0 * square).sqrt();
    for (key, expected) in [
        ("element[1].linear.stiffness.x", -rms * real / square),
        ("unbalance[1].amount", rms / 70e-6),
    ] {
        let own = derivative(&found, "x_rms_m", key);
        assert!(
            (own / expected - 1.0).abs() < 1e-5,
            "{key}: {own} {expected}"
        );
    }
    let files = folder.path().join("output/scene");
    assert!(files.join("run_tornado.svg").exists() && files.join("run_sensitivity.csv").exists());

    // while the start dies out no number is that of the motion; the run is kept all the same
    let short = ["--set", "time.settle=0 s", "--set", "time.duration=0.06 s"];
    let output = run(&short);
    let message = told(&output);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("no sensitivities: the motion has not settled"),
        "{message}"
    );
    assert!(files.join("trace.csv").exists() && !files.join("run_sensitivity.csv").exists());
}

#[test]
fn lines_of_a_record_are_fitted_and_drawn_over_it() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("truth.toml"), ON_SPRINGS).expect("a file");
    fs::write(
        folder.path().join("guess.toml"),
        ON_SPRINGS.replace("70 g mm", "20 g mm"),
    )
    .expect("a file");
    done(jeffcott_in(folder.path(), &["run", "truth.toml"]));
    let trace = "output/truth/trace.csv";
    done(jeffcott_in(
        folder.path(),
        &["analyze", trace, "--speed", "3000 rpm", "--out", "records"],
    ));
    let fit = "base = 'guess.toml'\n\
        [[unknown]]\nkey = 'unbalance[1].amount'\nfrom = '1 g mm'\nto = '200 g mm'\n\
        [[observation]]\nrecord = 'records/trace'\nchannel = 'x'\nlines = ['1x']\nsigma = '5 %'\n\
        [[observation]]\nrecord = 'records/trace'\nchannel = 'y'\nlines = ['1x']\nsigma = '5 %'\n";
    fs::write(folder.path().join("fit.toml"), fit).expect("a file");
    let output = done(jeffcott_in(folder.path(), &["fit", "fit.toml", "--json"]));
    let told: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let [amount, _] = found(&told, 0);
    assert!((amount / 70e-6 - 1.0).abs() < 1e-3, "{amount}");
    let fitted = fs::read_to_string(folder.path().join("output/fit/fitted.toml")).expect("a file");
    assert!(fitted.contains("[[measured]]"), "{fitted}");
    assert!(folder.path().join("output/fit/measured.svg").exists());
}

#[test]
fn the_schema_of_fits_is_up_to_date() {
    let output = done(jeffcott_in(root(), &["schema", "--fit"]));
    let kept = fs::read(scenarios().join("fit.schema.json")).expect("the schema");
    assert!(
        kept == output.stdout,
        "run `jeffcott schema --fit > scenarios/fit.schema.json`"
    );
}
