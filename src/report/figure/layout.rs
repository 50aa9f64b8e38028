//! Places of the parts of a figure in a width, so that nothing is cut and no text covers another. The page's script
//! places them by the same rules.

use super::text::{LINE, SIZE, shortened, width, wrapped};
use super::ticks::{Tick, ticks};
use super::{Axis, Colour, Figure, Mark, Name, Panel, Point};

/// Least width of a column, px: narrower ones go below each other.
const COLUMN: f64 = 230.0;
/// Right of a plot, px.
const MARGIN: f64 = 14.0;
/// Room of a bar of colours with its numbers, px.
const BAR: f64 = 74.0;
/// Greatest height of a plot with an aspect, px.
const HIGHEST: f64 = 460.0;
/// Width of the key before a name, and of the gap behind it, px.
const BESIDE_NAME: f64 = 42.0;
/// Between texts side by side, px.
const APART: f64 = 8.0;
/// Most peaks that are named.
const MOST_PEAKS: usize = 10;

/// A text that is placed: by its middle and its base line.
#[derive(Debug, Clone)]
pub(super) struct Placed {
    pub text: String,
    pub x: f64,
    pub y: f64,
    pub colour: Option<Colour>,
    half: f64,
}

/// A name of a strip: its corner, from the corner of the strip.
#[derive(Debug, Clone)]
pub(super) struct StripName {
    pub text: String,
    pub colour: Colour,
    pub mark: Option<Mark>,
    pub left: f64,
    pub top: f64,
}

/// Place of a panel, px.
#[derive(Debug, Clone)]
pub(super) struct Place<'a> {
    pub panel: &'a Panel,
    /// Left and right end of its column.
    pub column: [f64; 2],
    /// Top of what is written above the plot.
    pub head: f64,
    pub title: Vec<String>,
    pub names: Vec<StripName>,
    /// The plot.
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
    /// What the axes show.
    pub x: [f64; 2],
    pub y: [f64; 2],
    /// Whether the axis below is named: not where the panel below it has the same one.
    pub names_x: bool,
    /// Whether the names along the axis to the left are written: not where the panel to the left has them.
    pub names_rows: bool,
}

/// The places of all panels below `top`, and the end of all.
pub(super) fn layout(figure: &Figure, width: f64, mut top: f64) -> (Vec<Place<'_>>, f64) {
    let columns = figure.columns.min((width / COLUMN) as usize).max(1);
    let panels = &figure.panels;
    let rooms = |room: &dyn Fn(usize) -> f64| -> Vec<f64> {
        let of_column = |column| (column..panels.len()).step_by(columns).map(room);
        (0..columns)
            .map(|column| of_column(column).fold(0.0, f64::max))
            .collect()
    };
    let lefts = rooms(&|index| room_left(panels, index, columns, width));
    let rights = rooms(&|index| {
        if panels[index].bar.is_some() {
            BAR
        } else {
            MARGIN
        }
    });
    let room: f64 = lefts.iter().chain(&rights).sum();
    // plots side by side are equally wide
    let plot = ((width - room) / columns as f64).max(40.0);
    let mut places: Vec<Place> = Vec::new();
    for (row, chunk) in panels.chunks(columns).enumerate() {
        let mut left = 0.0;
        for (column, panel) in chunk.iter().enumerate() {
            let index = row * columns + column;
            let right = left + lefts[column] + plot + rights[column];
            let below = panels.get(index + columns);
            places.push(Place {
                panel,
                column: [left, right],
                head: top,
                title: wrapped(&panel.title, SIZE + 1.0, right - left - APART),
                names: strip(&panel.names, right - left),
                left: left + lefts[column],
                top,
                width: plot,
                height: f64::from(panel.height).max(60.0),
                x: panel.x.ends,
                y: panel.y.ends,
                names_x: below.is_none_or(|below| below.x != panel.x),
                names_rows: names_rows(panels, index, columns),
            });
            left = right;
        }
        let placed = &mut places[row * columns..];
        let head = placed.iter().map(Place::head_height).fold(0.0, f64::max);
        for place in placed.iter_mut() {
            place.top += head;
            place.keep_aspect();
        }
        top = placed.iter().map(Place::end).fold(0.0, f64::max);
    }
    (places, top)
}

fn names_rows(panels: &[Panel], index: usize, columns: usize) -> bool {
    index.is_multiple_of(columns) || panels[index].y != panels[index - 1].y
}

/// Room to the left of a plot: what the longest text needs.
fn room_left(panels: &[Panel], index: usize, columns: usize, all: f64) -> f64 {
    let panel = &panels[index];
    if !panel.y.texts.is_empty() && !names_rows(panels, index, columns) {
        return MARGIN;
    }
    let height = panel.aspect.map_or(f64::from(panel.height), |_| HIGHEST);
    let ticks = ticks(&panel.y, panel.y.ends, steps_up(height));
    let widest = ticks
        .iter()
        .map(|tick| width(&tick.text, SIZE))
        .fold(20.0, f64::max);
    (widest + 14.0).min(0.55 * all / columns as f64)
}

/// Most ticks upwards.
fn steps_up(height: f64) -> usize {
    ((height / 34.0) as usize).max(2)
}

/// Names side by side in rows.
pub(super) fn strip(names: &[Name], most: f64) -> Vec<StripName> {
    let (mut left, mut top) = (0.0, 0.0);
    let mut placed = Vec::new();
    for name in names {
        let text = shortened(&name.text, SIZE, most - BESIDE_NAME);
        let room = width(&text, SIZE) + BESIDE_NAME;
        if left > 0.0 && left + room > most {
            (left, top) = (0.0, top + LINE + 2.0);
        }
        placed.push(StripName {
            text,
            colour: name.colour,
            mark: name.mark,
            left,
            top,
        });
        left += room;
    }
    placed
}

/// Height of a strip of names.
pub(super) fn strip_height(names: &[StripName]) -> f64 {
    names.last().map_or(0.0, |last| last.top + LINE + 6.0)
}

impl Place<'_> {
    fn head_height(&self) -> f64 {
        let label = if self.panel.y.texts.is_empty() {
            LINE
        } else {
            0.0
        };
        LINE * self.title.len() as f64 + strip_height(&self.names) + label + 12.0
    }

    /// Where the panel ends: below the numbers and the name of its axis.
    fn end(&self) -> f64 {
        self.top + self.height + LINE + if self.names_x { LINE + 12.0 } else { 8.0 }
    }

    /// Gives the plot the height of its aspect; of one that would be too high more is shown across.
    fn keep_aspect(&mut self) {
        let Some(aspect) = self.panel.aspect else {
            return;
        };
        let [[left, right], [low, high]] = [self.x, self.y];
        let up = aspect * (high - low);
        self.height = (self.width * up / (right - left)).min(HIGHEST);
        let half = 0.5 * up * self.width / self.height;
        let middle = 0.5 * (left + right);
        self.x = [middle - half, middle + half];
    }

    /// Place of a point, px.
    pub fn at(&self, (x, y): Point) -> (f64, f64) {
        let part = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let [x, y] = [
            part(self.panel.x.place(x), self.x),
            part(self.panel.y.place(y), self.y),
        ];
        (
            self.left + x * self.width,
            self.top + (1.0 - y) * self.height,
        )
    }

    /// Ticks below the plot, as many as their texts leave room for.
    pub fn ticks_below(&self) -> Vec<(f64, Placed)> {
        let axis = &self.panel.x;
        let placed = |tick: Tick| {
            let part = (tick.at - self.x[0]) / (self.x[1] - self.x[0]);
            let (at, half) = (self.left + part * self.width, 0.5 * width(&tick.text, SIZE));
            let x = inside(at, half, self.column);
            let y = self.top + self.height + LINE;
            (
                at,
                Placed {
                    text: tick.text,
                    x,
                    y,
                    colour: None,
                    half,
                },
            )
        };
        let most = ((self.width / 50.0) as usize).max(2);
        let tried = (1..=most).rev().map(|most| {
            let ticks = ticks(axis, self.x, most).into_iter();
            ticks.map(placed).collect::<Vec<_>>()
        });
        let are_apart = |ticks: &Vec<(f64, Placed)>| {
            ticks.windows(2).all(|pair| {
                let [a, b] = [&pair[0].1, &pair[1].1];
                b.x - a.x >= a.half + b.half + APART
            })
        };
        tried.into_iter().find(are_apart).unwrap_or_default()
    }

    /// Ticks to the left of the plot: their heights and texts.
    pub fn ticks_left(&self) -> Vec<(f64, String)> {
        let axis = &self.panel.y;
        let most = self.left - self.column[0] - APART;
        let is_told = self.names_rows || axis.texts.is_empty();
        let text = |text: String| {
            if is_told {
                shortened(&text, SIZE, most)
            } else {
                String::new()
            }
        };
        let ticks = self.ticks_up(axis, self.y).into_iter();
        ticks.map(|(y, value)| (y, text(value))).collect()
    }

    /// Ticks of an axis over the height of the plot.
    pub fn ticks_up(&self, axis: &Axis, [low, high]: [f64; 2]) -> Vec<(f64, String)> {
        let ticks = ticks(axis, [low, high], steps_up(self.height)).into_iter();
        let height = |at: f64| self.top + (high - at) / (high - low) * self.height;
        ticks.map(|tick| (height(tick.at), tick.text)).collect()
    }

    /// The labels of the panel inside its plot; one that would cover another moves above or below it.
    pub fn labels(&self) -> Vec<Placed> {
        let mut placed: Vec<Placed> = Vec::new();
        for (at, text, colour) in &self.panel.labels {
            let text = shortened(text, SIZE - 1.0, self.width - APART);
            let (x, y) = self.at(*at);
            let half = 0.5 * width(&text, SIZE - 1.0);
            let x = inside(x + 3.0 + half, half, [self.left, self.left + self.width]);
            let steps = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0];
            let free = steps.into_iter().find_map(|step| {
                let y = y + 10.0 + 15.0 * step;
                let label = Placed {
                    text: text.clone(),
                    x,
                    y,
                    colour: Some(*colour),
                    half,
                };
                let inside = y - 10.0 >= self.top && y + 3.0 <= self.top + self.height;
                (inside && !label.covers(&placed)).then_some(label)
            });
            placed.extend(free);
        }
        placed
    }

    /// The peaks that the plot shows, each with its point; a name that would cover a label or one before it moves up, or
    /// is left out where there is no room either.
    pub fn peaks(&self) -> Vec<(Point, Placed)> {
        let mut taken = self.labels();
        let mut peaks = Vec::new();
        let ends = [self.left, self.left + self.width];
        for (at, text) in &self.panel.peaks {
            let (x, y) = self.at(*at);
            let half = 0.5 * width(text, SIZE);
            let is_inside =
                (ends[0]..=ends[1]).contains(&x) && y >= self.top && y <= self.top + self.height;
            if !is_inside || peaks.len() == MOST_PEAKS {
                continue;
            }
            let tried = [6.0, 21.0, 36.0].map(|above| Placed {
                text: text.clone(),
                x: inside(x, half, ends),
                y: (y - above).max(self.top + 11.0),
                colour: None,
                half,
            });
            if let Some(peak) = tried.into_iter().find(|peak| !peak.covers(&taken)) {
                taken.push(peak.clone());
                peaks.push(((x, y), peak));
            }
        }
        peaks
    }
}

impl Placed {
    fn covers(&self, others: &[Self]) -> bool {
        let mut others = others.iter();
        others.any(|other| {
            (other.x - self.x).abs() < other.half + self.half + 4.0
                && (other.y - self.y).abs() < 15.0
        })
    }
}

/// The middle of a text that keeps within two ends.
pub(super) fn inside(at: f64, half: f64, [from, to]: [f64; 2]) -> f64 {
    at.min(to - half - 2.0).max(from + half + 2.0)
}
