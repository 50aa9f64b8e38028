//! A speed as it stands on a command line.

use super::dimension::Dimension;
use super::quantity::{QuantityError, parse};

/// Why a text is not a speed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(transparent)]
pub struct SpeedError(Cause);

#[derive(Debug, Clone, PartialEq, thiserror::Error)]
enum Cause {
    #[error("{0}; write a speed with its unit, as in \"3000 rpm\" or \"500 rad/s\"")]
    Quantity(QuantityError),
    #[error("a speed of {0} rad/s is negative: the shaft turns about +Z")]
    Negative(f64),
}

/// A speed with its unit in rad/s, zero or positive.
///
/// # Errors
/// [`SpeedError`] says what is wrong with the text.
///
/// ```
/// assert_eq!(jeffcott::scenario::speed("500 rad/s").unwrap(), 500.0);
/// assert!(jeffcott::scenario::speed("500").is_err());
/// ```
pub fn speed(text: &str) -> Result<f64, SpeedError> {
    match parse(text, Dimension::AngularSpeed) {
        Ok(parsed) if parsed.si < 0.0 => Err(SpeedError(Cause::Negative(parsed.si))),
        Ok(parsed) => Ok(parsed.si),
        Err(error) => Err(SpeedError(Cause::Quantity(error))),
    }
}
