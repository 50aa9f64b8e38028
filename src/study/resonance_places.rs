//! Where peaks of a response are looked for: about the modes, whatever grid was asked for.

use crate::rotor::Mode;

/// Distances from a mode in its half widths ζω at which the response is looked at.
const HALF_WIDTHS: [f64; 9] = [-8.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 8.0];
/// Smallest half width, as a part of the frequency: an undamped mode has none.
const LEAST_RATIO: f64 = 1e-5;
/// Part of a half width within which a place is already looked at.
const KNOWN: f64 = 0.25;

/// A resonance: angular frequency, or speed, in rad/s, and damping ratio.
pub(super) struct Place {
    pub at: f64,
    pub damping_ratio: f64,
}

impl From<&Mode> for Place {
    fn from(mode: &Mode) -> Self {
        Self {
            at: mode.eigenvalue.im,
            damping_ratio: mode.damping_ratio(),
        }
    }
}

/// The places besides those that are `known`, which rise, between the first and the last of them: close enough about
/// each resonance that no peak lies between two of them.
pub(super) fn between(known: &[f64], resonances: &[Place]) -> Vec<f64> {
    let (Some(from), Some(to)) = (known.first(), known.last()) else {
        return Vec::new();
    };
    let mut found: Vec<f64> = Vec::new();
    for own in resonances {
        let half_width = own.damping_ratio.abs().max(LEAST_RATIO) * own.at;
        for distance in HALF_WIDTHS {
            let place = own.at + distance * half_width;
            let is_near = |other: &f64| (other - place).abs() < KNOWN * half_width;
            let above = known.partition_point(|other| *other < place);
            let beside = &known[above.saturating_sub(1)..(above + 1).min(known.len())];
            let is_new = !beside.iter().chain(&found).any(is_near);
            if is_new && (from..to).contains(&&place) {
                found.push(place);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_stand_about_resonances_within_the_range_once() {
        let known = [90.0, 100.0, 110.0];
        let resonance = |at, damping_ratio| Place { at, damping_ratio };
        let found = between(&known, &[resonance(100.0, 0.01), resonance(112.0, 0.01)]);
        // 100 itself is known, and beyond 110 nothing is asked for
        let mut expected = vec![92.0, 96.0, 98.0, 99.0, 101.0, 102.0, 104.0, 108.0];
        expected.push(112.0 - 8.0 * 1.12);
        expected.push(112.0 - 4.0 * 1.12);
        assert_eq!(found, expected);
        // the same once more
        assert_eq!(
            between(&known, &[resonance(100.0, 0.01), resonance(100.0, 0.01)]).len(),
            8
        );
        assert!(between(&[], &[resonance(100.0, 0.01)]).is_empty());
    }
}
