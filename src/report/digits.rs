//! Numbers as people read them.

use crate::numerics::digits::to_digits;

/// A text whose numbers that are rounded to zero have no minus sign: `-0.0000` → `0.0000`.
pub(super) fn without_negative_zeros(text: &str) -> String {
    let in_number = |c: char| c.is_alphanumeric() || c == '.';
    let mut out = String::with_capacity(text.len());
    for (index, c) in text.char_indices() {
        let rest = &text[index + c.len_utf8()..];
        let end = rest.find(|c| !in_number(c)).unwrap_or(rest.len());
        let number = rest[..end].trim_end_matches('.').trim_end_matches("e0");
        let is_zero =
            number.starts_with('0') && number.bytes().all(|byte| matches!(byte, b'0' | b'.'));
        let begins = !out.ends_with(|c: char| c.is_alphanumeric() || c == '_');
        if !(c == '-' && is_zero && begins) {
            out.push(c);
        }
    }
    out
}

/// Four decimals.
pub(super) fn decimal(value: f64) -> String {
    format!("{value:.4}")
}

/// Four decimals, or powers of ten where they would not show the value.
pub(super) fn significant(value: f64) -> String {
    if (1e-2..1e5).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.3e}")
    }
}

/// Five significant digits; powers of ten where they would be many.
pub(super) fn digits(value: f64) -> String {
    in_digits(value, 5)
}

/// So many significant digits; powers of ten where they would be many.
pub(super) fn in_digits(value: f64, count: usize) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&size) {
        let decimals = (count as f64 - 1.0 - size.log10().floor()).max(0.0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{:e}", to_digits(value, count.min(4)))
    }
}
