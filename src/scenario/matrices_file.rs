//! A shaft as the matrices of another program.

use std::path::Path;

use nalgebra::DMatrix;
use serde::Deserialize;

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
    let unreadable = |error: std::io::Error| format!("it cannot be read: {error}");
    let known = std::fs::metadata(path).map_err(unreadable)?;
    if !known.is_file() || known.len() > LARGEST {
        return Err(format!("it is not a file of at most {} MB", LARGEST >> 20));
    }
    let text = std::fs::read_to_string(path).map_err(unreadable)?;
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
        let per_node = match size {
            _ if size == 4 * count => 4,
            _ if size == 6 * count => 6,
            _ => {
                return Err(format!(
                    "M has {size} rows; {count} nodes have {} or {}",
                    4 * count,
                    6 * count
                ));
            }
        };
        let matrix = |name: &str, rows: &[Vec<f64>]| matrix(name, rows, size);
        let [mass, stiffness, gyroscopic] = [
            matrix("M", &self.mass)?,
            matrix("K", &self.stiffness)?,
            matrix("G", &self.gyroscopic)?,
        ];
        for (name, entries) in [("M", &mass), ("K", &stiffness)] {
            same(
                &format!("{name} is not symmetric"),
                entries,
                &entries.transpose(),
            )?;
        }
        same(
            "G is not skew-symmetric",
            &gyroscopic,
            &-gyroscopic.transpose(),
        )?;
        let planes = Planes::new(count, per_node);
        Ok(Mesh {
            nodes: self.nodes.clone(),
            plane: Plane {
                mass: planes.of_both("M", &mass)?,
                stiffness: planes.of_both("K", &stiffness)?,
                polar: planes.across(&gyroscopic),
            },
        })
    }
}

fn matrix(name: &str, rows: &[Vec<f64>], size: usize) -> Result<DMatrix<f64>, String> {
    if rows.len() != size {
        return Err(format!("{name} has {} rows, M {size}", rows.len()));
    }
    for (index, row) in rows.iter().enumerate() {
        if row.len() != size {
            return Err(format!(
                "row {} of {name} has {} entries, {name} {size} rows",
                index + 1,
                row.len()
            ));
        }
        if row.iter().any(|entry| !entry.is_finite()) {
            return Err(format!(
                "row {} of {name} has an entry that is no number",
                index + 1
            ));
        }
    }
    Ok(DMatrix::from_fn(size, size, |row, column| {
        rows[row][column]
    }))
}

fn same(what: &str, first: &DMatrix<f64>, second: &DMatrix<f64>) -> Result<(), String> {
    let apart = (first - second).amax();
    if apart > SAME * first.amax() {
        return Err(format!("{what}: entries differ by {apart:.3e}"));
    }
    Ok(())
}

/// Which coordinates of the file are deflections and slopes of the planes of x and y, with their signs.
struct Planes([Vec<(usize, f64)>; 2]);

impl Planes {
    fn new(nodes: usize, per_node: usize) -> Self {
        let tilt = per_node - 2 - usize::from(per_node == 6);
        let plane = |pair: [(usize, f64); 2]| {
            let nodes = 0..nodes;
            nodes
                .flat_map(|node| pair.map(|(own, sign)| (per_node * node + own, sign)))
                .collect()
        };
        Self([
            plane([(0, 1.0), (tilt + 1, 1.0)]),
            plane([(1, 1.0), (tilt, -1.0)]),
        ])
    }

    fn block(&self, entries: &DMatrix<f64>, rows: usize, columns: usize) -> DMatrix<f64> {
        let (rows, columns) = (&self.0[rows], &self.0[columns]);
        DMatrix::from_fn(rows.len(), columns.len(), |row, column| {
            rows[row].1 * columns[column].1 * entries[(rows[row].0, columns[column].0)]
        })
    }

    /// The matrix of one plane, where both are alike.
    fn of_both(&self, name: &str, entries: &DMatrix<f64>) -> Result<DMatrix<f64>, String> {
        let [first, second] = [0, 1].map(|plane| self.block(entries, plane, plane));
        same(
            &format!("{name} is that of no round shaft"),
            &first,
            &second,
        )?;
        Ok(first)
    }

    /// The rotary inertia about the axis in the gyroscopic matrix.
    fn across(&self, gyroscopic: &DMatrix<f64>) -> DMatrix<f64> {
        let block = self.block(gyroscopic, 0, 1);
        0.5 * (&block + block.transpose())
    }
}
