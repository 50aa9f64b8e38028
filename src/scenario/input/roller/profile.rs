//! Profile of rollers: by its name, by drops, or by the radii of barrels.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::RollerInput;
use super::dimensions::Known;
use crate::bearing::{Profile, ProfilePoints, RollerKind};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Length, Quantity, si, significant};

/// Profile of a roller by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProfileInput {
    /// That of ISO/TS 16281 for the kind and the proportions of the rollers.
    Logarithmic,
    /// None.
    Flat,
}

/// How much a roller is thinner at a distance from its middle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DropInput {
    /// Distance from the middle, for instance "3.5 mm".
    #[schemars(extend("examples" = ["3.5 mm"], "x-minimum" = 0.0))]
    pub at: Quantity<Length>,
    /// Drop of roller and race together, for instance "4 um".
    #[schemars(extend("examples" = ["4 um"], "x-minimum" = 0.0))]
    pub drop: Quantity<Length>,
}

impl RollerInput {
    /// The profile, where radii, drops and a name do not contradict each other.
    pub(super) fn profile(&self, known: &Known, problems: &mut Problems<'_>) -> Option<Profile> {
        let (roller, race) = (si(&self.roller_radius), si(&self.race_radius));
        let spherical = known.kind == RollerKind::Spherical;
        let radii = [
            (".roller.roller_radius", roller),
            (".roller.race_radius", race),
        ];
        for (key, _) in radii
            .iter()
            .filter(|(_, radius)| radius.is_some() && !spherical)
        {
            let issue = Issue::new(
                *key,
                "only spherical rollers have a radius along their length",
            );
            problems.refuse(issue.help("remove it").against(".roller.kind"));
        }
        let named = self.profile.map(|profile| match profile {
            ProfileInput::Logarithmic => Profile::Logarithmic,
            ProfileInput::Flat => Profile::Flat,
        });
        let is_round = roller.is_some() || race.is_some();
        let ways = [named.is_some(), !self.drop.is_empty(), is_round];
        if ways.into_iter().filter(|given| *given).count() > 1 {
            let message = "the profile of the rollers is given in two ways";
            let issue = Issue::new(".roller", message);
            problems.refuse(issue.help("keep one of `profile`, `drop` and the two radii"));
            return None;
        }
        if !self.drop.is_empty() {
            let pairs: Vec<_> = self
                .drop
                .iter()
                .map(|own| [own.at.si(), own.drop.si()])
                .collect();
            if pairs[0][1] != 0.0 {
                let message = format!(
                    "the first point of a profile has a drop of {} um: what a roller is thinner all along is clearance",
                    significant(1e6 * pairs[0][1])
                );
                let issue = Issue::new(".roller.drop", message);
                problems.refuse(
                    issue.help("begin with drop = [{ at = \"0 mm\", drop = \"0 um\" }, …]"),
                );
                return None;
            }
            let message = format!(
                "the distances of a profile must rise, with at most {} points",
                ProfilePoints::MOST
            );
            let points = ProfilePoints::new(&pairs).map(Profile::Points);
            return problems.take(points.ok_or_else(|| Issue::new(".roller.drop", message)));
        }
        if named.is_some() || !spherical {
            return Some(named.unwrap_or(Profile::Logarithmic));
        }
        if let Some(estimate) = known.estimate.as_ref().filter(|_| !is_round) {
            return Some(estimate.profile(known.contact_angle));
        }
        let half = 0.5 * known.length;
        problems.take(match (roller, race) {
            (Some(roller_radius), Some(race_radius))
                if roller_radius > half && race_radius >= roller_radius =>
            {
                Ok(Profile::Barrel {
                    roller_radius,
                    race_radius,
                })
            }
            (Some(_), Some(_)) => {
                let message = "a spherical roller is a barrel in a wider race: half its length is less than its radius, and that \
                               no more than the radius of the race";
                Err(Issue::new(".roller.roller_radius", message)
                    .against_all([".roller.race_radius", ".roller.length"]))
            }
            _ => {
                let message = "spherical rollers need `roller_radius` and `race_radius`";
                let issue = Issue::new(".roller.roller_radius", message);
                Err(issue
                    .help("for instance roller_radius = \"33.2 mm\" and race_radius = \"34 mm\", or profile = \"flat\"")
                    .against(".roller.race_radius"))
            }
        })
    }
}
