//! The line contacts of rollers with both races.

use super::Lamina;
use crate::bearing::Bearing;
use crate::bearing::rollers::Rollers;
use crate::physics::{ContactEllipse, LINE_EXPONENT, LineContact, contact_modulus, line_stiffness};

/// Elastic contacts of a roller with both races, inner first: each slice a strip after Hertz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContacts {
    contacts: [LineContact; 2],
    /// The rollers themselves.
    pub(super) rollers: Rollers,
    /// C of both races in series, N/m^(10/9).
    pub(super) stiffness: f64,
}

impl LineContacts {
    /// Largest contact pressure that leaves no dent, Pa: ISO 76 for roller bearings.
    pub const PERMISSIBLE_PRESSURE: f64 = 4e9;

    /// The contacts of a bearing with the curvatures of γ = D cos α/d_m.
    pub(super) fn new(bearing: &Bearing, rollers: &Rollers, gamma: f64) -> Self {
        let modulus = contact_modulus(&bearing.ball_material, &bearing.ring_material);
        let diameter = bearing.geometry.ball_diameter();
        // Σρ = 2/(D (1 ∓ γ))
        let contact = |gamma: f64| LineContact {
            curvature: 2.0 / (diameter * (1.0 + gamma)),
            modulus,
        };
        Self {
            contacts: [contact(-gamma), contact(gamma)],
            rollers: *rollers,
            stiffness: line_stiffness(rollers.length, modulus),
        }
    }

    /// Effective length of a roller, m.
    pub(in crate::bearing) fn length(&self) -> f64 {
        self.rollers.length
    }

    /// Stiffness of both contacts in series at an approach in m, N/m.
    pub fn stiffness_at(&self, approach: f64) -> f64 {
        // dQ/dδ = 10/9 C δ^(1/9)
        LINE_EXPONENT * self.stiffness * approach.powf(LINE_EXPONENT - 1.0)
    }

    /// Load, N, of a straight roller whose approach to both races together is given in m.
    pub fn load_at(&self, approach: f64) -> f64 {
        self.stiffness * approach.max(0.0).powf(LINE_EXPONENT)
    }

    /// The strip on a race under a load in N that is alike along the roller.
    pub fn ellipse(&self, race: usize, load: f64) -> ContactEllipse {
        let along = load / self.rollers.length;
        ContactEllipse {
            semi_major: 0.5 * self.rollers.length,
            semi_minor: self.contacts[race].half_width(along),
            peak_pressure: self.contacts[race].peak_pressure(along),
            // each race has half of the approach
            approach: 0.5 * (load / self.stiffness).powf(1.0 / LINE_EXPONENT),
        }
    }

    /// Half-width in m and largest pressure in Pa of a lamina on a race.
    pub(in crate::bearing) fn strip(&self, race: usize, lamina: &Lamina) -> [f64; 2] {
        let (contact, along) = (&self.contacts[race], lamina.load / lamina.width);
        [contact.half_width(along), contact.peak_pressure(along)]
    }

    /// Stiffness of the contact with a race under a load in N, N/m: twice that of both in series.
    pub fn stiffness_under(&self, _race: usize, load: f64) -> f64 {
        let approach = (load / self.stiffness).powf(1.0 / LINE_EXPONENT);
        2.0 * self.stiffness_at(approach)
    }

    /// Loads at both races, alike along the roller, that leave no dent, N.
    pub fn permissible_loads(&self) -> [f64; 2] {
        let load = |contact: LineContact| contact.load_under(Self::PERMISSIBLE_PRESSURE);
        self.contacts
            .map(|contact| self.rollers.length * load(contact))
    }
}
