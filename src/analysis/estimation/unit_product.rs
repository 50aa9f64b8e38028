//! Units of products: `m/s^2` by `m` is `m^2/s^2`.

/// Factors of a unit such as `m/s^2` or `N m`, with their powers.
struct Factors(Vec<(String, i32)>);

impl Factors {
    /// `m/s^2` is m¹ s⁻²: the divisors come after the slash.
    fn read(unit: &str) -> Self {
        let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
        let mut factors = Self(Vec::new());
        for (text, sign) in [(above, 1), (below, -1)] {
            for word in text.split_whitespace() {
                let (symbol, power) = word.split_once('^').unwrap_or((word, "1"));
                factors.multiply(symbol, sign * power.parse::<i32>().unwrap_or(1));
            }
        }
        factors
    }

    fn multiply(&mut self, symbol: &str, power: i32) {
        match self.0.iter_mut().find(|(known, _)| known == symbol) {
            Some((_, known)) => *known += power,
            None => self.0.push((symbol.to_owned(), power)),
        }
    }

    fn written(&self) -> String {
        let side = |sign: i32| {
            let factors = self.0.iter().filter(|(_, power)| power * sign > 0);
            let words = factors.map(|(symbol, power)| match power.abs() {
                1 => symbol.clone(),
                power => format!("{symbol}^{power}"),
            });
            words.collect::<Vec<_>>().join(" ")
        };
        let (above, below) = (side(1), side(-1));
        match (above.is_empty(), below.is_empty()) {
            (_, true) => above,
            (true, false) => format!("1/{below}"),
            (false, false) => format!("{above}/{below}"),
        }
    }
}

/// Unit of the product of two quantities.
pub(super) fn product(first: &str, second: &str) -> String {
    let mut factors = Factors::read(first);
    for (symbol, power) in Factors::read(second).0 {
        factors.multiply(&symbol, power);
    }
    factors.written()
}

#[cfg(test)]
mod tests {
    use super::product;

    #[test]
    fn units_multiply() {
        assert_eq!(product("m", "m"), "m^2");
        assert_eq!(product("m/s^2", "m/s^2"), "m^2/s^4");
        assert_eq!(product("N m", "rad/s"), "N m rad/s");
        assert_eq!(product("N m", "m"), "N m^2");
    }
}
