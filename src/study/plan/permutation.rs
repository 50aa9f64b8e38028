//! A random order of n things in which the place of each is worked out by itself.

use crate::rotor::load::SplitMix64;

/// Rounds of the network: the least that leave no visible pattern of Luby and Rackoff's four, and two more.
const ROUNDS: u64 = 6;

/// A permutation of 0 … n − 1 that a key decides.
///
/// A Feistel network permutes the next power of four; what falls outside n is sent through again.
///
/// Source: J. Black & P. Rogaway, *Ciphers with arbitrary finite domains*, CT-RSA 2002, cycle walking.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Permutation {
    length: u64,
    random: SplitMix64,
    /// Bits of one half of a number.
    half: u32,
}

impl Permutation {
    /// A permutation of `length` numbers; at most 2⁶² of them.
    pub fn new(length: u64, key: u64) -> Self {
        let bits = u64::BITS - length.saturating_sub(1).leading_zeros();
        Self {
            length,
            random: SplitMix64::new(key),
            half: bits.div_ceil(2).max(1),
        }
    }

    /// The place of a number below `length`.
    pub fn of(&self, number: u64) -> u64 {
        let mut place = self.network(number);
        while place >= self.length {
            place = self.network(place);
        }
        place
    }

    fn network(&self, number: u64) -> u64 {
        let mask = (1_u64 << self.half) - 1;
        let (mut left, mut right) = (number >> self.half, number & mask);
        for round in 0..ROUNDS {
            let mixed = left ^ (self.random.stream(round).bits(right) & mask);
            (left, right) = (right, mixed);
        }
        left << self.half | right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_is_taken_once() {
        let order = Permutation::new(5, 7);
        let mut places: Vec<u64> = (0..5).map(|i| order.of(i)).collect();
        places.sort();
        assert_eq!(places, [0, 1, 2, 3, 4]);
    }
}
