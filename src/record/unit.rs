//! Names of columns with their units, as people write them: `acc [m/s²]`, `Time (ms)`, `x / µm`.

/// Units that are known in headers, those with prefixes first.
const UNITS: [(&str, &str); 2] = [
    (
        "s sec m g gn kg Hz N Nm Pa bar V A W J rad strain Ohm Ω",
        "nmuckM",
    ),
    (
        "min h hr rpm RPM rps cpm rev r in inch ft ips mil mils thou micron psi lbf K degC degF °C °F C deg ° % dB dBA pC G",
        "",
    ),
];

/// What is in brackets at the end of a name and may be meant as a unit: all in square ones, in round ones what begins with a unit
/// in letters of any case.
pub(crate) fn in_brackets(name: &str) -> Option<&str> {
    let within = |open, close| Some(name.trim().strip_suffix(close)?.rsplit_once(open)?.1);
    let begins_with_unit = |text: &&str| {
        let word = text.split([' ', '/', '*', '^']).next().unwrap_or_default();
        is_unit(word) || is_unit(&word.to_lowercase())
    };
    within('[', ']').or_else(|| within('(', ')').filter(begins_with_unit))
}

/// A header as name and unit; the whole of it is the name where no unit is recognised.
pub(super) fn split(header: &str) -> (&str, Option<&str>) {
    let header = header.trim();
    let brackets = [('[', ']'), ('(', ')')];
    let mut bracketed = brackets
        .iter()
        .filter_map(|(open, close)| header.strip_suffix(*close)?.rsplit_once(*open));
    // of `m/s` the name would be a unit
    let divided = || header.split_once('/').filter(|(name, _)| !is_unit(name));
    match bracketed.next().or_else(divided) {
        Some((name, unit)) if !name.trim().is_empty() && is_unit(unit) => {
            (name.trim_end_matches([' ', '/', ',']), Some(unit.trim()))
        }
        _ => (header, None),
    }
}

/// Whether a text is a unit: a product or quotient of units with powers.
pub(super) fn is_unit(text: &str) -> bool {
    // micro has two signs
    let text = text.replace(['µ', 'μ'], "u");
    let is_between = |sign: char| "/*·⋅.^-⁻¹²³ ()[]".contains(sign) || sign.is_ascii_digit();
    let mut words = text
        .split(is_between)
        .filter(|word| !word.is_empty())
        .peekable();
    words.peek().is_some() && words.all(is_word)
}

fn is_word(word: &str) -> bool {
    let mut known = UNITS
        .iter()
        .flat_map(|(names, prefixes)| names.split(' ').map(move |name| (name, prefixes)));
    known.any(|(name, prefixes)| match word.strip_suffix(name) {
        Some(prefix) => prefix.len() <= 1 && prefixes.contains(prefix),
        None => false,
    })
}

/// A time in this unit that is one second: 1000 ms.
pub(super) fn per_second(unit: &str) -> Option<f64> {
    Some(match unit.trim().replace(['µ', 'μ'], "u").as_str() {
        "s" | "sec" | "seconds" => 1.0,
        "ms" => 1e3,
        "us" => 1e6,
        "ns" => 1e9,
        "min" => 1.0 / 60.0,
        "h" | "hr" => 1.0 / 3600.0,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_may_be_meant_as_a_unit_is_told_from_other_words() {
        for (name, expected) in [
            ("d [um pk-pk]", Some("um pk-pk")),
            ("v (mm/s rms)", Some("mm/s rms")),
            ("a (MM/S^2)", Some("MM/S^2")),
            ("b [DE]", Some("DE")),
            ("b (DE)", None),
            ("b", None),
        ] {
            assert_eq!(in_brackets(name), expected, "{name}");
        }
    }
}
