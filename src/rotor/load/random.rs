//! Random numbers that depend on a seed and a counter alone.

/// The generator SplitMix64: number n is a mix of `seed + (n + 1)·0x9e3779b97f4a7c15`.
///
/// Every number can be had by itself, on every machine the same. Its period is 2⁶⁴.
///
/// Source: Steele, Lea & Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014,
/// with the constants of Vigna's `splitmix64.c`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SplitMix64 {
    seed: u64,
}

impl SplitMix64 {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self { seed }
    }

    /// A sequence of its own for each stream of one seed.
    pub fn stream(self, number: u64) -> Self {
        Self::new(self.bits(number))
    }

    /// 64 random bits.
    pub fn bits(self, counter: u64) -> u64 {
        let step = counter.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.seed.wrapping_add(step);
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number uniform between 0 and 1, both left out.
    pub fn uniform(self, counter: u64) -> f64 {
        // the middle of one of 2⁵² equal parts
        ((self.bits(counter) >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_splitmix64_c() {
        // the first number that splitmix64.c gives for the seed 1234567
        assert_eq!(
            SplitMix64::new(1_234_567).bits(0),
            6_457_827_717_110_365_317
        );
    }
}
