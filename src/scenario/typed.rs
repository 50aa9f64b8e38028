//! Values that are written by themselves, as options of the command are: each as the key of a scenario is.

use std::sync::LazyLock;

use super::Issue;
use super::key::Key;
use crate::integrate::Method;

/// The number in SI units that the key of a path can have; in it `load[]` stands for any load. `name` is what messages
/// call it.
///
/// # Errors
/// [`Issue`] says what is wrong with the text.
pub fn number(text: &str, path: &str, name: &str) -> Result<f64, Issue> {
    let key = Key::named(path);
    Ok(key.si(&key.typed(text, name)?))
}

/// A speed with its unit in rad/s, zero or positive.
///
/// # Errors
/// [`Issue`] says what is wrong with the text.
pub fn speed(text: &str) -> Result<f64, Issue> {
    number(text, "speed.constant", "speed")
}

/// A frequency with its unit in Hz, positive.
///
/// # Errors
/// [`Issue`] says what is wrong with the text.
pub fn frequency(text: &str) -> Result<f64, Issue> {
    number(text, "output.sample_rate", "frequency")
}

/// Seconds of a time with its unit, zero or positive.
///
/// # Errors
/// [`Issue`] says what is wrong with the text.
pub fn time(text: &str) -> Result<f64, Issue> {
    number(text, "time.settle", "time")
}

/// A position along the shaft with its unit in m.
///
/// # Errors
/// [`Issue`] says what is wrong with the text.
pub fn position(text: &str) -> Result<f64, Issue> {
    number(text, "load[].position", "position")
}

/// A tolerance as a run can be asked to keep to.
///
/// # Errors
/// [`Issue`] where it is none.
pub fn tolerance(text: &str) -> Result<f64, Issue> {
    number(text, "integrator.tolerance", "tolerance")
}

/// All methods that a scenario can name.
pub fn methods() -> &'static [Method] {
    static METHODS: LazyLock<Vec<Method>> = LazyLock::new(|| {
        let words = Key::named("integrator.method").words().into_iter();
        words.filter_map(|word| method(word).ok()).collect()
    });
    &METHODS
}

/// The method of a name.
///
/// # Errors
/// [`Issue`] names those that there are.
pub fn method(name: &str) -> Result<Method, Issue> {
    let word = Key::named("integrator.method").typed(name, "method")?;
    serde_json::from_value(word).map_err(|error| Issue::new("method", error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_speed_needs_its_unit() {
        assert_eq!(speed("500 rad/s").unwrap(), 500.0);
        assert!(speed("500").is_err());
    }

    #[test]
    fn a_time_needs_its_unit() {
        assert_eq!(time("250 ms").unwrap(), 0.25);
        assert!(time("0.25").is_err());
    }

    #[test]
    fn a_tolerance_is_positive() {
        assert_eq!(tolerance("1e-6"), Ok(1e-6));
        assert!(tolerance("0").is_err());
    }

    #[test]
    fn methods_have_the_names_of_a_scenario() {
        let names = methods();
        assert!(names.iter().any(|named| named.to_string() == "dop853"));
    }
}
