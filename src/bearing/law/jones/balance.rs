//! The two contacts of a ball at a trial position, and the balance of forces on it.

use super::inertia::{InertiaForces, InertiaLaw};
use crate::bearing::dual::Dual;
use crate::bearing::number::Number;

/// Dimensions of a ball's plane, and its inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ball {
    /// D, m.
    pub(super) diameter: f64,
    /// (f_i − 1/2)D and (f_o − 1/2)D, m.
    pub(super) free: [f64; 2],
    /// Radius of the inner groove f_i D: arm of T_i about the groove centre, m.
    pub(super) groove_radius: f64,
    pub(super) inertia: InertiaLaw,
}

/// Positions in a ball's plane, from the outer groove centre, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Positions<T = f64> {
    /// The ball's centre.
    pub(super) centre: Plane<T>,
    /// The inner groove centre.
    pub(super) groove: Plane<T>,
    /// Drops of the surfaces of both races under the ball.
    pub(super) drop: [T; 2],
}

/// Forces on a ball at a trial position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Balance<T> {
    /// With the inner and the outer race.
    pub(super) contacts: [Contact<T>; 2],
    pub(super) inertia: InertiaForces<T>,
    /// Force that the inner race presses onto the ball, N.
    ring_force: Plane<T>,
    /// Sum of all forces on the ball, N.
    pub(super) residual: Plane<T>,
}

impl<T: Copy> Balance<T> {
    /// The balance with another kind of number.
    #[inline(always)]
    pub(super) fn map<U>(&self, to: impl Fn(T) -> U + Copy) -> Balance<U> {
        Balance {
            contacts: self.contacts.each_ref().map(|contact| contact.map(to)),
            inertia: InertiaForces {
                centrifugal: to(self.inertia.centrifugal),
                friction: self.inertia.friction.map(to),
            },
            ring_force: self.ring_force.map(to),
            residual: self.residual.map(to),
        }
    }
}

/// Force of the inner ring onto a ball (axial, radial, couple), loads at both races, and the approach at the inner one.
pub(super) type Response<T> = [T; 6];

impl Ball {
    /// Balance in some positions; `load` has load, N, and stiffness, N/m, of the inner (0) and the outer contact (1) at
    /// an approach in m, `force_scale` is F_0 = ½ m_b d_m ω² in N.
    ///
    /// ```text
    /// r = Q_i n_i + T_i t_i − Q_o n_o − T_o t_o + (0, F_c)
    /// n = (sin α, cos α)   t = (cos α, −sin α)
    /// ```
    #[inline(always)]
    pub(super) fn balance<const D: usize>(
        &self,
        positions: &Positions<Dual<f64, D>>,
        load: impl Fn(usize, f64) -> (f64, f64),
        force_scale: f64,
    ) -> Balance<Dual<f64, D>> {
        let Positions {
            centre: [x, y],
            groove: [axial, radial],
            drop,
        } = *positions;
        // both contacts: L, α, Q(L)
        let free = [drop[0] + self.free[0], drop[1] + self.free[1]];
        let contacts = [
            Contact::new([axial - x, radial - y], free[0], 0, &load),
            Contact::new([x, y], free[1], 1, &load),
        ];
        // F_c, T_i and T_o at these angles
        let inertia = self.inertia.forces(&contacts, force_scale);
        let [inner, outer] = inertia.friction;
        // Q n + T t at both races
        let [ring_force, outer_force] =
            [(&contacts[0], inner), (&contacts[1], outer)].map(|(contact, friction)| {
                [
                    contact.load * contact.sin + friction * contact.cos,
                    contact.load * contact.cos - friction * contact.sin,
                ]
            });
        Balance {
            residual: [
                ring_force[0] - outer_force[0],
                ring_force[1] - outer_force[1] + inertia.centrifugal,
            ],
            ring_force,
            contacts,
            inertia,
        }
    }

    /// What the ball answers in balance.
    #[inline(always)]
    pub(super) fn response<T: Number>(&self, balance: &Balance<T>) -> Response<T> {
        let [axial, radial] = balance.ring_force;
        let [inner, outer] = &balance.contacts;
        [
            axial,
            radial,
            // λ_i f_i M_g = f_i D T_i
            balance.inertia.friction[0] * -self.groove_radius,
            inner.load,
            outer.load,
            inner.approach,
        ]
    }

    /// Derivatives of the response in balance by the position of the inner groove centre, axial and radial, and by the
    /// drops of both surfaces, the ball's centre following so that its balance keeps: `dX/da = −(∂r/∂X)⁻¹ ∂r/∂a`.
    /// Zero where no load holds the ball. `load` and `force_scale` as for [`Ball::balance`].
    pub(super) fn slopes(
        &self,
        positions: &Positions,
        load: impl Fn(usize, f64) -> (f64, f64),
        force_scale: f64,
    ) -> [[f64; 4]; 6] {
        // the centre's position first, then what it follows
        let variable = |[x, y]: Plane<f64>, first: usize| -> Plane<Dual<f64, 6>> {
            [Dual::variable(x, first), Dual::variable(y, first + 1)]
        };
        let positions = Positions {
            centre: variable(positions.centre, 0),
            groove: variable(positions.groove, 2),
            drop: variable(positions.drop, 4),
        };
        let balance = self.balance(&positions, load, force_scale);
        let residual = balance.residual.map(|residual| residual.slopes);
        let by_centre = residual.map(|[x, y, ..]| [x, y]);
        // no load, no force; and without inertia nothing then holds the ball anywhere
        let loaded = balance.contacts[0].load.value > 0.0;
        let Some(inverse) = inverse(&by_centre).filter(|_| loaded) else {
            return [[0.0; 4]; 6];
        };
        self.response(&balance).map(|response| {
            std::array::from_fn(|index| {
                let [x, y] = apply(&inverse, residual.map(|row| row[2 + index]));
                response.slopes[2 + index] - response.slopes[0] * x - response.slopes[1] * y
            })
        })
    }
}

/// `A x`
#[inline(always)]
pub(super) fn apply(a: &[Plane<f64>; 2], x: Plane<f64>) -> Plane<f64> {
    a.map(|row| row[0] * x[0] + row[1] * x[1])
}

/// `A⁻¹`; nothing for a singular matrix.
#[inline(always)]
pub(super) fn inverse(&[[a, b], [c, d]]: &[Plane<f64>; 2]) -> Option<[Plane<f64>; 2]> {
    let scale = 1.0 / (a * d - b * c);
    let inverse = [[d * scale, -b * scale], [-c * scale, a * scale]];
    scale.is_finite().then_some(inverse)
}

/// Axial and radial component.
pub(super) type Plane<T> = [T; 2];

/// Distance, direction and load between the ball's centre and a groove centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact<T> {
    /// Distance of the centres L, m.
    pub(super) length: T,
    /// Approach: L less the distance of the centres at first touch, m.
    pub(super) approach: T,
    /// sin α and cos α: from centre to centre away from the outer groove centre.
    pub(super) sin: T,
    pub(super) cos: T,
    /// Normal load Q, N.
    pub(super) load: T,
    /// dQ/dL, N/m.
    pub(super) stiffness: f64,
}

impl<T: Copy> Contact<T> {
    /// The contact with another kind of number.
    #[inline(always)]
    pub(super) fn map<U>(&self, to: impl Fn(T) -> U) -> Contact<U> {
        Contact {
            length: to(self.length),
            approach: to(self.approach),
            sin: to(self.sin),
            cos: to(self.cos),
            load: to(self.load),
            stiffness: self.stiffness,
        }
    }
}

impl<const D: usize> Contact<Dual<f64, D>> {
    /// Contact of a race along a vector in m, the centres at first touch at a distance of `free` in m; a vanishing
    /// vector is taken for radial.
    #[inline(always)]
    fn new(
        [axial, radial]: Plane<Dual<f64, D>>,
        free: Dual<f64, D>,
        race: usize,
        load: &impl Fn(usize, f64) -> (f64, f64),
    ) -> Self {
        let square = axial * axial + radial * radial;
        let (length, sin, cos) = if square.value > 0.0 {
            // L and 1/L by one division
            let value = square.value.sqrt();
            let inverse = 1.0 / value;
            let length = square.chained(value, 0.5 * inverse);
            let inverse = square.chained(inverse, -0.5 * inverse * inverse * inverse);
            (length, axial * inverse, radial * inverse)
        } else {
            let [length, sin, cos] = [f64::MIN_POSITIVE, 0.0, 1.0].map(Dual::fixed);
            (length, sin, cos)
        };
        let approach = length - free;
        let (load, stiffness) = load(race, approach.value);
        Self {
            length,
            approach,
            sin,
            cos,
            load: approach.chained(load, stiffness),
            stiffness,
        }
    }
}
