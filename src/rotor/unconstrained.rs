//! Freedoms in which nothing holds the shaft at its static equilibrium, and what then rests on nothing.
//!
//! A shaft that floats in the clearance of its bearings is a scene like any other: the equations of
//! motion ask for no stiffness. What does ask for it is all that is derived from K before the first
//! step. Where a scene uses that, it says one thing and computes another, and is refused:
//!
//! - a linear bearing keeps the K of the equilibrium for good, so nothing ever holds the shaft;
//! - damping as a ratio of the critical value, or proportional to K, is no damping at all, unless the balls hold the shaft
//!   once the cages have turned by half a ball spacing, as where it rests in its clearance on a single ball right below:
//!   then it is derived from that K;
//! - a start at equilibrium in a freedom that nothing drives either stays where the search for the
//!   equilibrium happened to end.
//!
//! Every other scene runs, and is reported in a warning.

use std::f64::consts::PI;

use nalgebra::{Complex, DMatrix, SymmetricEigen};

use super::structure::Structure;
use super::{Damping, InitialPosition, Rotor, RotorDefinition};
use crate::bearing::{ContactLaw, Geometry, Support};

/// Stiffness, as a part of that of a loaded contact, below which nothing holds the shaft: the force
/// of an oil film across an open gap, and round-off, are less.
pub(super) const FREE_STIFFNESS: f64 = 1e-9;
/// A displacement that is small in a bearing, m: a force that `FREE_STIFFNESS` would answer it with is none.
const SMALL_DISPLACEMENT: f64 = 1e-6;
/// Part of a freedom's direction that must be unconstrained to call the freedom itself unconstrained.
const WHOLLY: f64 = 0.999;
/// Part from which on a freedom has a share in an unconstrained combination.
const PARTLY: f64 = 0.05;
/// Sweeps after which the search for eigenvalues gives up.
const SWEEPS: usize = 1000;

/// Freedoms without stiffness at the static equilibrium.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "nothing holds the shaft along {freedoms} at the static equilibrium: the stiffness there is \
     {stiffness:.1e} N/m, where a loaded contact of these bearings has {contact:.0e} N/m"
)]
pub struct Unconstrained {
    /// Names of the freedoms.
    pub freedoms: String,
    /// Least stiffness, tilts by their arm, N/m; negative where the equilibrium is not stable.
    pub stiffness: f64,
    /// Stiffness of a loaded contact of these bearings, by its order of magnitude, N/m.
    pub contact: f64,
}

/// A scene that rests on a stiffness that is not there.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum UnconstrainedError {
    /// A linear bearing without stiffness.
    #[error(
        "{0}; a linear bearing keeps this for good: add a load or a preload, set contact = \"hertz\", \
         or hold the freedom by shaft.freedoms"
    )]
    Linear(Unconstrained),
    /// Damping that is derived from no stiffness.
    #[error(
        "{0}; damping that is derived from it is none: give damping.coefficients, add a load or a \
         preload, or hold the freedom by shaft.freedoms"
    )]
    Damping(Unconstrained),
    /// A start at an equilibrium that is one of many.
    #[error(
        "{0}; so the equilibrium is one of many places to start from, and no load drives the shaft \
         from it: give initial.displacement, add a load or a preload, or hold the freedom by \
         shaft.freedoms"
    )]
    Start(Unconstrained),
}

/// Refuses a scene that rests on a stiffness which its active freedoms do not have at the static
/// equilibrium; says what the reader should know where such a scene can be run.
///
/// # Errors
/// [`UnconstrainedError`] names the freedoms, the stiffness and what to change.
pub fn check_constraints(
    definition: &RotorDefinition,
    rotor: &Rotor,
) -> Result<Vec<String>, UnconstrainedError> {
    let free = &rotor.start.free;
    let along = |axes: Vec<usize>| unconstrained_along(rotor, axes);
    let Some(all) = along(free.axes(PARTLY)) else {
        return Ok(Vec::new());
    };
    let mut bearings = definition.bearings.iter();
    if bearings.any(|bearing| bearing.law == ContactLaw::Linear) {
        return Err(UnconstrainedError::Linear(all));
    }
    let undamped = along(free.undamped(&definition.damping));
    if let Some(undamped) = undamped.filter(|_| !rotor.start.damped_by_later_balls) {
        return Err(UnconstrainedError::Damping(undamped));
    }
    if let Some(lost) = along(free.without_start(definition, rotor)) {
        return Err(UnconstrainedError::Start(lost));
    }
    let damping = match rotor.start.damped_by_later_balls {
        true => {
            "; its damping follows from the stiffness with the cages turned by half the spacing of their rolling elements"
        }
        false => "",
    };
    Ok(vec![format!(
        "{all}; its place there is one of many, and the natural frequencies leave it out{damping}"
    )])
}

/// What the reader of a linearised answer should know of freedoms that nothing holds at the static equilibrium.
pub fn unconstrained_warning(rotor: &Rotor) -> Option<String> {
    let all = unconstrained_along(rotor, rotor.start.free.axes(PARTLY))?;
    Some(format!(
        "{all}; natural frequencies leave it out, and responses know no force that restores it: add a load or a preload, or hold \
         the freedom by shaft.freedoms"
    ))
}

/// Some freedoms that nothing holds; none where there are none.
fn unconstrained_along(rotor: &Rotor, axes: Vec<usize>) -> Option<Unconstrained> {
    let (free, coordinates) = (&rotor.start.free, &rotor.structure.coordinates);
    let names = axes.into_iter().map(|dof| coordinates[dof].name.as_str());
    let names: Vec<&str> = names.collect();
    (!names.is_empty()).then(|| Unconstrained {
        freedoms: names.join(", "),
        stiffness: free.stiffness,
        contact: free.contact,
    })
}

/// What nothing holds at the static equilibrium.
#[derive(Debug, Clone)]
pub(super) struct FreeDirections {
    /// Part of the direction of each degree of freedom that is unconstrained.
    shares: Vec<f64>,
    /// Least stiffness, tilts by their arm, N/m.
    stiffness: f64,
    /// Stiffness of a loaded contact, or of the stiffest linear element, by its order of magnitude, N/m.
    contact: f64,
}

impl FreeDirections {
    /// Eigenvectors of the symmetric part of K at the equilibrium whose eigenvalue is next to nothing, or negative.
    pub fn find(
        structure: &Structure,
        definition: &RotorDefinition,
        supports: &[Support],
        stiffness: &DMatrix<f64>,
    ) -> Self {
        let elements = definition.elements.iter();
        let linear = elements.filter_map(|own| own.law.linear_at(definition.speed));
        let stiffest = linear.map(|own| own.stiffness.view((0, 0), (3, 3)).diagonal().max());
        let contact = stiffest.fold(contact_stiffness(supports), f64::max);
        let dofs = structure.dofs;
        let arm = Support::largest(supports, Geometry::lever);
        let length = |dof: usize| structure.coordinates[dof].length(arm);
        let scaled = DMatrix::from_fn(dofs, dofs, |row, column| {
            let both = stiffness[(row, column)] + stiffness[(column, row)];
            0.5 * both / (length(row) * length(column))
        });
        let mut shares = vec![0.0; dofs];
        let mut least = f64::INFINITY;
        if let Some(modes) = SymmetricEigen::try_new(scaled, f64::EPSILON, SWEEPS) {
            let vectors = modes.eigenvectors.column_iter();
            for (value, vector) in modes.eigenvalues.iter().zip(vectors) {
                least = least.min(*value);
                if *value <= FREE_STIFFNESS * contact {
                    for (share, part) in shares.iter_mut().zip(vector.iter()) {
                        *share += part * part;
                    }
                }
            }
        }
        Self {
            shares,
            stiffness: least,
            contact,
        }
    }

    /// Freedoms of which more than a part is unconstrained.
    fn axes(&self, part: f64) -> Vec<usize> {
        let axes = (0..self.shares.len()).filter(|dof| self.shares[*dof] > part);
        axes.collect()
    }

    /// Freedoms that the damping leaves undamped although it is to damp them. A ratio damps every
    /// freedom by its own stiffness, so a combination of two has its share.
    fn undamped(&self, damping: &Damping) -> Vec<usize> {
        match *damping {
            Damping::Ratio(ratio) if ratio > 0.0 => self.axes(WHOLLY),
            Damping::StiffnessTime(time) if time > 0.0 => self.axes(PARTLY),
            _ => Vec::new(),
        }
    }

    /// Freedoms in which neither the scene says where the motion starts nor anything drives it. A
    /// combination is driven, and starts, by any of its freedoms; x and θy, or y and θx, by each other, as only a shaft
    /// that is its own mirror image moves in one of them alone.
    fn without_start(&self, definition: &RotorDefinition, rotor: &Rotor) -> Vec<usize> {
        let (initial, driven) = (&definition.initial, rotor.driven(self.contact));
        let given = |axis: usize| {
            initial.displacement[axis].is_some()
                || initial.velocity[axis].is_some_and(|velocity| velocity != 0.0)
        };
        let shaft = &rotor.structure.shaft;
        let of_plane_driven = |axis: usize| {
            let other = [4, 3, 2, 1, 0][axis];
            driven.get(shaft.coordinates[other]) == Some(&true)
        };
        let known = |dof: &usize| {
            driven[*dof]
                || shaft.axis_of(*dof).is_some_and(of_plane_driven)
                || initial.from == InitialPosition::Origin
                || shaft.axis_of(*dof).is_some_and(given)
        };
        let mut lost = self.axes(WHOLLY);
        let mut combined = self.axes(PARTLY);
        combined.retain(|dof| !lost.contains(dof));
        lost.retain(|dof| !known(dof));
        if !combined.iter().any(known) {
            lost.append(&mut combined);
        }
        lost
    }
}

/// Stiffness of a loaded contact of these bearings, by its order of magnitude, N/m: that of one
/// ball pressed in by a thousandth of the groove centre distance.
pub(super) fn contact_stiffness<'a>(supports: impl IntoIterator<Item = &'a Support>) -> f64 {
    let stiffnesses = supports.into_iter().map(Support::contact_stiffness);
    stiffnesses.fold(0.0, f64::max)
}

impl Rotor {
    /// Where damping is to follow from a stiffness that is not there, and the cages roll on, it follows from the stiffness
    /// with the cages turned by half a ball spacing, if that holds the shaft.
    pub(super) fn damp_by_later_balls(&mut self, definition: &RotorDefinition) {
        let undamped = |rotor: &Self| !rotor.start.free.undamped(&definition.damping).is_empty();
        let rolls = definition.cage.turns() && self.excitation.speed.highest() > 0.0;
        if !rolls || !undamped(self) {
            return;
        }
        let mut turned = definition.clone();
        for bearing in &mut turned.bearings {
            bearing.first_ball += PI / bearing.bearing.geometry.balls() as f64;
        }
        let structure = Structure::from_definition(&turned).ok();
        let turned = structure.and_then(|structure| Self::from_structure(structure, &turned).ok());
        if let Some(turned) = turned.filter(|turned| !undamped(turned)) {
            self.linear.damping = turned.linear.damping;
            self.start.damped_by_later_balls = true;
        }
    }

    /// Which degrees of freedom unbalance, varying loads and passing balls drive.
    fn driven(&self, contact: f64) -> Vec<bool> {
        let turns = self.excitation.speed.highest() > 0.0;
        let mut driven = vec![false; self.dofs()];
        let unbalance = turns.then(|| self.excitation.unbalance_phasor(1.0, self.dofs()));
        let loads = self
            .excitation
            .load_vibrations(0.0, self.dofs())
            .into_iter();
        for force in unbalance.into_iter().chain(loads.map(|(_, force)| force)) {
            for (driven, part) in driven.iter_mut().zip(force.iter()) {
                *driven |= *part != Complex::ZERO;
            }
        }
        if turns && self.elements.cage.turns() {
            let nothing = FREE_STIFFNESS * contact * SMALL_DISPLACEMENT;
            for (driven, change) in driven.iter_mut().zip(self.passing_force().iter()) {
                *driven |= *change > nothing;
            }
        }
        // gyroscopic moments turn one tilt into the other
        let gyroscopic = &self.linear.gyroscopic.entries;
        let own = driven.clone();
        for (dof, driven) in driven.iter_mut().enumerate() {
            *driven |= (0..self.dofs()).any(|other| own[other] && gyroscopic[(dof, other)] != 0.0);
        }
        driven
    }
}
