//! How the balls of a mounted bearing go round.

use super::{Cage, CageJitter, MountedBearing, Support, Vector5};
use crate::bearing::cage::rolling_ratio;
use crate::bearing::surface::ImperfectSurfaces;
use crate::bearing::{BearingRotation, CageMotion};
use crate::physics::{BallPass, Race};

impl Support {
    /// Lets the balls go round as from an equilibrium at a displacement and a speed in rad/s; where there is no
    /// equilibrium, as without load.
    pub(crate) fn roll(&mut self, motion: CageMotion, displacement: Option<&Vector5>, speed: f64) {
        self.turn_with(self.cage_at(motion, displacement, speed));
    }

    /// Lets the balls go round with a cage.
    pub(super) fn turn_with(&mut self, cage: Cage) {
        self.cage = cage;
        let own = &self.definition;
        let rolling = cage.rolling_ratio(&own.bearing);
        let surfaces =
            ImperfectSurfaces::new(&own.imperfections, &own.bearing, own.first_ball, rolling);
        self.ring.surfaces = surfaces.map(Box::new);
    }

    /// The cage of an equilibrium.
    ///
    /// ```text
    /// γ = (D/d_m) Σ Q_j (cos α_ij + cos α_oj)/2 / Σ Q_j        Q_j load of ball j at the inner race
    /// ```
    pub(super) fn cage_at(
        &self,
        motion: CageMotion,
        displacement: Option<&Vector5>,
        speed: f64,
    ) -> Cage {
        let geometry = &self.definition.bearing.geometry;
        let nominal = geometry.nominal_angle().cos();
        let gamma = match (motion, displacement) {
            (CageMotion::Rolling | CageMotion::Frozen, _) => geometry.gamma(),
            (CageMotion::Operating, None) => geometry.gamma_at(nominal),
            (CageMotion::Operating, Some(displacement)) => {
                let cosine = self.operating_cosine(displacement, speed);
                geometry.gamma_at(cosine.unwrap_or(nominal))
            }
        };
        let slip = match motion.turns() {
            true => self.definition.imperfections.cage_slip,
            false => 1.0,
        };
        Cage::new(&self.definition.bearing, gamma, slip)
    }

    /// Mean of cos α over the balls, weighted by their loads; none without load.
    fn operating_cosine(&self, displacement: &Vector5, speed: f64) -> Option<f64> {
        let (mut moment, mut load) = (0.0, 0.0);
        let place = self.settled(displacement, &BearingRotation::at_start(speed));
        for ball in self.around(&place, speed, None) {
            let contact = ball.contact;
            let cosine = 0.5 * (contact.angle_inner.cos() + contact.angle_outer.cos());
            moment += contact.load_inner * cosine;
            load += contact.load_inner;
        }
        (load > 0.0).then(|| moment / load)
    }

    /// The bearing as it starts with its shaft and its cage at these angles in rad.
    pub(crate) fn turned(&self, shaft: f64, cage: f64) -> MountedBearing {
        let own = &self.definition;
        let turning = own.bearing.rotating_ring;
        let past_outer = match turning {
            Race::Inner => cage,
            Race::Outer => cage - shaft,
        };
        let rolled = rolling_ratio(&own.bearing.geometry, self.cage.gamma) * past_outer;
        MountedBearing {
            first_ball: own.first_ball + cage,
            imperfections: own.imperfections.turned(turning, shaft, rolled),
            ..own.clone()
        }
    }

    /// Speed of the cage over that of the shaft.
    #[inline]
    pub(crate) fn cage_ratio(&self) -> f64 {
        self.cage.ratio
    }

    /// How the cage wanders, where it does.
    #[inline]
    pub(crate) fn cage_jitter(&self) -> Option<&CageJitter> {
        self.cage_jitter.as_ref()
    }

    /// Ball-pass frequencies at a speed of the shaft in rad/s, with the cage as it turns.
    pub(crate) fn ball_pass(&self, speed: f64) -> BallPass {
        self.cage.ball_pass(&self.definition.bearing, speed)
    }

    /// Ball-pass frequencies at the nominal contact angle, without slip, at a speed of the shaft in rad/s.
    pub(crate) fn nominal_ball_pass(&self, speed: f64) -> BallPass {
        self.definition.bearing.rolling_ball_pass(0.0, speed)
    }

    /// Balls of a row that pass a point at rest, a revolution.
    pub(crate) fn passes(&self) -> f64 {
        self.definition.bearing.geometry.balls() as f64 * self.cage.ratio
    }
}
