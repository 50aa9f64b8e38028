//! Hertz contact behind an oil film, as a spring.

use super::{ContactSpring, HertzSpring, PreparedContact};
use crate::bearing::number::{Function, Number};
use crate::physics::FilmContact;

/// Exponent of the load in Hertz's approach.
const HERTZ: f64 = 2.0 / 3.0;
/// Exponent of the load in the film thickness, without its minus sign.
const FILM: f64 = FilmContact::LOAD_EXPONENT;

/// A contact with film, prepared for one speed and right at every speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LubricatedContact {
    elastic: HertzSpring,
    load_scale: f64,
    /// Speed for which it is prepared, rad/s, and the spring there.
    prepared: (f64, FilmSpring),
}

impl LubricatedContact {
    /// `film` is c in m, the constant of `h = c ω^0.67 Q^(−0.067)` for the
    /// shaft speed ω in rad/s and the load Q in N; fastest at `speed` in rad/s.
    pub(super) fn new(elastic: HertzSpring, film: f64, speed: f64) -> Self {
        // (Q*/K)^(2/3) = c Q*^(−0.067)
        let load_scale = (film * elastic.stiffness.powf(HERTZ)).powf(1.0 / (HERTZ + FILM));
        Self {
            elastic,
            load_scale,
            prepared: (speed, FilmSpring::new(elastic, load_scale, speed)),
        }
    }
}

impl PreparedContact for LubricatedContact {
    type Spring = FilmSpring;

    #[inline]
    fn at_speed(&self, speed: f64) -> FilmSpring {
        match self.prepared {
            (prepared, spring) if speed == prepared => spring,
            _ => FilmSpring::new(self.elastic, self.load_scale, speed),
        }
    }

    #[inline]
    fn elastic(&self) -> HertzSpring {
        self.elastic
    }
}

/// Hertz contact behind an oil film at one speed.
///
/// ```text
/// s(Q) = (Q/K)^(2/3) − h(Q),   h = h* (Q/Q*)^(−0.067)
/// ```
///
/// `Q*` is the load at which film and Hertz approach are equal, `h*` that length. With
/// `y = ln(Q/Q*)` and `σ = s/h*` every contact has the same law
/// `σ = e^(2y/3) − e^(−0.067 y)`, strictly increasing, which is inverted to round-off. Without
/// speed the spring is the dry one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmSpring {
    dry: HertzSpring,
    load_scale: f64,
    film_scale: f64,
}

impl FilmSpring {
    /// With the scale Q* at 1 rad/s, at a shaft speed in rad/s. Out of line: inlined, its power would be taken in
    /// advance of loops that may need it, and so by dry bearings, too.
    #[inline(never)]
    fn new(dry: HertzSpring, load_scale: f64, speed: f64) -> Self {
        // Q* grows as c^(1/(2/3 + 0.067)), c as ω^0.67
        let exponent = FilmContact::SPEED_EXPONENT / (HERTZ + FILM);
        let load_scale = load_scale * speed.abs().powf(exponent);
        Self {
            dry,
            load_scale,
            film_scale: (load_scale / dry.stiffness).cbrt().powi(2),
        }
    }
}

impl ContactSpring for FilmSpring {
    const IS_SMOOTH: bool = true;

    #[inline(always)]
    fn load<T: Number>(&self, approach: T) -> T {
        let [load] = T::apply(self, [approach]);
        load
    }

    #[inline]
    fn load_and_stiffness(&self, approach: f64) -> (f64, f64) {
        if self.film_scale == 0.0 {
            return self.dry.load_and_stiffness(approach);
        }
        let (ratio, slope) = reduced_load(approach / self.film_scale);
        let load = self.load_scale * ratio;
        (load, load * slope / self.film_scale)
    }

    #[inline]
    fn approach(&self, load: f64) -> f64 {
        if self.film_scale == 0.0 || load == 0.0 {
            return self.dry.approach(load);
        }
        self.dry.approach(load) - self.film_scale * (load / self.load_scale).powf(-FILM)
    }

    #[inline]
    fn lift(&self) -> f64 {
        self.film_scale
    }
}

/// From the approach to the load.
impl Function<1, 1> for FilmSpring {
    #[inline]
    fn with_slopes(&self, [approach]: [f64; 1]) -> ([f64; 1], [[f64; 1]; 1]) {
        let (load, stiffness) = self.load_and_stiffness(approach);
        ([load], [[stiffness]])
    }
}

/// e^y and dy/dσ of `σ = e^(2y/3) − e^(−0.067 y)`, to round-off for any σ.
///
/// Halley's iteration in y from a fit that is right to 0.07 everywhere: the first step leaves
/// 2e-5, the second less than round-off. Both exponentials are carried along by factors.
#[inline]
fn reduced_load(sigma: f64) -> (f64, f64) {
    let start = reduced_load_start(sigma);
    // e^(y/3), of which the Hertz term is the square and the load the cube, and e^(−0.067 y)
    let mut third = (start * (1.0 / 3.0)).exp();
    let mut film = (-FILM * start).exp();
    // f(y) = e^(2y/3) − e^(−0.067 y) − σ and its derivatives
    for _ in 0..2 {
        let hertz = third * third;
        // Halley: Δy = −2 f f'/(2 f'² − f f'')
        let f = hertz - film - sigma;
        let slope = HERTZ * hertz + FILM * film;
        let curvature = HERTZ * HERTZ * hertz - FILM * FILM * film;
        let step = -2.0 * f * slope / (2.0 * slope * slope - f * curvature);
        // y ← y + Δy, both exponentials by factors
        third *= exp_of_small(step * (1.0 / 3.0));
        film *= exp_of_small(-FILM * step);
    }
    let slope = HERTZ * third * third + FILM * film;
    (third * third * third, 1.0 / slope)
}

/// e^x to round-off for |x| ≤ 0.03: its series to x⁷, grouped so that the terms do not wait for
/// one another.
#[inline]
fn exp_of_small(x: f64) -> f64 {
    let square = x * x;
    let low = 0.5 + x * (1.0 / 6.0);
    let middle = 1.0 / 24.0 + x * (1.0 / 120.0);
    let high = 1.0 / 720.0 + x * (1.0 / 5040.0);
    1.0 + (x + square * (low + square * (middle + square * high)))
}

/// y(σ) to 0.07: Hertz above, film below, a fitted polynomial between.
#[inline]
fn reduced_load_start(sigma: f64) -> f64 {
    if sigma > 0.5 {
        1.5 * (sigma + 0.92).ln()
    } else if sigma < -1.7 {
        (-sigma).ln() * (-1.0 / FILM)
    } else {
        const FIT: [f64; 6] = [-0.0275, 1.4403, -0.0025, -0.0642, -1.8324, -0.6685];
        FIT.iter().rev().fold(0.0, |sum, c| sum * sigma + c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reduced_law_is_inverted_to_round_off() {
        for step in -20_000..20_000 {
            let sigma = (f64::from(step) * 1e-3).sinh() * 1e-3 + 1e-4 * f64::from(step);
            let (ratio, _) = reduced_load(sigma);
            let (hertz, film) = (ratio.powf(HERTZ), ratio.powf(-FILM));
            let error = (hertz - film - sigma) / (hertz + film);
            assert!(error.abs() < 5e-15, "σ = {sigma}: {error:e}");
        }
    }

    #[test]
    fn the_reduced_slope_is_the_derivative() {
        for sigma in [-300.0, -5.0, -1.7, -1.0, 0.0, 0.5, 3.0, 1e4] {
            let step = 1e-5 * (1.0 + f64::abs(sigma));
            let (up, down) = (reduced_load(sigma + step).0, reduced_load(sigma - step).0);
            let difference = (up / down).ln() / (2.0 * step);
            assert!((reduced_load(sigma).1 / difference - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_thin_film_is_the_dry_spring() {
        let dry = HertzSpring { stiffness: 8e9 };
        let contact = LubricatedContact::new(dry, 1e-9, 0.0);
        for approach in [-1e-6, 0.0, 1e-5] {
            assert_eq!(
                contact.at_speed(0.0).load_and_stiffness(approach),
                dry.load_and_stiffness(approach)
            );
        }
        let (load, stiffness) = contact.at_speed(1e-12).load_and_stiffness(1e-5);
        let (dry_load, dry_stiffness) = dry.load_and_stiffness(1e-5);
        assert!((load / dry_load - 1.0).abs() < 1e-9);
        assert!((stiffness / dry_stiffness - 1.0).abs() < 1e-9);
    }
}
