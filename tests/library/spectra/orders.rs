//! Spectra over shaft orders while the speed changes.

use std::f64::consts::TAU;

use crate::analysis::{
    Axis, Channel, Detrend, EstimateError, Scaling, Segment, SpectrumKind, SpectrumQuantity,
    SpectrumRequest, Window,
};

use super::record::{Motion, X, Y, estimated, request, values};

/// Speed at the start and its growth: from 10 to 30 rev/s in two seconds.
const START: f64 = TAU * 10.0;
const GROWTH: f64 = TAU * 10.0;

/// x = cos 3ψ + ½ cos 4.5ψ, y = sin ψ of a run-up.
fn motion(time: f64) -> Motion {
    let angle = START * time + 0.5 * GROWTH * time * time;
    let speed = START + GROWTH * time;
    let cosine = |order: f64, lead: f64| {
        let phase = order * angle + lead;
        let pace = order * speed;
        [
            phase.cos(),
            -pace * phase.sin(),
            -pace * pace * phase.cos() - order * GROWTH * phase.sin(),
        ]
    };
    let (three, more, once) = (cosine(3.0, 0.0), cosine(4.5, 0.0), cosine(1.0, -TAU / 4.0));
    let at = |derivative: usize| [three[derivative] + 0.5 * more[derivative], once[derivative]];
    Motion {
        turning: [angle, speed],
        displacement: at(0),
        velocity: at(1),
        acceleration: at(2),
    }
}

fn over_orders(kind: SpectrumKind, channels: &[Channel]) -> SpectrumRequest {
    SpectrumRequest {
        axis: Axis::Order,
        ..request(kind, channels, Scaling::Peak)
    }
}

#[test]
fn orders_of_a_run_up_are_lines_as_sharp_as_the_stated_error() {
    // the force on the shaft is −x: known by its values alone
    let channels = [X, Channel::Force(0)];
    let mut request = over_orders(SpectrumKind::Plain, &channels);
    request.segment = Segment::Revolutions(16);
    let found = estimated(&request, 2049, motion).unwrap();
    let resampling = found.resampling.as_ref().unwrap();
    assert_eq!(
        (resampling.per_revolution, resampling.oversampling),
        (35, 3)
    );
    assert_eq!((found.segment, found.averages), (16 * 105, 4)); // 40 revolutions
    for (channel, (named, error)) in channels.iter().zip(&resampling.errors) {
        assert_eq!(channel, named);
        let error = error.unwrap();
        let peaks = values(&found, SpectrumQuantity::Value(*channel));
        assert_eq!(peaks.len(), 16 * 105 / 6 + 1);
        for (row, peak) in peaks.iter().enumerate() {
            let expected = match found.place(row) {
                3.0 => 1.0,
                4.5 => 0.5,
                _ => 0.0,
            };
            let off = (peak - expected).abs();
            assert!(
                off < 3.0 * error,
                "{channel} order {}: {peak}",
                found.place(row)
            );
        }
    }
    // derivatives make the interpolation the better one
    let errors: Vec<f64> = resampling
        .errors
        .iter()
        .filter_map(|(_, error)| *error)
        .collect();
    assert!(errors[0] < 1e-3 && errors[0] < errors[1], "{errors:?}");
    assert_eq!(found.frequency(3), None);
}

#[test]
fn a_whirl_over_orders_turns_with_the_shaft() {
    let circle = |time: f64| {
        let now = motion(time);
        let [angle, speed] = now.turning;
        let pace = [-angle.sin(), angle.cos()];
        let out = [angle.cos(), angle.sin()];
        Motion {
            displacement: out,
            velocity: pace.map(|part| speed * part),
            acceleration: std::array::from_fn(|axis| {
                GROWTH * pace[axis] - speed * speed * out[axis]
            }),
            ..now
        }
    };
    let found = estimated(&over_orders(SpectrumKind::Whirl, &[X, Y]), 2049, circle).unwrap();
    let radii = values(&found, SpectrumQuantity::Rotary(X, Y));
    for (row, radius) in radii.iter().enumerate() {
        let expected = if (found.place(row) - 1.0).abs() < 1e-9 {
            1.0
        } else {
            0.0
        };
        assert!(
            (radius - expected).abs() < 1e-7,
            "{}: {radius}",
            found.place(row)
        );
    }
    let ends = [found.place(0), found.place(radii.len() - 1)];
    assert!(
        (ends[0] + 17.5).abs() < 1e-9 && (ends[1] - 17.5).abs() < 1e-9,
        "{ends:?}"
    );
}

#[test]
fn a_tone_that_stands_still_does_not_fold_into_lower_orders() {
    // 300 Hz is order 30 at the start, above the highest order of 17.5, and 10 at the end
    let tone = |time: f64| {
        let pace = TAU * 300.0;
        let (cos, sin) = ((pace * time).cos(), (pace * time).sin());
        Motion {
            displacement: [cos, 0.0],
            velocity: [-pace * sin, 0.0],
            acceleration: [-pace * pace * cos, 0.0],
            ..motion(time)
        }
    };
    let mut request = over_orders(SpectrumKind::Plain, &[X]);
    request.scaling = Scaling::Power;
    request.window = Window::Hann;
    request.detrend = Detrend::Constant;
    let found = estimated(&request, 2049, tone).unwrap();
    let powers = values(&found, SpectrumQuantity::Value(X));
    let below: f64 = (0..powers.len())
        .filter(|row| found.place(*row) < 9.0)
        .map(|row| powers[row])
        .sum();
    let all: f64 = powers.iter().sum();
    assert!(all > 0.1, "the tone is there");
    assert!(below < 1e-4 * all, "{below:e} of {all:e}");
}

#[test]
fn a_shaft_that_turns_back_or_hardly_turns_has_no_orders() {
    let back = |time: f64| Motion {
        turning: [10.0 * time * (1.0 - time), 10.0 - 20.0 * time],
        ..motion(time)
    };
    let request = over_orders(SpectrumKind::Plain, &[X]);
    let error = estimated(&request, 1024, back).unwrap_err();
    assert!(matches!(error, EstimateError::TurnsBack { time } if (time - 0.5).abs() < 0.002));
    let error = estimated(&request, 40, motion).unwrap_err();
    assert!(matches!(error, EstimateError::NoRevolution { turns } if turns < 1.0));
    let mut request = request;
    request.segment = Segment::Seconds(0.1);
    let error = estimated(&request, 2049, motion).unwrap_err();
    assert_eq!(error, EstimateError::SecondsOverOrders);
}
