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
}
