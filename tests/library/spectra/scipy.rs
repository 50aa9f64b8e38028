//! Agreement with SciPy to 1e-12 of the largest value, window by window and case by case.

use crate::analysis::{Detrend, Envelopes, Scaling, Transform, Welch, Window};
use serde_json::Value;

use super::signal::{RATE, signals};

/// Largest difference, of the largest value of its list.
const AGREEMENT: f64 = 1e-12;

fn results() -> Value {
    serde_json::from_str(include_str!("scipy_spectra.json")).expect("the stored results are JSON")
}

fn cases(key: &str) -> Vec<Value> {
    let cases = results()[key].as_array().expect("a list of cases").clone();
    assert!(cases.len() > 1, "{key} has cases");
    cases
}

fn numbers(case: &Value, key: &str) -> Vec<f64> {
    let list = case[key].as_array().expect("a list of numbers").iter();
    list.map(|number| number.as_f64().expect("a number"))
        .collect()
}

fn count(case: &Value, key: &str) -> usize {
    case[key].as_u64().expect("a count") as usize
}

fn assert_agree(what: &Value, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let largest = expected
        .iter()
        .fold(0.0, |largest: f64, x| largest.max(x.abs()));
    assert!(largest > 0.0);
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        let difference = (found - expected).abs() / largest;
        assert!(
            difference < AGREEMENT,
            "{what} at {k}: {found:e} for {expected:e}, {difference:e} of the largest"
        );
    }
}

/// What the case is, without its results.
fn named(case: &Value) -> Value {
    let entries = case.as_object().expect("a table").iter();
    let plain = entries.filter(|(_, value)| !value.is_array());
    plain
        .map(|(key, value)| (key.clone(), value.clone()))
        .collect::<serde_json::Map<_, _>>()
        .into()
}

fn window(case: &Value) -> Window {
    match case["window"].as_str() {
        Some("rectangular") => Window::Rectangular,
        Some("hann") => Window::Hann,
        Some("hamming") => Window::Hamming,
        Some("blackman_harris") => Window::BlackmanHarris,
        Some("flat_top") => Window::FlatTop,
        other => panic!("window {other:?}"),
    }
}

fn welch(case: &Value) -> Welch {
    let detrend = match case["detrend"].as_str() {
        Some("none") => Detrend::None,
        Some("constant") => Detrend::Constant,
        Some("linear") => Detrend::Linear,
        other => panic!("detrend {other:?}"),
    };
    let (segment, overlap) = (count(case, "segment"), count(case, "overlap"));
    Welch::new(window(case), segment, overlap, detrend)
}

/// Scales powers of bins as the case asks.
fn scaled(case: &Value, welch: &Welch, powers: &[f64], sides: impl Fn(usize) -> f64) -> Vec<f64> {
    let scaling = match case["scaling"].as_str() {
        Some("power") => Scaling::Power,
        Some("density") => Scaling::Density,
        other => panic!("scaling {other:?}"),
    };
    let bandwidth = window(case).equivalent_noise_bandwidth() * RATE / welch.length as f64;
    let powers = powers.iter().enumerate();
    powers
        .map(|(k, power)| scaling.value(*power, sides(k), bandwidth))
        .collect()
}

#[test]
fn windows_their_gain_and_their_noise_bandwidth_are_scipys() {
    for case in cases("windows") {
        let (window, length) = (window(&case), count(&case, "length"));
        let weights: Vec<f64> = (0..length).map(|n| window.weight(n, length)).collect();
        assert_agree(&named(&case), &weights, &numbers(&case, "values"));
        let gain = case["coherent_gain"].as_f64().unwrap();
        assert!((window.coherent_gain() - gain).abs() < 1e-14, "{case}");
        let bandwidth = case["noise_bandwidth"].as_f64().unwrap();
        assert!((window.equivalent_noise_bandwidth() - bandwidth).abs() < 1e-12);
    }
}

#[test]
fn amplitudes_are_those_of_the_plain_transform() {
    for case in cases("amplitude") {
        let length = count(&case, "length");
        let [x, _] = signals(length);
        let window = window(&case);
        let expected = numbers(&case, "values");
        let welch = Welch::new(window, length, 0, Detrend::None);
        let powers = welch.power(&mut &x[..]).into_iter().enumerate();
        let peaks: Vec<f64> = powers
            .map(|(k, power)| Scaling::Peak.value(power, welch.sides(k), 1.0))
            .collect();
        assert_agree(&named(&case), &peaks, &expected);
        // the spectrum of every run weights after the transform
        let transform = Transform::new(x);
        let mixed: Vec<f64> = (0..transform.bins())
            .map(|k| transform.amplitude(k, window))
            .collect();
        assert_agree(&named(&case), &mixed, &expected);
    }
}

#[test]
fn welch_is_scipys_welch() {
    for case in cases("welch") {
        let [x, _] = signals(count(&case, "length"));
        let welch = welch(&case);
        let found = scaled(&case, &welch, &welch.power(&mut &x[..]), |k| welch.sides(k));
        assert_agree(&named(&case), &found, &numbers(&case, "values"));
    }
}

#[test]
fn cross_spectra_and_coherence_are_scipys() {
    for case in cases("cross") {
        let [x, y] = signals(count(&case, "length"));
        let welch = welch(&case);
        let found = welch.cross(&x, &y);
        let part = |value: fn(&nalgebra::Complex<f64>) -> f64| -> Vec<f64> {
            let parts: Vec<f64> = found.cross.iter().map(value).collect();
            scaled(&case, &welch, &parts, |k| welch.sides(k))
        };
        let [real, imaginary] = [part(|bin| bin.re), part(|bin| bin.im)];
        // both parts belong to one number, whose size they are measured by
        let joined = [real, imaginary].concat();
        let expected = [numbers(&case, "real"), numbers(&case, "imaginary")].concat();
        assert_agree(&named(&case), &joined, &expected);
        let coherence: Vec<f64> = (0..found.cross.len()).map(|k| found.coherence(k)).collect();
        assert_agree(&named(&case), &coherence, &numbers(&case, "coherence"));
    }
}

#[test]
fn spectra_of_a_whirl_are_scipys_of_a_complex_signal() {
    for case in cases("whirl") {
        let [x, y] = signals(count(&case, "length"));
        let welch = welch(&case);
        let found = scaled(&case, &welch, &welch.rotary(&x, &y), |_| 1.0);
        assert_agree(&named(&case), &found, &numbers(&case, "values"));
    }
}

#[test]
fn envelopes_are_scipys_hilbert() {
    for case in cases("envelope") {
        let [_, y] = signals(count(&case, "length"));
        let band = numbers(&case, "band");
        let found = Envelopes::new(&y, RATE).envelope([band[0], band[1]]);
        assert_agree(&named(&case), &found, &numbers(&case, "values"));
    }
}
