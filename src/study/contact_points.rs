//! Points of the motion at which laws of contact are compared.

use super::contact_choice::{Candidate, ContactQuestion, largest, lever};
use crate::bearing::{BearingRotation, Geometry, Support, Vector5};
use crate::numerics::distinct::rising;
use crate::rotor::{Attachment, FREEDOMS, Rotor, RotorDefinition, RotorError};

/// Largest motion that is considered, in groove centre distances: beyond it the estimate is a resonance
/// without damping rather than a motion.
pub(super) const LARGEST_MOTION: f64 = 0.1;

/// A speed, and the positions of the shaft at it.
pub(super) struct Point {
    pub speed: f64,
    /// The equilibrium first.
    pub positions: Vec<Vector5>,
    /// How far the positions are from it, m.
    pub reach: f64,
    /// Force that differences are relative to, N.
    pub force: f64,
    /// What the motion changes it by, N.
    pub change: f64,
}

/// The speeds at the start, the highest, and the one after the settle time.
pub(super) fn speeds(rotor: &RotorDefinition, settle: Option<f64>) -> Result<Vec<f64>, RotorError> {
    let mut speeds = vec![rotor.speed];
    if let Some(settle) = settle {
        speeds.push(rotor.highest_speed());
        if rotor.drive.is_none() {
            speeds.extend(rotor.speed_profile()?.steady_from(settle));
        }
    }
    Ok(rising(speeds))
}

impl Point {
    /// Whether the shaft moves there.
    pub fn moves(&self) -> bool {
        self.reach > 0.0
    }

    /// The equilibrium under the highest level at a speed, and the positions around it.
    pub fn new(
        rotor: &RotorDefinition,
        question: &ContactQuestion,
        speed: f64,
    ) -> Result<Self, RotorError> {
        let steady = rotor.at_constant_speed(speed);
        let top = Candidate::new(&steady)?;
        let (middle, _) = top.frozen;
        let reach = reach(&steady, &top.supports, question)?;
        let arm = top.arm();
        let active = steady.shaft.freedoms.axes();
        let (_, stiffness) = top.tangent(&middle, 0.0, speed);
        let diagonal = |&axis: &usize| stiffness[(axis, axis)] / lever(axis, arm).powi(2);
        let change = reach * largest(active.iter().map(diagonal));
        let bears = |(support, attachment): (&Support, &Attachment)| {
            let displacement = attachment.displacement(&middle, &[]);
            let mut force = [0.0; FREEDOMS];
            let own = support.force(&displacement, &BearingRotation::at_start(speed));
            attachment.add_force(1.0, &own, &mut force);
            largest((0..FREEDOMS).map(|axis| force[axis] / lever(axis, arm)))
        };
        Ok(Self {
            speed,
            force: largest(top.supports.iter().zip(&top.attachments).map(bears)).max(change),
            change,
            positions: around(middle, reach, active, arm),
            reach,
        })
    }
}

/// How far the shaft is estimated to move, m; zero where nothing moves.
pub(super) fn reach(
    steady: &RotorDefinition,
    supports: &[Support],
    question: &ContactQuestion,
) -> Result<f64, RotorError> {
    if question.settle.is_none() {
        return Ok(0.0);
    }
    let scale = Rotor::assemble(steady)?.motion_scale(question.model_error);
    let limit = LARGEST_MOTION * Support::largest(supports, Geometry::length_scale);
    Ok(scale.length.min(limit))
}

/// A position and those on either side of it along every freedom that moves.
pub(super) fn around(middle: Vector5, reach: f64, active: &[usize], arm: f64) -> Vec<Vector5> {
    let mut positions = vec![middle];
    if reach > 0.0 {
        for &axis in active {
            for step in [reach, -reach] {
                let mut position = middle;
                position[axis] += step / lever(axis, arm);
                positions.push(position);
            }
        }
    }
    positions
}
