//! Curves and the panels that they stand in, as the page's script reads them.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// Buckets of a curve over time: twice as many points. A wide screen shows fewer.
pub(super) const BUCKETS: usize = 3072;

/// A curve: its name, and its points as little-endian 32-bit floats in base64.
pub(super) fn curve(name: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Value {
    let (mut abscissas, mut values) = (Vec::new(), Vec::new());
    for (abscissa, value) in points {
        abscissas.extend((abscissa as f32).to_le_bytes());
        values.extend((value as f32).to_le_bytes());
    }
    json!({
        "name": name,
        "abscissas": STANDARD.encode(abscissas),
        "values": STANDARD.encode(values),
    })
}

/// Curves over one axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Panel<'a> {
    /// What is drawn.
    pub name: &'a str,
    /// Unit of the values.
    pub unit: &'a str,
    /// Quantity and unit of the abscissa.
    pub over: [&'a str; 2],
    /// Abscissa up to which the panel is shown at first; all of it where `None`.
    pub shown: Option<f64>,
    /// Whether values stand on a logarithmic axis.
    pub logarithmic: bool,
}

impl Panel<'_> {
    /// The panel with its curves and what is marked on them.
    pub fn json(self, curves: Vec<Value>, marks: Vec<Value>) -> Value {
        json!({
            "name": self.name,
            "unit": self.unit,
            "over": self.over,
            "shown": self.shown,
            "logarithmic": self.logarithmic,
            "curves": curves,
            "marks": marks,
        })
    }
}
