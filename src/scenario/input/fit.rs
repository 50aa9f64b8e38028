//! `[bearing.fit]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::material::{MaterialInput, material};
use crate::bearing::{Bearing, Fit, GeometryError};
use crate::physics::{Material, STEEL_EXPANSION};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Length, Quantity, Temperature, ThermalExpansion, si};

/// How the rings sit on shaft and in housing, and how warm everything is: what is left of clearance, contact angle and
/// preload in operation. The bearing itself, its preload too, is given as it is before it is mounted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FitInput {
    /// Interference of shaft and inner ring on the diameter, for instance "10 um"; negative is loose. Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["10 um"], "x-minimum" = -1e-3, "x-maximum" = 1e-3))]
    pub inner_interference: Quantity<Length>,
    /// Interference of outer ring and housing on the diameter. Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["5 um"], "x-minimum" = -1e-3, "x-maximum" = 1e-3))]
    pub outer_interference: Quantity<Length>,
    /// Bore of a hollow shaft, for instance "12.5 mm". Default: a solid one.
    #[schemars(extend("examples" = ["12.5 mm"], "x-minimum" = 0.0))]
    pub shaft_bore: Option<Quantity<Length>>,
    /// Outside diameter of the housing, for instance "80 mm". Default: a thick one.
    #[schemars(extend("examples" = ["80 mm"], "x-above" = 0.0))]
    pub housing_diameter: Option<Quantity<Length>>,
    /// Material of the shaft. Default: steel.
    pub shaft_material: Option<MaterialInput>,
    /// Material of the housing. Default: steel.
    pub housing_material: Option<MaterialInput>,
    /// Thermal expansion of the shaft. Default: "12.5e-6 1/K", steel.
    #[schemars(extend("x-minimum" = 0.0))]
    pub shaft_expansion: Option<Quantity<ThermalExpansion>>,
    /// Thermal expansion of the housing, for instance "23.8e-6 1/K" (aluminium). Default: "12.5e-6 1/K", steel.
    #[schemars(extend("examples" = ["23.8e-6 1/K"], "x-minimum" = 0.0))]
    pub housing_expansion: Option<Quantity<ThermalExpansion>>,
    /// Thermal expansion of the balls, for instance "3.2e-6 1/K" (silicon nitride). Default: "12.5e-6 1/K", steel.
    #[schemars(extend("examples" = ["3.2e-6 1/K"], "x-minimum" = 0.0))]
    pub ball_expansion: Option<Quantity<ThermalExpansion>>,
    /// Temperature at which everything has the sizes given. Default: "20 degC".
    #[schemars(extend("examples" = ["20 degC"], "x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub reference_temperature: Option<Quantity<Temperature>>,
    /// Temperature of the inner ring. Default: that of the shaft, or else the reference.
    #[schemars(extend("x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub inner_temperature: Option<Quantity<Temperature>>,
    /// Temperature of the outer ring. Default: that of the housing, or else the reference.
    #[schemars(extend("x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub outer_temperature: Option<Quantity<Temperature>>,
    /// Temperature of the balls. Default: the mean of both rings.
    #[schemars(extend("x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub ball_temperature: Option<Quantity<Temperature>>,
    /// Temperature of the shaft. Default: that of the inner ring.
    #[schemars(extend("x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub shaft_temperature: Option<Quantity<Temperature>>,
    /// Temperature of the housing. Default: that of the outer ring.
    #[schemars(extend("x-minimum" = -273.0, "x-maximum" = 1000.0))]
    pub housing_temperature: Option<Quantity<Temperature>>,
    /// Bore of the bearing, where neither `catalogue` nor [bearing.ratings] gives it.
    #[schemars(extend("examples" = ["25 mm"], "x-above" = 0.0))]
    pub bore: Option<Quantity<Length>>,
    /// Outside diameter of the bearing, where neither `catalogue` nor [bearing.ratings] gives it.
    #[schemars(extend("examples" = ["52 mm"], "x-above" = 0.0))]
    pub outside_diameter: Option<Quantity<Length>>,
}

impl FitInput {
    /// The fit with bore and outside diameter of the bearing, m.
    pub fn build(&self, bearing: &Bearing, problems: &mut Problems<'_>) -> Option<(Fit, [f64; 2])> {
        let boundary = self.boundary(bearing, problems)?;
        let [bore, outside] = boundary;
        let shaft_bore = si(&self.shaft_bore).unwrap_or(0.0);
        let housing_outside = si(&self.housing_diameter).unwrap_or(f64::INFINITY);
        let section = bearing.geometry.check_section(boundary);
        problems.take(section.map_err(|error| no_section(&error, bearing, bore)))?;
        let orders = [
            (
                "shaft_bore",
                shaft_bore < bore,
                "the bore of the shaft must be smaller than that of the bearing",
            ),
            (
                "housing_diameter",
                outside < housing_outside,
                "the housing must be larger than the outside diameter of the bearing",
            ),
        ];
        let wrong = orders.into_iter().find(|(_, right, _)| !right);
        if let Some((key, _, message)) = wrong {
            problems.refuse(Issue::new(format!(".fit.{key}"), message));
            return None;
        }
        let reference = si(&self.reference_temperature).unwrap_or(20.0);
        let [inner, outer, balls, shaft, housing] = [
            &self.inner_temperature,
            &self.outer_temperature,
            &self.ball_temperature,
            &self.shaft_temperature,
            &self.housing_temperature,
        ]
        .map(|temperature| si(temperature).map(|celsius| celsius - reference));
        let inner_ring = inner.or(shaft).unwrap_or(0.0);
        let outer_ring = outer.or(housing).unwrap_or(0.0);
        let balls = balls.unwrap_or(0.5 * (inner_ring + outer_ring));
        if bearing.is_hybrid() && self.ball_expansion.is_none() && balls != 0.0 {
            problems.warn(expanding_as_steel(bearing, balls, problems));
        }
        let mate =
            |input: &Option<MaterialInput>| material(input.as_ref(), Material::BEARING_STEEL);
        let mates = [mate(&self.shaft_material), mate(&self.housing_material)];
        let around = [shaft.unwrap_or(inner_ring), housing.unwrap_or(outer_ring)];
        let expansions = [&self.shaft_expansion, &self.housing_expansion];
        for (place, name) in ["shaft", "housing"].into_iter().enumerate() {
            let is_steel = is_of_steel(&mates[place]) || around[place] == 0.0;
            if expansions[place].is_none() && !is_steel {
                let modulus = mates[place].youngs_modulus;
                let seat = [modulus, boundary[place], around[place]];
                problems.warn(mate_expanding_as_steel(name, seat, problems));
            }
        }
        let fit = Fit {
            interference: [self.inner_interference.si(), self.outer_interference.si()],
            shaft_bore,
            housing_outside,
            mates,
            expansions: expansions.map(|expansion| si(expansion).unwrap_or(STEEL_EXPANSION)),
            ball_expansion: si(&self.ball_expansion).unwrap_or(STEEL_EXPANSION),
            rings: [inner_ring, balls, outer_ring],
            around,
        };
        Some((fit, boundary))
    }

    /// Bore and outside diameter of the bearing, m.
    fn boundary(&self, bearing: &Bearing, problems: &mut Problems<'_>) -> Option<[f64; 2]> {
        let known = bearing.boundary.map_or([None; 2], |known| known.map(Some));
        let given = [
            ("bore", &self.bore, known[0]),
            ("outside_diameter", &self.outside_diameter, known[1]),
        ];
        let [bore, outside] = given.map(|(key, given, known)| {
            let value = si(given).or(known).ok_or_else(|| {
                let message = format!("`{}` needs `{key}`", problems.path(".fit"));
                Issue::new(format!(".fit.{key}"), message)
                    .help("it is known of bearings that `catalogue` or [bearing.ratings] describes")
            });
            problems.take(value)
        });
        Some([bore?, outside?])
    }
}

/// The problem of balls or rollers that reach beyond the bore or the outside diameter of their bearing.
fn no_section(error: &GeometryError, bearing: &Bearing, bore: f64) -> Issue {
    let geometry = &bearing.geometry;
    let key = match bore < geometry.pitch_diameter() - geometry.ball_diameter() {
        true => ".fit.outside_diameter",
        false => ".fit.bore",
    };
    Issue::new(key, error.to_string())
}

/// What a hybrid bearing loses that is so many K over the reference, where the expansion of its balls is not given.
fn expanding_as_steel(bearing: &Bearing, balls: f64, problems: &Problems<'_>) -> String {
    let name = bearing.geometry.element();
    format!(
        "`{}` is not given, and the {name}s, lighter than steel (hybrid), are taken to expand as steel: at {balls:.0} K over the \
         reference temperature {name}s of silicon nitride, \"3.2e-6 1/K\", would change the clearance by {:.2} um more",
        problems.path(".fit.ball_expansion"),
        1e6 * 2.0 * bearing.geometry.ball_diameter() * balls * (STEEL_EXPANSION - SILICON_NITRIDE),
    )
}

/// Largest relative difference of the Young's modulus of steels from that of bearing steel.
const STEELS: f64 = 0.1;

fn is_of_steel(material: &Material) -> bool {
    (material.youngs_modulus / Material::BEARING_STEEL.youngs_modulus - 1.0).abs() <= STEELS
}

/// What the expansion of a shaft or a housing of another material than steel changes, where it is not given, by its modulus
/// in Pa, the diameter of its seat in m and the K that it is over the reference.
fn mate_expanding_as_steel(
    name: &str,
    [modulus, seat, temperature]: [f64; 3],
    problems: &Problems<'_>,
) -> String {
    format!(
        "`{}` is not given, and the {name}, of {:.0} GPa no steel, is taken to expand as steel, \"12.5e-6 1/K\": at \
         {temperature:.0} K over the reference temperature each 1e-6 1/K more changes its seat by {:.2} um",
        problems.path(&format!(".fit.{name}_expansion")),
        modulus / 1e9,
        seat * temperature,
    )
}

/// Thermal expansion of silicon nitride at room temperature, 1/K, as makers of ceramic balls print it.
const SILICON_NITRIDE: f64 = 3.2e-6;
