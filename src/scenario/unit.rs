//! Units as people write them: products and powers of known ones with SI prefixes, each reduced to its size and dimension.

use super::unit_words::{Size, WORDS};
use crate::numerics::digits::to_digits;

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
        to_digits(si / self.factor * self.divisor + self.zero, 10)
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
