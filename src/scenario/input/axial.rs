//! Bearings that no axial load presses together.

use crate::bearing::{MountedBearing, Preload};
use crate::scenario::problems::Problems;

/// Warns where all bearings bear axially the same way, and none of them is pressed that way; there is no axial load.
///
/// `inputs` is the number of tables that describe them.
pub fn warn_where_unheld(bearings: &[MountedBearing], inputs: usize, problems: &mut Problems<'_>) {
    let Some(first) = bearings.first() else {
        return;
    };
    let one_way = |mounted: &MountedBearing| {
        mounted.facing == first.facing
            && !mounted.bearing.geometry.is_symmetric()
            && mounted.bearing.geometry.nominal_angle() > 0.0
            && !matches!(mounted.preload, Preload::Spring(_))
    };
    if !bearings.iter().all(one_way) {
        return;
    }
    let [way, other] = if first.facing.sign() > 0.0 {
        ["+z", "-z"]
    } else {
        ["-z", "+z"]
    };
    let load = format!(
        "a load along {way}, as in `[[load]]` constant = {{ z = \"{}500 N\" }}",
        way.trim_end_matches('z').trim_start_matches('+')
    );
    problems.warn(match bearings.len() {
        1 => format!(
            "a single angular contact bearing bears axially one way only and needs an axial load: with none its \
             balls lose their contact angle and hardly hold the shaft; add {load}"
        ),
        count => {
            let turned = match inputs {
                1 => "set arrangement = \"back-to-back\" in `bearing[0]`".to_owned(),
                inputs => format!("write facing = \"{other}\" in `bearing[{}]`", inputs - 1),
            };
            format!(
                "all {count} angular contact bearings face the same way, {way}: none holds the shaft against the \
                 others, and a preload of theirs is not borne; {turned}, or add {load}"
            )
        }
    });
}
