//! What a spectral line can be caused by, and how it is called.

use std::fmt;

use crate::bearing::Surface;
use crate::rotor::Whirl;

/// What a spectral line can be caused by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LineKind {
    /// k × shaft frequency.
    ShaftOrder(u32),
    /// k × ball-pass frequency of the outer race, ± sideband × shaft: balls that pass a load which
    /// stands still.
    BallPassOuter {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
        /// Shaft orders added.
        sideband: i32,
    },
    /// k × ball-pass frequency of the inner race, ± sideband × shaft: balls that pass a load which
    /// turns with the shaft.
    BallPassInner {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
        /// Shaft orders added.
        sideband: i32,
    },
    /// k × spin frequency of the balls, ± sideband × cage: a spot of a ball that meets the races.
    BallSpin {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
        /// Cage orders added.
        sideband: i32,
    },
    /// A wave around a surface, which balls roll over.
    Waviness {
        /// Bearing, from 0.
        bearing: usize,
        /// The surface.
        on: Surface,
        /// Waves around it, n.
        order: u32,
        /// What the balls, the shaft or the cage turn by beside: of races n + p is a multiple of the number of balls, of a
        /// ball p cage orders are added. Pure thrust gives lines of p = 0 along the axis and p = ±1 across it only.
        beside: i32,
    },
    /// Odd number of halves of the shaft frequency: motion that repeats after two revolutions.
    ShaftHalves(u32),
    /// Odd number of halves of the ball-pass frequency of the outer race: motion that repeats after
    /// two ball passes.
    BallPassHalves {
        /// Bearing, from 0.
        bearing: usize,
        /// Number of halves.
        halves: u32,
    },
    /// k × cage frequency of bearing `bearing`.
    Cage {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
    },
    /// k × meshing frequency of a sprocket and its chain.
    Meshing {
        /// Sprocket, from 0, among the varying loads.
        sprocket: usize,
        /// Multiple.
        multiple: u32,
    },
    /// Natural frequency number `mode` (from 0) of the linearised system.
    Natural {
        /// Mode, from 0, lowest first.
        mode: usize,
        /// How the shaft goes round in it.
        whirl: Whirl,
    },
}

impl LineKind {
    /// Whether pure thrust makes the line along the axis of the shaft, or across it where that is asked for; waves are told
    /// apart by it whose lines have one frequency.
    pub(super) fn is_of_wave(self, along: bool) -> bool {
        match self {
            Self::Waviness { beside, .. } => beside.abs() == i32::from(!along),
            _ => false,
        }
    }

    /// Rank of simplicity: where several causes fit equally well, the lowest one names the line.
    pub(super) fn rank(self) -> (u32, u32) {
        match self {
            Self::ShaftOrder(order) => (0, order),
            Self::Waviness { beside, .. } => match beside {
                -1..=1 => (1, 0),
                _ => (12, beside.unsigned_abs()),
            },
            Self::Meshing { multiple, .. } => (2, multiple),
            Self::BallPassOuter {
                multiple,
                sideband: 0,
                ..
            } => (3, multiple),
            Self::BallPassInner {
                multiple,
                sideband: 0,
                ..
            } => (4, multiple),
            Self::Natural { mode, .. } => (5, mode as u32),
            Self::Cage { multiple, .. } => (6, multiple),
            Self::ShaftHalves(halves) => (7, halves),
            Self::BallPassHalves { halves, .. } => (8, halves),
            Self::BallPassOuter {
                multiple, sideband, ..
            } => (9, multiple + sideband.unsigned_abs()),
            Self::BallPassInner {
                multiple, sideband, ..
            } => (10, multiple + sideband.unsigned_abs()),
            Self::BallSpin {
                multiple, sideband, ..
            } => (11, multiple + sideband.unsigned_abs()),
        }
    }
}

/// `1×`, `2×BPFO`, `BPFI − 1×`, `5/2×BPFO`, `cage`, `BSF + 1×cage`, `meshing of sprocket 1`,
/// `natural frequency 1`, `waviness of the outer race, order 17`, `waviness of ball 1, order 4 − 1×cage`; bearings and sprockets after the first by number.
impl fmt::Display for LineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::ShaftOrder(order) => write!(f, "{order}×"),
            Self::BallPassOuter {
                bearing,
                multiple,
                sideband,
            } => write_ball_line(f, "BPFO", [multiple, bearing as u32], sideband, ""),
            Self::BallPassInner {
                bearing,
                multiple,
                sideband,
            } => write_ball_line(f, "BPFI", [multiple, bearing as u32], sideband, ""),
            Self::BallSpin {
                bearing,
                multiple,
                sideband,
            } => write_ball_line(f, "BSF", [multiple, bearing as u32], sideband, "cage"),
            Self::Waviness {
                bearing,
                on,
                order,
                beside,
            } => {
                write!(f, "waviness of {on}")?;
                write_number(f, "bearing", bearing as u32)?;
                write!(f, ", order {order}")?;
                match on {
                    Surface::Ball(_) => write_sideband(f, beside, "cage"),
                    Surface::Inner | Surface::Outer => Ok(()),
                }
            }
            Self::ShaftHalves(halves) => write!(f, "{halves}/2×"),
            Self::BallPassHalves { bearing, halves } => {
                write!(f, "{halves}/2×BPFO")?;
                write_number(f, "bearing", bearing as u32)
            }
            Self::Cage { bearing, multiple } => {
                write_ball_line(f, "cage", [multiple, bearing as u32], 0, "")
            }
            Self::Meshing { sprocket, multiple } => {
                write_multiple(f, multiple)?;
                write!(f, "meshing")?;
                write_number(f, "sprocket", sprocket as u32)
            }
            Self::Natural { mode, whirl } => {
                write!(f, "natural frequency {}", mode + 1)?;
                match whirl {
                    Whirl::Forward | Whirl::Backward => write!(f, " ({whirl})"),
                    Whirl::Straight | Whirl::Axial => Ok(()),
                }
            }
        }
    }
}

fn write_ball_line(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    [multiple, bearing]: [u32; 2],
    sideband: i32,
    of: &str,
) -> fmt::Result {
    write_multiple(f, multiple)?;
    write!(f, "{name}")?;
    write_number(f, "bearing", bearing)?;
    write_sideband(f, sideband, of)
}

fn write_sideband(f: &mut fmt::Formatter<'_>, sideband: i32, of: &str) -> fmt::Result {
    match sideband {
        0 => Ok(()),
        1.. => write!(f, " + {sideband}×{of}"),
        _ => write!(f, " − {}×{of}", sideband.unsigned_abs()),
    }
}

fn write_multiple(f: &mut fmt::Formatter<'_>, multiple: u32) -> fmt::Result {
    match multiple {
        1 => Ok(()),
        _ => write!(f, "{multiple}×"),
    }
}

fn write_number(f: &mut fmt::Formatter<'_>, what: &str, index: u32) -> fmt::Result {
    match index {
        0 => Ok(()),
        _ => write!(f, " of {what} {}", index + 1),
    }
}
