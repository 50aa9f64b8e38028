//! `series` of `[[load]]`.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Surroundings, components};
use crate::rotor::load::{Interpolation, Series};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::series_file::{self, SeriesFileError};

/// A series of values from a CSV file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeriesInput {
    /// CSV file, relative to the scenario file. Its first line names the columns: `t_s` first,
    /// then any of `x_N`, `y_N`, `z_N`, `tilt_x_N_m`, `tilt_y_N_m`. Before the first row its
    /// values hold, after the last row those of the last.
    #[schemars(extend("examples" = ["load.csv"]))]
    pub file: String,
    /// How the series is read between its rows. Default: "linear".
    #[serde(default)]
    pub interpolation: Interpolation,
}

impl SeriesInput {
    /// The series, where its file is right.
    pub fn build(&self, around: Surroundings, problems: &mut Problems<'_>) -> Option<Series> {
        match self.read(problems.folder()) {
            Ok((series, axes)) => {
                let held = axes.iter().find(|axis| **axis >= around.freedoms.count());
                if let Some(axis) = held {
                    let message = format!(
                        "`{}` has a column for `{}`, which `freedoms` holds",
                        self.file,
                        components::KEYS[*axis]
                    );
                    let issue = Issue::new(".file", message);
                    problems.refuse(issue.against("shaft.freedoms"));
                }
                if series.end() < around.duration {
                    problems.warn(format!(
                        "`{}` ends at {} s; its last row is held to the end of the run",
                        self.file,
                        series.end()
                    ));
                }
                Some(series)
            }
            Err(error) => {
                let message = format!("`{}` is no load series: {error}", self.file);
                let issue = Issue::new(".file", message);
                problems.refuse(issue);
                None
            }
        }
    }

    /// The series and the freedoms that it loads.
    fn read(&self, folder: &Path) -> Result<(Series, Vec<usize>), SeriesFileError> {
        let (times, columns) = series_file::read(&folder.join(&self.file))?;
        let axes = columns.iter().map(|column| column.axis).collect();
        let series = Series::new(times, columns, self.interpolation)?;
        Ok((series, axes))
    }
}
