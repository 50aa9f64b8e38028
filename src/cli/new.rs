//! `jeffcott new`.

use std::f64::consts::TAU;
use std::fs::OpenOptions;
use std::io::{self, BufRead, ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{Outcome, terminal};
use crate::bearing::MountedBearing;
use crate::scenario::{self, Format, Issue, STDIN, Scenario, ScenarioError};

/// Writes a commented scenario of a shaft on one bearing or two, ready to run and to be changed.
///
/// What no option gives is asked for on a terminal; elsewhere, and for an empty answer, the default is taken. Two deep
/// groove bearings stand as they are, two angular contact bearings back to back with a light preload.
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
    /// Mass of all that moves with the shaft [default: 5 kg]
    #[arg(long, value_name = "MASS")]
    mass: Option<String>,
    /// Speed [default: 3000 rpm]
    #[arg(long, value_name = "SPEED")]
    speed: Option<String>,
    /// Bearing of the catalogue [default: 6205]
    #[arg(long, value_name = "NAME")]
    bearing: Option<String>,
    /// Distance of the two bearings; "0 mm" is a single one [default: 100 mm]
    #[arg(long, value_name = "LENGTH")]
    span: Option<String>,
    /// Radial load beside the weight, downwards [default: 0 N]
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    radial: Option<String>,
    /// Axial load, along +Z [default: 0 N; 200 N of a single bearing]
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    axial: Option<String>,
}

/// A quantity that a scenario is made of.
struct Question {
    /// The option that gives it.
    option: &'static str,
    /// What is asked on a terminal.
    text: &'static str,
    /// The key that it is a value of; none of the bearing.
    key: Option<&'static str>,
}

/// Asks for what no option gives, where somebody is there to answer.
struct Dialogue {
    asks: bool,
}

impl Dialogue {
    /// The answer as it is written and as a number in SI units; zero of the bearing.
    fn answer(
        &self,
        question: &Question,
        given: Option<&String>,
        default: &str,
    ) -> Result<(String, f64), Issue> {
        let check = |text: &str| {
            let text = text.trim().to_owned();
            let value = match question.key {
                Some(key) => scenario::number(&text, key, question.option)?,
                None => check_bearing(&text).map(|()| 0.0)?,
            };
            Ok((text, value))
        };
        if let Some(text) = given {
            return check(text);
        }
        if !self.asks {
            return check(default);
        }
        loop {
            terminal::tell(&format!("{} [{default}]: ", question.text));
            let mut line = String::new();
            let count = io::stdin().lock().read_line(&mut line);
            let text = match (count, line.trim()) {
                (Ok(0) | Err(_), _) => return Err(Issue::new(question.option, "no answer")),
                (_, "") => default,
                (_, text) => text,
            };
            match check(text) {
                Ok(answer) => return Ok(answer),
                Err(issue) => terminal::tell(&format!("{issue}\n")),
            }
        }
    }
}

/// Refuses a bearing that no scenario can name.
fn check_bearing(name: &str) -> Result<(), Issue> {
    let scenario = format!(
        "shaft = {{ mass = \"1 kg\", freedoms = \"radial\" }}\nspeed = {{ constant = \"0 rpm\" }}\n\
         bearing = [{{ catalogue = {} }}]\n",
        quoted(name)
    );
    let checked = scenario::parse(&scenario, "the scenario", Format::Toml);
    let issue = checked
        .err()
        .and_then(|error| error.issues.into_iter().next());
    issue.map_or(Ok(()), Err)
}

/// A text as TOML has it.
fn quoted(text: &str) -> String {
    Value::from(text).to_string()
}

/// What was answered, as it is written.
struct Answers {
    title: String,
    mass: String,
    speed: String,
    bearing: String,
    /// Distance of two bearings, m; zero of one.
    span: f64,
    radial: String,
    axial: String,
    /// Speed, rad/s, radial and axial load, N.
    numbers: [f64; 3],
}

/// Asks, writes the scenario and says what comes next.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let file = &arguments.file;
    let printed = file == Path::new(STDIN);
    let refuse = |message: &str| {
        terminal::tell(&format!("error: {}: {message}\n", file.display()));
        Ok(Outcome::WrongInput)
    };
    if !printed && file.extension().is_none_or(|extension| extension != "toml") {
        return refuse("a scenario that is written ends in .toml");
    }
    if !printed && file.exists() {
        return refuse("it is there already, and stays as it is: give another name");
    }
    let text = match Answers::of(arguments) {
        Ok(answers) => answers.scenario(),
        Err(issue) => return refuse(&issue.to_string()),
    };
    let (text, scenario) = match text {
        Ok(text) => text,
        Err(error) => {
            terminal::tell(&error.render(terminal::color()));
            return Ok(Outcome::WrongInput);
        }
    };
    for warning in &scenario.warnings {
        terminal::tell(&format!("warning: {}: {warning}\n", file.display()));
    }
    if printed {
        terminal::print(&text)?;
        return Ok(Outcome::Done);
    }
    match write_new(file, &text) {
        Ok(()) => {
            let name = file.display();
            terminal::summarise(&format!("wrote {name}; next: jeffcott run {name}\n"))?;
            Ok(Outcome::Done)
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            refuse("it is there already, and stays as it is: give another name")
        }
        Err(error) => {
            terminal::tell(&format!("error: {}: {error}\n", file.display()));
            Ok(Outcome::Failed)
        }
    }
}

fn write_new(file: &Path, text: &str) -> io::Result<()> {
    let mut options = OpenOptions::new();
    let mut file = options.write(true).create_new(true).open(file)?;
    file.write_all(text.as_bytes())
}

impl Answers {
    fn of(arguments: &Arguments) -> Result<Self, Issue> {
        let dialogue = Dialogue {
            asks: io::stdin().is_terminal() && io::stderr().is_terminal(),
        };
        let ask = |option, text, key, given: &Option<String>, default: &str| {
            let question = Question { option, text, key };
            dialogue.answer(&question, given.as_ref(), default)
        };
        let mass = "Mass of all that moves with the shaft";
        let (mass, _) = ask("mass", mass, Some("shaft.mass"), &arguments.mass, "5 kg")?;
        let key = Some("speed.constant");
        let (speed, omega) = ask("speed", "Speed", key, &arguments.speed, "3000 rpm")?;
        let bearing = "Bearing, as `jeffcott catalogue` lists it";
        let (bearing, _) = ask("bearing", bearing, None, &arguments.bearing, "6205")?;
        let span = "Distance of two such bearings; 0 mm for one alone";
        let key = Some("bearing[].position");
        let (_, span) = ask("span", span, key, &arguments.span, "100 mm")?;
        let radial = "Radial load beside the weight, downwards";
        let key = Some("load[].constant.y");
        let (radial, down) = ask("radial", radial, key, &arguments.radial, "0 N")?;
        let default = if span == 0.0 { "200 N" } else { "0 N" };
        let (axial, along) = ask("axial", "Axial load", key, &arguments.axial, default)?;
        if span < 0.0 {
            return Err(Issue::new("span", "a distance is zero or positive"));
        }
        let stem = arguments.file.file_stem().unwrap_or_default();
        Ok(Self {
            title: match stem.to_str() {
                Some(STDIN) | None => "shaft".to_owned(),
                Some(stem) => stem.to_owned(),
            },
            mass,
            speed,
            bearing,
            span,
            radial,
            axial,
            numbers: [omega, down, along],
        })
    }

    /// The text of the scenario, and what it says.
    fn scenario(&self) -> Result<(String, Scenario), ScenarioError> {
        let parse = |text: &str| scenario::parse(text, "the scenario", Format::Toml);
        let plain = self.text(None);
        let scenario = parse(&plain)?;
        let bearings = &scenario.question.rotor.bearings;
        match &bearings[..] {
            [first, _] if !first.bearing.geometry.is_symmetric() => {
                let text = self.text(Some(first));
                parse(&text).map(|scenario| (text, scenario))
            }
            _ => Ok((plain, scenario)),
        }
    }

    /// The text; two angular contact bearings such as `pair` are set against each other.
    fn text(&self, pair: Option<&MountedBearing>) -> String {
        let Self {
            title,
            mass,
            speed,
            bearing,
            span,
            ..
        } = self;
        let [omega, ..] = self.numbers;
        let [title, mass, speed] = [title, mass, speed].map(|text| quoted(text));
        let (eccentricity, grade) = match omega > 0.0 {
            true => (
                6.3e3 / omega,
                format!("balance grade G 6.3 at {}", self.speed),
            ),
            false => (10.0, "nothing shows it at rest".to_owned()),
        };
        let (settle, duration) = times(omega);
        let sampling = match omega > 0.0 {
            true => "# samples_per_revolution = 128",
            false => "sample_rate = \"20 kHz\" # a standing shaft makes no revolutions to sample",
        };
        let bearings = match (pair, *span > 0.0) {
            (_, false) => one_bearing(bearing, "0 mm", ""),
            (None, true) => {
                let [low, high] = [-500.0 * span, 500.0 * span].map(|at| format!("{at:.6} mm"));
                one_bearing(bearing, &trimmed(&low), "")
                    + &one_bearing(bearing, &trimmed(&high), "")
            }
            (Some(pair), true) => {
                let rating = pair.bearing.dynamic_rating.unwrap_or(1e4);
                let more = format!(
                    "arrangement = \"back-to-back\" # or \"face-to-face\", \"tandem\"\nspacing = \"{}\"\n\
                     preload = \"{:.0} N\" # light: 1 % of the dynamic load rating\n",
                    trimmed(&format!("{:.6} mm", 1e3 * span)),
                    0.01 * rating
                );
                one_bearing(bearing, "0 mm", &more)
            }
        };
        format!(
            "# Written by `jeffcott new`. Change what you like: `jeffcott check` says what does not fit, and\n\
             # `jeffcott schema` lets an editor complete and explain all keys.\n\
             title = {title}\n\n\
             [shaft]\n\
             mass = {mass}\n\
             eccentricity = \"{eccentricity:.3} um\" # of the centre of mass: {grade}\n\
             # \"all\" lets the shaft tilt, too, and needs inertia_transverse and inertia_polar\n\
             freedoms = \"translational\"\n\
             gravity = true # along -y; false for a shaft that stands upright\n\n\
             [speed]\n\
             constant = {speed}\n\
             # a run-up instead: from = \"0 rpm\", to = {speed}, over = \"2 s\"\n\n\
             # Positions count from the centre of mass along the shaft, +z.\n\
             {bearings}\
             [model]\n\
             contact = \"hertz\" # \"jones\" for fast bearings: it knows the inertia of the balls\n\n\
             [damping]\n\
             ratio = 0.03 # of critical damping; measured on ball bearings: 0.02 to 0.04\n\n\
             {loads}\
             [time]\n\
             duration = \"{duration} s\"\n\
             settle = \"{settle} s\" # what the start leaves has decayed by then; spectra come after it\n\n\
             [output]\n\
             {sampling}\n",
            loads = self.loads(),
        )
    }

    fn loads(&self) -> String {
        let [_, down, along] = self.numbers;
        let mut parts = Vec::new();
        if down != 0.0 {
            let turned = match self.radial.strip_prefix('-') {
                Some(upwards) => upwards.to_owned(),
                None => format!("-{}", self.radial.trim_start_matches('+')),
            };
            parts.push(format!("y = {}", quoted(&turned)));
        }
        if along != 0.0 {
            parts.push(format!("z = {}", quoted(&self.axial)));
        }
        match &parts[..] {
            [] => "# A load: [[load]] with constant = { y = \"-300 N\", z = \"200 N\" }\n\n"
                .to_owned(),
            _ => format!("[[load]]\nconstant = {{ {} }}\n\n", parts.join(", ")),
        }
    }
}

fn one_bearing(name: &str, position: &str, more: &str) -> String {
    format!(
        "[[bearing]]\ncatalogue = {}\nposition = \"{position}\"\n{more}\n",
        quoted(name)
    )
}

/// Settle time and duration, s: ten revolutions each, and 0.2 s and 0.3 s unless that are more than 500.
fn times(omega: f64) -> (f64, f64) {
    let revolution = if omega > 0.0 { TAU / omega } else { 0.0 };
    let [settle, window] = [0.2_f64, 0.3].map(|least| match revolution > 0.0 {
        true => least.min(500.0 * revolution).max(10.0 * revolution),
        false => least,
    });
    // whole milliseconds, so that the file is easy to read
    let rounded = |time: f64| (1e3 * time).ceil() / 1e3;
    (rounded(settle), rounded(settle + window))
}

/// A number with its unit without closing zeros.
fn trimmed(quantity: &str) -> String {
    let (number, unit) = quantity.split_once(' ').unwrap_or((quantity, ""));
    format!(
        "{} {unit}",
        number.trim_end_matches('0').trim_end_matches('.')
    )
}
