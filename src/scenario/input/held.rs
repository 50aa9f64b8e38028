//! Whether bearings hold the shaft along the axis.

use crate::bearing::{Facing, MountedBearing, Preload};
use crate::scenario::problems::Problems;

/// Warns where all bearings bear or are preloaded axially the same way, and nothing presses against it; there is no axial
/// load.
///
/// `last` is the index of the last table that describes them.
pub fn warn_where_unheld(bearings: &[MountedBearing], last: usize, problems: &mut Problems<'_>) {
    let Some(first) = bearings.first() else {
        return;
    };
    let angular = |mounted: &MountedBearing| {
        let geometry = &mounted.bearing.geometry;
        !geometry.is_symmetric() && geometry.nominal_angle() > 0.0
    };
    let preloaded = |mounted: &MountedBearing| match mounted.preload {
        Preload::AxialOffset(value) | Preload::Force(value) | Preload::Spring(value) => value > 0.0,
    };
    let one_way = |mounted: &MountedBearing| {
        mounted.facing == first.facing && (angular(mounted) || preloaded(mounted))
    };
    if !bearings.iter().all(one_way) {
        return;
    }
    let [way, other, force] = match first.facing {
        Facing::PlusZ => ["+z", "-z", "500 N"],
        Facing::MinusZ => ["-z", "+z", "-500 N"],
    };
    let load = format!("a load along {way}, as in `[[load]]` constant = {{ z = \"{force}\" }}");
    problems.warn(match bearings.len() {
        1 if preloaded(first) => format!(
            "nothing bears the preload of a single bearing, and the shaft gives way along {other}: add a second \
             `[[bearing]]` with facing = \"{other}\", leave the preload out, or add {load}"
        ),
        1 => format!(
            "a single angular contact or tapered bearing bears axially one way only and needs an axial load: with none it \
             hardly holds the shaft; add {load}"
        ),
        count => {
            let turned = match last {
                0 => "set arrangement = \"back-to-back\" in `bearing[1]`".to_owned(),
                last => format!("write facing = \"{other}\" in `bearing[{}]`", last + 1),
            };
            let face = match bearings.iter().all(angular) {
                true => "bearings face",
                false => "bearings face or are preloaded",
            };
            format!(
                "all {count} {face} the same way, {way}: none holds the shaft against the others, and a preload of theirs is \
                 not borne; {turned}, or add {load}"
            )
        }
    });
}
