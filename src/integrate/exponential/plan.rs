//! Where steps end: steps longer than the interval of the samples last a round number of intervals,
//! shorter ones a round part of one, so that few sizes occur and every sample is a step's end or lies
//! whole intervals after its start.

/// Least part of an interval that counts as one, and nearness to a grid time that counts as there.
const SLACK: f64 = 1e-6;

/// Times that a step might be longer than the rest of a leg allows it to be from which on that rest is divided anew.
const MUCH: f64 = 4.0;

/// The way to the next time at which a step ends anyhow: a grid time or a break.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Leg {
    /// Its end, s.
    pub end: f64,
    /// Equal steps that are left on it, and their size, s.
    pub left: f64,
    pub size: f64,
    /// Intervals of samples that its only step lasts; zero where it lasts no whole number.
    pub intervals: f64,
}

impl Leg {
    /// A leg from a time on in steps no longer than a requested size, on a grid of samples, up to a limit.
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

    fn divided(end: f64, length: f64, requested: f64) -> Self {
        let whole = Self {
            end,
            left: 1.0,
            size: length,
            intervals: 0.0,
        };
        whole.halved(requested)
    }

    /// The same in equal parts no longer than a requested size.
    fn halved(mut self, requested: f64) -> Self {
        while self.size > requested * (1.0 + SLACK) {
            self.left *= 2.0;
            self.size *= 0.5;
        }
        self
    }

    /// The rest of the leg in steps no longer than a requested size.
    pub fn adapted(self, requested: f64) -> Self {
        let mut leg = self.halved(requested);
        leg.intervals = 0.0;
        while leg.left % 2.0 == 0.0 && 2.0 * leg.size <= requested * (1.0 + SLACK) {
            leg.left *= 0.5;
            leg.size *= 2.0;
        }
        if MUCH * leg.size <= requested {
            // steps grow faster than halves of the whole leg allow
            leg = Self::divided(self.end, self.left * self.size, requested);
        }
        leg
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

#[cfg(test)]
mod tests {
    use super::*;

    /// From a thousandth of an interval on in steps that may grow eightfold: as many of them as that takes.
    #[test]
    fn steps_on_the_way_to_a_sample_grow_as_fast_as_they_may() {
        let (mut requested, mut time, mut steps) = (1e-3, 0.0, 0);
        let mut leg = Leg::new(time, requested, 1.0, f64::INFINITY);
        while leg.left > 0.0 {
            assert!(leg.size <= requested * (1.0 + SLACK));
            (time, steps) = (time + leg.size, steps + 1);
            (leg.left, requested) = (leg.left - 1.0, 8.0 * leg.size);
            if leg.left > 0.0 {
                leg = leg.adapted(requested);
            }
        }
        assert!((time - 1.0).abs() < 1e-12 && steps <= 6, "{time}, {steps}");
    }
}
