//! Published and independently computed numbers, one file per source.

mod catalogue;
mod fits_and_life;
mod harris;
mod jis_6306_varying_compliance;
mod jones_7205c;
mod kinematics;
mod masta_6305;
mod quasi_static_7205c;
pub mod rollers;
mod tiwari_6204;
mod validation_page;
