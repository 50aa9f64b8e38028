//! Why no internal geometry follows from a catalogue line.

use super::rating::GROOVES;
use super::{Candidate, RollerCandidate};
use crate::bearing::GeometryError;

/// Why no internal geometry follows from a catalogue line.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EstimateError {
    /// A number is no positive length or force.
    #[error("the {name} is {value} in SI units; it must be positive and finite")]
    Number {
        /// What it is called.
        name: &'static str,
        /// As given.
        value: f64,
    },
    /// Bore and outside diameter leave no room.
    #[error("a bore of {} mm does not fit into an outside diameter of {} mm", 1e3 * bore, 1e3 * outside_diameter)]
    Section {
        /// Bore, m.
        bore: f64,
        /// Outside diameter, m.
        outside_diameter: f64,
    },
    /// Balls are to be found without a static load rating.
    #[error("without balls, ball diameter and grooves a static load rating is needed to find them")]
    NoStaticRating,
    /// No balls have these ratings.
    #[error(
        "no balls of a bearing of this size have the ratings C0 = {statical} N and, 2 % below to 10 % above ISO 281, \
         C = {dynamic} N{}; check the line, or give `balls` and `ball_diameter`; a roller bearing needs `kind` and `width`",
        closest.map_or(String::new(), |closest| format!(": closest are {closest}"))
    )]
    Impossible {
        /// C as printed, N.
        dynamic: f64,
        /// C_0 as printed, N.
        statical: f64,
        /// The balls that come closest.
        closest: Option<Candidate>,
    },
    /// The balls that have these ratings have another f0.
    #[error(
        "the ratings fit {closest}, whose f0 would be {found:.2}, not {printed}; check the line, or leave out `f0`"
    )]
    Factor {
        /// The balls that come closest.
        closest: Candidate,
        /// C_0 as printed over their Z D² cos α, N/mm².
        found: f64,
        /// f0 as printed.
        printed: f64,
    },
    /// No rollers have these ratings.
    #[error(
        "no rollers of a bearing of this size have the ratings C0 = {statical} N and, 3 % below to 20 % above ISO 281, \
         C = {dynamic} N{}; check the line, or give `rollers`, `diameter` and `length` in [bearing.roller]",
        closest.map_or(String::new(), |closest| format!(": closest are {closest}"))
    )]
    Rollers {
        /// C as printed, N.
        dynamic: f64,
        /// C_0 as printed, N.
        statical: f64,
        /// The rollers that come closest.
        closest: Option<RollerCandidate>,
    },
    /// No groove gives the static rating.
    #[error(
        "C0 = {statical} N does not belong to {balls} balls of {:.3} mm: with groove factors of {} to {} they have \
         {least:.0} to {largest:.0} N; give `groove_factor_inner` and `groove_factor_outer`, or correct the line",
        1e3 * ball_diameter, GROOVES[0], GROOVES[1]
    )]
    Groove {
        /// C_0 as printed, N.
        statical: f64,
        /// Number of balls.
        balls: usize,
        /// Ball diameter, m.
        ball_diameter: f64,
        /// C_0 of the widest groove, N.
        least: f64,
        /// C_0 of the narrowest groove, N.
        largest: f64,
    },
    /// The dimensions are no bearing.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
}

impl EstimateError {
    /// The error, or else that what comes closest has no room on a pitch circle between a bore and an outside diameter, m.
    pub(super) fn for_want_of_room(self, pitch: f64, boundary: [f64; 2]) -> Self {
        let (element, diameter) = match &self {
            Self::Impossible {
                closest: Some(closest),
                ..
            }
            | Self::Factor { closest, .. } => ("ball", closest.ball_diameter),
            Self::Rollers {
                closest: Some(closest),
                ..
            } => ("roller", closest.diameter),
            _ => return self,
        };
        let room = GeometryError::check_section(element, [diameter, pitch], boundary);
        room.map_or_else(Self::Geometry, |()| self)
    }
}
