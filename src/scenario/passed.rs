//! A checked scenario of which a few tables take other values again and again.

use std::path::Path;

use serde_json::{Map, Value};

use super::input::Questions;
use super::issue::Issue;
use super::node::{Content, Entry, Node};
use super::problems::Problems;
use super::vary::questions_of;
use super::{fill, schema, walk};

/// What the schema has passed of a scenario, table by table.
#[derive(Debug, Clone)]
pub(super) struct Passed {
    tables: Map<String, Value>,
}

impl Passed {
    /// Of a scenario without problems; the files that it names stand in `folder`.
    ///
    /// # Errors
    /// The first of its problems.
    pub fn new(scenario: &Value, folder: &Path) -> Result<Self, Issue> {
        questions_of(scenario, folder)?;
        let root = Node::from(scenario);
        let mut problems = Problems::new(&root, folder);
        match walk::value(&root, schema(), "", &mut problems) {
            Some(Value::Object(tables)) => Ok(Self { tables }),
            _ => Err(Issue::new("", "the scenario is no table")),
        }
    }

    /// What a scenario asks that differs from this one in the named tables alone: as by [`questions_of`], without
    /// another look at the rest. None where anything is wrong with it, or where this one has no such table.
    pub fn questions(
        &self,
        scenario: &Value,
        changed: &[String],
        folder: &Path,
    ) -> Option<Questions> {
        let entries: Option<Vec<Entry>> = changed
            .iter()
            .map(|name| Some(Entry::from((name, scenario.get(name)?))))
            .collect();
        let root = Node {
            span: 0..0,
            content: Content::Table(entries?),
        };
        let mut problems = Problems::new(&root, folder);
        let mut tables = self.tables.clone();
        for name in changed {
            let schema = &schema()["properties"][name];
            let passed = walk::value(root.find(name)?, schema, name, &mut problems)?;
            *tables.get_mut(name)? = passed;
        }
        let input = fill(Value::Object(tables), &mut problems)?;
        let questions = input.build(&mut problems)?;
        problems.is_clean().then_some(questions)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::scenario::load;
    use crate::scenario::vary::put;

    fn base() -> Value {
        let mut echo = load("scenarios/back-to-back-7205c.toml".as_ref())
            .expect("a shipped scenario")
            .echo;
        if let Value::Object(tables) = &mut echo {
            tables.remove("study");
        }
        echo
    }

    #[test]
    fn what_is_changed_is_read_as_in_a_whole_scenario() {
        let folder = Path::new("scenarios");
        let passed = Passed::new(&base(), folder).expect("no problems");
        let mut scenario = base();
        put(&mut scenario, "speed.constant", &json!("321 rad/s"));
        put(&mut scenario, "bearing[0].position", &json!("7 mm"));
        let changed = ["speed", "bearing"].map(str::to_owned);
        let found = passed.questions(&scenario, &changed, folder);
        let found = found.expect("questions");
        let expected = questions_of(&scenario, folder).expect("questions");
        assert_eq!(found.model, expected.model);
        assert_eq!(found.question, expected.question);
        let rotor = found.question.rotor;
        assert_eq!((rotor.speed, rotor.bearings[0].position), (321.0, 7e-3));
    }

    #[test]
    fn what_is_wrong_is_no_question() {
        let folder = Path::new("scenarios");
        let passed = Passed::new(&base(), folder).expect("no problems");
        for (key, value) in [
            ("speed.constant", json!("-3 rad/s")),
            ("speed.constant", json!(3)),
            ("speed.from", json!("3 rad/s")),
        ] {
            let mut scenario = base();
            put(&mut scenario, key, &value);
            let changed = ["speed".to_owned()];
            let found = passed.questions(&scenario, &changed, folder);
            assert!(
                found.is_none() && questions_of(&scenario, folder).is_err(),
                "{key}"
            );
        }
        // a table of which nothing is known
        let mut scenario = base();
        put(&mut scenario, "study.count", &json!(3));
        let changed = ["study".to_owned()];
        assert!(passed.questions(&scenario, &changed, folder).is_none());
    }
}
