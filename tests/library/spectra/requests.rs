//! `[[spectrum]]` from the scenario to the spectra of a run.

use std::sync::atomic::AtomicBool;

use crate::analysis::{Channel, Scaling, Segment, SpectrumQuantity, Window};
use crate::rotor::Sample;
use crate::scenario::{self, Format};
use crate::simulate::{Model, Monitor, Run, TraceSink, simulate};

use super::record::values;

/// A shaft whose balls pass under a pull.
const SHAFT: &str = "
[shaft]
mass = \"5 kg\"
eccentricity = \"10 um\"
freedoms = \"translational\"
gravity = true
[[bearing]]
catalogue = \"7205C\"
facing = \"+z\"
[model]
contact = \"hertz\"
cage = \"rolling\"
[damping]
ratio = 0.03
[[load]]
constant = { y = \"-1600 N\", z = \"1000 N\" }
";
const STEADY: &str = "
[speed]
constant = \"500 rad/s\"
[time]
duration = \"0.25 s\"
settle = \"0.1 s\"
";
const RUN_UP: &str = "
[speed]
from = \"100 rad/s\"
to = \"500 rad/s\"
over = \"0.25 s\"
[time]
duration = \"0.25 s\"
";

fn text(motion: &str, spectra: &str) -> String {
    format!("{SHAFT}{motion}{spectra}")
}

fn model(text: &str) -> Model {
    let scenario = scenario::parse(text, "test.toml", Format::Toml);
    let scenario = scenario.unwrap_or_else(|error| panic!("{error}"));
    scenario.model.expect("it moves")
}

struct Nowhere;

impl TraceSink for Nowhere {
    fn sample(&mut self, _: &Sample) -> std::io::Result<()> {
        Ok(())
    }
}

fn run(model: &Model) -> Run {
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    simulate(model, &mut Nowhere, &mut monitor).expect("it runs")
}

#[test]
fn a_table_has_the_defaults_of_scipy_and_a_name_of_its_settings() {
    let spectra = "
[[spectrum]]
channels = [\"x\", \"force\"]
[[spectrum]]
channels = [\"force_x\", \"y\"]
kind = \"cross\"
over = \"order\"
segment_revolutions = 3
";
    let asked = model(&text(STEADY, spectra)).spectra;
    let [plain, cross] = &asked[..] else {
        panic!("two spectra")
    };
    assert_eq!(
        (plain.name.as_str(), cross.name.as_str()),
        ("peak", "cross_density_order")
    );
    assert_eq!(plain.window, Window::Hann);
    assert_eq!((plain.overlap, plain.segment), (0.5, Segment::Whole));
    let forces = (0..3).map(Channel::Force);
    let channels: Vec<_> = std::iter::once(Channel::Displacement(0))
        .chain(forces)
        .collect();
    assert_eq!(plain.channels, channels);
    assert_eq!(
        (cross.scaling, cross.segment),
        (Scaling::Density, Segment::Revolutions(3))
    );
}

#[test]
fn displacement_velocity_and_acceleration_tell_one_motion() {
    let spectra = "
[[spectrum]]
channels = [\"x\", \"x_velocity\", \"x_acceleration\"]
";
    let model = model(&text(STEADY, spectra));
    let found = run(&model);
    let spectrum = &found.spectra[0];
    // whole revolutions: 1× stands on a bin
    let row = (0..spectrum.bins())
        .find(|row| spectrum.order(*row) == Some(1.0))
        .unwrap();
    let height = |channel| values(spectrum, SpectrumQuantity::Value(channel))[row];
    let x = height(Channel::Displacement(0));
    assert!(x > 1e-8);
    let velocity = height(Channel::Velocity(0)) / 500.0;
    let acceleration = height(Channel::Acceleration(0)) / 500.0_f64.powi(2);
    assert!((velocity / x - 1.0).abs() < 1e-4, "{velocity} {x}");
    assert!((acceleration / x - 1.0).abs() < 1e-4, "{acceleration} {x}");
}

#[test]
fn spectra_change_nothing_of_the_run() {
    let spectra = "
[[spectrum]]
channels = [\"acceleration\"]
";
    let with = run(&model(&text(STEADY, spectra)));
    let without = run(&model(&text(STEADY, "")));
    assert_eq!(with.counters, without.counters);
    assert_eq!(with.peaks, without.peaks);
    assert!(without.spectra.is_empty());
}

#[test]
fn leakage_and_aliasing_are_told_with_numbers_and_remedies() {
    let told = |output: &str, what: &str| {
        let balanced = text(STEADY, output).replace("10 um", "0 um");
        let found = run(&model(&balanced)).warnings;
        found.into_iter().find(|warning| warning.starts_with(what))
    };
    // nothing but the ball pass, between the bins of eleven revolutions
    let plain = "[output]\nwindow = \"rectangular\"\n";
    let warning = told(plain, "leakage").expect("the ball pass leaks");
    assert!(warning.contains("window = \"hann\""), "{warning}");
    assert!(warning.contains("bins off its bin"), "{warning}");
    assert_eq!(told("[output]\nwindow = \"flat_top\"\n", "leakage"), None);
    assert_eq!(told("", "aliasing"), None);
    // where no window is asked for, such a line is seen through Hann's
    assert_eq!(told("", "leakage"), None);
    let balanced = run(&model(&text(STEADY, "").replace("10 um", "0 um")));
    assert_eq!(balanced.spectrum.expect("a spectrum").window, Window::Hann);
    let coarse = "[output]\nsamples_per_revolution = 10\n";
    let warning = told(coarse, "aliasing").expect("half the rate is just above the ball pass");
    assert!(
        warning.contains("raise `samples_per_revolution`"),
        "{warning}"
    );
}

#[test]
fn rest_neither_leaks_nor_folds() {
    let spectra = "
[[spectrum]]
channels = [\"displacement\", \"velocity\", \"acceleration\", \"force\"]
window = \"rectangular\"
";
    let still = text(STEADY, spectra).replace("10 um", "0 um");
    let found = run(&model(&still.replace("rolling", "frozen")));
    assert_eq!(found.warnings, Vec::<String>::new());
}

#[test]
fn a_spectrum_that_cannot_be_taken_is_named_with_the_reason() {
    let spectra = "
[[spectrum]]
name = \"long\"
channels = [\"x\"]
over = \"order\"
segment_revolutions = 50
";
    let found = run(&model(&text(RUN_UP, spectra)));
    assert!(found.spectra.is_empty());
    let warnings = found.warnings.join("\n");
    assert!(
        warnings.contains("the spectrum `long` was not estimated"),
        "{warnings}"
    );
}
