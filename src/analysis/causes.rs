//! What a spectral line can be caused by, and which cause is nearest to it.

use std::fmt;

use crate::physics::BallPass;

/// Shaft orders looked for, 1× … this.
const SHAFT_ORDERS: u32 = 20;
/// Multiples of a ball-pass frequency looked for.
const BALL_PASS_MULTIPLES: u32 = 6;
/// Multiples of a cage frequency looked for.
const CAGE_MULTIPLES: u32 = 3;
/// Shaft orders looked for on either side of a ball-pass line.
const SIDEBANDS: i32 = 3;

/// A line this many bins from its cause is still named by it.
const TOLERANCE_BINS: f64 = 0.75;
/// Causes whose distances differ by less than this many bins cannot be told apart.
const TIE_BINS: f64 = 0.1;

/// What a spectral line can be caused by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    /// Natural frequency number `mode` (from 0) of the linearised system.
    Natural {
        /// Mode, from 0, lowest first.
        mode: usize,
    },
}

impl LineKind {
    /// Rank of simplicity: where several causes fit equally well, the lowest one names the line.
    fn rank(self) -> (u32, u32) {
        match self {
            Self::ShaftOrder(order) => (0, order),
            Self::BallPassOuter {
                multiple,
                sideband: 0,
                ..
            } => (1, multiple),
            Self::BallPassInner {
                multiple,
                sideband: 0,
                ..
            } => (2, multiple),
            Self::Natural { mode } => (3, mode as u32),
            Self::Cage { multiple, .. } => (4, multiple),
            Self::ShaftHalves(halves) => (5, halves),
            Self::BallPassHalves { halves, .. } => (6, halves),
            Self::BallPassOuter {
                multiple, sideband, ..
            } => (7, multiple + sideband.unsigned_abs()),
            Self::BallPassInner {
                multiple, sideband, ..
            } => (8, multiple + sideband.unsigned_abs()),
        }
    }
}

/// `1×`, `2×BPFO`, `BPFI − 1×`, `5/2×BPFO`, `cage`, `natural frequency 1`; bearings after the first by number.
impl fmt::Display for LineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::ShaftOrder(order) => write!(f, "{order}×"),
            Self::BallPassOuter {
                bearing,
                multiple,
                sideband,
            } => write_ball_line(f, "BPFO", multiple, sideband, bearing),
            Self::BallPassInner {
                bearing,
                multiple,
                sideband,
            } => write_ball_line(f, "BPFI", multiple, sideband, bearing),
            Self::ShaftHalves(halves) => write!(f, "{halves}/2×"),
            Self::BallPassHalves { bearing, halves } => {
                write!(f, "{halves}/2×BPFO")?;
                write_bearing(f, bearing)
            }
            Self::Cage { bearing, multiple } => write_ball_line(f, "cage", multiple, 0, bearing),
            Self::Natural { mode } => write!(f, "natural frequency {}", mode + 1),
        }
    }
}

fn write_ball_line(
    f: &mut fmt::Formatter<'_>,
    name: &str,
    multiple: u32,
    sideband: i32,
    bearing: usize,
) -> fmt::Result {
    if multiple > 1 {
        write!(f, "{multiple}×")?;
    }
    write!(f, "{name}")?;
    write_bearing(f, bearing)?;
    match sideband {
        0 => Ok(()),
        1.. => write!(f, " + {sideband}×"),
        _ => write!(f, " − {}×", sideband.unsigned_abs()),
    }
}

fn write_bearing(f: &mut fmt::Formatter<'_>, bearing: usize) -> fmt::Result {
    match bearing {
        0 => Ok(()),
        _ => write!(f, " of bearing {}", bearing + 1),
    }
}

/// A frequency at which a cause would show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The cause.
    pub kind: LineKind,
    /// Its frequency, Hz.
    pub frequency: f64,
}

/// Every line that shaft, bearings and natural frequencies can cause, all in Hz.
///
/// Bearings with the ball-pass frequencies of an earlier one add nothing: what they cause bears
/// the earlier one's name.
///
/// ```
/// use jeffcott::analysis::{causes, nearest_cause};
/// use jeffcott::physics::ball_pass_frequencies;
/// let pass = ball_pass_frequencies(100.0 * std::f64::consts::TAU, 9, 1.0, 5.0, 0.2);
/// let lines = causes(100.0, &[pass], &[731.0]);
/// let name = |frequency| nearest_cause(frequency, 1.0, &lines).map(|line| line.kind.to_string());
/// assert_eq!(name(200.1).as_deref(), Some("2×"));
/// assert_eq!(name(620.0).as_deref(), Some("2×BPFO − 1×"));
/// assert_eq!(name(731.2).as_deref(), Some("natural frequency 1"));
/// assert_eq!(name(333.0), None);
/// ```
pub fn causes(shaft_frequency: f64, ball_pass: &[BallPass], natural: &[f64]) -> Vec<Line> {
    let orders = (1..=SHAFT_ORDERS).map(|order| Line {
        kind: LineKind::ShaftOrder(order),
        frequency: f64::from(order) * shaft_frequency,
    });
    let halves = odd(SHAFT_ORDERS).map(|halves| Line {
        kind: LineKind::ShaftHalves(halves),
        frequency: 0.5 * f64::from(halves) * shaft_frequency,
    });
    let modes = natural.iter().enumerate().map(|(mode, frequency)| Line {
        kind: LineKind::Natural { mode },
        frequency: *frequency,
    });
    let balls = ball_pass
        .iter()
        .enumerate()
        .filter(|(bearing, pass)| !ball_pass[..*bearing].contains(pass))
        .flat_map(|(bearing, pass)| bearing_lines(bearing, pass, shaft_frequency));
    let mut lines: Vec<Line> = orders.chain(halves).chain(modes).chain(balls).collect();
    lines.retain(|line| line.frequency > 0.0);
    lines
}

fn bearing_lines(bearing: usize, pass: &BallPass, shaft_frequency: f64) -> Vec<Line> {
    let mut lines = Vec::new();
    for multiple in 1..=BALL_PASS_MULTIPLES {
        for sideband in -SIDEBANDS..=SIDEBANDS {
            let shift = f64::from(sideband) * shaft_frequency;
            lines.push(Line {
                kind: LineKind::BallPassOuter {
                    bearing,
                    multiple,
                    sideband,
                },
                frequency: f64::from(multiple) * pass.outer + shift,
            });
            lines.push(Line {
                kind: LineKind::BallPassInner {
                    bearing,
                    multiple,
                    sideband,
                },
                frequency: f64::from(multiple) * pass.inner + shift,
            });
        }
    }
    lines.extend(odd(BALL_PASS_MULTIPLES).map(|halves| Line {
        kind: LineKind::BallPassHalves { bearing, halves },
        frequency: 0.5 * f64::from(halves) * pass.outer,
    }));
    lines.extend((1..=CAGE_MULTIPLES).map(|multiple| Line {
        kind: LineKind::Cage { bearing, multiple },
        frequency: f64::from(multiple) * pass.cage,
    }));
    lines
}

/// Odd numbers of halves up to the whole number `largest`.
fn odd(largest: u32) -> impl Iterator<Item = u32> {
    (1..2 * largest).step_by(2)
}

/// The cause nearest to `frequency`, no further than three quarters of a bin of `resolution` Hz.
///
/// Causes that are equally near within a tenth of a bin are ranked by simplicity: shaft order,
/// ball pass, natural frequency, cage, halves, sidebands.
pub fn nearest_cause(frequency: f64, resolution: f64, causes: &[Line]) -> Option<Line> {
    let distance = |line: &Line| (line.frequency - frequency).abs();
    let nearest = causes.iter().map(distance).fold(f64::INFINITY, f64::min);
    if nearest > TOLERANCE_BINS * resolution {
        return None;
    }
    let reach = (nearest + TIE_BINS * resolution).min(TOLERANCE_BINS * resolution);
    causes
        .iter()
        .filter(|line| distance(line) <= reach)
        .min_by_key(|line| line.kind.rank())
        .copied()
}
