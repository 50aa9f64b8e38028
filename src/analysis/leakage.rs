//! Lines that do not stand on a bin of an unweighted spectrum.

use std::f64::consts::PI;

/// Lines below this part of the strongest are not looked at.
const STRONG: f64 = 0.1;
/// Fewest bins from either end of the spectrum: nearer ones are mixed with their image.
const MARGIN: usize = 3;
/// How far the neighbours of a line may be from what a single line leaves there, of its height.
const LIKENESS: f64 = 0.1;
/// Lines nearer to their bin than this show 99 % of their amplitude.
const SMALLEST_OFFSET: f64 = 0.08;
/// Lines with less than this part of the power are no lines but the hills of noise.
const POWER: f64 = 0.01;
/// Skirts are followed down to this part of their line.
const SKIRT: f64 = 0.01;

/// A line that leaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leak {
    /// The bin next to it.
    pub bin: usize,
    /// How far it stands beside that bin, −½ … ½ bins.
    pub offset: f64,
    /// Its amplitude.
    pub amplitude: f64,
}

impl Leak {
    /// Part of the amplitude that the bin shows, `sin πδ/πδ`.
    pub fn shown(&self) -> f64 {
        (PI * self.offset).sin() / (PI * self.offset)
    }

    /// Bins to either side within which the skirts stand above a hundredth of the line:
    /// at d bins they are `sin πδ/πd` of it.
    pub fn reach(&self) -> f64 {
        (PI * self.offset).sin().abs() / (PI * SKIRT)
    }
}

/// The line of an unweighted amplitude spectrum (peak values at bins 0, 1, …) that leaks most, of the
/// strong ones that stand beside their bin; amplitudes up to `noise` are none.
///
/// A line δ bins beside bin k leaves 1/|δ|, 1/(1 − δ) and 1/(1 + δ) at bins k and k ± 1, and 1/(2 ∓ δ)
/// beyond; what does not look so is no line. Source: Harris, Proc. IEEE 66 (1978), sect. IV.
pub fn leak(amplitudes: &[f64], noise: f64) -> Option<Leak> {
    let inner = MARGIN..amplitudes.len().saturating_sub(MARGIN);
    let powers = amplitudes.iter().skip(1).map(|a| a * a);
    let total: f64 = powers.sum();
    let strongest = amplitudes.iter().skip(1).copied().fold(0.0, f64::max);
    let leaked = |line: &Leak| line.amplitude * (PI * line.offset).sin().abs();
    inner
        .filter(|k| amplitudes[*k] > noise && amplitudes[*k] >= STRONG * strongest)
        .filter(|k| amplitudes[*k].powi(2) > POWER * total)
        .filter_map(|k| line(amplitudes, k))
        .filter(|line| line.offset.abs() > SMALLEST_OFFSET)
        .max_by(|a, b| leaked(a).total_cmp(&leaked(b)))
}

/// The single line that makes a maximum at bin `k`.
fn line(amplitudes: &[f64], k: usize) -> Option<Leak> {
    let height = amplitudes[k];
    let [below, above] = [k - 1, k + 1].map(|k| amplitudes[k] / height);
    if below > 1.0 || above >= 1.0 {
        return None;
    }
    let side = if above >= below { 1.0 } else { -1.0 };
    let ratio = above.max(below);
    let offset = ratio / (1.0 + ratio);
    let [far, beyond, behind] = if side > 0.0 {
        [k - 1, k + 2, k - 2]
    } else {
        [k + 1, k - 2, k + 2]
    };
    let expected = [
        (far, offset / (1.0 + offset)),
        (beyond, offset / (2.0 - offset)),
        (behind, offset / (2.0 + offset)),
    ];
    let alike = |(k, part): (usize, f64)| (amplitudes[k] / height - part).abs() < LIKENESS;
    let mut found = Leak {
        bin: k,
        offset: side * offset,
        amplitude: height,
    };
    if offset > 0.0 {
        found.amplitude /= found.shown();
    }
    expected.into_iter().all(alike).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Transform;
    use crate::analysis::Window;
    use std::f64::consts::TAU;

    #[test]
    fn a_line_between_bins_is_found() {
        let line = |n: usize| 3.0 * (TAU * 20.3 * n as f64 / 256.0).cos();
        let transform = Transform::new((0..256).map(line).collect());
        let amplitudes: Vec<f64> = (0..transform.bins())
            .map(|k| transform.amplitude(k, Window::Rectangular))
            .collect();
        let found = leak(&amplitudes, 1e-12).unwrap();
        assert_eq!(found.bin, 20);
        assert!((found.offset - 0.3).abs() < 0.02 && (found.amplitude - 3.0).abs() < 0.1);
    }
}
