//! The figure of defects: each drawn from the side.

use crate::bearing::{Defect, Geometry, SideView, Surface};
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use crate::simulate::Model;

/// Defects that are drawn, the first ones.
const MOST_DRAWN: usize = 4;
/// Width of a drawing in heights of it.
const SIDE_ASPECT: f64 = 3.2;
/// Least width of a drawing in lengths of its defect.
const WIDTH: f64 = 1.8;
/// Room below the surface and above it, in depths, of those deeper than long in lengths.
const BELOW: f64 = 1.25;
const ABOVE: f64 = 0.6;
/// Points of a curve of a drawing.
const POINTS: u32 = 600;

/// The figure of the defects of a model; none where bearings have none.
pub(in crate::report) fn figure(title: &str, model: &Model) -> Option<Figure> {
    let bearings = model.rotor.bearings.iter().enumerate();
    let defects = bearings.flat_map(|(number, own)| {
        let defects = own.imperfections.defects.iter();
        defects.map(move |defect| (number, &own.bearing.geometry, defect))
    });
    let drawings = defects.take(MOST_DRAWN);
    let drawings = drawings.map(|(number, geometry, defect)| side_view(number, geometry, defect));
    let panels: Vec<_> = drawings.collect();
    let title = format!("{title}: defects");
    (!panels.is_empty()).then(|| Figure::new("defects", &title, 1, panels))
}

/// A defect with the ball in its middle, where it strikes the far edge or rests on the floor.
fn side_view(number: usize, geometry: &Geometry, defect: &Defect) -> Panel {
    let view = defect.side_view(geometry);
    let drawing = Drawing::new(defect, view);
    let (depth, micro) = (1e3 * defect.depth, 1e6 * view.drop);
    let heights = match drawing.exaggeration {
        1.0 => "to scale".to_owned(),
        factor => format!("heights {factor:.1} times as large"),
    };
    let element = geometry.element();
    let title = format!(
        "bearing {}, {}: {:.4} mm long, {depth:.4} mm deep, the {element} drops by {micro:.2} µm; {heights}",
        number + 1,
        defect.on,
        1e3 * defect.length,
    );
    let [surface, mate] = match defect.on {
        Surface::Ball(_) => [element, "inner race"],
        Surface::Inner | Surface::Outer => ["race", element],
    };
    let half = 1e3 * drawing.half_width;
    let heights = [-BELOW * drawing.deep, ABOVE * drawing.deep].map(|height| 1e3 * height);
    let along = Axis::over(("along the surface", "mm"), -half..half);
    let height = Axis::over(("height", "mm"), heights[0]..heights[1]);
    Panel {
        title,
        names: Name::each([surface, mate]),
        curves: vec![
            Curve::line(distinct(0), drawing.surface()),
            Curve::line(distinct(1), drawing.mate()),
        ],
        aspect: Some(drawing.exaggeration),
        ..Panel::new(along, height, 0)
    }
}

/// Lengths of a drawing, m.
struct Drawing<'a> {
    defect: &'a Defect,
    view: SideView,
    half_width: f64,
    /// Depth that the heights are drawn for.
    deep: f64,
    /// By how much heights are drawn larger than lengths.
    exaggeration: f64,
}

impl<'a> Drawing<'a> {
    fn new(defect: &'a Defect, view: SideView) -> Self {
        let deep = defect.depth.min(defect.length).max(view.drop);
        let to_scale = 0.5 * (BELOW + ABOVE) * deep * SIDE_ASPECT;
        let half_width = to_scale.max(0.5 * WIDTH * defect.length);
        Self {
            defect,
            view,
            half_width,
            deep,
            exaggeration: half_width / to_scale,
        }
    }

    /// Height of the sound surface.
    fn sound(&self, along: f64) -> Option<f64> {
        let rise = sagitta(self.view.race_radius, along)?;
        Some(if self.view.convex { -rise } else { rise })
    }

    /// The surface with the slot in it.
    fn surface(&self) -> Vec<Point> {
        let half = 0.5 * self.defect.length;
        let edges = [-half, half];
        let mut points: Vec<Point> = Vec::new();
        let mut add = |along: f64, deep: bool| {
            let drop = if deep { self.defect.depth } else { 0.0 };
            points.extend(self.sound(along).map(|height| (along, height - drop)));
        };
        for along in self.places() {
            let inside = along.abs() < half;
            add(along, inside);
            let next = along + self.step();
            for edge in edges
                .into_iter()
                .filter(|edge| (along..next).contains(edge))
            {
                add(edge, edge > 0.0);
                add(edge, edge < 0.0);
            }
        }
        self.drawn(points)
    }

    /// What rolls over it, in the middle.
    fn mate(&self) -> Vec<Point> {
        let points = self.places().filter_map(|along| {
            let rise = sagitta(self.view.ball_radius, along)?;
            Some((along, rise - self.view.drop))
        });
        self.drawn(points.collect())
    }

    fn step(&self) -> f64 {
        2.0 * self.half_width / f64::from(POINTS)
    }

    fn places(&self) -> impl Iterator<Item = f64> + '_ {
        (0..=POINTS).map(|point| f64::from(point) * self.step() - self.half_width)
    }

    /// Points in mm within the heights that are drawn.
    fn drawn(&self, points: Vec<Point>) -> Vec<Point> {
        let heights = -BELOW * self.deep..=ABOVE * self.deep;
        let inside = points.into_iter().filter(|(_, y)| heights.contains(y));
        inside.map(|(x, y)| (1e3 * x, 1e3 * y)).collect()
    }
}

/// How far a circle has risen above its lowest point; none beyond its radius.
fn sagitta(radius: f64, along: f64) -> Option<f64> {
    let square = radius * radius - along * along;
    (square >= 0.0).then(|| along * along / (radius + square.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::DefectProfile;

    /// D 7.94, d_m 39.04 mm: the ball rests on both edges of the slot, far above its floor.
    #[test]
    fn a_ball_is_drawn_on_the_edges_of_its_slot() {
        let defect = Defect {
            on: Surface::Outer,
            angle: 0.0,
            length: 0.5334e-3,
            depth: 0.2794e-3,
            profile: DefectProfile::Edges,
        };
        let view = SideView {
            ball_radius: 3.97e-3,
            race_radius: 23.49e-3,
            convex: false,
            drop: 7.454e-6,
        };
        let drawing = Drawing::new(&defect, view);
        assert_eq!(drawing.exaggeration, 1.0);
        let surface = drawing.surface();
        let floor = surface
            .iter()
            .fold(f64::INFINITY, |least, point| least.min(point.1));
        assert!((floor + 0.2794).abs() < 1e-3, "{floor}");
        // at the edges the ball and the race meet
        let edge = 0.5 * defect.length;
        let ball = sagitta(view.ball_radius, edge).expect("inside") - view.drop;
        let race = drawing.sound(edge).expect("inside");
        assert!((ball - race).abs() < 1e-8, "{ball:e} {race:e}");
    }
}
