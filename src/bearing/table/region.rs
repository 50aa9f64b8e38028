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
    /// Least and greatest |A1|: every law is the same on both sides of A1 = 0.
    pub(super) fn axial_span(&self) -> [f64; 2] {
        let [low, high] = self.axial;
        let far = low.abs().max(high.abs());
        if low <= 0.0 && high >= 0.0 {
            [0.0, far]
        } else {
            [low.abs().min(high.abs()), far]
        }
    }

    /// The same from another least A2 on, and with both ends of A1 above zero; where it holds A1 = 0, it reaches as
    /// far to both sides.
    pub(super) fn one_sided(&self, lowest: f64) -> Self {
        let [near, far] = self.axial_span();
        Self {
            axial: [if near > 0.0 { near } else { -far }, far],
            radial: [lowest, self.radial[1]],
        }
    }
}
