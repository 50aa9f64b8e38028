//! Loads: constant ones by arrows, others by their names.

use super::super::figure::distinct;
use super::super::terminal::MILLI;
use super::drawing::Drawing;
use super::{LOADS, Scale};
use crate::numerics::digits::to_digits;
use crate::rotor::{Load, LoadKind, RotorDefinition};

impl Drawing {
    /// Loads at their positions: constant ones with their direction, axial parts at the end of the shaft that they pull at,
    /// varying ones from above.
    pub fn loads(&mut self, rotor: &RotorDefinition, scale: &Scale) {
        let colour = distinct(LOADS);
        let [left, right] = scale.ends;
        // a coupling has several loads in one
        let mut shown: Vec<(f64, String)> = Vec::new();
        for load in &rotor.loads {
            let name = name_of(load);
            let index = shown.len();
            let named = (load.position, name.clone());
            if shown.contains(&named) {
                continue;
            }
            shown.push(named);
            let at = MILLI * load.position;
            let from = (1.35 + 0.3 * index as f64).min(1.95) * scale.outer;
            let constant = load.as_constant().copied();
            let [x, y, z, ..] = constant.unwrap_or([0.0, -1.0, 0.0, 0.0, 0.0]);
            let mut text_at = (at, from);
            if z != 0.0 {
                let end = if z > 0.0 { right } else { left };
                self.arrow(colour, (end, 0.0), (scale.outer * z.signum(), 0.0));
                if x == 0.0 && y == 0.0 {
                    text_at = (end, 0.35 * scale.shaft);
                }
            }
            if x != 0.0 {
                // across the picture
                self.circle(colour, (at, 0.0), 0.15 * scale.shaft);
            }
            if y != 0.0 {
                text_at = (at, -y.signum() * from);
                let by = (0.0, y.signum() * (from - scale.shaft));
                self.arrow(colour, text_at, by);
            }
            self.label(text_at, name, colour);
        }
    }
}

/// What a load is called; of a constant one its components that are not zero.
fn name_of(load: &Load) -> String {
    let name = match &load.kind {
        LoadKind::Constant(parts) => {
            let axes = [
                ("x", "N"),
                ("y", "N"),
                ("z", "N"),
                ("Mx", "N m"),
                ("My", "N m"),
            ];
            let given = axes.into_iter().zip(parts);
            let texts: Vec<_> = given
                .filter(|(_, part)| **part != 0.0)
                .map(|((axis, unit), part)| format!("{axis} {} {unit}", to_digits(*part, 4)))
                .collect();
            return texts.join(", ");
        }
        LoadKind::Harmonic(_) => "harmonic load",
        LoadKind::Shock(_) => "shock",
        LoadKind::RandomShocks(_) => "random shocks",
        LoadKind::Sprocket(_) => "chain on a sprocket",
        LoadKind::Noise(_) => "noise",
        LoadKind::Series(_) => "series of forces",
        LoadKind::Base(_) => "acceleration of the housing",
    };
    name.to_owned()
}
