//! Numerical methods that know nothing of bearings and shafts.

pub(crate) mod cube_root;
pub(crate) mod digits;
pub(crate) mod distinct;
pub(crate) mod eigenvectors;
pub(crate) mod elimination;
pub(crate) mod minimum;
pub(crate) mod panels;
pub(crate) mod registers;
pub(crate) mod root;
