//! Thickness of the oil film in an elastohydrodynamic point or line contact.

/// Entrainment speed of the oil at both races, m/s.
///
/// `u = d_m ω (1 − γ²)/4`
///
/// `d_m` pitch diameter in m, `ω` shaft speed in rad/s (its size counts, not its sense),
/// `γ = D cos α/d_m`. Pure rolling with the outer ring fixed; mean of the surface speeds of ball
/// and race, the same at both races.
///
/// Source: Hamrock, Schmid & Jacobson, *Fundamentals of Fluid Film Lubrication*, 2nd ed. (2004),
/// rolling-element bearings.
///
/// ```
/// use jeffcott::physics::entrainment_speed;
/// // Cylinders rolling without a difference of diameters: a quarter of d_m ω.
/// assert_eq!(entrainment_speed(0.04, 0.0, 100.0), 1.0);
/// ```
pub fn entrainment_speed(pitch_diameter: f64, gamma: f64, shaft_speed: f64) -> f64 {
    0.25 * pitch_diameter * shaft_speed.abs() * (1.0 - gamma * gamma)
}

/// Shape of a contact under an oil film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FilmShape {
    /// Of a ball.
    Point {
        /// Ellipticity κ = a/b, dimensionless.
        ellipticity: f64,
    },
    /// Of a roller that is pressed alike along its length.
    Line {
        /// Effective length L, m.
        length: f64,
    },
}

/// What the film between a ball or a roller and a race depends on, apart from speed and load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmInputs {
    /// Effective radius in the rolling direction R_x, m: `D(1 ∓ γ)/2`, − at the inner race.
    pub radius: f64,
    /// Effective modulus E' = 2E*, Pa.
    pub modulus: f64,
    /// Shape of the contact.
    pub shape: FilmShape,
    /// Viscosity of the oil at ambient pressure η0, Pa s.
    pub viscosity: f64,
    /// Pressure–viscosity coefficient α_p, 1/Pa.
    pub pressure_viscosity: f64,
}

/// Oil film of one contact: thickness as a power law of speed and load.
///
/// ```text
/// U = η0 u/(E' R_x)   G = α_p E'   W = Q/(E' R_x²) of a point, Q/(E' R_x L) of a line
/// point  h_c   = 2.69 R_x U^0.67 G^0.53 W^(−0.067) (1 − 0.61 e^(−0.73 κ))
///        h_min = 3.63 R_x U^0.68 G^0.49 W^(−0.073) (1 − e^(−0.68 κ))
/// line   h_c   = 2.922 R_x U^0.692 G^0.470 W^(−0.166)
///        h_min = 1.714 R_x U^0.694 G^0.568 W^(−0.128)
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | u | entrainment speed | m/s |
/// | Q | normal load | N |
/// | h_c, h_min | central and minimum thickness | m |
///
/// Holds for hard (piezoviscous-elastic) contacts, fully flooded, isothermal. At rest there is no
/// film; at zero load the power law has no bound and gives infinity.
///
/// Source: B. J. Hamrock & D. Dowson, *J. Lubrication Technology* 99 (1977) 264–276, part III; lines: P. Pan & B. J.
/// Hamrock, *J. Tribology* 111 (1989) 246–251.
///
/// ```
/// use jeffcott::physics::{FilmContact, FilmInputs, FilmShape, entrainment_speed};
/// // 7205C at 1000 rad/s, Q = 251.39 N, η0 = 0.04 Pa s, α_p = 22 1/GPa, inner race:
/// // h_c = 0.8562 µm, h_min = 0.7001 µm (independent implementations).
/// let gamma = 7.938e-3 * 15f64.to_radians().cos() / 38.5e-3;
/// let film = FilmContact::new(FilmInputs {
///     radius: 0.5 * 7.938e-3 * (1.0 - gamma),
///     modulus: 207e9 / (1.0 - 0.09),
///     shape: FilmShape::Point { ellipticity: 9.311379 },
///     viscosity: 0.04,
///     pressure_viscosity: 2.2e-8,
/// });
/// let speed = entrainment_speed(38.5e-3, gamma, 1000.0);
/// assert!((film.central(speed, 251.39) - 0.8562e-6).abs() < 5e-11);
/// assert!((film.minimum(speed, 251.39) - 0.7001e-6).abs() < 5e-11);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmContact {
    central: PowerLaw,
    minimum: PowerLaw,
}

/// A thickness in m, `c u^p Q^(−q)`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PowerLaw {
    constant: f64,
    speed: f64,
    load: f64,
}

impl PowerLaw {
    fn at(&self, entrainment: f64, load: f64) -> f64 {
        self.constant * entrainment.powf(self.speed) * load.powf(-self.load)
    }
}

impl FilmContact {
    /// Exponent of the speed in the central thickness of a point contact.
    pub const SPEED_EXPONENT: f64 = 0.67;
    /// Exponent of the load in the central thickness of a point contact, without its minus sign.
    pub const LOAD_EXPONENT: f64 = 0.067;

    /// Gathers everything that depends neither on speed nor on load.
    pub fn new(inputs: FilmInputs) -> Self {
        let FilmInputs {
            radius: r_x,
            modulus: e,
            shape,
            viscosity,
            pressure_viscosity,
        } = inputs;
        // U and W at an entrainment of 1 m/s and a load of 1 N
        let u = viscosity / (e * r_x);
        let g = pressure_viscosity * e;
        let across = match shape {
            FilmShape::Point { .. } => r_x,
            FilmShape::Line { length } => length,
        };
        let w = 1.0 / (e * r_x * across);
        let law = |factor: f64, speed: f64, material: f64, load: f64, side: f64| PowerLaw {
            constant: factor * r_x * u.powf(speed) * g.powf(material) * w.powf(-load) * side,
            speed,
            load,
        };
        let [central, minimum] = match shape {
            FilmShape::Point { ellipticity: kappa } => [
                law(
                    2.69,
                    Self::SPEED_EXPONENT,
                    0.53,
                    Self::LOAD_EXPONENT,
                    1.0 - 0.61 * (-0.73 * kappa).exp(),
                ),
                law(3.63, 0.68, 0.49, 0.073, 1.0 - (-0.68 * kappa).exp()),
            ],
            FilmShape::Line { .. } => [
                law(2.922, 0.692, 0.470, 0.166, 1.0),
                law(1.714, 0.694, 0.568, 0.128, 1.0),
            ],
        };
        Self { central, minimum }
    }

    /// Central thickness at 1 m/s and 1 N, m.
    pub fn central_constant(&self) -> f64 {
        self.central.constant
    }

    /// Central thickness h_c at an entrainment speed in m/s and a load in N, m.
    pub fn central(&self, entrainment: f64, load: f64) -> f64 {
        self.central.at(entrainment, load)
    }

    /// Derivative of the central thickness by the load, m/N: `dh/dQ = −q h/Q`, q = 0.067 of a point contact.
    ///
    /// The film's own stiffness `|dQ/dh| = Q/(q h)` is the inverse of its size.
    pub fn central_slope(&self, entrainment: f64, load: f64) -> f64 {
        -self.central.load * self.central(entrainment, load) / load
    }

    /// Minimum thickness h_min at an entrainment speed in m/s and a load in N, m.
    pub fn minimum(&self, entrainment: f64, load: f64) -> f64 {
        self.minimum.at(entrainment, load)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact(shape: FilmShape) -> FilmContact {
        FilmContact::new(FilmInputs {
            radius: 3.1e-3,
            modulus: 227e9,
            shape,
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        })
    }

    const SHAPES: [FilmShape; 2] = [
        FilmShape::Point { ellipticity: 9.3 },
        FilmShape::Line { length: 8e-3 },
    ];

    #[test]
    fn no_speed_no_film() {
        for contact in SHAPES.map(contact) {
            assert_eq!(contact.central(0.0, 100.0), 0.0);
            assert_eq!(contact.minimum(0.0, 100.0), 0.0);
        }
    }

    #[test]
    fn slope_is_the_derivative_of_the_thickness() {
        for film in SHAPES.map(contact) {
            let (u, q) = (9.0, 150.0);
            let step = 1e-3 * q;
            let difference = (film.central(u, q + step) - film.central(u, q - step)) / (2.0 * step);
            assert!((film.central_slope(u, q) / difference - 1.0).abs() < 1e-6);
        }
    }
}
