//! Newton's method for states that return.

use nalgebra::{DMatrix, DVector};

use super::factors::Factors;
use super::map::residual;
use super::{MapError, ReturnMap, Slopes};
use crate::integrate::IntegrateError;

/// Corrections before the search is given up.
const MOST_CORRECTIONS: usize = 40;
/// A correction may shrink by no less than this with slopes of an earlier state; else they are renewed.
const SLOW: f64 = 0.2;
/// Halvings of a correction that would lead away.
const MOST_HALVINGS: u32 = 6;
/// Factor by which the residual may grow under a correction.
const LEADS_AWAY: f64 = 2.0;
/// Corrections within which the residual has to fall to half of the least before; else the search goes round in circles.
const PATIENCE: usize = 10;
/// Part of the tolerance that a correction may be foreseen to leave.
pub(super) const LEFT: f64 = 0.1;
/// Corrections of so many tolerances that stay as they are with slopes of the same states are the error
/// of the integration.
const NOISE: f64 = 100.0;

/// States that return.
#[derive(Debug, Clone, PartialEq)]
pub struct Returned {
    /// The states, scaled, one after the other.
    pub states: DVector<f64>,
    /// Residual before every correction, the largest component.
    pub history: Vec<f64>,
    /// Slopes that the last correction rests on.
    pub slopes: Vec<DMatrix<f64>>,
}

/// Why no states that return were found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ShootingError {
    /// The image of states is not known.
    #[error(transparent)]
    Map(#[from] MapError),
    /// Newton's method does not converge.
    #[error("after {} corrections the motion still misses its start by {:.1e} of its size (at best {:.1e})",
        history.len(), history.last().unwrap_or(&f64::NAN), history.iter().copied().fold(f64::INFINITY, f64::min))]
    NotFound {
        /// Residual before every correction.
        history: Vec<f64>,
    },
    /// A neighbouring motion returns as well: a multiplier is 1.
    #[error(
        "a multiplier of the motion is 1 to round-off: it is at a turning point, or is not damped"
    )]
    Singular,
}

impl ShootingError {
    /// Whether somebody asked the integration to stop.
    pub fn is_interrupted(&self) -> bool {
        matches!(
            self,
            Self::Map(MapError::Integrate(IntegrateError::Interrupted { .. }))
        )
    }
}

/// Finds states that return from a first guess, to `tolerance` of the size of the motion.
///
/// Slopes, where some are known of about these states, are kept from one correction to the next as long as corrections
/// shrink fast.
///
/// # Errors
/// [`ShootingError`] where they are not found.
pub fn solve(
    map: &mut dyn ReturnMap,
    guess: DVector<f64>,
    slopes: Option<&[DMatrix<f64>]>,
    tolerance: f64,
) -> Result<Returned, ShootingError> {
    solve_within(map, guess, slopes, tolerance, f64::INFINITY)
}

/// States that return as by [`solve`], but none that a correction larger than `reach` leads to, in units of the states: what is
/// sought there is another motion.
///
/// # Errors
/// [`ShootingError`] where they are not found.
pub fn solve_within(
    map: &mut dyn ReturnMap,
    guess: DVector<f64>,
    slopes: Option<&[DMatrix<f64>]>,
    tolerance: f64,
    reach: f64,
) -> Result<Returned, ShootingError> {
    let mut search = Search {
        states: guess,
        residual: DVector::zeros(0),
        factors: slopes.map(|slopes| Factors::new(map, slopes)),
        slopes: slopes.map_or_else(Vec::new, <[_]>::to_vec),
        asked: Slopes::First,
        history: Vec::new(),
    };
    search.evaluate(map)?;
    // a single one for all nodes that comes from elsewhere may just be an old one
    let mut is_borrowed = slopes.is_some_and(|slopes| slopes.len() < map.circle().nodes());
    let (mut before, mut renewed) = (f64::INFINITY, false);
    while search.history.len() < MOST_CORRECTIONS && !search.is_stuck() {
        // (Φ − shift) Δ = −r, with the slopes Φ of these or of earlier states
        let correction = search.correction(map)?;
        let size = correction.amax();
        if size > reach {
            break;
        }
        let noise = renewed && size > 0.5 * before && size <= NOISE * tolerance;
        if size <= tolerance || noise || leaves(size, before) <= LEFT * tolerance {
            return Ok(Returned {
                states: search.states + correction,
                history: search.history,
                slopes: search.slopes,
            });
        }
        // slopes of earlier states serve as long as corrections shrink fast
        let slow = size > SLOW * before;
        renewed = slow || size > 1.0;
        if slow && !is_borrowed {
            search.asked = Slopes::All;
        }
        is_borrowed &= !slow;
        search.apply(map, &correction, renewed)?;
        before = size;
    }
    Err(ShootingError::NotFound {
        history: search.history,
    })
}

/// What a correction leaves, by how much it is smaller than the one before.
pub(super) fn leaves(size: f64, before: f64) -> f64 {
    match before.is_finite() {
        true => size * (size / before),
        false => size,
    }
}

struct Search {
    states: DVector<f64>,
    residual: DVector<f64>,
    factors: Option<Factors>,
    /// What these are the factors of.
    slopes: Vec<DMatrix<f64>>,
    /// Slopes that the next evaluation asks for where fresh ones are needed: those of one state until they lead too slowly.
    asked: Slopes,
    history: Vec<f64>,
}

impl Search {
    /// Evaluates the residual, with slopes where they are to be renewed.
    fn evaluate(&mut self, map: &mut dyn ReturnMap) -> Result<(), ShootingError> {
        let asked = match self.factors {
            Some(_) => Slopes::None,
            None => self.asked,
        };
        let image = map.image(&self.states, asked)?;
        self.residual = residual(map, &self.states, &image.end);
        if self.factors.is_none() {
            self.factors = Some(Factors::new(map, &image.slopes));
            self.slopes = image.slopes;
        }
        Ok(())
    }

    /// Whether the latest corrections have led nowhere.
    fn is_stuck(&self) -> bool {
        let least = |residuals: &[f64]| residuals.iter().copied().fold(f64::INFINITY, f64::min);
        let (early, late) = self
            .history
            .split_at(self.history.len().saturating_sub(PATIENCE));
        least(late) > 0.5 * least(early)
    }

    fn correction(&mut self, map: &mut dyn ReturnMap) -> Result<DVector<f64>, ShootingError> {
        if self.factors.is_none() {
            self.evaluate(map)?;
        }
        self.history.push(self.residual.amax());
        let factors = self.factors.as_ref().ok_or(ShootingError::Singular)?;
        let solved = factors.solve(map.circle(), &self.residual);
        solved
            .map(|solved| -solved)
            .filter(|correction| correction.iter().all(|part| part.is_finite()))
            .ok_or(ShootingError::Singular)
    }

    /// Applies a correction, or as much of it as does not lead away; slopes are renewed there or kept.
    fn apply(
        &mut self,
        map: &mut dyn ReturnMap,
        correction: &DVector<f64>,
        renewed: bool,
    ) -> Result<(), ShootingError> {
        let (start, before) = (self.states.clone(), self.residual.amax());
        let mut part = 1.0;
        for halving in 0..=MOST_HALVINGS {
            // s + λ Δ, λ = 1, ½, ¼ … until the residual no longer grows
            self.states = &start + correction * part;
            if renewed {
                self.factors = None;
            }
            match self.evaluate(map) {
                Ok(()) if self.residual.amax() <= LEADS_AWAY * before || before < 1e-3 => {
                    return Ok(());
                }
                Err(error) if halving == MOST_HALVINGS => return Err(error),
                _ => part *= 0.5,
            }
        }
        Ok(())
    }
}
