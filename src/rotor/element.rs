//! What sits between the shaft and a housing or the ground.

use fearless_simd::{Level, Simd};

use super::linear_bearing::LinearElement;
use super::phases::Phases;
use super::point::Attachment;
use super::{CageMotion, FREEDOMS, Rotation};
use crate::bearing::{Angle, BearingRotation, CageJitter, Support, Vector5};

/// An element between two places, in its own orientation: its force by the displacement of its inner place from its outer
/// one, the rate of this, and the rotation of shaft and cage.
#[derive(Debug, Clone)]
pub(super) enum Element {
    /// A ball bearing. Its force is not linear, and nothing of it is in the linear part.
    BallBearing(Box<Support>),
    /// Springs and dampers of constant coefficients, which are in the linear part.
    Linear(Box<LinearElement>),
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

/// The places and velocities of a structure at an instant.
#[derive(Clone, Copy)]
pub(super) struct Instant<'a> {
    /// Of the degrees of freedom, or of all coordinates.
    pub place: &'a [f64],
    /// Likewise.
    pub velocity: &'a [f64],
    /// Place of all coordinates at the static equilibrium, where held ones stay.
    pub rest: &'a [f64],
    pub rotation: &'a Rotation,
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
    /// Whether the contacts of any bearing are damped.
    pub contacts_damped: bool,
    /// Number of balls whose force is not smooth where they lift off.
    pub balls_that_lift_off: usize,
    /// Speed of the first bearing's cage over that of the shaft.
    leading_ratio: f64,
}

impl Elements {
    pub fn new(all: Vec<AttachedElement>, cage: CageMotion, on_rigid_shaft: bool) -> Self {
        let mut elements = Self {
            all,
            level: Level::new(),
            cage,
            on_rigid_shaft,
            contacts_damped: false,
            balls_that_lift_off: 0,
            leading_ratio: 0.0,
        };
        let supports = || elements.supports();
        (
            elements.contacts_damped,
            elements.balls_that_lift_off,
            elements.leading_ratio,
        ) = (
            supports().any(Support::is_damped),
            supports().map(Support::balls_that_lift_off).sum(),
            supports().next().map_or(0.0, Support::cage_ratio),
        );
        elements
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// The ball bearings.
    #[inline(always)]
    pub fn bearings(&self) -> impl Iterator<Item = AttachedBearing<'_>> + Clone {
        self.all.iter().filter_map(|own| match &own.element {
            Element::BallBearing(support) => Some(AttachedBearing {
                attachment: &own.attachment,
                support,
            }),
            Element::Linear(_) => None,
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
            .filter_map(|own| match &mut own.element {
                Element::BallBearing(support) => Some((&own.attachment, &mut **support)),
                Element::Linear(_) => None,
            })
    }

    /// Sines and cosines of shaft and cages.
    #[inline(always)]
    pub fn phases(&self, rotation: &Rotation) -> Phases {
        Phases::new(rotation, self.leading_ratio)
    }

    /// Hands every element with its motion at an instant to `take`.
    pub fn visit(&self, at: &Instant<'_>, mut take: impl FnMut(&AttachedElement, &ElementMotion)) {
        for own in &self.all {
            take(own, &own.motion(at));
        }
    }

    /// The ball bearings with their motions at an instant.
    pub fn bearings_at<'a>(
        &'a self,
        at: &'a Instant<'a>,
    ) -> impl Iterator<Item = (AttachedBearing<'a>, ElementMotion)> {
        self.bearings().map(|bearing| (bearing, bearing.motion(at)))
    }

    /// Adds the forces of what is not linear on the degrees of freedom.
    #[inline(always)]
    pub fn add_forces<S: Simd>(&self, simd: S, at: &Instant<'_>, sum: &mut [f64]) {
        if self.contacts_damped {
            return self.add_damped_forces(at, sum);
        }
        for bearing in self.bearings() {
            let displacement = bearing.attachment.displacement(at.place, at.rest);
            let rotation = seen_by(bearing.support, at.rotation, &at.phases);
            let held = bearing.support.force_by(simd, &displacement, &rotation);
            bearing.attachment.add_force(-1.0, &held, sum);
        }
    }

    /// Adds their forces with the damping of their contacts; apart from the rest, which stays small where no contact is
    /// damped.
    #[inline(never)]
    fn add_damped_forces(&self, at: &Instant<'_>, sum: &mut [f64]) {
        for (bearing, motion) in self.bearings_at(at) {
            let [elastic, damping] =
                bearing
                    .support
                    .damped_force(&motion.displacement, &motion.rate, &motion.rotation);
            let force = std::array::from_fn(|axis| elastic[axis] + damping[axis]);
            bearing.attachment.add_force(-1.0, &force, sum);
        }
    }

    /// Force of a rigid shaft onto all bearings on the ground, N and N m, where no contact is damped.
    #[inline(always)]
    pub fn force_of_rigid_shaft<S: Simd>(
        &self,
        simd: S,
        shaft: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        // one by itself, so that no sum has to be kept in memory from bearing to bearing
        if let [only] = &self.all[..] {
            return only.force_of_rigid_shaft(simd, shaft, rotation, phases);
        }
        let mut sum = [0.0; FREEDOMS];
        for own in &self.all {
            let force = own.force_of_rigid_shaft(simd, shaft, rotation, phases);
            for axis in 0..FREEDOMS {
                sum[axis] += force[axis];
            }
        }
        sum
    }
}

impl AttachedElement {
    /// Force of a rigid shaft onto it and the ground as one on the shaft; none where it is in the linear part.
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
                self.attachment.on_shaft(&force)
            }
            Element::Linear(_) => [0.0; FREEDOMS],
        }
    }

    /// Its motion at an instant.
    fn motion(&self, at: &Instant<'_>) -> ElementMotion {
        match &self.element {
            Element::BallBearing(support) => motion(&self.attachment, support, at),
            Element::Linear(_) => ElementMotion {
                displacement: self.attachment.displacement(at.place, at.rest),
                rate: self.attachment.rate(at.velocity),
                rotation: BearingRotation::at_start(at.rotation.speed),
            },
        }
    }
}

impl AttachedBearing<'_> {
    /// Displacement of its inner ring's place from the outer one's.
    #[inline(always)]
    pub fn displacement(&self, place: &[f64], rest: &[f64]) -> Vector5 {
        self.attachment.displacement(place, rest)
    }

    /// Change of its cage's angle by that of the shaft, at an angle of the shaft.
    pub fn cage_rate(&self, angle: f64) -> f64 {
        let ratio = self.support.cage_ratio();
        let jitter = self.support.cage_jitter();
        ratio * (1.0 + jitter.map_or(0.0, |jitter| jitter.at(ratio * angle)[1]))
    }

    /// Its motion at an instant.
    pub fn motion(&self, at: &Instant<'_>) -> ElementMotion {
        motion(self.attachment, self.support, at)
    }
}

/// Motion of a ball bearing at an instant.
fn motion(attachment: &Attachment, support: &Support, at: &Instant<'_>) -> ElementMotion {
    ElementMotion {
        displacement: attachment.displacement(at.place, at.rest),
        rate: attachment.rate(at.velocity),
        rotation: seen_by(support, at.rotation, &at.phases),
    }
}

/// The rotation that a bearing sees; cages that roll as the first one share its sine.
#[inline(always)]
pub(super) fn seen_by(support: &Support, rotation: &Rotation, phases: &Phases) -> BearingRotation {
    let ratio = support.cage_ratio();
    if let Some(jitter) = support.cage_jitter() {
        return with_jitter(jitter, ratio, rotation, phases);
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

/// The rotation of a bearing whose cage wanders.
#[inline(never)]
fn with_jitter(
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
