//! A figure as SVG.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::colour::shade;
use super::layout::{Place, StripName, inside, layout, strip, strip_height};
use super::text::{LINE, SIZE, escaped, shortened, width, wrapped};
use super::{Axis, Colour, Curve, Figure, Map, Mark, Point};

/// Width of a figure: 180 mm, in CSS pixels of 1/96 inch.
pub(super) const PAGE: f64 = 680.0;

/// Text and axes.
const INK: &str = "#282828";
/// Grid.
const GRID: &str = "#e1e1e1";
/// Size of the title, px.
const TITLE: f64 = 15.0;

/// A figure in a width in px.
pub(super) fn drawn(figure: &Figure, width: f64) -> String {
    let mut pen = Pen::default();
    let mut top = 6.0;
    for line in wrapped(&figure.title, TITLE, width - LINE) {
        top += 18.0;
        pen.text(&line, (0.5 * width, top), TITLE, "middle", INK);
    }
    top += 8.0;
    let names = strip(&figure.names, width);
    pen.names(&names, (0.0, top));
    let (places, height) = layout(figure, width, top + strip_height(&names));
    for place in &places {
        pen.panel(place);
    }
    let height = (height + 4.0).ceil();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
        pen.0
    )
}

/// What is drawn so far.
#[derive(Default)]
struct Pen(String);

impl Pen {
    fn put(&mut self, element: std::fmt::Arguments<'_>) {
        // writing to a text does not fail
        let _ = writeln!(self.0, "{element}");
    }

    fn line(&mut self, points: impl IntoIterator<Item = Point>, colour: &str, width: f64) {
        let path = path(points);
        if !path.is_empty() {
            self.put(format_args!(
                "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
                 stroke-linejoin=\"round\"/>"
            ));
        }
    }

    fn rectangle(&mut self, (x, y): Point, [width, height]: [f64; 2], colour: &str) {
        let [x, y, width, height] = [x, y, width, height].map(short);
        self.put(format_args!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{colour}\"/>"
        ));
    }

    fn circle(&mut self, (x, y): Point, radius: f64, colour: &str) {
        let [x, y] = [x, y].map(short);
        self.put(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{colour}\"/>"
        ));
    }

    fn text(&mut self, text: &str, (x, y): Point, size: f64, anchor: &str, colour: &str) {
        if text.trim().is_empty() {
            return;
        }
        let ([x, y], text) = ([x, y].map(short), escaped(text));
        self.put(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{text}</text>"
        ));
    }

    fn picture(&mut self, map: &Map, (x, y): Point, [width, height]: [f64; 2]) {
        let [x, y, width, height] = [x, y, width, height].map(short);
        if let Some(png) = map.png() {
            let png = STANDARD.encode(png);
            self.put(format_args!(
                "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
                 image-rendering=\"optimizeSpeed\" href=\"data:image/png;base64,{png}\"/>"
            ));
        }
    }

    /// Names, each behind a stroke of its colour.
    fn names(&mut self, names: &[StripName], (left, top): Point) {
        for name in names {
            let (x, y) = (left + 14.0 + name.left, top + 12.0 + name.top);
            let colour = name.colour.hex();
            let width = if name.mark.is_some() { 1.4 } else { 3.0 };
            self.line([(x, y), (x + 18.0, y)], &colour, width);
            if let Some(mark) = name.mark {
                self.mark(mark, (x + 9.0, y), &colour);
            }
            self.text(&name.text, (x + 23.0, y + 4.0), SIZE, "start", INK);
        }
    }

    fn panel(&mut self, place: &Place<'_>) {
        let panel = place.panel;
        let mut head = place.head;
        for line in &place.title {
            head += LINE;
            self.middle(line, place, head, SIZE + 1.0);
        }
        self.names(&place.names, (place.column[0], head + 2.0));
        self.axes(place);
        let [left, top, width, height] =
            [place.left, place.top, place.width, place.height].map(short);
        // an inner picture shows nothing beyond its edges
        self.put(format_args!(
            "<svg x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" viewBox=\"{left} {top} {width} {height}\">"
        ));
        if let Some(map) = &panel.map {
            self.picture(map, (place.left, place.top), [place.width, place.height]);
        }
        for cell in &panel.cells {
            let [(x0, y0), (x1, y1)] = cell.corners.map(|corner| place.at(corner));
            let size = [(x1 - x0).abs() + 0.3, (y1 - y0).abs() + 0.3];
            self.rectangle((x0.min(x1), y0.min(y1)), size, &cell.colour.hex());
        }
        for curve in &panel.curves {
            self.curve(place, curve);
        }
        for label in place.labels() {
            let colour = label.colour.map_or(INK.to_owned(), Colour::hex);
            let at = (label.x, label.y);
            self.text(&label.text, at, SIZE - 1.0, "middle", &colour);
        }
        for (at, name) in place.peaks() {
            self.circle(at, 2.0, INK);
            self.text(&name.text, (name.x, name.y), SIZE, "middle", INK);
        }
        self.put(format_args!("</svg>"));
        self.bar(place);
    }

    /// A text about the middle of a plot, within its column.
    fn middle(&mut self, text: &str, place: &Place<'_>, y: f64, size: f64) {
        let half = 0.5 * width(text, size);
        let x = inside(place.left + 0.5 * place.width, half, place.column);
        self.text(text, (x, y), size, "middle", INK);
    }

    /// The grid, the numbers and the names of both axes.
    fn axes(&mut self, place: &Place<'_>) {
        let (right, bottom) = (place.left + place.width, place.top + place.height);
        for (x, tick) in place.ticks_below() {
            self.line([(x, place.top), (x, bottom)], GRID, 1.0);
            self.text(&tick.text, (tick.x, tick.y), SIZE, "middle", INK);
        }
        for (y, text) in place.ticks_left() {
            self.line([(place.left, y), (right, y)], GRID, 1.0);
            self.text(&text, (place.left - 6.0, y + 4.0), SIZE, "end", INK);
        }
        let corner = (place.left, bottom);
        self.line([(place.left, place.top), corner, (right, bottom)], INK, 1.0);
        let [from, to] = place.column;
        if place.names_x {
            let name = shortened(&place.panel.x.label.to_string(), SIZE, to - from - 4.0);
            self.middle(&name, place, bottom + 2.0 * LINE + 2.0, SIZE);
        }
        let bar = place.panel.bar.as_ref();
        let most = bar.map_or(to - from - 6.0, |_| 0.5 * (to - from) - 10.0);
        let y = place.top - 10.0;
        let name = |axis: &Axis| shortened(&axis.label.to_string(), SIZE, most);
        self.text(&name(&place.panel.y), (from + 6.0, y), SIZE, "start", INK);
        if let Some(bar) = bar {
            self.text(&name(bar), (to - 4.0, y), SIZE, "end", INK);
        }
    }

    /// All colours from below to above beside a plot.
    fn bar(&mut self, place: &Place<'_>) {
        let Some(bar) = &place.panel.bar else { return };
        let colours = Map {
            width: 1,
            levels: (0..=u8::MAX).rev().collect(),
        };
        let left = place.left + place.width + 10.0;
        self.picture(&colours, (left, place.top), [12.0, place.height]);
        for (y, text) in place.ticks_up(bar, bar.ends) {
            self.text(&text, (left + 16.0, y + 4.0), SIZE - 1.0, "start", INK);
        }
    }

    fn curve(&mut self, place: &Place<'_>, curve: &Curve) {
        let (colour, beside) = (curve.colour.hex(), f64::from(curve.beside));
        let at = |point: Point| {
            let (x, y) = place.at(point);
            (x + beside, y)
        };
        let edge = |side: usize| {
            let both = curve.points.iter().zip(&curve.band);
            let edge = both.map(|(point, band)| at((point.0, band[side])));
            edge.collect::<Vec<Point>>()
        };
        let [low, high] = [edge(0), edge(1)];
        for stretch in stretches(&low) {
            let back = low[stretch.clone()].iter().rev();
            let path = path(high[stretch].iter().chain(back).copied());
            self.put(format_args!(
                "<path d=\"{path}Z\" fill=\"{colour}\" fill-opacity=\"0.35\"/>"
            ));
        }
        let points: Vec<Point> = curve.points.iter().copied().map(at).collect();
        let width = if curve.fine { 0.8 } else { 1.4 };
        self.line(visible(&points, place), &colour, width);
        // of marks on one spot one is drawn: the file stays small
        let mut taken = std::collections::BTreeSet::new();
        for mark in &curve.marks {
            let (x, y) = at(*mark);
            if taken.insert((x.round() as i64, y.round() as i64)) {
                self.mark(curve.mark, (x, y), &colour);
            }
        }
    }

    fn mark(&mut self, mark: Mark, (x, y): Point, colour: &str) {
        match mark {
            Mark::Spot => self.rectangle((x - 1.0, y - 1.0), [2.0; 2], colour),
            Mark::Dot => self.circle((x, y), 2.6, colour),
            Mark::Disc => self.circle((x, y), 5.0, colour),
            Mark::Triangle => {
                let path = path([(x - 5.0, y + 4.0), (x + 5.0, y + 4.0), (x, y - 5.0)]);
                self.put(format_args!("<path d=\"{path}Z\" fill=\"{colour}\"/>"));
            }
        }
    }
}

/// A line without the points beyond a plot that no line joins to one within.
fn visible(points: &[Point], place: &Place<'_>) -> Vec<Point> {
    let beyond = |point: &Point| point.0 < place.left || point.0 > place.left + place.width;
    let is_near = |(index, _): &(usize, &Point)| {
        let around = &points[index.saturating_sub(1)..(index + 2).min(points.len())];
        !around.iter().all(beyond)
    };
    let near = points.iter().enumerate().filter(is_near);
    near.map(|(_, point)| *point).collect()
}

/// Ranges of points that are numbers, of more than one.
fn stretches(points: &[Point]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut start = 0;
    for stretch in points.chunk_by(|a, b| a.1.is_nan() == b.1.is_nan()) {
        let end = start + stretch.len();
        if !stretch[0].1.is_nan() && stretch.len() > 1 {
            found.push(start..end);
        }
        start = end;
    }
    found
}

/// The commands of a line through points, which is broken where one is not a number; points that are drawn on one spot
/// are written once.
fn path(points: impl IntoIterator<Item = Point>) -> String {
    let (mut path, mut command, mut before) = (String::new(), 'M', String::new());
    for (x, y) in points {
        if !x.is_finite() || !y.is_finite() {
            command = 'M';
            continue;
        }
        let place = format!("{} {}", short(x), short(y));
        if command == 'L' && place == before {
            continue;
        }
        path.push(command);
        path.push_str(&place);
        (command, before) = ('L', place);
    }
    path
}

/// A length to a tenth of a pixel.
fn short(length: f64) -> f64 {
    // no minus sign before zero
    (10.0 * length).round() / 10.0 + 0.0
}

impl Map {
    /// The map as PNG; none of one without levels.
    fn png(&self) -> Option<Vec<u8>> {
        let palette = (0..=u8::MAX).flat_map(|level| shade(f32::from(level) / 255.0));
        let height = self.levels.len().checked_div(self.width)?;
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(palette.collect::<Vec<u8>>());
        let mut writer = encoder.write_header().ok()?;
        writer.write_image_data(&self.levels).ok()?;
        writer.finish().ok()?;
        Some(file)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Cell, Name, Panel, distinct, graded};
    use super::*;
    use crate::report::scene::scene_figure;
    use crate::scenario::Scenario;

    /// Widths of a column and of a page of a journal: 88 and 180 mm.
    const WIDTHS: [f64; 2] = [333.0, PAGE];

    /// Left, top, right and bottom of all texts, each with itself.
    fn boxes(svg: &str) -> Vec<([f64; 4], String)> {
        let texts = svg.split("<text ").skip(1);
        let placed = texts.map(|element| {
            let value = |name: &str| {
                let (_, rest) = element
                    .split_once(&format!("{name}=\""))
                    .expect("an attribute");
                rest.split('"').next().expect("a value").to_owned()
            };
            let number = |name: &str| -> f64 { value(name).parse().expect("a number") };
            let (_, rest) = element.split_once('>').expect("an end");
            let words = rest.split("</text>").next().expect("a text");
            let signs = [("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")];
            let plain = |words: String, (sign, letter)| words.replace(sign, letter);
            let words = signs.into_iter().fold(words.to_owned(), plain);
            let (x, y, size) = (number("x"), number("y"), number("font-size"));
            let wide = super::width(&words, size);
            let left = match value("text-anchor").as_str() {
                "middle" => x - 0.5 * wide,
                "end" => x - wide,
                _ => x,
            };
            ([left, y - 0.7 * size, left + wide, y], words)
        });
        placed.collect()
    }

    /// No text leaves the paper, and none covers another.
    fn is_well_set(figure: &Figure) {
        for width in WIDTHS {
            let svg = drawn(figure, width);
            let (_, height) = svg.split_once("height=\"").expect("a height");
            let height: f64 = height
                .split('"')
                .next()
                .and_then(|text| text.parse().ok())
                .expect("a height");
            let texts = boxes(&svg);
            for (index, ([left, top, right, bottom], words)) in texts.iter().enumerate() {
                let on_paper = *left >= 0.0 && *top >= 0.0 && *right <= width && *bottom <= height;
                assert!(on_paper, "{words:?} leaves {width} px: {left} to {right}");
                for ([l, t, r, b], other) in &texts[..index] {
                    let apart = right <= l || r <= left || bottom <= t || b <= top;
                    assert!(apart, "{words:?} covers {other:?} at {width} px");
                }
            }
        }
    }

    #[test]
    fn texts_stay_on_the_paper_and_apart() {
        let wave = |scale: f64| {
            (0..400)
                .map(|k| (f64::from(k) * 250.0, scale * f64::from(k).sin()))
                .collect()
        };
        let curves = vec![
            Curve::line(distinct(0), wave(2.3e8)),
            Curve::line(distinct(1), wave(1e8)),
        ];
        let large = Panel::holding(
            Axis::over(("frequency of the outer race", "Hz"), 0.0..99_750.0),
            ("stiffness K_yy of the first bearing", "N/m"),
            120,
            curves,
        );
        let crowded = Panel {
            title: "a title that says much more than a line of a narrow figure can ever hold"
                .to_owned(),
            peaks: (0..30)
                .map(|k| {
                    (
                        (3e3 * f64::from(k), 1e7 * f64::from(30 - k)),
                        format!("{k}× ball pass, outer race"),
                    )
                })
                .collect(),
            labels: (0..12)
                .map(|k| {
                    (
                        (95e3, 1e7 * f64::from(k)),
                        format!("load {k}, 1000 N"),
                        distinct(2),
                    )
                })
                .collect(),
            ..large.clone()
        };
        let rows = ["contact by Jones with film and rolling cage", "linear"];
        let cells = (0..2).map(|k| Cell {
            corners: [(0.0, f64::from(k)), (0.4, f64::from(k) + 1.0)],
            colour: graded(1, 3),
            value: 0.4,
            run: None,
        });
        let named = Panel {
            cells: cells.collect(),
            ..Panel::new(
                Axis::over("rank correlation", -1.05..1.05),
                Axis::names(rows.map(str::to_owned)),
                52,
            )
        };
        let mapped = Panel {
            map: Some(Map {
                width: 2,
                levels: vec![0, 80, 160, 255],
            }),
            bar: Some(Axis::of_logarithms(
                ("amplitude of the displacement", "µm"),
                -3.2..0.8,
            )),
            ..Panel::new(
                Axis::over(("time", "s"), 0.0..0.0003),
                Axis::logarithmic(("frequency", "Hz"), [3.0, 40.0]),
                200,
            )
        };
        let names = Name::each([
            "x",
            "a name that is longer than all others and than a narrow figure is wide",
        ]);
        let panels = vec![large.clone(), large, crowded, named.clone(), named, mapped];
        for columns in 1..=4 {
            let figure = Figure::new(
                "hard",
                "A long title of a scenario & its <shaft> with two words more than fit",
                columns,
                panels.clone(),
            );
            is_well_set(&figure.with_names(names.clone()));
        }
    }

    #[test]
    fn the_texts_of_scenes_stay_apart() {
        for text in [
            include_str!("../../../scenarios/conveyor-shaft-6213.toml"),
            include_str!("../../../scenarios/flexible-spindle-7205c.toml"),
            include_str!("../../../scenarios/back-to-back-7205c.toml"),
        ] {
            let scenario = Scenario::from_toml(text).expect("a shipped scenario");
            is_well_set(&scene_figure(&scenario.title, &scenario.question.rotor));
        }
    }

    /// A unit is as long upwards as it is across, at any width.
    #[test]
    fn a_scene_is_to_scale() {
        let text = include_str!("../../../scenarios/fan-6205.toml");
        let scenario = Scenario::from_toml(text).expect("a shipped scenario");
        let figure = scene_figure("", &scenario.question.rotor);
        for width in WIDTHS {
            let (places, _) = layout(&figure, width, 0.0);
            let place = &places[0];
            let across = place.width / (place.x[1] - place.x[0]);
            let upwards = place.height / (place.y[1] - place.y[0]);
            assert!((across / upwards - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn what_is_absent_has_no_name() {
        let panel = Panel::holding(
            Axis::over("", 0.0..1.0),
            "",
            100,
            vec![Curve::line(distinct(1), vec![(0.0, 1.0)])],
        );
        let figure =
            Figure::new("", "", 1, vec![panel]).with_names(Name::each(["absent", "present"]));
        let names: Vec<_> = figure.names.iter().map(|name| name.text.as_str()).collect();
        assert_eq!(names, ["present"]);
    }

    /// What lies beyond the plot is left out but for the point that the line comes from or goes to.
    #[test]
    fn a_line_ends_beyond_the_plot() {
        let points: Vec<Point> = (0..10).map(|k| (f64::from(k), 0.5)).collect();
        let panel = Panel::new(Axis::over("", 2.5..6.5), Axis::over("", 0.0..1.0), 100);
        let figure = Figure::new("", "", 1, vec![panel]);
        let (places, _) = layout(&figure, PAGE, 0.0);
        let drawn: Vec<Point> = points.iter().map(|point| places[0].at(*point)).collect();
        assert_eq!(visible(&drawn, &places[0]), drawn[2..8]);
    }
}
