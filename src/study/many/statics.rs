//! Static questions as runs of a study: the numbers of their answers, and the bearings all around.

use super::numbers::NumberColumn;
use super::record::{Outcome, Place};
use crate::analysis::Channel;
use crate::bearing::{Around, BallLine, BearingState};
use crate::keys;
use crate::quasi_static::{QuasiStatic, StaticQuestion, Twist, answer_on};
use crate::rotor::{FREEDOMS, RotorDefinition, RotorError, build_supports};
use crate::table::{Column, Named};

/// Numbers of the whole shaft behind its stiffness.
const SHAFT: [Named<QuasiStatic>; 4] = [
    ("condition", "", |answer| answer.condition),
    ("residual", "", |answer| answer.residual),
    ("moment_z", "N m", |answer| {
        twist(answer, |twist| twist.moment)
    }),
    ("twist", "rad", |answer| twist(answer, |twist| twist.angle)),
];

fn twist(answer: &QuasiStatic, value: fn(&Twist) -> f64) -> f64 {
    answer.twist.as_ref().map_or(f64::NAN, value)
}

/// Numbers of the largest and the smallest value of all balls of a bearing; NaN where there are none.
const EXTREMES: [Named<BallLine>; 3] = [
    ("load_inner", "N", |ball| ball.inner.load),
    ("load_outer", "N", |ball| ball.outer.load),
    ("angle_inner", "rad", |ball| ball.inner.angle),
];

/// Numbers of one bearing after these.
const BEARING: [Named<BearingState>; 9] = [
    ("range_of_angle_inner", "rad", |state| {
        let angle = |ball: &BallLine| ball.inner.angle;
        extreme(state, angle, f64::max) - extreme(state, angle, f64::min)
    }),
    ("largest_pressure", "Pa", |state| {
        let pressure = |ball: &BallLine| ball.inner.peak_pressure.max(ball.outer.peak_pressure);
        extreme(state, pressure, f64::max)
    }),
    ("life_rating", "N", |state| {
        let lives = state.rating_lives.as_ref();
        lives.map_or(f64::NAN, |lives| lives.dynamic_rating)
    }),
    ("life", "Mrev", |state| state.life.unwrap_or(f64::NAN)),
    ("life", "h", |state| {
        let lives = state.rating_lives.as_ref();
        lives
            .and_then(|lives| lives.reference_hours)
            .unwrap_or(f64::NAN)
    }),
    ("modified_life", "h", |state| {
        let lives = state.rating_lives.as_ref();
        lives
            .and_then(|lives| lives.modified?.hours)
            .unwrap_or(f64::NAN)
    }),
    ("operating_preload", "N", |state| state.preload),
    ("static_safety", "", |state| {
        state.static_safety.unwrap_or(f64::NAN)
    }),
    ("friction_moment", "N m", |state| {
        state.friction_moment.total()
    }),
];

/// Largest or smallest value of all balls; NaN where there are none.
fn extreme(state: &BearingState, value: fn(&BallLine) -> f64, of: fn(f64, f64) -> f64) -> f64 {
    state.balls.iter().map(value).fold(f64::NAN, of)
}

/// Columns of a position around a bearing.
pub const AROUND: [Named<Around>; 6] = [
    ("azimuth", "rad", |place| place.azimuth),
    ("deformation", "m", |place| place.deformation),
    ("load_inner", "N", |place| place.contact.load_inner),
    ("load_outer", "N", |place| place.contact.load_outer),
    ("angle_inner", "rad", |place| place.contact.angle_inner),
    ("angle_outer", "rad", |place| place.contact.angle_outer),
];

/// The numbers of every answer to questions about a rotor.
pub fn static_columns(rotor: &RotorDefinition) -> Vec<NumberColumn> {
    let displacements = (0..FREEDOMS).map(|axis| {
        let column = Channel::Displacement(axis).column();
        NumberColumn::from_answer(column, move |answer| answer.displacement[axis])
    });
    let forces = (0..FREEDOMS).map(|axis| {
        let column = Channel::Force(axis).column();
        NumberColumn::from_answer(column, move |answer| answer.force[axis])
    });
    let diagonal = keys::diagonal_columns().into_iter().enumerate();
    let stiffness = diagonal.map(|(axis, column)| {
        NumberColumn::from_answer(column, move |answer| answer.stiffness[(axis, axis)])
    });
    let mut columns: Vec<_> = displacements.chain(forces).chain(stiffness).collect();
    columns.extend(SHAFT.map(|(quantity, unit, value)| {
        NumberColumn::from_answer(Column::number(quantity, unit), value)
    }));
    columns.extend((0..rotor.bearings.len()).flat_map(bearing_columns));
    columns
}

/// The numbers of a bearing.
fn bearing_columns(bearing: usize) -> Vec<NumberColumn> {
    let number = |quantity: &str, unit, value: Box<dyn Fn(&BearingState) -> f64 + Send + Sync>| {
        let column = Column::number(format!("bearing_{}_{quantity}", bearing + 1), unit);
        NumberColumn::from_answer(column, move |answer| {
            answer.bearings.get(bearing).map_or(f64::NAN, &value)
        })
    };
    let loaded = |state: &BearingState| state.balls_loaded as f64;
    let mut columns = vec![number("balls_loaded", "", Box::new(loaded))];
    for (quantity, unit, value) in EXTREMES {
        let of_all = |which: &str, of: fn(f64, f64) -> f64| {
            let extreme = move |state: &BearingState| extreme(state, value, of);
            number(&format!("{which}_{quantity}"), unit, Box::new(extreme))
        };
        columns.extend([of_all("largest", f64::max), of_all("smallest", f64::min)]);
    }
    columns.extend(BEARING.map(|(quantity, unit, value)| number(quantity, unit, Box::new(value))));
    columns
}

impl Place {
    /// A number of the position by its quantity, as `deformation`; NaN where there is none of that name.
    pub fn number(&self, quantity: &str) -> f64 {
        let place = AROUND.iter().position(|(name, ..)| *name == quantity);
        let number = place.and_then(|place| self.numbers.get(place));
        number.copied().unwrap_or(f64::NAN)
    }
}

/// The answer to a static question as what came of a run, with every bearing at so many azimuths from +X on, or where
/// its balls are.
///
/// # Errors
/// [`RotorError`] where it has no answer.
pub fn static_outcome(
    question: &StaticQuestion,
    columns: &[NumberColumn],
    positions: Option<usize>,
) -> Result<Outcome, RotorError> {
    let rotor = &question.rotor;
    let supports = build_supports(rotor)?;
    let answer = answer_on(question, &supports)?;
    let bearings = supports.iter().zip(&answer.bearings);
    let around = (1..).zip(bearings).flat_map(|(bearing, (support, state))| {
        let places = support.around(&state.displacement, rotor.speed, positions);
        places.into_iter().map(move |place| Place {
            bearing,
            row: place.row,
            position: place.position,
            numbers: AROUND.map(|(.., value)| value(&place)).to_vec(),
        })
    });
    Ok(Outcome {
        around: around.collect(),
        numbers: columns.iter().map(|own| own.in_answer(&answer)).collect(),
        warnings: answer.warnings,
        ..Outcome::default()
    })
}
