//! Units as people write them: products and powers of known ones with SI prefixes, each reduced to its size and dimension.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// The prefixes that are read, with what they multiply by and divide by.
const PREFIXES: [(char, f64, f64); 8] = [
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
const UNITS: [(&str, f64, f64, [i32; 5], &str); 39] = [
    ("kg", 1.0, 1.0, [1, 0, 0, 0, 0], ""),
    ("g", 1.0, 1e3, [1, 0, 0, 0, 0], "um"),
    ("t", 1e3, 1.0, [1, 0, 0, 0, 0], ""),
    ("lb lbs lbm", 0.453_592_37, 1.0, [1, 0, 0, 0, 0], ""),
    ("oz", 0.028_349_523_125, 1.0, [1, 0, 0, 0, 0], ""),
    ("m", 1.0, 1.0, [0, 1, 0, 0, 0], "numck"),
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
const RUN_TOGETHER: [(&str, &str); 3] = [
    ("uN mN N kN MN", "um mm cm m s"),
    ("mPa Pa", "s"),
    ("g kg", "mm cm m"),
];

/// Every known word: a first factor, 1 for most, and the last one, which has the power.
static WORDS: LazyLock<BTreeMap<String, [Size; 2]>> =
    LazyLock::new(|| words().into_iter().collect());

fn words() -> Vec<(String, [Size; 2])> {
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
struct Size {
    over: f64,
    under: f64,
    exponents: [i32; 5],
}

impl Size {
    const ONE: Self = Self {
        over: 1.0,
        under: 1.0,
        exponents: [0; 5],
    };

    fn times(self, other: Self) -> Self {
        Self {
            over: self.over * other.over,
            under: self.under * other.under,
            exponents: std::array::from_fn(|base| self.exponents[base] + other.exponents[base]),
        }
    }

    fn inverse(self) -> Self {
        Self {
            over: self.under,
            under: self.over,
            exponents: self.exponents.map(|power| -power),
        }
    }

    /// A power, given times two; none where quarters come out, and none of a power of great ones.
    fn to_half(self, halves: i32) -> Option<Self> {
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
    fn reduced(self) -> [f64; 2] {
        match (self.over, self.under) {
            (over, 1.0) => [over, 1.0],
            (over, under) if under % over == 0.0 => [1.0, under / over],
            (1.0, under) => [1.0, under],
            (over, under) => [over / under, 1.0],
        }
    }
}

/// A unit as somebody wrote it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unit {
    /// Its spelling, products with one blank, powers with `^`.
    pub symbol: String,
    factor: f64,
    divisor: f64,
    /// How far its zero is above that of the base unit, in this unit.
    zero: f64,
    exponents: [i32; 5],
}

/// Why a text is no unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitError {
    Unknown,
    /// Something follows a divisor.
    Ambiguous,
}

impl Unit {
    /// Longest text that is read.
    const LONGEST: usize = 64;

    /// The unit of a text: `N·s/m`, `kN s m^-1`, `kNs/m`.
    pub fn read(text: &str) -> Result<Self, UnitError> {
        let symbol = normalise(text);
        if symbol.len() > Self::LONGEST {
            return Err(UnitError::Unknown);
        }
        let mut reader = Reader(&symbol);
        let size = reader.product()?;
        if !reader.0.is_empty() {
            return Err(UnitError::Unknown);
        }
        let [factor, divisor] = size.reduced();
        let zero = match symbol.as_str() {
            "K" => 273.15,
            "degF" => 32.0,
            _ => 0.0,
        };
        let exponents = size.exponents;
        Ok(Self {
            symbol,
            factor,
            divisor,
            zero,
            exponents,
        })
    }

    /// The units whose spelling differs by capital letters alone.
    pub fn alike(text: &str) -> Vec<Self> {
        let text = normalise(text);
        if text.len() > Self::LONGEST {
            return Vec::new();
        }
        let mut spellings = vec![String::new()];
        for piece in text.split_inclusive(|c: char| !c.is_alphabetic()) {
            let (word, sign) = piece.split_at(
                piece
                    .find(|c: char| !c.is_alphabetic())
                    .unwrap_or(piece.len()),
            );
            let is_alike = |known: &&String| known.to_lowercase() == word.to_lowercase();
            let mut words: Vec<_> = WORDS.keys().filter(is_alike).map(String::as_str).collect();
            if words.is_empty() {
                words.push(word);
            }
            let longer =
                |start: String| words.iter().map(move |word| format!("{start}{word}{sign}"));
            spellings = spellings.into_iter().flat_map(longer).take(100).collect();
        }
        let read = spellings
            .iter()
            .filter_map(|spelling| Self::read(spelling).ok());
        read.collect()
    }

    /// Whether both measure the same.
    pub fn measures_as(&self, other: &Self) -> bool {
        self.exponents == other.exponents
    }

    /// A unit that is so many times as large.
    pub fn times(self, number: f64) -> Self {
        let [factor, divisor] = Size {
            over: number * self.factor,
            under: self.divisor,
            exponents: self.exponents,
        }
        .reduced();
        Self {
            factor,
            divisor,
            ..self
        }
    }

    /// SI value of one of it; a scale with a zero of its own has no size.
    pub fn size(&self) -> Option<f64> {
        (self.zero == 0.0).then(|| self.si(1.0))
    }

    /// SI value of a number in this unit.
    pub fn si(&self, number: f64) -> f64 {
        (number - self.zero) * self.factor / self.divisor
    }

    /// Number in this unit of an SI value, rounded to the digits that people read.
    pub fn readable(&self, si: f64) -> f64 {
        let exact = si / self.factor * self.divisor + self.zero;
        format!("{exact:.9e}").parse().unwrap_or(exact)
    }
}

/// One spelling for many: `N·m²`, `N*m**2`, `N.m^2`, `N-m2` and `N m^2` become the same.
fn normalise(unit: &str) -> String {
    // most are letters alone, and a study reads them again for every run
    let is_plain = |letter: u8| letter.is_ascii_alphabetic() || letter == b'/';
    if unit.bytes().all(is_plain) {
        return unit.to_owned();
    }
    let plain = unit
        .replace(['µ', 'μ'], "u")
        .replace('°', "deg")
        .replace("**", "^")
        .replace("^(3/2)", "^1.5");
    let mut product = String::with_capacity(plain.len());
    let mut previous = ' ';
    let mut rest = plain.chars().peekable();
    while let Some(written) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        let raised = "⁻⁰¹²³⁴".chars().position(|it| it == written);
        let sign = raised.map_or(written, |place| char::from(b"-01234"[place]));
        let is_power = sign == '-' || sign.is_ascii_digit();
        let separates = match sign {
            '*' | '·' | '⋅' | '×' => true,
            '.' => !(previous.is_ascii_digit() && next.is_ascii_digit()),
            '-' => previous.is_alphabetic() && next.is_alphabetic(),
            _ => sign.is_whitespace(),
        };
        let sign = if separates { ' ' } else { sign };
        if is_power && !separates && (previous.is_alphabetic() || previous == ')') {
            product.push('^');
        }
        product.push(sign);
        previous = sign;
    }
    let words: Vec<_> = product.split_whitespace().collect();
    let product = words.join(" ").replace(" /", "/").replace("/ ", "/");
    product.replace("( ", "(").replace(" )", ")")
}

/// What is left to read of a unit.
struct Reader<'a>(&'a str);

impl<'a> Reader<'a> {
    /// Factors up to the end or a closing bracket.
    fn product(&mut self) -> Result<Size, UnitError> {
        if self.0.starts_with("1/") {
            self.take('1');
        }
        let mut product = Size::ONE;
        let mut divided = false;
        loop {
            let divides = self.take('/');
            if self.take(' ') && divided {
                return Err(UnitError::Ambiguous);
            }
            let factor = self.factor()?;
            product = product.times(if divides { factor.inverse() } else { factor });
            divided |= divides;
            if self.0.is_empty() || self.0.starts_with(')') {
                return Ok(product);
            }
        }
    }

    /// A word or a product in brackets, and its power.
    fn factor(&mut self) -> Result<Size, UnitError> {
        let base = match self.take('(') {
            true => Some([Size::ONE, self.product()?]).filter(|_| self.take(')')),
            false => WORDS.get(self.take_while(char::is_alphabetic)).copied(),
        };
        let [first, last] = base.ok_or(UnitError::Unknown)?;
        if !self.take('^') {
            return Ok(first.times(last));
        }
        let power = self.halves().and_then(|halves| last.to_half(halves));
        power
            .map(|power| first.times(power))
            .ok_or(UnitError::Unknown)
    }

    /// A power, times two.
    fn halves(&mut self) -> Option<i32> {
        let in_brackets = self.take('(');
        let power: f64 = self
            .take_while(|it| it.is_ascii_digit() || "+-.".contains(it))
            .parse()
            .ok()?;
        let halves = 2.0 * power;
        let is_read =
            halves.fract() == 0.0 && halves.abs() <= 24.0 && (!in_brackets || self.take(')'));
        is_read.then_some(halves as i32)
    }

    fn take_while(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let end = self.0.find(|it| !belongs(it)).unwrap_or(self.0.len());
        let (taken, rest) = self.0.split_at(end);
        self.0 = rest;
        taken
    }

    /// Takes a character where it comes next.
    fn take(&mut self, next: char) -> bool {
        let rest = self.0.strip_prefix(next);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
