//! A shaft as the matrices of another program.

use std::path::Path;

use nalgebra::DMatrix;
use serde::Deserialize;

use super::document::file_text;
use crate::rotor::{Mesh, Plane};

/// Most bytes of a file.
const LARGEST: u64 = 64 << 20;
/// Difference of entries that should be equal, of the largest of their matrix.
const SAME: f64 = 1e-6;

/// The file: JSON with the positions of the nodes in m and the matrices M, K and G, row by row in SI units, with 4
/// coordinates a node (x, y, θx, θy) or 6 (x, y, z, θx, θy, θz).
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MatricesFile {
    nodes: Vec<f64>,
    #[serde(rename = "M")]
    mass: Vec<Vec<f64>>,
    #[serde(rename = "K")]
    stiffness: Vec<Vec<f64>>,
    #[serde(rename = "G")]
    gyroscopic: Vec<Vec<f64>>,
}

/// Reads a file.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn read(path: &Path) -> Result<Mesh, String> {
    let text = file_text(path, LARGEST)?;
    let file: MatricesFile = serde_json::from_str(&text).map_err(|error| {
        format!("{error}; it must be JSON with `nodes` in m and the matrices `M`, `K` and `G`")
    })?;
    file.mesh()
}

impl MatricesFile {
    fn mesh(&self) -> Result<Mesh, String> {
        let count = self.nodes.len();
        if count < 2 {
            return Err("it has fewer than two nodes".to_owned());
        }
        if !self.nodes.windows(2).all(|pair| pair[0] < pair[1]) {
            return Err("the positions of its nodes do not rise".to_owned());
        }
        let size = self.mass.len();
        let Some(per_node) = [4, 6].into_iter().find(|each| each * count == size) else {
            let [plane, space] = [4, 6].map(|each| each * count);
            return Err(format!(
                "M has {size} rows; {count} nodes have {plane} or {space}"
            ));
        };
        let mass = matrix("M", &self.mass, size)?;
        let stiffness = matrix("K", &self.stiffness, size)?;
        let gyroscopic = matrix("G", &self.gyroscopic, size)?;
        same("M is not symmetric", &mass, &mass.transpose())?;
        same("K is not symmetric", &stiffness, &stiffness.transpose())?;
        let turned = -gyroscopic.transpose();
        same("G is not skew-symmetric", &gyroscopic, &turned)?;
        let tilt = per_node - 2 - usize::from(per_node == 6);
        let planes = [[(0, 1.0), (tilt + 1, 1.0)], [(1, 1.0), (tilt, -1.0)]].map(|pair| {
            let of_node = |node| pair.map(|(own, sign)| (per_node * node + own, sign));
            (0..count).flat_map(of_node).collect::<Coordinates>()
        });
        // of the gyroscopic matrix the rotary inertia about the axis
        let across = block(&gyroscopic, &planes[0], &planes[1]);
        Ok(Mesh {
            nodes: self.nodes.clone(),
            whole: None,
            plane: Plane {
                mass: plane_matrix("M", &mass, &planes)?,
                stiffness: plane_matrix("K", &stiffness, &planes)?,
                polar: 0.5 * (&across + across.transpose()),
            },
        })
    }
}

fn matrix(name: &str, rows: &[Vec<f64>], size: usize) -> Result<DMatrix<f64>, String> {
    if rows.len() != size {
        return Err(format!("{name} has {} rows, M {size}", rows.len()));
    }
    for (number, row) in (1..).zip(rows) {
        let count = row.len();
        if count != size {
            let problem = format!("has {count} entries, {name} {size} rows");
            return Err(format!("row {number} of {name} {problem}"));
        }
        if row.iter().any(|entry| !entry.is_finite()) {
            let problem = "has an entry that is no number";
            return Err(format!("row {number} of {name} {problem}"));
        }
    }
    Ok(DMatrix::from_row_iterator(
        size,
        size,
        rows.iter().flatten().copied(),
    ))
}

fn same(what: &str, first: &DMatrix<f64>, second: &DMatrix<f64>) -> Result<(), String> {
    let apart = (first - second).amax();
    if apart > SAME * first.amax() {
        return Err(format!("{what}: entries differ by {apart:.3e}"));
    }
    Ok(())
}

/// Which coordinates of the file are deflections and slopes of a plane, with their signs.
type Coordinates = Vec<(usize, f64)>;

fn block(entries: &DMatrix<f64>, rows: &Coordinates, columns: &Coordinates) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |row, column| {
        rows[row].1 * columns[column].1 * entries[(rows[row].0, columns[column].0)]
    })
}

/// The matrix of one plane, where both, those of x and y, are alike.
fn plane_matrix(
    name: &str,
    entries: &DMatrix<f64>,
    planes: &[Coordinates; 2],
) -> Result<DMatrix<f64>, String> {
    let [first, second] = planes.each_ref().map(|plane| block(entries, plane, plane));
    let problem = format!("{name} is that of no round shaft");
    same(&problem, &first, &second)?;
    Ok(first)
}
