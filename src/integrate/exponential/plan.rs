//! Where steps end: steps longer than the interval of the samples last a round number of intervals,
//! shorter ones an interval over a product of round numbers, so that few sizes occur and every sample is a step's end or
//! lies whole intervals after its start.

use crate::integrate::problem::SLACK;

/// The equal steps to the next time at which a step ends anyhow: a grid time or a break.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Span {
    /// Its end, s.
    pub end: f64,
    /// Steps that are left to it, and their size, s.
    pub left: f64,
    pub size: f64,
    /// The length from grid time or break to the next, s, and the parts of this size that it has.
    length: f64,
    parts: f64,
    /// Intervals of samples that its only step lasts; zero where it lasts no whole number.
    pub intervals: f64,
}

impl Span {
    /// From a time on in steps no longer than a requested size, on a grid of samples, up to a limit.
    pub fn new(time: f64, requested: f64, interval: f64, limit: f64) -> Self {
        let index = (time / interval).round();
        if index * interval == time {
            let free = ((limit - time) / interval + SLACK).floor();
            let intervals = round_below((requested / interval * (1.0 + SLACK)).min(free));
            if intervals >= 1.0 {
                let whole =
                    Self::divided((index + intervals) * interval, intervals * interval, 1.0);
                return Self { intervals, ..whole };
            }
            if free >= 1.0 {
                let parts = parts(interval / requested);
                return Self::divided((index + 1.0) * interval, interval, parts);
            }
            return Self::divided(limit, limit - time, parts((limit - time) / requested));
        }
        let next = ((time / interval).floor() + 1.0) * interval;
        let end = if next < limit + SLACK * interval {
            next
        } else {
            limit
        };
        Self::divided(end, end - time, parts((end - time) / requested))
    }

    /// A length in so many parts.
    fn divided(end: f64, length: f64, parts: f64) -> Self {
        Self {
            end,
            left: parts,
            size: length / parts,
            length,
            parts,
            intervals: 0.0,
        }
    }

    /// The rest in steps no longer than a requested size: the whole length in a round multiple of the fewest equal parts
    /// between two of which the latest step ended.
    pub fn adapted(self, requested: f64) -> Self {
        let common = common_divisor(self.parts, self.left);
        let fewest = self.parts / common;
        let multiple = parts(self.length / (fewest * requested));
        let anew = Self::divided(self.end, self.length, fewest * multiple);
        if self.size <= requested * (1.0 + SLACK) && anew.size < self.size {
            return self;
        }
        Self {
            left: self.left / common * multiple,
            ..anew
        }
    }
}

/// The greatest common divisor of whole numbers; any number of what is not finite.
fn common_divisor(one: f64, other: f64) -> f64 {
    if other > 0.0 {
        common_divisor(other, one % other)
    } else {
        one
    }
}

/// The smallest round number of parts of a length that are at most one long each.
fn parts(length: f64) -> f64 {
    round_above(length * (1.0 - SLACK))
}

/// The largest of 1, 2, 3, 4, 6, 8, 12, … that is not above a number; zero below one.
fn round_below(number: f64) -> f64 {
    if number < 1.0 {
        return 0.0;
    }
    let power = 2.0_f64.powi(number.log2().floor() as i32);
    if power >= 2.0 && 1.5 * power <= number {
        1.5 * power
    } else {
        power
    }
}

/// The smallest of 1, 2, 3, 4, 6, 8, 12, … that is not below a number.
fn round_above(number: f64) -> f64 {
    if number <= 1.0 {
        return 1.0;
    }
    let power = 2.0_f64.powi(number.log2().ceil() as i32);
    if power >= 4.0 && number <= 0.75 * power {
        0.75 * power
    } else {
        power
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From a thousandth of an interval on in steps that may grow eightfold: each as long as the way behind it.
    #[test]
    fn steps_on_the_way_to_a_sample_grow_with_the_way_behind_them() {
        let (mut requested, mut time, mut steps) = (1e-3, 0.0, 0);
        let mut span = Span::new(time, requested, 1.0, f64::INFINITY);
        while span.left > 0.0 {
            assert!(span.size <= requested * (1.0 + SLACK));
            (time, steps) = (time + span.size, steps + 1);
            (span.left, requested) = (span.left - 1.0, 8.0 * span.size);
            if span.left > 0.0 {
                span = span.adapted(requested);
            }
        }
        assert!((time - 1.0).abs() < 1e-12 && steps <= 11, "{time}, {steps}");
    }

    /// However requested sizes change, an interval ends where it should, no step is longer than requested, and the sizes
    /// that occur are few.
    #[test]
    fn sizes_on_the_way_to_samples_are_few() {
        let (mut sizes, mut number) = (Vec::new(), 0_u32);
        for sample in 0..2000 {
            let mut time = f64::from(sample);
            let mut request = || {
                number += 1;
                (0.45 + 0.4 * (0.7 * f64::from(number)).sin()) * f64::from(1 + number % 3)
            };
            let mut span = Span::new(time, request().min(0.99), 1.0, f64::INFINITY);
            while span.left > 0.0 {
                time += span.size;
                if !sizes.contains(&span.size) {
                    sizes.push(span.size);
                }
                span.left -= 1.0;
                let requested = request();
                if span.left > 0.0 {
                    span = span.adapted(requested);
                    assert!(span.size <= requested * (1.0 + SLACK));
                }
            }
            assert!((time - f64::from(sample + 1)).abs() < 1e-9, "{time}");
        }
        assert!(sizes.len() < 12, "{sizes:?}");
    }

    /// A requested size of next to nothing ends in a size of next to nothing, which the stepper refuses.
    #[test]
    fn a_vanishing_size_is_no_endless_search() {
        let span = Span::new(0.0, 0.5, 1.0, f64::INFINITY);
        for requested in [1e-300, f64::MIN_POSITIVE] {
            let tiny = span.adapted(requested);
            assert!(tiny.size <= 1e-300 && tiny.adapted(requested).size <= 1e-300);
        }
        // where the number of parts is not finite
        let none = span.adapted(0.0);
        assert_eq!(none.size, 0.0);
        assert_ne!(none.adapted(0.0).left, 0.0);
    }
}
