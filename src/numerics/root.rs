//! Roots of a function of one variable.

/// An interval at whose ends a continuous function has values of opposite sign, narrowed by the regula falsi.
///
/// Source: the Illinois algorithm, Dowell & Jarratt, *BIT* 11 (1971) 168–174: an end that stays twice loses half of
/// its weight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bracket {
    ends: [f64; 2],
    values: [f64; 2],
    /// Whether the latest value was taken for the upper end.
    latest: Option<bool>,
}

impl Bracket {
    /// The interval between two positions with the values there; none where both have one sign.
    pub fn new(ends: [f64; 2], values: [f64; 2]) -> Option<Self> {
        let differ = (values[0] >= 0.0) != (values[1] >= 0.0);
        differ.then_some(Self {
            ends,
            values,
            latest: None,
        })
    }

    /// Where the root is looked for next.
    pub fn guess(&self) -> f64 {
        let ([low, high], [at_low, at_high]) = (self.ends, self.values);
        ((low * at_high - high * at_low) / (at_high - at_low)).clamp(low, high)
    }

    /// Takes the value at a position within.
    pub fn narrow(&mut self, position: f64, value: f64) {
        let beyond = (value >= 0.0) == (self.values[1] >= 0.0);
        let end = usize::from(beyond);
        (self.ends[end], self.values[end]) = (position, value);
        if self.latest == Some(beyond) {
            self.values[1 - end] *= 0.5;
        }
        self.latest = Some(beyond);
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The end with the smaller value.
    pub fn nearest(&self) -> f64 {
        let [at_low, at_high] = self.values;
        self.ends[usize::from(at_low.abs() >= at_high.abs())]
    }
}

/// Values taken in a search.
const MOST_VALUES: usize = 60;

/// Root of a continuous function between two positions where it has these values, to within a distance; none where
/// both have one sign.
pub(crate) fn root(
    mut value: impl FnMut(f64) -> f64,
    ends: [f64; 2],
    values: [f64; 2],
    within: f64,
) -> Option<f64> {
    let mut bracket = Bracket::new(ends, values)?;
    for _ in 0..MOST_VALUES {
        let position = bracket.guess();
        let found = value(position);
        bracket.narrow(position, found);
        if bracket.length() < within || found == 0.0 {
            break;
        }
    }
    Some(bracket.nearest())
}

/// Where a condition begins to hold between two positions, by halving the interval to within a length, or to round-off.
/// It holds at the second end and not at the first.
pub(crate) fn bisection(
    mut holds: impl FnMut(f64) -> bool,
    [mut before, mut after]: [f64; 2],
    within: f64,
) -> f64 {
    while (after - before).abs() > within {
        let middle = 0.5 * (before + after);
        if middle == before || middle == after {
            break;
        }
        if holds(middle) {
            after = middle;
        } else {
            before = middle;
        }
    }
    0.5 * (before + after)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_found_to_round_off() {
        let value = |position: f64| (position - 0.3).powi(3) + 0.1 * (position - 0.3);
        let found = root(value, [0.0, 1.0], [0.0, 1.0].map(value), 1e-9);
        assert!(
            found.is_some_and(|position| (position - 0.3).abs() < 1e-9),
            "{found:?}"
        );
        let none = root(|position| position + 1.0, [0.0, 1.0], [1.0, 2.0], 1e-9);
        assert_eq!(none, None);
    }
}
