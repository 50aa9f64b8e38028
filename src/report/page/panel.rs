//! Curves and the panels that they stand in, as the page's script reads them.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use serde_json::{Value, json};

/// A curve: its name, and its points as little-endian floats in base64, abscissas of 64 and values of 32 bits.
pub(in crate::report) fn curve(name: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Value {
    let (abscissas, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
    let wide: Vec<u8> = abscissas.iter().flat_map(|x| x.to_le_bytes()).collect();
    json!({
        "name": name,
        "abscissas": STANDARD.encode(wide),
        "values": narrow(values),
    })
}

/// Values as little-endian 32-bit floats in base64.
pub(in crate::report) fn narrow(values: impl IntoIterator<Item = f64>) -> String {
    let bytes = values
        .into_iter()
        .flat_map(|value| (value as f32).to_le_bytes());
    STANDARD.encode(bytes.collect::<Vec<_>>())
}

/// Curves over one axis.
#[derive(Debug, Serialize)]
pub(in crate::report) struct PagePanel<'a> {
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
    /// The curves.
    pub curves: Vec<Value>,
    /// What is marked on them.
    pub marks: Vec<Value>,
    /// Where values lie that are not known one by one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub band: Option<Value>,
}
