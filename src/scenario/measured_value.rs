//! Values that were measured, in the units that people measure in.

use serde_json::Value;

use super::problems::Issue;
use super::quantity::{Dimension, parse};
use crate::analysis::Channel;

/// Units that amplitudes of a channel are measured in: those of the channel, of its rate and of the rate of that.
const RATES: [(&str, [Dimension; 3]); 2] = [
    (
        "m",
        [
            Dimension::Length,
            Dimension::Velocity,
            Dimension::Acceleration,
        ],
    ),
    (
        "rad",
        [
            Dimension::Angle,
            Dimension::AngularSpeed,
            Dimension::AngularSpeed,
        ],
    ),
];

/// An amplitude of a channel, or of one of its rates.
pub(super) struct Amplitude {
    /// In SI units.
    pub value: f64,
    /// Of which rate of the channel.
    pub rate: i32,
}

impl Amplitude {
    pub fn read(text: &Value, channel: Channel, place: &str) -> Result<Self, Issue> {
        let rates = RATES.iter().find(|(unit, _)| *unit == channel.unit());
        let Some((_, dimensions)) = rates else {
            return Ok(Self {
                value: read(text, channel.unit(), place)?,
                rate: 0,
            });
        };
        let written = text.as_str().unwrap_or_default().trim();
        // of a sensor g is the standard gravity
        let written = match written
            .strip_suffix('g')
            .filter(|rest| !rest.ends_with('k'))
        {
            Some(number) => format!("{number}gn"),
            None => written.to_owned(),
        };
        let found = (0..).zip(dimensions).find_map(|(rate, dimension)| {
            let parsed = parse(&written, &[*dimension]).ok()?;
            Some(Self {
                value: parsed.si,
                rate,
            })
        });
        found.ok_or_else(|| {
            let message = format!("{text} is no amplitude of `{channel}`");
            let units: Vec<_> = dimensions
                .iter()
                .map(|dimension| dimension.si_symbol())
                .collect();
            Issue::new(place, message).help(format!(
                "give a number with a unit like {}",
                units.join(", ")
            ))
        })
    }

    /// A standard deviation of the amplitude, as a part of it or in its unit.
    pub fn deviation(&self, text: &Value, channel: Channel, place: &str) -> Result<f64, Issue> {
        let in_unit = || {
            let own = Self::read(text, channel, place).ok();
            own.filter(|own| own.rate == self.rate).map(|own| own.value)
        };
        let part = percent(text).map(|part| part * self.value);
        let sigma = part.or_else(in_unit).ok_or_else(|| {
            let message = format!("{text} is no standard deviation of the amplitude");
            Issue::new(place, message)
                .help("give it as a part, \"5 %\", or with a unit of what the amplitude measures")
        })?;
        positive_deviation(sigma, place)
    }
}

/// A value in a unit that columns have; a number of what has no unit, or one that no scenario knows.
pub(super) fn read(value: &Value, unit: &str, place: &str) -> Result<f64, Issue> {
    let dimension = Dimension::of_unit(unit);
    let wrong = |how: String| Issue::new(place, format!("{value} is no such quantity")).help(how);
    match (dimension, value.as_str()) {
        (Some(dimension), Some(text)) => {
            let parsed = parse(text, &[dimension]);
            let parsed = parsed.map_err(|_| {
                wrong(format!(
                    "a {} is written like \"2 {unit}\"",
                    dimension.name()
                ))
            })?;
            Ok(parsed.si)
        }
        (Some(dimension), None) => Err(wrong(format!(
            "a {} needs a unit, as in \"{value} {unit}\"",
            dimension.name()
        ))),
        (None, None) => value
            .as_f64()
            .ok_or_else(|| wrong("give a number".to_owned())),
        (None, Some(_)) => Err(wrong(format!(
            "give a number{}",
            match unit {
                "" => String::new(),
                unit => format!(" in {unit}, without the unit"),
            }
        ))),
    }
}

/// `5 %` as a part; none of another text.
pub(super) fn percent(value: &Value) -> Option<f64> {
    let number = value.as_str()?.trim().strip_suffix('%')?;
    Some(number.trim().parse::<f64>().ok()? / 100.0)
}

/// A standard deviation, as a part of what was measured or in its unit.
pub(super) fn deviation(
    value: &Value,
    measured: f64,
    unit: &str,
    place: &str,
) -> Result<f64, Issue> {
    let sigma = match percent(value) {
        Some(part) => part * measured.abs(),
        None => read(value, unit, place)?,
    };
    positive_deviation(sigma, place)
}

/// A standard deviation that can weigh what was measured.
pub(super) fn positive_deviation(sigma: f64, place: &str) -> Result<f64, Issue> {
    match sigma > 0.0 && sigma.is_finite() {
        true => Ok(sigma),
        false => Err(Issue::new(place, "a standard deviation is positive")
            .help("of a value of zero it is no part: give it in its unit")),
    }
}
