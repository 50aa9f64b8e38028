//! Balance of forces on one ball at a trial position.

use nalgebra::{Matrix2, RowVector2, Vector2};

use super::direction::Direction;
use super::inertia::{InertiaForces, InertiaLaw};
use super::rate::Rate;
use crate::bearing::contact_spring::ContactSpring;
use crate::bearing::{BallForce, BallTangent};

/// Dimensions of a ball's plane, and its inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ball {
    /// (f_i − 1/2)D, m.
    pub(super) free_inner: f64,
    /// (f_o − 1/2)D, m.
    pub(super) free_outer: f64,
    /// Radius of the inner groove f_i D: arm of T_i about the groove centre, m.
    pub(super) groove_radius: f64,
    pub(super) inertia: InertiaLaw,
}

/// One contact at a trial position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    pub(super) direction: Direction,
    /// Normal load Q, N.
    pub(super) load: f64,
    /// dQ/ds, N/m.
    pub(super) stiffness: f64,
}

impl Contact {
    #[inline]
    fn new(vector: Vector2<f64>, free_length: f64, spring: &impl ContactSpring) -> Self {
        let direction = Direction::new(vector);
        let (load, stiffness) = spring.load_and_stiffness(direction.length - free_length);
        Self {
            direction,
            load,
            stiffness,
        }
    }

    /// Force `Q n + T t` and its derivatives by this contact's length and angle, and by the other
    /// contact's angle; T is a rate by variables of which `own` is this angle and `other` that.
    #[inline]
    fn force(&self, friction: &Rate, own: usize, other: usize) -> ContactForce {
        let (n, t) = (self.direction.normal, self.direction.tangent());
        ContactForce {
            value: self.load * n + friction.value * t,
            by_length: self.stiffness * n,
            by_load_inner: friction.by[0] * t,
            by_angle: (self.load + friction.by[own]) * t - friction.value * n,
            by_other_angle: friction.by[other] * t,
        }
    }
}

struct ContactForce {
    value: Vector2<f64>,
    by_length: Vector2<f64>,
    by_load_inner: Vector2<f64>,
    by_angle: Vector2<f64>,
    by_other_angle: Vector2<f64>,
}

/// Forces on a ball at a trial position, with what Newton's method and the tangent need.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Balance {
    pub(super) inner: Contact,
    pub(super) outer: Contact,
    pub(super) inertia: InertiaForces,
    /// Force that the inner race presses onto the ball, N.
    pub(super) ring_force: Vector2<f64>,
    /// Sum of all forces on the ball, N.
    pub(super) residual: Vector2<f64>,
    ring_by_inner: Matrix2<f64>,
    ring_by_outer: Matrix2<f64>,
    residual_by_inner: Matrix2<f64>,
    residual_by_outer: Matrix2<f64>,
}

impl Ball {
    /// Balance with the ball's centre at `centre` and the inner groove centre at `groove`, both
    /// from the outer groove centre; `force_scale` is F_0 = ½ m_b d_m ω² in N.
    ///
    /// ```text
    /// r = Q_i n_i + T_i t_i − Q_o n_o − T_o t_o + (0, F_c)
    /// n = (sin α, cos α)   t = (cos α, −sin α)
    /// ```
    #[inline]
    pub(super) fn balance(
        &self,
        groove: Vector2<f64>,
        centre: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Balance {
        let inner = Contact::new(groove - centre, self.free_inner, &springs[0]);
        let outer = Contact::new(centre, self.free_outer, &springs[1]);
        let inertia = self
            .inertia
            .forces(inner.load, &inner.direction, &outer.direction, force_scale);
        let from_inner = inner.force(&inertia.friction_inner, 1, 2);
        let from_outer = outer.force(&inertia.friction_outer, 2, 1);
        let up = Vector2::y();
        let [by_load, by_alpha_i, by_alpha_o] = inertia.centrifugal.by.into();
        let ring_by_length = from_inner.by_length + inner.stiffness * from_inner.by_load_inner;
        let residual_by_length =
            ring_by_length + inner.stiffness * (by_load * up - from_outer.by_load_inner);
        let no_length = Vector2::zeros();
        Balance {
            ring_force: from_inner.value,
            residual: from_inner.value - from_outer.value + inertia.centrifugal.value * up,
            ring_by_inner: inner.direction.chain(ring_by_length, from_inner.by_angle),
            ring_by_outer: outer.direction.chain(no_length, from_inner.by_other_angle),
            residual_by_inner: inner.direction.chain(
                residual_by_length,
                from_inner.by_angle - from_outer.by_other_angle + by_alpha_i * up,
            ),
            residual_by_outer: outer.direction.chain(
                -from_outer.by_length,
                from_inner.by_other_angle - from_outer.by_angle + by_alpha_o * up,
            ),
            inner,
            outer,
            inertia,
        }
    }

    /// Force of the inner ring onto the ball.
    #[inline]
    pub(super) fn force(&self, balance: &Balance) -> BallForce {
        BallForce {
            axial: balance.ring_force.x,
            radial: balance.ring_force.y,
            // λ_i f_i M_g = f_i D T_i
            couple: -self.groove_radius * balance.inertia.friction_inner.value,
        }
    }

    /// Derivative of the force by the position of the inner groove centre, the ball's centre
    /// following so that its balance keeps: `dX/dA = −(∂r/∂X)⁻¹ ∂r/∂A`.
    #[inline]
    pub(super) fn tangent(&self, balance: &Balance) -> BallTangent {
        // no load, no force; and without inertia nothing then holds the ball anywhere
        if balance.inner.load == 0.0 {
            return [[0.0; 2]; 3];
        }
        let Some(inverse) = balance.jacobian().try_inverse() else {
            return [[0.0; 2]; 3];
        };
        let outer_follows = -inverse * balance.residual_by_inner;
        let inner_follows = Matrix2::identity() - outer_follows;
        let force =
            balance.ring_by_inner * inner_follows + balance.ring_by_outer * outer_follows;
        let friction = &balance.inertia.friction_inner.by;
        let (inner, outer) = (&balance.inner, &balance.outer);
        let by_inner: RowVector2<f64> = friction[0]
            * inner.stiffness
            * inner.direction.normal.transpose()
            + friction[1] / inner.direction.length * inner.direction.tangent().transpose();
        let by_outer: RowVector2<f64> =
            friction[2] / outer.direction.length * outer.direction.tangent().transpose();
        let couple =
            -self.groove_radius * (by_inner * inner_follows + by_outer * outer_follows);
        [
            [force.m11, force.m12],
            [force.m21, force.m22],
            [couple.x, couple.y],
        ]
    }
}

impl Balance {
    /// ∂r/∂X, the derivative of the residual by the ball's centre.
    #[inline]
    pub(super) fn jacobian(&self) -> Matrix2<f64> {
        self.residual_by_outer - self.residual_by_inner
    }
}
