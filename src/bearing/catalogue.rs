//! Bearings by their designation, each number with its source.

use super::{Bearing, BearingError, ClearanceClass, FreePosition, Geometry};
use crate::physics::Material;

/// Internal dimensions of a standard bearing, as printed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CatalogueEntry {
    /// Designation, for instance `7205C`.
    pub designation: &'static str,
    /// Number of balls.
    pub balls: usize,
    /// Ball diameter, mm.
    pub ball_diameter_mm: f64,
    /// Pitch diameter, mm.
    pub pitch_diameter_mm: f64,
    /// Free contact angle in degrees; deep-groove bearings have none.
    pub contact_angle_deg: Option<f64>,
    /// Groove factor of the inner race.
    pub groove_factor_inner: f64,
    /// Groove factor of the outer race.
    pub groove_factor_outer: f64,
    /// Bore, outside diameter and width, mm.
    pub boundary_mm: [f64; 3],
    /// Basic dynamic load rating, N.
    pub dynamic_rating: f64,
    /// Where the numbers come from.
    pub source: &'static str,
}

/// All bearings known by designation.
pub const CATALOGUE: &[CatalogueEntry] = &[
    CatalogueEntry {
        designation: "7205C",
        balls: 12,
        ball_diameter_mm: 7.938,
        pitch_diameter_mm: 38.5,
        contact_angle_deg: Some(15.0),
        groove_factor_inner: 0.52,
        groove_factor_outer: 0.53,
        boundary_mm: [25.0, 52.0, 15.0],
        dynamic_rating: 16_600.0,
        source: "balls of 5/16 in, 12 of them: with the formulas of ISO 281 they give the \
                 catalogues' C = 16.6 kN and C0 = 10.2 kN (13 balls would give 17.5 kN); pitch: mean of \
                 bore and outside diameter; 15°: suffix C; grooves: reference of ISO/TS 16281",
    },
    CatalogueEntry {
        designation: "6204",
        balls: 8,
        ball_diameter_mm: 7.938,
        pitch_diameter_mm: 33.5,
        contact_angle_deg: None,
        groove_factor_inner: 0.52,
        groove_factor_outer: 0.53,
        boundary_mm: [20.0, 47.0, 14.0],
        dynamic_rating: 13_500.0,
        source: "8 balls, ball-pass factor 3.05: Tiwari, Gupta & Prakash (2000), met by balls of \
                 5/16 in on the mean of bore and outside diameter; C: SKF, Rolling bearings; grooves: \
                 reference of ISO/TS 16281",
    },
    CatalogueEntry {
        designation: "6205",
        balls: 9,
        ball_diameter_mm: 7.940,
        pitch_diameter_mm: 39.04,
        contact_angle_deg: None,
        groove_factor_inner: 0.52,
        groove_factor_outer: 0.53,
        boundary_mm: [25.0, 52.0, 15.0],
        dynamic_rating: 14_800.0,
        source: "9 balls of 0.3126 in, pitch 1.537 in: 6205-2RS of the Case Western Reserve \
                 University bearing data; C: SKF, Rolling bearings; grooves: reference of ISO/TS 16281",
    },
    CatalogueEntry {
        designation: "6305",
        balls: 7,
        ball_diameter_mm: 11.5,
        pitch_diameter_mm: 43.5,
        contact_angle_deg: None,
        groove_factor_inner: 0.52,
        groove_factor_outer: 0.53,
        boundary_mm: [25.0, 62.0, 17.0],
        dynamic_rating: 23_400.0,
        source: "all of balls, pitch, grooves and C: the 6305 of the public repository \
                 minzhun/ISO16281, computed there with a commercial program",
    },
    CatalogueEntry {
        designation: "6306",
        balls: 8,
        ball_diameter_mm: 11.9062,
        pitch_diameter_mm: 52.0,
        contact_angle_deg: None,
        groove_factor_inner: 0.52,
        groove_factor_outer: 0.53,
        boundary_mm: [30.0, 72.0, 19.0],
        dynamic_rating: 29_600.0,
        source: "8 balls of 11.9062 mm, pitch 52.0 mm: JIS 6306 of Fukata et al. (1985) and Mevel & \
                 Guyader (1993); C: SKF, Rolling bearings; grooves: reference of ISO/TS 16281",
    },
];

/// The entry of a designation; letter case and blanks do not matter.
pub fn find(designation: &str) -> Option<&'static CatalogueEntry> {
    let wanted = designation.replace(' ', "").to_ascii_uppercase();
    CATALOGUE.iter().find(|entry| entry.designation == wanted)
}

/// A designation that is in no catalogue.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no bearing is called `{designation}`; known are {}", known.join(", "))]
pub struct UnknownBearing {
    /// The designation as given.
    pub designation: String,
    /// All designations.
    pub known: Vec<&'static str>,
}

impl Bearing {
    /// The bearing of a designation, in SI units, balls and rings of bearing steel; letter case and blanks do not
    /// matter.
    ///
    /// # Errors
    /// [`UnknownBearing`] names those that are known.
    pub fn catalogue(designation: &str) -> Result<Self, UnknownBearing> {
        let entry = find(designation).and_then(|entry| entry.bearing().ok());
        entry.ok_or_else(|| UnknownBearing {
            designation: designation.to_owned(),
            known: CATALOGUE.iter().map(|entry| entry.designation).collect(),
        })
    }
}

impl CatalogueEntry {
    /// Bore, m.
    pub fn bore(&self) -> f64 {
        self.boundary_mm[0] / 1e3
    }

    /// Where the races stand without load: by the contact angle, or by the middle of a class of clearance of a
    /// deep-groove bearing.
    pub(crate) fn free_position(&self, class: ClearanceClass) -> FreePosition {
        match self.contact_angle_deg {
            Some(degrees) => FreePosition::ContactAngle(degrees.to_radians()),
            // every shipped bore stands in the table
            None => FreePosition::DiametralClearance(class.middle(self.bore()).unwrap_or(0.0)),
        }
    }

    /// The bearing in SI units, balls and rings of bearing steel, a deep-groove bearing with the clearance of
    /// class CN.
    ///
    /// # Errors
    /// [`BearingError::Geometry`], which no shipped entry gives.
    pub(crate) fn bearing(&self) -> Result<Bearing, BearingError> {
        let geometry = Geometry::new(
            self.balls,
            self.ball_diameter_mm / 1e3,
            self.pitch_diameter_mm / 1e3,
            self.free_position(ClearanceClass::CN),
            self.groove_factor_inner,
            self.groove_factor_outer,
        )?;
        Ok(Bearing {
            geometry,
            ring_material: Material::BEARING_STEEL,
            ball_material: Material::BEARING_STEEL,
            contact_stiffness: None,
            dynamic_rating: Some(self.dynamic_rating),
            roughness: None,
            limiting_speed: None,
            shoulder_angle: None,
            clearance_class: self
                .contact_angle_deg
                .is_none()
                .then_some(ClearanceClass::CN),
        })
    }
}
