//! What the surfaces of a mounted bearing add where they are not perfect.

use super::{Support, Vector5};
use crate::bearing::law::with_law;
use crate::bearing::number::LANES;
use crate::bearing::ring::side_by_side;
use crate::bearing::surface::{ImperfectSurfaces, TurningSurfaces};
use crate::bearing::{Ball, BallLaw, BearingRotation, Passing, RaceSpall};
use crate::numerics::registers::in_baseline_registers;

impl Support {
    /// Whether any surface of the bearing differs from a perfect one.
    pub(crate) fn is_imperfect(&self) -> bool {
        self.ring.surfaces.is_some()
    }

    /// When balls pass the places at which the force is not smooth because of a defect.
    pub(crate) fn passings(&self) -> &[Passing] {
        let surfaces = self.ring.surfaces.as_deref();
        surfaces.map_or(&[], |surfaces| &surfaces.passings)
    }

    /// Spalls of the races whose edges alone balls meet.
    pub(crate) fn race_spalls(&self) -> impl Iterator<Item = RaceSpall> + '_ {
        let own = &self.definition;
        let defects = own.imperfections.defects.iter();
        defects.filter_map(|defect| defect.race_spall(&own.bearing))
    }

    /// Which of its surfaces turn.
    pub(crate) fn surfaces_that_turn(&self) -> TurningSurfaces {
        let surfaces = self.ring.surfaces.as_deref();
        surfaces.map_or_else(TurningSurfaces::default, ImperfectSurfaces::turning)
    }

    /// Sum of the largest drops of all surfaces, m.
    pub(crate) fn largest_drop(&self) -> f64 {
        let surfaces = self.ring.surfaces.as_deref();
        surfaces.map_or(0.0, ImperfectSurfaces::bound)
    }

    /// Moments, N m, that balls exert on a shaft whose cage turns by a ratio of its angle as the surfaces under them fall,
    /// through their elastic contacts and through the damping of these:
    ///
    /// ```text
    /// M = Σ_j Q_i ∂h_i/∂ψ + Q_o ∂h_o/∂ψ        M_d = −Σ_j Σ_races F_d (∂δ/∂h_i ∂h_i/∂ψ + ∂δ/∂h_o ∂h_o/∂ψ)
    /// ```
    ///
    /// What the contacts store is less by the work of the first, and the second takes part in what they dissipate.
    pub(crate) fn surface_moments(
        &self,
        motion: [&Vector5; 2],
        rotation: &BearingRotation,
        cage_ratio: f64,
    ) -> [f64; 2] {
        let Some(surfaces) = self.ring.surfaces.as_deref() else {
            return [0.0; 2];
        };
        let motion = self.ring_motion(motion, rotation);
        let coefficients = self.damped.unwrap_or_default();
        with_law!(&self.law, law => in_baseline_registers!(simd => {
            let [place, rate] = motion.map(|vector| side_by_side(simd, &vector));
            let mut moments = [0.0; 2];
            self.ring.visit(simd, &place, rotation, |at| {
                let directions = [at.cos, at.sin, at.side];
                let [axial, radial, tilt] = self.ring.components([0.0; 2], &rate, directions);
                let directions: [&[f64; LANES]; 2] = [&at.cos, &at.sin];
                let ratios = [cage_ratio, 1.0];
                let [by_inner, by_outer] = surfaces.rates(at.first, directions, rotation, ratios);
                for (number, ball) in at.single(self.ring.balls()) {
                    let lane = number - at.first;
                    let by_angle = [by_inner[lane], by_outer[lane]];
                    let rate = Ball {
                        axial: axial[lane],
                        radial: radial[lane],
                        tilt: tilt[lane],
                        drop: by_angle.map(|by_angle| rotation.speed * by_angle),
                    };
                    let response = law.response(&ball, rotation.speed);
                    let (_, resisting) =
                        law.damped::<_, 4>(&ball, &rate, coefficients, rotation.speed);
                    for (race, by_angle) in by_angle.into_iter().enumerate() {
                        moments[0] += response.load[race] * by_angle;
                        moments[1] -= resisting.drop[race] * by_angle;
                    }
                }
            });
            moments
        }))
    }

    /// Upper bound of the change of a ball's load, N, at a distance in m past a kink of a defect, at a speed in rad/s.
    pub(crate) fn load_past_kink(&self, distance: f64, speed: f64) -> f64 {
        // slopes of drops stay below one: no ball of a bearing sinks into a slot as steep as that
        let [drop, further] = [0.0, distance].map(|distance| self.largest_drop() + distance);
        self.load_at(further, speed) - self.load_at(drop, speed)
    }
}
