//! `jeffcott bearing`.

use std::io;
use std::path::PathBuf;

use super::jobs::{Job, Shown, jobs, show, with_files};
use super::{Outcome, stream};
use crate::quasi_static::{QuasiStatic, quasi_static};
use crate::report;
use crate::rotor::RotorError;
use crate::study::{Study, StudyError};

/// Finds where the shaft stands, without motion: equilibrium, stiffness and every ball.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott bearing scenarios/bearing-7205c.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: balls.csv, balls.svg and,\n\
                  last, bearing.json. With a [study]: study.csv, around.csv, stiffness.svg,\n\
                  deformation.svg, contact_angle.svg and, last, study.json.\n\n\
                  Exit code: 0 all answers are found, 1 a load has no equilibrium or a file cannot \
                  be\nwritten, 2 a file is wrong."
)]
pub struct Arguments {
    /// Scenario files, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Folder that the folders of the answers are written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    out: PathBuf,
    /// Print the answers as JSON: an object, or an array for several files
    #[arg(long)]
    json: bool,
}

/// Checks all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let Some(jobs) = jobs(&arguments.files, &arguments.out) else {
        return Ok(Outcome::WrongInput);
    };
    let answers = jobs.iter().map(|job| {
        let answer = match &job.scenario.study {
            Some(study) => job.study(study, arguments.json),
            None => job.answer(arguments.json),
        };
        (job.name.as_str(), answer)
    });
    show(arguments.json, answers)
}

/// Why a job failed, in words.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error(transparent)]
    Report(#[from] report::ReportError),
    #[error(transparent)]
    Rotor(#[from] RotorError),
    #[error(transparent)]
    Study(#[from] StudyError),
}

impl Job {
    fn answer(&self, as_json: bool) -> Result<Shown, Failure> {
        let (title, echo) = (&self.scenario.title, &self.scenario.echo);
        let answer = quasi_static(&self.scenario.question)?;
        self.warn("", &answer);
        let files = report::write_answer(&self.folder, title, echo, &answer)?;
        let choice = self.scenario.contact_choice.as_ref();
        Ok(if as_json {
            let mut json = with_files(report::answer_json(title, echo, &answer), &files);
            if let Some(choice) = choice {
                json["contact_choice"] = report::contact_choice_json(choice);
            }
            Shown::Json(json)
        } else {
            let chosen = choice.map(report::contact_choice_text).unwrap_or_default();
            Shown::Text(report::answer_text(title, &answer, &files) + &chosen)
        })
    }

    fn study(&self, study: &Study, as_json: bool) -> Result<Shown, Failure> {
        let (title, echo) = (&self.scenario.title, &self.scenario.echo);
        let rows = study.run()?;
        for row in &rows {
            let variable = &study.variable;
            let shown = variable.shown(row.value);
            let place = format!("{} = {shown} {}: ", variable.key, variable.shown_unit);
            self.warn(&place, &row.answer);
        }
        let files = report::write_study(&self.folder, title, echo, study, &rows)?;
        Ok(if as_json {
            Shown::Json(with_files(
                report::study_json(title, echo, study, &rows),
                &files,
            ))
        } else {
            Shown::Text(report::study_text(title, study, &rows, &files))
        })
    }

    fn warn(&self, place: &str, answer: &QuasiStatic) {
        for warning in &answer.warnings {
            stream::tell(&format!("warning: {}: {place}{warning}\n", self.name));
        }
    }
}
