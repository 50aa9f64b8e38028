//! `[shaft]` and `[shaft.torsion]`.

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::flexible::SectionInput;
use super::material::MaterialInput;
use crate::quasi_static::{Torsion, TorsionCause};
use crate::rotor::{FlexibleShaft, Freedoms, PlaneUnbalance, Shaft};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{
    Angle, Inertia, Length, Mass, Moment, Pressure, Quantity, SecondMoment, Time, si,
};

/// The shaft: a rigid, concentrated mass, or, with sections, an elastic beam with discs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShaftInput {
    /// Mass of everything that moves with a rigid shaft, for instance "5 kg".
    #[schemars(extend("examples" = ["5 kg"], "x-minimum" = 1e-6))]
    pub mass: Option<Quantity<Mass>>,
    /// Sections of a shaft that bends, one `[[shaft.section]]` for each, from its left end on. Positions of bearings,
    /// discs, loads and unbalances then count from there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub section: Vec<SectionInput>,
    /// JSON file with nodes and matrices M, K and G of a shaft from another program, instead of sections.
    #[schemars(extend("examples" = ["shaft.json"]))]
    pub matrices: Option<String>,
    /// Material of the sections. Default: steel, 210 GPa, 0.3, 7850 kg/m³.
    pub material: Option<MaterialInput>,
    /// Modes of bending between the points where something acts, in each plane, 0 to 60. Default: those below three times
    /// the highest excitation, but at least 4 and at most 20.
    #[schemars(range(min = 0, max = 60))]
    pub modes: Option<u32>,
    /// Position whose motion is recorded, from the left end of a shaft that bends. Default: that of the heaviest disc, or
    /// the middle.
    #[schemars(extend("examples" = ["300 mm"]))]
    pub observed: Option<Quantity<Length>>,
    /// Internal damping of a shaft that bends, as this time multiplied by its stiffness; it turns with the shaft, and above
    /// a critical speed it drives a whirl, for instance "2 us". Default: "0 s".
    #[schemars(extend("examples" = ["2 us"], "x-minimum" = 0.0, "x-maximum" = 1.0))]
    pub internal_damping: Option<Quantity<Time>>,
    /// Distance of the centre of mass from the axis of rotation, for instance "0.01 mm". The
    /// heavy side points along +X at shaft angle 0. Default: "0 m", a balanced shaft.
    #[serde(default)]
    #[schemars(extend("examples" = ["0.01 mm"], "x-minimum" = 0.0))]
    pub eccentricity: Quantity<Length>,
    /// Unbalance at the centre of mass instead of the eccentricity, for instance "20 g mm", or as a balance quality grade
    /// of ISO 21940-11 at the highest speed of the scenario, for instance "G 6.3".
    #[schemars(extend("examples" = ["20 g mm", "G 6.3"]))]
    pub unbalance: Option<String>,
    /// Which freedoms move: "radial" (x, y), "translational" (x, y, z), "lateral" (x, y and both tilts) or "all" (x, y, z
    /// and both tilts). The rest is held. Default: "all" where both moments of inertia are given or the shaft bends, else
    /// "radial". A shaft that bends always moves along x and y and tilts; "radial" and "lateral" hold its z. Where no
    /// bearing holds z and nothing acts along it, z is held whatever is written, and a warning says so.
    pub freedoms: Option<Freedoms>,
    /// Whether the weight acts, along −Y. Default: false.
    #[serde(default)]
    pub gravity: bool,
    /// Whether the sections have stiffness and no mass: the shaft of a Laval rotor. Discs have the mass, and where a ball
    /// bearing sits its inner ring does; other places follow from the forces on them, where neither damping, an unbalance
    /// nor a varying load may act. Default: false.
    #[serde(default)]
    pub massless: bool,
    /// Moment of inertia of all that turns, discs included, about a transverse axis through its centre of mass, for instance
    /// "0.01 kg m^2". Needed for a motion with freedoms = "all" or "lateral".
    #[schemars(extend("x-minimum" = 1e-12))]
    pub inertia_transverse: Option<Quantity<Inertia>>,
    /// Moment of inertia of all that turns, discs included, about the axis of rotation, for instance "0.004 kg m^2"; at most
    /// twice the transverse one. Needed for a motion with freedoms = "all" or "lateral" and for a drive.
    #[schemars(extend("examples" = ["0.004 kg m^2"], "x-minimum" = 0.0))]
    pub inertia_polar: Option<Quantity<Inertia>>,
    /// The segment that a moment about the shaft axis twists.
    pub torsion: Option<TorsionInput>,
    /// Misalignment: tilt about X that the shaft is held at where the tilts do not move, for
    /// instance "0.5 mrad". Default: "0 rad".
    #[schemars(extend("examples" = ["0.5 mrad"], "x-minimum" = -0.1, "x-maximum" = 0.1))]
    pub tilt_x: Option<Quantity<Angle>>,
    /// Misalignment: tilt about Y that the shaft is held at where the tilts do not move. Default: "0 rad".
    #[schemars(extend("examples" = ["0.5 mrad"], "x-minimum" = -0.1, "x-maximum" = 0.1))]
    pub tilt_y: Option<Quantity<Angle>>,
}

impl ShaftInput {
    /// Whether the shaft bends.
    pub fn bends(&self) -> bool {
        !self.section.is_empty() || self.matrices.is_some()
    }

    /// What of a shaft that bends the whole of it has.
    pub fn build_flexible(&self, shaft: &FlexibleShaft) -> Shaft {
        Shaft {
            mass: shaft.mass(),
            inertia_transverse: shaft.inertia_transverse(),
            inertia_polar: shaft.inertia_polar(),
            eccentricity: 0.0,
            unbalance: PlaneUnbalance::default(),
            freedoms: self.freedoms(),
            gravity: self.gravity,
            held_tilt: [0.0; 2],
        }
    }

    /// Which freedoms move.
    fn freedoms(&self) -> Freedoms {
        let inertia = self.inertia_transverse.is_some() && self.inertia_polar.is_some();
        self.freedoms.unwrap_or(match inertia || self.bends() {
            true => Freedoms::All,
            false => Freedoms::Radial,
        })
    }

    /// Writes down which freedoms move where the file does not say it, and tells it where some are held.
    pub fn choose_freedoms(&mut self, problems: &mut Problems<'_>) {
        if self.freedoms.is_none() && self.freedoms() == Freedoms::Radial {
            problems.warn(
                "no `freedoms` in `[shaft]`: x and y move (freedoms = \"radial\"), z and the tilts are held; both moments of \
                 inertia let all of them move",
            );
        }
        self.freedoms = Some(self.freedoms());
    }

    /// The shaft; its inertia is zero where no tilt moves and no drive `turns` it, and where nothing
    /// `moves` it may be.
    pub fn build(&self, moves: bool, turns: bool, problems: &mut Problems<'_>) -> Shaft {
        self.check_inertia(moves, turns, problems);
        self.check_tilt(problems);
        Shaft {
            mass: si(&self.mass).unwrap_or(0.0),
            inertia_transverse: si(&self.inertia_transverse).unwrap_or(0.0),
            inertia_polar: si(&self.inertia_polar).unwrap_or(0.0),
            eccentricity: self.eccentricity.si(),
            unbalance: PlaneUnbalance::default(),
            freedoms: self.freedoms(),
            gravity: self.gravity,
            held_tilt: [&self.tilt_x, &self.tilt_y].map(|tilt| si(tilt).unwrap_or(0.0)),
        }
    }

    /// Refuses a held tilt where the tilts move.
    fn check_tilt(&self, problems: &mut Problems<'_>) {
        for (key, tilt) in [("tilt_x", &self.tilt_x), ("tilt_y", &self.tilt_y)] {
            if tilt.is_some() && self.freedoms().tilts() {
                let name = self.freedoms().name();
                let message = format!("`{key}` holds a tilt that freedoms = \"{name}\" lets move");
                let help = format!("to start there: [initial] displacement = {{ {key} = … }}");
                let issue = Issue::new(format!("shaft.{key}"), message).help(help);
                problems.refuse(issue.against("shaft.freedoms"));
            }
        }
    }

    fn check_inertia(&self, moves: bool, turns: bool, problems: &mut Problems<'_>) {
        let freedoms = self.freedoms();
        let given = [
            ("inertia_transverse", si(&self.inertia_transverse)),
            ("inertia_polar", si(&self.inertia_polar)),
        ];
        for (key, inertia) in given {
            let path = format!("shaft.{key}");
            let turned = turns && key == "inertia_polar";
            if turned && inertia.is_none_or(|inertia| inertia <= 0.0) {
                let message = "`shaft` needs an `inertia_polar` above zero where a drive turns it";
                let help = "for instance: inertia_polar = \"0.01 kg m^2\"";
                problems.refuse(Issue::new(path, message).help(help).against("speed.drive"));
                continue;
            }
            if !freedoms.tilts() && inertia.is_some() && !turned {
                problems.warn(format!("`{path}` has no effect: the tilts are held"));
            }
            if moves && freedoms.tilts() && inertia.is_none() {
                let name = freedoms.name();
                let message = format!("`shaft` needs `{key}` where freedoms = \"{name}\"");
                let body = match key {
                    "inertia_polar" => "m·d²/8 about its axis",
                    _ => "m·(3·d² + 4·l²)/48 across it",
                };
                let issue = Issue::new(path, message).help(format!(
                    "a CAD program prints it; a solid cylinder of diameter d and length l has {body}; or hold the \
                     tilts: freedoms = \"translational\""
                ));
                problems.refuse(issue.against("shaft.freedoms"));
            }
        }
        if let [(_, Some(transverse)), (_, Some(polar))] = given
            && polar > 2.0 * transverse
        {
            let message = "no body has an `inertia_polar` above twice its `inertia_transverse`";
            let issue = Issue::new("shaft.inertia_polar", message);
            problems.refuse(issue.against("shaft.inertia_transverse"));
        }
    }
}

/// Shear modulus of steel, Pa.
const STEEL: f64 = 79.4e9;

/// The segment of the shaft that a moment about its axis twists: in static questions, and in motion
/// under a drive, there by the friction moment of the bearings. Without moment and angle that moment
/// twists it in static questions, too.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "x-exactly-one" = ["diameter", "polar_second_moment"],
    "x-at-most-one" = ["moment", "angle"]
))]
pub struct TorsionInput {
    /// Length of the segment, for instance "200 mm".
    #[schemars(extend("examples" = ["200 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Shear modulus. Default: "79.4 GPa", steel.
    #[schemars(extend("examples" = ["79.4 GPa"], "x-minimum" = 1e3))]
    pub shear_modulus: Option<Quantity<Pressure>>,
    /// Diameter of a solid round segment, for instance "25 mm".
    #[schemars(extend("examples" = ["25 mm"], "x-minimum" = 1e-5))]
    pub diameter: Option<Quantity<Length>>,
    /// Polar second moment of area of another section, for instance "38000 mm^4".
    #[schemars(extend("examples" = ["38000 mm^4"], "x-above" = 0.0))]
    pub polar_second_moment: Option<Quantity<SecondMoment>>,
    /// Moment about the shaft axis, for instance "2 N m".
    pub moment: Option<Quantity<Moment>>,
    /// Angle of twist, for instance "0.1 mrad".
    #[schemars(extend("examples" = ["0.1 mrad"]))]
    pub angle: Option<Quantity<Angle>>,
}

impl TorsionInput {
    /// The segment and what twists it.
    pub fn build(&self) -> Torsion {
        Torsion {
            length: self.length.si(),
            shear_modulus: si(&self.shear_modulus).unwrap_or(STEEL),
            // I_p = π d⁴/32 of a solid round segment
            polar_second_moment: match (&self.polar_second_moment, &self.diameter) {
                (Some(given), _) => given.si(),
                (None, Some(diameter)) => PI * diameter.si().powi(4) / 32.0,
                (None, None) => f64::INFINITY,
            },
            cause: match (&self.moment, &self.angle) {
                (Some(moment), _) => TorsionCause::Moment(moment.si()),
                (None, Some(angle)) => TorsionCause::Angle(angle.si()),
                (None, None) => TorsionCause::Friction,
            },
        }
    }
}
