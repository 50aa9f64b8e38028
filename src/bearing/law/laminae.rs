//! Laminae of a roller side by side, and what they bear.

use fearless_simd::{Simd, SimdBase};

use super::ninth_root::ninth_root;
use crate::bearing::number::{LANES, Lanes, Plain};

/// Laminae side by side.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Four {
    /// Middles from the middle of the roller, m.
    pub position: [f64; LANES],
    /// 2 P, m.
    pub drop: [f64; LANES],
}

/// Drop of what fills up the last four, m: deeper than any approach.
pub(super) const NEVER: f64 = 1e3;

/// Laminae in fours, each a position and 2 P in m, the last filled up with ones that never bear.
pub(super) fn fours(laminae: &[[f64; 2]]) -> Box<[Four]> {
    let four = |laminae: &[[f64; 2]]| {
        let mut four = Four {
            position: [0.0; LANES],
            drop: [NEVER; LANES],
        };
        for (lane, lamina) in laminae.iter().enumerate() {
            [four.position[lane], four.drop[lane]] = *lamina;
        }
        four
    };
    laminae.chunks(LANES).map(four).collect()
}

/// Sums over laminae, over c_s.
#[derive(Clone, Copy)]
pub(super) struct Sums<T> {
    /// Σ q and −Σ s q.
    pub load: [T; 2],
    /// Σ dq/dδ s^m, m = 0, 1, 2, but for the factor 10/9.
    pub stiffness: [T; 3],
}

impl<S: Simd> Sums<Lanes<S>> {
    /// What laminae bear with the middle of the roller approached by some m under a tilt in rad, each lane a part of the
    /// sums; those of the stiffness only where `SLOPES`.
    #[inline(always)]
    pub fn over<const SLOPES: bool>(simd: S, fours: &[Four], [middle, tilt]: [f64; 2]) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let (mut load, mut stiffness) = ([zero; 2], [zero; 3]);
        for four in fours {
            let position = Lanes::load_array_ref(simd, &four.position);
            let drop = Lanes::load_array_ref(simd, &four.drop);
            // δ_k
            let approach = (Lanes::splat(simd, middle) - position * tilt) - drop;
            if !simd.any_true_mask64x4(simd.simd_gt_f64x4(approach, zero)) {
                continue;
            }
            let pressed = approach.max(zero);
            // dq/dδ = 10/9 c_s δ^(1/9) and q = c_s δ δ^(1/9)
            let root = ninth_root(pressed);
            let pushed = pressed * root;
            load[0] += pushed;
            load[1] -= position * pushed;
            if SLOPES {
                let slope = approach.if_positive(root);
                let lever = position * slope;
                stiffness[0] += slope;
                stiffness[1] += lever;
                stiffness[2] += position * lever;
            }
        }
        Self { load, stiffness }
    }

    /// The sums of the lanes.
    #[inline(always)]
    pub fn total(&self) -> Sums<f64> {
        Sums {
            load: self.load.map(|lanes| total(&lanes)),
            stiffness: self.stiffness.map(|lanes| total(&lanes)),
        }
    }
}

/// Sum of the lanes.
#[inline(always)]
pub(super) fn total<S: Simd>(lanes: &Lanes<S>) -> f64 {
    let [a, b, c, d] = **lanes;
    (a + b) + (c + d)
}
