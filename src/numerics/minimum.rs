//! Minima of a function of one variable.

/// (√5 − 1)/2: of two places that divide an interval in this ratio from either end, one divides what is left of it so.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Place and value of the minimum of a function that first falls and then rises between two ends, the lower one first, to within
/// a length: by the golden section, with one value a step, which leaves the interval 0.618 times as long.
///
/// About its minimum a smooth function is flat: to less than 1e-8 of the place round-off decides.
///
/// Source: Kiefer, *Proc. American Mathematical Society* 4 (1953) 502–506.
///
/// # Errors
/// The first error of the function.
pub(crate) fn minimum<E>(
    mut value: impl FnMut(f64) -> Result<f64, E>,
    [mut low, mut high]: [f64; 2],
    within: f64,
) -> Result<(f64, f64), E> {
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut places = inner(low, high);
    let mut values = [value(places[0])?, value(places[1])?];
    while high - low > within && places[0] < places[1] {
        if values[0] < values[1] {
            high = places[1];
            places = [inner(low, high)[0], places[0]];
            values = [value(places[0])?, values[0]];
        } else {
            low = places[0];
            places = [places[1], inner(low, high)[1]];
            values = [values[1], value(places[1])?];
        }
    }
    let least = usize::from(values[1] < values[0]);
    Ok((places[least], values[least]))
}

#[cfg(test)]
mod tests {
    use super::minimum;

    #[test]
    fn a_minimum_is_found_within_a_length() {
        let mut count = 0;
        let value = |place: f64| {
            count += 1;
            Ok::<_, ()>((place - 0.3).powi(2) + 2.0)
        };
        let (place, least) = minimum(value, [0.0, 1.0], 1e-6).expect("no error");
        assert!(
            (place - 0.3).abs() < 1e-6 && (least - 2.0).abs() < 1e-11,
            "{place} {least}"
        );
        // 0.618³⁰ is less than 1e-6
        assert_eq!(count, 2 + 29);
        // where the function is flat it ends, too
        assert!(minimum(|_| Ok::<_, ()>(1.0), [1.0, 2.0], 0.0).is_ok());
        assert_eq!(minimum(|_| Err(7), [1.0, 2.0], 0.1), Err(7));
    }
}
