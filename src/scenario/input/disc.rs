//! Discs on a shaft that bends.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::flexible::{STEEL, check_bore, check_position};
use super::material::{MaterialInput, material};
use crate::rotor::{Disc, FlexibleShaft};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Inertia, Length, Mass, Quantity, si};

/// A rigid disc on a shaft with sections, given by its inertia or by its size.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["mass", "outer_diameter"]))]
pub struct DiscInput {
    /// Position of its centre, from the left end of the shaft.
    #[schemars(extend("examples" = ["300 mm"]))]
    pub position: Quantity<Length>,
    /// Mass, for instance "12 kg".
    #[schemars(extend("examples" = ["12 kg"], "x-above" = 0.0))]
    pub mass: Option<Quantity<Mass>>,
    /// Moment of inertia about a diameter. Default: "0 kg m^2", a point mass.
    #[schemars(extend("examples" = ["0.03 kg m^2"], "x-minimum" = 0.0))]
    pub inertia_transverse: Option<Quantity<Inertia>>,
    /// Moment of inertia about the axis of the shaft, at most twice the transverse one. Default: "0 kg m^2".
    #[schemars(extend("examples" = ["0.05 kg m^2"], "x-minimum" = 0.0))]
    pub inertia_polar: Option<Quantity<Inertia>>,
    /// Outer diameter instead of mass and inertia; `width` is needed with it.
    #[schemars(extend("examples" = ["280 mm"], "x-above" = 0.0))]
    pub outer_diameter: Option<Quantity<Length>>,
    /// Diameter of its bore. Default: the outer diameter of the shaft there.
    #[schemars(extend("examples" = ["50 mm"], "x-minimum" = 0.0))]
    pub inner_diameter: Option<Quantity<Length>>,
    /// Width along the shaft.
    #[schemars(extend("examples" = ["70 mm"], "x-above" = 0.0))]
    pub width: Option<Quantity<Length>>,
    /// Length of the shaft about its centre that its hub keeps from bending: bearings, loads and unbalances within it move with
    /// it. Default: "0 m", a thin disc.
    #[schemars(extend("examples" = ["60 mm"], "x-minimum" = 0.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hub_width: Option<Quantity<Length>>,
    /// Its material, of which the density counts. Default: steel of 7850 kg/m³.
    pub material: Option<MaterialInput>,
}

/// Refuses hubs that overlap.
pub fn check_hubs(discs: &[Disc], problems: &mut Problems<'_>) {
    for (index, disc) in discs.iter().enumerate() {
        let [left, right] = disc.hub_ends();
        let overlaps = |own: &Disc| {
            let [begin, end] = own.hub_ends();
            own.hub_width > 0.0 && begin < right && left < end
        };
        let other = discs[..index].iter().position(overlaps);
        if let Some(other) = other.filter(|_| disc.hub_width > 0.0) {
            let message = "the hub overlaps that of another disc";
            let issue = Issue::new(format!("disc[{}].hub_width", index + 1), message)
                .help("give one of both the width of the two, and the other none");
            problems.refuse(issue.against(format!("disc[{}].hub_width", other + 1)));
        }
    }
}

impl DiscInput {
    pub(super) fn with_hub(
        &self,
        shaft: &FlexibleShaft,
        problems: &mut Problems<'_>,
    ) -> Option<Disc> {
        let disc = self.build(shaft, problems)?;
        let hub_width = si(&self.hub_width).unwrap_or(0.0);
        let disc = Disc { hub_width, ..disc };
        if hub_width > 0.0 {
            for end in disc.hub_ends() {
                check_position(shaft, ".hub_width", end, problems);
            }
        }
        Some(disc)
    }

    fn build(&self, shaft: &FlexibleShaft, problems: &mut Problems<'_>) -> Option<Disc> {
        let position = self.position.si();
        check_position(shaft, ".position", position, problems);
        if let Some(mass) = &self.mass {
            let transverse = si(&self.inertia_transverse).unwrap_or(0.0);
            let polar = si(&self.inertia_polar).unwrap_or(0.0);
            if polar > 2.0 * transverse * (1.0 + 1e-9) {
                let message = "no body has an `inertia_polar` above twice its `inertia_transverse`";
                let issue = Issue::new(".inertia_polar", message);
                problems.refuse(issue.against(".inertia_transverse"));
                return None;
            }
            return Some(Disc {
                position,
                mass: mass.si(),
                inertia_transverse: transverse,
                inertia_polar: polar,
                hub_width: 0.0,
            });
        }
        let outer = si(&self.outer_diameter)?;
        let Some(width) = si(&self.width) else {
            let message = "a disc of a given `outer_diameter` needs a `width`";
            let issue = Issue::new(".width", message)
                .help("for instance: width = \"70 mm\"; or give mass and moments of inertia");
            problems.refuse(issue.against(".outer_diameter"));
            return None;
        };
        let inner = si(&self.inner_diameter).unwrap_or_else(|| shaft.outer_diameter_at(position));
        check_bore(inner, outer, "disc", problems)?;
        let density = material(self.material.as_ref(), STEEL).density;
        Some(Disc::of_size(position, width, [outer, inner], density))
    }
}
