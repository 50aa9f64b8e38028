//! Newton's method for a point of a branch: the states u and the parameter p at which the residual G(u, p) of the map
//! vanishes, sought in the plane through a guess normal to a direction d.
//!
//! ```text
//! ( ∂G/∂u  ∂G/∂p ) (Δu)     (G)
//! ( d_u/nU²  d_p ) (Δp) = − (0)
//! ```
//!
//! with n states in units of U, the largest of them: what is the same part of a motion counts the same, however large the
//! motion. The matrix B is that of a point nearby. From each correction Δ to the next it learns from the residual r that is
//! left, `B + r Δᵀ/ΔᵀΔ` (Broyden's method), and it is made anew where corrections shrink slowly.

use nalgebra::{DMatrix, DVector};

use super::map::{jacobian, residual};
use super::multipliers::{Crossing, multipliers};
use super::newton::{LEFT, leaves};
use super::{BranchPoint, Continuation, Image, ReturnMap, ShootingError, Slopes};

/// Most corrections of a guess; a point that needs more is sought again with a shorter step.
const MOST_CORRECTIONS: usize = 16;
/// Most times that the slopes are renewed for one guess.
const MOST_RENEWALS: usize = 6;
/// Slopes are renewed where a correction is more than this part of the one before.
const SLOW: f64 = 0.3;
/// Corrections up to so many tolerances that renewed slopes do not make shrink are noise, the error of the integration: the
/// point is then as good as it gets.
const NOISE: f64 = 300.0;
/// Step of the parameter for the difference taken for ∂G/∂p; the whole range is 1.
const PARAMETER_STEP: f64 = 1e-5;

/// A point of a branch with what it takes to go on to the next.
#[derive(Clone)]
pub(super) struct Node {
    pub point: BranchPoint,
    /// (u, p): states, and the parameter last.
    pub unknowns: DVector<f64>,
    /// Direction of the branch, of length 1 by [`product`] in the unit there.
    pub tangent: DVector<f64>,
    /// (∂G/∂u, ∂G/∂p), one row less than columns.
    pub slopes: DMatrix<f64>,
    /// Residual after half the period, zero where the motion repeats after that already; none where the forcing does not.
    pub half: Option<DVector<f64>>,
    /// Corrections that it took to find.
    pub corrections: usize,
}

impl Node {
    /// The numbers that change their sign where the motion changes its kind.
    pub fn crossing(&self) -> Crossing {
        // dp along the branch, zero at a fold
        let turning = self.tangent[self.tangent.len() - 1];
        Crossing::from_multipliers(&self.point.multipliers, turning)
    }

    /// Number of multipliers outside the unit circle. Between two points with as many, the motion does not change its kind
    /// even if a number of [`Node::crossing`] jumps: a complex pair outside became two real multipliers, or the reverse.
    pub fn outside(&self) -> usize {
        let all = self.point.multipliers.values();
        all.iter().filter(|value| value.norm() >= 1.0).count()
    }
}

/// What follows a branch.
pub(super) struct Continuer<'a> {
    /// The maps at all values of the parameter.
    pub family: &'a mut dyn ReturnMap,
    pub plan: &'a Continuation,
}

impl Continuer<'_> {
    /// Corrects a guess in the plane normal to a direction; `slopes` are those of a point near the guess.
    pub fn corrected(
        &mut self,
        mut unknowns: DVector<f64>,
        direction: &DVector<f64>,
        slopes: &DMatrix<f64>,
    ) -> Result<Node, ShootingError> {
        let unit = unit(&unknowns);
        let mut matrix = bordered(slopes, direction, unit);
        let mut latest: Option<DVector<f64>> = None;
        let (mut history, mut before, mut renewals) = (Vec::new(), f64::INFINITY, 0);
        let mut known = None;
        for corrections in 1..=MOST_CORRECTIONS {
            let residual = match known.take() {
                Some(residual) => residual,
                None => self.residual(&unknowns)?,
            };
            history.push(residual.amax());
            let residual = residual.push(0.0);
            if let Some(correction) = latest.take() {
                matrix -= &residual * correction.transpose() / correction.norm_squared();
            }
            // (Δu, Δp), without its sign
            let correction = matrix.clone().lu().solve(&residual);
            let correction = correction.ok_or(ShootingError::Singular)?;
            unknowns -= &correction;
            let size = correction.amax();
            let is_slow = size > SLOW * before;
            let is_noise = is_slow && renewals > 0 && size <= NOISE * self.plan.tolerance;
            let is_last = leaves(size, before) <= LEFT * self.plan.tolerance;
            if size <= self.plan.tolerance || is_noise || is_last {
                // the corrections leave next to nothing of G, unless the noise of the integration ended them
                let here = (!is_noise).then(|| DVector::zeros(unknowns.len() - 1));
                return self.node(unknowns, here, direction, corrections);
            }
            if !size.is_finite() || (is_slow && renewals == MOST_RENEWALS) {
                break;
            }
            if is_slow {
                let (slopes, residual) = self.slopes_at(&unknowns)?;
                matrix = bordered(&slopes, direction, unit);
                known = Some(residual);
                renewals += 1;
            } else {
                latest = Some(correction);
            }
            before = size;
        }
        Err(ShootingError::NotFound { history })
    }

    /// G(u, p).
    fn residual(&mut self, unknowns: &DVector<f64>) -> Result<DVector<f64>, ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::None)?;
        Ok(residual(self.family, &states, &image.end))
    }

    /// The states u among the unknowns, and their image at the parameter p.
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

    /// (∂G/∂u, ∂G/∂p) at states and a parameter, and G.
    pub fn slopes_at(
        &mut self,
        unknowns: &DVector<f64>,
    ) -> Result<(DMatrix<f64>, DVector<f64>), ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::All)?;
        let here = residual(self.family, &states, &image.end);
        let slopes = self.slopes_from(unknowns, &image.slopes, &here)?;
        Ok((slopes, here))
    }

    /// (∂G/∂u, ∂G/∂p) from the slopes of an image and G; by the parameter as a difference.
    fn slopes_from(
        &mut self,
        unknowns: &DVector<f64>,
        slopes: &[DMatrix<f64>],
        here: &DVector<f64>,
    ) -> Result<DMatrix<f64>, ShootingError> {
        let by_states = jacobian(self.family, slopes);
        let mut ahead = unknowns.clone();
        ahead[unknowns.len() - 1] += PARAMETER_STEP;
        let by_parameter = (self.residual(&ahead)? - here) / PARAMETER_STEP;
        let columns = by_states.ncols();
        let mut all = by_states.insert_column(columns, 0.0);
        all.set_column(columns, &by_parameter);
        Ok(all)
    }

    /// Everything about a point of the branch that was found, with G there if it is known; its tangent has the sense of
    /// `direction`.
    pub fn node(
        &mut self,
        unknowns: DVector<f64>,
        here: Option<DVector<f64>>,
        direction: &DVector<f64>,
        corrections: usize,
    ) -> Result<Node, ShootingError> {
        let (states, image) = self.image(&unknowns, Slopes::Exact)?;
        let half = self.family.half_return(&states)?;
        let multipliers = multipliers(self.family.circle(), &image.slopes);
        // that of the image is of the integration with slopes, and has another error
        let here = match here {
            Some(here) => here,
            None => self.residual(&unknowns)?,
        };
        let slopes = self.slopes_from(&unknowns, &image.slopes, &here)?;
        // the tangent t leaves G at zero, and ⟨d, t⟩ = 1: the last row of the system
        let (last_row, unit) = (parameter_direction(unknowns.len()), unit(&unknowns));
        let tangent = bordered(&slopes, direction, unit).lu().solve(&last_row);
        let tangent = tangent.ok_or(ShootingError::Singular)?;
        Ok(Node {
            point: BranchPoint {
                parameter: unknowns[unknowns.len() - 1],
                states,
                slopes: image.slopes,
                multipliers,
            },
            unknowns,
            tangent: normalised(tangent, unit),
            slopes,
            half,
            corrections,
        })
    }
}

/// The direction (0, …, 0, 1) of the parameter among so many unknowns.
pub(super) fn parameter_direction(unknowns: usize) -> DVector<f64> {
    let mut direction = DVector::zeros(unknowns);
    direction[unknowns - 1] = 1.0;
    direction
}

/// The unit U of the states among the unknowns: the largest of them, but no less than the size of the motion assumed.
pub(super) fn unit(unknowns: &DVector<f64>) -> f64 {
    unknowns.rows(0, unknowns.len() - 1).amax().max(1.0)
}

/// `⟨a, b⟩ = Σ a_i b_i/(n U²) + a_p b_p` over n states and the parameter, so that neither the number of states nor their
/// size outweighs the parameter.
pub(super) fn product(left: &DVector<f64>, right: &DVector<f64>, unit: f64) -> f64 {
    let states = left.len() - 1;
    let sum: f64 = (0..states).map(|i| left[i] * right[i]).sum();
    sum / (states as f64 * unit * unit) + left[states] * right[states]
}

/// A direction with the length 1 by [`product`].
pub(super) fn normalised(vector: DVector<f64>, unit: f64) -> DVector<f64> {
    let length = product(&vector, &vector, unit).sqrt();
    vector / length
}

/// The matrix of Newton's method: (∂G/∂u, ∂G/∂p), and below it the row that makes ⟨d, Δ⟩ of a change Δ.
fn bordered(slopes: &DMatrix<f64>, direction: &DVector<f64>, unit: f64) -> DMatrix<f64> {
    let states = slopes.nrows();
    let mut all = slopes.clone().insert_row(states, 0.0);
    for column in 0..states {
        all[(states, column)] = direction[column] / (states as f64 * unit * unit);
    }
    all[(states, states)] = direction[states];
    all
}
