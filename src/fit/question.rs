//! Questions about a scene, and the numbers that answer them.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::Complex;

use super::kind::{CRITICAL_SPEEDS, critical_column, mode_columns, motion_columns};
use super::{Answer, NamedLine, NoAnswer, Number};
use crate::analysis::Line;
use crate::physics::velocity_band;
use crate::quasi_static::{StaticQuestion, quasi_static};
use crate::rotor::{Rotor, RotorDefinition};
use crate::simulate::{Model, StaticState, reference_settings};
use crate::steady::{
    MotionRange, Orbit, SteadyError, SteadyLines, SteadyQuestion, orbit_alone, orbit_near, steady,
};
use crate::study::campbell::{CampbellError, CampbellQuestion};
use crate::study::many::{Keep, Maker, NumberColumn, Schedule, Unmade, static_columns};
use crate::study::plan::{Plan, Sampling};

/// Part of its order within which a line is that of the shaft.
const NEAR: f64 = 1e-9;

/// A question about a scene.
#[derive(Debug, Clone)]
pub enum Question {
    /// The static equilibrium of the shaft.
    Bearing(StaticQuestion),
    /// Natural frequencies at the speed of a shaft, and its critical speeds where they are asked for.
    Campbell(Box<RotorDefinition>, Option<Box<CampbellQuestion>>),
    /// The motion that a shaft settles to, over so many periods.
    Steady(Model, Option<u32>),
    /// A run, of its numbers those that are asked for, and its named lines up to an order of the shaft where one is given.
    Run(Model, Vec<NumberColumn>, Option<f64>),
}

impl Question {
    /// Answers it, a motion from that of a neighbouring scene where one is known.
    ///
    /// # Errors
    /// [`NoAnswer`] where there is none, or it was to stop.
    pub fn answer(&self, near: Option<&Orbit>, stop: &AtomicBool) -> Result<Answer, NoAnswer> {
        match self {
            Self::Bearing(question) => of_statics(question),
            Self::Campbell(rotor, critical) => of_modes(rotor, critical.as_deref(), stop),
            Self::Steady(model, multiple) => of_motion(model, *multiple, near, stop),
            Self::Run(model, columns, order) => of_run(model, columns, *order, stop),
        }
    }
}

fn of_statics(question: &StaticQuestion) -> Result<Answer, NoAnswer> {
    let found = quasi_static(question).map_err(NoAnswer::failed)?;
    // what Newton's method leaves, relative to the forces in play
    let number = |own: &NumberColumn| {
        let value = own.in_answer(&found);
        Number::new(&own.column, value, found.residual * value.abs())
    };
    Ok(Answer {
        numbers: static_columns(&question.rotor).iter().map(number).collect(),
        ..Answer::default()
    })
}

fn of_modes(
    rotor: &RotorDefinition,
    critical: Option<&CampbellQuestion>,
    stop: &AtomicBool,
) -> Result<Answer, NoAnswer> {
    let assembled = Rotor::assemble(rotor).map_err(NoAnswer::failed)?;
    let modes = StaticState::from_rotor(&assembled).natural_frequencies;
    let mut numbers: Vec<Number> = Vec::new();
    for (place, mode) in (1..).zip(modes) {
        let [frequency, ratio] = mode_columns(place);
        numbers.push(Number::new(&frequency, mode.frequency, f64::NAN));
        numbers.push(Number::new(&ratio, mode.damping_ratio, f64::NAN));
    }
    if let Some(critical) = critical {
        let found = critical.solve(stop).map_err(|error| match error {
            CampbellError::Stopped => NoAnswer::Stopped,
            error => NoAnswer::failed(error),
        })?;
        let speeds = (1..=CRITICAL_SPEEDS).zip(&found.critical_speeds);
        numbers.extend(speeds.map(|(place, own)| {
            let error = own.speed * own.error();
            Number::new(&critical_column(place), own.speed, error)
        }));
    }
    Ok(Answer {
        numbers,
        ..Answer::default()
    })
}

fn of_motion(
    model: &Model,
    multiple: Option<u32>,
    near: Option<&Orbit>,
    stop: &AtomicBool,
) -> Result<Answer, NoAnswer> {
    let question = SteadyQuestion {
        model,
        multiple,
        stop,
        integrated: &AtomicU64::new(0),
    };
    let answer = |orbit| answer_of(orbit, model, f64::NAN);
    // near another one it is found at once, else by itself, and with its stability where that is in doubt
    let found = match near {
        Some(near) if model.verify => measured_near(&question, near).map(Some),
        Some(near) => orbit_near(&question, near).map(|orbit| Some(answer(orbit))),
        None if model.verify || multiple.is_some() => Ok(None),
        None => orbit_alone(&question).map(|orbit| orbit.map(answer)),
    };
    match found {
        Ok(Some(answer)) => return Ok(answer),
        Err(error) if error.is_interrupted() => return Err(NoAnswer::Stopped),
        _ => {}
    }
    let found = steady(&question).map_err(|error| match error.is_interrupted() {
        true => NoAnswer::Stopped,
        false => NoAnswer::failed(error),
    })?;
    let error = found.measured.as_ref();
    let error = error.map_or(f64::NAN, |error| error.relative);
    Ok(answer_of(Orbit::from_steady(found, model), model, error))
}

/// The answer of a motion with the errors of its numbers: their distances from those of one that is found again from it at a
/// tenth of the tolerance.
fn measured_near(question: &SteadyQuestion<'_>, near: &Orbit) -> Result<Answer, SteadyError> {
    let model = question.model;
    let finer = Model {
        integrator: reference_settings(model.integrator),
        ..model.clone()
    };
    let again = SteadyQuestion {
        model: &finer,
        ..*question
    };
    let reference = answer_of(orbit_near(&again, near)?, model, f64::NAN);
    let mut answer = answer_of(orbit_near(question, near)?, model, f64::NAN);
    for (own, other) in answer.numbers.iter_mut().zip(&reference.numbers) {
        own.error = (own.value - other.value).abs();
    }
    for own in &mut answer.lines {
        let mut others = reference.lines.iter();
        let other = others.find(|other| other.channel == own.channel && other.name == own.name);
        if let Some(other) = other {
            let [here, there] =
                [&*own, other].map(|line| Complex::from_polar(line.amplitude, line.phase));
            own.error = (here - there).norm();
        }
    }
    Ok(answer)
}

/// The numbers and named lines of a motion whose error, relative to its size, is known or NaN.
fn answer_of(orbit: Orbit, model: &Model, error: f64) -> Answer {
    let (ranges, lines) = (&orbit.ranges, &orbit.lines);
    let speed = model.rotor.speed;
    let numbers = ranges.iter().enumerate();
    Answer {
        numbers: numbers
            .flat_map(|(index, range)| motion_numbers(range, lines, index, speed, error))
            .collect(),
        lines: named_lines(ranges, lines, &orbit.causes, error),
        orbit: Some(orbit),
    }
}

/// Half the range of a quantity: what the error of a motion is relative to.
fn size(range: &MotionRange) -> f64 {
    0.5 * range.peak_to_peak
}

/// The values of [`motion_columns`] of a channel.
fn motion_numbers(
    range: &MotionRange,
    lines: &SteadyLines,
    index: usize,
    speed: f64,
    error: f64,
) -> Vec<Number> {
    let moving = || lines.lines.iter().filter(|line| line.frequency > 0.0);
    let order = |order: f64| {
        let frequency = order * speed / TAU;
        let near = |line: &f64| (line - frequency).abs() <= NEAR * frequency;
        let found = moving().find(|line| near(&line.frequency));
        found.map_or(0.0, |line| line.amplitude[index])
    };
    let [low, high] = velocity_band(speed);
    let in_band = moving().filter(|line| (low..=high).contains(&line.frequency));
    // v_rms² = Σ (2πf a)²/2
    let square = in_band.map(|line| 0.5 * (TAU * line.frequency * line.amplitude[index]).powi(2));
    let velocity = square.sum::<f64>().sqrt();
    let values = [range.mean, range.rms, range.peak_to_peak];
    let values = values.into_iter().chain([1.0, 2.0, 3.0].map(order));
    let columns = motion_columns(range.channel);
    let numbers = columns.iter().zip(values.chain([velocity]));
    numbers
        .map(|(column, value)| {
            let part = if column.unit == range.channel.unit() {
                1.0
            } else {
                value / range.rms
            };
            Number::new(column, value, error * size(range) * part)
        })
        .collect()
}

/// The lines whose causes are known, of every channel.
fn named_lines(
    ranges: &[MotionRange],
    lines: &SteadyLines,
    causes: &[Line],
    error: f64,
) -> Vec<NamedLine> {
    let mut named: Vec<NamedLine> = Vec::new();
    for line in &lines.lines {
        let Some(cause) = line.cause(causes) else {
            continue;
        };
        let name = cause.kind.to_string();
        for (index, range) in ranges.iter().enumerate() {
            named.push(NamedLine {
                channel: range.channel,
                name: name.clone(),
                frequency: line.frequency,
                amplitude: line.amplitude[index],
                phase: line.phase[index],
                error: error * size(range),
            });
        }
    }
    named
}

fn of_run(
    model: &Model,
    columns: &[NumberColumn],
    highest_order: Option<f64>,
    stop: &AtomicBool,
) -> Result<Answer, NoAnswer> {
    let plan = Plan::new(Vec::new(), Sampling::Grid, 0);
    let maker = Maker {
        plan: &plan,
        schedule: Schedule::new(1, 1, None),
        keep: Keep {
            highest_order,
            ..Keep::default()
        },
        verify_every: u64::from(model.verify),
        traces: None,
        columns,
        model: &|_| Ok(model.clone()),
        stop,
    };
    let found = std::cell::Cell::new(None);
    maker.chain(0, &|made| {
        found.set(Some(made));
        false
    });
    let outcome = match found.into_inner() {
        Some(Ok(record)) => record.outcome.map_err(NoAnswer::Failed)?,
        Some(Err(Unmade::Trace(error))) => return Err(NoAnswer::failed(error)),
        Some(Err(Unmade::Stopped)) | None => return Err(NoAnswer::Stopped),
    };
    let values = columns.iter().zip(outcome.numbers);
    let measured = values.clone().find(|(own, _)| own.is_error());
    let error = measured.map_or(f64::NAN, |(_, error)| error);
    let numbers = values
        .map(|(own, value)| Number::new(&own.column, value, error * value.abs()))
        .collect();
    let lines = outcome.peaks.into_iter().filter_map(|peak| {
        Some(NamedLine {
            channel: peak.channel,
            name: peak.name?,
            frequency: peak.frequency,
            amplitude: peak.amplitude,
            phase: f64::NAN,
            error: error * peak.amplitude,
        })
    });
    Ok(Answer {
        numbers,
        lines: lines.collect(),
        orbit: None,
    })
}
