//! Load of a contact by its approach.

use crate::bearing::number::{Function, Number};

/// Load of one contact, or of two in series, as a function of the approach.
///
/// The load never decreases with the approach and is never negative.
pub trait ContactSpring {
    /// Whether the load is smooth where the surfaces part, as behind an oil film.
    const IS_SMOOTH: bool;

    /// Load Q in N at an approach `s` in m, negative when apart, in the innermost loop.
    fn load<T: Number>(&self, approach: T) -> T;

    /// Load Q in N and stiffness dQ/ds in N/m at an approach `s` in m, negative when apart.
    fn load_and_stiffness(&self, approach: f64) -> (f64, f64);

    /// Approach s in m under a load in N: the inverse.
    fn approach(&self, load: f64) -> f64;

    /// Roughly by how much a film holds the surfaces apart under load, m.
    fn lift(&self) -> f64;
}

/// A contact whose spring depends on the shaft speed where it has a film.
pub trait PreparedContact: Copy {
    /// What the contact is at one speed.
    type Spring: ContactSpring;

    /// Spring at a shaft speed in rad/s.
    fn at_speed(&self, speed: f64) -> Self::Spring;

    /// The elastic bodies without film.
    fn elastic(&self) -> HertzSpring;
}

/// Dry contact: `Q = K s^(3/2)` for s > 0, nothing otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzSpring {
    /// Stiffness constant K, N/m^1.5.
    pub stiffness: f64,
}

impl HertzSpring {
    /// Two alike in series that make one of this stiffness constant: `K_n = [2 K^(−2/3)]^(−3/2)`.
    pub fn halves(series: f64) -> [Self; 2] {
        let stiffness = series * 2f64.powf(1.5);
        [Self { stiffness }; 2]
    }

    /// Stiffness under a load in N, N/m.
    ///
    /// `dQ/ds = 3/2 K^(2/3) Q^(1/3)`
    pub fn stiffness_under(&self, load: f64) -> f64 {
        // 3/2 K^(2/3) Q^(1/3)
        1.5 * self.stiffness.cbrt().powi(2) * load.cbrt()
    }
}

impl ContactSpring for HertzSpring {
    const IS_SMOOTH: bool = false;

    #[inline(always)]
    fn load<T: Number>(&self, approach: T) -> T {
        let pressed = approach.positive();
        // Q = K s √s
        pressed * self.stiffness * pressed.sqrt()
    }

    #[inline]
    fn load_and_stiffness(&self, approach: f64) -> (f64, f64) {
        let s = approach.max(0.0);
        // dQ/ds = 3/2 K √s,  Q = K s √s
        let root = self.stiffness * s.sqrt();
        (root * s, 1.5 * root)
    }

    #[inline]
    fn approach(&self, load: f64) -> f64 {
        // s = (Q/K)^(2/3)
        let root = (load / self.stiffness).cbrt();
        root * root
    }

    #[inline]
    fn lift(&self) -> f64 {
        0.0
    }
}

impl PreparedContact for HertzSpring {
    type Spring = Self;

    #[inline(always)]
    fn at_speed(&self, _speed: f64) -> Self {
        *self
    }

    #[inline(always)]
    fn elastic(&self) -> Self {
        *self
    }
}

/// From the load to the elastic approach.
impl Function<1, 1> for HertzSpring {
    fn with_slopes(&self, [load]: [f64; 1]) -> ([f64; 1], [[f64; 1]; 1]) {
        let stiffness = self.stiffness_under(load);
        let slope = if stiffness > 0.0 {
            1.0 / stiffness
        } else {
            0.0
        };
        ([self.approach(load)], [[slope]])
    }

    fn values(&self, [load]: [f64; 1]) -> [f64; 1] {
        [self.approach(load)]
    }
}

/// Elastic approaches of both contacts under their loads in N, m.
#[inline(always)]
pub(super) fn approaches_under<T: Number>(springs: &[HertzSpring; 2], load: [T; 2]) -> [T; 2] {
    let [inner] = T::apply(&springs[0], [load[0]]);
    let [outer] = T::apply(&springs[1], [load[1]]);
    [inner, outer]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn springs_in_a_row_have_the_tangent_under_a_load() {
        // K = 8, Q = 27: s = (27/8)^(2/3) = 9/4 and 3/2 K √s = 18.
        let spring = HertzSpring { stiffness: 8.0 };
        assert!((spring.stiffness_under(27.0) - 18.0).abs() < 1e-14);
    }
}
