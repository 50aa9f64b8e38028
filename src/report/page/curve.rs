//! Curves and the panels that they stand in, as the page's script reads them.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// Buckets of a curve over time: twice as many points. A wide screen shows fewer.
pub(super) const BUCKETS: usize = 3072;

/// A curve: its name, and its points as little-endian floats in base64, abscissas of 64 and values of 32 bits.
pub(super) fn curve(name: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Value {
    let (abscissas, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
    let wide: Vec<u8> = abscissas.iter().flat_map(|x| x.to_le_bytes()).collect();
    json!({
        "name": name,
        "abscissas": STANDARD.encode(wide),
        "values": narrow(values),
    })
}

/// Values as little-endian 32-bit floats in base64.
pub(super) fn narrow(values: impl IntoIterator<Item = f64>) -> String {
    let bytes = values
        .into_iter()
        .flat_map(|value| (value as f32).to_le_bytes());
    STANDARD.encode(bytes.collect::<Vec<_>>())
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

/// What to draw of the points of a curve: all of them or, of too many, from every stretch the highest and the
/// lowest.
pub(super) fn prominent(all: Vec<usize>, height: impl Fn(usize) -> f64) -> Vec<usize> {
    let stretch = all.len().div_ceil(BUCKETS);
    if stretch <= 2 {
        return all;
    }
    let by_height = |a: &&usize, b: &&usize| height(**a).total_cmp(&height(**b));
    all.chunks(stretch)
        .flat_map(|stretch| {
            let lowest = stretch.iter().min_by(by_height).copied();
            let highest = stretch.iter().max_by(by_height).copied();
            let [first, last] = [lowest.min(highest), lowest.max(highest)];
            first.into_iter().chain(last.filter(|_| first != last))
        })
        .collect()
}
