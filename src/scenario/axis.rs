//! The values that a number of a scenario takes: listed, evenly spaced or drawn.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::Issue;
use super::key::Key;
use super::key_path::{KeyPaths, entry};
use super::problems::Problems;
use crate::study::Variable;
use crate::study::plan::{Axis, Distribution, MOST_RUNS, Shape};

/// How many standard deviations a normal distribution reaches: beyond lies less than one draw in 10¹⁶.
const REACH: f64 = 8.3;

/// One number of the base that takes many values: by a list, evenly spaced or drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["values", "count", "distribution"]))]
pub struct AxisInput {
    /// Path of its key, for instance "speed.constant" or, of the first bearing, "bearing[1].preload"; "bearing[*].preload",
    /// or a list of paths, changes several keys together.
    #[schemars(extend("examples" = ["speed.constant"]))]
    pub key: KeyPaths,
    /// The values, each written as that key is.
    #[schemars(extend("minItems" = 1, "maxItems" = 1_000_000))]
    pub values: Option<Vec<Scalar>>,
    /// First of `count` values, or least value of a uniform distribution.
    pub from: Option<Scalar>,
    /// Last of `count` values, or largest value of a uniform distribution.
    pub to: Option<Scalar>,
    /// How many evenly spaced values.
    #[schemars(range(min = 2, max = MOST_RUNS))]
    pub count: Option<u64>,
    /// Whether `count` values have equal differences or equal ratios. Default: "linear".
    pub spacing: Option<Spacing>,
    /// How values are drawn.
    pub distribution: Option<DistributionKind>,
    /// Mean of a normal distribution.
    pub mean: Option<Scalar>,
    /// Standard deviation of a normal distribution.
    pub deviation: Option<Scalar>,
    /// Most likely value of a triangular distribution.
    pub mode: Option<Scalar>,
    /// Least value of a normal or triangular distribution.
    pub lowest: Option<Scalar>,
    /// Largest value of a normal or triangular distribution.
    pub highest: Option<Scalar>,
}

/// Spacing of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal differences.
    Linear,
    /// Equal ratios.
    Logarithmic,
}

/// How values are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DistributionKind {
    /// Evenly between `from` and `to`.
    Uniform,
    /// By `mean` and `deviation`, cut off at `lowest` and `highest`.
    Normal,
    /// From `lowest` to `highest` with the most likely value `mode`.
    Triangular,
}

impl AxisInput {
    /// The values that are given one by one, by their keys.
    fn given(&self) -> [(&'static str, &Option<Scalar>); 7] {
        [
            ("from", &self.from),
            ("to", &self.to),
            ("mean", &self.mean),
            ("deviation", &self.deviation),
            ("mode", &self.mode),
            ("lowest", &self.lowest),
            ("highest", &self.highest),
        ]
    }

    /// The key that says how the values are given, what messages call it, and the keys that go with it.
    fn form(&self) -> (&'static str, &'static str, &'static [&'static str]) {
        use DistributionKind as Kind;
        let (called, own): (_, &[_]) = match (&self.values, self.distribution) {
            (Some(_), _) => return ("values", "`values`", &[]),
            (None, None) => return ("count", "`count`", &["from", "to"]),
            (None, Some(Kind::Uniform)) => ("a uniform distribution", &["from", "to"]),
            (None, Some(Kind::Normal)) => {
                let own = &["mean", "deviation", "lowest", "highest"];
                ("a normal distribution", own)
            }
            (None, Some(Kind::Triangular)) => {
                ("a triangular distribution", &["lowest", "mode", "highest"])
            }
        };
        ("distribution", called, own)
    }
}

/// An axis while it is read; its table is the present one.
pub(super) struct AxisReader<'a, 'p> {
    /// The key that names the number.
    pub named: &'static str,
    /// What is given.
    pub input: &'a AxisInput,
    /// The number.
    pub key: &'a Key,
    /// What is wrong.
    pub problems: &'a mut Problems<'p>,
}

impl AxisReader<'_, '_> {
    /// The axis with what varies, if nothing contradicts it.
    pub fn build(mut self) -> Option<(Axis, Variable)> {
        let AxisInput {
            values,
            count,
            distribution,
            ..
        } = self.input;
        if values.is_none() && count.is_none() && distribution.is_none() {
            // the one that is due was found missing or wrong before
            return None;
        }
        self.refuse_unrelated();
        if self.key.is_text() {
            return self.words();
        }
        let values = match (&self.input.values, self.input.distribution) {
            (Some(values), _) => self.listed(values.len())?,
            (None, Some(kind)) => Axis::Drawn(self.drawn(kind)?),
            (None, None) => self.spaced()?,
        };
        // in the unit of the first value given
        let listed = self.input.values.as_ref().and_then(|values| values.first());
        let others = self.input.given();
        let others = others.into_iter().find_map(|(_, value)| value.as_ref());
        Some((values, self.key.variable(&listed.or(others)?.0)))
    }

    /// The words that are listed, numbered from 0.
    fn words(&mut self) -> Option<(Axis, Variable)> {
        let path = &self.key.path;
        let Some(values) = &self.input.values else {
            let message = format!("`{path}` is no number: list its `values`");
            self.problems.refuse(Issue::new(self.named, message));
            return None;
        };
        let words = (0..values.len()).map(|index| {
            let place = self.problems.path(&entry(".values", index));
            let value = self.key.read(&place, self.problems)?;
            value.as_str().map(str::to_owned)
        });
        let words: Vec<_> = words
            .collect::<Vec<_>>()
            .into_iter()
            .collect::<Option<_>>()?;
        let places = (0..words.len()).map(|place| place as f64);
        let variable = self.key.variable(&Value::Null);
        Some((
            Axis::Listed(places.collect()),
            Variable { words, ..variable },
        ))
    }

    /// Refuses keys that do not go with the form in which the values are given.
    fn refuse_unrelated(&mut self) {
        let (form, called, own) = self.input.form();
        let values = self.input.given();
        let mut unrelated: Vec<_> = (values.iter())
            .filter(|(name, value)| value.is_some() && !own.contains(name))
            .map(|(name, _)| *name)
            .collect();
        if self.input.spacing.is_some() && self.input.count.is_none() {
            unrelated.push("spacing");
        }
        for name in unrelated {
            let message = format!("{called} does not go with `{name}`");
            let issue = Issue::new(format!(".{name}"), message).help("remove it");
            self.problems.refuse(issue.against(format!(".{form}")));
        }
    }

    /// A value of the key in SI units.
    fn number(&mut self, name: &str) -> Option<f64> {
        let path = self.problems.path(&format!(".{name}"));
        let value = self.key.read(&path, self.problems)?;
        Some(self.key.si(&value))
    }

    /// Values that must be given.
    fn needed<const N: usize>(&mut self, names: [&str; N]) -> Option<[f64; N]> {
        let (form, called, _) = self.input.form();
        let values = names.map(|name| {
            if !self.input.given().contains(&(name, &None)) {
                return self.number(name);
            }
            let issue = Issue::new(format!(".{name}"), format!("{called} needs `{name}`"));
            self.problems.refuse(issue.against(format!(".{form}")));
            None
        });
        let all = values.iter().all(Option::is_some);
        all.then(|| values.map(Option::unwrap_or_default))
    }

    /// Refuses a whole number, which has no values between two.
    fn refuse_whole(&mut self, form: &str) -> Option<()> {
        if !self.key.is_whole() {
            return Some(());
        }
        let path = &self.key.path;
        let message = format!("`{path}` is a whole number: list its `values`");
        let issue = Issue::new(self.named, message);
        self.problems.refuse(issue.against(format!(".{form}")));
        None
    }

    fn listed(&mut self, count: usize) -> Option<Axis> {
        let values = (0..count).map(|index| self.number(&entry("values", index)));
        let values: Vec<_> = values.collect();
        Some(Axis::Listed(values.into_iter().collect::<Option<_>>()?))
    }

    fn spaced(&mut self) -> Option<Axis> {
        self.refuse_whole("count")?;
        let [from, to] = self.needed(["from", "to"])?;
        let logarithmic = self.input.spacing == Some(Spacing::Logarithmic);
        if logarithmic && !(from > 0.0 && to > 0.0) {
            let message = "values of equal ratios cannot come from zero or below";
            let issue = Issue::new(".spacing", message);
            self.problems
                .refuse(issue.help("let both ends be above zero"));
            return None;
        }
        Some(Axis::Spaced {
            from,
            to,
            count: self.input.count?,
            logarithmic,
        })
    }

    fn drawn(&mut self, kind: DistributionKind) -> Option<Distribution> {
        self.refuse_whole("distribution")?;
        let (lowest, highest, shape) = match kind {
            DistributionKind::Uniform => {
                let [lowest, highest] = self.needed(["from", "to"])?;
                (lowest, highest, Shape::Uniform)
            }
            DistributionKind::Normal => {
                let [mean, deviation] = self.needed(["mean", "deviation"])?;
                let [least, most] = [mean - REACH * deviation, mean + REACH * deviation];
                let lowest = self.bound("lowest", &self.input.lowest, least)?;
                let highest = self.bound("highest", &self.input.highest, most)?;
                (lowest, highest, Shape::Normal { mean, deviation })
            }
            DistributionKind::Triangular => {
                let [lowest, mode, highest] = self.needed(["lowest", "mode", "highest"])?;
                (lowest, highest, Shape::Triangular { mode })
            }
        };
        let distribution = Distribution {
            lowest,
            highest,
            shape,
        };
        let checked = distribution.checked().map_err(|error| {
            let issue = Issue::new(".distribution", error.to_string());
            issue.help("numbers in SI units; change its bounds")
        });
        self.problems.take(checked)
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
            self.key.path
        );
        self.problems.refuse(Issue::new(".", message));
        None
    }
}

/// A string or a number, as it was written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub(super) struct Scalar(pub Value);

impl JsonSchema for Scalar {
    fn schema_name() -> Cow<'static, str> {
        "scalar".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["string", "number"] })
    }
}
