//! What rollers have in place of grooves: kind, length, profile, and the slices that they are cut into.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Geometry, GeometryError};
use crate::physics::roller_dynamic_rating;

/// Kind of a radial roller bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RollerKind {
    /// Cylindrical rollers, whose rings move freely along the axis.
    Cylindrical,
    /// Cylindrical rollers that are long and thin.
    Needle,
    /// Conical rollers, which bear axially one way.
    Tapered,
    /// Two rows of barrels in an outer race that is a sphere about the middle of the bearing: tilts meet no resistance.
    Spherical,
}

impl RollerKind {
    /// The name of its key.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylindrical => "cylindrical",
            Self::Needle => "needle",
            Self::Tapered => "tapered",
            Self::Spherical => "spherical",
        }
    }

    /// `n d_m` that cage and lubrication bear, mm/min, where the maker gives no limiting speed: a rule of thumb, about what
    /// general catalogues print for oil (NU 206 some 14 000 rpm, 30206 9000 to 12 000 rpm, 22212 6300 rpm).
    pub(super) fn speed_factor(self) -> f64 {
        match self {
            Self::Cylindrical => 7e5,
            Self::Needle | Self::Tapered | Self::Spherical => 5e5,
        }
    }

    /// Rows of rollers.
    pub fn rows(self) -> usize {
        match self {
            Self::Spherical => 2,
            _ => 1,
        }
    }

    /// Whether rollers of this kind lie at a contact angle in rad.
    ///
    /// # Errors
    /// [`GeometryError::RollerAngle`] says what it must be.
    pub(super) fn check_angle(self, contact_angle: f64) -> Result<(), GeometryError> {
        let rule = match self {
            Self::Cylindrical | Self::Needle if contact_angle != 0.0 => "it must be zero",
            Self::Tapered | Self::Spherical if contact_angle == 0.0 => "it must be above zero",
            _ => return Ok(()),
        };
        Err(GeometryError::RollerAngle {
            kind: self.name(),
            degrees: contact_angle.to_degrees(),
            rule,
        })
    }

    /// Rating factor b_m of ISO 281.
    pub(crate) fn material_factor(self) -> f64 {
        match self {
            Self::Spherical => 1.15,
            _ => 1.1,
        }
    }
}

/// How much thinner a roller is away from its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Profile {
    /// Straight.
    Flat,
    /// The profile of ISO/TS 16281 for the kind and the proportions of the roller.
    Logarithmic,
    /// A barrel of a radius in m along its length in races of another one.
    Barrel {
        /// Of the roller.
        roller_radius: f64,
        /// Of both races.
        race_radius: f64,
    },
    /// Drops at distances from the middle.
    Points(ProfilePoints),
}

/// Distances from the middle of a roller, rising, and its drops there, m; straight lines in between, and level beyond.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoints {
    points: [[f64; 2]; Self::MOST],
    count: usize,
}

impl ProfilePoints {
    /// Most points of a profile.
    pub const MOST: usize = 8;

    /// From pairs of a distance and a drop; none where they are too many or none, do not rise, or are negative.
    pub fn new(pairs: &[[f64; 2]]) -> Option<Self> {
        let rise = pairs.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        let valid = |value: &f64| *value >= 0.0 && value.is_finite();
        let fits = (1..=Self::MOST).contains(&pairs.len());
        if !(fits && rise && pairs.as_flattened().iter().all(valid)) {
            return None;
        }
        let mut points = [[0.0; 2]; Self::MOST];
        points[..pairs.len()].copy_from_slice(pairs);
        let count = pairs.len();
        Some(Self { points, count })
    }

    fn drop_at(&self, distance: f64) -> f64 {
        let points = &self.points[..self.count];
        let next = points.partition_point(|point| point[0] < distance);
        let last = points[next.saturating_sub(1)];
        let next = points.get(next).copied().unwrap_or(last);
        let step = next[0] - last[0];
        match step > 0.0 {
            true => last[1] + (next[1] - last[1]) * (distance - last[0]) / step,
            false => last[1],
        }
    }
}

/// Rollers of a bearing, besides their number, diameter, pitch circle and contact angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rollers {
    /// Kind of the bearing.
    pub kind: RollerKind,
    /// Effective length L, m.
    pub length: f64,
    /// Profile of roller and races together.
    pub profile: Profile,
    /// Number of slices.
    pub laminae: usize,
    /// Diametral clearance G_r, m.
    pub clearance: f64,
}

/// A slice of a roller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slice {
    /// Middle s from the middle of the roller, m.
    pub position: f64,
    /// Drop P of a single contact there, m.
    pub drop: f64,
}

impl Rollers {
    /// Fewest slices.
    pub const FEWEST_LAMINAE: usize = 4;
    /// Fewest slices of the standard.
    pub const STANDARD_LAMINAE: usize = 30;
    /// Most slices.
    pub const MOST_LAMINAE: usize = 500;
    /// Length over diameter above which a roller is straight in its middle.
    const SLENDER: f64 = 2.5;

    /// Rows of rollers.
    pub fn rows(&self) -> usize {
        self.kind.rows()
    }

    /// Whether the radii of a barrel are those of a roller in wider races.
    ///
    /// # Errors
    /// [`GeometryError::Barrel`] with the radii and the length.
    pub(super) fn check_barrel(&self) -> Result<(), GeometryError> {
        match self.profile {
            Profile::Barrel {
                roller_radius,
                race_radius,
            } if !(roller_radius > 0.5 * self.length && race_radius >= roller_radius) => {
                Err(GeometryError::Barrel {
                    roller_radius,
                    race_radius,
                    length: self.length,
                })
            }
            _ => Ok(()),
        }
    }

    /// C of ISO 281 of a bearing with these rollers, N.
    pub(super) fn dynamic_rating(&self, geometry: &Geometry) -> f64 {
        roller_dynamic_rating(
            self.kind.material_factor(),
            [self.rows(), geometry.balls()],
            geometry.ball_diameter(),
            self.length,
            geometry.pitch_diameter(),
            geometry.nominal_angle(),
        )
    }

    /// The slices of a roller of a diameter in m, of equal width: `s_k = L ((k − 1/2)/n − 1/2)`.
    pub fn slices(&self, diameter: f64) -> impl Iterator<Item = Slice> + '_ {
        (0..self.laminae).map(move |index| {
            let steps = (2 * index + 1) as f64 - self.laminae as f64;
            let position = 0.5 * self.length * steps / self.laminae as f64;
            Slice {
                position,
                drop: self.drop_at(position.abs(), diameter),
            }
        })
    }

    /// Drop in m at a distance s in m from the middle of a roller of a diameter in m.
    ///
    /// ```text
    /// logarithmic   P = 0.00035 D ln 1/(1 − (2s/L)²)     tapered 0.00045
    ///               L > 2.5 D: 0 up to s = (L − 2.5 D)/2, then 0.0005 D ln 1/(1 − ((2s − L + 2.5 D)/(2.5 D))²)
    /// barrel        P = s²/2 (1/R_roller − 1/R_race)
    /// ```
    ///
    /// Source: ISO/TS 16281:2008, 4.2.3.
    fn drop_at(&self, distance: f64, diameter: f64) -> f64 {
        let crowned = Self::SLENDER * diameter;
        match self.profile {
            Profile::Flat => 0.0,
            Profile::Points(points) => points.drop_at(distance),
            Profile::Barrel {
                roller_radius,
                race_radius,
            } => 0.5 * distance * distance * (1.0 / roller_radius - 1.0 / race_radius),
            Profile::Logarithmic if self.kind == RollerKind::Tapered => {
                logarithmic(0.00045 * diameter, 2.0 * distance / self.length)
            }
            Profile::Logarithmic if self.length > crowned => {
                let past = (2.0 * distance - self.length + crowned).max(0.0);
                logarithmic(0.0005 * diameter, past / crowned)
            }
            Profile::Logarithmic => logarithmic(0.00035 * diameter, 2.0 * distance / self.length),
        }
    }
}

/// `scale ln 1/(1 − part²)`
fn logarithmic(scale: f64, part: f64) -> f64 {
    -scale * (-part * part).ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Drop in µm at a distance in mm from the middle of a roller of 10 mm and a length in mm.
    fn drop(kind: RollerKind, profile: Profile, length: f64, distance: f64) -> f64 {
        let rollers = Rollers {
            kind,
            length: 1e-3 * length,
            profile,
            laminae: Rollers::FEWEST_LAMINAE,
            clearance: 0.0,
        };
        1e6 * rollers.drop_at(1e-3 * distance, 10e-3)
    }

    #[test]
    fn profiles_drop_by_hand_at_places_of_their_own() {
        let (kind, profile) = (RollerKind::Cylindrical, Profile::Logarithmic);
        // where the logarithm is 1: (2s/L)² = 1 − 1/e, 0.79506 of the half length
        let part = (1.0 - (-1.0_f64).exp()).sqrt();
        assert!((drop(kind, profile, 20.0, 10.0 * part) - 3.5).abs() < 1e-9);
        assert!((drop(RollerKind::Tapered, profile, 20.0, 10.0 * part) - 4.5).abs() < 1e-9);
        // 40 mm: flat to 7.5 mm, and its ends are those of 25 mm
        assert_eq!(drop(kind, profile, 40.0, 7.5), 0.0);
        assert!((drop(kind, profile, 40.0, 7.5 + 12.5 * part) - 5.0).abs() < 1e-9);
        // a barrel: the distance of two arcs, R − √(R² − s²)
        let [roller_radius, race_radius] = [33.2e-3, 34e-3];
        let barrel = Profile::Barrel {
            roller_radius,
            race_radius,
        };
        let arc = |radius: f64| 1e6 * (radius - (radius * radius - 1e-6).sqrt());
        let arcs = arc(roller_radius) - arc(race_radius);
        let found = drop(RollerKind::Spherical, barrel, 13.0, 1.0);
        assert!((found / arcs - 1.0).abs() < 1e-3, "{found} {arcs}");
    }
}
