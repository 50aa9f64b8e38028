//! What is kept of one run.

use super::numbers::Numbers;
use super::{Direction, Turn};

/// One run of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct RunRecord {
    /// Its number, its point of the plan and how it was come to.
    pub turn: Turn,
    /// Values of the axes, SI units.
    pub values: Vec<f64>,
    /// What came of it, or why nothing did.
    pub outcome: Result<Outcome, String>,
}

/// What came of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Its numbers.
    pub numbers: Numbers,
    /// Amplitudes of the displacements, m and rad, at frequencies in Hz; empty where none are kept.
    pub spectrum: Vec<Line>,
    /// Places of the shaft; empty where none are kept.
    pub points: Vec<Point>,
    /// Stiffness of every bearing that has one of its own; empty where it is not kept.
    pub stiffness: Vec<BearingStiffness>,
    /// What its trace is known by, where it is kept.
    pub trace: Option<TraceSeal>,
}

/// What the trace of a run is known by wherever it goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TraceSeal {
    /// Number of bytes.
    pub bytes: u64,
    /// Sum over them.
    pub checksum: u64,
}

/// Amplitudes at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Frequency over that of the shaft, where it turns.
    pub order: Option<f64>,
    /// Amplitude of every displacement that moves.
    pub amplitudes: Vec<f64>,
}

/// How stiffly one bearing holds the shaft at the static equilibrium, and its part of the damping.
///
/// The entries [`BearingStiffness::ENTRIES`]: those that do not depend on which way the bearing faces, and that
/// a bearing without tilts has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingStiffness {
    /// Number of the bearing, from 1 on.
    pub bearing: usize,
    /// Speed of the shaft there, rad/s.
    pub speed: f64,
    /// K, N/m.
    pub stiffness: [f64; 5],
    /// Part of C in the proportion of the stiffness, entry by entry, N s/m: what damps the shaft belongs to
    /// no bearing by itself.
    pub damping: [f64; 5],
}

impl BearingStiffness {
    /// Names, rows and columns of the entries, x before y before z.
    pub const ENTRIES: [(&str, usize, usize); 5] = [
        ("xx", 0, 0),
        ("xy", 0, 1),
        ("yx", 1, 0),
        ("yy", 1, 1),
        ("zz", 2, 2),
    ];
}

/// Place of the shaft at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Time, s.
    pub time: f64,
    /// Displacements that move, m and rad.
    pub displacement: Vec<f64>,
}

impl RunRecord {
    /// Which way it was come to.
    pub fn direction(&self) -> Direction {
        self.turn.direction
    }
}
