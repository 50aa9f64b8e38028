//! `[speed]` and `[speed.drive]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::rotor::{Drive, SpeedPoint, SpeedProfile};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{AngularSpeed, Moment, Quantity, Time, si};

/// How fast the shaft turns about +Z, in exactly one of four ways: `constant`; `from`, `to` and
/// `over`; `profile`; or `drive`, where the speed follows from the moments on the shaft. Static equilibrium, damping ratios and natural frequencies are those at the
/// start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["constant", "from", "profile", "drive"]))]
pub struct SpeedInput {
    /// Constant speed from the start on, for instance "500 rad/s" or "3000 rpm"; zero or
    /// positive.
    #[schemars(extend("x-minimum" = 0.0))]
    pub constant: Option<Quantity<AngularSpeed>>,
    /// Speed at the start of a run-up or coast-down at constant acceleration.
    #[schemars(extend("examples" = ["0 rpm"], "x-minimum" = 0.0))]
    pub from: Option<Quantity<AngularSpeed>>,
    /// Speed at its end, which is held from there on.
    #[schemars(extend("examples" = ["3000 rpm"], "x-minimum" = 0.0))]
    pub to: Option<Quantity<AngularSpeed>>,
    /// Time that it takes.
    #[schemars(extend("examples" = ["2 s"], "x-minimum" = 1e-6))]
    pub over: Option<Quantity<Time>>,
    /// Speeds at times, the first at "0 s" and at least two, with straight lines between them;
    /// the last speed is held.
    #[schemars(extend("examples" = [[
        { "at": "0 s", "speed": "0 rpm" }, { "at": "2 s", "speed": "3000 rpm" },
    ]]))]
    pub profile: Option<Vec<PointInput>>,
    /// A motor; the speed is part of the answer.
    #[schemars(extend("examples" = [{ "torque": "5 N m", "no_load_speed": "3000 rpm" }]))]
    pub drive: Option<DriveInput>,
}

/// A speed at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointInput {
    /// Time.
    #[schemars(extend("examples" = ["0 s"], "x-minimum" = 0.0))]
    pub at: Quantity<Time>,
    /// Speed at that time.
    #[schemars(extend("examples" = ["3000 rpm"], "x-minimum" = 0.0))]
    pub speed: Quantity<AngularSpeed>,
}

impl SpeedInput {
    /// The key that the speed is given by.
    pub fn path(&self) -> &'static str {
        match self {
            Self { from: Some(_), .. } => "speed.from",
            Self {
                profile: Some(_), ..
            } => "speed.profile",
            Self { drive: Some(_), .. } => "speed.drive",
            _ => "speed.constant",
        }
    }

    /// The speed from the start on, as far as nothing contradicts it; of a drive that at the start.
    pub fn build(&self, problems: &mut Problems<'_>) -> Option<SpeedProfile> {
        let ramp = self.ramp(problems);
        let (start, points) = if let Some(from) = &self.from {
            (from.si(), vec![ramp?])
        } else if let Some(profile) = &self.profile {
            problems.take(points(profile))?
        } else if let Some(drive) = &self.drive {
            (drive.start.si(), Vec::new())
        } else {
            (si(&self.constant).unwrap_or(0.0), Vec::new())
        };
        let profile = SpeedProfile::new(start, &points);
        problems.take(profile.map_err(|error| Issue::new(self.path(), error.to_string())))
    }

    /// The end of a run-up or coast-down; its three keys go together.
    fn ramp(&self, problems: &mut Problems<'_>) -> Option<SpeedPoint> {
        let keys = [
            ("from", self.from.is_some()),
            ("to", self.to.is_some()),
            ("over", self.over.is_some()),
        ];
        let named = |given: bool| {
            let keys = keys.iter().filter(move |(_, there)| *there == given);
            keys.map(|(key, _)| format!("`{key}`")).collect::<Vec<_>>()
        };
        let (given, missing) = (named(true), named(false).join(" and "));
        if let Some(first) = given.first().filter(|_| !missing.is_empty()) {
            let message = format!("{} needs {missing} as well", given.join(" with "));
            let issue = Issue::new(format!("speed.{}", first.trim_matches('`')), message);
            problems.refuse(
                issue.help("a run-up is from = \"0 rpm\", to = \"3000 rpm\", over = \"2 s\""),
            );
        }
        Some(SpeedPoint {
            time: si(&self.over)?,
            speed: si(&self.to)?,
        })
    }
}

/// The speed at the start and the points after it; the times must rise from zero.
fn points(profile: &[PointInput]) -> Result<(f64, Vec<SpeedPoint>), Issue> {
    let [first, _, ..] = profile else {
        let count = profile.len();
        let message = format!("`profile` must have at least two points, not {count}");
        let issue = Issue::new("speed.profile", message);
        return Err(issue.help("for a single speed: constant = \"3000 rpm\""));
    };
    if first.at.si() != 0.0 {
        let message = "the first point of `profile` must stand at 0 s";
        return Err(Issue::new("speed.profile[1].at", message));
    }
    for (index, pair) in profile.windows(2).enumerate() {
        let (before, time) = (pair[0].at.si(), pair[1].at.si());
        if time <= before {
            let message = format!("`at` must rise from point to point: {before} s comes before");
            let issue = Issue::new(format!("speed.profile[{}].at", index + 2), message);
            return Err(issue.against(format!("speed.profile[{}].at", index + 1)));
        }
    }
    let point = |point: &PointInput| SpeedPoint {
        time: point.at.si(),
        speed: point.speed.si(),
    };
    Ok((first.speed.si(), profile[1..].iter().map(point).collect()))
}

/// A motor that turns the shaft against a load and the friction of the bearings. `shaft.inertia_polar`
/// is that of everything that turns; `[shaft.torsion]` adds the twist under the friction moment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveInput {
    /// Speed at the start. Default: "0 rad/s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0 rpm"], "x-minimum" = 0.0))]
    pub start: Quantity<AngularSpeed>,
    /// Moment of the motor at rest, for instance "5 N m".
    #[schemars(extend("examples" = ["5 N m"], "x-minimum" = 0.0))]
    pub torque: Quantity<Moment>,
    /// Speed up to which the moment falls linearly to zero, for instance "3000 rpm". Without it the
    /// moment is constant.
    #[schemars(extend("examples" = ["3000 rpm"], "x-above" = 0.0))]
    pub no_load_speed: Option<Quantity<AngularSpeed>>,
    /// Moment of the driven machine against the rotation. Default: "0 N m".
    #[serde(default)]
    #[schemars(extend("examples" = ["2 N m"], "x-minimum" = 0.0))]
    pub load_torque: Quantity<Moment>,
    /// Whether the friction moment of the bearings (Palmgren) resists. Default: true.
    #[serde(default = "yes")]
    pub friction: bool,
}

fn yes() -> bool {
    true
}

impl DriveInput {
    /// The drive of a shaft that a friction moment twists by `compliance` in rad/(N m).
    pub fn build(&self, compliance: f64) -> Drive {
        Drive {
            torque: self.torque.si(),
            no_load_speed: si(&self.no_load_speed),
            load_torque: self.load_torque.si(),
            friction: self.friction,
            compliance,
        }
    }
}
