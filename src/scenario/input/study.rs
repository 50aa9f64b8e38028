//! `[study]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::scenario::axis::{AxisInput, AxisReader, Scalar};
use crate::scenario::key::{self, KeyPaths, number_keys};
use crate::scenario::problems::Problems;
use crate::scenario::{Issue, questions_at, without};
use crate::study::{Study, StudyPoint};

/// One number of the scenario that takes many values, the static question answered at each
/// (`jeffcott bearing`).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["values", "count"]))]
pub struct StudyInput {
    /// Path of the key that takes the values, for instance "load[1].constant.z",
    /// "speed.constant" or "bearing[1].preload"; "bearing[*].preload", or a list of paths, changes several keys
    /// together.
    #[schemars(extend("examples" = ["speed.constant"]))]
    pub vary: KeyPaths,
    /// The values, each written as that key is, for instance ["200 N", "400 N"].
    #[schemars(extend("minItems" = 1, "maxItems" = 10_000))]
    pub values: Option<Vec<Scalar>>,
    /// First of `count` evenly spaced values.
    pub from: Option<Scalar>,
    /// Last of `count` evenly spaced values.
    pub to: Option<Scalar>,
    /// How many evenly spaced values, 2 to 10000.
    #[schemars(range(min = 2, max = 10_000))]
    pub count: Option<u32>,
    /// At how many azimuths around a bearing, from +X on, deformation and contact angle are
    /// evaluated, 3 to 3600. Default: where its balls are.
    #[schemars(range(min = 3, max = 3600))]
    pub positions: Option<u32>,
}

/// Tables that play no part in a static question, and the study itself.
const LEFT_OUT: [&str; 6] = [
    "damping",
    "initial",
    "time",
    "integrator",
    "output",
    "study",
];

impl StudyInput {
    /// The static question at every value, as far as nothing contradicts it; `scenario` has its defaults
    /// written out.
    pub fn build(&self, scenario: &Value, problems: &mut Problems<'_>) -> Option<Study> {
        let base = without(scenario, &LEFT_OUT);
        let known = number_keys(&base, &LEFT_OUT);
        let found = key::find(&known, self.vary.all(), "study.vary");
        let key = problems.take(found.map_err(|issue| self.unknown(issue)))?;
        let input = AxisInput {
            values: self.values.clone(),
            from: self.from.clone(),
            to: self.to.clone(),
            count: self.count.map(u64::from),
            ..AxisInput::default()
        };
        let (axis, variable) = problems.inside("study", |problems| {
            let reader = AxisReader {
                named: ".vary",
                input: &input,
                key: &key,
                problems,
            };
            reader.build()
        })?;
        let count = axis.length();
        let mut points = Vec::new();
        for index in 0..count {
            let value = axis.value(index);
            let questions = questions_at(&base, &key, value, problems.folder);
            let questions = questions.map_err(|issue| Issue {
                path: self.place(index, count),
                ..issue
            });
            let question = problems.take(questions)?.question;
            points.push(StudyPoint { value, question });
        }
        Some(Study {
            variable,
            points,
            positions: self.positions.map(|positions| positions as usize),
            warnings: Vec::new(),
        })
    }

    /// The issue of a number that there is none of, or that plays no part.
    fn unknown(&self, issue: Issue) -> Issue {
        let left_out = self.vary.all().iter().find(|path| {
            let table = path.split(['.', '[']).next().unwrap_or_default();
            LEFT_OUT.contains(&table)
        });
        let Some(path) = left_out else { return issue };
        let message = format!("`{path}` plays no part in a static question");
        Issue { message, ..issue }
    }

    /// Path of the key that gives a value.
    fn place(&self, index: u64, count: u64) -> String {
        match (&self.values, index) {
            (Some(_), _) => format!("study.values[{}]", index + 1),
            (None, 0) => "study.from".to_owned(),
            (None, last) if last + 1 == count => "study.to".to_owned(),
            _ => "study.vary".to_owned(),
        }
    }
}
