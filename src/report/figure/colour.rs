//! Colours of curves, of grades and of what frames them.

use plotters::style::RGBColor;

/// Colours of Okabe & Ito (2008) that are told apart by every kind of colour vision.
const PALETTE: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Text and axes.
pub(super) const INK: RGBColor = RGBColor(40, 40, 40);
/// Grid.
pub(super) const GRID: RGBColor = RGBColor(225, 225, 225);
/// What others are measured by, and what is not stable.
pub(in crate::report) const GREY: RGBColor = RGBColor(150, 150, 150);
/// Paper, and text on dark maps.
pub(in crate::report) const WHITE: RGBColor = RGBColor(255, 255, 255);

/// Number of colours before they begin anew.
pub(in crate::report) const COLOURS: usize = PALETTE.len();

/// Colour number `index` of things without an order.
pub(in crate::report) fn distinct(index: usize) -> RGBColor {
    PALETTE[index % COLOURS]
}

/// Colour number `index` of `count` values in their order: blue over green to yellow.
pub(in crate::report) fn graded(index: usize, count: usize) -> RGBColor {
    /// The colour map viridis in five anchors (Smith & van der Walt, 2015).
    const ANCHORS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [215.0, 205.0, 40.0],
    ];
    let steps = count.saturating_sub(1).max(1);
    let place = (ANCHORS.len() - 1) as f64 * index as f64 / steps as f64;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let part = place - below as f64;
    let mixed = |k: usize| ANCHORS[below][k] * (1.0 - part) + ANCHORS[below + 1][k] * part;
    let [red, green, blue] = [0, 1, 2].map(|k| mixed(k).round() as u8);
    RGBColor(red, green, blue)
}
