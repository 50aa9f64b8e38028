//! `[[unbalance]]`, and the unbalance of the shaft as a text.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::rotor::{PlaneUnbalance, RotorDefinition};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{self, Angle, Dimension, Length, Quantity, Unbalance};
use crate::scenario::wrong_value::no_quantity;

/// An unbalance in a plane of the shaft. Several add up: on a rigid shaft to a static unbalance and a couple.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnbalanceInput {
    /// Mass times its distance from the axis, for instance "20 g mm".
    #[schemars(extend("x-minimum" = 0.0))]
    pub amount: Quantity<Unbalance>,
    /// Angle on the shaft, from +X towards +Y at shaft angle 0. Default: "0 rad".
    #[serde(default)]
    #[schemars(extend("examples" = ["180 deg"]))]
    pub angle: Quantity<Angle>,
    /// Position of the plane along the shaft, from the centre of mass towards +Z, or, needed then, from the left end of a
    /// shaft that bends. Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["-30 mm"]))]
    pub position: Quantity<Length>,
}

/// What `[shaft]`, whose unbalance is a `text`, and the planes give together on a rigid shaft.
pub fn build(
    text: Option<&str>,
    planes: &[UnbalanceInput],
    rotor: &RotorDefinition,
    problems: &mut Problems<'_>,
) -> PlaneUnbalance {
    let mut sum = PlaneUnbalance::default();
    if let Some(text) = text {
        if rotor.shaft.eccentricity != 0.0 {
            let message = "`eccentricity` and `unbalance` both say how the shaft is balanced";
            let issue = Issue::new("shaft.unbalance", message).help("keep one of them");
            problems.refuse(issue.against("shaft.eccentricity"));
        }
        if let Some(amount) = problems.take(amount(text, rotor)) {
            sum.add(amount, 0.0, 0.0);
        }
    }
    for plane in planes {
        sum.add(plane.amount.si(), plane.angle.si(), plane.position.si());
    }
    if sum.couple != [0.0; 2] && !rotor.shaft.freedoms.tilts() {
        problems.warn(
            "the unbalances have a couple about the centre of mass, which has no effect: the tilts are held \
             (freedoms = \"all\" lets them move)",
        );
    }
    sum
}

/// Static unbalance in kg m of `20 g mm`, or of a balance quality grade `G 6.3`: `U = m G/ω` (ISO 21940-11).
fn amount(text: &str, rotor: &RotorDefinition) -> Result<f64, Issue> {
    let path = "shaft.unbalance";
    if let Some(grade) = text.trim().strip_prefix(['G', 'g']) {
        let grade = grade.trim().parse::<f64>();
        let grade = grade.ok().filter(|grade| (0.0..=4000.0).contains(grade));
        let grade = grade.ok_or_else(|| {
            let rule = "a number of 0 to 4000 mm/s follows the G";
            let message = format!("`{text}` is no balance quality grade: {rule}");
            Issue::new(path, message).help("for instance: unbalance = \"G 6.3\"")
        })?;
        let speed = rotor.highest_speed();
        if speed <= 0.0 {
            let message =
                "a balance quality grade is an unbalance at a speed, and the shaft is stationary";
            let issue = Issue::new(path, message).help("give the unbalance, as in \"20 g mm\"");
            return Err(issue.against_all(["speed.constant", "speed.from", "speed.to"]));
        }
        return Ok(rotor.shaft.mass * 1e-3 * grade / speed);
    }
    match quantity::parse(text, &[Dimension::Unbalance]) {
        Ok(parsed) if (0.0..=1e6).contains(&parsed.si) => Ok(parsed.si),
        Ok(_) => Err(Issue::new(path, "`unbalance` must be zero or positive")),
        Err(error) => {
            let mut issue = no_quantity(error, text.trim(), &[Dimension::Unbalance], path);
            let grade = "a balance quality grade is written \"G 6.3\"";
            issue.help = issue.help.map(|help| format!("{help}; {grade}"));
            Err(issue)
        }
    }
}
