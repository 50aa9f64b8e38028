//! How results name and shape what `#[derive(Serialize)]` alone cannot: quantities with their units,
//! stiffness matrices, things by their names.

use std::collections::BTreeMap;
use std::fmt::Display;

use nalgebra::Complex;
use serde::{Serialize, Serializer};

use crate::table::Column;

/// Number of freedoms of the inner ring: x, y, z, θx, θy.
const FREEDOMS: usize = 5;
/// A stiffness matrix.
type Matrix5 = nalgebra::SMatrix<f64, FREEDOMS, FREEDOMS>;

/// What comes of writing a value.
type Serialized<S> = Result<<S as Serializer>::Ok, <S as Serializer>::Error>;

/// Names of the freedoms.
pub(crate) const AXES: [&str; FREEDOMS] = ["x", "y", "z", "tilt_x", "tilt_y"];
/// Displacements and tilts with their units.
pub(crate) const DISPLACEMENT: [(&str, &str); FREEDOMS] = [
    (AXES[0], "m"),
    (AXES[1], "m"),
    (AXES[2], "m"),
    (AXES[3], "rad"),
    (AXES[4], "rad"),
];
/// Forces and moments with their units.
pub(crate) const FORCE: [(&str, &str); FREEDOMS] = [
    ("force_x", "N"),
    ("force_y", "N"),
    ("force_z", "N"),
    ("moment_x", "N m"),
    ("moment_y", "N m"),
];

/// The columns of the diagonal of a stiffness matrix: `stiffness_x_N_m` ….
pub(crate) fn diagonal_columns() -> [Column; FREEDOMS] {
    std::array::from_fn(|axis| {
        let unit = format!("{}/{}", FORCE[axis].1, DISPLACEMENT[axis].1);
        Column::number(format!("stiffness_{}", AXES[axis]), unit)
    })
}

/// Quantities with their units as keys.
fn named(quantities: [(&'static str, &'static str); FREEDOMS]) -> [String; FREEDOMS] {
    quantities.map(|(quantity, unit)| Column::number(quantity, unit).name())
}

/// `{"x_m": …, "y_m": …, …}`.
pub(crate) fn displacement<S: Serializer>(
    values: &[f64; FREEDOMS],
    serializer: S,
) -> Serialized<S> {
    serializer.collect_map(named(DISPLACEMENT).iter().zip(values))
}

/// `{"force_x_N": …, …}`.
pub(crate) fn force<S: Serializer>(values: &[f64; FREEDOMS], serializer: S) -> Serialized<S> {
    serializer.collect_map(named(FORCE).iter().zip(values))
}

/// `{"x": …, "y": …, …}`: one value each of the first freedoms.
pub(crate) fn by_axis<T: Serialize, S: Serializer>(values: &[T], serializer: S) -> Serialized<S> {
    serializer.collect_map(AXES.iter().zip(values))
}

/// Names of the freedoms that are marked: `["x", "y"]`.
pub(crate) fn marked<S: Serializer>(marks: &[bool; FREEDOMS], serializer: S) -> Serialized<S> {
    let names = AXES.iter().zip(marks).filter(|(_, mark)| **mark);
    serializer.collect_seq(names.map(|(name, _)| name))
}

/// A stiffness matrix with the names of its rows and columns, and its diagonal by name.
pub(crate) fn stiffness<S: Serializer>(matrix: &Matrix5, serializer: S) -> Serialized<S> {
    rows(
        &std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)])),
        serializer,
    )
}

/// The rows of a stiffness matrix with the names of its rows and columns, and its diagonal by name.
pub(crate) fn rows<S: Serializer>(
    rows: &[[f64; FREEDOMS]; FREEDOMS],
    serializer: S,
) -> Serialized<S> {
    #[derive(Serialize)]
    struct Named<'a> {
        meaning: &'a str,
        rows: [String; FREEDOMS],
        columns: [String; FREEDOMS],
        matrix: &'a [[f64; FREEDOMS]; FREEDOMS],
        #[serde(serialize_with = "diagonal")]
        named: Matrix5,
    }
    let named = Named {
        meaning: "forces and moments that the bearings need per displacement and tilt at the static \
                  equilibrium; the unit of an entry is that of its row over that of its column",
        rows: named(FORCE),
        columns: named(DISPLACEMENT),
        matrix: rows,
        named: Matrix5::from_fn(|row, column| rows[row][column]),
    };
    named.serialize(serializer)
}

/// The diagonal of a stiffness matrix: `{"stiffness_x_N_m": …, …}`.
pub(crate) fn diagonal<S: Serializer>(matrix: &Matrix5, serializer: S) -> Serialized<S> {
    let columns = diagonal_columns().into_iter().enumerate();
    serializer.collect_map(columns.map(|(axis, column)| (column, matrix[(axis, axis)])))
}

/// Complex numbers with their magnitudes.
pub(crate) fn complex<S: Serializer>(values: &[Complex<f64>], serializer: S) -> Serialized<S> {
    #[derive(Serialize)]
    struct Number {
        re: f64,
        im: f64,
        magnitude: f64,
    }
    serializer.collect_seq(values.iter().map(|value| Number {
        re: value.re,
        im: value.im,
        magnitude: value.norm(),
    }))
}

/// Magnitudes of complex numbers.
pub(crate) fn magnitudes<S: Serializer>(values: &[Complex<f64>], serializer: S) -> Serialized<S> {
    let magnitudes = values.iter().map(|value| value.norm());
    serializer.collect_seq(magnitudes.map(|value| BTreeMap::from([("magnitude", value)])))
}

/// What it is called.
pub(crate) fn name<S: Serializer>(value: &impl Display, serializer: S) -> Serialized<S> {
    serializer.collect_str(value)
}

/// What it is called, if there is one.
pub(crate) fn optional_name<T: Display, S: Serializer>(
    value: &Option<T>,
    serializer: S,
) -> Serialized<S> {
    let name = value.as_ref().map(ToString::to_string);
    name.serialize(serializer)
}

/// Pairs of a name and what bears it.
pub(crate) fn by_name<K: Display, T: Serialize, S: Serializer>(
    pairs: &[(K, T)],
    serializer: S,
) -> Serialized<S> {
    serializer.collect_map(pairs.iter().map(|(name, value)| (name.to_string(), value)))
}

/// How many there are.
pub(crate) fn count<T, S: Serializer>(values: &[T], serializer: S) -> Serialized<S> {
    serializer.serialize_u64(values.len() as u64)
}

/// An index as a number from 1 on.
pub(crate) fn from_one<S: Serializer>(index: &usize, serializer: S) -> Serialized<S> {
    serializer.serialize_u64(*index as u64 + 1)
}

/// First and last time, s.
pub(crate) fn span<S: Serializer>(span: &Option<[f64; 2]>, serializer: S) -> Serialized<S> {
    let [first, last] = span.map_or([None; 2], |span| span.map(Some));
    serializer.collect_map([("first_s", first), ("last_s", last)])
}

/// A result, or a `note` that says why there is none.
pub(crate) fn or_note<T: Serialize, E: Display, S: Serializer>(
    result: &Result<T, E>,
    serializer: S,
) -> Serialized<S> {
    match result {
        Ok(value) => value.serialize(serializer),
        Err(reason) => serializer.collect_map([("note", reason.to_string())]),
    }
}
