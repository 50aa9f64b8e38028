//! What a spectral line can be caused by, and how it is called.

use std::fmt;

use crate::bearing::Surface;
use crate::physics::BallPass;
use crate::rotor::Whirl;

/// What a spectral line can be caused by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LineKind {
    /// k × shaft frequency.
    ShaftOrder(u32),
    /// k × a characteristic frequency of a bearing, ± sideband × shaft, beside the spin of a ball × cage.
    Bearing {
        /// Bearing, from 0.
        bearing: usize,
        /// Which frequency.
        of: Characteristic,
        /// Multiple.
        multiple: u32,
        /// Shaft or cage orders added.
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
    /// k × meshing frequency of a sprocket and its chain.
    Meshing {
        /// Sprocket, from 0, among the varying loads.
        sprocket: usize,
        /// Multiple.
        multiple: u32,
    },
    /// k × frequency of a load that vibrates or strikes at equal intervals.
    Load {
        /// Load, from 0, among the varying loads.
        number: usize,
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

/// A characteristic frequency of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Characteristic {
    /// Ball pass at the outer race, BPFO: balls that pass a stationary load.
    OuterRace,
    /// Ball pass at the inner race, BPFI: balls that pass a load which turns with the shaft.
    InnerRace,
    /// Ball spin, BSF: a spot of a ball that meets the races.
    Spin,
    /// The cage.
    Cage,
}

impl Characteristic {
    /// Its frequency and the distance of its sidebands, Hz.
    pub(super) fn frequencies(self, pass: &BallPass, shaft: f64) -> [f64; 2] {
        match self {
            Self::OuterRace => [pass.outer, shaft],
            Self::InnerRace => [pass.inner, shaft],
            Self::Spin => [pass.spin, pass.cage],
            Self::Cage => [pass.cage, shaft],
        }
    }
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

    /// Whether it is the shaft's own line, or a multiple of a ball pass with at most one sideband.
    pub(crate) fn is_main(self) -> bool {
        match self {
            Self::ShaftOrder(order) => order <= 3,
            Self::Bearing { of, sideband, .. } => {
                let is_pass = matches!(of, Characteristic::OuterRace | Characteristic::InnerRace);
                is_pass && sideband.abs() <= 1
            }
            _ => false,
        }
    }

    /// Rank of simplicity: where several causes fit equally well, the lowest one names the line. What the scene is excited by
    /// comes first.
    pub(super) fn rank(self) -> (u32, u32) {
        match self {
            Self::ShaftOrder(1) => (0, 0),
            Self::Load { multiple, .. } | Self::Meshing { multiple, .. } => (1, multiple),
            Self::ShaftOrder(order) => (2, order),
            Self::Waviness { beside, .. } => match beside {
                -1..=1 => (2, 0),
                _ => (12, beside.unsigned_abs()),
            },
            Self::Natural { mode, .. } => (5, mode as u32),
            Self::ShaftHalves(halves) => (7, halves),
            Self::BallPassHalves { halves, .. } => (8, halves),
            Self::Bearing {
                of,
                multiple,
                sideband,
                ..
            } => {
                let rank = match (of, sideband) {
                    (Characteristic::OuterRace, 0) => 3,
                    (Characteristic::InnerRace, 0) => 4,
                    (Characteristic::Cage, _) => 6,
                    (Characteristic::OuterRace, _) => 9,
                    (Characteristic::InnerRace, _) => 10,
                    (Characteristic::Spin, _) => 11,
                };
                (rank, multiple + sideband.unsigned_abs())
            }
        }
    }
}

/// `1×`, `2×BPFO`, `BPFI − 1×`, `5/2×BPFO`, `cage`, `BSF + 1×cage`, `meshing of sprocket 1`, `2×varying load 1`,
/// `natural frequency 1`, `waviness of the outer race, order 17`, `waviness of ball 1, order 4 − 1×cage`; bearings and sprockets after the first by number.
impl fmt::Display for LineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::ShaftOrder(order) => write!(f, "{order}×"),
            Self::Bearing {
                bearing,
                of,
                multiple,
                sideband,
            } => {
                let (name, beside) = match of {
                    Characteristic::OuterRace => ("BPFO", ""),
                    Characteristic::InnerRace => ("BPFI", ""),
                    Characteristic::Spin => ("BSF", "cage"),
                    Characteristic::Cage => ("cage", ""),
                };
                write_multiple(f, multiple)?;
                write!(f, "{name}")?;
                write_number(f, "bearing", bearing as u32)?;
                write_sideband(f, sideband, beside)
            }
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
            Self::Meshing { sprocket, multiple } => {
                write_multiple(f, multiple)?;
                write!(f, "meshing")?;
                write_number(f, "sprocket", sprocket as u32)
            }
            Self::Load { number, multiple } => {
                write_multiple(f, multiple)?;
                write!(f, "varying load {}", number + 1)
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
