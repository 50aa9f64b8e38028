//! What the surfaces of a mounted bearing add where they are not perfect.

use fearless_simd::{Fallback, Simd};

use super::law::with_law;
use super::ring::{Balls, Consumer, LaneVector, side_by_side};
use super::support::Support;
use super::surface::{ImperfectSurfaces, TurningSurfaces};
use super::{BallLaw, BearingRotation, Passing, RacePass, Ring, Vector5};

impl Support {
    /// Whether any surface of the bearing differs from a perfect one.
    pub(crate) fn is_imperfect(&self) -> bool {
        self.ring.surfaces.is_some()
    }

    /// When balls pass the places at which the force is not smooth because of a defect.
    pub(crate) fn passings(&self) -> &[Passing] {
        let surfaces = self.ring.surfaces.as_deref();
        surfaces.map_or(&[], ImperfectSurfaces::passings)
    }

    /// Spalls of the races whose edges alone balls meet, at equal angles of a cage that turns evenly; none of one that wanders.
    pub(crate) fn race_passes(&self) -> impl Iterator<Item = RacePass> + '_ {
        let own = &self.definition;
        let defects = own.imperfections.defects.iter();
        let defects = defects.filter(|_| self.cage_walk().is_none());
        defects.filter_map(|defect| {
            defect.race_pass(&own.bearing.geometry, own.first_ball, own.position)
        })
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
        with_law!(&self.law, law => {
            let simd = Fallback::new();
            let [place, rate] = motion.map(|vector| side_by_side(simd, &vector));
            let mut moments = SurfaceMoments {
                law,
                ring: &self.ring,
                surfaces,
                coefficients,
                rate: &rate,
                rotation,
                cage_ratio,
                sums: [0.0; 2],
            };
            self.ring.visit(simd, &place, rotation, &mut moments);
            moments.sums
        })
    }

    /// Upper bound of the change of a ball's load, N, at a distance in m past a kink of a defect, at a speed in rad/s.
    pub(crate) fn load_past_kink(&self, distance: f64, speed: f64) -> f64 {
        // slopes of drops stay below one: no ball of a bearing sinks into a slot as steep as that
        let [drop, further] = [0.0, distance].map(|distance| self.largest_drop() + distance);
        self.load_past_lift_off(further, speed) - self.load_past_lift_off(drop, speed)
    }
}

/// The moments, ball by ball.
struct SurfaceMoments<'a, L, S: Simd> {
    law: &'a L,
    ring: &'a Ring,
    surfaces: &'a ImperfectSurfaces,
    coefficients: [f64; 2],
    rate: &'a LaneVector<S>,
    rotation: &'a BearingRotation,
    cage_ratio: f64,
    sums: [f64; 2],
}

impl<L: BallLaw, S: Simd> Consumer<S> for SurfaceMoments<'_, L, S> {
    fn take(&mut self, at: &Balls<S>) {
        let [axial, radial] = self.ring.components([0.0; 2], self.rate, [at.cos, at.sin]);
        let per_angle = self.surfaces.rates(
            at.first,
            [&at.cos, &at.sin],
            self.rotation,
            [self.cage_ratio, 1.0],
        );
        let speed = self.rotation.speed;
        for (number, ball) in at.single(self.ring.balls()) {
            let lane = number - at.first;
            let [inner, outer] = [per_angle[0][lane], per_angle[1][lane]];
            let rates = [axial[lane], radial[lane], speed * inner, speed * outer];
            let response = self.law.response(&ball.with_slopes_by::<4>(), speed);
            let approaches = self.law.elastic_approaches(&response);
            for (race, by_angle) in [inner, outer].into_iter().enumerate() {
                let load = response.load[race].value;
                self.sums[0] += load * by_angle;
                let slopes = approaches[race].slopes;
                let rate: f64 = slopes
                    .iter()
                    .zip(rates)
                    .map(|(slope, rate)| slope * rate)
                    .sum();
                let damped = load * (self.coefficients[race] * rate).max(-1.0);
                self.sums[1] -= damped * (slopes[2] * inner + slopes[3] * outer);
            }
        }
    }
}
