//! What a bearing is made of and how it sits on the shaft: plain data, before any computation.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::surface::{ImperfectionError, Imperfections};
use super::{
    Clearance, ClearanceClass, ContactDamping, ContactLaw, EstimateError, FitState, Geometry,
    GeometryError, Lubrication, Oil, RaceContacts,
};
use crate::physics::{
    HertzContact, HertzError, Material, Race, SkfFriction, contact_modulus, inner_race_curvature,
    outer_race_curvature,
};

/// Why a bearing cannot be built or mounted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BearingError {
    /// The dimensions do not make a bearing.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// No internal geometry follows from the catalogue line.
    #[error(transparent)]
    Estimate(#[from] Box<EstimateError>),
    /// Ball and race do not form a Hertz contact.
    #[error("the contact of ball and {race} race: {source}")]
    Contact {
        /// Which race.
        race: &'static str,
        /// What is wrong with it.
        source: HertzError,
    },
    /// A property of the oil is no positive number.
    #[error("the oil's {name} is {value} in SI units; it must be positive and finite")]
    Oil {
        /// Which property.
        name: &'static str,
        /// Value as given.
        value: f64,
    },
    /// The balls have no mass.
    #[error("the density of the balls is {density} kg/m³; it must be positive and finite")]
    Density {
        /// Density as given, kg/m³.
        density: f64,
    },
    /// A stiffness given for both races together cannot be told apart.
    #[error(
        "a contact stiffness of {stiffness} N/m^1.5 is given for both races together; ball inertia \
         loads them differently, so give the geometry's own contacts instead"
    )]
    SeriesStiffness {
        /// Stiffness constant K_n as given, N/m^1.5.
        stiffness: f64,
    },
    /// The inertia of balls under an outer ring that turns.
    #[error(
        "contact = \"jones\" knows the inertia of balls under a turning inner ring only: with rotating_ring = \"outer\" \
         set contact = \"hertz\""
    )]
    RotatingRing,
    /// A coefficient of the contact damping is no number that damps.
    #[error("the contact damping is {value} s/m; it must be zero or positive, finite")]
    ContactDamping {
        /// Coefficient as given, s/m.
        value: f64,
    },
    /// A defect, a wave or a ball does not fit the bearing.
    #[error(transparent)]
    Imperfection(#[from] ImperfectionError),
    /// A bearing's preload has no axial position that gives it.
    #[error(
        "no axial position of the inner ring gives a preload of {preload} N; give a smaller \
         preload or an axial_offset"
    )]
    Preload {
        /// Preload as given, N.
        preload: f64,
    },
}

/// A bearing by itself: dimensions, materials, contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Checked dimensions.
    pub geometry: Geometry,
    /// Material of both rings.
    pub ring_material: Material,
    /// Material of the balls.
    pub ball_material: Material,
    /// Load–deflection constant K_n of a ball between both races in N/m^1.5 where it is given
    /// directly, as literature models do; otherwise it follows from Hertz's theory.
    pub contact_stiffness: Option<f64>,
    /// Basic dynamic load rating C, N; the life needs it.
    pub dynamic_rating: Option<f64>,
    /// Composite root-mean-square roughness σ of ball and race, m; the film ratio λ needs it.
    pub roughness: Option<f64>,
    /// Highest permissible speed, rad/s, as catalogues print it, for cage and lubrication; where it is
    /// not given, `n d_m` = 10⁶ mm/min is taken.
    pub limiting_speed: Option<f64>,
    /// Angle at which the shoulders of the races end, from the radial plane, rad; where it is given,
    /// contacts that reach it are told.
    pub shoulder_angle: Option<f64>,
    /// The class whose middle the clearance of a deep-groove bearing is, where it was taken from there.
    pub clearance_class: Option<ClearanceClass>,
    /// Bore and outside diameter, m; fits and SKF's friction model need them.
    pub boundary: Option<[f64; 2]>,
    /// Whether balls, pitch diameter or grooves were estimated from the ratings of a catalogue.
    pub estimated: bool,
    /// Constants of SKF's friction model, where the series of the bearing is known.
    pub skf_friction: Option<SkfFriction>,
    /// Lubricant; the modified life and SKF's friction model need it.
    pub(crate) lubrication: Option<Lubrication>,
    /// The ring that turns; the other one stands, as the load does.
    pub rotating_ring: Race,
    /// Reliability of the modified life, per cent; 90 where it is not given.
    pub reliability: Option<f64>,
    /// What fits and temperatures have done to it.
    pub(crate) fit: Option<FitState>,
}

/// Speed factor `ω d_m`, m/s, above which manufacturers ask for bearings and lubrication of special
/// design, where they give no limiting speed: `n d_m` = 10⁶ mm/min, a rule of thumb.
const LIMITING_SPEED_FACTOR: f64 = 1e6 * 1e-3 * std::f64::consts::TAU / 60.0;

impl Bearing {
    /// A bearing of a geometry with balls and rings of bearing steel, of which nothing else is known.
    pub fn of_steel(geometry: Geometry) -> Self {
        Self {
            geometry,
            ring_material: Material::BEARING_STEEL,
            ball_material: Material::BEARING_STEEL,
            contact_stiffness: None,
            dynamic_rating: None,
            roughness: None,
            limiting_speed: None,
            shoulder_angle: None,
            clearance_class: None,
            boundary: None,
            estimated: false,
            skf_friction: None,
            lubrication: None,
            rotating_ring: Race::Inner,
            reliability: None,
            fit: None,
        }
    }

    /// Highest permissible speed, rad/s, given or by its pitch diameter.
    pub fn highest_permissible_speed(&self) -> f64 {
        self.limiting_speed
            .unwrap_or(LIMITING_SPEED_FACTOR / self.geometry.pitch_diameter())
    }

    /// Clearance of a deep-groove bearing; none of an angular contact bearing.
    pub fn clearance(&self) -> Option<Clearance> {
        let class = self.clearance_class;
        let diametral = self.geometry.diametral_clearance()?;
        Some(Clearance { diametral, class })
    }

    /// Hertz contact of ball and inner race, curvature at the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn inner_contact(&self) -> Result<HertzContact, BearingError> {
        self.contact("inner", self.geometry.gamma())
    }

    /// Hertz contact of ball and outer race, curvature at the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn outer_contact(&self) -> Result<HertzContact, BearingError> {
        self.contact("outer", self.geometry.gamma())
    }

    pub(super) fn contact(
        &self,
        race: &'static str,
        gamma: f64,
    ) -> Result<HertzContact, BearingError> {
        let (ball, [inner, outer]) = (
            self.geometry.ball_diameter(),
            self.geometry.groove_factors(),
        );
        let curvature = match race {
            "inner" => inner_race_curvature(ball, inner, gamma),
            _ => outer_race_curvature(ball, outer, gamma),
        };
        let modulus = contact_modulus(&self.ball_material, &self.ring_material);
        HertzContact::new(curvature, modulus)
            .map_err(|source| BearingError::Contact { race, source })
    }

    /// Load–deflection constant K_n of a ball between both races, N/m^1.5.
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 7205C, E = 207 GPa, ν = 0.3: K_n = 273 580.37 N/mm^1.5 (independent implementations).
    /// let bearing = Bearing::catalogue("7205C")?;
    /// assert!((bearing.load_deflection_constant()? / 10f64.powf(4.5) - 273_580.37).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn load_deflection_constant(&self) -> Result<f64, BearingError> {
        match self.contact_stiffness {
            Some(given) => Ok(given),
            None => Ok(self.contacts()?.in_series().stiffness),
        }
    }

    /// Contacts of ball and races at the free contact angle.
    pub(crate) fn contacts(&self) -> Result<RaceContacts, BearingError> {
        RaceContacts::new(self, self.geometry.gamma())
    }

    /// Contacts of ball and races at the nominal contact angle, which the ratings belong to, whatever the clearance.
    pub(super) fn rated_contacts(&self) -> Result<RaceContacts, BearingError> {
        RaceContacts::new(self, self.geometry.nominal_gamma())
    }
}

/// Which way along Z the inner ring must move to load the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum Facing {
    /// Moving the shaft along +Z loads the bearing.
    #[default]
    #[serde(rename = "+z")]
    PlusZ,
    /// Moving the shaft along −Z loads the bearing.
    #[serde(rename = "-z")]
    MinusZ,
}

impl Facing {
    /// s = +1 or −1 of the mirror rule z, θx, θy → s·.
    pub fn sign(self) -> f64 {
        match self {
            Self::PlusZ => 1.0,
            Self::MinusZ => -1.0,
        }
    }
}

/// Axial preset of a mounted bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Preload {
    /// Inner ring displaced by this much in m the way its facing loads it: z_local = s z + offset.
    AxialOffset(f64),
    /// The offset at which the bearing alone, standing, carries this axial force in N.
    Force(f64),
    /// The outer ring floats axially and a soft spring presses it with this force in N, the way that
    /// loads the bearing, wherever the shaft is.
    Spring(f64),
}

/// What the outer ring of a bearing sits in: a mass on springs and dampers to the ground, which does not tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Housing {
    /// Mass, kg.
    pub mass: f64,
    /// Stiffness to the ground along x, y and z, N/m.
    pub stiffness: [f64; 3],
    /// Damping to the ground along x, y and z, N s/m.
    pub damping: [f64; 3],
}

/// A bearing and its place on the shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct MountedBearing {
    /// The bearing.
    pub bearing: Bearing,
    /// Force law that stands for it.
    pub law: ContactLaw,
    /// Oil whose films part the surfaces; `None` leaves films out.
    pub oil: Option<Oil>,
    /// Position along the shaft from the centre of mass, m.
    pub position: f64,
    /// Orientation.
    pub facing: Facing,
    /// Axial preset.
    pub preload: Preload,
    /// Damping of the contacts.
    pub contact_damping: ContactDamping,
    /// Azimuth of ball 0 at the start, from +X towards +Y, rad.
    pub first_ball: f64,
    /// What makes its surfaces differ from perfect ones.
    pub imperfections: Imperfections,
    /// The housing that it stands in; none on the ground.
    pub housing: Option<Housing>,
}

impl MountedBearing {
    /// The bearing at the centre of mass, loaded along +Z: dry Hertz contacts without damping, no preload, ball 0 on +X.
    pub fn new(bearing: Bearing) -> Self {
        Self {
            bearing,
            law: ContactLaw::Hertz,
            oil: None,
            position: 0.0,
            facing: Facing::PlusZ,
            preload: Preload::AxialOffset(0.0),
            contact_damping: ContactDamping::default(),
            first_ball: 0.0,
            imperfections: Imperfections::default(),
            housing: None,
        }
    }
}
