//! The words that name a unit, each with its size.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// The prefixes that are read, with what they multiply by and divide by.
pub(super) const PREFIXES: [(char, f64, f64); 9] = [
    ('p', 1.0, 1e12),
    ('n', 1.0, 1e9),
    ('u', 1.0, 1e6),
    ('m', 1.0, 1e3),
    ('c', 1.0, 1e2),
    ('h', 1e2, 1.0),
    ('k', 1e3, 1.0),
    ('M', 1e6, 1.0),
    ('G', 1e9, 1.0),
];

/// Names of a unit, the quotient that is its size in SI units, its powers of kg, m, s, K and rad, and its prefixes. Only
/// those that are in use: of `Mm` and `mm` one would be a slip of the shift key.
#[rustfmt::skip]
pub(super) const UNITS: [(&str, f64, f64, [i32; 5], &str); 39] = [
    ("kg", 1.0, 1.0, [1, 0, 0, 0, 0], ""),
    ("g", 1.0, 1e3, [1, 0, 0, 0, 0], "um"),
    ("t", 1e3, 1.0, [1, 0, 0, 0, 0], ""),
    ("lb lbs lbm", 0.453_592_37, 1.0, [1, 0, 0, 0, 0], ""),
    ("oz", 0.028_349_523_125, 1.0, [1, 0, 0, 0, 0], ""),
    ("m", 1.0, 1.0, [0, 1, 0, 0, 0], "pnumck"),
    ("micron microns", 1.0, 1e6, [0, 1, 0, 0, 0], ""),
    ("in inch", 0.0254, 1.0, [0, 1, 0, 0, 0], ""),
    ("mil mils thou", 1.0, 1e3 / 0.0254, [0, 1, 0, 0, 0], ""),
    ("ft", 0.3048, 1.0, [0, 1, 0, 0, 0], ""),
    ("s sec", 1.0, 1.0, [0, 0, 1, 0, 0], "num"),
    ("min", 60.0, 1.0, [0, 0, 1, 0, 0], ""),
    ("h hr", 3_600.0, 1.0, [0, 0, 1, 0, 0], ""),
    ("d day days", 86_400.0, 1.0, [0, 0, 1, 0, 0], ""),
    ("K", 1.0, 1.0, [0, 0, 0, 1, 0], ""),
    ("degC", 1.0, 1.0, [0, 0, 0, 1, 0], ""),
    ("degF", 5.0, 9.0, [0, 0, 0, 1, 0], ""),
    ("rad", 1.0, 1.0, [0, 0, 0, 0, 1], "um"),
    ("deg", PI / 180.0, 1.0, [0, 0, 0, 0, 1], ""),
    ("arcmin", PI / 10_800.0, 1.0, [0, 0, 0, 0, 1], ""),
    // also in German and in French
    ("rev r U tr", 2.0 * PI, 1.0, [0, 0, 0, 0, 1], ""),
    ("rpm RPM Rpm", PI / 30.0, 1.0, [0, 0, -1, 0, 1], "k"),
    ("rps", 2.0 * PI, 1.0, [0, 0, -1, 0, 1], ""),
    ("Hz", 1.0, 1.0, [0, 0, -1, 0, 0], "mkMG"),
    ("cpm CPM", 1.0, 60.0, [0, 0, -1, 0, 0], ""),
    ("N", 1.0, 1.0, [1, 1, -2, 0, 0], "umkMG"),
    ("lbf", 4.448_221_615_260_5, 1.0, [1, 1, -2, 0, 0], "k"),
    ("kip", 4_448.221_615_260_5, 1.0, [1, 1, -2, 0, 0], ""),
    ("ozf", 4.448_221_615_260_5 / 16.0, 1.0, [1, 1, -2, 0, 0], ""),
    ("kgf kp", 9.806_65, 1.0, [1, 1, -2, 0, 0], ""),
    ("dyn", 1.0, 1e5, [1, 1, -2, 0, 0], ""),
    ("gn", 9.806_65, 1.0, [0, 1, -2, 0, 0], "m"),
    ("Pa", 1.0, 1.0, [1, -1, -2, 0, 0], "mhkMG"),
    ("bar", 1e5, 1.0, [1, -1, -2, 0, 0], "mk"),
    ("psi", 6_894.757_293_168_361, 1.0, [1, -1, -2, 0, 0], "kM"),
    ("ksi", 6_894_757.293_168_361, 1.0, [1, -1, -2, 0, 0], ""),
    ("P", 1.0, 10.0, [1, -1, -1, 0, 0], "c"),
    ("St", 1.0, 1e4, [0, 2, -1, 0, 0], "c"),
    ("ppm", 1.0, 1e6, [0; 5], ""),
];

/// Products that are written as one word, too: first factors and what may follow them.
pub(super) const RUN_TOGETHER: [(&str, &str); 3] = [
    ("uN mN N kN MN", "um mm cm m s"),
    ("mPa Pa", "s"),
    ("g kg", "mm cm m"),
];

/// Every known word: a first factor, 1 for most, and the last one, which has the power.
pub(super) static WORDS: LazyLock<BTreeMap<String, [Size; 2]>> =
    LazyLock::new(|| words().into_iter().collect());

pub(super) fn words() -> Vec<(String, [Size; 2])> {
    let mut words = Vec::new();
    for (names, over, under, powers, prefixes) in UNITS {
        let exponents = powers.map(|power| 2 * power);
        let prefixed = PREFIXES.iter().filter(|it| prefixes.contains(it.0));
        let prefixed =
            prefixed.map(|(prefix, up, down)| (prefix.to_string(), up * over, down * under));
        for (prefix, over, under) in prefixed.chain([(String::new(), over, under)]) {
            let size = Size {
                over,
                under,
                exponents,
            };
            words.extend(
                names
                    .split(' ')
                    .map(|name| (format!("{prefix}{name}"), [Size::ONE, size])),
            );
        }
    }
    let single: BTreeMap<_, _> = words.iter().cloned().collect();
    for (firsts, seconds) in RUN_TOGETHER {
        for first in firsts.split(' ') {
            let pair = |second| {
                let pair = [first, second].map(|word| single[word][1]);
                (format!("{first}{second}"), pair)
            };
            words.extend(seconds.split(' ').map(pair));
        }
    }
    words
}

/// Size in SI units, a quotient whose sides are exact where they are powers of ten, and the powers of kg, m, s, K and
/// rad, each times two: a contact stiffness is in N/m^1.5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Size {
    pub over: f64,
    pub under: f64,
    pub exponents: [i32; 5],
}

impl Size {
    pub const ONE: Self = Self {
        over: 1.0,
        under: 1.0,
        exponents: [0; 5],
    };

    pub fn times(self, other: Self) -> Self {
        Self {
            over: self.over * other.over,
            under: self.under * other.under,
            exponents: std::array::from_fn(|base| self.exponents[base] + other.exponents[base]),
        }
    }

    pub fn inverse(self) -> Self {
        Self {
            over: self.under,
            under: self.over,
            exponents: self.exponents.map(|power| -power),
        }
    }

    /// A power, given times two; none where quarters come out, and none of a power of great ones.
    pub fn to_half(self, halves: i32) -> Option<Self> {
        if self.exponents.iter().any(|power| power.abs() > 24) {
            return None;
        }
        let base = if halves < 0 { self.inverse() } else { self };
        let power = |count| (0..count).fold(Self::ONE, |power, _| power.times(base));
        if halves % 2 == 0 {
            return Some(power(halves.abs() / 2));
        }
        let square = power(halves.abs());
        let has_root = square.exponents.iter().all(|power| power % 2 == 0);
        has_root.then(|| Self {
            over: square.over.sqrt(),
            under: square.under.sqrt(),
            exponents: square.exponents.map(|power| power / 2),
        })
    }

    /// Factor and divisor, one of them 1: dividing by a power of ten is exact where multiplying by its inverse is not,
    /// 5 mm is 5/1e3.
    pub fn reduced(self) -> [f64; 2] {
        match (self.over, self.under) {
            (over, 1.0) => [over, 1.0],
            (over, under) if under % over == 0.0 => [1.0, under / over],
            (1.0, under) => [1.0, under],
            (over, under) => [over / under, 1.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::unit::Unit;

    #[test]
    fn every_word_has_one_meaning() {
        let words = words();
        assert_eq!(WORDS.len(), words.len());
    }

    #[test]
    fn mega_and_milli_are_never_taken_for_each_other() {
        for (name, _, _, _, prefixes) in UNITS {
            let both = prefixes.contains('M') && prefixes.contains('m');
            assert!(!both || ["N", "Hz", "Pa"].contains(&name), "{name}");
        }
        assert_eq!(Unit::alike("mpa").len(), 2);
    }
}
