//! Lines, circles, arrows and labels of a drawing, mm.

use super::super::figure::{Colour, Curve, GREY, Point};

/// Straight lines of a circle.
const CIRCLE: usize = 40;

/// What is drawn so far, mm.
#[derive(Default)]
pub struct Drawing {
    pub curves: Vec<Curve>,
    pub labels: Vec<(Point, String, Colour)>,
}

impl Drawing {
    pub fn line(&mut self, colour: Colour, points: Vec<Point>) {
        self.curves.push(Curve::line(colour, points));
    }

    pub fn fine(&mut self, colour: Colour, points: Vec<Point>) {
        self.curves.push(Curve {
            fine: true,
            ..Curve::line(colour, points)
        });
    }

    pub fn label(&mut self, at: Point, text: impl Into<String>, colour: Colour) {
        self.labels.push((at, text.into(), colour));
    }

    pub fn rectangle(&mut self, colour: Colour, [left, right]: [f64; 2], [low, high]: [f64; 2]) {
        let (first, third) = ((left, low), (right, high));
        self.line(
            colour,
            vec![first, (right, low), third, (left, high), first],
        );
    }

    pub fn circle(&mut self, colour: Colour, (x, y): Point, radius: f64) {
        let angles = (0..=CIRCLE).map(|k| std::f64::consts::TAU * k as f64 / CIRCLE as f64);
        let points = angles.map(|angle| (x + radius * angle.cos(), y + radius * angle.sin()));
        self.line(colour, points.collect());
    }

    /// An arrow from `from` by `by`.
    pub fn arrow(&mut self, colour: Colour, from: Point, by: Point) {
        let (tip, size) = ((from.0 + by.0, from.1 + by.1), by.0.hypot(by.1));
        let (along, across) = ((by.0 / size, by.1 / size), 0.12 * size);
        let barb = |side: f64| {
            let back = 1.8 * across;
            (
                tip.0 - back * along.0 + side * across * along.1,
                tip.1 - back * along.1 - side * across * along.0,
            )
        };
        self.line(colour, vec![from, tip, barb(1.0), tip, barb(-1.0)]);
    }

    /// Hatching beyond a ring that is fixed to the ground.
    pub fn ground(&mut self, [left, right]: [f64; 2], at: f64, beyond: f64) {
        let step = (right - left) / 6.0;
        for k in 0..=6 {
            let x = left + f64::from(k) * step;
            self.fine(GREY, vec![(x, at), (x + step, at + beyond)]);
        }
    }
}
