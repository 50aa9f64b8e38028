//! When a ball counts as in contact with the inner race.

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

impl ContactBand {
    /// From the permissible load at the inner race in N and the approach there under a load.
    pub(super) fn new(permissible: f64, approach: impl Fn(f64) -> f64) -> Self {
        let load = REGAINED_SHARE * permissible;
        Self {
            lost: approach(LOST_SHARE * permissible),
            regained: approach(load),
            load,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::bearing::{
        Ball, BallLaw, ContactDamping, ContactLaw, Facing, HertzFilmLaw, Imperfections,
        MountedBearing, Oil, Preload, Support, catalogue,
    };

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
            bearing,
            law: ContactLaw::Hertz,
            oil: Some(oil),
            position: 0.0,
            facing: Facing::PlusZ,
            preload: Preload::AxialOffset(0.0),
            contact_damping: ContactDamping::default(),
            first_ball: 0.0,
            imperfections: Imperfections::default(),
            housing: None,
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
