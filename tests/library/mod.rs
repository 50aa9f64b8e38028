//! Tests of the library as a whole: published numbers, laws, properties, hard cases. They are compiled into the
//! library's own tests: a crate of their own would make every law and register anew, which takes minutes.

// a test that cannot go on, or meets what it must not, says so and fails
#![allow(clippy::unwrap_used, clippy::panic)]

mod accuracy;
mod allocations;
mod architecture;
mod bearing_state;
mod campaign;
mod deep_groove;
mod elements;
mod endings;
mod equilibrium;
mod fit;
mod hard_cases;
mod imperfect;
mod integrate;
mod laws;
mod linear_response;
mod lines;
mod matrices;
mod measurement;
mod motion;
mod negative_clearance;
mod observation;
mod outer_ring;
mod properties;
mod published;
mod record;
mod report;
mod scenario;
mod spectra;
mod steady;
mod study_plan;
mod support;
mod supports;
mod table_files;
