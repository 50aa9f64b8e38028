//! The motion that a shaft settles to, along a number of its scenario.

use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64};

use super::{AskError, motion};
use crate::report::{Findings, ResponseError, response_findings};
use crate::scenario::{Issue, OpenScenario, Scenario};
use crate::simulate::Model;
use crate::steady::{self, response, response_warnings};
use crate::study::Variable;

/// A number of a scenario and its two ends, as they are written there.
#[derive(Debug, Clone)]
pub struct Followed<'a> {
    /// Key of the number, as `speed.constant`.
    pub key: &'a str,
    /// First value.
    pub from: &'a str,
    /// Last value.
    pub to: &'a str,
}

/// The motion that a shaft settles to, along a number of its scenario.
#[derive(Debug, Clone)]
pub struct ResponseQuestion<'a> {
    scenario: &'a Scenario,
    model: &'a Model,
    number: OpenScenario,
    variable: Variable,
    ends: [f64; 2],
    /// Periods of the forcing that the motion takes.
    pub multiple: u32,
    /// Most motions of a branch.
    pub points: usize,
    /// Whether motions of doubled period are followed, too.
    pub doubled: bool,
}

impl<'a> ResponseQuestion<'a> {
    /// Motions a branch has at most, where nothing else is asked for.
    pub const MOST_POINTS: usize = 20_000;

    /// Asks about a scenario whose files are in `folder`.
    ///
    /// # Errors
    /// [`AskError::Asked`] where nothing moves, where there is no such number, or where the scenario does not exist at
    /// its ends.
    pub fn new(
        scenario: &'a Scenario,
        followed: &Followed<'_>,
        folder: &Path,
    ) -> Result<Self, AskError> {
        let model = motion(scenario)?;
        let number = OpenScenario::new(scenario, [followed.key], folder)?;
        let (first, variable) = number.value(followed.from)?;
        let (last, _) = number.value(followed.to)?;
        if first == last {
            let message = format!("`{}` from and to are the same value", followed.key);
            return Err(Issue::new(followed.key, message).into());
        }
        for end in [first, last] {
            number.rotor(end)?;
        }
        Ok(Self {
            scenario,
            model,
            number,
            variable,
            ends: [first, last],
            multiple: 1,
            points: Self::MOST_POINTS,
            doubled: true,
        })
    }

    /// Follows the motion until its end or `stop` is set, telling the part of the range that is done and counting the
    /// periods that it integrates.
    ///
    /// # Errors
    /// [`AskError::Failed`] where no motion is found.
    pub fn answer(
        &self,
        stop: &AtomicBool,
        integrated: &AtomicU64,
        reached: &mut dyn FnMut(f64),
    ) -> Result<Findings, AskError> {
        let question = steady::ResponseQuestion {
            model: self.model,
            family: &|value| self.number.rotor(value).map_err(|issue| issue.to_string()),
            range: self.ends,
            multiple: self.multiple,
            points: self.points,
            doubled: self.doubled,
            stop,
            integrated,
        };
        let branches = response(&question, reached).map_err(AskError::failed)?;
        let warnings = response_warnings(&question, &branches);
        let error = ResponseError::largest(&branches, self.model.integrator.tolerance);
        let variable = &self.variable;
        Ok(response_findings(
            self.scenario,
            variable,
            &branches,
            error,
            &warnings,
        ))
    }
}
