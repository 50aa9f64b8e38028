//! The linear response: tables, Bode and polar diagrams, resonances.

mod figures;

use std::f64::consts::TAU;

use nalgebra::Complex;
use serde_json::{Value, json};

use crate::numerics::digits::to_digits;
use crate::numerics::distinct::each_once;
use crate::physics::PER_MINUTE;
use crate::report::terminal::{Lines, MILLI};
use crate::report::{FileSet, Findings};
use crate::rotor::{FREEDOM_NAMES, Pickup};
use crate::scenario::Scenario;
use crate::study::linear_response::{LinearResponse, LinearResponseQuestion, Resonance};
use crate::table::{Column, Table};

/// The response with its resonances; `operating` is the highest speed of the scenario, rad/s.
pub fn linear_response_findings(
    scenario: &Scenario,
    question: &LinearResponseQuestion,
    response: &LinearResponse,
    operating: f64,
) -> Findings {
    let reported = Reported {
        question,
        response,
        operating,
    };
    let mut warnings = response.warnings.clone();
    warnings.extend(
        response
            .resonances
            .iter()
            .filter_map(|own| reported.too_near(own)),
    );
    let unbounded = response.resonances.iter().filter(|own| own.is_unbounded());
    warnings.extend(unbounded.map(|own| reported.unbounded(own)));
    let found = json!({
        "at": question.at.iter().enumerate().map(|(index, own)| reported.point(index, own)).collect::<Value>(),
        "by": question.by.map_or_else(|| json!("unbalance"), |own| point_json(&own)),
        "speed_rad_s": question.by.map(|_| question.rotor.speed),
        "resonances": response.resonances.iter().map(|own| reported.resonance(own)).collect::<Value>(),
        "reduction_error": response.reduction_error,
        "warnings": warnings,
    });
    let title = &scenario.title;
    let (resonances, shown) = reported.resonances();
    let mut text = Lines::titled(title);
    match question.by {
        None => text.line(
            "response to",
            "the unbalances, linear about the static equilibrium",
        ),
        Some(by) => text.line(
            "response to",
            format!(
                "a {} along {}, linear about the static equilibrium at {:.0} 1/min",
                if by.axis < 3 {
                    "force of 1 N"
                } else {
                    "moment of 1 N m"
                },
                place(&by),
                PER_MINUTE * question.rotor.speed
            ),
        ),
    }
    if response.resonances.is_empty() {
        text.put("no resonance in the range\n");
    } else {
        let shown: Vec<_> = shown
            .iter()
            .map(|(head, name)| (*head, name.as_str()))
            .collect();
        text.show(&resonances, &shown, 5);
    }
    if let Some(error) = response.reduction_error {
        text.line(
            "error",
            format!("with fewer modes of bending {error:.1e} of the largest motion apart"),
        );
    }
    Findings {
        tables: vec![
            ("frequency_response", reported.table()),
            ("resonances", resonances),
        ],
        figures: vec![reported.bode(title), reported.polar(title)],
        ..Findings::new(
            FileSet::sealed("frequency_response.json"),
            scenario,
            found,
            text,
        )
    }
}

/// `x at 250 mm`.
fn place(pickup: &Pickup) -> String {
    let position = to_digits(MILLI * pickup.position, 6);
    format!("{} at {position} mm", FREEDOM_NAMES[pickup.axis])
}

/// Unit of a motion there.
fn motion_unit(pickup: &Pickup) -> &'static str {
    if pickup.axis < 3 { "m" } else { "rad" }
}

fn point_json(pickup: &Pickup) -> Value {
    json!({ "position_m": pickup.position, "direction": FREEDOM_NAMES[pickup.axis] })
}

/// A number of a resonance; none of one whose amplitude is unbounded.
fn bounded(own: &Resonance, number: Option<f64>) -> Option<f64> {
    number.filter(|_| !own.is_unbounded())
}

/// What is reported of a response.
struct Reported<'a> {
    question: &'a LinearResponseQuestion,
    response: &'a LinearResponse,
    operating: f64,
}

impl Reported<'_> {
    /// Name of a pickup in columns: its direction and the number of its position.
    fn name(&self, index: usize) -> String {
        let at = &self.question.at;
        let mut positions = each_once(at.iter().map(|own| own.position)).into_iter();
        let own = positions.position(|known| known == at[index].position);
        format!("{}_{}", FREEDOM_NAMES[at[index].axis], own.unwrap_or(0) + 1)
    }

    fn point(&self, index: usize, pickup: &Pickup) -> Value {
        let mut point = point_json(pickup);
        point["column"] = json!(self.name(index));
        point["unit"] = json!(motion_unit(pickup).to_owned() + self.per_force());
        point
    }

    /// What motions are divided by.
    fn per_force(&self) -> &'static str {
        match self.question.by {
            None => "",
            Some(by) if by.axis < 3 => "/N",
            Some(_) => "/(N m)",
        }
    }

    /// Unit of all motions, behind a prefix; of displacements and tilts side by side both.
    fn unit(&self, prefix: &str) -> String {
        let unit = |own| format!("{prefix}{}{}", motion_unit(own), self.per_force());
        each_once(self.question.at.iter().map(unit)).join(", ")
    }

    fn separation(&self, own: &Resonance) -> Option<(f64, Option<f64>)> {
        let of_unbalance = self.question.by.is_none() && self.operating > 0.0;
        of_unbalance.then(|| own.separation(self.operating))
    }

    fn resonance(&self, own: &Resonance) -> Value {
        let (margin, asked) = self
            .separation(own)
            .map_or((None, None), |(own, asked)| (Some(own), asked));
        json!({
            "column": self.name(own.pickup),
            (self.first_column().name()): self.own_unit(own.peak),
            "amplitude": bounded(own, Some(own.amplitude)),
            "amplification_factor": bounded(own, own.amplification),
            "unbounded": own.is_unbounded(),
            "separation_margin": margin,
            "separation_margin_asked": asked,
        })
    }

    /// That an amplitude has no bound.
    fn unbounded(&self, own: &Resonance) -> String {
        let peak = match self.question.by {
            Some(_) => format!("{:.4} Hz", own.peak / TAU),
            None => format!("{:.1} 1/min", PER_MINUTE * own.peak),
        };
        format!(
            "the resonance of {} at {peak} is undamped: its amplitude is unbounded",
            place(&self.question.at[own.pickup])
        )
    }

    /// A warning where a resonance is nearer to the operating speeds than API 617 asks.
    fn too_near(&self, own: &Resonance) -> Option<String> {
        let (margin, asked) = self.separation(own)?;
        let asked = asked.filter(|asked| margin < *asked)?;
        Some(format!(
            "the resonance of {} at {:.0} 1/min is {:.1} % away from the highest speed of the scenario, {:.0} 1/min, where API 617 \
             asks for {:.1} %",
            place(&self.question.at[own.pickup]),
            PER_MINUTE * own.peak,
            100.0 * margin,
            PER_MINUTE * self.operating,
            100.0 * asked
        ))
    }

    /// Hz of a force, rad/s of a speed.
    fn own_unit(&self, value: f64) -> f64 {
        if self.question.by.is_some() {
            value / TAU
        } else {
            value
        }
    }

    fn first_column(&self) -> Column {
        match self.question.by {
            Some(_) => Column::frequency(),
            None => Column::number("speed", "rad/s"),
        }
    }

    /// The responses: of a force receptance, mobility and accelerance, of unbalances the motion.
    fn table(&self) -> Table<'static> {
        let mut table = Table::from_items(&self.response.points)
            .column(self.first_column(), |(value, _)| self.own_unit(*value));
        for index in 0..self.question.at.len() {
            let name = self.name(index);
            let kinds: &[(&str, &str, i32)] = match self.question.by {
                Some(_) => &[
                    ("_receptance", "", 0),
                    ("_mobility", "/s", 1),
                    ("_accelerance", "/s^2", 2),
                ],
                None => &[("", "", 0)],
            };
            let motion = motion_unit(&self.question.at[index]);
            for (what, per_time, rates) in kinds {
                let quantity = format!("{name}{what}");
                let unit = format!("{motion}{per_time}{}", self.per_force());
                let column = match what.is_empty() {
                    true => Column::measure(quantity.clone(), "amplitude", unit),
                    false => Column::number(quantity.clone(), unit),
                };
                // a rate is iω times as large
                let motion = move |(value, motions): &(f64, Option<Vec<Complex<f64>>>)| {
                    let motion = motions.as_ref()?[index];
                    Some(motion * Complex::new(0.0, *value).powi(*rates))
                };
                table = table
                    .column(column, move |row| Some(motion(row)?.norm()))
                    .column(Column::phase(quantity), move |row| Some(motion(row)?.arg()));
            }
        }
        table.end()
    }

    /// The resonances, and which of their columns people are shown under which heads.
    fn resonances(&self) -> (Table<'static>, Vec<(&'static str, String)>) {
        let by_force = self.question.by.is_some();
        let mut unit = self.unit("");
        let is_mixed = unit.contains(',');
        if is_mixed {
            // displacements and tilts side by side have their units in a column of their own
            unit.clear();
        }
        let amplitude = match by_force {
            true => Column::number("receptance", unit),
            false => Column::number("amplitude", unit),
        };
        let mut shown = vec![
            ("place", "place".to_owned()),
            ("resonance", self.first_column().quantity.into_owned()),
            ("amplitude", amplitude.quantity.to_string()),
            ("unit", "unit".to_owned()),
            ("amplification\nfactor", "amplification_factor".to_owned()),
        ];
        let mut table = Table::from_items(&self.response.resonances)
            .word("column", |own| self.name(own.pickup))
            .word("place", |own| place(&self.question.at[own.pickup]))
            .column(self.first_column(), |own| self.own_unit(own.peak))
            .column(amplitude, |own| bounded(own, Some(own.amplitude)));
        if is_mixed {
            table = table.word("unit", |own| {
                motion_unit(&self.question.at[own.pickup]).to_owned() + self.per_force()
            });
        }
        table = table.number("amplification_factor", "", |own| {
            bounded(own, own.amplification)
        });
        if !by_force {
            shown.push(("margin", "separation_margin".to_owned()));
            shown.push(("margin by\nAPI 617", "separation_margin_asked".to_owned()));
            table = table
                .number("separation_margin", "", |own| Some(self.separation(own)?.0))
                .number("separation_margin_asked", "", |own| self.separation(own)?.1);
        }
        (table.end(), shown)
    }
}
