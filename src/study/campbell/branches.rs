//! Which modes at neighbouring speeds are the same: by their shapes, never by their order.

use super::{Branch, CampbellError, CampbellQuestion};
use crate::rotor::Mode;

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
pub(super) fn follow(
    question: &CampbellQuestion,
    speeds: &[f64],
) -> Result<(Vec<Branch>, f64), CampbellError> {
    let mut walk = Walk {
        question,
        least: 1.0,
    };
    let mut rows: Vec<Slots> = Vec::with_capacity(speeds.len());
    for (index, speed) in speeds.iter().enumerate().rev() {
        let slots = match rows.last() {
            None => question.modes(*speed)?.into_iter().map(Some).collect(),
            Some(above) => walk.carry(above, [speeds[index + 1], *speed], MOST_HALVINGS)?,
        };
        rows.push(slots);
    }
    rows.reverse();
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let mut branches: Vec<Branch> = (0..count)
        .map(|branch| Branch {
            modes: rows
                .iter()
                .map(|row| row.get(branch).cloned().flatten())
                .collect(),
        })
        .collect();
    branches.sort_by(|a, b| lowest(a).total_cmp(&lowest(b)));
    Ok((branches, walk.least))
}

/// Frequency at the lowest speed at which a branch has a mode, Hz.
fn lowest(branch: &Branch) -> f64 {
    let first = branch.modes.iter().flatten().next();
    first.map_or(f64::INFINITY, Mode::damped_frequency)
}

struct Walk<'a> {
    question: &'a CampbellQuestion,
    least: f64,
}

impl Walk<'_> {
    /// The branches at the second of two speeds, known at the first; in steps where they change much.
    fn carry(
        &mut self,
        known: &Slots,
        [at, to]: [f64; 2],
        halvings: u32,
    ) -> Result<Slots, CampbellError> {
        let modes = self.question.modes(to)?;
        let pairs = matches(known, &modes);
        let least = pairs.iter().map(|pair| pair.2).fold(1.0, f64::min);
        let lost = pairs.len() < known.iter().flatten().count().min(modes.len());
        if halvings > 0 && (least < SURE || lost) {
            let middle = 0.5 * (at + to);
            let between = self.carry(known, [at, middle], halvings - 1)?;
            return self.carry(&between, [middle, to], halvings - 1);
        }
        self.least = self.least.min(least);
        Ok(placed(known.len(), modes, &pairs))
    }
}

/// Pairs of branch and mode with their likeness, the most alike first, each in one pair only.
fn matches(known: &Slots, modes: &[Mode]) -> Vec<(usize, usize, f64)> {
    let mut all: Vec<(usize, usize, f64)> = Vec::new();
    for (branch, mode) in known.iter().enumerate() {
        let Some(mode) = mode else { continue };
        let likeness = modes.iter().map(|other| mode.assurance(other));
        all.extend(
            likeness
                .enumerate()
                .map(|(other, like)| (branch, other, like)),
        );
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
