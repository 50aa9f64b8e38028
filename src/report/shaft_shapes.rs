//! Figures of a shaft that bends: its static deflection, and its modes.

use nalgebra::Complex;

use super::figure::{Axis, Curve, Figure, GREY, Name, Panel, distinct};
use super::terminal::{MICRO, MILLI};
use crate::quasi_static::StaticQuestion;
use crate::rotor::{Mode, Rotor, RotorDefinition, ShaftShape, Whirl};

/// Height of a plot, px.
const HEIGHT: u32 = 160;
/// Modes that are drawn, lowest first.
const MOST_MODES: usize = 8;

/// A shaft that bends as its loads bend it; none where something else displaces it.
pub(super) fn deflection(title: &str, question: &StaticQuestion) -> Option<Figure> {
    let loaded = question.displacement.iter().all(Option::is_none) && !question.unbalance;
    question.rotor.flexible.as_ref().filter(|_| loaded)?;
    let shape = Rotor::assemble(&question.rotor).ok()?.static_shape()?;
    Some(static_shape(title, &shape))
}

/// The modes of a shaft that bends at a speed in rad/s.
pub(super) fn shapes_at(title: &str, rotor: &RotorDefinition, speed: f64) -> Option<Figure> {
    rotor.flexible.as_ref()?;
    let rotor = Rotor::assemble(&rotor.at_constant_speed(speed)).ok()?;
    let modes = rotor.modes().into_iter();
    let shapes = modes.filter_map(|mode| Some((mode.clone(), rotor.mode_shape(&mode)?)));
    let shapes: Vec<_> = shapes.collect();
    (!shapes.is_empty()).then(|| mode_shapes(title, &shapes))
}

/// The shaft at its static equilibrium, and undeformed.
fn static_shape(title: &str, shape: &ShaftShape<f64>) -> Figure {
    let panels = ["x", "y"].iter().zip(&shape.deflections).enumerate();
    let panels = panels.map(|(index, (name, deflections))| {
        let deflected = deflections.iter().map(|own| own * MICRO);
        let curves = vec![undeformed(shape), along(shape, deflected, index)];
        let deflection = (format!("deflection along {name}"), "µm");
        Panel::holding(positions(shape), deflection, HEIGHT, curves)
    });
    let names = [Name::new("undeformed", GREY)];
    Figure::new("deflection", title, 1, panels.collect()).with_names(names)
}

/// The lowest modes of bending at a speed, each in the moment when it deflects most and a quarter of a period later.
fn mode_shapes(title: &str, modes: &[(Mode, ShaftShape<Complex<f64>>)]) -> Figure {
    let lateral = modes
        .iter()
        .filter(|(mode, _)| mode.whirl() != Whirl::Axial);
    let panels = lateral.take(MOST_MODES).map(|(mode, shape)| {
        let (turn, size) = largest(shape);
        let mut curves = vec![undeformed(shape)];
        for (axis, deflections) in shape.deflections.iter().enumerate() {
            let at = |later: Complex<f64>| {
                let moment = deflections.iter().map(|own| (own * turn * later).re / size);
                along(shape, moment, axis)
            };
            curves.push(at(Complex::ONE));
            curves.push(Curve {
                fine: true,
                ..at(Complex::I)
            });
        }
        let (frequency, whirl) = (mode.damped_frequency(), mode.whirl());
        let damping = mode.damping_ratio();
        Panel {
            title: format!("{frequency:.2} Hz, {whirl}, damping ratio {damping:.4}"),
            ..Panel::holding(positions(shape), "shape", HEIGHT, curves)
        }
    });
    let names = Name::each(["x", "y"]).into_iter();
    let names = names.chain([Name::new("thin: a quarter of a period later", GREY)]);
    Figure::new("mode_shapes", title, 2, panels.collect()).with_names(names)
}

/// The factor that makes the largest deflection real, and its size.
fn largest(shape: &ShaftShape<Complex<f64>>) -> (Complex<f64>, f64) {
    let all = shape.deflections.iter().flatten();
    let most = all.copied().max_by(|a, b| a.norm().total_cmp(&b.norm()));
    let most = most.filter(|most| most.norm() > 0.0);
    let most = most.unwrap_or(Complex::ONE);
    (most.conj() / most.norm(), most.norm())
}

fn positions<T>(shape: &ShaftShape<T>) -> Axis {
    let range = [shape.positions.first(), shape.positions.last()];
    let [first, last] = range.map(|end| MILLI * end.copied().unwrap_or(0.0));
    Axis::over(("position", "mm"), first..last)
}

fn along<T>(shape: &ShaftShape<T>, deflections: impl Iterator<Item = f64>, colour: usize) -> Curve {
    let positions = shape.positions.iter().map(|position| MILLI * position);
    Curve::line(distinct(colour), positions.zip(deflections).collect())
}

fn undeformed<T>(shape: &ShaftShape<T>) -> Curve {
    let ends = [shape.positions.first(), shape.positions.last()];
    let ends = ends.into_iter().flatten().map(|end| (MILLI * end, 0.0));
    Curve::line(GREY, ends.collect())
}
