//! Where draws lie: permutations that a key decides, and Sobol's sequence.

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

    /// Position of a number below `length`.
    pub fn position(&self, number: u64) -> u64 {
        let mut position = self.network(number);
        while position >= self.length {
            position = self.network(position);
        }
        position
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

/// Most axes of Sobol's sequence.
pub const MOST_SOBOL_AXES: usize = 16;

/// Bits of a coordinate.
const BITS: usize = 32;

/// Degree and coefficients of a primitive polynomial, and the first direction numbers.
struct Direction(usize, u32, &'static [u32]);

/// Axes from the second on.
const DIRECTIONS: [Direction; MOST_SOBOL_AXES - 1] = [
    Direction(1, 0, &[1]),
    Direction(2, 1, &[1, 3]),
    Direction(3, 1, &[1, 3, 1]),
    Direction(3, 2, &[1, 1, 1]),
    Direction(4, 1, &[1, 1, 3, 3]),
    Direction(4, 4, &[1, 3, 5, 13]),
    Direction(5, 2, &[1, 1, 5, 5, 17]),
    Direction(5, 4, &[1, 1, 5, 5, 5]),
    Direction(5, 7, &[1, 1, 7, 11, 19]),
    Direction(5, 11, &[1, 1, 5, 1, 1]),
    Direction(5, 13, &[1, 1, 1, 3, 11]),
    Direction(5, 14, &[1, 3, 5, 5, 31]),
    Direction(6, 1, &[1, 3, 3, 9, 7, 49]),
    Direction(6, 13, &[1, 1, 1, 15, 21, 21]),
    Direction(6, 16, &[1, 3, 1, 13, 27, 49]),
];

/// Coordinate, from 0 on and below 1, of point `index` along `axis`; the first 2³² points, and the first
/// [`MOST_SOBOL_AXES`] axes, differ.
///
/// ```text
/// x = ⊕ over the set bits k of the Gray code of index of v_k,
/// v_k = a_1 v_(k−1) ⊕ … ⊕ a_(s−1) v_(k−s+1) ⊕ v_(k−s) ⊕ (v_(k−s) >> s)
/// ```
///
/// Source: S. Joe & F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635–2654, the table new-joe-kuo-6.
pub fn sobol(index: u64, axis: usize) -> f64 {
    let numbers = direction_numbers(axis % MOST_SOBOL_AXES);
    let gray = index ^ (index >> 1);
    let bits = numbers.iter().enumerate();
    let set = bits.filter(|(bit, _)| gray >> bit & 1 == 1);
    let coordinate = set.fold(0, |sum: u32, (_, number)| sum ^ number);
    f64::from(coordinate) / 2f64.powi(BITS as i32)
}

fn direction_numbers(axis: usize) -> [u32; BITS] {
    let mut numbers: [u32; BITS] = std::array::from_fn(|bit| 1 << (BITS - 1 - bit));
    let Some(Direction(degree, polynomial, first)) = axis.checked_sub(1).map(|k| &DIRECTIONS[k])
    else {
        return numbers;
    };
    for bit in 0..BITS {
        numbers[bit] = match first.get(bit) {
            Some(start) => start << (BITS - 1 - bit),
            None => {
                let last = numbers[bit - degree];
                let terms = 1..*degree;
                let chosen = terms.filter(|term| polynomial >> (degree - 1 - term) & 1 == 1);
                let sum = chosen.fold(0, |sum, term| sum ^ numbers[bit - term]);
                sum ^ last ^ (last >> degree)
            }
        };
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_position_is_taken_once() {
        let order = Permutation::new(5, 7);
        let mut positions: Vec<u64> = (0..5).map(|i| order.position(i)).collect();
        positions.sort();
        assert_eq!(positions, [0, 1, 2, 3, 4]);
    }
}
