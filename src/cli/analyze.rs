//! `jeffcott analyze`.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::jobs::{Answer, Answers, Common, Failure, Folders, name_of, wrong};
use super::{Outcome, terminal};
use crate::ask::{AnalyzeQuestion, record_setting};
use crate::report::{listed_record, record_json};
use crate::scenario::open_record;

/// Finds out what is in records of sensors: spectra, envelopes, orders, names of lines, slip, vibration.
///
/// A record is a table as text (CSV), WAV, MATLAB up to `-v7`, universal file 58, or a trace of `jeffcott run`. What its file
/// does not say, as the rate, the unit or the speed, options say, or a file .toml that describes the record: `[record]`,
/// `[speed]`, `[[bearing]]`, `[[spectrum]]`, `[machine]`. Nothing is guessed.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  jeffcott analyze 112.mat --list\n  \
                  jeffcott analyze 112.mat --channel X112_DE_time --rate \"12 kHz\" --unit g \\\n    \
                  --speed \"1797 rpm\" --bearing \"9, 0.3126 in, 1.537 in\"\n  \
                  jeffcott analyze motor.csv --speed \"2960 rpm\" --bearing 6205\n  \
                  jeffcott analyze motor.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: spectrum.csv, peaks.csv, spectrum_<name>.csv, figures,\n\
                  record.html and, last, record.json.\n\n\
                  Exit code: 0 done, 1 a result could not be written, 2 a file or the command line is wrong.")]
pub struct Arguments {
    /// Records, or files .toml that describe them; "-" is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Show the channels of the files, and write nothing
    #[arg(long)]
    list: bool,
    /// Channel that is analysed, by its name in the file or its number; repeatable. Default: all of the highest rate
    #[arg(long, value_name = "NAME")]
    channel: Vec<String>,
    /// Samples a second, as "12 kHz", where the file does not say it
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    rate: Option<String>,
    /// Unit of the channels, as "m/s^2", where the file does not say it; g is the standard gravity
    #[arg(long, value_name = "UNIT")]
    unit: Option<String>,
    /// What one in the file means in the unit: of a WAV full scale, of others one count
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    scale: Option<f64>,
    /// Speed of the shaft, as "1797 rpm", or the channel that holds it
    #[arg(long, value_name = "SPEED|NAME", allow_hyphen_values = true)]
    speed: Option<String>,
    /// Channel of a tacho or an encoder
    #[arg(long, value_name = "NAME", conflicts_with = "speed")]
    tacho: Option<String>,
    /// Pulses of the tacho a revolution
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        requires = "tacho"
    )]
    pulses: Option<f64>,
    /// Bearing whose lines are looked for, as 6205, or balls, their diameter, pitch diameter and contact angle, as "9, 7.94 mm,
    /// 39 mm, 0 deg"; repeatable
    #[arg(long, value_name = "BEARING")]
    bearing: Vec<String>,
    /// Window of the spectrum
    #[arg(long, value_name = "WINDOW")]
    window: Option<String>,
    /// Time of the record from which on it is analysed, as "0.5 s"
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    start: Option<String>,
    /// How long a part is analysed
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    duration: Option<String>,
    #[command(flatten)]
    common: Common,
}

/// Analyses all files in turn, or lists what they hold.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let mut answers = Answers::new(arguments.common.json, arguments.files.len());
    let mut folders = Folders::default();
    for file in &arguments.files {
        let name = name_of(file);
        let answer = match arguments.list {
            true => arguments.list(file, &name),
            false => arguments.analyse(file, &name, &mut folders),
        };
        answers.take_of(&name, answer)?;
    }
    answers.end()
}

impl Arguments {
    /// What the options say, as keys of a description.
    fn options(&self) -> Vec<String> {
        let number = |number: f64| format!("{number:?}");
        let single = [
            ("rate", self.rate.clone()),
            ("unit", self.unit.clone()),
            ("scale", self.scale.map(number)),
            ("start", self.start.clone()),
            ("duration", self.duration.clone()),
            ("window", self.window.clone()),
            ("speed", self.speed.clone()),
            ("tacho", self.tacho.clone()),
            ("pulses", self.pulses.map(number)),
        ];
        let single = single.map(|(name, value)| (name, Vec::from_iter(value)));
        let several = [("channel", &self.channel), ("bearing", &self.bearing)];
        let several = several.map(|(name, values)| (name, values.clone()));
        let options = single.into_iter().chain(several);
        let options = options.filter_map(|(name, values)| record_setting(name, &values));
        options
            .chain(self.common.settings.all.iter().cloned())
            .collect()
    }

    /// Shows what a file holds, also where people want quiet.
    fn list(&self, file: &Path, name: &str) -> Result<Answer, Failure> {
        let record = open_record(file).map_err(|error| wrong(error.problem))?;
        warn(name, record.warnings.iter().chain(&record.missing()));
        if !self.common.json {
            terminal::print(&listed_record(name, &record).text(false))?;
        }
        Ok(Answer::of_json(record_json(name, &record)))
    }

    fn analyse(&self, file: &Path, name: &str, folders: &mut Folders) -> Result<Answer, Failure> {
        let started = Instant::now();
        let folder = self.common.folder_of(file).map_err(wrong)?;
        folders.take(&folder, file).map_err(wrong)?;
        let findings = AnalyzeQuestion::load(file, "{}", &self.options())?.answer();
        warn(name, findings.warnings());
        let found = findings.write(&folder)?;
        Ok(Answer::new(found, self.common.open).timed(started))
    }
}

fn warn(name: &str, warnings: impl IntoIterator<Item = impl AsRef<str>>) {
    for warning in warnings {
        terminal::tell(&format!("warning: {name}: {}\n", warning.as_ref()));
    }
}
