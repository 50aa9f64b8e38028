//! Natural frequencies over the speed: the Campbell diagram of the linearised rotor.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::numerics::digits::to_digits;
use crate::physics::PER_MINUTE;
use crate::rotor::{Rotor, RotorDefinition, RotorError, Whirl};
use crate::simulate::{Model, Run, RunUp, finer_modes, range_warnings};

pub use super::critical_speeds::CriticalSpeed;
use super::critical_speeds::critical_speeds;
pub use crate::rotor::Mode;

/// A question about natural frequencies over the speed.
#[derive(Debug, Clone, PartialEq)]
pub struct CampbellQuestion {
    /// The shaft; of its speed nothing is used.
    pub rotor: RotorDefinition,
    /// Lowest speed, rad/s, zero or positive.
    pub from: f64,
    /// Highest speed, rad/s, above the lowest.
    pub to: f64,
    /// Number of evenly spaced speeds, at least 2.
    pub count: usize,
    /// Multiples of the shaft's frequency whose crossings are sought, positive.
    pub orders: Vec<f64>,
    /// Frequency up to which branches matter, Hz; none for one and a half times the highest order at the highest speed. A
    /// shaft that bends has modes for it at every speed alike.
    pub highest_frequency: Option<f64>,
}

/// Most speeds of a diagram.
pub const MOST_SPEEDS: usize = 100_000;

/// Speeds of the diagram of a run-up.
const RUN_UP_SPEEDS: usize = 61;

/// Natural frequencies up to the highest speed, where the run is mapped; where there is no diagram the run tells why.
pub(crate) fn along_run_up(model: &Model, run: &mut Run) -> Option<Campbell> {
    let highest = model.rotor.highest_speed();
    let maps = run.maps.as_ref().filter(|_| highest > 0.0)?;
    let orders = maps.tracks.orders.iter();
    let question = CampbellQuestion {
        rotor: model.rotor.clone(),
        from: 0.0,
        to: highest,
        count: RUN_UP_SPEEDS,
        orders: orders.map(|order| order.order).collect(),
        highest_frequency: None,
    };
    let refused = |error| {
        let warning = format!("there is no diagram of natural frequencies: {error}");
        run.warnings.push(warning);
    };
    let found = question.diagram(&NEVER).map_err(refused).ok()?;
    Some(found.up_to(None))
}

/// Highest order times highest speed up to which branches are shown, unless a frequency is asked for, as a factor.
const SHOWN: f64 = 1.5;

/// Frequency of the lowest branch up to which branches are shown at least, as a factor: no diagram is empty.
const LEAST_SHOWN: f64 = 1.25;

/// Frequency up to which branches are shown unless one is asked for, Hz; of a highest speed in rad/s.
fn shown(orders: &[f64], speed: f64) -> f64 {
    SHOWN * orders.iter().copied().fold(1.0, f64::max) * speed / TAU
}

impl Campbell {
    /// Without the branches that are above a frequency in Hz at every speed: one and a half times the highest order at the highest
    /// speed where none is given, and at least a quarter above the lowest branch.
    #[must_use]
    pub fn up_to(mut self, highest: Option<f64>) -> Self {
        let lowest: Vec<f64> = self.branches.iter().map(Branch::lowest_frequency).collect();
        let first = lowest.iter().copied().fold(f64::INFINITY, f64::min);
        let speed = self.speeds.last().copied().unwrap_or(0.0);
        let mut limit = highest.unwrap_or_else(|| shown(&self.orders, speed));
        if first.is_finite() {
            limit = limit.max(LEAST_SHOWN * first);
        }
        let is_kept = |branch: usize| lowest[branch] <= limit;
        self.critical_speeds
            .retain(|critical| is_kept(critical.branch));
        for critical in &mut self.critical_speeds {
            critical.branch = (0..critical.branch).filter(|other| is_kept(*other)).count();
        }
        let mut branch = 0..lowest.len();
        self.branches.retain(|_| branch.next().is_some_and(is_kept));
        self.left_out = lowest.len() - self.branches.len();
        self.highest_frequency = Some(limit);
        self
    }

    /// Largest relative error of the frequency at a critical speed: of the search for it and, of a shaft that bends, of its
    /// reduction; none without a critical speed.
    pub(crate) fn frequency_error(&self) -> Option<f64> {
        let errors = self.critical_speeds.iter().map(CriticalSpeed::error);
        errors.max_by(f64::total_cmp)
    }

    /// Critical speeds of the shaft's own order that a run went through, by speed, those of both whirls of a round shaft once.
    pub(crate) fn passed(&self, run_up: &RunUp) -> Vec<CriticalSpeed> {
        let [lowest, highest] = run_up.speeds;
        let own = self
            .critical_speeds
            .iter()
            .filter(|critical| critical.order == 1.0);
        let mut passed: Vec<_> = own
            .filter(|critical| (lowest..=highest).contains(&critical.speed))
            .copied()
            .collect();
        passed.dedup_by(|next, before| (next.speed / before.speed - 1.0).abs() < SAME);
        passed
    }
}

/// Critical speeds closer than this part of them are one.
const SAME: f64 = 1e-6;

/// A mode followed over the speeds by its shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// The mode at every speed; none where it is overdamped or has become another.
    pub modes: Vec<Option<Mode>>,
}

impl Branch {
    /// Lowest frequency at any speed, Hz.
    fn lowest_frequency(&self) -> f64 {
        let frequencies = self.modes.iter().flatten().map(Mode::damped_frequency);
        frequencies.fold(f64::INFINITY, f64::min)
    }

    /// Frequency at the lowest speed at which it has a mode, Hz.
    fn first_frequency(&self) -> f64 {
        let first = self.modes.iter().flatten().next();
        first.map_or(f64::INFINITY, Mode::damped_frequency)
    }

    /// How the shaft goes round in it at most of its speeds; of as many that where it goes round most clearly.
    pub fn whirl(&self) -> Whirl {
        let known = self.modes.iter().flatten();
        let known: Vec<_> = known
            .map(|mode| (mode.whirl(), mode.forward_share().abs()))
            .collect();
        let often = |whirl: &Whirl| {
            let own = known.iter().filter(|(other, _)| other == whirl);
            let clearest = own.clone().map(|(_, share)| *share).fold(0.0, f64::max);
            (own.count(), clearest)
        };
        let [first, others @ ..] = [
            Whirl::Straight,
            Whirl::Axial,
            Whirl::Backward,
            Whirl::Forward,
        ];
        others
            .into_iter()
            .fold(first, |most, whirl| match often(&whirl) > often(&most) {
                true => whirl,
                false => most,
            })
    }
}

/// Natural frequencies over the speed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Campbell {
    /// The speeds, rad/s, rising.
    pub speeds: Vec<f64>,
    /// Modes that belong together, by their frequency at the lowest speed.
    pub branches: Vec<Branch>,
    /// The orders that were asked for.
    pub orders: Vec<f64>,
    /// Crossings of branches and orders, by speed.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// The least likeness, [`Mode::assurance`], by which two modes were taken for the same.
    pub least_assurance: f64,
    /// What the reader should know, of the highest speed too.
    pub warnings: Vec<String>,
    /// Frequency up to which branches are shown, Hz; none where all are.
    pub highest_frequency: Option<f64>,
    /// Branches above it, which are left out.
    pub left_out: usize,
}

/// Why there is no diagram.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CampbellError {
    /// The range holds no two speeds.
    #[error(
        "a diagram from {} to {} rpm at {count} speeds has no range: give a first speed of zero or more, a higher last one, and \
         at least 2 speeds",
        per_minute(*from),
        per_minute(*to)
    )]
    Range {
        /// First speed, rad/s.
        from: f64,
        /// Last speed, rad/s.
        to: f64,
        /// Number of speeds.
        count: usize,
    },
    /// An order that no frequency has.
    #[error("order {0}: give orders above zero")]
    Order(f64),
    /// The shaft cannot be assembled at a speed.
    #[error("at {} rpm: {source}", per_minute(*speed))]
    Rotor {
        /// The speed, rad/s.
        speed: f64,
        /// Why.
        source: RotorError,
    },
    /// It was to stop.
    #[error("the diagram was stopped before its end")]
    Stopped,
}

/// A speed in rad/s as revolutions per minute, with the digits that people read.
fn per_minute(speed: f64) -> f64 {
    to_digits(speed * PER_MINUTE, 6)
}

/// Whether a diagram from one speed to another in rad/s has a range, and all orders a frequency.
///
/// # Errors
/// `CampbellError::Range` and `CampbellError::Order`.
pub fn check_range(
    [from, to]: [f64; 2],
    count: usize,
    orders: &[f64],
) -> Result<(), CampbellError> {
    let rising = from >= 0.0 && to > from && to.is_finite();
    if !rising || !(2..=MOST_SPEEDS).contains(&count) {
        return Err(CampbellError::Range { from, to, count });
    }
    let wrong = |order: &&f64| !(order.is_finite() && **order > 0.0);
    match orders.iter().find(wrong) {
        Some(order) => Err(CampbellError::Order(*order)),
        None => Ok(()),
    }
}

impl CampbellQuestion {
    /// Linearises the shaft at every speed, about the static equilibrium there, and follows its modes.
    ///
    /// `M q̈ + (C + ωG) q̇ + K q = 0` with K and C of the equilibrium at that speed, cages where they
    /// start; damping of contacts is left out. Modes belong together whose shapes are most alike
    /// ([`Mode::assurance`]); between speeds whose shapes differ too much further ones are put in. A
    /// critical speed is found by a search for the root of `f(ω) − order ω/2π` between two speeds.
    ///
    /// # Errors
    /// [`CampbellError`] where the range is empty, the shaft has no equilibrium at a speed, or `stop` was set.
    pub fn solve(&self, stop: &AtomicBool) -> Result<Campbell, CampbellError> {
        let mut campbell = self.diagram(stop)?;
        let reduced = self.with_modes(stop);
        for critical in &mut campbell.critical_speeds {
            critical.reduction_error = reduced.reduction_error(critical)?;
        }
        let of_range = range_warnings(&self.rotor, [self.from, self.to]);
        campbell.warnings = self.rotor.warnings_with(of_range);
        Ok(campbell)
    }

    /// Critical speeds alone, without the error of the reduction.
    pub(super) fn critical_speeds(
        &self,
        stop: &AtomicBool,
    ) -> Result<Vec<CriticalSpeed>, CampbellError> {
        self.diagram(stop).map(|found| found.critical_speeds)
    }

    /// Branches and critical speeds, without the error of the reduction and warnings.
    fn diagram(&self, stop: &AtomicBool) -> Result<Campbell, CampbellError> {
        check_range([self.from, self.to], self.count, &self.orders)?;
        let speeds = self.speeds();
        let reduced = self.with_modes(stop);
        let (branches, least_assurance) = follow(&reduced, &speeds)?;
        let critical_speeds = critical_speeds(&reduced, &speeds, &branches, &self.orders)?;
        Ok(Campbell {
            speeds,
            branches,
            orders: self.orders.clone(),
            critical_speeds,
            least_assurance,
            warnings: Vec::new(),
            highest_frequency: None,
            left_out: 0,
        })
    }

    /// The shaft with the number of modes for the highest frequency, whatever the speed: by the speed its branches would
    /// jump, and at rest they would be those of too few modes.
    fn with_modes<'a>(&self, stop: &'a AtomicBool) -> Reduced<'a> {
        let fastest = self.rotor.at_constant_speed(self.to);
        let highest = self
            .highest_frequency
            .unwrap_or_else(|| shown(&self.orders, self.to));
        let excitation = fastest.highest_excitation().max(TAU * highest);
        Reduced {
            rotor: self.rotor.with_modes_for(excitation),
            stop,
        }
    }

    fn speeds(&self) -> Vec<f64> {
        let step = (self.to - self.from) / (self.count - 1) as f64;
        let inside = (0..self.count - 1).map(|index| self.from + index as f64 * step);
        inside.chain([self.to]).collect()
    }
}

/// Nobody stops it.
pub(crate) static NEVER: AtomicBool = AtomicBool::new(false);

/// A shaft with a fixed number of modes, which is linearised at one speed after the other.
pub(super) struct Reduced<'a> {
    rotor: RotorDefinition,
    stop: &'a AtomicBool,
}

impl Reduced<'_> {
    /// Modes of the shaft at a speed in rad/s.
    pub(super) fn modes(&self, speed: f64) -> Result<Vec<Mode>, CampbellError> {
        if self.stop.load(Ordering::Relaxed) {
            return Err(CampbellError::Stopped);
        }
        Ok(assembled(&self.rotor.at_constant_speed(speed), speed)?.modes())
    }

    /// Difference of the frequency at a critical speed from the nearest one of a reduction to more modes; none of a rigid
    /// shaft.
    fn reduction_error(&self, critical: &CriticalSpeed) -> Result<Option<f64>, CampbellError> {
        let speed = critical.speed;
        let definition = self.rotor.at_constant_speed(speed);
        let Some(modes) = assembled(&definition, speed)?.bending_modes() else {
            return Ok(None);
        };
        let finer = assembled(
            &definition.with_modes(finer_modes(finer_modes(modes))),
            speed,
        )?
        .modes();
        let difference = |mode: &Mode| (mode.damped_frequency() / critical.frequency - 1.0).abs();
        let alike = finer.iter().filter(|mode| mode.whirl() == critical.whirl);
        Ok(alike.map(difference).min_by(f64::total_cmp))
    }
}

/// The shaft at a speed in rad/s.
fn assembled(definition: &RotorDefinition, speed: f64) -> Result<Rotor, CampbellError> {
    Rotor::assemble(definition).map_err(|source| CampbellError::Rotor { speed, source })
}

/// Shapes more alike than this are surely the same mode.
const SURE: f64 = 0.9;

/// Shapes less alike than this are different modes.
const LEAST: f64 = 0.1;

/// Halvings of the step between two speeds.
const MOST_HALVINGS: u32 = 8;

/// The mode of every branch at one speed.
type Slots = Vec<Option<Mode>>;

/// Follows all modes from the highest speed down, where gyroscopic moments tell them apart best.
///
/// Returns the branches, and the least likeness by which two modes were taken for the same.
fn follow(shaft: &Reduced<'_>, speeds: &[f64]) -> Result<(Vec<Branch>, f64), CampbellError> {
    let mut least = 1.0;
    let mut rows: Vec<Slots> = Vec::with_capacity(speeds.len());
    for (index, speed) in speeds.iter().enumerate().rev() {
        let slots = match rows.last() {
            None => shaft.modes(*speed)?.into_iter().map(Some).collect(),
            Some(above) => {
                let ends = [speeds[index + 1], *speed];
                carry(shaft, above, ends, MOST_HALVINGS, &mut least)?
            }
        };
        rows.push(slots);
    }
    rows.reverse();
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let branch = |branch: usize| {
        let modes = rows.iter().map(|row| row.get(branch).cloned().flatten());
        Branch {
            modes: modes.collect(),
        }
    };
    let mut branches: Vec<Branch> = (0..count).map(branch).collect();
    branches.sort_by(|a, b| a.first_frequency().total_cmp(&b.first_frequency()));
    Ok((branches, least))
}

/// The branches at the second of two speeds, known at the first; in steps where they change much. Notes the `least`
/// likeness of all pairs.
fn carry(
    shaft: &Reduced<'_>,
    known: &Slots,
    [at, to]: [f64; 2],
    halvings: u32,
    least: &mut f64,
) -> Result<Slots, CampbellError> {
    let modes = shaft.modes(to)?;
    let pairs = matches(known, &modes);
    let likeness = pairs.iter().map(|pair| pair.2).fold(1.0, f64::min);
    let lost = pairs.len() < known.iter().flatten().count().min(modes.len());
    if halvings > 0 && (likeness < SURE || lost) {
        let middle = 0.5 * (at + to);
        let between = carry(shaft, known, [at, middle], halvings - 1, least)?;
        return carry(shaft, &between, [middle, to], halvings - 1, least);
    }
    *least = least.min(likeness);
    Ok(placed(known.len(), modes, &pairs))
}

/// Pairs of branch and mode with their likeness, the most alike first, each in one pair only.
fn matches(known: &Slots, modes: &[Mode]) -> Vec<(usize, usize, f64)> {
    let mut all: Vec<(usize, usize, f64)> = Vec::new();
    for (branch, mode) in known.iter().enumerate() {
        let Some(mode) = mode else { continue };
        let others = modes.iter().enumerate();
        all.extend(others.map(|(index, other)| (branch, index, mode.assurance(other))));
    }
    all.sort_by(|a, b| b.2.total_cmp(&a.2));
    let mut pairs: Vec<(usize, usize, f64)> = Vec::new();
    for pair in all {
        let taken = |other: &(usize, usize, f64)| other.0 == pair.0 || other.1 == pair.1;
        if pair.2 >= LEAST && !pairs.iter().any(taken) {
            pairs.push(pair);
        }
    }
    pairs
}

/// The modes at their branches; those that continue none begin new ones.
fn placed(branches: usize, modes: Vec<Mode>, pairs: &[(usize, usize, f64)]) -> Slots {
    let mut slots: Slots = vec![None; branches];
    for (index, mode) in modes.into_iter().enumerate() {
        match pairs.iter().find(|pair| pair.1 == index) {
            Some((branch, ..)) => slots[*branch] = Some(mode),
            None => slots.push(Some(mode)),
        }
    }
    slots
}
