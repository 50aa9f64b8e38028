//! `jeffcott bearing`.

use std::io;

use serde_json::json;

use super::Outcome;
use super::jobs::{Answer, Failure, Files, Job};
use crate::quasi_static::{StaticQuestion, quasi_static};
use crate::report;
use crate::scenario::{self, Issue};
use crate::study::Study;

/// Finds where the shaft stands, without motion: equilibrium, stiffness and every ball.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott bearing scenarios/bearing-7205c.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: balls.csv, balls.svg,\n\
                  bearing.html and, last, bearing.json. With a [study]: study.csv, around.csv, stiffness.svg,\n\
                  deformation.svg, contact_angle.svg, study.html and, last, study.json.\n\n\
                  Exit code: 0 all answers are found, 1 a load has no equilibrium or a file cannot \
                  be\nwritten, 2 a file is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Angle that the shaft has turned by
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    shaft_angle: Option<f64>,
    /// Angle that the cages have turned by; where they roll to with the shaft, if it is left out
    #[arg(long, value_name = "ANGLE", value_parser = angle, allow_hyphen_values = true)]
    cage_angle: Option<f64>,
}

/// An angle with its unit, rad.
fn angle(text: &str) -> Result<f64, Issue> {
    scenario::number(text, "bearing[].first_ball", "angle")
}

/// Checks all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let (shaft, cage) = (arguments.shaft_angle, arguments.cage_angle);
    let turn = |question: &mut StaticQuestion| {
        if shaft.or(cage).is_some() {
            question.turn(shaft.unwrap_or(0.0), cage);
        }
    };
    let answer = |job: &Job, ()| match &job.scenario.study {
        Some(study) => {
            let mut study = study.clone();
            study
                .points
                .iter_mut()
                .for_each(|point| turn(&mut point.question));
            answer_study(job, &study)
        }
        None => {
            let mut question = job.scenario.question.clone();
            turn(&mut question);
            answer(job, &question)
        }
    };
    arguments.files.answer(|_| Ok(()), answer)
}

fn answer(job: &Job, question: &StaticQuestion) -> Result<Answer, Failure> {
    let found = quasi_static(question)?;
    let findings = report::answer_findings(&job.destination(), question, &found);
    let mut answer = job.write(findings)?;
    answer.text += &job.contact_choice_text();
    if let Some(choice) = &job.scenario.contact_choice {
        answer.json["contact_choice"] = json!(choice);
    }
    Ok(answer)
}

fn answer_study(job: &Job, study: &Study) -> Result<Answer, Failure> {
    let destination = job.destination();
    let rows = study.run()?;
    let answer = job.write(report::study_findings(&destination, study, &rows))?;
    let mut json = report::study_json(&destination, study, &rows);
    json["files"] = answer.json["files"].clone();
    Ok(Answer { json, ..answer })
}
