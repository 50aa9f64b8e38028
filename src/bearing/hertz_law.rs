//! Ball law of two Hertz contacts in series, ball inertia neglected.

use fearless_simd::{Simd, SimdBase, SimdFloat};

use super::{BallContact, BallForce, BallLaw, BallTangent, LaneForces, Lanes, LoadSlope};

/// Hertz contact of a ball with both races, the ball itself without inertia.
///
/// ```text
/// d = √(A1² + A2²)   δ = d − A   Q = K_n max(δ, 0)^(3/2)   F_a = Q A1/d   F_r = Q A2/d
/// ```
///
/// `A1`, `A2` place of the inner groove centre from the outer one in m, `A` their unloaded
/// distance in m, `K_n` in N/m^1.5. Holds at speeds where centrifugal force is small against the
/// ball load. A separated ball (δ ≤ 0) carries nothing.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.5 and 7.20–7.24.
///
/// ```
/// use jeffcott::bearing::{BallLaw, HertzLaw};
/// // 7205C under 1000 N of thrust (independent implementations): α = 19.35927°, δz = 31.97643 µm,
/// // so each of the 12 balls carries Q = 1000/(12 sin α) = 251.39 N.
/// let (distance, angle) = (0.396_9e-3, 15f64.to_radians());
/// let law = HertzLaw { load_deflection_constant: 273_580.37 * 10f64.powf(4.5), distance };
/// let ball = law.contact(distance * angle.sin() + 31.97643e-6, distance * angle.cos(), 0.0);
/// assert!((ball.load_inner - 251.39).abs() < 5e-3);
/// assert!((ball.angle_inner.to_degrees() - 19.35927).abs() < 1e-5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzLaw {
    /// Load–deflection constant K_n of both races in series, N/m^1.5.
    pub load_deflection_constant: f64,
    /// Unloaded distance A of the groove centres, m.
    pub distance: f64,
}

/// Keeps the direction of the line of centres defined where the two centres meet (no contact there).
pub(super) const SMALLEST_DISTANCE: f64 = f64::MIN_POSITIVE;

impl HertzLaw {
    /// Distance d of the groove centres and approach max(δ, 0).
    #[inline(always)]
    fn distance_and_approach(&self, axial: f64, radial: f64) -> (f64, f64) {
        let distance = (axial * axial + radial * radial).sqrt();
        let reach = distance - self.distance;
        // δ ≤ 0: separated
        (
            distance + SMALLEST_DISTANCE,
            if reach > 0.0 { reach } else { 0.0 },
        )
    }

    /// Q = K_n δ^(3/2)
    #[inline(always)]
    fn load(&self, approach: f64) -> f64 {
        self.load_deflection_constant * approach * approach.sqrt()
    }
}

impl BallLaw for HertzLaw {
    #[inline(always)]
    fn force(&self, axial: f64, radial: f64, _speed: f64) -> BallForce {
        let (distance, approach) = self.distance_and_approach(axial, radial);
        let lateral = self.load(approach) / distance;
        BallForce {
            axial: lateral * axial,
            radial: lateral * radial,
            couple: 0.0,
        }
    }

    #[inline(always)]
    fn forces<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>, _speed: f64) -> LaneForces<S> {
        let distance = (axial * axial + radial * radial).sqrt();
        // δ ≤ 0: separated
        let approach = (distance - self.distance).max(Lanes::splat(axial.witness(), 0.0));
        let load = self.load_deflection_constant * approach * approach.sqrt();
        let lateral = load / (distance + SMALLEST_DISTANCE);
        LaneForces {
            axial: lateral * axial,
            radial: lateral * radial,
            couple: Lanes::splat(axial.witness(), 0.0),
        }
    }

    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let (distance, approach) = self.distance_and_approach(axial, radial);
        let (n_a, n_r) = (axial / distance, radial / distance);
        // dF_i/dA_j = (dQ/dδ) n_i n_j + (Q/d)(δ_ij − n_i n_j)
        let normal = 1.5 * self.load_deflection_constant * approach.sqrt();
        let lateral = self.load(approach) / distance;
        let cross = (normal - lateral) * n_a * n_r;
        let tangent = [
            [normal * n_a * n_a + lateral * n_r * n_r, cross],
            [cross, normal * n_r * n_r + lateral * n_a * n_a],
            [0.0, 0.0],
        ];
        (self.force(axial, radial, speed), tangent)
    }

    fn load_slopes(&self, axial: f64, radial: f64, _speed: f64) -> [LoadSlope; 2] {
        let (distance, approach) = self.distance_and_approach(axial, radial);
        // ∂Q/∂A = (dQ/dδ) n
        let normal = 1.5 * self.load_deflection_constant * approach.sqrt();
        let slope = LoadSlope {
            load: self.load(approach),
            by_place: [normal * axial / distance, normal * radial / distance],
        };
        [slope; 2]
    }

    #[inline(always)]
    fn past_lift_off(&self, axial: f64, radial: f64, _speed: f64) -> f64 {
        (axial * axial + radial * radial).sqrt() - self.distance
    }

    fn contact(&self, axial: f64, radial: f64, _speed: f64) -> BallContact {
        let (distance, approach) = self.distance_and_approach(axial, radial);
        let (load, angle) = (self.load(approach), axial.atan2(radial));
        BallContact {
            approach: distance - self.distance,
            load_inner: load,
            load_outer: load,
            angle_inner: angle,
            angle_outer: angle,
        }
    }
}
