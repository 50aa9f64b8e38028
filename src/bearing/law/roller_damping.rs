//! Damping of the contacts of a roller, lamina by lamina.

use fearless_simd::{Simd, SimdBase};

use super::laminae::{Four, total};
use super::ninth_root::ninth_root;
use crate::bearing::number::{Function, Lanes, Plain};
use crate::numerics::registers::in_wide_registers;
use crate::physics::LINE_EXPONENT;

/// What resists the rate of a roller whose laminae are damped each by itself.
///
/// ```text
/// δ̇_k = u̇ − s_k Ṫ        p_k = q_k Σ_races max(c δ̇_k/2, −1)/2        load = Σ p_k        couple = −Σ s_k p_k
/// ```
///
/// by the approach u of its middle, its tilt T and their rates, with q_k and s_k of [`super::RollerLaw`]: each race takes
/// half of the approach. As with balls, no contact pulls.
pub(super) struct LaminaDamping<'a> {
    pub level: fearless_simd::Level,
    pub laminae: &'a [Four],
    /// c_s, N/m^(10/9).
    pub stiffness: f64,
    /// c of both races, s/m.
    pub coefficients: [f64; 2],
}

impl Function<4, 2> for LaminaDamping<'_> {
    fn with_slopes(&self, at: [f64; 4]) -> ([f64; 2], [[f64; 4]; 2]) {
        in_wide_registers!(self.level, simd => self.sums(simd, at))
    }
}

impl LaminaDamping<'_> {
    #[inline(always)]
    fn sums<S: Simd>(
        &self,
        simd: S,
        [middle, tilt, middle_rate, tilt_rate]: [f64; 4],
    ) -> ([f64; 2], [[f64; 4]; 2]) {
        let zero = Lanes::splat(simd, 0.0);
        // Σ p s^m, Σ ∂p/∂δ s^m and Σ ∂p/∂δ̇ s^m
        let (mut load, mut by_place, mut by_rate) = ([zero; 2], [zero; 3], [zero; 3]);
        for four in self.laminae {
            let position = Lanes::load_array_ref(simd, &four.position);
            let drop = Lanes::load_array_ref(simd, &four.drop);
            let approach = (Lanes::splat(simd, middle) - position * tilt) - drop;
            let rate = Lanes::splat(simd, middle_rate) - position * tilt_rate;
            let pressed = approach.max(zero);
            let root = ninth_root(pressed) * self.stiffness;
            let elastic = pressed * root;
            let (mut part, mut slope) = (zero, zero);
            for coefficient in self.coefficients {
                let half = rate * (0.5 * coefficient);
                part += half.at_least(-1.0) * 0.5;
                slope += (half + 1.0).if_positive(Lanes::splat(simd, 0.25 * coefficient));
            }
            let parts = [
                elastic * part,
                approach.if_positive(root) * LINE_EXPONENT * part,
                elastic * slope,
            ];
            let mut lever = Lanes::splat(simd, 1.0);
            for power in 0..3 {
                if power < 2 {
                    load[power] += lever * parts[0];
                }
                by_place[power] += lever * parts[1];
                by_rate[power] += lever * parts[2];
                lever *= position;
            }
        }
        let [load, couple] = load.map(|lanes| total(&lanes));
        let [d0, d1, d2] = by_place.map(|lanes| total(&lanes));
        let [r0, r1, r2] = by_rate.map(|lanes| total(&lanes));
        ([load, -couple], [[d0, -d1, r0, -r1], [-d1, d2, -r1, r2]])
    }
}
