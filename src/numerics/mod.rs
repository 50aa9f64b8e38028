//! Numerical methods that know nothing of bearings and shafts.

pub(crate) mod root;
