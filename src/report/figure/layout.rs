//! Where the parts of a figure stand, px.

use super::axis::{LEFT_ROOM, LETTER};
use super::{Figure, Name, Panel};

/// Width of a figure.
pub(super) const WIDTH: u32 = 900;
/// Height of the title.
const TITLE: u32 = 40;
/// Height of a row of names.
pub(super) const NAMES_ROW: u32 = 22;
/// Width of what stands before a name, and of the gap behind it.
const BESIDE_NAME: u32 = 37;
/// Height of a line of words.
pub(super) const LINE_OF_WORDS: u32 = 22;
/// Beside a plot.
pub(super) const MARGIN: u32 = 12;
/// Above a plot.
pub(super) const MARGIN_ABOVE: u32 = 10;

/// Width of the plot of a panel that stands alone.
pub(in crate::report) const PLOT_WIDTH: u32 = WIDTH - LEFT_ROOM - 2 * MARGIN;

/// A part of a figure.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub left: u32,
    pub top: u32,
    pub width: u32,
    pub height: u32,
}

/// Corners of names that stand side by side in rows, and the height of all.
pub(super) fn strip(names: &[Name], width: u32) -> (Vec<(u32, u32)>, u32) {
    let (mut left, mut top) = (LEFT_ROOM, 0);
    let mut corners = Vec::new();
    for name in names {
        let room = BESIDE_NAME + LETTER * name.text.chars().count() as u32;
        if left > LEFT_ROOM && left + room > width {
            (left, top) = (LEFT_ROOM, top + NAMES_ROW);
        }
        corners.push((left, top));
        left += room;
    }
    let height = if names.is_empty() { 0 } else { top + NAMES_ROW };
    (corners, height)
}

impl Figure {
    /// The strip of names, the panels in their order, and the height of all.
    pub(super) fn layout(&self) -> (Part, Vec<Part>, u32) {
        let columns = self.columns.max(1);
        let names = Part {
            left: 0,
            top: TITLE,
            width: WIDTH,
            height: strip(&self.names, WIDTH).1,
        };
        let widths = self.widths(columns);
        let mut top = names.top + names.height;
        let mut parts = Vec::new();
        for row in self.panels.chunks(columns) {
            let heights = row
                .iter()
                .zip(&widths)
                .map(|(panel, width)| panel.full_height(*width));
            let height = heights.max().unwrap_or(0);
            let mut left = 0;
            for width in widths.iter().take(row.len()) {
                parts.push(Part {
                    left,
                    top,
                    width: *width,
                    height,
                });
                left += width;
            }
            top += height;
        }
        (names, parts, top.max(TITLE + NAMES_ROW))
    }

    /// Widths of the columns, whose plots are equally wide.
    fn widths(&self, columns: usize) -> Vec<u32> {
        let rooms = (0..columns).map(|column| {
            let panels = self.panels.iter().skip(column).step_by(columns);
            panels.map(|panel| panel.y.room_left()).max().unwrap_or(0)
        });
        let rooms: Vec<u32> = rooms.collect();
        let plots = WIDTH.saturating_sub(rooms.iter().sum());
        let widths = rooms.iter().map(|room| room + plots / columns as u32);
        widths.collect()
    }
}

impl Panel {
    /// Height with all that stands above and below the plot.
    fn full_height(&self, width: u32) -> u32 {
        let words = LINE_OF_WORDS * self.words.len() as u32;
        let plot = MARGIN_ABOVE + self.height + self.x.room_below();
        self.head_height(width) + plot.max(words)
    }

    /// Height of what stands above the plot.
    pub(super) fn head_height(&self, width: u32) -> u32 {
        let title = if self.title.is_empty() { 0 } else { NAMES_ROW };
        title + strip(&self.names, width).1
    }
}
