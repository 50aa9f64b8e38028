//! The envelope of a curve, in memory that does not grow with it.

/// Buckets of a curve: more cannot be seen on the width of a figure.
pub(super) const BUCKETS: usize = 2048;
/// Buckets of a curve on a wide screen.
pub(super) const SCREEN_BUCKETS: usize = 3072;

/// Smallest and largest value of a segment of a curve, in the order in which they came.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bucket {
    /// The extreme that came first: abscissa and value.
    pub first: (f64, f64),
    /// The extreme that came last: abscissa and value.
    pub last: (f64, f64),
}

impl Bucket {
    /// Smallest value.
    pub fn low(&self) -> f64 {
        self.first.1.min(self.last.1)
    }

    /// Largest value.
    pub fn high(&self) -> f64 {
        self.first.1.max(self.last.1)
    }

    /// This and the following segment as one.
    fn join(self, next: Self) -> Self {
        let [mut low, mut high] = [self.first; 2];
        for point in [self.last, next.first, next.last] {
            if point.1 < low.1 {
                low = point;
            }
            if point.1 > high.1 {
                high = point;
            }
        }
        let (first, last) = if low.0 <= high.0 {
            (low, high)
        } else {
            (high, low)
        };
        Self { first, last }
    }
}

/// Keeps the envelope of a curve in at most `capacity` buckets, however long the curve becomes.
///
/// Every bucket holds the extremes of the same number of values; when all are full, neighbours are joined and
/// each then holds those of twice as many.
#[derive(Debug, Clone, PartialEq)]
pub struct Decimator {
    capacity: usize,
    full: Vec<Bucket>,
    /// Number of values that a full bucket covers.
    stride: u64,
    open: Option<Bucket>,
    /// Values in the open bucket.
    filled: u64,
}

impl Decimator {
    /// An empty envelope of at most `capacity` buckets, at least two.
    pub fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2);
        Self {
            capacity,
            full: Vec::with_capacity(capacity),
            stride: 1,
            open: None,
            filled: 0,
        }
    }

    /// Takes the next value; the abscissa must not decrease. A value that is not finite is a gap.
    pub fn push(&mut self, abscissa: f64, value: f64) {
        if !value.is_finite() {
            return;
        }
        let (first, last) = ((abscissa, value), (abscissa, value));
        let point = Bucket { first, last };
        match &mut self.open {
            // between the extremes it changes nothing
            Some(bucket) if bucket.low() <= value && value <= bucket.high() => {}
            Some(bucket) => *bucket = bucket.join(point),
            None => self.open = Some(point),
        }
        self.filled += 1;
        if self.filled == self.stride {
            self.full.extend(self.open.take());
            self.filled = 0;
            if self.full.len() == self.capacity - 1 {
                self.halve();
            }
        }
    }

    /// Whether the points are all values that were taken: a bucket of two has both.
    pub fn is_whole(&self) -> bool {
        self.stride <= 2
    }

    /// The envelope so far, in order.
    pub fn buckets(&self) -> impl Iterator<Item = Bucket> + '_ {
        self.full.iter().copied().chain(self.open)
    }

    /// The points of the envelope, in order.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let buckets = self.buckets();
        buckets.flat_map(|Bucket { first, last }| [first, last])
    }

    /// Lowest and highest value.
    pub fn range(&self) -> Option<[f64; 2]> {
        let values = self.buckets().map(|bucket| [bucket.low(), bucket.high()]);
        values.reduce(|[low, high], next| [low.min(next[0]), high.max(next[1])])
    }

    /// Largest magnitude.
    pub fn magnitude(&self) -> f64 {
        self.range().map_or(0.0, |[low, high]| high.max(-low))
    }

    fn halve(&mut self) {
        let pairs = self.full.len() / 2;
        // With an odd number the last bucket is half full again.
        if self.full.len() % 2 == 1 {
            self.open = self.full.pop();
            self.filled = self.stride;
        }
        for pair in 0..pairs {
            self.full[pair] = self.full[2 * pair].join(self.full[2 * pair + 1]);
        }
        self.full.truncate(pairs);
        self.stride *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_buckets_keep_the_extremes() {
        let mut envelope = Decimator::new(4);
        for n in 0..1000 {
            envelope.push(f64::from(n), f64::from(n % 7));
        }
        assert!(envelope.buckets().count() <= 4);
        assert!(
            envelope
                .buckets()
                .all(|bucket| bucket.low() == 0.0 && bucket.high() == 6.0)
        );
    }
}
