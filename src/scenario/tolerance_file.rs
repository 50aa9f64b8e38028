//! Tolerances of a comparison from a TOML file, as strictly read as a scenario.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::node::Node;
use super::problems::Problems;
use super::{Issue, ScenarioError, read_toml, schema, walk};

/// Tolerances of a comparison.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[derive(Default)]
struct TolerancesInput {
    /// Allowed difference as part of the largest magnitude in the column.
    #[schemars(range(min = 0))]
    relative: Option<f64>,
    /// Allowed difference in the unit of the column, added to the relative one.
    #[schemars(range(min = 0))]
    absolute: Option<f64>,
    /// Other tolerances of single columns, one `[[column]]` for each.
    column: Vec<ColumnInput>,
}

/// Tolerance of one column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ColumnInput {
    /// Its name.
    #[schemars(extend("examples" = ["x_m"]))]
    name: String,
    /// Allowed difference as part of the largest magnitude in the column.
    #[schemars(range(min = 0), extend("examples" = [1e-6]))]
    relative: f64,
    /// Allowed difference in the unit of the column, added to the relative one. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0))]
    absolute: f64,
}

/// What a file of tolerances says.
#[derive(Debug)]
pub struct ToleranceFile {
    /// Relative tolerance of all columns.
    pub relative: Option<f64>,
    /// Absolute tolerance of all columns.
    pub absolute: Option<f64>,
    /// Name, relative and absolute tolerance of single columns.
    pub columns: Vec<(String, f64, f64)>,
    name: String,
    text: String,
    root: Node,
}

impl ToleranceFile {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong, also where the file cannot be read.
    pub fn load(path: &Path) -> Result<Self, ScenarioError> {
        let name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Self::parse(&text, &name),
            Err(error) => {
                let issue = Issue::new("", format!("cannot read the file: {error}"));
                Err(ScenarioError::new(&name, "", vec![issue]))
            }
        }
    }

    /// Reads and checks the text of a file; `name` is what messages call it.
    ///
    /// ```
    /// use jeffcott::scenario::ToleranceFile;
    /// let text = "relative = 1e-4\n[[column]]\nname = \"x_m\"\nrelative = 1e-2\n";
    /// let file = ToleranceFile::parse(text, "tolerances.toml")?;
    /// assert_eq!(file.columns, [("x_m".to_owned(), 1e-2, 0.0)]);
    /// assert!(ToleranceFile::parse("relativ = 1e-4", "tolerances.toml").is_err());
    /// # Ok::<(), jeffcott::scenario::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong.
    pub fn parse(text: &str, name: &str) -> Result<Self, ScenarioError> {
        let failed = |issues| ScenarioError::new(name, text, issues);
        let root = read_toml::read(text).map_err(failed)?;
        let input = check(&root).map_err(failed)?;
        let columns = input.column.into_iter();
        Ok(Self {
            relative: input.relative,
            absolute: input.absolute,
            columns: columns
                .map(|column| (column.name, column.relative, column.absolute))
                .collect(),
            name: name.to_owned(),
            text: text.to_owned(),
            root,
        })
    }

    /// What is wrong where a column is named that no table has; `None` where the file does not name it.
    pub fn unused(&self, column: &str, known: &[String]) -> Option<ScenarioError> {
        let mut columns = self.columns.iter();
        let index = columns.position(|(name, ..)| name == column)?;
        let path = format!("column[{index}].name");
        let help = match walk::nearest(column, known.iter().map(String::as_str)) {
            Some(near) => format!("did you mean \"{near}\"?"),
            None => format!("there are: {}", known.join(", ")),
        };
        let place = self.root.locate(&path);
        let issue = Issue::new(path, format!("no table has a column {column:?}"));
        let issue = issue.help(help).at(place);
        Some(ScenarioError::new(&self.name, &self.text, vec![issue]))
    }
}

fn check(root: &Node) -> Result<TolerancesInput, Vec<Issue>> {
    let mut problems = Problems::new(root, Path::new("")).about("a file of tolerances");
    let schema = schema::schema_of::<TolerancesInput>();
    let value = walk::value(root, &schema, "", &mut problems);
    let input = value.map(serde_json::from_value::<TolerancesInput>);
    let input = match input {
        Some(Ok(input)) => input,
        Some(Err(error)) => {
            problems.add(Issue::new("", error.to_string()));
            TolerancesInput::default()
        }
        None => TolerancesInput::default(),
    };
    for (index, column) in input.column.iter().enumerate() {
        let mut earlier = input.column[..index].iter();
        if earlier.any(|other| other.name == column.name) {
            let message = format!("column {:?} has a tolerance already", column.name);
            let issue = Issue::new(format!("column[{index}].name"), message).help("keep one");
            problems.refuse(issue, &[]);
        }
    }
    match problems.finish().0 {
        issues if issues.is_empty() => Ok(input),
        issues => Err(issues),
    }
}
