//! `[[element]]`: what holds, damps or rubs the shaft besides its bearings.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{Components, PerFreedom};
use super::support::HousingInput;
use crate::bearing::Facing;
use crate::rotor::{
    Coupling, ElementLaw, FREEDOMS, ForceElement, Freedoms, LinearLaw, Load, Rub, SqueezeFilm,
};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{
    Angle, Damping, Length, Measure, Moment, Quantity, Stiffness, TiltDamping, TiltStiffness,
    Viscosity, si,
};
use crate::scenario::{Issue, coefficients_file};

/// Length of a film over its diameter up to which it counts as short.
const SHORT: f64 = 0.5;

/// What holds, damps or rubs the shaft besides its bearings: exactly one law of force. It sits between the shaft and the ground,
/// or a housing, or between a housing and the ground.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["linear", "coefficients", "squeeze_film", "rub", "coupling"]))]
pub struct ElementInput {
    /// Position along the shaft, from the centre of mass towards +Z, or, of a shaft that bends, from its left end.
    /// Default: "0 m"; with `housing_of` and without a position the element sits between that housing and the ground.
    #[schemars(extend("examples" = ["-30 mm"]))]
    pub position: Option<Quantity<Length>>,
    /// Number of the bearing in whose housing it sits, or whose housing it holds against the ground; elements count on
    /// behind the bearings.
    #[schemars(range(min = 1))]
    pub housing_of: Option<u32>,
    /// Springs and dampers of constant coefficients.
    pub linear: Option<LinearInput>,
    /// A file of stiffness and damping over the speed, as of a journal bearing or a seal: CSV with the columns `speed_rad_s` or
    /// `speed_rpm`, `kxx_N_m`, `kxy_N_m`, `kyx_N_m`, `kyy_N_m`, `kzz_N_m` and `cxx_N_s_m` …, or a bearing that ROSS has saved, in
    /// TOML or JSON. Beyond its first and last speed their coefficients are kept.
    #[schemars(extend("examples" = ["journal.csv"]))]
    pub coefficients: Option<String>,
    /// A squeeze film damper.
    pub squeeze_film: Option<SqueezeFilmInput>,
    /// A ring about the shaft that it rubs where it has crossed its clearance.
    pub rub: Option<RubInput>,
    /// A flexible coupling to a shaft that does not vibrate, which may be misaligned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coupling: Option<CouplingInput>,
    /// The housing that it is mounted in. Default: it is mounted on the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub housing: Option<HousingInput>,
}

/// Springs and dampers to the ground or to a housing. What is left out is zero.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearInput {
    /// Stiffness, for instance { x = "1e6 N/m", y = "1e6 N/m" }. `xy` is the force along X that a displacement along Y takes,
    /// `yx` that along Y by one along X; one that is left out is like the other, as of springs whose axes are inclined. A
    /// film or seal has both with opposite signs, and drives a forward whirl where `xy` is the positive one.
    #[schemars(extend("examples" = [{ "x": "1 N/um", "y": "1 N/um" }]))]
    pub stiffness: Coupled<Stiffness, TiltStiffness>,
    /// Damping, for instance { x = "100 N s/m", y = "100 N s/m" }, by velocities in the same way. Default: none.
    pub damping: Option<Coupled<Damping, TiltDamping>>,
}

/// A short film of oil about a ring that does not turn, open at its ends, with cavitation on the side that the ring leaves
/// (π film). It holds nothing by itself: springs beside it must.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SqueezeFilmInput {
    /// Diameter of the ring, for instance "120 mm".
    #[schemars(extend("examples" = ["120 mm"], "x-above" = 0.0))]
    pub diameter: Quantity<Length>,
    /// Length of the film along the shaft, up to half the diameter.
    #[schemars(extend("examples" = ["30 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Radial clearance, for instance "0.1 mm".
    #[schemars(extend("examples" = ["0.1 mm"], "x-above" = 0.0))]
    pub clearance: Quantity<Length>,
    /// Dynamic viscosity of the oil, for instance "10 mPa s".
    #[schemars(extend("examples" = ["10 mPa s"], "x-above" = 0.0))]
    pub viscosity: Quantity<Viscosity>,
}

/// A ring on springs, alike in all directions, with Coulomb friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RubInput {
    /// Radial clearance between shaft and ring, for instance "0.2 mm".
    #[schemars(extend("examples" = ["0.2 mm"], "x-above" = 0.0))]
    pub clearance: Quantity<Length>,
    /// Stiffness of the ring, for instance "10 N/um".
    #[schemars(extend("examples" = ["10 N/um"], "x-above" = 0.0))]
    pub stiffness: Quantity<Stiffness>,
    /// Coefficient of friction. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 2.0))]
    pub friction: f64,
    /// Diameter of the shaft where it rubs: by it and the speed the surface slides. Needed with friction.
    #[schemars(extend("examples" = ["60 mm"], "x-above" = 0.0))]
    pub shaft_diameter: Option<Quantity<Length>>,
}

/// A coupling of two flexible joints with a spacer between them. A misalignment loads the shaft with a constant reaction and
/// with parts of the same size at 1× and 2× (Gibbons 1976; Sekhar & Prabhu 1995).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CouplingInput {
    /// Stiffness of each joint against bending, for instance "2000 N m/rad".
    #[schemars(extend("examples" = ["2000 N m/rad"], "x-above" = 0.0))]
    pub bending_stiffness: Quantity<TiltStiffness>,
    /// Damping of each joint. Default: none.
    #[schemars(extend("examples" = ["0.5 N m s/rad"], "x-minimum" = 0.0))]
    pub bending_damping: Option<Quantity<TiltDamping>>,
    /// Distance of the joints, the first of which sits at `position`.
    #[schemars(extend("examples" = ["100 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Torque that it carries. Default: "0 N m".
    #[schemars(extend("examples" = ["50 N m"]))]
    pub torque: Option<Quantity<Moment>>,
    /// Parallel offset of the other shaft. Default: "0 m".
    #[schemars(extend("examples" = ["0.2 mm"]))]
    pub offset: Option<Quantity<Length>>,
    /// Angle between the shafts, of which small ones are meant. Default: "0 rad".
    #[schemars(extend("examples" = ["0.2 deg"]))]
    pub angle: Option<Quantity<Angle>>,
    /// Direction of offset and angle, from +X towards +Y. Default: "0 rad".
    #[schemars(extend("examples" = ["90 deg"]))]
    pub direction: Option<Quantity<Angle>>,
    /// Which way along Z the other shaft lies. Default: "+z".
    #[serde(default)]
    pub towards: Facing,
}

/// Values along the axes (`T`) and about them (`R`), and across between x and y.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(bound(
    serialize = "T: Measure + Clone, R: Measure + Clone",
    deserialize = "T: Measure + Clone, R: Measure + Clone"
))]
#[schemars(bound = "T: Measure, R: Measure", deny_unknown_fields, extend("minProperties" = 1))]
pub struct Coupled<T, R> {
    /// Along the axes and about them.
    #[serde(flatten)]
    pub direct: Components<T, R>,
    /// Force along X that a displacement, or velocity, along Y takes.
    pub xy: Option<Quantity<T>>,
    /// Force along Y that one along X takes. Default: that of `xy`, springs whose axes are inclined; a film or seal that
    /// drives a whirl has both with opposite signs.
    pub yx: Option<Quantity<T>>,
}

impl<T, R> Coupled<T, R> {
    /// Values of x, y, z and the tilts, SI.
    fn direct(&self) -> [f64; FREEDOMS] {
        self.direct.values().map(Option::unwrap_or_default)
    }

    /// Those of xy and yx.
    fn across(&self) -> [f64; 2] {
        let [xy, yx] = [&self.xy, &self.yx].map(si);
        [xy.or(yx), yx.or(xy)].map(Option::unwrap_or_default)
    }
}

impl LinearInput {
    /// As a law of force.
    fn build(&self) -> LinearLaw {
        let damping = self.damping.as_ref();
        let damping = damping.map(|own| (own.direct(), own.across()));
        LinearLaw::new(
            (self.stiffness.direct(), self.stiffness.across()),
            damping.unwrap_or_default(),
        )
    }
}

impl CouplingInput {
    fn build(&self) -> Coupling {
        Coupling {
            bending_stiffness: self.bending_stiffness.si(),
            bending_damping: si(&self.bending_damping).unwrap_or(0.0),
            length: self.length.si(),
            torque: si(&self.torque).unwrap_or(0.0),
            offset: si(&self.offset).unwrap_or(0.0),
            angle: si(&self.angle).unwrap_or(0.0),
            direction: si(&self.direction).unwrap_or(0.0),
            side: match self.towards {
                Facing::PlusZ => 1.0,
                Facing::MinusZ => -1.0,
            },
        }
    }
}

impl ElementInput {
    /// What loads the shaft besides, of a misaligned coupling.
    pub fn loads(&self) -> Vec<Load> {
        let coupling = self.coupling.as_ref().map(CouplingInput::build);
        let position = si(&self.position).unwrap_or(0.0);
        coupling.map_or_else(Vec::new, |own| own.loads(position))
    }

    /// Whether it holds the shaft along z.
    pub fn holds_z(&self) -> bool {
        let linear = self.linear.as_ref();
        linear.is_some_and(|own| si(&own.stiffness.direct.z).is_some_and(|own| own > 0.0))
    }

    /// The element, as far as nothing contradicts it.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Option<ForceElement> {
        let housing = problems.given("housing", &self.housing, |housing, problems| {
            problems.take(housing.build(freedoms))
        });
        if self.housing_of.is_some() && self.housing.is_some() {
            let message = "`housing` and `housing_of` both say where it sits";
            let issue = Issue::new(".housing_of", message).help("keep one of them");
            problems.refuse(issue.against(".housing"));
        }
        let law = self.law(problems)?;
        let position = self.position.as_ref().map(Quantity::si);
        Some(ForceElement {
            position: position.or(self.housing_of.is_none().then_some(0.0)),
            housing_of: self.housing_of.map(|number| number.max(1) as usize - 1),
            housing: housing?,
            law,
        })
    }

    fn law(&self, problems: &mut Problems<'_>) -> Option<ElementLaw> {
        if let Some(linear) = &self.linear {
            return Some(ElementLaw::Linear(Box::new(linear.build())));
        }
        if let Some(file) = &self.coefficients {
            let read = coefficients_file::read(&problems.folder.join(file));
            return problems.take(read.map_err(|problem| {
                let message = format!("`{file}` has no coefficients of a bearing: {problem}");
                Issue::new(".coefficients", message)
            }));
        }
        if let Some(film) = &self.squeeze_film {
            return Some(ElementLaw::SqueezeFilm(film.build(problems)));
        }
        if let Some(coupling) = &self.coupling {
            if self.housing_of.is_some() || self.housing.is_some() {
                let message = "a coupling leads to another shaft, and not to a housing";
                problems.refuse(Issue::new(".coupling", message).help("leave the housing out"));
            }
            return Some(ElementLaw::Linear(Box::new(coupling.build().law())));
        }
        let rub = self.rub.as_ref()?;
        if rub.friction > 0.0 && rub.shaft_diameter.is_none() {
            let message = "friction needs the `shaft_diameter`, by which the surface slides";
            problems.refuse(Issue::new(".rub", message).help("for instance: \"60 mm\""));
        }
        Some(ElementLaw::Rub(Rub {
            clearance: rub.clearance.si(),
            stiffness: rub.stiffness.si(),
            friction: rub.friction,
            radius: 0.5 * si(&rub.shaft_diameter).unwrap_or(0.0),
        }))
    }
}

impl SqueezeFilmInput {
    fn build(&self, problems: &mut Problems<'_>) -> SqueezeFilm {
        let slenderness = self.length.si() / self.diameter.si();
        if slenderness > SHORT {
            let path = problems.path(".squeeze_film.length");
            problems.warn(format!(
                "`{path}` is {slenderness:.2} of the diameter: the film of a short bearing is too stiff from about {SHORT} on"
            ));
        }
        SqueezeFilm {
            radius: 0.5 * self.diameter.si(),
            length: self.length.si(),
            clearance: self.clearance.si(),
            viscosity: self.viscosity.si(),
        }
    }
}

/// Refuses a `housing_of` that names no housing.
pub fn check_housings(elements: &[ForceElement], housings: &[usize], problems: &mut Problems<'_>) {
    for (index, element) in elements.iter().enumerate() {
        let Some(number) = element.housing_of.filter(|own| !housings.contains(own)) else {
            continue;
        };
        let message = format!("bearing {} is in no housing", number + 1);
        let issue = Issue::new(format!("element[{}].housing_of", index + 1), message);
        problems.refuse(
            issue.help("give it a table [bearing.housing]; elements count on behind the bearings"),
        );
    }
}
