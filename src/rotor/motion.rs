//! The shaft in motion: the right-hand side of its equations, and what can be seen of it.

use super::damping::DampingMatrix;
use super::{CageMotion, FREEDOMS, Sample};
use crate::bearing::equilibrium::Equilibrium;
use crate::bearing::{CageAngle, Support, Vector5};
use crate::integrate::System;

/// A concentrated mass on its bearings, assembled and ready to move.
///
/// ```text
/// m ẍ  + (C q̇)_x = −F_x + m e ω² cos ψ + P_x
/// m ÿ  + (C q̇)_y = −F_y + m e ω² sin ψ − m g + P_y
/// m z̈  + (C q̇)_z = −F_z + P_z
/// I_t θ̈x + (C q̇)_θx + I_p ω θ̇y = −M_x + P_θx
/// I_t θ̈y + (C q̇)_θy − I_p ω θ̇x = −M_y + P_θy
/// ```
///
/// with F the force that holds the inner rings at q. Freedoms that the scene does not keep stay
/// where the static equilibrium has them.
///
/// Source: the equations of a Jeffcott rotor with gyroscopic tilt, e.g. Krämer, *Dynamics of Rotors
/// and Foundations* (1993), ch. 1 and 5.
#[derive(Debug, Clone)]
pub struct Rotor {
    pub(super) kept: usize,
    pub(super) mass: Vector5,
    pub(super) inverse_mass: Vector5,
    /// I_p ω, kg m²/s.
    pub(super) gyroscopic: f64,
    pub(super) speed: f64,
    pub(super) cage: CageMotion,
    /// m e ω², N.
    pub(super) unbalance: f64,
    pub(super) load: Vector5,
    pub(super) damping: DampingMatrix,
    pub(super) supports: Vec<Support>,
    pub(super) equilibrium: Equilibrium,
    /// Displacement and velocity at t = 0.
    pub(super) initial: [Vector5; 2],
}

impl Rotor {
    /// Number of freedoms that move: the first so many of x, y, z, θx, θy.
    pub fn kept(&self) -> usize {
        self.kept
    }

    /// Angular speed of the shaft, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Static equilibrium under the constant loads, without unbalance.
    pub fn equilibrium(&self) -> &Equilibrium {
        &self.equilibrium
    }

    /// Bearings on the shaft.
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// Displacement and velocity at t = 0.
    pub fn initial_state(&self) -> [Vector5; 2] {
        self.initial
    }

    /// Force of the shaft onto all bearings at a displacement and a time, N and N m.
    #[inline]
    fn force_on_bearings(&self, displacement: &Vector5, time: f64) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        self.for_each_support(time, |support, cage| {
            let force = support.force(displacement, cage, self.speed);
            for axis in 0..FREEDOMS {
                total[axis] += force[axis];
            }
        });
        total
    }

    /// Speed of the cage of a bearing, rad/s.
    #[inline]
    pub(super) fn cage_speed(&self, support: &Support) -> f64 {
        match self.cage {
            CageMotion::Rolling => support.cage_speed(self.speed),
            CageMotion::Frozen => 0.0,
        }
    }

    /// Visits every bearing with the angle of its cage; bearings that roll alike share the sine.
    #[inline]
    pub(super) fn for_each_support(&self, time: f64, mut visit: impl FnMut(&Support, CageAngle)) {
        let mut known = (0.0, CageAngle::START);
        for support in &self.supports {
            let cage_speed = self.cage_speed(support);
            if cage_speed != known.0 {
                known = (cage_speed, CageAngle::new(cage_speed * time));
            }
            visit(support, known.1);
        }
    }

    /// What is observed in a state at a time.
    pub fn sample<const N: usize>(&self, time: f64, state: &[f64; N]) -> Sample {
        let displacement = self.full(&self.equilibrium.displacement, &state[..N / 2]);
        let velocity = self.full(&[0.0; FREEDOMS], &state[N / 2..]);
        let (mut largest, mut loaded) = (0.0_f64, 0);
        self.for_each_support(time, |support, cage| {
            support.for_each_contact(&displacement, cage, self.speed, &mut |ball| {
                let load = ball.load_inner.max(ball.load_outer);
                largest = largest.max(load);
                loaded += u32::from(ball.load_inner > 0.0);
            });
        });
        Sample {
            time,
            angle: self.speed * time,
            speed: self.speed,
            displacement,
            velocity,
            force_on_shaft: self
                .force_on_bearings(&displacement, time)
                .map(|force| -force),
            largest_ball_load: largest,
            balls_loaded: loaded,
        }
    }

    /// Five components, the kept ones from a state, the others from `held`.
    #[inline(always)]
    pub(super) fn full(&self, held: &Vector5, kept: &[f64]) -> Vector5 {
        let mut full = *held;
        full[..kept.len()].copy_from_slice(kept);
        full
    }
}

impl<const N: usize> System<N> for Rotor {
    #[inline]
    fn derivative(&self, time: f64, state: &[f64; N], rate: &mut [f64; N]) {
        let kept = N / 2;
        let velocity = &state[kept..];
        let displacement = self.full(&self.equilibrium.displacement, &state[..kept]);
        let force = self.force_on_bearings(&displacement, time);
        let (sin, cos) = (self.speed * time).sin_cos();
        let mut push = self.load;
        push[0] += self.unbalance * cos;
        push[1] += self.unbalance * sin;
        if kept == FREEDOMS {
            push[3] -= self.gyroscopic * velocity[4];
            push[4] += self.gyroscopic * velocity[3];
        }
        self.damping.brake(velocity, &mut push);
        for axis in 0..kept {
            rate[axis] = velocity[axis];
            rate[kept + axis] = (push[axis] - force[axis]) * self.inverse_mass[axis];
        }
    }
}
