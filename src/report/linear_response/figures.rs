//! Bode and polar diagrams of the linear response.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{Reported, place};
use crate::physics::PER_MINUTE;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, broken_at_turns, distinct};
use crate::report::terminal::{MICRO, digits};

/// Height of a plot, px.
const HEIGHT: u32 = 240;

impl Reported<'_> {
    fn names(&self) -> Vec<Name> {
        Name::each(self.question.at.iter().map(place))
    }

    /// A curve for each pickup through points made of values and motions.
    fn curves(&self, point: impl Fn(f64, Complex<f64>) -> Point) -> Vec<Curve> {
        let pickups = 0..self.question.at.len();
        let curve = |index: usize| {
            let all = self.response.drawn.iter();
            let points =
                all.filter_map(|(value, motions)| Some(point(*value, motions.as_ref()?[index])));
            Curve::line(distinct(index), points.collect())
        };
        pickups.map(curve).collect()
    }

    fn axis(&self) -> (Axis, f64) {
        let (label, factor) = match self.question.by {
            Some(_) => (("frequency", "Hz"), 1.0 / TAU),
            None => (("speed", "1/min"), PER_MINUTE),
        };
        let [from, to] = self.question.range.map(|end| factor * end);
        (Axis::over(label, from..to), factor)
    }

    /// Amplitude and phase over speed or frequency.
    pub fn bode(&self, title: &str) -> Figure {
        let (axis, factor) = self.axis();
        let curves = self.curves(|value, motion| (factor * value, MICRO * motion.norm()));
        let heights: Vec<f64> = curves
            .iter()
            .flat_map(|own| &own.points)
            .map(|own| own.1)
            .collect();
        let amplitudes = Panel {
            curves,
            ..Panel::new(
                axis.clone(),
                Axis::logarithmic(("amplitude", &self.unit("µ")), heights),
                HEIGHT,
            )
        };
        let mut phases = self.curves(|value, motion| (factor * value, motion.arg().to_degrees()));
        for curve in &mut phases {
            curve.points = broken_at_turns(&curve.points);
        }
        let phases = Panel {
            curves: phases,
            ..Panel::new(axis, Axis::over(("phase", "deg"), -180.0..180.0), HEIGHT)
        };
        Figure::new("bode", title, 1, vec![amplitudes, phases]).with_names(self.names())
    }

    /// Every motion as a point of the plane, with the resonances named.
    pub fn polar(&self, title: &str) -> Figure {
        let curves = self.curves(|_, motion| (MICRO * motion.re, MICRO * motion.im));
        let points = curves.iter().flat_map(|own| &own.points);
        let most = points.map(|own| own.0.hypot(own.1)).fold(0.0, f64::max);
        let most = if most > 0.0 { 1.1 * most } else { 1.0 };
        let label = |part: &str| (format!("{part} part"), self.unit("µ"));
        let (axis, factor) = self.axis();
        let peaks = self.response.resonances.iter().filter_map(|own| {
            let nearest = self
                .response
                .drawn
                .iter()
                .min_by(|a, b| (a.0 - own.peak).abs().total_cmp(&(b.0 - own.peak).abs()))?;
            let motion = nearest.1.as_ref()?[own.pickup];
            let place = (MICRO * motion.re, MICRO * motion.im);
            Some((
                place,
                format!("{} {}", digits(factor * own.peak), axis.label.unit),
            ))
        });
        let panel = Panel {
            peaks: peaks.collect(),
            curves,
            aspect: Some(1.0),
            ..Panel::new(
                Axis::over(label("real"), -most..most),
                Axis::over(label("imaginary"), -most..most),
                0,
            )
        };
        Figure::new("polar", title, 1, vec![panel]).with_names(self.names())
    }
}
