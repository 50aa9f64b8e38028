//! Where the inner groove centres of a ring's balls may come.

/// Rectangle of places (A1, A2) of the inner groove centre, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallRegion {
    /// Least and greatest axial distance A1, m.
    pub axial: [f64; 2],
    /// Least and greatest radial distance A2, m.
    pub radial: [f64; 2],
}

impl BallRegion {
    /// The same with |A1| in place of A1: every law is the same on both sides of A1 = 0.
    pub(super) fn folded(&self) -> Self {
        let [low, high] = self.axial;
        let far = low.abs().max(high.abs());
        let near = if low <= 0.0 && high >= 0.0 {
            0.0
        } else {
            low.abs().min(high.abs())
        };
        Self {
            axial: [near, far],
            radial: self.radial,
        }
    }

    /// Whether a place is inside a folded region; one that is no number is not.
    pub(super) fn contains(&self, axial: f64, radial: f64) -> bool {
        let within = |value: f64, [low, high]: [f64; 2]| (low..=high).contains(&value);
        within(axial.abs(), self.axial) && within(radial, self.radial)
    }

    /// Whether all places are inside a folded region whose A1 and A2 are within their amplitudes of the middle; each is the
    /// middle and the square of the amplitude, in m and m².
    #[inline(always)]
    pub(super) fn contains_around(&self, axial: [f64; 2], radial: [f64; 2]) -> bool {
        // squares in place of a root, which takes long
        let room = |[middle, square]: [f64; 2], [low, high]: [f64; 2]| {
            let (below, above) = (middle - low, high - middle);
            (below >= 0.0) & (above >= 0.0) & (below * below >= square) & (above * above >= square)
        };
        let [near, far] = self.axial;
        // both sides of A1 = 0
        let near = if near > 0.0 { near } else { -far };
        room(radial, self.radial) & room([axial[0].abs(), axial[1]], [near, far])
    }
}
