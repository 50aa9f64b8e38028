//! Where in a spectrum something knocks: the band whose envelope has the largest kurtosis.

use super::estimation::Envelopes;

/// Levels of the tree of bands at most: bands down to a 64th of the range.
const MOST_LEVELS: u32 = 6;
/// log₂ of the fewest samples that a band of the last level leaves.
const FEWEST: u32 = 7;
/// Part of the power of a signal below which a band is left out: round-off has any kurtosis.
const LEAST_POWER: f64 = 1e-4;
/// Part of a record at either end over which it is faded in and out, so that its ends do not knock.
const FADE: f64 = 0.05;
/// Samples of a long record that are looked at, in pieces that are spread over it.
const MOST_SAMPLES: usize = 1 << 20;
const PIECES: usize = 16;

/// A band and the kurtosis of what it holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulsiveBand {
    /// Lowest and highest frequency, Hz.
    pub band: [f64; 2],
    /// Spectral kurtosis: 0 of stationary noise, −1 of a tone, large where something knocks.
    pub kurtosis: f64,
}

/// The band of a signal of `rate` samples a second in which it knocks most, of a tree that divides the range up to half the
/// rate in 2, 3, 4, 6, 8, 12 … equal bands; none of a signal that is too short or rests.
///
/// ```text
/// K = ⟨|c|⁴⟩/⟨|c|²⟩² − 2
/// ```
///
/// with the complex envelope c of what the band holds, edges sharp.
///
/// Source: the tree and the measure are those of J. Antoni, *Fast computation of the kurtogram for the detection of
/// transient faults*, Mech. Syst. Signal Process. 21 (2007) 108–124; bands have sharp edges here in place of his filters of
/// 16 coefficients.
pub fn impulsive_band(samples: &[f64], rate: f64) -> Option<ImpulsiveBand> {
    let pieces: Vec<Vec<f64>> = pieces(samples).into_iter().map(faded).collect();
    let levels = pieces[0].len().checked_ilog2()?.checked_sub(FEWEST)?;
    let squares = pieces.iter().flatten().map(|value| value * value);
    let power = squares.sum::<f64>() / (pieces.len() * pieces[0].len()) as f64;
    let halves = (1..=levels.min(MOST_LEVELS)).flat_map(|level| [1 << level, 3 << (level - 1)]);
    let bands = halves.flat_map(|count: u32| {
        let width = 0.5 * rate / f64::from(count);
        (0..count).map(move |band| [0, 1].map(|edge| width * f64::from(band + edge)))
    });
    let envelopes = pieces.iter().map(|piece| Envelopes::new(piece, rate));
    let mut envelopes: Vec<Envelopes> = envelopes.collect();
    let kurtosis = |band: [f64; 2]| {
        let powers = envelopes.iter_mut().map(|piece| piece.mean_powers(band));
        let sums = powers.fold([0.0; 2], |[a, b], [second, fourth]| {
            [a + second, b + fourth]
        });
        let [second, fourth] = sums.map(|sum| sum / pieces.len() as f64);
        // half of the square of an envelope is power
        let loud = 0.5 * second > LEAST_POWER * power;
        let kurtosis = fourth / (second * second) - 2.0;
        (loud && kurtosis.is_finite()).then_some(ImpulsiveBand { band, kurtosis })
    };
    let found = bands.filter_map(kurtosis);
    found.max_by(|a, b| a.kurtosis.total_cmp(&b.kurtosis))
}

/// The whole signal, or of a long one pieces of equal length.
fn pieces(samples: &[f64]) -> Vec<&[f64]> {
    if samples.len() <= MOST_SAMPLES {
        return vec![samples];
    }
    let length = MOST_SAMPLES / PIECES;
    let start = |piece: usize| (samples.len() - length) / (PIECES - 1) * piece;
    let piece = |piece: usize| &samples[start(piece)..start(piece) + length];
    (0..PIECES).map(piece).collect()
}

/// The signal about its mean, faded in and out.
fn faded(samples: &[f64]) -> Vec<f64> {
    let length = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / length;
    let fade = FADE * length;
    let weight = |index: usize| {
        let from_end = (index as f64 + 0.5).min(length - index as f64 - 0.5);
        match from_end < fade {
            true => 0.5 - 0.5 * (std::f64::consts::PI * from_end / fade).cos(),
            false => 1.0,
        }
    };
    let samples = samples.iter().enumerate();
    samples
        .map(|(index, value)| weight(index) * (value - mean))
        .collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::rotor::load::SplitMix64;

    const RATE: f64 = 10_000.0;

    /// Noise of variance 1/12 with tones, and, where they are loud, rings at 2.2 kHz 40 times a second.
    fn signal(loudness: f64) -> Vec<f64> {
        let noise = SplitMix64::new(5);
        let at = |index: u64| {
            let time = index as f64 / RATE;
            let since = time % 0.025;
            let ring = loudness * (-since * 900.0).exp() * (TAU * 2200.0 * since).sin();
            let tone = 2.0 * (TAU * 130.0 * time).cos();
            ring + tone + noise.uniform(index) - 0.5
        };
        (0..16_384).map(at).collect()
    }

    #[test]
    fn the_band_of_what_rings_is_found_beneath_louder_tones() {
        let found = impulsive_band(&signal(4.0), RATE).expect("a band");
        let [low, high] = found.band;
        assert!(
            low < 2200.0 && 2200.0 < high && high - low < 2000.0,
            "{found:?}"
        );
        assert!(found.kurtosis > 3.0, "{found:?}");
        let still = impulsive_band(&signal(0.0), RATE).expect("a band");
        assert!(still.kurtosis < 0.6, "{still:?}");
    }

    #[test]
    fn pieces_are_spread_over_a_long_signal() {
        let signal: Vec<f64> = (0..MOST_SAMPLES + 20).map(|n| n as f64).collect();
        let found = pieces(&signal);
        let ends = [found[0][0], found[PIECES - 1][MOST_SAMPLES / PIECES - 1]];
        assert_eq!((found.len(), ends[0]), (PIECES, 0.0));
        assert!((ends[1] - signal.len() as f64).abs() <= PIECES as f64);
    }

    #[test]
    fn what_rests_or_is_short_has_none() {
        assert_eq!(impulsive_band(&[0.0; 1024], RATE), None);
        assert_eq!(impulsive_band(&[1.0, -1.0, 1.0], RATE), None);
        assert_eq!(impulsive_band(&[], RATE), None);
    }
}
