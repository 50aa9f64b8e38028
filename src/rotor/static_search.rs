//! Damped Newton for the position at which what holds a structure balances its load.

use nalgebra::{DMatrix, DVector};

use super::equilibrium::EquilibriumError;

/// Residual that is accepted as equilibrium, relative to the forces in play.
const ACCEPTED_RESIDUAL: f64 = 1e-9;
/// Residual that is round-off: nothing is left to gain.
const CONVERGED: f64 = 1e-14;
/// Round-off of a position between the races, in groove centre distances.
pub(super) const POSITION_ROUND_OFF: f64 = 16.0 * f64::EPSILON;
/// Newton steps before giving up.
const STEP_LIMIT: usize = 200;
/// Displacement, in groove centre distances, beyond which no ball bearing is in one piece.
const RUNAWAY: f64 = 20.0;

/// What holds a structure at a displacement of its coordinates.
#[derive(Debug, Clone)]
pub(super) struct Restoring {
    /// Force F of the structure onto what holds it, N and N m.
    pub force: DVector<f64>,
    /// K = ∂F/∂q.
    pub stiffness: DMatrix<f64>,
    /// Largest share of one bearing in the force, moments by the coordinate's length, N.
    pub largest_share: f64,
}

/// A coordinate of a structure in a static search.
#[derive(Debug, Clone)]
pub(super) struct StaticCoordinate {
    /// Name in messages.
    pub name: String,
    /// Length that turns it into a displacement, m; 1 of what is one.
    pub length: f64,
    /// External load, N or N m; of held coordinates it does not matter.
    pub load: f64,
    /// Whether it finds its own position; otherwise it stays at `start`.
    pub free: bool,
    /// Where the search starts, m or rad.
    pub start: f64,
}

/// The search for `F(q) = load` in the free coordinates.
pub(super) struct StaticSearch<'a> {
    pub coordinates: Vec<StaticCoordinate>,
    /// Distance of the groove centres of the bearings, m: the unit of their displacements.
    pub length_scale: f64,
    pub restoring: &'a dyn Fn(&[f64]) -> Restoring,
}

impl StaticSearch<'_> {
    /// Finds the displacement whose force is the load.
    ///
    /// Newton's step with the exact K is shortened where the force along it overshoots, and turned
    /// towards steepest descent where K is singular (no ball in contact yet). For conservative ball
    /// laws F is the gradient of a convex energy, so this finds the equilibrium from anywhere, if
    /// there is one; it goes on to round-off.
    ///
    /// # Errors
    /// [`EquilibriumError`] names the coordinate that nothing carries.
    pub fn solve(&self) -> Result<Balance, EquilibriumError> {
        self.check_finite()?;
        self.newton().map_err(|lost| self.not_carried(&lost))
    }

    /// Newton from a start until the residual is below what is accepted and at its round-off, or until it got lost.
    fn newton(&self) -> Result<Balance, Box<Balance>> {
        let mut reach = 0.5 * self.length_scale;
        let start = self.coordinates.iter().map(|coordinate| coordinate.start);
        let mut state = self.evaluate(DVector::from_iterator(self.coordinates.len(), start));
        for newton_steps in 0..STEP_LIMIT {
            if state.relative_residual() <= CONVERGED {
                return Ok(Balance {
                    newton_steps,
                    ..state
                });
            }
            let (step, shortened) = state.step(reach);
            if shortened {
                reach *= 2.0;
            }
            let next = self.search(&state, &step);
            let gained = next.relative_residual() < 0.5 * state.relative_residual();
            if state.relative_residual() <= ACCEPTED_RESIDUAL && !gained {
                let next_is_better = next.relative_residual() < state.relative_residual();
                return Ok(Balance {
                    newton_steps: newton_steps + 1,
                    ..if next_is_better { next } else { state }
                });
            }
            state = next;
            if self.has_run_away(&state) {
                break;
            }
        }
        Err(Box::new(state))
    }

    fn check_finite(&self) -> Result<(), EquilibriumError> {
        let values = self.coordinates.iter().flat_map(|own| {
            let load = if own.free { own.load } else { 0.0 };
            [(own, load), (own, own.start)]
        });
        let mut wrong = values.filter(|(_, value)| !value.is_finite());
        wrong.next().map_or(Ok(()), |(own, value)| {
            let freedom = own.name.clone();
            Err(EquilibriumError::NotFinite { freedom, value })
        })
    }

    fn evaluate(&self, displacement: DVector<f64>) -> Balance {
        let restoring = (self.restoring)(displacement.as_slice());
        let size = displacement.len();
        let mut scale = restoring.largest_share;
        let mut excess = DVector::zeros(size);
        let mut jacobian = DMatrix::identity(size, size);
        let mut stiffest: f64 = 0.0;
        let coordinates = self.coordinates.iter().enumerate();
        let free = coordinates.filter(|(_, own)| own.free);
        for (row, own) in free.clone() {
            excess[row] = (restoring.force[row] - own.load) / own.length;
            scale = scale.max((own.load / own.length).abs());
            for (column, other) in free.clone() {
                let lengths = own.length * other.length;
                jacobian[(row, column)] = restoring.stiffness[(row, column)] / lengths;
            }
            stiffest = stiffest.max(jacobian[(row, row)].abs());
        }
        // no residual can be told from zero below what round-off of a position makes of it
        let round_off = POSITION_ROUND_OFF * self.length_scale * stiffest;
        Balance {
            displacement,
            restoring,
            newton_steps: 0,
            excess,
            jacobian,
            stiffest,
            scale: scale.max(round_off / ACCEPTED_RESIDUAL),
        }
    }

    /// The state a part of a step further.
    fn moved(&self, state: &Balance, step: &DVector<f64>, part: f64) -> Balance {
        let mut displacement = state.displacement.clone();
        for (axis, coordinate) in self.coordinates.iter().enumerate() {
            displacement[axis] += part * step[axis] / coordinate.length;
        }
        self.evaluate(displacement)
    }

    /// The state a step further, or nearer where the force along the step overshoots.
    fn search(&self, state: &Balance, step: &DVector<f64>) -> Balance {
        let start_slope = state.excess.dot(step);
        let acceptable = 0.5 * start_slope.abs();
        let mut trial = self.moved(state, step, 1.0);
        let mut slope = trial.excess.dot(step);
        let (mut low, mut low_slope) = (0.0, start_slope);
        let (mut high, mut high_slope) = (1.0, slope);
        for _ in 0..60 {
            // Short of the minimum along the step is progress; beyond it, only a little is.
            if slope <= acceptable && (high == 1.0 || slope >= -acceptable) {
                break;
            }
            let secant = (high_slope * low - low_slope * high) / (high_slope - low_slope);
            let margin = 0.1 * (high - low);
            // where forces are beyond all numbers there is no secant
            let part = match secant.is_nan() {
                true => 0.5 * (low + high),
                false => secant.clamp(low + margin, high - margin),
            };
            trial = self.moved(state, step, part);
            slope = trial.excess.dot(step);
            if slope > 0.0 {
                (high, high_slope) = (part, slope);
            } else {
                (low, low_slope) = (part, slope);
            }
        }
        trial
    }

    /// How far every coordinate has moved since the start, as displacements, m.
    fn travels(&self, state: &Balance) -> DVector<f64> {
        DVector::from_fn(self.coordinates.len(), |index, _| {
            let coordinate = &self.coordinates[index];
            (state.displacement[index] - coordinate.start) * coordinate.length
        })
    }

    fn has_run_away(&self, state: &Balance) -> bool {
        let limit = RUNAWAY * self.length_scale;
        let travels = self.travels(state);
        travels
            .iter()
            .any(|travel| travel.is_nan() || travel.abs() > limit)
    }

    /// Where the structure ran away, the coordinate that went farthest gave way, and others are out of balance because of
    /// that; else the one with the largest excess.
    fn not_carried(&self, state: &Balance) -> EquilibriumError {
        let worst = match self.has_run_away(state) {
            true => self.travels(state).iamax(),
            false => state.excess.iamax(),
        };
        let coordinate = &self.coordinates[worst];
        EquilibriumError::NotCarried {
            freedom: coordinate.name.clone(),
            displacement: state.displacement[worst],
            residual: state.restoring.force[worst] - coordinate.load,
            load: coordinate.load,
        }
    }
}

/// One point of the search, and where it ends; excess and jacobian in comparable units, N and m, held coordinates at zero.
pub(super) struct Balance {
    /// Displacement, m and rad.
    pub displacement: DVector<f64>,
    /// What holds the structure there.
    pub restoring: Restoring,
    /// Newton steps taken.
    pub newton_steps: usize,
    excess: DVector<f64>,
    jacobian: DMatrix<f64>,
    /// Largest diagonal entry of the free coordinates.
    stiffest: f64,
    /// Forces in play.
    scale: f64,
}

impl Balance {
    /// Largest unbalanced force relative to the forces in play, moments by their length.
    pub fn relative_residual(&self) -> f64 {
        let largest = self.excess.amax();
        if largest == 0.0 {
            0.0
        } else {
            largest / self.scale
        }
    }

    /// Length of the Newton step that is left, m, tilts by their length: the error of the displacement.
    pub fn displacement_error(&self) -> f64 {
        match self.excess.amax() {
            0.0 => 0.0,
            _ => self.step(f64::MAX).0.norm(),
        }
    }

    /// Newton's step, no longer than `reach`, and whether that shortened it.
    fn step(&self, reach: f64) -> (DVector<f64>, bool) {
        let mut damping = 0.0;
        for _ in 0..40 {
            let mut matrix = self.jacobian.clone();
            for axis in 0..self.excess.len() {
                matrix[(axis, axis)] += damping;
            }
            if let Some(step) = matrix.lu().solve(&-&self.excess)
                && step.iter().all(|part| part.is_finite())
                && step.dot(&self.excess) < 0.0
            {
                let length = step.norm();
                return if length > reach {
                    (step * (reach / length), true)
                } else {
                    (step, false)
                };
            }
            damping = f64::max(10.0 * damping, 1e-12 * self.stiffest);
            if self.stiffest == 0.0 {
                break;
            }
        }
        // unit first: the norm of a tiny excess would be rounded to zero
        let direction = &self.excess / self.excess.amax();
        let length = direction.norm();
        (direction * (-reach / length), true)
    }
}
