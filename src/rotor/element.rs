//! What sits between the shaft and a housing or the ground.

use std::sync::Arc;

use fearless_simd::{Level, Simd};

use super::force_law::{ForceLaw, has_event};
use super::linear_law::LinearLaw;
use super::phases::Phases;
use super::point::Attachment;
use super::{CageMotion, FREEDOMS, Rotation};
use crate::bearing::{Angle, BearingRotation, CageJitter, Support, Vector5};

/// A law of force: the force that an element takes at a displacement of its inner place from its outer one, at the rate of
/// that displacement and a rotation of shaft and cage, all in the element's own orientation.
#[derive(Debug, Clone)]
pub(super) enum Element {
    /// A ball bearing. Its force is not linear, and nothing of it is in the linear part.
    BallBearing(Box<Support>),
    /// Springs and dampers of constant coefficients, which are in the linear part.
    Linear(Box<LinearLaw>),
    /// Any other law of force, nothing of which is in the linear part.
    Law(Arc<dyn ForceLaw>),
}

impl Element {
    /// Its law of force, where it is neither that of a ball bearing nor linear.
    pub fn law(&self) -> Option<&dyn ForceLaw> {
        match self {
            Self::Law(law) => Some(&**law),
            Self::BallBearing(_) | Self::Linear(_) => None,
        }
    }
}

/// An element in its place.
#[derive(Debug, Clone)]
pub(super) struct AttachedElement {
    pub attachment: Attachment,
    pub element: Element,
}

/// A ball bearing in its place.
#[derive(Debug, Clone, Copy)]
pub(super) struct AttachedBearing<'a> {
    pub attachment: &'a Attachment,
    pub support: &'a Support,
}

/// How an element moves at an instant, in its own orientation.
#[derive(Debug, Clone, Copy)]
pub(super) struct ElementMotion {
    /// Displacement of its inner place from its outer one.
    pub displacement: Vector5,
    /// Rate of that displacement.
    pub rate: Vector5,
    /// The rotation that it sees.
    pub rotation: BearingRotation,
}

/// The motion of a structure at an instant.
#[derive(Clone, Copy)]
pub(super) struct Instant<'a> {
    /// q: the degrees of freedom, with or without the held coordinates that follow them.
    pub place: &'a [f64],
    /// q̇, as long as `place`.
    pub velocity: &'a [f64],
    /// All coordinates at the static equilibrium: those that `place` lacks are held there.
    pub rest: &'a [f64],
    /// Angle ψ and speed ω of the shaft.
    pub rotation: &'a Rotation,
    /// Sines and cosines of ψ and of the first bearing's cage.
    pub phases: Phases,
}

/// The elements of a shaft, in the order of the scene.
#[derive(Debug, Clone)]
pub(super) struct Elements {
    all: Vec<AttachedElement>,
    /// Vector instructions of the processor.
    pub level: Level,
    /// How the cages go round.
    pub cage: CageMotion,
    /// Whether all of them sit between a rigid shaft and the ground, and nothing else is elastic.
    pub on_rigid_shaft: bool,
    /// Whether any force depends on rates: of bearings with damped contacts, or of other laws.
    pub by_rate: bool,
    /// Number of balls whose force is not smooth where they lift off.
    pub balls_that_lift_off: usize,
    /// Number of laws with an event surface.
    pub law_event_count: usize,
    /// Speed of the first bearing's cage over that of the shaft: its sine is found along with the shaft's, and serves every
    /// cage that turns as fast.
    first_cage_ratio: f64,
}

impl Elements {
    pub fn new(all: Vec<AttachedElement>, cage: CageMotion, on_rigid_shaft: bool) -> Self {
        let mut elements = Self {
            all,
            level: Level::new(),
            cage,
            on_rigid_shaft,
            by_rate: false,
            balls_that_lift_off: 0,
            law_event_count: 0,
            first_cage_ratio: 0.0,
        };
        let damped = elements.supports().any(Support::is_damped);
        elements.by_rate = damped || elements.laws().next().is_some();
        elements.law_event_count = elements.laws().filter(|(_, law)| has_event(*law)).count();
        let lifting = elements.supports().map(Support::balls_that_lift_off);
        elements.balls_that_lift_off = lifting.sum();
        let first = elements.supports().next();
        elements.first_cage_ratio = first.map_or(0.0, Support::cage_ratio);
        elements
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// The ball bearings.
    #[inline(always)]
    pub fn bearings(&self) -> impl Iterator<Item = AttachedBearing<'_>> + Clone {
        self.all
            .iter()
            .filter_map(|attached| match &attached.element {
                Element::BallBearing(support) => Some(AttachedBearing {
                    attachment: &attached.attachment,
                    support,
                }),
                Element::Linear(_) | Element::Law(_) => None,
            })
    }

    /// The other laws of force.
    pub fn laws(&self) -> impl Iterator<Item = (&Attachment, &dyn ForceLaw)> {
        self.all
            .iter()
            .filter_map(|own| Some((&own.attachment, own.element.law()?)))
    }

    /// The laws of force with a clearance, m, and their numbers among the elements of the scene, from 1.
    pub fn clearances(&self) -> impl Iterator<Item = (usize, &Attachment, f64)> {
        // behind the bearings
        let behind = self.all.iter().skip(self.bearings().count());
        behind.zip(1..).filter_map(|(own, number)| {
            let clearance = own.element.law()?.clearance()?;
            Some((number, &own.attachment, clearance))
        })
    }

    /// The other laws of force with their motions at an instant.
    pub fn laws_at<'a>(
        &'a self,
        at: &'a Instant<'a>,
    ) -> impl Iterator<Item = (&'a Attachment, &'a dyn ForceLaw, ElementMotion)> {
        self.laws().map(|(attachment, law)| {
            let seen = BearingRotation::at_start(at.rotation.speed);
            (attachment, law, attachment.motion(at, seen))
        })
    }

    /// The ball bearings by themselves.
    pub fn supports(&self) -> impl Iterator<Item = &Support> + Clone {
        self.bearings().map(|bearing| bearing.support)
    }

    /// The ball bearings and their places, to be changed.
    pub fn bearings_mut(&mut self) -> impl Iterator<Item = (&Attachment, &mut Support)> {
        self.all
            .iter_mut()
            .filter_map(|attached| match &mut attached.element {
                Element::BallBearing(support) => Some((&attached.attachment, &mut **support)),
                Element::Linear(_) | Element::Law(_) => None,
            })
    }

    /// Sines and cosines of the shaft and of the first bearing's cage.
    #[inline(always)]
    pub fn phases(&self, rotation: &Rotation) -> Phases {
        Phases::new(rotation, self.first_cage_ratio)
    }

    /// Hands every element with its motion at an instant to `take`.
    pub fn visit(&self, at: &Instant<'_>, mut take: impl FnMut(&AttachedElement, &ElementMotion)) {
        for attached in &self.all {
            take(attached, &attached.motion(at));
        }
    }

    /// The ball bearings with their motions at an instant.
    pub fn bearings_at<'a>(
        &'a self,
        at: &'a Instant<'a>,
    ) -> impl Iterator<Item = (AttachedBearing<'a>, ElementMotion)> {
        self.bearings().map(|bearing| (bearing, bearing.motion(at)))
    }

    /// Adds −Bᵀ F of every ball bearing and law to the forces on the degrees of freedom: F holds its inner ring, −F acts on the
    /// shaft. Elements of constant coefficients are in the linear part.
    #[inline(always)]
    pub fn add_forces<S: Simd>(&self, simd: S, at: &Instant<'_>, sum: &mut [f64]) {
        if self.by_rate {
            return self.add_forces_by_rate(at, sum);
        }
        for bearing in self.bearings() {
            // u = B q, F(u, ψ_c), −Bᵀ F
            let displacement = bearing.attachment.displacement(at.place, at.rest);
            let rotation = seen_by(bearing.support, at.rotation, &at.phases);
            let holding = bearing.support.force_by(simd, &displacement, &rotation);
            bearing.attachment.add_force(-1.0, &holding, sum);
        }
    }

    /// Does the work of [`Elements::add_forces`] where forces depend on rates. Out of line, so that the usual path stays
    /// short.
    #[inline(never)]
    fn add_forces_by_rate(&self, at: &Instant<'_>, sum: &mut [f64]) {
        for (bearing, motion) in self.bearings_at(at) {
            let [elastic, damping] =
                bearing
                    .support
                    .damped_force(&motion.displacement, &motion.rate, &motion.rotation);
            let force = std::array::from_fn(|axis| elastic[axis] + damping[axis]);
            bearing.attachment.add_force(-1.0, &force, sum);
        }
        for (attachment, law, motion) in self.laws_at(at) {
            attachment.add_force(-1.0, &law.force(&motion), sum);
        }
    }

    /// Force +F of a rigid shaft onto all its ball bearings, moments about its centre of mass, N and N m: as
    /// [`Elements::add_forces`] with the opposite sign, for bearings on the ground whose forces depend on no rate.
    #[inline(always)]
    pub fn force_of_rigid_shaft<S: Simd>(
        &self,
        simd: S,
        shaft: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        // the force of a single one needs no sum in memory, which takes time that is seen
        if let [only] = &self.all[..] {
            return only.force_of_rigid_shaft(simd, shaft, rotation, phases);
        }
        let mut sum = [0.0; FREEDOMS];
        for attached in &self.all {
            let force = attached.force_of_rigid_shaft(simd, shaft, rotation, phases);
            for axis in 0..FREEDOMS {
                sum[axis] += force[axis];
            }
        }
        sum
    }
}

impl AttachedElement {
    /// Force of a rigid shaft onto a ball bearing on the ground, moments about the centre of mass; zero of an element that
    /// is in the linear part.
    #[inline(always)]
    fn force_of_rigid_shaft<S: Simd>(
        &self,
        simd: S,
        shaft: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        match &self.element {
            Element::BallBearing(support) => {
                let displacement = self.attachment.displacement_by_shaft(shaft);
                let seen = seen_by(support, rotation, phases);
                let force = support.force_by(simd, &displacement, &seen);
                self.attachment.about_observed(&force)
            }
            Element::Linear(_) | Element::Law(_) => [0.0; FREEDOMS],
        }
    }

    /// Its motion at an instant.
    fn motion(&self, at: &Instant<'_>) -> ElementMotion {
        let rotation = match &self.element {
            Element::BallBearing(support) => seen_by(support, at.rotation, &at.phases),
            // no other force depends on an angle
            Element::Linear(_) | Element::Law(_) => BearingRotation::at_start(at.rotation.speed),
        };
        self.attachment.motion(at, rotation)
    }
}

impl AttachedBearing<'_> {
    /// dψ_c/dψ, how far its cage turns with the shaft, at an angle ψ of the shaft.
    pub fn cage_rate(&self, angle: f64) -> f64 {
        let ratio = self.support.cage_ratio();
        let jitter = self.support.cage_jitter();
        ratio * (1.0 + jitter.map_or(0.0, |jitter| jitter.at(ratio * angle)[1]))
    }

    /// Its motion at an instant.
    pub fn motion(&self, at: &Instant<'_>) -> ElementMotion {
        let rotation = seen_by(self.support, at.rotation, &at.phases);
        self.attachment.motion(at, rotation)
    }
}

impl Attachment {
    /// Motion of an element there at an instant, which sees a rotation.
    fn motion(&self, at: &Instant<'_>, rotation: BearingRotation) -> ElementMotion {
        ElementMotion {
            displacement: self.displacement(at.place, at.rest),
            rate: self.rate(at.velocity),
            rotation,
        }
    }
}

/// The rotation that a bearing sees. A cage as fast as the first one shares its sine; that of a cage with jitter is its
/// own.
#[inline(always)]
pub(super) fn seen_by(support: &Support, rotation: &Rotation, phases: &Phases) -> BearingRotation {
    let ratio = support.cage_ratio();
    if let Some(jitter) = support.cage_jitter() {
        return seen_with_jitter(jitter, ratio, rotation, phases);
    }
    BearingRotation {
        cage: if ratio == phases.ratio {
            phases.cage
        } else {
            Angle::new(ratio * rotation.angle)
        },
        shaft: phases.shaft,
        cage_angle: ratio * rotation.angle,
        cage_speed: ratio * rotation.speed,
        speed: rotation.speed,
    }
}

/// The rotation that a bearing sees whose cage wanders by ε about an even turn: ψ_c = r ψ + ε(r ψ), ω_c = r ω (1 + ε′).
#[inline(never)]
fn seen_with_jitter(
    jitter: &CageJitter,
    ratio: f64,
    rotation: &Rotation,
    phases: &Phases,
) -> BearingRotation {
    let nominal = ratio * rotation.angle;
    let [ahead, slope] = jitter.at(nominal);
    BearingRotation {
        cage: Angle::new(nominal + ahead),
        shaft: phases.shaft,
        cage_angle: nominal + ahead,
        cage_speed: ratio * rotation.speed * (1.0 + slope),
        speed: rotation.speed,
    }
}
