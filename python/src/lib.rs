//! What the Python package `jeffcott` calls: questions of the crate with the lock of the interpreter released, their
//! tables as numpy arrays, their documents as JSON. The package itself, `python/jeffcott`, gives it its shape.

mod answer;
mod arrow;
mod compare;
mod errors;
mod fit;
mod record;
mod scenario;
mod study;
mod watch;

use pyo3::prelude::*;

/// The compiled part of `jeffcott`; use the package.
#[pymodule(gil_used = false)]
mod _jeffcott {
    #[pymodule_export]
    use crate::answer::{Findings, RunFindings};
    #[pymodule_export]
    use crate::arrow::arrow_stream;
    #[pymodule_export]
    use crate::compare::compare;
    #[pymodule_export]
    use crate::fit::fit;
    #[pymodule_export]
    use crate::record::analyze;
    #[pymodule_export]
    use crate::scenario::{CheckedScenario, catalogue};
    #[pymodule_export]
    use crate::study::{StudyPlan, merge};
    #[pymodule_export]
    use crate::watch::StopSignal;

    #[pymodule_export]
    #[allow(non_upper_case_globals, missing_docs)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
