//! How near the balls of a mounted bearing are to their lift-off, and with what force it sets in.

use super::{Support, Vector5};
use crate::bearing::BearingRotation;
use crate::bearing::law::{BallLaw, ContactSpring, ForceLaw, with_law};

impl Support {
    /// Number of places, one a ball and all laminae of rollers, whose force is not smooth where they lift off: none of a
    /// linear bearing, and none behind films.
    pub(crate) fn balls_that_lift_off(&self) -> usize {
        match self.frozen {
            None if !self.law.is_smooth() => {
                self.ring.balls() * with_law!(&self.law, law => law.places())
            }
            _ => 0,
        }
    }

    /// Leaves how far each of these places is pressed past its lift-off, m, in `past`, ball 0 first of every place.
    pub(crate) fn past_lift_offs(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
        past: &mut [f64],
    ) {
        let place = self.settled(displacement, rotation);
        match self.table_at(&place, rotation.speed) {
            Some(table) => self.ring.past_lift_offs(table, &place, rotation, past),
            None => with_law!(&self.law, law => {
                self.ring.past_lift_offs(law, &place, rotation, past);
            }),
        }
    }

    /// How far one of these places is pressed past its lift-off, m.
    pub(crate) fn past_lift_off(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
        number: usize,
    ) -> f64 {
        let place = self.settled(displacement, rotation);
        match self.table_at(&place, rotation.speed) {
            Some(table) => self.ring.past_lift_off(table, &place, rotation, number),
            None => with_law!(&self.law, law => {
                self.ring.past_lift_off(law, &place, rotation, number)
            }),
        }
    }

    /// Largest approach that any ball has without inertia and film at a displacement, at any angle of the
    /// cage, m. A bound, which a ball comes to where the ring tilts towards the side to which it is shifted.
    ///
    /// `δ = hypot(|A1|, A2) − A` with the largest A1 and A2 around the ring; of rollers `|A1| sin α + A2 cos α + T L/2`.
    pub(crate) fn hertz_approach(&self, displacement: &Vector5, rotation: &BearingRotation) -> f64 {
        let place = self.settled(displacement, rotation);
        let [axial, radial] = self.ring.amplitudes(&place);
        let [along, across] = [axial, radial].map(|[middle, square]| middle.abs() + square.sqrt());
        let geometry = &self.definition.bearing.geometry;
        let Some(rollers) = geometry.rollers() else {
            return along.hypot(across) - geometry.groove_centre_distance();
        };
        let (sin, cos) = geometry.contact_angle().sin_cos();
        let tilt = place[3].hypot(place[4]);
        (along * sin + across * cos) + 0.5 * rollers.length * tilt
    }

    /// Largest load of one of these places so far past its lift-off in m, N; zero where the force is smooth there.
    pub(crate) fn load_past_lift_off(&self, distance: f64, speed: f64) -> f64 {
        if self.law.is_smooth() {
            return 0.0;
        }
        with_law!(&self.law, law => law.load_past_lift_off(distance, speed))
    }

    /// Load of a ball at an approach in m, N; zero where the force is smooth at its lift-off.
    pub(super) fn load_at(&self, approach: f64, speed: f64) -> f64 {
        if self.law.is_smooth() {
            return 0.0;
        }
        with_law!(&self.law, law => law.spring(speed).load_and_stiffness(approach).0)
    }

    /// Power of the distance past lift-off that the load of a ball sets in with.
    pub(crate) fn lift_off_exponent(&self) -> f64 {
        with_law!(&self.law, law => law.exponent())
    }

    /// Where a ball leaves and meets the inner race at a shaft speed in rad/s.
    pub(crate) fn contact_band(&self, speed: f64) -> ContactBand {
        let [permissible, _] = self.contacts.permissible_loads();
        let load = REGAINED_SHARE * permissible;
        with_law!(&self.law, law => {
            let spring = law.spring(speed);
            ContactBand {
                lost: spring.approach(LOST_SHARE * permissible),
                regained: spring.approach(load),
                load,
            }
        })
    }
}

/// Approaches at which a ball leaves the inner race and at which it meets it again.
///
/// They are those under two small loads, 1e-9 and 1e-8 of the permissible static load of the contact,
/// [`crate::bearing::permissible_static_load`]: some µN and some ten µN in a small bearing, whatever it carries
/// otherwise. Dry, that is where the surfaces touch, give or take a nanometre. Behind an oil film,
/// where no load is ever quite zero, it is where the film has faded: there the load falls with the
/// gap's 15th power, so that the choice of the loads hardly moves the place. That there are two keeps
/// a ball that rests in between from coming and going with round-off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactBand {
    /// Approach as in [`crate::bearing::BallContact::approach`] below which contact is lost, m.
    pub lost: f64,
    /// Approach above which contact is regained, m.
    pub regained: f64,
    /// Load at `regained`, N.
    pub load: f64,
}

/// Load at which contact is lost, of the permissible one.
const LOST_SHARE: f64 = 1e-9;
/// Load at which contact is regained, of the permissible one.
const REGAINED_SHARE: f64 = 1e-8;

#[cfg(test)]
mod tests {
    use crate::bearing::{Ball, BallLaw, HertzFilmLaw, MountedBearing, Oil, Support, catalogue};

    /// The approach of the band is that at which the law itself bears the load of the band.
    #[test]
    fn the_band_of_a_film_is_where_its_load_has_faded() {
        let bearing = catalogue::find("7205C").expect("an entry").bearing();
        let bearing = bearing.expect("a bearing");
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let mounted = MountedBearing {
            oil: Some(oil),
            ..MountedBearing::new(bearing)
        };
        let support = Support::new(&mounted, 0.0).expect("a support");
        let band = support.contact_band(700.0);
        let law = HertzFilmLaw::with_film(&bearing, oil, 0.0).expect("a law");
        let distance = bearing.geometry.groove_centre_distance() + band.regained;
        let contact = law.contact(&Ball::at(0.0, distance), 700.0);
        assert!((contact.load_inner / band.load - 1.0).abs() < 1e-9);
        assert!((contact.approach - band.regained).abs() < 1e-18);
        // micrometres apart, and wider than round-off by far
        assert!((-5e-6..-1e-7).contains(&band.regained), "{band:?}");
        assert!(
            (1e-8..1e-6).contains(&(band.regained - band.lost)),
            "{band:?}"
        );
    }
}
