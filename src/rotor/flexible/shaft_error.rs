//! Why a shaft cannot be built.

/// Why a shaft cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShaftError {
    /// A position beyond the ends of the shaft.
    #[error(
        "a position of {position} m lies beyond the shaft, which is {length} m long from its left end"
    )]
    Beyond {
        /// The position from the left end, m.
        position: f64,
        /// Length of the shaft, m.
        length: f64,
    },
    /// The matrices cannot be reduced.
    #[error(
        "the shaft cannot be reduced to the {points} points where bearings, loads and unbalances sit: a part of it has no \
         stiffness"
    )]
    Singular {
        /// Number of points that are kept.
        points: usize,
    },
    /// Points without mass or moment of inertia, positions from the left end in m, of a shaft that has some elsewhere.
    #[error(
        "bearings, loads, unbalances or the observed point sit at {}, where the shaft has no mass or no moment of inertia, \
         although it has some between them: put a disc there that has both, or give these nodes some",
        millimetres(.0)
    )]
    Massless(Vec<f64>),
    /// Coordinates without mass follow from the forces on them, and these must not vary by themselves.
    #[error(
        "{0} have no mass or moment of inertia, and damping, an unbalance or a varying load acts there: put a disc there \
         that has both, however small, or take what acts there to a disc"
    )]
    Followers(String),
    /// A point between the nodes of given matrices.
    #[error(
        "no node of the shaft's matrices lies at {position} m: the nearest one is at {nearest} m"
    )]
    NoNode {
        /// The position from the left end, m.
        position: f64,
        /// Of the nearest node, m.
        nearest: f64,
    },
}

/// `0.0 mm, 200.0 mm`.
fn millimetres(positions: &[f64]) -> String {
    let texts = positions.iter().map(|at| format!("{:.1} mm", 1e3 * at));
    texts.collect::<Vec<_>>().join(", ")
}
