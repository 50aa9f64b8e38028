//! Where steps end: steps longer than the interval of the samples last a round number of intervals,
//! shorter ones a round part of one, so that few sizes occur and every sample is a step's end or lies
//! whole intervals after its start.

use crate::integrate::problem::SLACK;

/// The equal steps to the next time at which a step ends anyhow: a grid time or a break.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Span {
    /// Its end, s.
    pub end: f64,
    /// Steps that are left to it, and their size, s.
    pub left: f64,
    pub size: f64,
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
                return Self {
                    end: (index + intervals) * interval,
                    left: 1.0,
                    size: intervals * interval,
                    intervals,
                };
            }
            if free >= 1.0 {
                return Self::divided((index + 1.0) * interval, interval, requested);
            }
            return Self::divided(limit, limit - time, requested);
        }
        let next = ((time / interval).floor() + 1.0) * interval;
        let end = if next < limit + SLACK * interval {
            next
        } else {
            limit
        };
        Self::divided(end, end - time, requested)
    }

    /// A length in as few parts as a requested size allows, of the numbers 1, 2, 3, 4, 6, 8, 12, ….
    fn divided(end: f64, length: f64, requested: f64) -> Self {
        let left = round_above(length / requested * (1.0 - SLACK));
        Self {
            end,
            left,
            size: length / left,
            intervals: 0.0,
        }
    }

    /// The rest in steps no longer than a requested size: as before, or in fewer.
    pub fn adapted(self, requested: f64) -> Self {
        let anew = Self::divided(self.end, self.left * self.size, requested);
        if self.size > requested * (1.0 + SLACK) || anew.left < self.left {
            return anew;
        }
        Self {
            intervals: 0.0,
            ..self
        }
    }
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

    /// From a thousandth of an interval on in steps that may grow eightfold: as many of them as that takes.
    #[test]
    fn steps_on_the_way_to_a_sample_grow_as_fast_as_they_may() {
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
        assert!((time - 1.0).abs() < 1e-12 && steps <= 6, "{time}, {steps}");
    }
}
