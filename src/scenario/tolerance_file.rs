//! Tolerances of a comparison from a TOML file, as strictly read as a scenario.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::document::Document;
use super::key_path::entry;
use super::schema::schema_of;
use super::{Format, Issue, ScenarioError, reader};

/// Tolerances of a comparison.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TolerancesInput {
    /// Allowed difference as part of the largest magnitude in the column.
    #[schemars(range(min = 0))]
    pub relative: Option<f64>,
    /// Allowed difference in the unit of the column, added to the relative one.
    #[schemars(range(min = 0))]
    pub absolute: Option<f64>,
    /// Other tolerances of single columns, one `[[column]]` for each.
    pub column: Vec<ColumnInput>,
}

/// Tolerance of one column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColumnInput {
    /// Its name.
    #[schemars(extend("examples" = ["x_m"]))]
    pub name: String,
    /// Allowed difference as part of the largest magnitude in the column.
    #[schemars(range(min = 0), extend("examples" = [1e-6]))]
    pub relative: f64,
    /// Allowed difference in the unit of the column, added to the relative one. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub absolute: f64,
}

/// A file of tolerances.
#[derive(Debug)]
pub struct ToleranceFile {
    /// What it says.
    pub input: TolerancesInput,
    document: Document,
}

impl ToleranceFile {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong, also where the file cannot be read.
    pub fn load(path: &Path) -> Result<Self, ScenarioError> {
        Self::check(Document::open_as(path, Format::Toml)?)
    }

    fn check(document: Document) -> Result<Self, ScenarioError> {
        let mut problems = document.problems().about("a file of tolerances");
        let schema = schema_of::<TolerancesInput>();
        let input: TolerancesInput = reader::read(&schema, &mut problems).unwrap_or_default();
        for (index, column) in input.column.iter().enumerate() {
            let mut earlier = input.column[..index].iter();
            if earlier.any(|other| other.name == column.name) {
                let message = format!("column {:?} has a tolerance already", column.name);
                let issue = Issue::new(format!("{}.name", entry("column", index)), message);
                problems.refuse(issue.help("keep one"));
            }
        }
        let (input, _) = document.finish(Some(input), problems)?;
        Ok(Self { input, document })
    }

    /// What is wrong where a column is named that no table has; `None` where the file does not name it.
    pub fn unused(&self, column: &str, known: &[String]) -> Option<ScenarioError> {
        let mut columns = self.input.column.iter();
        let index = columns.position(|named| named.name == column)?;
        let message = format!("no table has a column {column:?}");
        let issue = Issue::new(format!("{}.name", entry("column", index)), message).help_nearest(
            column,
            known.iter().map(String::as_str),
            &format!("there are: {}", known.join(", ")),
        );
        Some(self.document.refused(issue))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<ToleranceFile, ScenarioError> {
        ToleranceFile::check(Document::parse(text, "tolerances.toml", Format::Toml)?)
    }

    #[test]
    fn columns_are_read_and_unknown_keys_refused() {
        let text = "relative = 1e-4\n[[column]]\nname = \"x_m\"\nrelative = 1e-2\n";
        let file = parse(text).expect("tolerances");
        let [column] = &file.input.column[..] else {
            panic!("one column")
        };
        assert_eq!(
            (&*column.name, column.relative, column.absolute),
            ("x_m", 1e-2, 0.0)
        );
        assert!(parse("relativ = 1e-4").is_err());
    }
}
