//! What the equations of motion cost, and how fast they are driven.

use super::Rotor;
use crate::bearing::Support;
use crate::integrate::Effort;

/// Of a derivative without its bearings by freedom, and of a varying load, s.
const FREEDOM: f64 = 5e-9;
const LOAD: f64 = 10e-9;
/// Slopes of the damping of dry contacts over its force; differences, which others take, are twice as dear.
const DAMPING_SLOPES: f64 = 30.0;

impl Rotor {
    /// Prices on one server, by the laws of the bearings.
    pub(super) fn effort(&self) -> Effort {
        let forces: f64 = self.supports.iter().map(Support::price).sum();
        let slopes: f64 = self.supports.iter().map(Support::slopes_price).sum();
        let shaft = FREEDOM * self.kept() as f64 + LOAD * self.loads.len() as f64;
        let damping: f64 = self.supports.iter().map(Support::damping_price).sum();
        Effort {
            derivative: shaft + forces + damping,
            linearisation: shaft + forces + slopes + DAMPING_SLOPES * damping,
        }
    }

    /// Mean angular frequency between two times of the fastest of shaft and loads, rad/s.
    pub(super) fn pace(&self, from: f64, to: f64) -> f64 {
        let speed = self.mean_speed(from, to);
        let loads = self.loads.iter().map(|load| {
            let swing = load.swing(self.mass[0]);
            swing.frequency + swing.order * speed
        });
        loads.fold(speed, f64::max)
    }

    /// Mean speed of the shaft between two times, rad/s; with a drive, the highest one.
    fn mean_speed(&self, from: f64, to: f64) -> f64 {
        if self.is_driven() {
            return self.highest_speed();
        }
        let angle = self.speed.at(to).angle - self.speed.at(from).angle;
        angle / (to - from)
    }
}
