//! Natural frequencies over the speed.

use std::f64::consts::TAU;
use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use super::{AskError, Sensitivity};
use crate::fit::Question;
use crate::physics::BallPass;
use crate::quasi_static::StaticQuestion;
use crate::report::{Findings, campbell_findings};
use crate::rotor::{CageMotion, RotorDefinition};
use crate::scenario::{Issue, Scenario};
use crate::study::campbell::{self, check_range};

/// A multiple of the shaft's frequency, or what is one of every bearing.
#[derive(Debug, Clone, Copy)]
pub enum Order {
    /// A number.
    Number(f64),
    /// A frequency of the bearings by its name.
    OfBearings(&'static str, fn(&BallPass) -> f64),
}

impl FromStr for Order {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const OF_BEARINGS: [Order; 4] = [
            Order::OfBearings("bpfo", |pass| pass.outer),
            Order::OfBearings("bpfi", |pass| pass.inner),
            Order::OfBearings("ftf", |pass| pass.cage),
            Order::OfBearings("bsf", |pass| pass.spin),
        ];
        let text = text.trim();
        let is_named = |order: &Self| match order {
            Self::OfBearings(name, _) => text.eq_ignore_ascii_case(name),
            Self::Number(_) => false,
        };
        let named = OF_BEARINGS.into_iter().find(is_named);
        let number = || text.parse().ok().map(Self::Number);
        named
            .or_else(number)
            .ok_or("give a number, \"bpfo\", \"bpfi\", \"ftf\" or \"bsf\"")
    }
}

/// Highest speed where none is given, in parts of the highest of the scenario.
const BEYOND: f64 = 1.5;

/// Natural frequencies over the speed, and the critical speeds.
#[derive(Debug, Clone)]
pub struct CampbellQuestion<'a> {
    scenario: &'a Scenario,
    question: campbell::CampbellQuestion,
    /// Orders that are those of bearings, with their names.
    named: Vec<(f64, String)>,
    /// By what the answer is differentiated.
    pub sensitivity: Option<Sensitivity>,
}

impl<'a> CampbellQuestion<'a> {
    /// Asks about `count` speeds between two, rad/s, the last of which may be left to the scenario, crossings with some orders, and branches up to a frequency in Hz.
    ///
    /// # Errors
    /// [`AskError::Asked`] where the range is empty or an order is not positive.
    pub fn new(
        scenario: &'a Scenario,
        (from, to): (f64, Option<f64>),
        count: usize,
        orders: &[Order],
        highest: Option<f64>,
    ) -> Result<Self, AskError> {
        let rotor = scenario.question.rotor.clone();
        let to = to.unwrap_or(BEYOND * rotor.highest_speed());
        let (mut found, mut named): (Vec<f64>, _) = (Vec::new(), Vec::new());
        for order in orders {
            match order {
                Order::Number(order) if found.contains(order) => {}
                Order::Number(order) => found.push(*order),
                Order::OfBearings(name, of) => {
                    for (number, pass) in (1..).zip(ball_passes(&rotor, from)) {
                        let order = of(&pass);
                        if !found.contains(&order) {
                            found.push(order);
                            named.push((
                                order,
                                format!("{} of bearing {number}", name.to_uppercase()),
                            ));
                        }
                    }
                }
            }
        }
        let refused = |error: campbell::CampbellError| Issue::new("speed", error.to_string());
        check_range([from, to], count, &found).map_err(refused)?;
        Ok(Self {
            scenario,
            question: campbell::CampbellQuestion {
                rotor,
                from,
                to,
                count,
                orders: found,
                highest_frequency: highest,
            },
            named,
            sensitivity: None,
        })
    }

    /// Branches and critical speeds, until `stop` is set.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the shaft has no equilibrium at a speed, or it was stopped.
    pub fn answer(&self, stop: &AtomicBool) -> Result<Findings, AskError> {
        let found = self.question.solve(stop).map_err(AskError::failed)?;
        let (found, rotor) = (
            found.up_to(self.question.highest_frequency),
            &self.question.rotor,
        );
        let mut findings = campbell_findings(self.scenario, rotor, &found, &self.named);
        if let Some(asked) = &self.sensitivity {
            let question = |statics: StaticQuestion, _| {
                let mut critical = self.question.clone();
                critical.rotor = statics.rotor.clone();
                Question::Campbell(Box::new(statics.rotor), Some(Box::new(critical)))
            };
            findings.add_sensitivity(&asked.answer(question, stop)?);
        }
        Ok(findings)
    }
}

/// Ball passes a revolution of the shaft, with the cages as in a motion that starts at a speed in rad/s; also of cages that
/// the scene holds.
fn ball_passes(rotor: &RotorDefinition, speed: f64) -> Vec<BallPass> {
    let mut rotor = rotor.at_constant_speed(speed);
    if !rotor.cage.turns() {
        rotor.cage = CageMotion::default();
    }
    // what cannot be built is refused by the answer
    let supports = rotor.rolling_supports().unwrap_or_default();
    let passes = supports.iter().map(|support| support.ball_pass(TAU));
    passes.collect()
}
