//! A mounted bearing as a restoring force on the shaft.
//!
//! `force` has the entries for its force and slopes, `damping` what resists the rate of the contacts, `lift_off` where
//! balls part from a race, `rolling` how they go round, `surfaces` what imperfect surfaces add, `table` the law as
//! polynomials, `assessment` all that is known of it in one place.

mod assessment;
mod damping;
mod force;
mod lift_off;
mod linear_force;
mod rolling;
mod surfaces;
mod table;

pub(crate) use assessment::LOADED_SHARE;
pub(crate) use lift_off::ContactBand;

use super::bearing_friction::BearingFriction;
use super::cage::Cage;
use super::law::{BallTable, Law};
use super::seat::Seat;
use super::{
    BallLoads, BearingError, CageJitter, ContactLaw, FrictionMoment, Geometry, Matrix5,
    MountedBearing, Preload, RaceContacts, RaceFilms, Ring, Vector5,
};
use linear_force::LinearForce;

/// A mounted bearing, ready to answer with forces.
///
/// Displacements are those that shaft and housing impose: of the inner ring's place from the outer one's. Forces are those
/// on the inner ring. Both are in the bearing's own orientation, in which a positive axial force loads it: where it sits on
/// the shaft, and which way it faces, is known to the shaft alone.
#[derive(Debug, Clone)]
pub struct Support {
    pub(super) ring: Ring,
    law: Law,
    /// Oil films of both races, where there are any: those of rollers are known, and part nothing.
    films: Option<RaceFilms>,
    /// Answers in place of the law where a motion asks for forces, once compiled.
    table: Option<Box<BallTable>>,
    pub(super) seat: Seat,
    /// Contacts at the free contact angle.
    contacts: RaceContacts,
    /// Contacts at the nominal contact angle.
    rated_contacts: RaceContacts,
    /// Coefficients of the damping of the contacts, inner race first, s/m, where there is damping.
    damped: Option<[f64; 2]>,
    friction: BearingFriction,
    pub(super) cage: Cage,
    pub(super) cage_jitter: Option<CageJitter>,
    /// Set once the bearing is linear.
    frozen: Option<LinearForce>,
    pub(super) definition: MountedBearing,
}

impl Support {
    /// Builds the ring of a bearing, fastest at `speed` in rad/s, and finds the seat of its preload.
    ///
    /// A bearing of the linear law starts as Hertz, too, until [`Support::freeze`] knows where.
    ///
    /// # Errors
    /// [`BearingError`] where the contact cannot be formed or the preload cannot be reached.
    pub fn new(definition: &MountedBearing, speed: f64) -> Result<Self, BearingError> {
        let contacts = definition.bearing.contacts()?;
        let rated_contacts = definition.bearing.rated_contacts()?;
        let (geometry, imperfections) = (&definition.bearing.geometry, &definition.imperfections);
        imperfections.check(geometry)?;
        let law = Law::new(definition, &contacts, speed)?;
        let bearing = &definition.bearing;
        let films = match &contacts {
            RaceContacts::Point(contacts) => {
                let oil = definition.oil.as_ref();
                oil.map(|oil| RaceFilms::new(bearing, contacts, oil))
            }
            RaceContacts::Line(contacts) => {
                let oil = bearing.lubrication.map(|lubrication| lubrication.oil);
                oil.map(|oil| RaceFilms::of_rollers(bearing, contacts.length(), &oil))
            }
        };
        let films = films.transpose()?;
        let cage = Cage::new(
            &definition.bearing,
            geometry.gamma(),
            imperfections.cage_slip,
        );
        let mut support = Self {
            ring: Ring::new(geometry, definition.first_ball),
            contacts,
            damped: definition.contact_damping.coefficients()?,
            friction: BearingFriction::new(definition, &rated_contacts),
            rated_contacts,
            seat: Seat::new(definition, &law)?,
            law,
            films,
            table: None,
            cage,
            cage_jitter: CageJitter::new(&imperfections.cage_steps, geometry.balls()),
            frozen: None,
            definition: definition.clone(),
        };
        support.turn_with(cage);
        Ok(support)
    }

    /// Largest value of a dimension among the bearings of a shaft, m; 10 mm where none has balls: it makes numbers of
    /// displacements, and any length does.
    pub(crate) fn largest<'a>(
        supports: impl IntoIterator<Item = &'a Self>,
        dimension: fn(&Geometry) -> f64,
    ) -> f64 {
        let own = |support: &Self| dimension(&support.definition.bearing.geometry);
        supports
            .into_iter()
            .map(own)
            .reduce(f64::max)
            .unwrap_or(0.01)
    }

    /// The bearing as it was defined.
    pub(crate) fn definition(&self) -> &MountedBearing {
        &self.definition
    }

    /// Elastic contacts of its balls, for ratings and reports.
    pub(crate) fn contacts(&self) -> &RaceContacts {
        &self.contacts
    }

    /// Stiffness of a loaded contact by its order of magnitude, N/m: that of a ball pressed in by a thousandth of
    /// [`Geometry::length_scale`].
    pub(crate) fn contact_stiffness(&self) -> f64 {
        let distance = self.definition.bearing.geometry.length_scale();
        self.contacts.stiffness_at(1e-3 * distance)
    }

    /// Angle left from the end of the contact of a ball with the inner (0) or the outer (1) race to the shoulder, rad, at a
    /// contact angle in rad and a load in N; negative where the contact is cut off, none where no shoulder is known.
    pub(crate) fn shoulder_margin(&self, race: usize, angle: f64, load: f64) -> Option<f64> {
        let shoulder_angle = self.definition.bearing.shoulder_angle?;
        let reach = self.contacts.reach(race, load)?;
        Some(shoulder_angle - angle.abs() - reach)
    }

    /// Whether the bearing is preset axially, apart from what fits and temperatures do.
    pub(crate) fn is_preloaded(&self) -> bool {
        let fit = self.definition.bearing.fit.and_then(|fit| fit.axial_offset);
        if let Some([before, _]) = fit {
            return before != 0.0;
        }
        match self.definition.preload {
            Preload::AxialOffset(value) | Preload::Force(value) | Preload::Spring(value) => {
                value != 0.0
            }
        }
    }

    /// Axial preset of the inner ring when the shaft is in its place, m.
    pub(crate) fn axial_preset(&self) -> f64 {
        self.seat.offset()
    }

    /// Axial displacement at which the races of this bearing are axially centred, m.
    pub(crate) fn centred_axial(&self) -> f64 {
        -self.definition.bearing.geometry.free_axial() - self.seat.offset()
    }

    /// Whether the balls go round with the cage: those of a linear bearing are frozen.
    pub(crate) fn follows_cage(&self) -> bool {
        self.frozen.is_none()
    }

    /// Number of balls whose loads [`Support::force_and_loads`] gives; none where the bearing is frozen: a linear law
    /// knows no balls.
    pub(crate) fn known_balls(&self) -> usize {
        match self.frozen {
            Some(_) => 0,
            None => self.ring.balls(),
        }
    }

    /// Room for the loads of its balls, with their angles, and of the slices of its rollers where it has a rating.
    pub(crate) fn room_for_loads(&self, angles: bool) -> BallLoads {
        let bearing = &self.definition.bearing;
        let rollers = bearing.geometry.rollers();
        let rollers = rollers.filter(|_| bearing.dynamic_rating.is_some());
        let slices = rollers.map_or(0, |rollers| rollers.laminae);
        BallLoads::new(self.known_balls(), angles).with_slices(slices)
    }

    /// Friction moment under a force of the shaft onto this bearing in N at a speed in rad/s.
    pub(crate) fn friction_moment(&self, force: &Vector5, speed: f64) -> FrictionMoment {
        self.friction.moment(force, speed)
    }
}
