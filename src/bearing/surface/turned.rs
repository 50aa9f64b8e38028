//! Imperfect surfaces with shaft and cage at other angles than at the start.

use super::surfaces::rolling_ratio;
use super::{Imperfections, Surface};
use crate::bearing::MountedBearing;

impl MountedBearing {
    /// The same bearing that starts with its shaft and its cage at these angles in rad.
    pub(crate) fn turned(&self, shaft: f64, cage: f64) -> Self {
        let rolled = rolling_ratio(&self.bearing.geometry) * cage;
        Self {
            first_ball: self.first_ball + cage,
            imperfections: self.imperfections.turned(shaft, rolled),
            ..self.clone()
        }
    }
}

impl Imperfections {
    /// The same with the inner race and the balls turned by angles in rad, the balls past the place where they meet the outer
    /// race.
    fn turned(&self, inner: f64, balls: f64) -> Self {
        let mut turned = self.clone();
        let by = |on: Surface| match on {
            Surface::Outer => 0.0,
            Surface::Inner => inner,
            Surface::Ball(_) => -balls,
        };
        for defect in &mut turned.defects {
            defect.angle += by(defect.on);
        }
        for (on, wave) in &mut turned.waves {
            // A cos(n (θ − ψ) + φ)
            wave.phase -= f64::from(wave.order) * by(*on);
        }
        turned
    }
}
