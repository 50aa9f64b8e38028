//! Elements besides the bearings, and laws of force that are not linear.

use std::fmt;
use std::sync::Arc;

use super::element::{Element, ElementMotion, Instant};
use super::{CoefficientTable, LinearLaw, Rotor, Rub, SqueezeFilm, dot};
use crate::bearing::{Housing, Matrix5, Vector5};

/// What sits between the shaft and a housing or the ground, or under a housing, besides the bearings.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceElement {
    /// Position along the shaft, m; none of an element between the housing of `housing_of` and the ground.
    pub position: Option<f64>,
    /// The bearing, from 0, or behind them the element, in whose housing it sits, or whose housing it holds.
    pub housing_of: Option<usize>,
    /// The housing that it has for itself; without one it sits on the ground.
    pub housing: Option<Housing>,
    /// Its law of force.
    pub law: ElementLaw,
}

/// What forces an element exerts.
#[derive(Debug, Clone, PartialEq)]
pub enum ElementLaw {
    /// Springs and dampers of constant coefficients.
    Linear(Box<LinearLaw>),
    /// Springs and dampers whose coefficients follow the speed.
    OverSpeed(CoefficientTable),
    /// A squeeze film damper.
    SqueezeFilm(SqueezeFilm),
    /// A stator that the shaft rubs.
    Rub(Rub),
}

impl ElementLaw {
    /// The element of a shaft at a speed in rad/s that is kept, or that changes.
    pub(super) fn element(&self, speed: f64, kept: bool) -> Element {
        match self {
            Self::Linear(law) => Element::Linear(law.clone()),
            Self::OverSpeed(table) if kept => Element::Linear(Box::new(table.at(speed))),
            Self::OverSpeed(table) => Element::Law(Arc::new(table.clone())),
            Self::SqueezeFilm(film) => Element::Law(Arc::new(*film)),
            Self::Rub(rub) => Element::Law(Arc::new(*rub)),
        }
    }

    /// Its springs and dampers at a speed in rad/s; none of another law.
    pub(super) fn linear_at(&self, speed: f64) -> Option<LinearLaw> {
        match self {
            Self::Linear(law) => Some(**law),
            Self::OverSpeed(table) => Some(table.at(speed)),
            Self::SqueezeFilm(_) | Self::Rub(_) => None,
        }
    }

    /// Whether it damps at a speed in rad/s.
    pub(super) fn damps(&self, speed: f64) -> bool {
        let linear = self.linear_at(speed);
        linear.map_or(matches!(self, Self::SqueezeFilm(_)), |law| {
            law.damping.amax() > 0.0
        })
    }
}

/// A law of force that is no constant stiffness and damping. The force is that of the shaft onto the element.
pub(super) trait ForceLaw: fmt::Debug + Send + Sync {
    /// F(u, u̇, ω).
    fn force(&self, motion: &ElementMotion) -> Vector5;

    /// ∂F/∂u and ∂F/∂u̇.
    fn slopes(&self, motion: &ElementMotion) -> [Matrix5; 2];

    /// Energy that it gives back, J, and the force that is its slope by the displacement.
    fn elastic(&self, _displacement: &Vector5) -> (f64, Vector5) {
        (0.0, [0.0; 5])
    }

    /// Moment by which it resists the rotation of the shaft, N m.
    fn resisting_moment(&self, _motion: &ElementMotion) -> f64 {
        0.0
    }

    /// Power that the rotation supplies through coefficients that follow its speed, which store no energy, W.
    fn supplied(&self, _motion: &ElementMotion) -> f64 {
        0.0
    }

    /// Distance from the middle that the shaft cannot reach, m; none of a law that holds anywhere.
    fn wall(&self) -> Option<f64> {
        None
    }

    /// Distance from the middle up to which the shaft moves freely, m; none of a law without such a gap.
    fn clearance(&self) -> Option<f64> {
        self.wall()
    }

    /// How far past its event surface a displacement is, m; none of a law without one. The force is proportional to it.
    fn past_event(&self, _displacement: &Vector5) -> Option<f64> {
        None
    }

    /// Bound of the force across the shaft at a distance past the event surface, N.
    fn force_past_event(&self, _distance: f64) -> f64 {
        0.0
    }
}

/// What laws of force do to the energy of a motion.
#[derive(Default)]
pub(super) struct LawPowers {
    /// Power that they dissipate, W.
    pub dissipated: f64,
    /// Moment by which they resist the rotation, N m.
    pub resisting: f64,
    /// Power that the rotation supplies besides, W.
    pub supplied: f64,
}

impl Rotor {
    /// Adds the forces of all laws; what they do to the energy.
    pub(super) fn laws_act(&self, at: &Instant<'_>, sum: &mut [f64]) -> LawPowers {
        let mut powers = LawPowers::default();
        for (attachment, law, motion) in self.elements.laws_at(at) {
            let force = law.force(&motion);
            let (_, elastic) = law.elastic(&motion.displacement);
            let (moment, supplied) = (law.resisting_moment(&motion), law.supplied(&motion));
            powers.resisting += moment;
            powers.supplied += supplied;
            powers.dissipated += dot(&force, &motion.rate) - dot(&elastic, &motion.rate)
                + moment * at.rotation.speed
                + supplied;
            attachment.add_force(-1.0, &force, sum);
        }
        powers
    }

    /// Energy that laws of force give back, J.
    pub(super) fn energy_of_laws(&self, at: &Instant<'_>) -> f64 {
        let laws = self.elements.laws_at(at);
        laws.map(|(_, law, motion)| law.elastic(&motion.displacement).0)
            .sum()
    }

    /// Writes how far laws are past their event surfaces, m.
    pub(super) fn law_events(&self, at: &Instant<'_>, values: &mut [f64]) {
        let laws = self.elements.laws_at(at);
        let past = laws.filter_map(|(_, law, motion)| law.past_event(&motion.displacement));
        for (value, past) in values.iter_mut().zip(past) {
            *value = past;
        }
    }

    /// Writes the accelerations that a law so far past its event surface gives the degrees of freedom at most, as the
    /// rates of their velocities.
    pub(super) fn law_jump(&self, event: usize, distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
        let mut laws = self.elements.laws().filter(|(_, law)| has_event(*law));
        if let Some((attachment, law)) = laws.nth(event) {
            let force = law.force_past_event(distance);
            let accelerations = &mut rate[self.dofs()..2 * self.dofs()];
            attachment.add_force_bound(&[force, force, 0.0, 0.0, 0.0], accelerations);
            self.linear.mass.accelerate(accelerations);
        }
    }
}

/// Whether a law has an event surface.
pub(super) fn has_event(law: &dyn ForceLaw) -> bool {
    law.past_event(&[0.0; 5]).is_some()
}

#[cfg(test)]
#[path = "law_tests.rs"]
mod tests;
