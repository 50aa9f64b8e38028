//! Complete elliptic integrals, exact to round-off.

/// Complete elliptic integral of the first kind K(m), `m = k²` the parameter.
///
/// `K(m) = ∫₀^{π/2} dθ/√(1 − m sin²θ)`, for m < 1; NaN outside.
///
/// ```
/// use jeffcott::physics::complete_elliptic_first;
/// // Abramowitz & Stegun (1964), table 17.1: K(0.5) = 1.85407 46773 01372.
/// assert!((complete_elliptic_first(0.5) - 1.854_074_677_301_372).abs() < 1e-14);
/// ```
pub fn complete_elliptic_first(parameter: f64) -> f64 {
    ellip::ellipk(parameter).unwrap_or(f64::NAN)
}

/// Complete elliptic integral of the second kind E(m), `m = k²` the parameter.
///
/// `E(m) = ∫₀^{π/2} √(1 − m sin²θ) dθ`, for m ≤ 1; NaN outside.
///
/// ```
/// use jeffcott::physics::complete_elliptic_second;
/// // Abramowitz & Stegun (1964), table 17.1: E(0.5) = 1.35064 38810 47676.
/// assert!((complete_elliptic_second(0.5) - 1.350_643_881_047_676).abs() < 1e-14);
/// ```
pub fn complete_elliptic_second(parameter: f64) -> f64 {
    ellip::ellipe(parameter).unwrap_or(f64::NAN)
}
