//! Many numbers as text: little-endian floats in base64, which the page's script reads at once.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use super::{Cell, Curve, Point};

/// Values as 32-bit floats in base64.
pub(in crate::report) fn narrow(values: impl IntoIterator<Item = f64>) -> String {
    let values = values.into_iter();
    let bytes = values.flat_map(|value| (value as f32).to_le_bytes());
    STANDARD.encode(bytes.collect::<Vec<_>>())
}

/// Abscissas as 64-bit floats in base64: of a long run the last ones are told apart.
fn wide(points: &[Point]) -> String {
    let bytes = points.iter().flat_map(|point| point.0.to_le_bytes());
    STANDARD.encode(bytes.collect::<Vec<_>>())
}

/// Numbers of runs, which are exact below 2^24; nothing where there are none.
fn numbers(runs: &[u64]) -> Option<String> {
    (!runs.is_empty()).then(|| narrow(runs.iter().map(|run| *run as f64)))
}

/// Bytes in base64.
pub(super) fn levels<S: Serializer>(levels: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&STANDARD.encode(levels))
}

/// Curves; one with the abscissas of the curve before it has none of its own.
pub(super) fn curves<S: Serializer>(curves: &[Curve], serializer: S) -> Result<S::Ok, S::Error> {
    let mut before = None;
    let packed = curves.iter().map(|curve| {
        let abscissas = wide(&distinct_points(curve));
        let own = before.as_ref() != Some(&abscissas);
        let packed = packed(curve, own.then_some(&abscissas));
        before = Some(abscissas);
        packed
    });
    packed.collect::<Vec<_>>().serialize(serializer)
}

fn packed(curve: &Curve, abscissas: Option<&String>) -> Value {
    let marks_points = !curve.points.is_empty() && curve.marks == curve.points;
    let values = |points: &[Point]| narrow(points.iter().map(|point| point.1));
    let edge = |side: usize| narrow(curve.band.iter().map(|band| band[side]));
    json!({
        "name": curve.name,
        "colour": curve.colour,
        "fine": curve.fine,
        "beside": curve.beside,
        "abscissas": abscissas,
        "values": values(&distinct_points(curve)),
        "band": (!curve.band.is_empty()).then(|| [edge(0), edge(1)]),
        "marks": (!marks_points).then(|| [wide(&curve.marks), values(&curve.marks)]),
        "mark": curve.mark,
        "runs": numbers(&curve.runs),
    })
}

/// The points of a curve; where nothing else belongs to them, none twice.
fn distinct_points(curve: &Curve) -> Vec<Point> {
    let mut points = curve.points.clone();
    if curve.runs.is_empty() && curve.marks.is_empty() && curve.band.is_empty() {
        points.dedup();
    }
    points
}

/// Cells, or null where there are none.
pub(super) fn cells<S: Serializer>(cells: &[Cell], serializer: S) -> Result<S::Ok, S::Error> {
    let corners = |index: usize, axis: fn(&Point) -> f64| {
        narrow(cells.iter().map(|cell| axis(&cell.corners[index])))
    };
    let packed = || {
        json!({
            "left": corners(0, |point| point.0),
            "right": corners(1, |point| point.0),
            "top": corners(0, |point| point.1),
            "bottom": corners(1, |point| point.1),
            "values": narrow(cells.iter().map(|cell| cell.value)),
            "colours": cells.iter().map(|cell| json!(cell.colour)).collect::<Value>(),
            "runs": numbers(&cells.iter().filter_map(|cell| cell.run).collect::<Vec<_>>()),
        })
    };
    (!cells.is_empty()).then(packed).serialize(serializer)
}
