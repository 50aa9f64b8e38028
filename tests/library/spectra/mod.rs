//! Spectra against SciPy, and against motions whose spectra are known in closed form.

mod close;
mod closed_form;
mod estimates;
mod orders;
mod record;
mod requests;
mod scipy;
mod signal;
