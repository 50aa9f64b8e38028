//! What comes of compiling a table.

use serde::Serialize;

/// What a table is good for, and what it took.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TableReport {
    /// Largest difference from the exact force at offset places of the whole region, N.
    #[serde(rename = "error_N")]
    pub error: f64,
    /// The same relative to the load that the tolerance refers to.
    pub relative_error: f64,
    /// Number of cells.
    pub cells: usize,
    /// Evaluations of the exact law, those for the error among them.
    pub evaluations: usize,
}

/// Why a law stays without a table.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TableError {
    /// No range, or no load to refer to.
    #[error("the balls move in no region of their own, or carry nothing")]
    NoRegion,
    /// The line of lift-off cannot be followed.
    #[error("the balls lift off outside the reach of a table")]
    LiftOff,
    /// The surfaces under the balls are not perfect.
    #[error(
        "a table knows a ball by its place alone, and the surfaces under the balls are not perfect"
    )]
    Imperfect,
    /// The law is not smooth enough.
    #[error("a table of {cells} cells has a relative error of {relative_error:e}")]
    Tolerance {
        /// Measured error relative to the load that the tolerance refers to.
        relative_error: f64,
        /// Number of cells.
        cells: usize,
    },
}
