//! From `[[axis]]` to the values of a plan.

use super::input::{AxisInput, DistributionKind, Spacing};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::scalar::Scalar;
use crate::scenario::vary::Key;
use crate::study::Variable;
use crate::study::plan::{Axis, AxisValues, Distribution};

/// How many standard deviations a normal distribution reaches: beyond lies less than one draw in 10¹⁶.
const REACH: f64 = 8.3;

/// An axis of a study: a key of the base and its values.
pub(super) struct AxisBuilder<'a, 'p> {
    /// Path of the axis in the study file.
    pub path: String,
    pub input: &'a AxisInput,
    pub key: &'a Key<'static>,
    pub problems: &'a mut Problems<'p>,
}

impl AxisBuilder<'_, '_> {
    /// The axis with what varies, if nothing contradicts it.
    pub fn build(mut self) -> Option<(Axis, Variable)> {
        self.refuse_strangers();
        let values = match (&self.input.values, self.input.distribution) {
            (Some(values), _) => self.listed(values.len())?,
            (None, Some(choice)) => AxisValues::Drawn(self.drawn(choice)?),
            (None, None) => self.spaced()?,
        };
        let shown = self.shown()?;
        Some((Axis { values }, shown))
    }

    fn at(&self, name: &str) -> String {
        format!("{}.{name}", self.path)
    }

    fn refuse(&mut self, name: &str, message: String, help: &str) {
        let issue = Issue::new(self.at(name), message).help(help);
        self.problems.refuse(issue, &[]);
    }

    /// Keys that are given.
    fn given(&self) -> [(&'static str, &Option<Scalar>); 7] {
        let input = self.input;
        [
            ("from", &input.from),
            ("to", &input.to),
            ("mean", &input.mean),
            ("deviation", &input.deviation),
            ("mode", &input.mode),
            ("lowest", &input.lowest),
            ("highest", &input.highest),
        ]
    }

    /// Refuses keys that do not belong to the way in which the values are given.
    fn refuse_strangers(&mut self) {
        let (way, own): (&str, &[&str]) = match (&self.input.values, self.input.distribution) {
            (Some(_), _) => ("`values`", &[]),
            (None, None) => ("`count`", &["from", "to"]),
            (None, Some(DistributionKind::Uniform)) => {
                ("distribution = \"uniform\"", &["from", "to"])
            }
            (None, Some(DistributionKind::Normal)) => (
                "distribution = \"normal\"",
                &["mean", "deviation", "lowest", "highest"],
            ),
            (None, Some(DistributionKind::Triangular)) => (
                "distribution = \"triangular\"",
                &["lowest", "mode", "highest"],
            ),
        };
        let given = self.given();
        let strangers = given
            .iter()
            .filter(|(name, value)| value.is_some() && !own.contains(name));
        let strangers: Vec<_> = strangers.map(|(name, _)| *name).collect();
        for name in strangers {
            self.refuse(
                name,
                format!("{way} does not go with `{name}`"),
                "remove it",
            );
        }
        if self.input.spacing.is_some() && self.input.count.is_none() {
            let message = format!("{way} does not go with `spacing`");
            self.refuse("spacing", message, "remove it");
        }
    }

    /// A value of the key in SI units.
    fn number(&mut self, name: &str) -> Option<f64> {
        let value = self.key.read(self.at(name), self.problems)?;
        Some(self.key.si(&value.value))
    }

    /// Values that must be given.
    fn needed<const N: usize>(&mut self, names: [&str; N], by: &str) -> Option<[f64; N]> {
        let mut values = [None; N];
        for (value, name) in values.iter_mut().zip(names) {
            if self.given().contains(&(name, &None)) {
                let issue = Issue::new(self.path.clone(), format!("{by} needs `{name}`"));
                self.problems.refuse(issue, &[]);
            } else {
                *value = self.number(name);
            }
        }
        values
            .iter()
            .all(Option::is_some)
            .then(|| values.map(Option::unwrap_or_default))
    }

    /// Refuses a whole number, which has no values between two.
    fn refuse_whole(&mut self, name: &str, help: &str) -> Option<()> {
        if !self.key.is_whole() {
            return Some(());
        }
        let message = format!("`{}` is a whole number", self.input.key);
        self.refuse(name, message, help);
        None
    }

    fn listed(&mut self, count: usize) -> Option<AxisValues> {
        let values = (0..count).map(|index| self.number(&format!("values[{index}]")));
        let values: Vec<_> = values.collect();
        Some(AxisValues::Listed(
            values.into_iter().collect::<Option<_>>()?,
        ))
    }

    fn spaced(&mut self) -> Option<AxisValues> {
        self.refuse_whole("count", "list its `values`")?;
        let [from, to] = self.needed(["from", "to"], "`count`")?;
        let logarithmic = self.input.spacing == Some(Spacing::Logarithmic);
        if logarithmic && !(from > 0.0 && to > 0.0) {
            let message = "values of equal ratios cannot come from zero or below".to_owned();
            self.refuse("spacing", message, "let both ends be above zero");
            return None;
        }
        Some(AxisValues::Spaced {
            from,
            to,
            count: self.input.count?,
            logarithmic,
        })
    }

    fn drawn(&mut self, choice: DistributionKind) -> Option<Distribution> {
        let help = "list its `values`: they are drawn evenly";
        self.refuse_whole("distribution", help)?;
        let distribution = match choice {
            DistributionKind::Uniform => {
                let [lowest, highest] = self.needed(["from", "to"], "a uniform distribution")?;
                Distribution::Uniform { lowest, highest }
            }
            DistributionKind::Normal => self.normal()?,
            DistributionKind::Triangular => {
                let names = ["lowest", "mode", "highest"];
                let [lowest, mode, highest] = self.needed(names, "a triangular distribution")?;
                Distribution::Triangular {
                    lowest,
                    mode,
                    highest,
                }
            }
        };
        let checked = distribution.checked();
        checked
            .map_err(|error| {
                let issue = Issue::new(self.at("distribution"), error.to_string());
                self.problems
                    .refuse(issue.help("numbers in SI units; change its bounds"), &[]);
            })
            .ok()
    }

    fn normal(&mut self) -> Option<Distribution> {
        let [mean, deviation] = self.needed(["mean", "deviation"], "a normal distribution")?;
        let input = self.input;
        let lowest = self.bound("lowest", &input.lowest, mean - REACH * deviation)?;
        let highest = self.bound("highest", &input.highest, mean + REACH * deviation)?;
        Some(Distribution::Normal {
            mean,
            deviation,
            lowest,
            highest,
        })
    }

    /// A bound of a normal distribution; where none is given, how far it reaches, if the key can have that
    /// value.
    fn bound(&mut self, name: &str, given: &Option<Scalar>, reach: f64) -> Option<f64> {
        if given.is_some() {
            return self.number(name);
        }
        if self.key.contains(reach) {
            return Some(reach);
        }
        let message = format!(
            "a normal distribution needs `{name}` here: without it draws reach {reach:.4e}, which `{}` cannot \
             be",
            self.input.key
        );
        self.problems
            .refuse(Issue::new(self.path.clone(), message), &[]);
        None
    }

    /// What varies, shown in the unit of the first value given.
    fn shown(&self) -> Option<Variable> {
        let listed = self.input.values.as_ref().and_then(|values| values.first());
        let others = self
            .given()
            .into_iter()
            .find_map(|(_, value)| value.as_ref());
        let first = listed.or(others)?;
        Some(self.key.variable(&first.0))
    }
}
