//! Hertz contact of a ball and a race: ellipse, approach, stress and stiffness.

use std::f64::consts::PI;

use super::{Curvature, at_least, complete_elliptic_first, complete_elliptic_second};

/// Why a Hertz contact cannot be formed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HertzError {
    /// The curvature difference is outside the range of an elliptic point contact.
    #[error(
        "the curvature difference F(ρ) = {difference} is not in 0 … 1 (exclusive): the bodies do \
         not meet in an ellipse; check groove factor, ball and pitch diameter"
    )]
    Difference {
        /// Curvature difference F(ρ) as given.
        difference: f64,
    },
    /// The curvature sum or the modulus is not a positive finite number.
    #[error("curvature sum {sum} 1/m and contact modulus {modulus} Pa must be positive and finite")]
    Scale {
        /// Curvature sum Σρ, 1/m.
        sum: f64,
        /// Contact modulus E*, Pa.
        modulus: f64,
    },
}

/// Size and stress of the contact ellipse under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEllipse {
    /// Semi-axis a across the rolling direction, m.
    pub semi_major: f64,
    /// Semi-axis b along the rolling direction, m.
    pub semi_minor: f64,
    /// Largest contact pressure, Pa.
    pub peak_pressure: f64,
    /// Approach of the two bodies, m.
    pub approach: f64,
}

/// An elliptic point contact of given curvature and modulus.
///
/// ```text
/// κ = a/b solves  F(ρ) = [(κ² + 1)E − 2K]/[(κ² − 1)E],  m = 1 − 1/κ²
/// a* = (2κ²E/π)^(1/3)   b* = (2E/(πκ))^(1/3)   δ* = (2K/π)[π/(2κ²E)]^(1/3)
/// a = a*[3Q/(2ΣρE*)]^(1/3)   b likewise   p_max = 3Q/(2πab)
/// δ = δ*[3Q/(2ΣρE*)]^(2/3) Σρ/2   so   Q = K_h δ^(3/2)
/// ```
///
/// `K`, `E` are complete elliptic integrals of parameter m, `Q` the normal load in N. Holds for
/// smooth elastic bodies whose ellipse is small against their radii. Nothing is fitted: κ is
/// solved to round-off.
///
/// Source: H. Hertz (1881); Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007),
/// eqs. 6.27–6.43.
///
/// ```
/// use jeffcott::physics::{Curvature, HertzContact};
/// // Harris, Table 6.1: F(ρ) = 0.93657 → a* = 3.738, b* = 0.4166, δ* = 0.6112.
/// let contact = HertzContact::new(Curvature { sum: 1.0, difference: 0.93657 }, 1.0)?;
/// assert!((contact.semi_major_constant() - 3.738).abs() < 5e-4);
/// assert!((contact.semi_minor_constant() - 0.4166).abs() < 5e-5);
/// assert!((contact.approach_constant() - 0.6112).abs() < 5e-5);
/// # Ok::<(), jeffcott::physics::HertzError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzContact {
    curvature_sum: f64,
    modulus: f64,
    ellipticity: f64,
    elliptic_first: f64,
    elliptic_second: f64,
}

impl HertzContact {
    /// Solves the ellipticity for a curvature and a contact modulus E* in Pa.
    ///
    /// # Errors
    /// [`HertzError`] where F(ρ) is outside 0 … 1 or a scale is not positive.
    pub fn new(curvature: Curvature, modulus: f64) -> Result<Self, HertzError> {
        let Curvature { sum, difference } = curvature;
        if !(difference > 0.0 && difference < 1.0) {
            return Err(HertzError::Difference { difference });
        }
        if !(sum > 0.0 && sum.is_finite() && modulus > 0.0 && modulus.is_finite()) {
            return Err(HertzError::Scale { sum, modulus });
        }
        let ellipticity = solve_ellipticity(difference);
        let parameter = ellipse_parameter(ellipticity);
        Ok(Self {
            curvature_sum: sum,
            modulus,
            ellipticity,
            elliptic_first: complete_elliptic_first(parameter),
            elliptic_second: complete_elliptic_second(parameter),
        })
    }

    /// Ellipticity κ = a/b, dimensionless, at least 1.
    pub fn ellipticity(&self) -> f64 {
        self.ellipticity
    }

    /// Dimensionless semi-axis a*.
    pub fn semi_major_constant(&self) -> f64 {
        let kappa = self.ellipticity;
        // a* = (2κ²E/π)^(1/3)
        (2.0 * kappa * kappa * self.elliptic_second / PI).cbrt()
    }

    /// Dimensionless semi-axis b*.
    pub fn semi_minor_constant(&self) -> f64 {
        // b* = (2E/(πκ))^(1/3)
        (2.0 * self.elliptic_second / (PI * self.ellipticity)).cbrt()
    }

    /// Dimensionless approach δ*.
    pub fn approach_constant(&self) -> f64 {
        let kappa = self.ellipticity;
        // δ* = (2K/π)[π/(2κ²E)]^(1/3)
        2.0 * self.elliptic_first / PI * (PI / (2.0 * kappa * kappa * self.elliptic_second)).cbrt()
    }

    /// Stiffness constant K_h of `Q = K_h δ^(3/2)`, N/m^1.5.
    pub fn stiffness(&self) -> f64 {
        // δ = δ* [3Q/(2ΣρE*)]^(2/3) Σρ/2, solved for Q
        let sum = self.curvature_sum;
        let ratio = 2.0 / (self.approach_constant() * sum);
        2.0 * sum * self.modulus / 3.0 * ratio * ratio.sqrt()
    }

    /// Ellipse, peak pressure and approach under the normal load `load` in N (zero if negative).
    pub fn ellipse(&self, load: f64) -> ContactEllipse {
        let load = at_least(load, 0.0);
        let scale = (3.0 * load / (2.0 * self.curvature_sum * self.modulus)).cbrt();
        let semi_major = self.semi_major_constant() * scale;
        let semi_minor = self.semi_minor_constant() * scale;
        let peak_pressure = match load == 0.0 {
            true => 0.0,
            false => 3.0 * load / (2.0 * PI * semi_major * semi_minor),
        };
        ContactEllipse {
            semi_major,
            semi_minor,
            peak_pressure,
            approach: self.approach_constant() * scale * scale * self.curvature_sum / 2.0,
        }
    }
}

/// Stiffness constant of two races in series under equal loads, N/m^1.5.
///
/// `K_n = [K_i^(−2/3) + K_o^(−2/3)]^(−3/2)`
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eq. 7.6.
///
/// ```
/// use jeffcott::physics::series_stiffness;
/// // Two equal springs: K_n = K/2^1.5.
/// assert!((series_stiffness(8.0, 8.0) - 8.0 / 2f64.powf(1.5)).abs() < 1e-14);
/// ```
pub fn series_stiffness(inner: f64, outer: f64) -> f64 {
    let compliance = inner.cbrt().powi(-2) + outer.cbrt().powi(-2);
    compliance.powf(-1.5)
}

/// Elliptic parameter m = 1 − 1/κ².
fn ellipse_parameter(kappa: f64) -> f64 {
    (kappa - 1.0) * (kappa + 1.0) / (kappa * kappa)
}

/// F(ρ) that belongs to an ellipticity, and dF/dκ.
fn difference_of_ellipticity(kappa: f64) -> (f64, f64) {
    let m = ellipse_parameter(kappa);
    let (k, e) = (complete_elliptic_first(m), complete_elliptic_second(m));
    let square = kappa * kappa;
    let (numerator, denominator) = ((square + 1.0) * e - 2.0 * k, (square - 1.0) * e);
    // dE/dm = (E − K)/(2m), dK/dm = (E − (1 − m)K)/(2m(1 − m)), dm/dκ = 2/κ³
    let dm = 2.0 / (square * kappa);
    let de = (e - k) / (2.0 * m) * dm;
    let dk = (e - (1.0 - m) * k) / (2.0 * m * (1.0 - m)) * dm;
    let d_numerator = 2.0 * kappa * e + (square + 1.0) * de - 2.0 * dk;
    let d_denominator = 2.0 * kappa * e + (square - 1.0) * de;
    let value = numerator / denominator;
    (value, (d_numerator - value * d_denominator) / denominator)
}

/// κ from F(ρ): Newton in ln κ kept inside a bracket, to round-off.
fn solve_ellipticity(difference: f64) -> f64 {
    let (mut low, mut high) = (1.0 + 1e-9, 1e8);
    // Brewe & Hamrock (1977): κ ≈ 1.0339 (R_y/R_x)^0.636, with R_y/R_x = (1 + F)/(1 − F).
    let mut kappa = (1.0339 * ((1.0 + difference) / (1.0 - difference)).powf(0.636))
        .clamp(low * 1.000_001, high * 0.999_999);
    for _ in 0..100 {
        let (value, slope) = difference_of_ellipticity(kappa);
        if value > difference {
            high = kappa;
        } else {
            low = kappa;
        }
        let step = (difference - value) / (slope * kappa);
        let newton = kappa * step.clamp(-1.0, 1.0).exp();
        let next = if newton > low && newton < high {
            newton
        } else {
            (low * high).sqrt()
        };
        if (next - kappa).abs() <= 4.0 * f64::EPSILON * kappa {
            return next;
        }
        kappa = next;
    }
    kappa
}
