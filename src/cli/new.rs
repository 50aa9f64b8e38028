//! `jeffcott new`.

use std::f64::consts::TAU;
use std::fs::File;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{Outcome, terminal};
use crate::bearing::MountedBearing;
use crate::scenario::{self, Format, Issue, STDIN, Scenario, ScenarioError};

/// Writes a commented scenario of a shaft on one bearing or two, ready to run and to be changed.
///
/// Two deep groove bearings stand as they are, two angular contact bearings back to back with a light preload.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  jeffcott new shaft.toml\n  \
                  jeffcott new fan.toml --mass \"8 kg\" --speed \"1500 rpm\" --bearing 6205 --span \"150 mm\" \\\n    \
                  --radial \"300 N\" --axial \"0 N\"\n\n\
                  Exit code: 0 the scenario is written, 1 it cannot be written, 2 an option is wrong or the\n\
                  file is there already.")]
pub struct Arguments {
    /// File to write, .toml, which must not be there yet; "-" prints the scenario
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Mass of all that moves with the shaft
    #[arg(
        long,
        value_name = "MASS",
        default_value = "5 kg",
        allow_hyphen_values = true
    )]
    mass: String,
    /// Speed
    #[arg(
        long,
        value_name = "SPEED",
        default_value = "3000 rpm",
        allow_hyphen_values = true
    )]
    speed: String,
    /// Bearing, as `jeffcott catalogue` lists it
    #[arg(long, value_name = "NAME", default_value = "6205")]
    bearing: String,
    /// Distance of the two bearings; "0 mm" is a single one
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = "100 mm",
        allow_hyphen_values = true
    )]
    span: String,
    /// Radial load besides the weight, downwards
    #[arg(
        long,
        value_name = "FORCE",
        default_value = "0 N",
        allow_hyphen_values = true
    )]
    radial: String,
    /// Axial load, along +Z [default: 0 N; 200 N of a single bearing]
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    axial: Option<String>,
}

/// A distance, m; zero or positive.
fn distance(text: &str) -> Result<f64, Issue> {
    let span = scenario::number(text, "bearing[].position", "span")?;
    let refused = || Issue::new("span", "a distance is zero or positive");
    (span >= 0.0).then_some(span).ok_or_else(refused)
}

/// A text as TOML has it.
fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// What the options say, each as it is written and, where it is needed, as a number.
struct Choice<'a> {
    title: String,
    mass: &'a str,
    /// Also in rad/s.
    speed: (&'a str, f64),
    bearing: &'a str,
    /// Distance of two bearings, m; zero of one.
    span: f64,
    /// Also in N.
    radial: (&'a str, f64),
    axial: (&'a str, f64),
}

/// Writes the scenario and says what comes next.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let file = &arguments.file;
    let name = file.display();
    let is_printed = file == Path::new(STDIN);
    let refuse = |message: &str| Ok(terminal::refuse(format!("{name}: {message}")));
    if !is_printed && file.extension().is_none_or(|extension| extension != "toml") {
        return refuse("a scenario that is written ends in .toml");
    }
    if !is_printed && file.exists() {
        return refuse(THERE);
    }
    let choice = match Choice::new(arguments) {
        Ok(choice) => choice,
        Err(issue) => return refuse(&issue.to_string()),
    };
    let (text, scenario) = match choice.scenario() {
        Ok(written) => written,
        Err(error) => {
            terminal::tell_problems(&error);
            return Ok(Outcome::WrongInput);
        }
    };
    let lost = arguments.axial.is_some() && choice.axial.1 != 0.0 && !carries_axial_load(&scenario);
    if lost {
        let bearing = &arguments.bearing;
        return refuse(&format!(
            "`axial`: the rollers of a {bearing} carry no axial load"
        ));
    }
    for warning in &scenario.warnings {
        terminal::tell(&format!("warning: {name}: {warning}\n"));
    }
    if is_printed {
        terminal::print(&text)?;
        return Ok(Outcome::Done);
    }
    let created = File::create_new(file);
    match created.and_then(|mut file| file.write_all(text.as_bytes())) {
        Ok(()) => {
            terminal::summarise(&format!("wrote {name}; next: jeffcott run {name}\n"))?;
            Ok(Outcome::Done)
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => refuse(THERE),
        Err(error) => {
            terminal::tell(&format!("error: {name}: {error}\n"));
            Ok(Outcome::Failed)
        }
    }
}

/// Whether a bearing of a scenario holds the shaft along its axis.
fn carries_axial_load(scenario: &Scenario) -> bool {
    let mut bearings = scenario.question.rotor.bearings.iter();
    bearings.any(|mounted| mounted.bearing.geometry.carries_axial_load())
}

/// Largest eccentricity that is written, µm.
const LARGEST_ECCENTRICITY: f64 = 100.0;

/// The scenario with the names of its values between `@`.
const TEMPLATE: &str = include_str!("new.toml");

/// Why nothing is written over.
const THERE: &str = "it is there already, and stays as it is: give another name";

impl<'a> Choice<'a> {
    fn new(arguments: &'a Arguments) -> Result<Self, Issue> {
        let both = |text: &'a str, key: &str, name: &str| {
            Ok((text.trim(), scenario::number(text.trim(), key, name)?))
        };
        let span = distance(&arguments.span)?;
        let single = if span == 0.0 { "200 N" } else { "0 N" };
        let axial = arguments.axial.as_deref().unwrap_or(single);
        let stem = arguments.file.file_stem().unwrap_or_default().to_str();
        Ok(Self {
            title: stem
                .filter(|stem| *stem != STDIN)
                .unwrap_or("shaft")
                .to_owned(),
            mass: &arguments.mass,
            speed: both(&arguments.speed, "speed.constant", "speed")?,
            bearing: &arguments.bearing,
            span,
            radial: both(&arguments.radial, "load[].constant.y", "radial")?,
            axial: both(axial, "load[].constant.z", "axial")?,
        })
    }

    /// The text of the scenario, and what it says.
    fn scenario(&self) -> Result<(String, Scenario), ScenarioError> {
        let parse = |text: &str| scenario::parse(text, "the scenario", Format::Toml);
        let plain = self.text(None, true);
        let scenario = parse(&plain)?;
        let bearings = &scenario.question.rotor.bearings;
        let text = match &bearings[..] {
            [first, _] if !first.bearing.geometry.is_symmetric() => self.text(Some(first), true),
            _ if !carries_axial_load(&scenario) => self.text(None, false),
            _ => return Ok((plain, scenario)),
        };
        parse(&text).map(|scenario| (text, scenario))
    }

    /// The text; two angular contact bearings such as `pair` are set against each other, and where the bearings do not hold the
    /// shaft along its axis it does not move there.
    fn text(&self, pair: Option<&MountedBearing>, is_held_along: bool) -> String {
        let (speed, omega) = &self.speed;
        let (settle, duration) = times(*omega);
        let (eccentricity, grade, sampling) = match *omega > 0.0 {
            // slow shafts are not that far out of balance
            true if 6.3e3 / omega > LARGEST_ECCENTRICITY => (
                LARGEST_ECCENTRICITY,
                "as of a shaft that was never balanced".to_owned(),
                "# samples_per_revolution = 128",
            ),
            true => (
                6.3e3 / omega,
                format!("balance grade G 6.3 at {speed}"),
                "# samples_per_revolution = 128",
            ),
            false => (
                10.0,
                "nothing shows it at rest".to_owned(),
                "sample_rate = \"20 kHz\" # a standing shaft makes no revolutions to sample",
            ),
        };
        let freedoms = if is_held_along {
            "translational"
        } else {
            "radial"
        };
        let values = [
            ("title", quoted(&self.title)),
            ("mass", quoted(self.mass)),
            ("eccentricity", format!("{eccentricity:.3}")),
            ("grade", grade),
            ("speed", quoted(speed)),
            ("bearings", self.bearings(pair)),
            ("freedoms", quoted(freedoms)),
            ("loads", self.loads(is_held_along)),
            ("duration", duration.to_string()),
            ("settle", settle.to_string()),
            ("sampling", sampling.to_owned()),
        ];
        let fill = |text: String, (name, value): (&str, String)| {
            text.replace(&format!("@{name}@"), &value)
        };
        values.into_iter().fold(TEMPLATE.to_owned(), fill)
    }

    fn bearings(&self, pair: Option<&MountedBearing>) -> String {
        // in millimetres; nanometres are fine enough
        let rounded = |length: f64| (1e6 * length).round() / 1e6;
        let bearing = |position: f64, more: &str| {
            let position = rounded(position);
            format!(
                "[[bearing]]\ncatalogue = {}\nposition = \"{position} mm\"\n{more}",
                quoted(self.bearing)
            )
        };
        let span = rounded(1e3 * self.span);
        match pair {
            None if span > 0.0 => {
                format!("{}\n{}", bearing(-0.5 * span, ""), bearing(0.5 * span, ""))
            }
            None => bearing(0.0, ""),
            Some(pair) => {
                let preload = 0.01 * pair.bearing.dynamic_rating.unwrap_or(1e4);
                bearing(
                    0.0,
                    &format!(
                        "arrangement = \"back-to-back\" # or \"face-to-face\", \"tandem\"\nspacing = \"{span} mm\"\n\
                         preload = \"{preload:.0} N\" # light: 1 % of the dynamic load rating\n"
                    ),
                )
            }
        }
    }

    fn loads(&self, is_held_along: bool) -> String {
        let ((radial, down), (axial, along)) = (&self.radial, &self.axial);
        let mut parts = Vec::new();
        if *down != 0.0 {
            let turned = match radial.strip_prefix('-') {
                Some(upwards) => upwards.to_owned(),
                None => format!("-{}", radial.trim_start_matches('+')),
            };
            parts.push(format!("y = {}", quoted(&turned)));
        }
        if is_held_along && *along != 0.0 {
            parts.push(format!("z = {}", quoted(axial)));
        }
        match &parts[..] {
            [] => "# A load: [[load]] with constant = { y = \"-300 N\", z = \"200 N\" }".to_owned(),
            _ => format!("[[load]]\nconstant = {{ {} }}", parts.join(", ")),
        }
    }
}

/// Settle time and duration, s: ten revolutions each, and 0.2 s and 0.3 s unless that are more than 500.
fn times(omega: f64) -> (f64, f64) {
    let [settle, window] = [0.2_f64, 0.3].map(|least| match omega > 0.0 {
        true => least.min(500.0 * TAU / omega).max(10.0 * TAU / omega),
        false => least,
    });
    // whole milliseconds, so that the file is easy to read
    let rounded = |time: f64| (1e3 * time).ceil() / 1e3;
    (rounded(settle), rounded(settle + window))
}
