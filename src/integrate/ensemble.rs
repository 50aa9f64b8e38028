//! Motions side by side carried along a grid of times.

use std::sync::atomic::AtomicBool;

use super::course::Course;
use super::nystrom::EnsembleWalk;
use super::{Counters, Grid, IntegrateError, Scaling, Settings, System, VelocityDependence};

/// An integration of `K` motions side by side, in N states together: component i belongs to motion number i
/// modulo K. They share the steps, which the tolerance holds for each of them.
///
/// The method is Dormand–El-Mikkawy–Prince 8(6): of the methods here it costs least where nothing is known of
/// the motions. Surfaces at which a derivative is not smooth are stepped over.
pub(crate) struct EnsembleIntegration<'a, S, const N: usize, const K: usize> {
    system: &'a S,
    scaling: Scaling<N>,
    grid: Grid,
    settings: Settings,
    stop: &'a AtomicBool,
    next: u64,
    walk: EnsembleWalk<N, K>,
}

impl<'a, S: System<N>, const N: usize, const K: usize> EnsembleIntegration<'a, S, N, K> {
    /// Starts at time 0 in `state`. Setting `stop` ends the integration at its next step.
    ///
    /// # Errors
    /// [`VelocityDependence`] where the method does not serve the system.
    pub fn new(
        system: &'a S,
        scaling: Scaling<N>,
        grid: Grid,
        settings: Settings,
        stop: &'a AtomicBool,
        state: &[f64; N],
    ) -> Result<Self, VelocityDependence> {
        let deviation = std::array::from_fn(|i| state[i] - scaling.origin[i]);
        Ok(Self {
            system,
            scaling,
            grid,
            settings,
            stop,
            next: 0,
            walk: EnsembleWalk::new(system, deviation)?,
        })
    }

    /// Work done so far for every one of the motions.
    pub fn counters(&self) -> Counters {
        self.walk.counters()
    }

    /// Number of grid times handed out so far.
    pub fn done(&self) -> u64 {
        self.next
    }

    /// Integrates over up to `points` further grid times and appends the states there to `states`.
    ///
    /// # Errors
    /// [`IntegrateError`] where any of the motions cannot go on.
    pub fn advance(
        &mut self,
        points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        let (scaling, settings) = (&self.scaling, &self.settings);
        let course = Course::over(&self.grid, self.system, scaling, settings, self.stop);
        let left = self.grid.count - self.next;
        for _ in 0..left.min(points as u64) {
            states.push(self.walk.states_at(&course, self.grid.time(self.next))?);
            self.next += 1;
        }
        Ok(())
    }
}
