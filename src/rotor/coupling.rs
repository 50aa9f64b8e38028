//! A flexible coupling to a shaft that does not vibrate, which may be misaligned with this one.

use super::load::{Harmonic, HarmonicRate};
use super::{LinearLaw, Load, LoadKind};
use crate::bearing::{Matrix5, Vector5};

/// Two joints of bending stiffness K, so far apart as the spacer between them is long: the first one on this shaft, at the
/// slope θ and the distance u from the common axis, the second one on the other shaft.
///
/// ```text
/// s = σ (Δ − u)/L,   V = ½ K ((s − θ)² + (α − s)²)
/// ```
///
/// with the parallel offset Δ and the angle α of the other shaft, which lies towards +Z (σ = 1) or −Z (σ = −1). It acts on this
/// shaft as springs, `F = (2K/L² u + σK/L θ, σK/L u + K θ)`, and with the reaction to the misalignment: along its direction e the
/// force p and the moment m of bending, across it the force q and about e the moment t of the torque T,
///
/// ```text
/// p = 2KΔ/L² − σKα/L,   m = σKΔ/L,   q = Tα/L,   t = TΔ/L
/// ```
///
/// The reaction at rest is that of Gibbons, for small angles; while the shaft turns it has parts of the same size at 1×
/// and 2×, those along X and about Y as sines and those along Y and about X as cosines of the angle, after Sekhar &
/// Prabhu. So large they are of a coupling whose reaction comes and goes with its turning; of one with many bolts or discs they
/// are smaller. The coupling is constant in speed, has no mass and no stiffness along Z.
///
/// Source: C. B. Gibbons, *Coupling misalignment forces*, Proc. 5th Turbomachinery Symposium (1976) 111–116; A. S. Sekhar &
/// B. S. Prabhu, *Effects of coupling misalignment on vibrations of rotating machinery*, J. Sound Vib. 185 (1995) 655–671.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupling {
    /// K of each joint, N m/rad.
    pub bending_stiffness: f64,
    /// Damping of each joint, N m s/rad.
    pub bending_damping: f64,
    /// L, m.
    pub length: f64,
    /// T, N m.
    pub torque: f64,
    /// Δ, m.
    pub offset: f64,
    /// α, rad.
    pub angle: f64,
    /// Direction e of both from +X, rad.
    pub direction: f64,
    /// σ.
    pub side: f64,
}

impl Coupling {
    /// Its springs and dampers.
    pub fn law(&self) -> LinearLaw {
        let along = |joint: f64| {
            let (across, arm) = (
                2.0 * joint / (self.length * self.length),
                self.side * joint / self.length,
            );
            let mut matrix = Matrix5::from_diagonal(&[across, across, 0.0, joint, joint].into());
            // θy = dx/dz, θx = −dy/dz
            for (row, column, sign) in [(0, 4, 1.0), (1, 3, -1.0)] {
                matrix[(row, column)] = sign * arm;
                matrix[(column, row)] = sign * arm;
            }
            matrix
        };
        LinearLaw {
            stiffness: along(self.bending_stiffness),
            damping: along(self.bending_damping),
        }
    }

    /// Reaction to the misalignment at rest, of the coupling on this shaft, N and N m.
    pub fn reaction(&self) -> Vector5 {
        let (joint, length) = (self.bending_stiffness, self.length);
        let along =
            2.0 * joint * self.offset / (length * length) - self.side * joint * self.angle / length;
        let across = self.torque * self.angle / length;
        let bending = self.side * joint * self.offset / length;
        let twisting = self.torque * self.offset / length;
        let (sin, cos) = self.direction.sin_cos();
        [
            along * cos - across * sin,
            along * sin + across * cos,
            0.0,
            twisting * cos - bending * sin,
            twisting * sin + bending * cos,
        ]
    }

    /// The reaction at rest, and its parts at 1× and 2×.
    pub fn loads(&self, position: f64) -> Vec<Load> {
        let [x, y, _, tilt_x, tilt_y] = self.reaction();
        let sines = ([x, 0.0, 0.0, 0.0, tilt_y], -std::f64::consts::FRAC_PI_2);
        let cosines = ([0.0, y, 0.0, tilt_x, 0.0], 0.0);
        let mut kinds = vec![LoadKind::Constant(self.reaction())];
        for order in [1.0, 2.0] {
            for (amplitude, phase) in [sines, cosines] {
                kinds.push(LoadKind::Harmonic(Harmonic {
                    amplitude,
                    rate: HarmonicRate::Order(order),
                    phase,
                }));
            }
        }
        let acts = |kind: &LoadKind| match kind {
            LoadKind::Harmonic(own) => own.amplitude != [0.0; 5],
            _ => self.reaction() != [0.0; 5],
        };
        let acting = kinds.into_iter().filter(acts);
        acting.map(|kind| Load { kind, position }).collect()
    }
}
