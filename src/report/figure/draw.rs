//! Draws a figure as SVG: where its parts stand, curves and axes, and maps as pictures.

use std::collections::BTreeSet;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::{LEFT_ROOM, LETTER};
use super::{Axis, Curve, Figure, GRID, INK, Map, Mark, Name, Panel, Point, graded};

/// Drawing units a pixel: the library draws at whole units, so this is the sharpness of curves.
const SCALE: u32 = 2;
/// Width of a curve, drawing units.
const LINE: u32 = 2;
/// Largest number of peaks that are named.
const MOST_PEAKS: usize = 10;
/// Colours of a map.
const COLOURS: usize = 256;

/// Width of a bar of colours with its numbers, px.
const BAR: u32 = 118;

/// What the drawing library answers.
type DrawError = Box<dyn std::error::Error + Send + Sync>;
/// A part of the figure.
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A plot with its axes.
type Plot<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

/// The figure as SVG.
pub(super) fn svg(figure: &Figure) -> Result<String, DrawError> {
    let (names, parts, height) = figure.layout();
    let mut text = String::new();
    let mut pictures = Vec::new();
    {
        let size = (px(WIDTH), px(height));
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        root.fill(&WHITE)?;
        write(&root, &figure.title, (WIDTH / 2, 10), font(18).pos(CENTRED))?;
        draw_names(&part(&root, names), &figure.names)?;
        for (panel, place) in figure.panels.iter().zip(parts) {
            draw_panel(&part(&root, place), panel, place.width, &mut pictures)?;
        }
        root.present()?;
    }
    // the canvas is SCALE times as large as the picture that shows it
    let canvas = format!("width=\"{}\" height=\"{}\"", px(WIDTH), px(height));
    let shown = format!("width=\"{WIDTH}\" height=\"{height}\"");
    let text = text.replacen(&canvas, &shown, 1);
    Ok(pictures.iter().fold(text, placed))
}

/// Below a place and about it.
const CENTRED: Pos = Pos {
    h_pos: HPos::Center,
    v_pos: VPos::Top,
};

/// Lengths in px as drawing units.
const fn px(pixels: u32) -> u32 {
    pixels * SCALE
}

/// A font of `size` px. No system font is needed: the text is drawn by whoever shows the SVG.
fn font(size: u32) -> TextStyle<'static> {
    ("sans-serif", px(size)).into_font().color(&INK)
}

fn part<'a>(root: &Area<'a>, part: Part) -> Area<'a> {
    let [left, top, width, height] =
        [part.left, part.top, part.width, part.height].map(|length| px(length) as i32);
    root.clone().shrink((left, top), (width, height))
}

/// Writes a text at a place in px, without the control characters that XML 1.0 forbids.
fn write(
    area: &Area,
    text: &str,
    (left, top): (u32, u32),
    style: TextStyle,
) -> Result<(), DrawError> {
    let blank = |c: char| if c.is_control() { ' ' } else { c };
    let text: String = text.chars().map(blank).collect();
    area.draw(&Text::new(text, (px(left) as i32, px(top) as i32), style))?;
    Ok(())
}

/// The names side by side, each behind a stroke of its colour.
fn draw_names(area: &Area, names: &[Name]) -> Result<(), DrawError> {
    let (corners, _) = strip(names, area.dim_in_pixel().0 / SCALE);
    for (name, (left, top)) in names.iter().zip(corners) {
        let middle = px(top + NAMES_ROW / 2) as i32;
        let [from, centre, to] = [0, 9, 18].map(|right| (px(left + right) as i32, middle));
        let width = if name.mark.is_some() { LINE } else { 2 * LINE };
        area.draw(&PathElement::new(
            [from, to],
            name.colour.stroke_width(width),
        ))?;
        if let Some(mark) = name.mark {
            draw_mark(area, mark, centre, name.colour)?;
        }
        write(area, &name.text, (left + 23, top + 5), font(12))?;
    }
    Ok(())
}

fn draw_panel(
    area: &Area,
    panel: &Panel,
    width: u32,
    pictures: &mut Vec<Picture>,
) -> Result<(), DrawError> {
    let (head, plot) = area.split_vertically(px(panel.head_height(width)) as i32);
    if !panel.title.is_empty() {
        write(&head, &panel.title, (width / 2, 4), font(15).pos(CENTRED))?;
    }
    let title = if panel.title.is_empty() { 0 } else { NAMES_ROW };
    draw_names(&head.split_vertically(px(title) as i32).1, &panel.names)?;
    let Some(values) = &panel.bar else {
        return draw_plot(&plot, panel, pictures);
    };
    let (plot, bar) = plot.split_horizontally(px(width - BAR) as i32);
    draw_plot(&plot, panel, pictures)?;
    draw_plot(&bar, &colour_bar(values, panel), pictures)
}

/// All colours from below to above, beside the plot of a panel.
fn colour_bar(values: &Axis, panel: &Panel) -> Panel {
    let colours = Map {
        width: 1,
        levels: (0..=u8::MAX).rev().collect(),
        ..Map::default()
    };
    Panel {
        map: Some(colours),
        ..Panel::new(Axis::blank(), values.clone(), panel.height)
    }
}

fn draw_plot(area: &Area, panel: &Panel, pictures: &mut Vec<Picture>) -> Result<(), DrawError> {
    let (x, y) = (&panel.x, &panel.y);
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(MARGIN_ABOVE))
        .margin_left(px(MARGIN))
        .margin_right(px(MARGIN))
        .set_label_area_size(LabelAreaPosition::Left, px(y.room_left()))
        .set_label_area_size(LabelAreaPosition::Bottom, px(x.room_below()))
        .build_cartesian_2d(x.clone(), y.clone())?;
    let cells = panel.cells.iter();
    let cells = cells.map(|cell| {
        let corners = cell.corners.map(|corner| panel.place(corner));
        Rectangle::new(corners, cell.colour.filled())
    });
    chart.draw_series(cells)?;
    if let Some(map) = &panel.map {
        let corners =
            [(x.least(), y.most()), (x.most(), y.least())].map(|corner| panel.place(corner));
        let picture = Picture::of(map, pictures.len());
        chart.draw_series([Rectangle::new(corners, picture.held.filled())])?;
        pictures.push(picture);
    }
    draw_axes(&mut chart, panel)?;
    for curve in &panel.curves {
        draw_curve(area, &mut chart, panel, curve)?;
    }
    for (at, text, colour) in &panel.labels {
        let style = font(10).color(colour);
        chart.draw_series([Text::new(text.clone(), panel.place(*at), style)])?;
    }
    draw_peaks(area, &chart, panel)
}

fn draw_axes(chart: &mut Plot, panel: &Panel) -> Result<(), DrawError> {
    let mut mesh = chart.configure_mesh();
    if panel.cells.is_empty() && panel.map.is_none() {
        mesh.bold_line_style(GRID).light_line_style(TRANSPARENT);
    } else {
        mesh.disable_mesh();
    }
    mesh.x_labels(panel.x.count())
        .y_labels(panel.y.count())
        .x_label_formatter(&|tick| panel.x.text(*tick))
        .y_label_formatter(&|tick| panel.y.text(*tick))
        .x_desc(&panel.x.name)
        .y_desc(&panel.y.name)
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    Ok(())
}

fn draw_curve(
    area: &Area,
    chart: &mut Plot,
    panel: &Panel,
    curve: &Curve,
) -> Result<(), DrawError> {
    let stroke = curve.colour.stroke_width(if curve.fine { 1 } else { LINE });
    let points = curve.points.iter().map(|point| panel.place(*point));
    chart.draw_series(LineSeries::new(points, stroke))?;
    // of marks on one spot one is drawn: the file stays small
    let mut taken = BTreeSet::new();
    for mark in &curve.marks {
        let (x, y) = spot(area, chart, panel, *mark);
        if taken.insert((x / 2, y / 2)) {
            draw_mark(area, curve.mark, (x, y), curve.colour)?;
        }
    }
    Ok(())
}

/// Where a point stands in the area around the plot, drawing units.
fn spot(area: &Area, chart: &Plot, panel: &Panel, point: Point) -> (i32, i32) {
    let (left, top) = area.get_base_pixel();
    let (x, y) = chart.backend_coord(&panel.place(point));
    (x - left, y - top)
}

fn draw_mark(area: &Area, mark: Mark, at: (i32, i32), colour: RGBColor) -> Result<(), DrawError> {
    let filled = colour.filled();
    match mark {
        Mark::Spot => area.draw(&Circle::new(at, px(1), filled)),
        Mark::Dot => area.draw(&Circle::new(at, px(3), filled)),
        Mark::Disc => area.draw(&Circle::new(at, px(5), filled)),
        Mark::Triangle => area.draw(&TriangleMarker::new(at, px(6), filled)),
    }?;
    Ok(())
}

/// Names the peaks that the plot holds, each only where it covers none before it.
fn draw_peaks(area: &Area, chart: &Plot, panel: &Panel) -> Result<(), DrawError> {
    let mut taken = Vec::<((i32, i32), i32)>::new();
    for (at, name) in &panel.peaks {
        let (x, y) = spot(area, chart, panel, *at);
        // estimated from the number of letters: the true font is the viewer's
        let half = (px(LETTER) as usize * name.chars().count() / 2) as i32;
        let covers = |((x_known, y_known), known): &((i32, i32), i32)| {
            (x_known - x).abs() < known + half && (y_known - y).abs() < px(15) as i32
        };
        let is_inside = panel.x.holds(at.0) && panel.y.holds(at.1);
        if !is_inside || taken.len() == MOST_PEAKS || taken.iter().any(covers) {
            continue;
        }
        let style = font(12).pos(Pos::new(HPos::Center, VPos::Bottom));
        area.draw(&Circle::new((x, y), px(2), INK.filled()))?;
        area.draw(&Text::new(name.as_str(), (x, y - px(5) as i32), style))?;
        taken.push(((x, y), half));
    }
    Ok(())
}

/// A map of the figure, and the colour that holds its place while the figure is drawn.
struct Picture {
    held: RGBColor,
    uri: String,
}

impl Picture {
    /// The map as picture number `index`, whose colour no other part of a figure has.
    fn of(map: &Map, index: usize) -> Self {
        let colours = (0..COLOURS).map(|index| graded(index, COLOURS));
        let palette: Vec<_> = colours
            .map(|RGBColor(red, green, blue)| [red, green, blue])
            .collect();
        Self {
            held: RGBColor(1, 2, 3 + index as u8),
            uri: format!(
                "data:image/png;base64,{}",
                STANDARD.encode(png(map.width, &map.levels, &palette))
            ),
        }
    }
}

/// Puts a picture where a rectangle of its colour was drawn.
fn placed(text: String, picture: &Picture) -> String {
    let RGBColor(red, green, blue) = picture.held;
    let held = format!(" opacity=\"1\" fill=\"#{red:02X}{green:02X}{blue:02X}\" stroke=\"none\"/>");
    let image = format!(
        " preserveAspectRatio=\"none\" image-rendering=\"optimizeSpeed\" href=\"{}\"/>",
        picture.uri
    );
    let Some(end) = text.find(&held) else {
        return text;
    };
    let (before, after) = (&text[..end], &text[end + held.len()..]);
    match before.rfind("<rect") {
        Some(start) => {
            let extent = &before[start + "<rect".len()..];
            format!("{}<image{extent}{image}{after}", &before[..start])
        }
        None => text,
    }
}

/// Width of a figure.
pub(super) const WIDTH: u32 = 900;
/// Height of the title.
const TITLE: u32 = 40;
/// Height of a row of names.
pub(super) const NAMES_ROW: u32 = 22;
/// Width of what stands before a name, and of the gap behind it.
const BESIDE_NAME: u32 = 37;
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
        self.head_height(width) + MARGIN_ABOVE + self.height + self.x.room_below()
    }

    /// Height of what stands above the plot.
    pub(super) fn head_height(&self, width: u32) -> u32 {
        let title = if self.title.is_empty() { 0 } else { NAMES_ROW };
        title + strip(&self.names, width).1
    }
}

/// Bytes that a stored block of zlib holds at most.
const BLOCK: usize = 65_535;

/// PNG of one byte a pixel, row by row from the top, each the number of a colour.
///
/// Source: PNG, ISO/IEC 15948; zlib and deflate, RFC 1950 and 1951, here with stored blocks.
fn png(width: usize, pixels: &[u8], palette: &[[u8; 3]]) -> Vec<u8> {
    let height = pixels.len() / width.max(1);
    let mut header = Vec::new();
    header.extend((width as u32).to_be_bytes());
    header.extend((height as u32).to_be_bytes());
    // eight bits a pixel, colours by number, no filter beyond the per-row byte, not interlaced
    header.extend([8, 3, 0, 0, 0]);
    let mut rows = Vec::with_capacity(pixels.len() + height);
    for row in pixels.chunks(width.max(1)) {
        rows.push(0);
        rows.extend(row);
    }
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut file, b"IHDR", &header);
    chunk(&mut file, b"PLTE", palette.as_flattened());
    chunk(&mut file, b"IDAT", &stored(&rows));
    chunk(&mut file, b"IEND", &[]);
    file
}

fn chunk(file: &mut Vec<u8>, kind: &[u8; 4], content: &[u8]) {
    file.extend((content.len() as u32).to_be_bytes());
    let checked = file.len();
    file.extend(kind);
    file.extend(content);
    let sum = crc32(&file[checked..]);
    file.extend(sum.to_be_bytes());
}

fn stored(bytes: &[u8]) -> Vec<u8> {
    let mut out = vec![0x78, 0x01];
    let last = bytes.len().div_ceil(BLOCK).max(1) - 1;
    for (index, block) in bytes.chunks(BLOCK).enumerate() {
        let length = block.len() as u16;
        out.push(u8::from(index == last));
        out.extend(length.to_le_bytes());
        out.extend((!length).to_le_bytes());
        out.extend(block);
    }
    out.extend(adler32(bytes).to_be_bytes());
    out
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ (0xEDB8_8320 & (sum & 1).wrapping_neg())
        })
    })
}

fn adler32(bytes: &[u8]) -> u32 {
    let (a, b) = bytes.iter().fold((1u32, 0u32), |(a, b), byte| {
        let a = (a + u32::from(*byte)) % 65_521;
        (a, (b + a) % 65_521)
    });
    (b << 16) | a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_the_standards() {
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
        assert_eq!(adler32(b"Wikipedia"), 0x11E6_0398);
    }
}
