//! The shaft in motion: the right-hand side of its equations.

use std::borrow::Cow;

use fearless_simd::Simd;
use nalgebra::{DMatrix, DVector};

use super::element::{AttachedBearing, Elements, Instant};
use super::equilibrium::{Equilibrium, axial_hold_warning};
use super::excitation::Excitation;
use super::linear_part::LinearPart;
use super::point::Point;
use super::structure::Structure;
use super::unconstrained::FreeDirections;
use super::{Freedoms, InitialPosition, Rotation, SpeedProfile};
use crate::bearing::{BearingState, Support, Vector5};
use crate::numerics::registers::in_wide_registers;

/// A shaft on its bearings, assembled and ready to move.
///
/// ```text
/// M q̈ + (C + ω G) q̇ + (K − ω H) q + Σ_b B_bᵀ F_b(B_b q, B_b q̇, ψ_b, ω) = f(t, ψ)
/// ```
///
/// q are its degrees of freedom, B_b takes from them the displacement between the points that the rings of bearing b
/// sit at, F_b is the force that holds its inner ring there and moves it against the damping of the contacts, and f are the
/// unbalances, the weight and the loads. H is of damping inside a shaft that bends, which drives a forward whirl. Of a
/// rigid shaft on ball bearings on the ground, K = H = 0 and
///
/// ```text
/// m ẍ  + (C q̇)_x = −F_x + m e (ω² cos ψ + ω̇ sin ψ) + P_x
/// m ÿ  + (C q̇)_y = −F_y + m e (ω² sin ψ − ω̇ cos ψ) − m g + P_y
/// m z̈  + (C q̇)_z = −F_z + P_z
/// I_t θ̈x + (C q̇)_θx + I_p ω θ̇y = −M_x + P_θx
/// I_t θ̈y + (C q̇)_θy − I_p ω θ̇x = −M_y + P_θy
/// ```
///
/// with ψ, ω and ω̇ those of the speed profile. The
/// cage of a bearing turns by its constant ratio of ψ, at any profile. Coordinates that the scene holds stay where the
/// static equilibrium has them.
///
/// Source: the equations of a Jeffcott rotor with gyroscopic tilt, e.g. Krämer, *Dynamics of Rotors
/// and Foundations* (1993), ch. 1 and 5.
#[derive(Debug, Clone)]
pub struct Rotor {
    /// Its coordinates, and the points that are observed.
    pub(super) structure: Structure,
    pub(super) linear: LinearPart,
    pub(super) elements: Elements,
    pub(super) excitation: Excitation,
    pub(super) start: Start,
    /// Whether energy is accounted for.
    pub(super) energy: bool,
}

/// Where a motion starts: the static equilibrium, and what departs from it.
#[derive(Debug, Clone)]
pub(super) struct Start {
    pub equilibrium: Equilibrium,
    /// Place of all coordinates at the static equilibrium.
    pub rest: Vec<f64>,
    /// K and the stiffness of the bearings there, of all coordinates.
    pub tangent: DMatrix<f64>,
    /// C of the laws of force that are not linear there, likewise; those of the contacts are left out.
    pub law_damping: DMatrix<f64>,
    /// Axial displacement of every bearing where the shaft rests without load, [`Structure::unloaded_axial`], m.
    pub unloaded: Vec<f64>,
    /// Force in N by which z is held there, where the axial forces of several bearings balance nowhere.
    pub axial_hold: Option<f64>,
    /// What nothing holds there.
    pub free: FreeDirections,
    /// Whether C follows from the stiffness with the cages turned by half a ball spacing, as nothing holds the shaft before.
    pub damped_by_later_balls: bool,
    /// Where the motion starts from.
    pub from: InitialPosition,
    /// Displacement and velocity of the shaft at t = 0.
    pub shaft: [Vector5; 2],
}

impl Rotor {
    /// Warning of axial forces that balance nowhere.
    pub(crate) fn axial_warning(&self) -> Option<String> {
        self.start.axial_hold.map(axial_hold_warning)
    }

    /// Freedoms of the shaft that move.
    pub fn freedoms(&self) -> Freedoms {
        self.structure.freedoms
    }

    /// Displacement of the observed point of the shaft in a state.
    pub(crate) fn displacement(&self, state: &[f64]) -> Vector5 {
        let place = self.place_of_all(&state[..self.dofs()]);
        self.structure.shaft.displacement(&place, &self.start.rest)
    }

    /// Place of all coordinates where some have no mass and follow, else that of the degrees of freedom.
    pub(super) fn place_of_all<'a>(&self, dofs: &'a [f64]) -> Cow<'a, [f64]> {
        self.all_coordinates(dofs, Some(&self.start.rest))
    }

    /// Rates likewise.
    pub(super) fn rate_of_all<'a>(&self, rates: &'a [f64]) -> Cow<'a, [f64]> {
        self.all_coordinates(rates, None)
    }

    /// Values of all coordinates by those of the degrees of freedom, about `rest` or zero.
    fn all_coordinates<'a>(&self, dofs: &'a [f64], rest: Option<&[f64]>) -> Cow<'a, [f64]> {
        let followers = &self.structure.followers;
        if followers.is_empty() {
            return Cow::Borrowed(dofs);
        }
        let rest = rest.map_or_else(
            || Cow::Owned(vec![0.0; self.start.rest.len()]),
            Cow::Borrowed,
        );
        let moved = dofs.iter().zip(rest.iter()).map(|(own, rest)| own - rest);
        let moved = followers * DVector::from_iterator(dofs.len(), moved);
        let first = rest.len() - followers.nrows();
        let mut all = [dofs, &rest[dofs.len()..]].concat();
        all[first..]
            .iter_mut()
            .zip(&moved)
            .for_each(|(sum, part)| *sum += part);
        Cow::Owned(all)
    }

    /// Modes of bending that are kept in each plane of a shaft that bends.
    pub(crate) fn bending_modes(&self) -> Option<usize> {
        self.structure.bending.as_ref().map(|bending| bending.modes)
    }

    /// Frequency in Hz up to which natural frequencies are those of a shaft that bends, and not of its reduction; none where
    /// nothing is left out.
    pub(crate) fn natural_up_to(&self) -> Option<f64> {
        self.structure.bending.as_ref()?.natural_up_to()
    }

    /// Number of degrees of freedom.
    #[inline(always)]
    pub(crate) fn dofs(&self) -> usize {
        self.structure.dofs
    }

    /// Angular speed of the shaft at t = 0, rad/s.
    pub(crate) fn speed(&self) -> f64 {
        self.excitation.speed.at(0.0).speed
    }

    /// Speed and angle of the shaft from t = 0 on.
    pub(crate) fn speed_profile(&self) -> &SpeedProfile {
        &self.excitation.speed
    }

    /// Highest speed that the shaft is meant for, [`super::RotorDefinition::highest_speed`], rad/s.
    pub(crate) fn highest_speed(&self) -> f64 {
        self.excitation.highest_speed()
    }

    /// Whether a drive decides the speed.
    pub(crate) fn is_driven(&self) -> bool {
        self.excitation.drive.is_some()
    }

    /// The speed that is kept from a time on; `None` where it changes after it.
    pub(crate) fn steady_from(&self, time: f64) -> Option<f64> {
        if self.is_driven() {
            return None;
        }
        self.excitation.speed.steady_from(time)
    }

    /// Static equilibrium under the constant loads, without unbalance.
    pub fn equilibrium(&self) -> &Equilibrium {
        &self.start.equilibrium
    }

    /// Ball bearings on the shaft.
    pub(crate) fn supports(&self) -> impl Iterator<Item = &Support> + Clone {
        self.elements.supports()
    }

    /// What is known of every bearing at the static equilibrium and a speed of the shaft in rad/s.
    pub(crate) fn bearing_states(&self, speed: f64) -> Vec<BearingState> {
        let state = |(bearing, &unloaded): (AttachedBearing<'_>, &f64)| {
            let place = self.static_displacement(&bearing);
            let cage = self.elements.cage;
            bearing.support.state(&place, unloaded, speed, cage)
        };
        let bearings = self.elements.bearings();
        bearings.zip(&self.start.unloaded).map(state).collect()
    }

    /// Displacement between the rings of a bearing at the static equilibrium.
    pub(super) fn static_displacement(&self, bearing: &AttachedBearing<'_>) -> Vector5 {
        bearing.attachment.displacement(&self.start.rest, &[])
    }

    /// Places and velocities of the degrees of freedom in a state.
    pub(super) fn instant<'a>(&'a self, state: &'a [f64], rotation: &'a Rotation) -> Instant<'a> {
        let (place, velocity) = state[..2 * self.dofs()].split_at(self.dofs());
        Instant {
            place,
            velocity,
            rest: &self.start.rest,
            rotation,
            phases: self.elements.phases(rotation),
        }
    }

    /// Whether the shaft turns at one speed, and no load jumps from a time on.
    pub(crate) fn goes_on_alike(&self, time: f64) -> bool {
        let mut loads = self.excitation.loads.iter();
        self.steady_from(0.0).is_some()
            && loads.all(|load| load.kind.next_break(time) == f64::INFINITY)
    }

    /// Derivative of (q, q̇).
    #[inline(always)]
    pub(super) fn motion_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        // points and sizes of a rigid shaft on the ground are known to the compiler: with two freedoms that saves a
        // quarter of the time
        let rigid = self.elements.on_rigid_shaft;
        in_wide_registers!(self.elements.level, simd => match self.dofs() {
            2 if rigid => self.derivative_by::<_, true>(simd, 2, time, state, rate),
            3 if rigid => self.derivative_by::<_, true>(simd, 3, time, state, rate),
            5 if rigid => self.derivative_by::<_, true>(simd, 5, time, state, rate),
            dofs => self.derivative_by::<_, false>(simd, dofs, time, state, rate),
        });
    }

    /// Derivative of (q, q̇) for the processor's level `S`.
    #[inline(always)]
    fn derivative_by<S: Simd, const RIGID: bool>(
        &self,
        simd: S,
        dofs: usize,
        time: f64,
        state: &[f64],
        rate: &mut [f64],
    ) {
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let (displacement_rate, force) = rate[..2 * dofs].split_at_mut(dofs);
        displacement_rate.copy_from_slice(velocity);
        // M q̈ = f − (C + ω G) q̇ − (K − ω H) q − Σ Bᵀ F
        force.copy_from_slice(&self.excitation.constant_force[..dofs]);
        let rotation = self.excitation.speed.at(time);
        let phases = self.elements.phases(&rotation);
        self.excitation
            .add_varying_forces::<RIGID>(time, &rotation, &phases, force);
        self.linear
            .add_forces_by_rate(rotation.speed, velocity, force);
        if !RIGID {
            self.linear
                .add_forces_by_place(rotation.speed, place, force);
        }
        let rest = &self.start.rest;
        if RIGID && !self.elements.by_rate {
            let shaft = Point::RIGID_SHAFT;
            let displacement = shaft.displacement(place, rest);
            let elements = &self.elements;
            let held = elements.force_of_rigid_shaft(simd, &displacement, &rotation, &phases);
            shaft.add_force(-1.0, &held, force);
        } else {
            let at = Instant {
                place,
                velocity,
                rest,
                rotation: &rotation,
                phases,
            };
            self.elements.add_forces(simd, &at, force);
        }
        self.linear.mass.accelerate(force);
    }
}
