//! How two results are compared, and how far their values may be apart.

use std::str::FromStr;

use super::CompareError;

/// Allowed difference: `absolute + relative · max|column|`, of a spectrum the largest of its lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    relative: f64,
    absolute: f64,
}

impl Tolerance {
    /// A millionth of the largest magnitude in the column.
    pub const DEFAULT: Self = Self {
        relative: 1e-6,
        absolute: 0.0,
    };

    /// Checks both parts; `absolute` is in the unit of the column.
    ///
    /// # Errors
    /// [`CompareError::Tolerance`] where one is negative or not finite.
    pub fn new(relative: f64, absolute: f64) -> Result<Self, CompareError> {
        check("relative tolerance", relative)?;
        check("absolute tolerance", absolute)?;
        Ok(Self { relative, absolute })
    }

    /// Whether values must be equal.
    pub(super) fn is_exact(self) -> bool {
        self.relative == 0.0 && self.absolute == 0.0
    }

    /// Difference allowed in a column whose largest magnitude is `scale`.
    ///
    /// ```
    /// use jeffcott::report::compare::Tolerance;
    /// assert_eq!(Tolerance::new(0.5, 1.0)?.allowed(4.0), 3.0);
    /// # Ok::<(), jeffcott::report::compare::CompareError>(())
    /// ```
    pub fn allowed(self, scale: f64) -> f64 {
        self.absolute + self.relative * scale
    }
}

/// Refuses what is negative, and what lets everything agree.
fn check(kind: &'static str, value: f64) -> Result<(), CompareError> {
    match value >= 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err(CompareError::Tolerance { kind, value }),
    }
}

/// What two values of a column may differ by: its tolerance of a scale, and something more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Allowance {
    pub tolerance: Tolerance,
    pub scale: f64,
    pub more: f64,
}

impl Allowance {
    /// So many dB.
    pub fn decibels(most: f64) -> Self {
        Self {
            tolerance: Tolerance {
                relative: most,
                absolute: 0.0,
            },
            scale: 1.0,
            more: 0.0,
        }
    }

    /// Both together.
    pub fn total(self) -> f64 {
        self.tolerance.allowed(self.scale) + self.more
    }
}

/// The tolerance of every column.
#[derive(Debug, Clone, PartialEq)]
pub struct Tolerances {
    default: Tolerance,
    /// Of the columns that have one of their own.
    pub(super) columns: Vec<(String, Tolerance)>,
}

impl Tolerances {
    /// One tolerance for all columns.
    pub fn uniform(default: Tolerance) -> Self {
        Self {
            default,
            columns: Vec::new(),
        }
    }

    /// Another tolerance for the column `name`; the last one given counts.
    #[must_use]
    pub fn with_column(mut self, name: &str, tolerance: Tolerance) -> Self {
        self.columns.push((name.to_owned(), tolerance));
        self
    }

    /// Tolerance of the column `name`.
    pub fn of_column(&self, name: &str) -> Tolerance {
        self.own(name).unwrap_or(self.default)
    }

    /// Tolerance of the column `name` that rows are matched by: its own, or [`Tolerance::DEFAULT`] unless equal values are asked
    /// for. What values may differ by at a place is no measure of places.
    pub(super) fn of_axis(&self, name: &str) -> Tolerance {
        self.own(name).unwrap_or(match self.default.is_exact() {
            true => self.default,
            false => Tolerance::DEFAULT,
        })
    }

    fn own(&self, name: &str) -> Option<Tolerance> {
        let mut own = self.columns.iter().rev();
        own.find(|(column, _)| column == name)
            .map(|(_, tolerance)| *tolerance)
    }
}

/// How two results are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Rules {
    /// How far values may be apart.
    pub tolerances: Tolerances,
    /// Places that are reported of every column, the worst first; at least one.
    pub worst: usize,
    /// Compares what both results have; otherwise a file, a column or every other row that only one of
    /// them has is a difference.
    pub common: bool,
    /// Compares spectra by the strongest lines of every column, whatever their bins, instead of row by row; other tables are left
    /// out.
    pub lines: Option<LineRules>,
}

/// How the strongest lines of spectra are compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineRules {
    /// How many of every column.
    pub count: usize,
    /// How they find their partners.
    pub by: LinesBy,
    /// Part of its frequency or order within which a line finds its partner, in place of a bin of the coarser axis.
    pub reach: Option<f64>,
    /// Lets lines be so many dB apart, in place of the tolerances.
    pub decibels: Option<f64>,
}

/// How lines of two results find their partners.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LinesBy {
    /// At the frequency, or the order of a spectrum over orders.
    #[default]
    Frequency,
    /// At the multiple of the frequency of the own shaft.
    Order,
    /// By name, each at its own frequency: BPFO to BPFO.
    Name,
}

impl FromStr for LinesBy {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        match word {
            "frequency" => Ok(Self::Frequency),
            "order" => Ok(Self::Order),
            "name" => Ok(Self::Name),
            _ => Err("lines are matched by `frequency`, `order` or `name`".to_owned()),
        }
    }
}

impl Rules {
    /// Row by row, everything, one place a column.
    pub fn new(tolerances: Tolerances) -> Self {
        Self {
            tolerances,
            worst: 1,
            common: false,
            lines: None,
        }
    }

    /// Refuses lines that would always agree, or never.
    ///
    /// # Errors
    /// [`CompareError::Tolerance`] where their reach or their decibels are negative or not finite.
    pub(super) fn check(&self) -> Result<(), CompareError> {
        let (reach, decibels) = self
            .lines
            .map_or((None, None), |own| (own.reach, own.decibels));
        check("reach", reach.unwrap_or(0.0))?;
        check("difference in decibels", decibels.unwrap_or(0.0))
    }
}

impl LineRules {
    /// So many, by frequency to a bin, within the tolerances.
    pub fn new(count: usize) -> Self {
        Self {
            count,
            by: LinesBy::default(),
            reach: None,
            decibels: None,
        }
    }
}

impl Default for Rules {
    /// Within [`Tolerance::DEFAULT`] everywhere.
    fn default() -> Self {
        Self::new(Tolerances::uniform(Tolerance::DEFAULT))
    }
}
