//! A stator that the shaft rubs once it has crossed its clearance.

use super::element::ElementMotion;
use super::force_law::ForceLaw;
use crate::bearing::{Matrix5, Vector5};

/// Speed of sliding about which friction changes its sign, m/s.
const CREEP: f64 = 1e-3;

/// A ring about the shaft, on springs alike in all directions:
///
/// ```text
/// N = k (r − δ) for r > δ, else 0        F = N n + μ s(v) N t
/// v = ω R + u̇·t,   s(v) = v/√(v² + v₀²),   v₀ = 1 mm/s
/// ```
///
/// with r = |u|, n = u/r, t a quarter turn ahead of n, and F the force of the shaft onto the ring. Friction resists the
/// rotation by the moment R μ s N.
///
/// Source: the usual model of a rub, e.g. A. Muszynska, *Rotordynamics* (2005), ch. 5; friction after Coulomb.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rub {
    /// Radial clearance δ, m.
    pub clearance: f64,
    /// Stiffness k of the ring, N/m.
    pub stiffness: f64,
    /// Coefficient of friction μ.
    pub friction: f64,
    /// Radius R of the shaft where it rubs, m.
    pub radius: f64,
}

/// A contact with the ring.
struct Contact {
    /// Direction towards the ring, and along it with the rotation.
    across: [f64; 2],
    along: [f64; 2],
    /// r, m.
    distance: f64,
    /// N, N.
    normal: f64,
    /// μ s, and μ ds/dv in s/m.
    friction: [f64; 2],
}

impl Rub {
    /// The contact in a motion; none where the clearance is open.
    fn contact(&self, motion: &ElementMotion) -> Option<Contact> {
        let [x, y, ..] = motion.displacement;
        let distance = x.hypot(y);
        let normal = self.stiffness * (distance - self.clearance);
        if normal <= 0.0 {
            return None;
        }
        let across = [x / distance, y / distance];
        let along = [-across[1], across[0]];
        let [v_x, v_y, ..] = motion.rate;
        let sliding = motion.rotation.speed * self.radius + v_x * along[0] + v_y * along[1];
        let smoothed = sliding.hypot(CREEP);
        let slope = (CREEP / smoothed).powi(2) / smoothed;
        Some(Contact {
            across,
            along,
            distance,
            normal,
            friction: [sliding / smoothed, slope].map(|part| self.friction * part),
        })
    }
}

impl ForceLaw for Rub {
    fn force(&self, motion: &ElementMotion) -> Vector5 {
        let Some(contact) = self.contact(motion) else {
            return [0.0; 5];
        };
        let [x, y] = [0, 1].map(|axis| {
            contact.normal * (contact.across[axis] + contact.friction[0] * contact.along[axis])
        });
        [x, y, 0.0, 0.0, 0.0]
    }

    fn slopes(&self, motion: &ElementMotion) -> [Matrix5; 2] {
        let mut slopes = [Matrix5::zeros(); 2];
        let Some(contact) = self.contact(motion) else {
            return slopes;
        };
        let (n, t, normal) = (contact.across, contact.along, contact.normal);
        let [friction, by_sliding] = contact.friction;
        let [v_x, v_y, ..] = motion.rate;
        // dn = t (t·du)/r, dt = −n (t·du)/r, dv = t·du̇ − (u̇·n)(t·du)/r
        let turning = 1.0 / contact.distance;
        let turned = -(v_x * n[0] + v_y * n[1]) * turning;
        for row in 0..2 {
            for column in 0..2 {
                let pressed = n[row] + friction * t[row];
                let carried = turning * (t[row] - friction * n[row]) + by_sliding * turned * t[row];
                slopes[0][(row, column)] =
                    self.stiffness * pressed * n[column] + normal * carried * t[column];
                slopes[1][(row, column)] = normal * by_sliding * t[row] * t[column];
            }
        }
        slopes
    }

    fn elastic(&self, displacement: &Vector5) -> (f64, Vector5) {
        let [x, y, ..] = *displacement;
        let distance = x.hypot(y);
        let approach = (distance - self.clearance).max(0.0);
        let normal = self.stiffness * approach;
        let share = if approach > 0.0 {
            normal / distance
        } else {
            0.0
        };
        (
            0.5 * normal * approach,
            [share * x, share * y, 0.0, 0.0, 0.0],
        )
    }

    fn resisting_moment(&self, motion: &ElementMotion) -> f64 {
        let contact = self.contact(motion);
        contact.map_or(0.0, |own| self.radius * own.friction[0] * own.normal)
    }

    fn clearance(&self) -> Option<f64> {
        Some(self.clearance)
    }

    fn past_event(&self, displacement: &Vector5) -> Option<f64> {
        Some(displacement[0].hypot(displacement[1]) - self.clearance)
    }

    fn force_past_event(&self, distance: f64) -> f64 {
        self.stiffness * distance.abs() * (1.0 + self.friction)
    }
}
