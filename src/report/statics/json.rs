//! The answer as JSON, every number with its unit in its name.

use serde_json::{Map, Value, json};

use super::super::columns::{ball_pass, matrix};
use super::csv::race_name;
use crate::analysis::Channel;
use crate::bearing::{
    BallLine, BearingState, FilmState, Matrix5, RaceContact, StiffnessShares, Vector5,
};
use crate::quasi_static::{QuasiStatic, Twist};
use crate::rotor::FREEDOMS;

/// The whole answer, with the scenario as it is.
pub fn answer_json(title: &str, scenario: &Value, found: &QuasiStatic) -> Value {
    let mut document = json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
    });
    if let (Value::Object(entries), Value::Object(more)) = (&mut document, answer(found)) {
        entries.extend(more);
    }
    document
}

/// The answer without title and scenario.
pub(in super::super) fn answer(answer: &QuasiStatic) -> Value {
    let mut stiffness = matrix(&answer.stiffness);
    stiffness["named"] = named_stiffness(&answer.stiffness);
    stiffness["condition"] = answer.condition.into();
    json!({
        "equilibrium": equilibrium(answer),
        "force": components(Channel::Force, &answer.force),
        "stiffness": stiffness,
        "twist": answer.twist.map(twist),
        "bearings": answer.bearings.iter().map(bearing).collect::<Value>(),
        "warnings": answer.warnings,
    })
}

/// The diagonal of K by name.
fn named_stiffness(stiffness: &Matrix5) -> Value {
    json!({
        "K_x_N_m": stiffness[(0, 0)],
        "K_y_N_m": stiffness[(1, 1)],
        "K_z_N_m": stiffness[(2, 2)],
        "K_tilt_x_N_m_rad": stiffness[(3, 3)],
        "K_tilt_y_N_m_rad": stiffness[(4, 4)],
    })
}

fn equilibrium(answer: &QuasiStatic) -> Value {
    let mut entries = components(Channel::Displacement, &answer.displacement);
    let free = (0..FREEDOMS).filter(|&axis| answer.free[axis]);
    entries["free"] = free
        .map(|axis| Channel::Displacement(axis).name())
        .collect();
    entries["residual"] = answer.residual.into();
    entries["newton_steps"] = answer.newton_steps.into();
    entries
}

fn components(channel: fn(usize) -> Channel, values: &Vector5) -> Value {
    let names = (0..FREEDOMS).map(channel).map(Channel::column);
    let values = values.iter().map(|value| Value::from(*value));
    Value::Object(names.zip(values).collect::<Map<_, _>>())
}

fn twist(twist: Twist) -> Value {
    json!({ "moment_N_m": twist.moment, "angle_rad": twist.angle })
}

fn bearing(state: &BearingState) -> Value {
    json!({
        "displacement": components(Channel::Displacement, &state.displacement),
        "force": components(Channel::Force, &state.force),
        "stiffness": matrix(&state.stiffness),
        "shares": state.shares.as_ref().map(shares),
        "balls_loaded": state.balls_loaded,
        "life_Mrev": state.life,
        "static_safety": state.static_safety,
        "friction_moment": {
            "load_N_m": state.friction_moment.load,
            "viscous_N_m": state.friction_moment.viscous,
            "total_N_m": state.friction_moment.total(),
        },
        "ball_pass": ball_pass(&state.ball_pass),
        "balls": state.balls.iter().map(ball).collect::<Value>(),
        "warnings": state.warnings,
    })
}

fn shares(shares: &StiffnessShares) -> Value {
    json!({
        "contacts": named_stiffness(&shares.contacts),
        "films": named_stiffness(&shares.films),
    })
}

fn ball(line: &BallLine) -> Value {
    json!({
        "azimuth_rad": line.azimuth,
        "deformation_m": line.deformation,
        "inner": contact(&line.inner),
        "outer": contact(&line.outer),
        "centrifugal_force_N": line.centrifugal_force,
        "gyroscopic_moment_N_m": line.gyroscopic_moment,
        "controlling_race": line.controlling_race.map(race_name),
    })
}

fn contact(contact: &RaceContact) -> Value {
    json!({
        "load_N": contact.load,
        "angle_rad": contact.angle,
        "approach_m": contact.approach,
        "semi_major_m": contact.semi_major,
        "semi_minor_m": contact.semi_minor,
        "peak_pressure_Pa": contact.peak_pressure,
        "contact_stiffness_N_m": contact.contact_stiffness,
        "film": contact.film.map(film),
        "spin_to_roll": contact.spin_to_roll,
        "shoulder_margin_rad": contact.shoulder_margin,
    })
}

fn film(film: FilmState) -> Value {
    json!({
        "central_m": film.central,
        "minimum_m": film.minimum,
        "stiffness_N_m": film.stiffness,
        "lambda": film.lambda,
    })
}
