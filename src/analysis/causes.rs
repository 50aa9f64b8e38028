//! The frequencies at which causes would show, and which of them is nearest to a line.

use super::Characteristic;
use super::LineKind;
use crate::bearing::{Imperfections, Surface};
use crate::physics::BallPass;
use crate::rotor::NaturalFrequency;

/// Shaft orders looked for, 1× … this, and multiples of a ball-pass frequency.
const SHAFT_ORDERS: u32 = 20;
/// Multiples of a ball-pass frequency whose sidebands and halves are looked for.
const BALL_PASS_MULTIPLES: u32 = 6;
/// Multiples of a cage frequency looked for.
const CAGE_MULTIPLES: u32 = 3;
/// Multiples of a ball's spin frequency looked for.
const SPIN_MULTIPLES: u32 = 4;
/// The same of balls with dents, even ones beyond [`SPIN_MULTIPLES`]: a dent meets both races in a revolution.
const DENT_MULTIPLES: u32 = 20;
/// Multiples of a meshing frequency looked for.
const MESHING_MULTIPLES: u32 = 8;
/// Shaft orders looked for on either side of a ball-pass line, cage orders beside one of spin.
const SIDEBANDS: i32 = 3;

/// Bins within which a frequency is known that is read off a spectrum, and no better.
pub(super) const BINS_KNOWN: f64 = 0.75;
/// Causes whose distances differ by less than this part of the uncertainty cannot be told apart.
const TIE: f64 = 2.0 / 15.0;
/// Bins between lines that are told apart: the main lobe of the Hann window.
const LOBE_BINS: f64 = 4.0;

/// How exactly a frequency of a spectrum is known. From a width of a bin in Hz: to three quarters of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Precision {
    /// Width of a bin, Hz.
    pub resolution: f64,
    /// How far the frequency may be off, Hz.
    pub uncertainty: f64,
}

impl From<f64> for Precision {
    fn from(resolution: f64) -> Self {
        Self {
            resolution,
            uncertainty: BINS_KNOWN * resolution,
        }
    }
}

impl Precision {
    /// How far from a line a frequency may be to bear its name, Hz; none where such lines stand closer than the
    /// spectrum tells apart, and one of them is near any frequency. A natural frequency is itself an estimate.
    fn reach(&self, line: &Line) -> Option<f64> {
        let apart = LOBE_BINS * self.resolution;
        match line.kind {
            LineKind::Natural { .. } => Some(self.uncertainty.max(BINS_KNOWN * self.resolution)),
            LineKind::ShaftHalves(halves) | LineKind::BallPassHalves { halves, .. } => {
                let spacing = line.frequency / f64::from(halves);
                (spacing >= apart).then_some(self.uncertainty)
            }
            _ => Some(self.uncertainty),
        }
    }

    /// Lines that a frequency may bear the name of, each with its distance, Hz.
    fn near<'a>(&self, frequency: f64, lines: &'a [Line]) -> impl Iterator<Item = (f64, &'a Line)> {
        let precision = *self;
        lines.iter().filter_map(move |line| {
            let distance = (line.frequency - frequency).abs();
            (distance <= precision.reach(line)?).then_some((distance, line))
        })
    }
}

/// A frequency at which a cause would show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The cause.
    pub kind: LineKind,
    /// Its frequency, Hz: that of the motion as it is simulated.
    pub frequency: f64,
    /// Where the same line stands on a bearing whose balls roll at their operating contact angle, Hz;
    /// none for what does not depend on a bearing.
    pub operating: Option<f64>,
}

/// A bearing's ball-pass frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFrequencies {
    /// With the cage as it turns in the simulation, which keeps the nominal contact angle: where its
    /// lines stand in simulated spectra.
    pub simulated: BallPass,
    /// At the mean operating contact angle of the static equilibrium: where they stand on a bearing
    /// whose cage follows its balls.
    pub operating: BallPass,
}

/// Imperfect surfaces of a bearing that make lines of their own.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LineSurfaces {
    /// Number of balls.
    pub balls: u32,
    /// Whether a ball has a dent or waves.
    pub balls_show_spin: bool,
    /// Surfaces with orders of waves around them.
    pub waves: Vec<(Surface, u32)>,
}

impl LineSurfaces {
    /// Of a bearing with so many balls.
    pub fn new(balls: usize, imperfections: &Imperfections) -> Self {
        let is_ball = |on: &Surface| matches!(on, Surface::Ball(_));
        let waves = imperfections.waves.iter();
        let mut waves: Vec<_> = waves.map(|(on, wave)| (*on, wave.order)).collect();
        waves.sort();
        waves.dedup();
        Self {
            balls: balls as u32,
            balls_show_spin: imperfections.defects.iter().any(|own| is_ball(&own.on))
                || waves.iter().any(|(on, _)| is_ball(on)),
            waves,
        }
    }

    /// Lines of waves, with p up to [`SIDEBANDS`]: of n waves around
    ///
    /// ```text
    /// outer race  q Z FTF           inner race  |q Z FTF − n f|     n + p = q Z
    /// a ball      n BSF + p FTF     of even n: odd ones cancel between both races
    /// ```
    fn wave_lines(&self, bearing: usize, own: &BearingFrequencies, shaft: f64) -> Vec<Line> {
        let besides = || -SIDEBANDS..=SIDEBANDS;
        let orders = self.waves.iter();
        let all = orders.flat_map(|&(on, order)| besides().map(move |beside| (on, order, beside)));
        let line = |(on, order, beside): (Surface, u32, i32)| {
            let (n, p) = (f64::from(order), f64::from(beside));
            let passing = order.checked_add_signed(beside)?;
            let is_multiple = passing.is_multiple_of(self.balls);
            let of = |pass: &BallPass| match on {
                Surface::Outer => is_multiple.then_some(f64::from(passing) * pass.cage),
                Surface::Inner => {
                    is_multiple.then_some((f64::from(passing) * pass.cage - n * shaft).abs())
                }
                Surface::Ball(_) => order
                    .is_multiple_of(2)
                    .then_some(n * pass.spin + p * pass.cage),
            };
            Some(Line {
                kind: LineKind::Waviness {
                    bearing,
                    on,
                    order,
                    beside,
                },
                frequency: of(&own.simulated)?,
                operating: of(&own.operating),
            })
        };
        all.filter_map(line).collect()
    }
}

/// What can cause lines, all in Hz.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sources {
    /// Shaft frequency; zero where it stands.
    pub shaft: f64,
    /// Every bearing.
    pub bearings: Vec<BearingFrequencies>,
    /// Imperfect surfaces of every bearing; empty where all are perfect.
    pub surfaces: Vec<LineSurfaces>,
    /// Natural frequencies of the linearised system, lowest first; lines stand at the damped ones.
    pub natural: Vec<NaturalFrequency>,
    /// Meshing frequency of every sprocket.
    pub meshing: Vec<f64>,
}

/// Every line that shaft, bearings, sprockets and natural frequencies can cause.
///
/// Bearings with the ball-pass frequencies of an earlier one add nothing: what they cause bears
/// the earlier one's name.
///
/// The spin of a ball shows by a spot on it. Balls with dents or waves turn as the simulation turns them; on others nothing
/// simulated has a spot, and their lines take the operating contact angle.
///
/// ```
/// use jeffcott::internals::{BearingFrequencies, Sources, causes, nearest_cause};
/// use jeffcott::physics::ball_pass_frequencies;
/// let pass = |gamma| ball_pass_frequencies(100.0 * std::f64::consts::TAU, 9, 1.0, 5.0, gamma);
/// let lines = causes(&Sources {
///     shaft: 100.0,
///     bearings: vec![BearingFrequencies { simulated: pass(0.2), operating: pass(0.19) }],
///     meshing: vec![1900.0],
///     ..Sources::default()
/// });
/// let name = |frequency| nearest_cause(frequency, 1.0, &lines).map(|line| line.kind.to_string());
/// assert_eq!(name(200.1).as_deref(), Some("2×"));
/// assert_eq!(name(620.0).as_deref(), Some("2×BPFO − 1×"));
/// assert_eq!(name(3800.3).as_deref(), Some("2×meshing"));
/// assert_eq!(name(333.0), None);
/// // BPFO at the operating angle: 9 (100/2) (1 − 0.19)
/// let outer = nearest_cause(360.0, 1.0, &lines).unwrap();
/// assert!((outer.operating.unwrap() - 364.5).abs() < 1e-9);
/// ```
pub fn causes(sources: &Sources) -> Vec<Line> {
    let shaft = sources.shaft;
    let orders = (1..=SHAFT_ORDERS).map(|order| {
        let frequency = f64::from(order) * shaft;
        fixed(LineKind::ShaftOrder(order), frequency)
    });
    let halves = odd(SHAFT_ORDERS).map(|halves| {
        let frequency = 0.5 * f64::from(halves) * shaft;
        fixed(LineKind::ShaftHalves(halves), frequency)
    });
    let modes = sources.natural.iter().enumerate().map(|(mode, natural)| {
        let whirl = natural.whirl;
        fixed(LineKind::Natural { mode, whirl }, natural.damped_frequency)
    });
    let meshing = sources.meshing.iter().enumerate();
    let meshing = meshing.flat_map(|(sprocket, frequency)| {
        (1..=MESHING_MULTIPLES).map(move |multiple| {
            let kind = LineKind::Meshing { sprocket, multiple };
            fixed(kind, f64::from(multiple) * frequency)
        })
    });
    let bearings = &sources.bearings;
    let surfaces = |bearing: usize| sources.surfaces.get(bearing);
    let shows_spin = |bearing| surfaces(bearing).is_some_and(|own| own.balls_show_spin);
    let balls = bearings.iter().enumerate();
    let balls = balls
        .filter(|(bearing, own)| shows_spin(*bearing) || !bearings[..*bearing].contains(own))
        .flat_map(|(bearing, own)| bearing_lines(bearing, own, shaft, shows_spin(bearing)));
    let waves = bearings.iter().enumerate().flat_map(|(bearing, own)| {
        surfaces(bearing).map_or_else(Vec::new, |of| of.wave_lines(bearing, own, shaft))
    });
    let all = orders.chain(halves).chain(modes).chain(meshing);
    let mut lines: Vec<Line> = all.chain(balls).chain(waves).collect();
    lines.retain(|line| line.frequency > 0.0);
    lines
}

/// A line that no bearing decides on.
fn fixed(kind: LineKind, frequency: f64) -> Line {
    Line {
        kind,
        frequency,
        operating: None,
    }
}

fn bearing_lines(
    bearing: usize,
    own: &BearingFrequencies,
    shaft: f64,
    shows_spin: bool,
) -> Vec<Line> {
    let largest_spin = if shows_spin {
        DENT_MULTIPLES
    } else {
        SPIN_MULTIPLES
    };
    let spins = multiples(largest_spin)
        .filter(|(multiple, _)| *multiple <= SPIN_MULTIPLES || multiple.is_multiple_of(2));
    let line = |kind, of: &dyn Fn(&BallPass) -> f64| {
        let (simulated, operating) = (of(&own.simulated), of(&own.operating));
        let is_spin = matches!(
            kind,
            LineKind::Bearing {
                of: Characteristic::Spin,
                ..
            }
        );
        Line {
            kind,
            frequency: if is_spin && !shows_spin {
                operating
            } else {
                simulated
            },
            operating: Some(operating),
        }
    };
    let characteristic = |(of, (multiple, sideband)): (Characteristic, (u32, i32))| {
        let kind = LineKind::Bearing {
            bearing,
            of,
            multiple,
            sideband,
        };
        line(kind, &|pass| {
            let [own, beside] = of.frequencies(pass, shaft);
            f64::from(multiple) * own + f64::from(sideband) * beside
        })
    };
    let halves = odd(BALL_PASS_MULTIPLES).map(|halves| {
        let kind = LineKind::BallPassHalves { bearing, halves };
        line(kind, &|pass| 0.5 * f64::from(halves) * pass.outer)
    });
    let higher = (BALL_PASS_MULTIPLES + 1..=SHAFT_ORDERS).map(|multiple| (multiple, 0));
    let passes = multiples(BALL_PASS_MULTIPLES).chain(higher);
    let races = [Characteristic::OuterRace, Characteristic::InnerRace];
    let passes = passes.flat_map(|number| races.map(|race| (race, number)));
    let spins = spins.map(|number| (Characteristic::Spin, number));
    let cage = (1..=CAGE_MULTIPLES).map(|multiple| (Characteristic::Cage, (multiple, 0)));
    let lines = passes.chain(spins).map(characteristic).chain(halves);
    lines.chain(cage.map(characteristic)).collect()
}

/// Multiples up to `largest`, each with its sidebands.
fn multiples(largest: u32) -> impl Iterator<Item = (u32, i32)> {
    (1..=largest)
        .flat_map(|multiple| (-SIDEBANDS..=SIDEBANDS).map(move |sideband| (multiple, sideband)))
}

/// Odd numbers of halves up to the whole number `largest`.
fn odd(largest: u32) -> impl Iterator<Item = u32> {
    (1..2 * largest).step_by(2)
}

/// The cause nearest to `frequency`, no further than it is known.
///
/// Causes that are equally near are ranked by simplicity: shaft order, waviness under thrust, meshing, ball pass, natural frequency, cage,
/// halves, sidebands.
pub fn nearest_cause(
    frequency: f64,
    precision: impl Into<Precision>,
    causes: &[Line],
) -> Option<Line> {
    let precision = precision.into();
    let near = || precision.near(frequency, causes);
    let nearest = near()
        .map(|(distance, _)| distance)
        .fold(f64::INFINITY, f64::min);
    let tie = nearest + TIE * precision.uncertainty;
    let tied = near().filter(|(distance, _)| *distance <= tie);
    tied.map(|(_, line)| line)
        .min_by_key(|line| line.kind.rank())
        .copied()
}

/// Causes as near to `frequency` as it is known besides the one that names it, nearest first.
pub fn other_causes(
    frequency: f64,
    precision: impl Into<Precision>,
    causes: &[Line],
    named: Option<Line>,
) -> Vec<Line> {
    let precision = precision.into();
    let near = precision.near(frequency, causes);
    let mut others: Vec<_> = near.filter(|(_, line)| named != Some(**line)).collect();
    others.sort_by(|(a, first), (b, second)| {
        let places = a.total_cmp(b);
        places.then_with(|| first.kind.rank().cmp(&second.kind.rank()))
    });
    others.into_iter().map(|(_, line)| *line).collect()
}
