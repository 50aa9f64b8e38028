//! What of a run is written, and in which formats.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Format of the tables of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TableFormat {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet; only where `jeffcott` is built with it.
    Parquet,
    /// A MAT-file of MATLAB, level 5: one variable a column.
    Mat,
}

impl TableFormat {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Parquet, Self::Mat];

    /// Name in a scenario, and the ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Parquet => "parquet",
            Self::Mat => "mat",
        }
    }

    /// Whether this build can write it.
    pub fn is_built(self) -> bool {
        self != Self::Parquet || cfg!(feature = "parquet")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_a_scenario() {
        for format in TableFormat::ALL {
            assert_eq!(serde_json::json!(format), format.extension());
        }
    }
}
