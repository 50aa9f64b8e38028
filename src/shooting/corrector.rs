//! Newton's method for a point of a branch: states and parameter in the plane across a direction.
//!
//! ```text
//! ( ∂G/∂u  ∂G/∂p ) (Δu)     (G)
//! (    direction ) (Δp) = − (0)
//! ```

use nalgebra::{DMatrix, DVector};

use super::map::{jacobian, residual};
use super::multipliers::{Crossing, multipliers};
use super::{BranchPoint, Continuation, Image, ReturnMap, ShootingError, Slopes};

/// Corrections of a point before its step is halved.
const MOST_CORRECTIONS: usize = 16;
/// Slopes are renewed, so many times at most, where a correction shrinks by less than this.
const MOST_RENEWALS: usize = 6;
const SLOW: f64 = 0.3;
/// Corrections of so many tolerances that stay as they are count as the error of the integration.
const NOISE: f64 = 300.0;
/// Difference of the parameter over which the map is differenced, as a part of the whole range.
const PARAMETER_STEP: f64 = 1e-5;

/// A point with what it takes to go on.
#[derive(Clone)]
pub(super) struct Node {
    pub point: BranchPoint,
    /// States and parameter.
    pub unknowns: DVector<f64>,
    pub tangent: DVector<f64>,
    /// Slopes of the residual by states and parameter.
    pub slopes: DMatrix<f64>,
    /// Residual after half the period.
    pub half: Option<DVector<f64>>,
    pub corrections: usize,
}

impl Node {
    pub fn crossing(&self) -> Crossing {
        let turning = self.tangent[self.tangent.len() - 1];
        Crossing::from_multipliers(&self.point.multipliers, turning)
    }

    /// Number of multipliers outside the unit circle. Where it stays, a number that jumps means nothing: a pair
    /// outside became two real ones there, or the reverse.
    pub fn outside(&self) -> usize {
        let all = self.point.multipliers.values();
        all.iter().filter(|value| value.norm() >= 1.0).count()
    }
}

/// What follows a branch of a family.
pub(super) struct Continuer<'a> {
    pub family: &'a mut dyn ReturnMap,
    pub plan: &'a Continuation,
}

impl Continuer<'_> {
    /// Corrects a guess in the plane across a direction, with slopes of about there.
    pub fn corrected(
        &mut self,
        mut unknowns: DVector<f64>,
        direction: &DVector<f64>,
        slopes: &DMatrix<f64>,
    ) -> Result<Node, ShootingError> {
        let mut factors = bordered(slopes, direction).lu();
        let (mut history, mut before, mut renewals) = (Vec::new(), f64::INFINITY, 0);
        for corrections in 1..=MOST_CORRECTIONS {
            let residual = self.residual(&unknowns)?;
            history.push(residual.amax());
            let correction = factors
                .solve(&residual.push(0.0))
                .ok_or(ShootingError::Singular)?;
            unknowns -= &correction;
            let size = correction.amax();
            let slow = size > SLOW * before;
            let noise = slow && renewals > 0 && size <= NOISE * self.plan.tolerance;
            if size <= self.plan.tolerance || noise {
                return self.node(unknowns, direction, corrections);
            }
            if !size.is_finite() || (slow && renewals == MOST_RENEWALS) {
                break;
            }
            if slow {
                factors = bordered(&self.slopes_at(&unknowns)?, direction).lu();
                renewals += 1;
            }
            before = size;
        }
        Err(ShootingError::NotFound { history })
    }

    fn residual(&mut self, unknowns: &DVector<f64>) -> Result<DVector<f64>, ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::None)?;
        Ok(residual(self.family, &states, &image.end))
    }

    /// States and their image at a parameter.
    fn image(
        &mut self,
        unknowns: &DVector<f64>,
        slopes: Slopes,
    ) -> Result<(DVector<f64>, Image), ShootingError> {
        let count = unknowns.len() - 1;
        let states = unknowns.rows(0, count).into_owned();
        self.family.set(unknowns[count])?;
        let image = self.family.image(&states, slopes)?;
        Ok((states, image))
    }

    pub fn slopes_at(&mut self, unknowns: &DVector<f64>) -> Result<DMatrix<f64>, ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::All)?;
        self.slopes_from(unknowns, &states, &image)
    }

    /// Slopes of the residual by the states, and by the parameter as a difference.
    fn slopes_from(
        &mut self,
        unknowns: &DVector<f64>,
        states: &DVector<f64>,
        image: &Image,
    ) -> Result<DMatrix<f64>, ShootingError> {
        let by_states = jacobian(self.family, &image.slopes);
        let here = residual(self.family, states, &image.end);
        let mut ahead = unknowns.clone();
        ahead[unknowns.len() - 1] += PARAMETER_STEP;
        let by_parameter = (self.residual(&ahead)? - here) / PARAMETER_STEP;
        let columns = by_states.ncols();
        let mut all = by_states.insert_column(columns, 0.0);
        all.set_column(columns, &by_parameter);
        Ok(all)
    }

    /// Everything about a point of the branch; its tangent goes along `direction`.
    pub fn node(
        &mut self,
        unknowns: DVector<f64>,
        direction: &DVector<f64>,
        corrections: usize,
    ) -> Result<Node, ShootingError> {
        let (states, image) = self.image(&unknowns, Slopes::All)?;
        let half = self.family.half_return(&states)?;
        let multipliers = multipliers(self.family.circle(), &image.slopes);
        let slopes = self.slopes_from(&unknowns, &states, &image)?;
        let ahead = parameter_direction(unknowns.len());
        let tangent = bordered(&slopes, direction).lu().solve(&ahead);
        let tangent = tangent.ok_or(ShootingError::Singular)?;
        Ok(Node {
            point: BranchPoint {
                parameter: unknowns[unknowns.len() - 1],
                states,
                slopes: image.slopes,
                multipliers,
            },
            unknowns,
            tangent: normalised(tangent),
            slopes,
            half,
            corrections,
        })
    }
}

/// The direction of the parameter among so many unknowns.
pub(super) fn parameter_direction(unknowns: usize) -> DVector<f64> {
    let mut direction = DVector::zeros(unknowns);
    direction[unknowns - 1] = 1.0;
    direction
}

/// `⟨a, b⟩`
pub(super) fn product(left: &DVector<f64>, right: &DVector<f64>) -> f64 {
    let states = left.len() - 1;
    let sum: f64 = (0..states).map(|i| left[i] * right[i]).sum();
    sum / states as f64 + left[states] * right[states]
}

pub(super) fn normalised(vector: DVector<f64>) -> DVector<f64> {
    let length = product(&vector, &vector).sqrt();
    vector / length
}

/// Slopes with the row of the plane below them.
fn bordered(slopes: &DMatrix<f64>, direction: &DVector<f64>) -> DMatrix<f64> {
    let states = slopes.nrows();
    let mut all = slopes.clone().insert_row(states, 0.0);
    for column in 0..states {
        all[(states, column)] = direction[column] / states as f64;
    }
    all[(states, states)] = direction[states];
    all
}
