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

/// Place of the shaft at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Time, s.
    pub time: f64,
    /// Displacements that move, m and rad.
    pub displacement: Vec<f64>,
}

impl RunRecord {
    /// Whether the run came to its end.
    pub fn is_done(&self) -> bool {
        self.outcome.is_ok()
    }

    /// Which way it was come to.
    pub fn direction(&self) -> Direction {
        self.turn.direction
    }
}
