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
    /// Whether the contact angles are.
    pub(super) angles: bool,
    /// Of the balls as they stand now.
    sums: LoadSums,
}

/// What the loads of all balls have in common.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct LoadSums {
    largest: f64,
    least: f64,
    loaded: u32,
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
            angles: true,
            sums: LoadSums::default(),
        }
    }

    /// As [`BallContacts::new`], but the contact angles stay zero.
    pub(super) fn loads(supports: &[Support]) -> Self {
        Self {
            angles: false,
            ..Self::new(supports)
        }
    }

    /// Room for none of the balls: they are not looked at, and the forces of the bearings only where asked for.
    pub(super) fn unwatched(supports: &[Support], forces: bool) -> Self {
        Self {
            balls: Vec::new(),
            axial_forces: vec![0.0; supports.len()],
            ends: vec![0; supports.len()],
            forces,
            angles: false,
            sums: LoadSums::default(),
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
        self.sums.largest
    }

    /// Load at the inner race above which a ball counts as loaded, N: a millionth of the largest
    /// there, of all bearings, for behind an oil film no load is quite zero.
    pub fn least_load(&self) -> f64 {
        self.sums.least
    }

    /// Number of loaded balls of all bearings.
    pub fn loaded(&self) -> u32 {
        self.sums.loaded
    }

    /// Takes stock of the balls, once they are those of another sample.
    pub(super) fn sum_up(&mut self) {
        let (mut inner, mut outer) = (0.0, 0.0);
        for ball in &self.balls {
            inner = if ball.load_inner > inner {
                ball.load_inner
            } else {
                inner
            };
            outer = if ball.load_outer > outer {
                ball.load_outer
            } else {
                outer
            };
        }
        let least = LOADED_SHARE * inner;
        let loaded = |ball: &BallContact| u32::from(ball.load_inner > least);
        self.sums = LoadSums {
            largest: if outer > inner { outer } else { inner },
            least,
            loaded: self.balls.iter().map(loaded).sum(),
        };
    }
}
