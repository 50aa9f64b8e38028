//! Spectra against SciPy, and against motions whose spectra are known in closed form.

#![allow(clippy::unwrap_used)] // a test that cannot go on fails

mod estimates;
mod orders;
mod record;
mod requests;
mod scipy;
mod signal;
