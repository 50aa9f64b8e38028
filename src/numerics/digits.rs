//! Numbers with as many digits as people read.

/// A value with at most so many significant digits.
pub(crate) fn to_digits(value: f64, count: usize) -> f64 {
    let decimals = count - 1;
    format!("{value:.decimals$e}").parse().unwrap_or(value)
}
