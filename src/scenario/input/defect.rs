//! `[[bearing.defect]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::{Defect, DefectProfile, Geometry, ImperfectionError, Surface};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length, Quantity};

/// Where an imperfection is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceInput {
    /// The outer race.
    Outer,
    /// The inner race.
    Inner,
    /// A ball.
    Ball,
}

/// A slot across a race, or a dent of a ball. The ball sinks as deep as the edges let it, or to the floor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DefectInput {
    /// Where it is: "outer", "inner" or "ball".
    pub on: SurfaceInput,
    /// Number of the ball that it is on, from 1: ball 1 starts at `first_ball`.
    #[schemars(range(min = 1, max = 200))]
    pub ball: Option<u32>,
    /// Angle of its middle: on the outer race from +X towards +Y, on the inner race from the mark of the unbalance, which
    /// points along +X at the start; on a ball from where it meets the outer race at the start. Default: "0 rad".
    #[serde(default)]
    #[schemars(extend("examples" = ["-90 deg"]))]
    pub angle: Quantity<Angle>,
    /// Length along the race, for instance "0.5334 mm".
    #[schemars(extend("examples" = ["0.5334 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Depth of its floor, for instance "0.2794 mm". Few balls ever reach it.
    #[schemars(extend("examples" = ["0.2794 mm"], "x-above" = 0.0))]
    pub depth: Quantity<Length>,
    /// How the drop of a ball follows: "edges", the exact one of sharp edges; "half_sine" and "rectangular" of the whole
    /// depth are found in literature. Default: "edges".
    #[serde(default)]
    pub profile: DefectProfile,
}

impl DefectInput {
    /// The defect, as far as it fits the bearing.
    pub fn build(&self, geometry: &Geometry, problems: &mut Problems<'_>) -> Option<Defect> {
        let Some(on) = surface(self.on, self.ball, problems)? else {
            let issue = Issue::new(".ball", "a defect of a ball needs its number")
                .help("for instance: ball = 1, the one that starts at `first_ball`");
            problems.refuse(issue.against(".on"));
            return None;
        };
        let defect = Defect {
            on,
            angle: self.angle.si(),
            length: self.length.si(),
            depth: self.depth.si(),
            profile: self.profile,
        };
        match defect.check(geometry) {
            Ok(()) => Some(defect),
            Err(error) => {
                let key = match error {
                    ImperfectionError::Ball { .. } => ".ball",
                    ImperfectionError::Length { name: "depth", .. } => ".depth",
                    ImperfectionError::NotFinite { .. } => ".angle",
                    _ => ".length",
                };
                problems.refuse(Issue::new(key, error.to_string()));
                None
            }
        }
    }
}

/// The surface that is meant: `Some(None)` where all balls are, `None` where a number is given for a race.
pub fn surface(
    on: SurfaceInput,
    ball: Option<u32>,
    problems: &mut Problems<'_>,
) -> Option<Option<Surface>> {
    let race = match on {
        SurfaceInput::Outer => Surface::Outer,
        SurfaceInput::Inner => Surface::Inner,
        SurfaceInput::Ball => {
            let number = ball.map(|ball| Surface::Ball(ball as usize - 1));
            return Some(number);
        }
    };
    if ball.is_some() {
        let message = "`ball` is the number of a ball, and this is on a race";
        let issue = Issue::new(".ball", message).help("remove it, or set on = \"ball\"");
        problems.refuse(issue.against(".on"));
        return None;
    }
    Some(Some(race))
}
