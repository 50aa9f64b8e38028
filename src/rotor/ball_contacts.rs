//! What is observed of every ball at one instant.

use crate::bearing::{BallLoads, LOADED_SHARE, Support};

/// Loads and contact angles of every ball of every bearing at one instant, and what each bearing
/// bears axially; filled anew at every sample, without allocation.
#[derive(Debug, Clone, PartialEq)]
pub struct BallContacts {
    pub(super) bearings: Vec<BallLoads>,
    /// By bearing, in its own orientation, N.
    pub(super) axial_forces: Vec<f64>,
    /// Whether the forces of the bearings are looked at.
    pub(super) forces: bool,
    largest: f64,
    least: f64,
    loaded: u32,
}

impl BallContacts {
    /// Room for the balls of some bearings, and for their angles; a linear bearing has none.
    pub(super) fn new(supports: &[Support], angles: bool) -> Self {
        let loads = |support: &Support| BallLoads::new(support.known_balls(), angles);
        Self {
            bearings: supports.iter().map(loads).collect(),
            axial_forces: vec![0.0; supports.len()],
            forces: true,
            largest: 0.0,
            least: 0.0,
            loaded: 0,
        }
    }

    /// Room for none of the balls: they are not looked at, and the forces of the bearings only where asked for.
    pub(super) fn unwatched(supports: &[Support], forces: bool) -> Self {
        Self {
            bearings: vec![BallLoads::default(); supports.len()],
            forces,
            ..Self::new(supports, false)
        }
    }

    /// The balls of each bearing; none of a linear one.
    pub fn bearings(&self) -> &[BallLoads] {
        &self.bearings
    }

    /// Whether any ball is observed.
    pub(super) fn has_balls(&self) -> bool {
        self.bearings.iter().any(|bearing| bearing.balls() > 0)
    }

    /// Axial force that the inner ring presses onto each bearing, positive the way its facing loads
    /// it, N.
    pub fn axial_forces(&self) -> &[f64] {
        &self.axial_forces
    }

    /// Largest load at either race, N; zero without balls.
    pub fn largest_load(&self) -> f64 {
        self.largest
    }

    /// Load at the inner race above which a ball counts as loaded, N: a millionth of the largest
    /// there, of all bearings, for behind an oil film no load is quite zero.
    pub fn least_load(&self) -> f64 {
        self.least
    }

    /// Number of loaded balls of all bearings.
    pub fn loaded(&self) -> u32 {
        self.loaded
    }

    /// Takes stock of the balls, once they are those of another sample.
    pub(super) fn sum_up(&mut self) {
        let mut largest = [0.0_f64; 2];
        for bearing in &self.bearings {
            for (largest, of_bearing) in largest.iter_mut().zip(bearing.largest) {
                *largest = largest.max(of_bearing);
            }
        }
        self.largest = largest[0].max(largest[1]);
        self.least = LOADED_SHARE * largest[0];
        self.loaded = 0;
        for bearing in &self.bearings {
            let loaded = bearing.load[0]
                .iter()
                .map(|load| u32::from(*load > self.least));
            self.loaded += loaded.sum::<u32>();
        }
    }
}
