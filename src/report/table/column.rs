//! What a column of a table is called, and what its numbers stand for.

use std::borrow::Cow;

/// What the numbers of a column stand for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ColumnKind {
    /// A real number, or nothing where it is NaN.
    Number,
    /// A whole number, exact below 2^53, or nothing where it is NaN.
    Count,
    /// The word at this index.
    Word(Vec<String>),
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Quantity and unit, valid as a name in MATLAB and pandas: `x_velocity_m_s`.
    pub name: Cow<'static, str>,
    /// What its numbers stand for.
    pub kind: ColumnKind,
}

impl Column {
    /// A column of real numbers.
    pub fn number(name: impl Into<Cow<'static, str>>) -> Self {
        Self::of(name, ColumnKind::Number)
    }

    /// A column of whole numbers.
    pub fn count(name: impl Into<Cow<'static, str>>) -> Self {
        Self::of(name, ColumnKind::Count)
    }

    /// A column of words, of which a row holds the index.
    pub fn words(
        name: impl Into<Cow<'static, str>>,
        words: impl IntoIterator<Item = impl Into<String>>,
    ) -> Self {
        let words = words.into_iter().map(Into::into).collect();
        Self::of(name, ColumnKind::Word(words))
    }

    /// A column of a kind.
    pub fn of(name: impl Into<Cow<'static, str>>, kind: ColumnKind) -> Self {
        Self {
            name: name.into(),
            kind,
        }
    }
}
