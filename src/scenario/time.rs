//! A time as it stands on a command line.

use super::dimension::Dimension;
use super::quantity::{QuantityError, parse};

/// Why a text is not a time.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(transparent)]
pub struct TimeError(Cause);

#[derive(Debug, Clone, PartialEq, thiserror::Error)]
enum Cause {
    #[error("{0}; write a time with its unit, as in \"0.25 s\"")]
    Quantity(QuantityError),
    #[error("a time of {0} s is before the start")]
    Negative(f64),
}

/// Seconds of a time with its unit, zero or positive.
///
/// # Errors
/// [`TimeError`] says what is wrong with the text.
///
/// ```
/// assert_eq!(jeffcott::scenario::time("250 ms").unwrap(), 0.25);
/// assert!(jeffcott::scenario::time("0.25").is_err());
/// ```
pub fn time(text: &str) -> Result<f64, TimeError> {
    match parse(text, Dimension::Time) {
        Ok(parsed) if parsed.si < 0.0 => Err(TimeError(Cause::Negative(parsed.si))),
        Ok(parsed) => Ok(parsed.si),
        Err(error) => Err(TimeError(Cause::Quantity(error))),
    }
}
