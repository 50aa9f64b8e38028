//! `[bearing.oil]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::{Lubrication, Oil};
use crate::physics::{Contamination, MINERAL_OIL_DENSITY, ViscosityLaw};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{
    Density, Dimension, KinematicViscosity, Or, PressureViscosity, Quantity, Temperature,
    Viscosity, si,
};

/// Lubricating oil, or the base oil of a grease, at the temperature of the bearing: by its viscosity there, by its ISO VG class
/// or by its viscosity at 40 °C and 100 °C.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["viscosity", "iso_vg", "viscosity_40"]))]
pub struct OilInput {
    /// Viscosity at ambient pressure and the temperature of the bearing: the dynamic, for instance "0.04 Pa s", or the
    /// kinematic, for instance "46 mm^2/s", which the density turns into the dynamic.
    #[schemars(extend("x-above" = 0.0))]
    pub viscosity: Option<Quantity<Or<Viscosity, KinematicViscosity>>>,
    /// Number of the ISO VG class, for instance 68: the kinematic viscosity at 40 °C in mm²/s; needs `temperature`.
    #[schemars(range(min = 2.0, max = 3200.0), extend("examples" = [68.0]))]
    pub iso_vg: Option<f64>,
    /// Viscosity index of an oil of an ISO VG class. Below 2 mm²/s at 100 °C, where ASTM D2270 ends, it is extended.
    /// Default: 95.
    #[schemars(range(min = 0.0, max = 400.0))]
    pub viscosity_index: Option<f64>,
    /// Kinematic viscosity at 40 °C, for instance "68 mm^2/s"; needs `viscosity_100` and `temperature`.
    #[schemars(extend("x-minimum" = 2.1e-7, "x-maximum" = 1e-2))]
    pub viscosity_40: Option<Quantity<KinematicViscosity>>,
    /// Kinematic viscosity at 100 °C, for instance "8.6 mm^2/s".
    #[schemars(extend("examples" = ["8.6 mm^2/s"], "x-minimum" = 2.1e-7, "x-maximum" = 1e-2))]
    pub viscosity_100: Option<Quantity<KinematicViscosity>>,
    /// Temperature of the oil in the bearing, for instance "70 degC".
    #[schemars(extend("x-minimum" = -60.0, "x-maximum" = 250.0))]
    pub temperature: Option<Quantity<Temperature>>,
    /// Density, which kinematic and dynamic viscosity differ by. Default: "870 kg/m^3", mineral oil.
    #[schemars(extend("examples" = ["870 kg/m^3"], "x-above" = 0.0))]
    pub density: Option<Quantity<Density>>,
    /// How the viscosity grows with the pressure, for instance "22 1/GPa". Default: by Wooster from the viscosity, for
    /// mineral oil.
    #[schemars(extend("x-above" = 0.0))]
    pub pressure_viscosity: Option<Quantity<PressureViscosity>>,
    /// Whether the oil is the base oil of a grease. Default: false.
    #[serde(default)]
    pub grease: bool,
    /// How clean it is, by the classes of ISO 281; the modified life L_nm needs it.
    pub contamination: Option<Contamination>,
}

impl OilInput {
    /// Refuses what a way to give the viscosity lacks, and what does not go with it.
    pub fn check(&self, problems: &mut Problems<'_>) {
        let way = match (&self.viscosity, self.iso_vg) {
            (Some(_), _) => "viscosity",
            (None, Some(_)) => "iso_vg",
            (None, None) => "viscosity_40",
        };
        let rules = [
            (
                "temperature",
                self.temperature.is_some(),
                "\"70 degC\"",
                way != "viscosity",
            ),
            (
                "viscosity_100",
                self.viscosity_100.is_some(),
                "\"8.6 mm^2/s\"",
                way == "viscosity_40",
            ),
        ];
        for (key, given, example, needed) in rules {
            let path = format!(".oil.{key}");
            let against = format!(".oil.{way}");
            if needed && !given {
                let issue = Issue::new(path, format!("`{way}` needs `{key}`"));
                let issue = issue.help(format!("for instance: {key} = {example}"));
                problems.refuse(issue.against(against));
            } else if given && !needed {
                let issue = Issue::new(path, format!("`{key}` does not go with `{way}`"));
                problems.refuse(issue.help("remove it").against(against));
            }
        }
        if self.viscosity_index.is_some() && way != "iso_vg" {
            let message = format!("`viscosity_index` does not go with `{way}`");
            let issue = Issue::new(".oil.viscosity_index", message).help("remove it");
            problems.refuse(issue.against(format!(".oil.{way}")));
        }
        if let Some(grade) = self.iso_vg.filter(|_| way == "iso_vg") {
            let warning = self.extended_index(grade, problems);
            warning.into_iter().for_each(|text| problems.warn(text));
        }
        if let (Some(cold), Some(warm)) = (&self.viscosity_40, &self.viscosity_100)
            && warm.si() >= cold.si()
        {
            let message = "an oil is thinner at 100 °C than at 40 °C";
            let issue = Issue::new(".oil.viscosity_100", message);
            problems.refuse(issue.against(".oil.viscosity_40"));
        }
    }

    /// Law of an oil of an ISO VG class.
    fn law_of_grade(&self, grade: f64) -> ViscosityLaw {
        let index = self.viscosity_index.unwrap_or(ViscosityLaw::USUAL_INDEX);
        ViscosityLaw::from_grade(1e-6 * grade, index)
    }

    /// A class of so thin an oil that no viscosity index is defined.
    fn extended_index(&self, grade: f64, problems: &Problems<'_>) -> Option<String> {
        let at_100 = 1e6 * self.law_of_grade(grade).at(100.0);
        (at_100 < 2.0).then(|| {
            format!(
                "`{}` gives {at_100:.2} mm²/s at 100 °C, and ASTM D2270 defines the viscosity index from 2 mm²/s on: it is \
                 extended below; where both viscosities are known, give `viscosity_40` and `viscosity_100`",
                problems.path(".oil.iso_vg")
            )
        })
    }

    fn density(&self) -> f64 {
        si(&self.density).unwrap_or(MINERAL_OIL_DENSITY)
    }

    /// Kinematic viscosity at the temperature of the bearing, m²/s.
    fn kinematic(&self) -> f64 {
        let temperature = si(&self.temperature).unwrap_or(40.0);
        match (&self.viscosity, self.iso_vg) {
            (Some(viscosity), _) if viscosity.dimension == Dimension::KinematicViscosity => {
                viscosity.si()
            }
            (Some(viscosity), _) => viscosity.si() / self.density(),
            (None, Some(grade)) => self.law_of_grade(grade).at(temperature),
            (None, None) => {
                let points = si(&self.viscosity_40).zip(si(&self.viscosity_100));
                let (cold, warm) = points.unwrap_or((68e-6, 8.6e-6));
                ViscosityLaw::through([(40.0, cold), (100.0, warm)]).at(temperature)
            }
        }
    }

    /// The oil of the films.
    pub fn build(&self) -> Oil {
        let viscosity = self
            .viscosity
            .as_ref()
            .filter(|it| it.dimension == Dimension::Viscosity);
        let viscosity = viscosity.map(Quantity::si);
        let viscosity = viscosity.unwrap_or_else(|| self.kinematic() * self.density());
        Oil {
            viscosity,
            pressure_viscosity: si(&self.pressure_viscosity).unwrap_or_else(|| wooster(viscosity)),
        }
    }

    /// What the life and SKF's friction model know of it.
    pub fn lubrication(&self) -> Lubrication {
        Lubrication {
            viscosity: self.kinematic(),
            grease: self.grease,
            contamination: self.contamination,
            oil: self.build(),
        }
    }
}

/// Pressure–viscosity coefficient of a mineral oil by its dynamic viscosity in Pa s, 1/Pa:
/// `α = (0.6 + 0.965 log10 η) 1e-8`, η in mPa s, not below 1 mPa s.
///
/// Source: W. A. Wooster (1944), as Stachowiak & Batchelor, *Engineering Tribology*, quote it with η in cP.
fn wooster(viscosity: f64) -> f64 {
    1e-8 * (0.6 + 0.965 * (1e3 * viscosity).log10().max(0.0))
}
