//! `balls.svg`: load and contact angle around every bearing.

use crate::bearing::{BallLine, BearingState, RaceContact};
use crate::quasi_static::QuasiStatic;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, all_around, distinct, turned};

/// Height of a plot, px.
const HEIGHT: u32 = 272;

/// One row of two panels for each bearing.
pub(super) fn balls(title: &str, answer: &QuasiStatic) -> Figure {
    let bearings = answer.bearings.iter().enumerate();
    let panels = bearings.flat_map(|(index, state)| {
        let bearing = if answer.bearings.len() > 1 {
            format!("bearing {}: ", index + 1)
        } else {
            String::new()
        };
        panels(&bearing, state)
    });
    let names = Name::each(["inner race", "outer race"]);
    Figure::new("balls.svg", title, 2, panels.collect()).with_names(names)
}

fn panels(bearing: &str, state: &BearingState) -> [Panel; 2] {
    let panel = |name: &str, value: fn(&RaceContact) -> f64| {
        // the outer race first: where both agree, the inner one is seen
        let curves = vec![
            curve(&state.balls, 1, |line| value(&line.outer)),
            curve(&state.balls, 0, |line| value(&line.inner)),
        ];
        Panel::of(Axis::azimuth(), format!("{bearing}{name}"), HEIGHT, curves)
    };
    [
        panel("ball load Q in N", |contact| contact.load),
        panel("contact angle α in deg", |contact| {
            contact.angle.to_degrees()
        }),
    ]
}

fn curve(balls: &[BallLine], race: usize, value: impl Fn(&BallLine) -> f64) -> Curve {
    let marks = turned(balls.iter().map(|line| (line.azimuth, value(line))));
    Curve {
        marks: marks.clone(),
        ..Curve::line(distinct(race), all_around(marks))
    }
}
