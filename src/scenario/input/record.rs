//! A file that describes a record: `[record]`, `[speed]`, `[[bearing]]` and what is made of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::geometry::{GeometryInput, Sources};
use super::identity::{Identity, Printed, PrintedBearing};
use super::output::{Output, TableFormat};
use super::ratings::RatingsInput;
use super::settings::MachineInput;
use super::spectrum::SpectrumInput;
use crate::analysis::Window;
use crate::bearing::{Bearing, EstimateError, Geometry, REFERENCE_GROOVES, RollerLine, catalogue};
use crate::measurement::MeasuredBearing;
use crate::physics::Race;
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{AngularSpeed, Frequency, Quantity, Time};

/// A record of sensors, what its file does not say of it, and what is found out of it. What has a dimension is a string with its
/// unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordFileInput {
    /// Where an editor finds the schema of this file; without effect.
    #[serde(rename = "$schema")]
    pub schema: Option<String>,
    /// One line on what was measured. Default: the name of the file.
    pub title: Option<String>,
    /// The record and its channels.
    #[serde(default)]
    pub record: RecordInput,
    /// How fast the shaft turned. Without this table, lines have no names.
    pub speed: Option<RecordSpeedInput>,
    /// The bearings whose lines are looked for, one `[[bearing]]` for each.
    #[serde(default)]
    pub bearing: Vec<RecordBearingInput>,
    /// The machine, for the zones of ISO 20816-3. Without this table no zone is given.
    pub machine: Option<MachineInput>,
    /// Further spectra, one `[[spectrum]]` for each. Default: the spectrum of the envelope of each of up to four channels, in the
    /// band where it knocks most; over orders where the speed changes.
    #[serde(default)]
    pub spectrum: Vec<SpectrumInput<SignalName>>,
    /// What is written.
    #[serde(default)]
    pub output: RecordOutputInput,
}

/// The file of a record, and what holds for all its channels.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordInput {
    /// The file: text in columns (CSV), WAV, MATLAB up to `-v7`, universal file 58, or a trace of this program.
    #[schemars(extend("examples" = ["112.mat"]))]
    pub file: Option<String>,
    /// Samples a second, where the file does not say it, for instance "12 kHz". It is never guessed: a wrong one moves every line.
    #[schemars(extend("examples" = ["12 kHz"], "x-above" = 0.0))]
    pub rate: Option<Quantity<Frequency>>,
    /// Unit of the channels, where the file does not say it: "m/s^2", "mm/s", "um", "N"; "g" is the standard gravity.
    #[schemars(extend("examples" = ["g"]))]
    pub unit: Option<String>,
    /// What one in the file means in the unit: of a WAV full scale, of others one count. Default: 1.
    pub scale: Option<f64>,
    /// Time of the record from which on it is analysed. Default: its beginning.
    #[schemars(extend("examples" = ["0.5 s"]))]
    pub start: Option<Quantity<Time>>,
    /// How long a part is analysed. Default: all.
    #[schemars(extend("examples" = ["10 s"], "x-above" = 0.0))]
    pub duration: Option<Quantity<Time>>,
    /// The channels that are analysed, one `[[record.channel]]` for each. Default: all of the highest rate but speed and pulses; of a trace of this program
    /// displacements and forces.
    #[serde(default)]
    pub channel: Vec<SignalInput>,
}

/// A channel of the record, and what its file does not say of it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SignalInput {
    /// Its name in the file, as `jeffcott analyze FILE --list` shows it, or its number, from "1".
    #[schemars(extend("examples" = ["X112_DE_time"]))]
    pub column: String,
    /// What it is called in results. Default: as in the file.
    #[schemars(extend("examples" = ["drive_end"]))]
    pub name: Option<String>,
    /// What is measured, for instance "acceleration". Default: what the unit says.
    #[schemars(extend("examples" = ["acceleration"]))]
    pub quantity: Option<String>,
    /// Its unit. Default: that of the file, or of `[record]`.
    #[schemars(extend("examples" = ["g"]))]
    pub unit: Option<String>,
    /// Direction in which it measures, for instance "+x"; it is reported with the results.
    #[schemars(extend("examples" = ["+x"]))]
    pub direction: Option<String>,
    /// Samples a second. Default: that of the file, or of `[record]`.
    #[schemars(extend("x-above" = 0.0))]
    pub rate: Option<Quantity<Frequency>>,
    /// What one in the file means in the unit. Default: that of `[record]`.
    pub scale: Option<f64>,
    /// Added to what is scaled, in the unit. Default: 0.
    #[serde(default)]
    pub offset: f64,
}

/// How fast the shaft turned: a number, a channel of speed, or a channel of pulses.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["constant", "channel", "tacho"]))]
pub struct RecordSpeedInput {
    /// Constant speed, for instance "1797 rpm".
    #[schemars(extend("examples" = ["1797 rpm"], "x-above" = 0.0))]
    pub constant: Option<Quantity<AngularSpeed>>,
    /// Channel that holds the speed.
    #[schemars(extend("examples" = ["speed"]))]
    pub channel: Option<String>,
    /// Unit of that channel. Default: that of the file.
    #[schemars(extend("examples" = ["rpm"]))]
    pub unit: Option<String>,
    /// Channel of a tacho or an encoder.
    #[schemars(extend("examples" = ["Channel_2"]))]
    pub tacho: Option<String>,
    /// Pulses of the tacho a revolution. Default: 1.
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 100_000.0))]
    pub pulses: Option<f64>,
    /// Samples a second of the channel. Default: that of the file, or of `[record]`.
    #[schemars(extend("x-above" = 0.0))]
    pub rate: Option<Quantity<Frequency>>,
}

/// A bearing whose lines are looked for: by its designation, its ratings, or four numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordBearingInput {
    /// Designation of a bearing that `jeffcott catalogue` lists.
    #[schemars(extend("examples" = ["6205"]))]
    pub catalogue: Option<String>,
    /// What a maker's catalogue prints of the bearing, instead of `catalogue`.
    pub ratings: Option<RatingsInput>,
    /// Four numbers: balls or rollers, their diameter, pitch diameter and contact angle (Default: 0 deg); besides `catalogue` or `ratings` those that
    /// differ.
    pub geometry: Option<GeometryInput>,
    /// How much slower the cage turns than it would roll, as a part. Default: as its lines show it.
    #[schemars(range(min = -0.1, max = 0.9))]
    pub cage_slip: Option<f64>,
    /// Ring that turns. Default: "inner".
    #[serde(default)]
    pub rotating_ring: Race,
}

/// What is written of the analysis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RecordOutputInput {
    /// Window of the spectrum of all channels. Default: "hann".
    pub window: Window,
    /// Whether figures are drawn. Default: true.
    pub figures: bool,
    /// Whether `record.html` is written, one page that shows the result in a browser. Default: true.
    pub report: bool,
    /// Formats of the tables. Default: CSV alone.
    #[schemars(extend("minItems" = 1))]
    pub formats: Vec<TableFormat>,
}

impl Default for RecordOutputInput {
    fn default() -> Self {
        Self {
            window: Window::Hann,
            figures: true,
            report: true,
            formats: vec![TableFormat::Csv],
        }
    }
}

impl RecordOutputInput {
    /// Which files are written.
    pub fn build(&self, problems: &mut Problems<'_>) -> Output {
        let output = Output {
            figures: self.figures,
            report: self.report,
            formats: self.formats.clone(),
            ..Output::default()
        };
        output.check_written(problems);
        output
    }
}

/// The name of a channel that is analysed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(inline)]
pub struct SignalName(String);

impl AsRef<str> for SignalName {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl RecordBearingInput {
    /// The bearing, as far as it rolls.
    pub fn build(&self, problems: &mut Problems<'_>) -> Option<MeasuredBearing> {
        let identity = Identity {
            catalogue: self.catalogue.as_deref(),
            ratings: self.ratings.as_ref(),
            has_dimensions: self.geometry.is_some(),
            clearance_class: None,
        };
        let printed = identity.printed(&catalogue::EMPTY, problems)?;
        let (name, geometry, notes) = match printed {
            Some(PrintedBearing::Rollers(printed)) => self.rollers(printed, problems)?,
            Some(PrintedBearing::Balls(printed)) => self.balls(Some(printed), problems)?,
            None => self.balls(None, problems)?,
        };
        for note in notes {
            problems.warn(format!("`{}`: {note}", problems.path(".")));
        }
        Some(MeasuredBearing {
            name,
            bearing: Bearing {
                rotating_ring: self.rotating_ring,
                ..Bearing::of_steel(geometry)
            },
            slip: self.cage_slip,
        })
    }

    /// The name of a roller bearing, its geometry, and what the reader should know of its estimate.
    fn rollers(
        &self,
        printed: Printed<RollerLine>,
        problems: &mut Problems<'_>,
    ) -> Option<(String, Geometry, Vec<String>)> {
        if self.geometry.is_some() {
            let issue = Issue::new(".geometry", "this belongs to balls").help("remove it");
            problems.refuse(issue.against(printed.key));
        }
        let line = &printed.line;
        let estimate = problems.take(line.estimate().map_err(|error| printed.wrong(&error)))?;
        let geometry = estimate.geometry(line.contact_angle);
        let wrong = |error| printed.wrong(&EstimateError::from(error));
        let geometry = problems.take(geometry.map_err(wrong))?;
        Some((printed.name, geometry, estimate.notes))
    }

    /// Name, geometry and notes of a ball bearing, of which nothing may be printed.
    fn balls(
        &self,
        printed: Option<Printed>,
        problems: &mut Problems<'_>,
    ) -> Option<(String, Geometry, Vec<String>)> {
        let name = printed.as_ref().map(|printed| printed.name.clone());
        let mut input = self.geometry.clone().unwrap_or_default();
        if printed.is_none() {
            // neither clearance nor grooves move a line
            if input.diametral_clearance.is_none() && input.radial_clearance.is_none() {
                input.contact_angle.get_or_insert_default();
            }
            let [inner, outer] = REFERENCE_GROOVES;
            input.groove_factor_inner.get_or_insert(inner);
            input.groove_factor_outer.get_or_insert(outer);
        }
        let clearance_class = printed.as_ref().and_then(|printed| printed.class);
        let sources = Sources {
            input: &input,
            printed,
            clearance_class,
        };
        let (geometry, estimate) = sources.build(Freedoms::Radial, 0.0, problems)?;
        let name = name.unwrap_or_else(|| format!("{} balls", geometry.balls()));
        let notes = estimate.map(|estimate| estimate.notes);
        Some((name, geometry, notes.unwrap_or_default()))
    }
}
