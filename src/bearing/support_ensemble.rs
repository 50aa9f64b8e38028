//! Bearings of rotors that move side by side.

use super::{HertzLaw, LANES, Ring, Support};

/// A number of every rotor side by side.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(32))]
pub(crate) struct LaneRow(pub [f64; LANES]);

/// The ring of a bearing and its axial preset in m, where they know nothing but Hertz contacts.
pub(super) fn plain(support: &Support) -> Option<(&Ring<HertzLaw>, f64)> {
    match support.frozen {
        Some(_) => None,
        None => support.plain_ring(),
    }
}
