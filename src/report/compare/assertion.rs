//! Comparison of spectra in Rust tests.

use std::path::{Path, PathBuf};

use super::table::Source;
use super::{CompareError, Comparison, Rules, compare_tables};
use crate::analysis::Spectrum;

/// A spectrum, or the file that holds one.
#[derive(Debug, Clone)]
pub enum ComparedSpectrum<'a> {
    /// In memory.
    Spectrum(&'a Spectrum),
    /// A `spectrum.csv`, or the run folder that holds it.
    Path(PathBuf),
}

impl<'a> From<&'a Spectrum> for ComparedSpectrum<'a> {
    fn from(spectrum: &'a Spectrum) -> Self {
        Self::Spectrum(spectrum)
    }
}

impl<P: AsRef<Path> + ?Sized> From<&P> for ComparedSpectrum<'_> {
    fn from(path: &P) -> Self {
        Self::Path(path.as_ref().to_owned())
    }
}

impl ComparedSpectrum<'_> {
    fn table(&self, name: &str) -> Result<Source<'_>, CompareError> {
        match self {
            Self::Spectrum(spectrum) => Ok(Source::of_spectrum(name, spectrum)),
            Self::Path(path) if path.is_dir() => Source::open(&path.join("spectrum.csv")),
            Self::Path(path) => Source::open(path),
        }
    }
}

/// Compares two spectra as `jeffcott compare` does; what differs or cannot be compared is an error that
/// reads as what `compare` prints. The names are what it calls them.
///
/// # Errors
/// What differs, or why they cannot be compared.
pub fn spectra_close(
    [first_name, second_name]: [&str; 2],
    first: &ComparedSpectrum<'_>,
    second: &ComparedSpectrum<'_>,
    rules: &Rules,
) -> Result<(), String> {
    let compared = || {
        rules.check()?;
        let tables = [first.table(first_name)?, second.table(second_name)?];
        let name = format!("{first_name} against {second_name}");
        let table = compare_tables(name, &tables, rules)?;
        Comparison::new(vec![table], Vec::new(), rules)
    };
    match compared() {
        Ok(comparison) if comparison.agrees() => Ok(()),
        Ok(comparison) => Err(comparison.to_string()),
        Err(error) => Err(error.with_causes()),
    }
}

/// Panics where two spectra differ, with the message of `jeffcott compare`: the worst place of every
/// column, and what would let them agree.
///
/// Each is a `&Spectrum` or the path of a `spectrum.csv` or of a run folder. Without a tolerance it is
/// 1e-6 of the largest value in the column; `relative = …` and `absolute = …` give another, and
/// [`Rules`](crate::report::compare::Rules) everything that `compare` knows.
///
/// ```
/// use jeffcott::analysis::{Channel, ChannelSpectrum, Spectrum, Window};
/// use jeffcott::assert_spectra_close;
/// use jeffcott::report::compare::{LineRules, Rules, Tolerance, Tolerances};
///
/// let spectrum = |amplitude: f64| Spectrum {
///     resolution: 10.0,
///     shaft_frequency: 0.0,
///     length: 4,
///     start: 0.0,
///     window: Window::Rectangular,
///     channels: vec![ChannelSpectrum {
///         channel: Channel::from_name("x").expect("a column of every run"),
///         amplitude: vec![0.0, amplitude, 0.0],
///         phase: vec![0.0; 3],
///     }],
/// };
/// let (before, after) = (spectrum(1e-6), spectrum(1.001e-6));
/// assert_spectra_close!(&before, &before);
/// assert_spectra_close!(&before, &after, relative = 1e-2);
/// assert_spectra_close!(&before, &after, relative = 0.0, absolute = 2e-9);
/// let rules = Rules {
///     lines: Some(LineRules::new(1)),
///     ..Rules::new(Tolerances::uniform(Tolerance::new(1e-2, 0.0)?))
/// };
/// assert_spectra_close!(&before, &after, rules);
/// # Ok::<(), jeffcott::report::compare::CompareError>(())
/// ```
#[macro_export]
macro_rules! assert_spectra_close {
    ($first:expr, $second:expr $(,)?) => {
        $crate::assert_spectra_close!($first, $second, $crate::report::compare::Rules::default())
    };
    ($first:expr, $second:expr, relative = $relative:expr $(,)?) => {
        $crate::assert_spectra_close!($first, $second, relative = $relative, absolute = 0.0)
    };
    ($first:expr, $second:expr, relative = $relative:expr, absolute = $absolute:expr $(,)?) => {
        match $crate::report::compare::Tolerance::new($relative, $absolute) {
            Err(error) => ::std::panic!("{error}"),
            Ok(tolerance) => {
                let tolerances = $crate::report::compare::Tolerances::uniform(tolerance);
                let rules = $crate::report::compare::Rules::new(tolerances);
                $crate::assert_spectra_close!($first, $second, rules)
            }
        }
    };
    ($first:expr, $second:expr, $rules:expr $(,)?) => {
        if let Err(message) = $crate::report::compare::spectra_close(
            [stringify!($first), stringify!($second)],
            &$crate::report::compare::ComparedSpectrum::from($first),
            &$crate::report::compare::ComparedSpectrum::from($second),
            &$rules,
        ) {
            ::std::panic!("spectra are not close\n{message}")
        }
    };
}
