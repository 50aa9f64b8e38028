//! A squeeze film damper: a ring that does not turn, in a film of oil.

use super::element::ElementMotion;
use super::force_law::ForceLaw;
use crate::bearing::{Matrix5, Vector5};

/// Largest eccentricity of a ring at rest.
const MOST_AT_REST: f64 = 0.999;

/// A short film that cavitates: where the ring draws back, half the circumference, there is no pressure (π film).
///
/// ```text
/// P(φ) = μ L³ (v·n)₊/h³,   h = c − u·n,   F = ∫ P n R dφ        n = (cos φ, sin φ), v = u̇
/// ```
///
/// With φ from the direction of u on, ε = |u|/c, and the film over half a turn about the direction of v:
///
/// ```text
/// F = μ R L³/c³ [I_ab] v,   I_ab = ∫ cosᵃφ sinᵇφ/(1 − ε cos φ)³ dφ,   a + b = 2
/// cos φ = (ε + cos γ)/(1 + ε cos γ):  I_ab = (1 − ε²)^((b−5)/2) ∫ (ε + cos γ)ᵃ sinᵇγ dγ
/// ```
///
/// Holds for L/2R up to about one half, without inertia of the oil, and with open ends. On a circle about the centre it is
/// `F_t = μ R L³/c² · ε ω π/(2 (1 − ε²)^(3/2))` against the motion and `F_r = μ R L³/c² · 2 ε² ω/(1 − ε²)²` towards the
/// centre.
///
/// Source: J. Vance, F. Zeidan & B. Murphy, *Machinery Vibration and Rotordynamics* (2010), ch. 6; substitution by
/// A. Sommerfeld (1904).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SqueezeFilm {
    /// Radius R of the ring, m.
    pub radius: f64,
    /// Length L of the film, m.
    pub length: f64,
    /// Radial clearance c, m.
    pub clearance: f64,
    /// Dynamic viscosity μ, Pa s.
    pub viscosity: f64,
}

/// The film about the ring in a motion.
struct Film {
    /// ε.
    eccentricity: f64,
    /// Direction of the displacement; X in the middle.
    along: [f64; 2],
    /// Both ends of the film, γ.
    ends: [f64; 2],
    /// μ R L³/c³, N s/m.
    size: f64,
    /// Part of the integrals that counts: half of those of a whole film where the ring is at rest.
    part: f64,
}

impl SqueezeFilm {
    /// The film at a displacement and its rate. Where nothing moves it may lie on either side, and both halves count half.
    fn film(&self, [x, y, ..]: &Vector5, [v_x, v_y, ..]: &Vector5) -> Film {
        let distance = x.hypot(*y);
        let along = match distance > 0.0 {
            true => [x / distance, y / distance],
            false => [1.0, 0.0],
        };
        let is_at_rest = *v_x == 0.0 && *v_y == 0.0;
        let eccentricity = match is_at_rest {
            // where an equilibrium is searched for, the film holds nothing and is nowhere singular
            true => (distance / self.clearance).min(MOST_AT_REST),
            false => distance / self.clearance,
        };
        let [radial, tangential] = [
            v_x * along[0] + v_y * along[1],
            v_y * along[0] - v_x * along[1],
        ];
        let (middle, half) = match is_at_rest {
            true => (0.0, std::f64::consts::PI),
            false => (tangential.atan2(radial), 0.5 * std::f64::consts::PI),
        };
        // γ − φ = 2 arctan(b sin φ/(1 − b cos φ)), b = ε/(1 + √(1 − ε²))
        let b = eccentricity / (1.0 + (1.0 - eccentricity * eccentricity).sqrt());
        let ends = [middle - half, middle + half].map(|phi| {
            let (sin, cos) = phi.sin_cos();
            phi + 2.0 * (b * sin).atan2(1.0 - b * cos)
        });
        Film {
            eccentricity,
            along,
            ends,
            size: self.viscosity * self.radius * (self.length / self.clearance).powi(3),
            part: if is_at_rest { 0.5 } else { 1.0 },
        }
    }
}

impl Film {
    /// ∫ of a function of γ, given by its antiderivative, over the film, times (1 − ε²)^(half/2).
    fn integral(&self, half: i32, antiderivative: impl Fn(f64, f64, f64) -> f64) -> f64 {
        let [first, last] = self.ends.map(|gamma| {
            let (sin, cos) = gamma.sin_cos();
            antiderivative(gamma, sin, cos)
        });
        let rest = 1.0 - self.eccentricity * self.eccentricity;
        self.part * (last - first) * rest.sqrt().powi(half)
    }

    /// I_20, I_11, I_02.
    fn squares(&self) -> [f64; 3] {
        let e = self.eccentricity;
        [
            // (ε + cos γ)²
            self.integral(-5, |g, s, c| (e * e + 0.5) * g + 2.0 * e * s + 0.5 * s * c),
            // (ε + cos γ) sin γ
            self.integral(-4, |_, s, c| 0.5 * s * s - e * c),
            // sin²γ
            self.integral(-3, |g, s, c| 0.5 * (g - s * c)),
        ]
    }

    /// `J_ab = ∫ cosᵃφ sinᵇφ/(1 − ε cos φ)⁴ dφ = (1 − ε²)^((b−7)/2) ∫ (ε + cos γ)ᵃ sinᵇγ dγ` for a + b = 3: J_30, J_21, J_12,
    /// J_03.
    fn cubes(&self) -> [f64; 4] {
        let e = self.eccentricity;
        [
            self.integral(-7, |g, s, c| {
                e * (e * e + 1.5) * g + (3.0 * e * e + 1.0) * s + 1.5 * e * s * c - s * s * s / 3.0
            }),
            self.integral(-6, |_, _, c| -(e + c).powi(3) / 3.0),
            self.integral(-5, |g, s, c| 0.5 * e * (g - s * c) + s * s * s / 3.0),
            self.integral(-4, |_, _, c| c * c * c / 3.0 - c),
        ]
    }

    /// A matrix along and across the displacement, in x and y.
    fn turned(&self, [[rr, rt], [tr, tt]]: [[f64; 2]; 2]) -> Matrix5 {
        let [c, s] = self.along;
        let axes = [[c, -s], [s, c]];
        let own = [[rr, rt], [tr, tt]];
        let mut matrix = Matrix5::zeros();
        for row in 0..2 {
            for column in 0..2 {
                for (i, part) in own.iter().enumerate() {
                    for (j, part) in part.iter().enumerate() {
                        matrix[(row, column)] += axes[row][i] * part * axes[column][j];
                    }
                }
            }
        }
        matrix
    }

    /// ∂F/∂v, with which F = (∂F/∂v) v.
    fn damping(&self) -> Matrix5 {
        let [rr, rt, tt] = self.squares().map(|own| self.size * own);
        self.turned([[rr, rt], [rt, tt]])
    }
}

impl ForceLaw for SqueezeFilm {
    fn force(&self, motion: &ElementMotion) -> Vector5 {
        let film = self.film(&motion.displacement, &motion.rate);
        (film.damping() * nalgebra::SVector::from(motion.rate)).into()
    }

    fn slopes(&self, motion: &ElementMotion) -> [Matrix5; 2] {
        let film = self.film(&motion.displacement, &motion.rate);
        let [c, s] = film.along;
        let [v_x, v_y, ..] = motion.rate;
        let (radial, tangential) = (v_x * c + v_y * s, v_y * c - v_x * s);
        // ∂F/∂u = 3 μ R L³ ∫ (v·n)₊ n nᵀ/h⁴ dφ: at both ends of the film its pressure is zero
        let size = 3.0 * film.size / self.clearance;
        let [rrr, rrt, rtt, ttt] = film.cubes().map(|own| size * own);
        let across = radial * rrt + tangential * rtt;
        let stiffness = film.turned([
            [radial * rrr + tangential * rrt, across],
            [across, radial * rtt + tangential * ttt],
        ]);
        [stiffness, film.damping()]
    }

    fn wall(&self) -> Option<f64> {
        Some(self.clearance)
    }
}
