//! Colours by what they mean; the SVG file and the page each know what they look like.

use serde::{Serialize, Serializer};

/// A colour of a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Colour {
    /// One of several without an order, below [`COLOURS`].
    Distinct(u8),
    /// A part from 0 to 1 of a colour map: blue over green to yellow.
    Graded(f32),
    /// What others are measured by, and what is not stable.
    Grey,
    /// Lines and text on a map.
    White,
}

impl Default for Colour {
    fn default() -> Self {
        Self::Distinct(0)
    }
}

/// What others are measured by, and what is not stable.
pub(in crate::report) const GREY: Colour = Colour::Grey;
/// Lines and text on a map.
pub(in crate::report) const WHITE: Colour = Colour::White;

/// Colours of Okabe & Ito (2008) that are told apart by every kind of colour vision.
const PALETTE: [[u8; 3]; 6] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [204, 121, 167],
    [230, 159, 0],
    [86, 180, 233],
];

/// Number of colours before they begin anew.
pub(in crate::report) const COLOURS: usize = PALETTE.len();

/// Colour number `index` of things without an order.
pub(in crate::report) fn distinct(index: usize) -> Colour {
    Colour::Distinct((index % COLOURS) as u8)
}

/// Colour number `index` of `count` values in their order.
pub(in crate::report) fn graded(index: usize, count: usize) -> Colour {
    Colour::Graded(index as f32 / count.saturating_sub(1).max(1) as f32)
}

/// Red, green and blue of a part from 0 to 1 of the colour map viridis in five anchors (Smith & van der Walt, 2015).
pub(super) fn shade(part: f32) -> [u8; 3] {
    const ANCHORS: [[f32; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [215.0, 205.0, 40.0],
    ];
    let place = part.clamp(0.0, 1.0) * (ANCHORS.len() - 1) as f32;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let part = place - below as f32;
    let mixed = |k: usize| ANCHORS[below][k] * (1.0 - part) + ANCHORS[below + 1][k] * part;
    [0, 1, 2].map(|k| mixed(k).round() as u8)
}

impl Colour {
    /// What it looks like on white paper: `#rrggbb`.
    pub(super) fn hex(self) -> String {
        let [red, green, blue] = match self {
            Self::Distinct(index) => PALETTE[usize::from(index) % COLOURS],
            Self::Graded(part) => shade(part),
            Self::Grey => [150; 3],
            Self::White => [255; 3],
        };
        format!("#{red:02x}{green:02x}{blue:02x}")
    }
}

/// `c0`, `grey`, `white`, or the part of the colour map to a thousandth.
impl Serialize for Colour {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Distinct(index) => serializer.serialize_str(&format!("c{index}")),
            Self::Graded(part) => serializer.serialize_f64((1e3 * f64::from(*part)).round() / 1e3),
            Self::Grey => serializer.serialize_str("grey"),
            Self::White => serializer.serialize_str("white"),
        }
    }
}
