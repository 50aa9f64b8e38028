//! `jeffcott bearing`.

use std::io;

use super::Outcome;
use super::jobs::Files;
use crate::ask::BearingQuestion;
use crate::scenario::{self, Issue};

/// Finds the static equilibrium of the shaft: displacement, stiffness and every rolling element.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott bearing scenarios/bearing-7205c.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: balls.csv, balls.svg,\n\
                  bearing.html and, last, bearing.json; with --sensitivity bearing_sensitivity.csv and\n\
                  bearing_tornado.svg, too. Of many values `jeffcott study` asks it, by\n\
                  ask = \"bearing\" in a study file.\n\n\
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
    /// Keys of the scenario that the numbers of the answer are differentiated by, as "bearing[*].preload,shaft.mass"
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',')]
    sensitivity: Vec<String>,
}

/// An angle with its unit, rad.
fn angle(text: &str) -> Result<f64, Issue> {
    scenario::number(text, "bearing[].first_ball", "angle")
}

/// Checks all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let (shaft, cage) = (arguments.shaft_angle, arguments.cage_angle);
    arguments.files.answer(
        |_| {},
        |job| {
            let mut question = BearingQuestion::new(&job.scenario, shaft, cage);
            question.sensitivity = job.sensitivity(&arguments.sensitivity)?;
            Ok(Box::new(move || job.write(&question.answer()?)))
        },
    )
}
