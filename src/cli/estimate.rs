//! `jeffcott estimate`.

use std::io;

use super::{Outcome, terminal};
use crate::report::{estimate_json, estimate_text, roller_estimate_json, roller_estimate_text};
use crate::scenario::{self, RatedLine};

/// Finds the inside of a bearing from what its catalogue prints: balls, ball diameter and grooves, or rollers.
///
/// For [bearing.ratings] of a scenario and for the bearings of the catalogue it is found in the same way.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott estimate --bore 40mm --outside-diameter 80mm --contact-angle 0deg --dynamic 29.1kN \
                  --static 17.9kN\n\
                  \x20 jeffcott estimate --kind cylindrical --bore 30mm --outside-diameter 62mm --width 16mm --dynamic 44kN \
                  --static 36.5kN\n\n\
                  Exit code: 0 done, 2 the line is wrong, or belongs to neither balls nor rollers."
)]
pub struct Arguments {
    /// Bore
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    bore: String,
    /// Outside diameter
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    outside_diameter: String,
    /// Of a roller bearing its kind: cylindrical, needle, tapered or spherical
    #[arg(long, value_name = "KIND", requires = "width")]
    kind: Option<String>,
    /// Width of a roller bearing
    #[arg(
        long,
        value_name = "LENGTH",
        allow_hyphen_values = true,
        requires = "kind"
    )]
    width: Option<String>,
    /// Nominal contact angle, 0deg of a deep-groove bearing
    #[arg(
        long,
        value_name = "ANGLE",
        default_value = "0 deg",
        allow_hyphen_values = true
    )]
    contact_angle: String,
    /// Basic dynamic load rating C
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    dynamic: String,
    /// Basic static load rating C0
    #[arg(long = "static", value_name = "FORCE", allow_hyphen_values = true)]
    statical: String,
    /// Number of balls, where it is printed
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    balls: Option<String>,
    /// Ball diameter, where it is printed
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    ball_diameter: Option<String>,
    /// Pitch diameter, where it is printed
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pitch_diameter: Option<String>,
    /// Factor f0, where it is printed, whole or with one decimal
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    f0: Option<String>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

const TITLE: &str = "Estimate";

/// Prints the estimate.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let given = [
        ("bore", Some(&arguments.bore)),
        ("outside_diameter", Some(&arguments.outside_diameter)),
        ("kind", arguments.kind.as_ref()),
        ("width", arguments.width.as_ref()),
        ("contact_angle", Some(&arguments.contact_angle)),
        ("dynamic", Some(&arguments.dynamic)),
        ("static", Some(&arguments.statical)),
        ("balls", arguments.balls.as_ref()),
        ("ball_diameter", arguments.ball_diameter.as_ref()),
        ("pitch_diameter", arguments.pitch_diameter.as_ref()),
        ("f0", arguments.f0.as_ref()),
    ];
    let given = given.into_iter();
    let given = given.filter_map(|(key, text)| Some((key, text?.as_str())));
    let line = match scenario::ratings(given) {
        Ok(line) => line,
        Err(issues) => {
            for issue in issues {
                let help = issue.help.map(|help| format!(" ({help})"));
                let help = help.unwrap_or_default();
                terminal::refuse(format!("{}{help}", issue.message));
            }
            return Ok(Outcome::WrongInput);
        }
    };
    let reported = match &line {
        RatedLine::Balls(line) => line.estimate().map(|found| {
            (
                estimate_json(line, &found),
                estimate_text(TITLE, line, &found),
            )
        }),
        RatedLine::Rollers(line) => line.estimate().map(|found| {
            let text = roller_estimate_text(TITLE, line, &found);
            (roller_estimate_json(line, &found), text)
        }),
    };
    match reported {
        Ok((document, _)) if arguments.json => terminal::print(&format!("{document:#}\n"))?,
        Ok((_, lines)) => terminal::print(&lines.text(terminal::details()))?,
        Err(error) => return Ok(terminal::refuse(error)),
    }
    Ok(Outcome::Done)
}
