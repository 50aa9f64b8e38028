//! `balls.svg`: load and contact angle around every bearing.

use super::super::ReportError;
use super::super::figure::svg;
use super::super::figure_curves::{
    Curve, Panel, all_around, azimuth_ticks, distinct, draw, turned,
};
use crate::bearing::{BallLine, BearingState, RaceContact};
use crate::quasi_static::QuasiStatic;

/// Height of the panels of one bearing, px.
const ROW_HEIGHT: u32 = 330;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;

/// Draws one row of two panels for each bearing.
pub(super) fn balls(title: &str, answer: &QuasiStatic) -> Result<String, ReportError> {
    let rows = answer.bearings.len() as u32;
    let panels: Vec<_> = answer
        .bearings
        .iter()
        .enumerate()
        .flat_map(|(index, state)| panels(index + 1, answer.bearings.len(), state))
        .collect();
    let names = ["inner race", "outer race"].map(str::to_owned);
    let names = [0, 1].map(|race| (names[race].clone(), distinct(race)));
    svg(
        "balls.svg",
        HEAD_HEIGHT + rows * ROW_HEIGHT,
        title,
        |area| draw(area, &names, &panels, 2),
    )
}

fn panels(number: usize, count: usize, state: &BearingState) -> [Panel; 2] {
    let bearing = if count > 1 {
        format!("bearing {number}: ")
    } else {
        String::new()
    };
    let panel = |name: &str, value: fn(&RaceContact) -> f64| Panel {
        x_name: "azimuth φ in deg".to_owned(),
        x_ticks: azimuth_ticks(),
        y_name: format!("{bearing}{name}"),
        // the outer race first: where both agree, the inner one is seen
        curves: vec![
            curve(&state.balls, 1, |line| value(&line.outer)),
            curve(&state.balls, 0, |line| value(&line.inner)),
        ],
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
        points: all_around(marks.clone()),
        colour: distinct(race),
        marks,
    }
}
