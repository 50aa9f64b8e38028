//! Balance of forces on one ball at a trial position.

use nalgebra::{Matrix2, Vector2};

use super::contact::Contact;
use super::inertia::{InertiaForces, InertiaLaw};
use super::plane::{apply, inverse, product};
use crate::bearing::contact_spring::ContactSpring;
use crate::bearing::{BallForce, BallTangent, LoadSlope};

/// Dimensions of a ball's plane, and its inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ball {
    /// D, m.
    pub(super) diameter: f64,
    /// (f_i − 1/2)D, m.
    pub(super) free_inner: f64,
    /// (f_o − 1/2)D, m.
    pub(super) free_outer: f64,
    /// Radius of the inner groove f_i D: arm of T_i about the groove centre, m.
    pub(super) groove_radius: f64,
    pub(super) inertia: InertiaLaw,
}

/// Forces on a ball at a trial position.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Balance {
    pub(super) inner: Contact,
    pub(super) outer: Contact,
    pub(super) inertia: InertiaForces,
    /// Force that the inner race presses onto the ball, N.
    ring_force: Vector2<f64>,
    /// Sum of all forces on the ball, N.
    pub(super) residual: Vector2<f64>,
}

impl Ball {
    /// Balance with the ball's centre at `centre` and the inner groove centre at `groove`, both
    /// from the outer groove centre; `force_scale` is F_0 = ½ m_b d_m ω² in N.
    ///
    /// ```text
    /// r = Q_i n_i + T_i t_i − Q_o n_o − T_o t_o + (0, F_c)
    /// n = (sin α, cos α)   t = (cos α, −sin α)
    /// ```
    #[inline(always)]
    pub(super) fn balance(
        &self,
        groove: Vector2<f64>,
        centre: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Balance {
        let inner = Contact::new(groove - centre, self.free_inner, &springs[0]);
        let outer = Contact::new(centre, self.free_outer, &springs[1]);
        let inertia = self.inertia.forces(&inner, &outer, force_scale);
        let ring_force = inner.load * inner.normal + inertia.friction_inner.value * inner.tangent();
        let outer_force =
            outer.load * outer.normal + inertia.friction_outer.value * outer.tangent();
        let centrifugal = Vector2::new(0.0, inertia.centrifugal.value);
        Balance {
            residual: ring_force - outer_force + centrifugal,
            ring_force,
            inner,
            outer,
            inertia,
        }
    }

    /// Force of the inner ring onto the ball.
    #[inline(always)]
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
    #[inline(always)]
    pub(super) fn tangent(&self, balance: &Balance) -> BallTangent {
        let slopes = balance.slopes();
        let Some([inner_follows, outer_follows]) = balance.follows(&slopes) else {
            return [[0.0; 2]; 3];
        };
        let force = product(&slopes.ring_by_inner, &inner_follows)
            + product(&slopes.ring_by_outer, &outer_follows);
        let friction = &balance.inertia.friction_inner;
        let (inner, outer) = (&balance.inner, &balance.outer);
        let by_inner = friction.by_length * inner.normal + friction.by_inner * inner.angle_row();
        let by_outer = friction.by_outer * outer.angle_row();
        let couple = -self.groove_radius
            * (apply(&inner_follows.transpose(), by_inner)
                + apply(&outer_follows.transpose(), by_outer));
        [
            [force.m11, force.m12],
            [force.m21, force.m22],
            [couple.x, couple.y],
        ]
    }
}

impl Balance {
    /// Derivatives of the vectors ball → inner groove centre and outer groove centre → ball by the
    /// position of the inner groove centre, the balance kept; none where no load holds the ball.
    #[inline(always)]
    fn follows(&self, slopes: &Slopes) -> Option<[Matrix2<f64>; 2]> {
        // no load, no force; and without inertia nothing then holds the ball anywhere
        let inverse = inverse(&slopes.by_centre()).filter(|_| self.inner.load > 0.0)?;
        let outer_follows = -product(&inverse, &slopes.residual_by_inner);
        Some([Matrix2::identity() - outer_follows, outer_follows])
    }

    /// Loads of both contacts and their derivatives by the position of the inner groove centre.
    pub(super) fn load_slopes(&self) -> [LoadSlope; 2] {
        let follows = self.follows(&self.slopes());
        let contacts = [&self.inner, &self.outer];
        std::array::from_fn(|race| {
            let contact = contacts[race];
            let by_place = follows.as_ref().map_or([0.0; 2], |follows| {
                // ∂Q/∂A = (dQ/dL) nᵀ ∂(vector)/∂A
                let row = apply(&follows[race].transpose(), contact.normal);
                [contact.stiffness * row.x, contact.stiffness * row.y]
            });
            LoadSlope {
                load: contact.load,
                by_place,
            }
        })
    }
}

/// Derivatives of the forces by the vectors ball → inner groove centre (`inner`) and outer groove
/// centre → ball (`outer`), N/m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Slopes {
    ring_by_inner: Matrix2<f64>,
    ring_by_outer: Matrix2<f64>,
    residual_by_inner: Matrix2<f64>,
    residual_by_outer: Matrix2<f64>,
}

impl Slopes {
    /// ∂r/∂X, the derivative of the residual by the ball's centre.
    #[inline(always)]
    pub(super) fn by_centre(&self) -> Matrix2<f64> {
        self.residual_by_outer - self.residual_by_inner
    }
}

impl Balance {
    /// Derivatives of ring force and residual, by way of the lengths and angles of the contacts.
    #[inline(always)]
    pub(super) fn slopes(&self) -> Slopes {
        let Self { inner, outer, .. } = self;
        let InertiaForces {
            centrifugal: f_c,
            friction_inner: t_i,
            friction_outer: t_o,
        } = &self.inertia;
        let (n_i, tangent_i) = (inner.normal, inner.tangent());
        let (n_o, tangent_o) = (outer.normal, outer.tangent());
        // Q_i n_i + T_i t_i
        let ring_by_length = inner.stiffness * n_i + t_i.by_length * tangent_i;
        let ring_by_angle = (inner.load + t_i.by_inner) * tangent_i - t_i.value * n_i;
        let ring_by_other = t_i.by_outer * tangent_i;
        // Q_o n_o + T_o t_o
        let outer_by_length = outer.stiffness * n_o;
        let outer_by_angle = (outer.load + t_o.by_outer) * tangent_o - t_o.value * n_o;
        let up = Vector2::y();
        Slopes {
            ring_by_inner: inner.chain(ring_by_length, ring_by_angle),
            ring_by_outer: outer.chain(Vector2::zeros(), ring_by_other),
            residual_by_inner: inner.chain(
                ring_by_length - t_o.by_length * tangent_o + f_c.by_length * up,
                ring_by_angle - t_o.by_inner * tangent_o + f_c.by_inner * up,
            ),
            residual_by_outer: outer.chain(
                -outer_by_length,
                ring_by_other - outer_by_angle + f_c.by_outer * up,
            ),
        }
    }
}
