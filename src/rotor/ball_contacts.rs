//! What is observed of every ball at one instant.

use crate::bearing::{BallContact, LOADED_SHARE, Support};

/// Loads and contact angles of every ball of every bearing at one instant, and what each bearing
/// bears axially; filled anew at every sample, without allocation.
#[derive(Debug, Clone, PartialEq)]
pub struct BallContacts {
    /// Bearing by bearing; ball 0 first.
    pub(super) balls: Vec<BallContact>,
    /// By bearing: index after its last ball.
    ends: Vec<usize>,
    /// By bearing, in its own orientation, N.
    pub(super) axial_forces: Vec<f64>,
    /// Whether the forces of the bearings are looked at.
    pub(super) forces: bool,
}

impl BallContacts {
    /// Room for the balls of some bearings; a linear bearing has none.
    pub(super) fn new(supports: &[Support]) -> Self {
        let ends: Vec<usize> = supports
            .iter()
            .scan(0, |end, support| {
                *end += support.known_balls();
                Some(*end)
            })
            .collect();
        Self {
            balls: vec![BallContact::default(); ends.last().copied().unwrap_or(0)],
            axial_forces: vec![0.0; supports.len()],
            ends,
            forces: true,
        }
    }

    /// Room for none of the balls: they are not looked at, and the forces of the bearings only where asked for.
    pub(super) fn unwatched(supports: &[Support], forces: bool) -> Self {
        Self {
            balls: Vec::new(),
            axial_forces: vec![0.0; supports.len()],
            ends: vec![0; supports.len()],
            forces,
        }
    }

    /// Bearings in their order, each with its balls, ball 0 first; none of a linear bearing.
    pub fn bearings(&self) -> impl Iterator<Item = &[BallContact]> {
        (0..self.ends.len()).map(|bearing| self.of_bearing(bearing))
    }

    /// Balls of one bearing; none where there is no such bearing.
    pub fn of_bearing(&self, bearing: usize) -> &[BallContact] {
        let start = match bearing {
            0 => 0,
            _ => self.ends.get(bearing - 1).copied().unwrap_or(0),
        };
        let end = self.ends.get(bearing).copied().unwrap_or(start);
        &self.balls[start..end]
    }

    /// Axial force that the inner ring presses onto each bearing, positive the way its facing loads
    /// it, N.
    pub fn axial_forces(&self) -> &[f64] {
        &self.axial_forces
    }

    /// Largest load at either race, N; zero without balls.
    pub fn largest_load(&self) -> f64 {
        let largest = |ball: &BallContact| ball.load_inner.max(ball.load_outer);
        self.balls.iter().map(largest).fold(0.0, f64::max)
    }

    /// Load at the inner race above which a ball counts as loaded, N: a millionth of the largest
    /// there, of all bearings, for behind an oil film no load is quite zero.
    pub fn least_load(&self) -> f64 {
        let inner = self.balls.iter().map(|ball| ball.load_inner);
        LOADED_SHARE * inner.fold(0.0, f64::max)
    }

    /// Number of loaded balls of all bearings.
    pub fn loaded(&self) -> u32 {
        let least = self.least_load();
        let loaded = |ball: &BallContact| u32::from(ball.load_inner > least);
        self.balls.iter().map(loaded).sum()
    }
}
