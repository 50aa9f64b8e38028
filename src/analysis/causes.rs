//! The frequencies at which causes would show, and which of them is nearest to a line.

use super::Characteristic;
use super::LineKind;
use crate::bearing::{MountedBearing, Support, Surface};
use crate::physics::{BallPass, Race};
use crate::rotor::NaturalFrequency;

/// Shaft orders looked for, 1× … this.
const SHAFT_ORDERS: u32 = 20;
/// Multiples of a ball-pass frequency looked for: a spall rings a housing at several kilohertz, some hundred times the frequency at
/// which balls pass.
const BALL_PASS_ORDERS: u32 = 100;
/// Multiples of a ball-pass frequency whose sidebands and halves are looked for.
const BALL_PASS_MULTIPLES: u32 = 6;
/// Multiples of a cage frequency looked for.
const CAGE_MULTIPLES: u32 = 3;
/// Multiples of a ball's spin frequency looked for, and even ones beyond them: a dent meets both races in a revolution.
const SPIN_MULTIPLES: u32 = 4;
const EVEN_SPIN_MULTIPLES: u32 = 20;
/// Multiples of a meshing frequency looked for, and of the frequency of another load.
const MESHING_MULTIPLES: u32 = 8;
const LOAD_MULTIPLES: u32 = 20;
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
    /// How far from a line a frequency may be to bear its name, Hz; none where such lines are closer than the
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
    /// Where handbooks have the same line, which take the nominal contact angle, Hz; none for what does not depend on a
    /// bearing.
    pub nominal: Option<f64>,
}

/// A bearing's ball-pass frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFrequencies {
    /// With the cage as it turns in the simulation: where its lines are in the spectra.
    pub simulated: BallPass,
    /// At the nominal contact angle, without slip.
    pub nominal: BallPass,
}

/// Imperfect surfaces of a bearing that make lines of their own.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LineSurfaces {
    /// Number of balls.
    pub balls: u32,
    /// Whether a ball has a dent or waves.
    pub balls_show_spin: bool,
    /// Whether balls differ from each other, which go round with the cage.
    pub balls_differ: bool,
    /// Whether what is on a race turns with its ring.
    pub turning: bool,
    /// The ring that turns.
    pub turning_ring: Race,
    /// Surfaces with orders of waves around them.
    pub waves: Vec<(Surface, u32)>,
}

impl LineSurfaces {
    /// Of a bearing with so many balls.
    pub fn new(support: &Support) -> Self {
        let MountedBearing {
            bearing,
            imperfections,
            ..
        } = support.definition();
        let turning = support.surfaces_that_turn();
        let waves = imperfections.waves.iter();
        let mut waves: Vec<_> = waves.map(|(on, wave)| (*on, wave.order)).collect();
        waves.sort();
        waves.dedup();
        Self {
            balls: bearing.geometry.balls() as u32,
            turning_ring: bearing.rotating_ring,
            balls_show_spin: turning.rolling.is_some(),
            balls_differ: turning.balls_differ,
            turning: turning.race,
            waves,
        }
    }

    /// Lines of waves, with p up to [`SIDEBANDS`]: of n waves around
    ///
    /// ```text
    /// standing race  q Z FTF        turning race  |q Z FTF − n f|     n + p = q Z
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
            let turns = on.turns_with(self.turning_ring);
            let of = |pass: &BallPass| match on {
                Surface::Outer | Surface::Inner => {
                    let past = if turns { n * shaft } else { 0.0 };
                    is_multiple.then_some((f64::from(passing) * pass.cage - past).abs())
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
                nominal: of(&own.nominal),
            })
        };
        all.filter_map(line).collect()
    }
}

/// What can cause lines, all in Hz.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sources {
    /// Shaft frequency; zero where it is stationary.
    pub shaft: f64,
    /// Every bearing.
    pub bearings: Vec<BearingFrequencies>,
    /// Imperfect surfaces of every bearing; empty where all are perfect.
    pub surfaces: Vec<LineSurfaces>,
    /// Whether the shaft has an unbalance, which turns with it.
    pub unbalanced: bool,
    /// Natural frequencies of the linearised system, lowest first; lines are at the damped ones.
    pub natural: Vec<NaturalFrequency>,
    /// Meshing frequency of every sprocket.
    pub meshing: Vec<f64>,
    /// Other varying loads that repeat, by their number from 0, and their frequencies.
    pub loads: Vec<(usize, f64)>,
}

/// Every line that shaft, bearings, loads and natural frequencies can cause.
///
/// Perfect bearings of a balanced shaft have lines of balls that pass the standing race, and no other. Orders of the shaft,
/// sidebands by them and balls that pass the turning race need an unbalance or an imperfect race that turns with the shaft; lines
/// of the cage need balls that differ, and those of spin need dents or waves on a ball.
///
/// Bearings with the ball-pass frequencies of an earlier one add nothing where their balls and turning races are perfect: what
/// they cause bears the earlier one's name.
///
/// ```
/// use jeffcott::internals::{BearingFrequencies, Sources, causes, nearest_cause};
/// use jeffcott::physics::ball_pass_frequencies;
/// let pass = |gamma| ball_pass_frequencies(100.0 * std::f64::consts::TAU, 9, 1.0, 5.0, gamma);
/// let lines = causes(&Sources {
///     shaft: 100.0,
///     bearings: vec![BearingFrequencies { simulated: pass(0.2), nominal: pass(0.19) }],
///     meshing: vec![1900.0],
///     unbalanced: true,
///     ..Sources::default()
/// });
/// let name = |frequency| nearest_cause(frequency, 1.0, &lines).map(|line| line.kind.to_string());
/// assert_eq!(name(200.1).as_deref(), Some("2×"));
/// assert_eq!(name(620.0).as_deref(), Some("2×BPFO − 1×"));
/// assert_eq!(name(3800.3).as_deref(), Some("2×meshing"));
/// assert_eq!(name(333.0), None);
/// // BPFO at the nominal angle: 9 (100/2) (1 − 0.19)
/// let outer = nearest_cause(360.0, 1.0, &lines).unwrap();
/// assert!((outer.nominal.unwrap() - 364.5).abs() < 1e-9);
/// ```
pub fn causes(sources: &Sources) -> Vec<Line> {
    let shaft = sources.shaft;
    let surfaces = |bearing: usize| sources.surfaces.get(bearing).cloned().unwrap_or_default();
    let turning = sources.unbalanced || sources.surfaces.iter().any(|own| own.turning);
    let orders = (1..=SHAFT_ORDERS).map(|order| {
        let frequency = f64::from(order) * shaft;
        fixed(LineKind::ShaftOrder(order), frequency)
    });
    let halves = odd(SHAFT_ORDERS).map(|halves| {
        let frequency = 0.5 * f64::from(halves) * shaft;
        fixed(LineKind::ShaftHalves(halves), frequency)
    });
    let orders = orders.chain(halves).filter(|_| turning);
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
    let loads = sources.loads.iter().flat_map(|&(number, frequency)| {
        (1..=LOAD_MULTIPLES).map(move |multiple| {
            let kind = LineKind::Load { number, multiple };
            fixed(kind, f64::from(multiple) * frequency)
        })
    });
    let bearings = &sources.bearings;
    let balls = bearings.iter().enumerate().flat_map(|(bearing, own)| {
        let surfaces = surfaces(bearing);
        let is_first = !bearings[..bearing].contains(own);
        let has_own = is_first || surfaces.turning || surfaces.balls_differ;
        let lines = has_own.then(|| bearing_lines(bearing, own, shaft, &surfaces, turning));
        lines.unwrap_or_default()
    });
    let waves = bearings
        .iter()
        .enumerate()
        .flat_map(|(bearing, own)| surfaces(bearing).wave_lines(bearing, own, shaft));
    let all = orders.chain(modes).chain(meshing).chain(loads);
    let mut lines: Vec<Line> = all.chain(balls).chain(waves).collect();
    lines.retain(|line| line.frequency > 0.0);
    lines
}

/// A line that no bearing decides on.
fn fixed(kind: LineKind, frequency: f64) -> Line {
    Line {
        kind,
        frequency,
        nominal: None,
    }
}

fn bearing_lines(
    bearing: usize,
    own: &BearingFrequencies,
    shaft: f64,
    surfaces: &LineSurfaces,
    turning: bool,
) -> Vec<Line> {
    let line = |kind, of: &dyn Fn(&BallPass) -> f64| Line {
        kind,
        frequency: of(&own.simulated),
        nominal: Some(of(&own.nominal)),
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
    // no ball passes a race that its cage keeps up with
    let has = |of: Characteristic| of.frequencies(&own.simulated, shaft)[0] > 0.0;
    let halves = odd(BALL_PASS_MULTIPLES).map(|halves| {
        let kind = LineKind::BallPassHalves { bearing, halves };
        line(kind, &|pass| 0.5 * f64::from(halves) * pass.outer)
    });
    let standing = match surfaces.turning_ring {
        Race::Inner => Characteristic::OuterRace,
        Race::Outer => Characteristic::InnerRace,
    };
    let halves = halves.filter(|_| has(standing) && standing == Characteristic::OuterRace);
    let higher = (BALL_PASS_MULTIPLES + 1..=BALL_PASS_ORDERS).map(|multiple| (multiple, 0));
    let passes = multiples(BALL_PASS_MULTIPLES).chain(higher);
    let races = [Characteristic::OuterRace, Characteristic::InnerRace];
    let passes = passes.flat_map(|number| races.map(|race| (race, number)));
    let passes = passes.filter(|(race, (_, sideband))| {
        let stationary = *race == standing && *sideband == 0;
        has(*race) && (stationary || turning)
    });
    let spins = multiples(EVEN_SPIN_MULTIPLES)
        .filter(|(multiple, _)| *multiple <= SPIN_MULTIPLES || multiple.is_multiple_of(2))
        .filter(|_| surfaces.balls_show_spin)
        .map(|number| (Characteristic::Spin, number));
    let cage = (1..=CAGE_MULTIPLES)
        .filter(|_| surfaces.balls_differ)
        .map(|multiple| (Characteristic::Cage, (multiple, 0)));
    let lines = passes.chain(spins).chain(cage).map(characteristic);
    lines.chain(halves).collect()
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
