//! The response of the linearised shaft to a harmonic force or to its unbalances.

use std::f64::consts::TAU;
use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use super::AskError;
use crate::report::{Findings, linear_response_findings};
use crate::rotor::{FREEDOM_NAMES, Pickup};
use crate::scenario::{Issue, Scenario, frequency, position as position_of, speed};
use crate::study::linear_response;

/// Fewest and most speeds or frequencies.
pub const COUNTS: std::ops::RangeInclusive<i64> = 3..=100_000;

/// A point and a direction, or a point and both directions across the shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Place(Vec<Pickup>);

/// `250 mm`, along x and y, or `y@250 mm`, or a tilt, `tilt_x@250 mm`: of a force its moment about X.
impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (axes, position) = match text.split_once('@') {
            None => (vec![0, 1], text),
            Some((name, position)) => {
                let axis = FREEDOM_NAMES.iter().position(|known| *known == name.trim());
                let axis = axis.ok_or_else(|| {
                    format!(
                        "`{name}` is no direction: write one of {}@ before the position",
                        FREEDOM_NAMES.join("@, ")
                    )
                })?;
                (vec![axis], position)
            }
        };
        let position = position_of(position.trim()).map_err(|issue| issue.to_string())?;
        Ok(Self(
            axes.into_iter()
                .map(|axis| Pickup { position, axis })
                .collect(),
        ))
    }
}

/// The response over the speed or the frequency.
#[derive(Debug, Clone)]
pub struct LinearResponseQuestion<'a> {
    scenario: &'a Scenario,
    question: linear_response::LinearResponseQuestion,
}

/// What is asked, as it was written.
#[derive(Debug, Clone)]
pub struct LinearRange<'a> {
    /// First speed, or frequency of a force.
    pub from: &'a str,
    /// Last one.
    pub to: &'a str,
    /// Number of them.
    pub count: usize,
}

impl<'a> LinearResponseQuestion<'a> {
    /// Asks about the motion at some places by the unbalances over the speed, or by a force over its frequency at a speed in
    /// rad/s.
    ///
    /// # Errors
    /// [`AskError::Asked`] where the range is empty, no place is named, or one is off the shaft.
    pub fn new(
        scenario: &'a Scenario,
        at: &[Place],
        by: Option<(&Place, Option<f64>)>,
        range: &LinearRange<'_>,
    ) -> Result<Self, AskError> {
        if at.is_empty() {
            let issue = Issue::new("at", "no place is named");
            return Err(issue.help("for instance: \"250 mm\"").into());
        }
        let mut rotor = scenario.question.rotor.clone();
        let force = match by {
            None => None,
            Some((place, given)) => {
                rotor = rotor.at_constant_speed(given.unwrap_or(rotor.speed));
                let [pickup] = place.0[..] else {
                    let message = "a force needs a direction";
                    let issue = Issue::new("by", message);
                    return Err(issue.help("for instance: --by \"y@250 mm\"").into());
                };
                Some(pickup)
            }
        };
        let read = |text: &str| match force {
            None => speed(text),
            Some(_) => Ok(TAU * frequency(text)?),
        };
        let at: Vec<_> = at
            .iter()
            .flat_map(|place| place.0.iter().copied())
            .collect();
        for pickup in at.iter().chain(&force) {
            check(pickup, scenario)?;
        }
        let (from, to) = (read(range.from)?, read(range.to)?);
        if from >= to {
            let message = format!("the range from {} to {} is empty", range.from, range.to);
            return Err(Issue::new("to", message)
                .help("give a higher last value")
                .into());
        }
        if force.is_none() && !rotor.is_unbalanced() {
            let message = "the shaft has no unbalance that it could respond to";
            return Err(Issue::new("unbalance", message)
                .help("add [[unbalance]], or ask for the response to a force: --by \"y@250 mm\"")
                .into());
        }
        Ok(Self {
            scenario,
            question: linear_response::LinearResponseQuestion {
                rotor,
                at,
                by: force,
                range: [from, to],
                count: range.count,
            },
        })
    }

    /// Responses and resonances, until `stop` is set.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the shaft has no equilibrium at a speed, or it was stopped.
    pub fn answer(&self, stop: &AtomicBool) -> Result<Findings, AskError> {
        let found = self.question.solve(stop).map_err(AskError::failed)?;
        let rotor = &self.scenario.question.rotor;
        Ok(linear_response_findings(
            self.scenario,
            &self.question,
            &found,
            rotor.highest_speed(),
        ))
    }
}

/// Refuses a place off the shaft, and one that cannot move that way.
fn check(pickup: &Pickup, scenario: &Scenario) -> Result<(), Issue> {
    let axis = FREEDOM_NAMES[pickup.axis];
    if !scenario.question.rotor.shaft.freedoms.moves(pickup.axis) {
        return Err(Issue::new("at", format!("the shaft is held along {axis}")));
    }
    check_on_shaft(pickup.position, scenario)
}

/// Refuses a position off a shaft that bends; a rigid one goes on for ever.
pub(super) fn check_on_shaft(position: f64, scenario: &Scenario) -> Result<(), Issue> {
    let Some(shaft) = &scenario.question.rotor.flexible else {
        return Ok(());
    };
    if shaft.reaches(position) {
        return Ok(());
    }
    let [left, right] = shaft.ends();
    let message = format!(
        "{:.1} mm lies off the shaft, which reaches from {:.1} to {:.1} mm",
        1e3 * position,
        1e3 * left,
        1e3 * right
    );
    Err(Issue::new("at", message))
}
