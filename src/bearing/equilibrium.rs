//! Static equilibrium of a shaft on its bearings: damped Newton with the exact Jacobian.

use nalgebra::SVector;

use super::{BearingRotation, Geometry, Matrix5, Support, Vector5};

/// Names of the five freedoms, as they appear in messages and column headers.
pub const FREEDOM_NAMES: [&str; 5] = ["x", "y", "z", "tilt_x", "tilt_y"];

/// Residual that is accepted as equilibrium, relative to the forces in play.
const ACCEPTED_RESIDUAL: f64 = 1e-9;
/// Residual that is round-off: nothing is left to gain.
const CONVERGED: f64 = 1e-14;
/// Round-off of a position between the races, in groove centre distances.
const POSITION_ROUND_OFF: f64 = 16.0 * f64::EPSILON;
/// Newton steps before giving up.
const STEP_LIMIT: usize = 200;
/// Displacement, in groove centre distances, beyond which no ball bearing is in one piece.
const RUNAWAY: f64 = 20.0;

/// Why a load has no static equilibrium.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquilibriumError {
    /// The shaft moves away without meeting resistance.
    #[error(
        "no static equilibrium: the shaft gives way along {freedom} by {displacement:.3e} (m or rad) \
         and {residual:.3e} (N or N m) stay unbalanced; nothing carries the load {load:.3e} there: \
         hold this freedom, add a bearing or a preload, or change the load"
    )]
    NotCarried {
        /// Freedom with the largest unbalanced force.
        freedom: &'static str,
        /// Where it went, m or rad.
        displacement: f64,
        /// Unbalanced force, N or N m.
        residual: f64,
        /// External load along this freedom, N or N m.
        load: f64,
    },
    /// A load or a displacement that is not a number.
    #[error("the load or the start of the search is not finite: {value} along {freedom}")]
    NotFinite {
        /// Freedom.
        freedom: &'static str,
        /// The value.
        value: f64,
    },
}

/// A static problem: what is given of load and displacement.
#[derive(Debug, Clone, Copy)]
pub struct StaticProblem<'a> {
    /// Bearings that carry the shaft.
    pub supports: &'a [Support],
    /// External load, N and N m; of held freedoms it does not matter.
    pub load: Vector5,
    /// Which freedoms find their own place; the others stay at `start`.
    pub free: [bool; 5],
    /// Where the search starts, and where held freedoms stay.
    pub start: Vector5,
    /// Shaft speed, rad/s.
    pub speed: f64,
}

/// A static equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Displacement, m and rad.
    pub displacement: Vector5,
    /// Force of the shaft onto the bearings, N and N m.
    pub force: Vector5,
    /// K = ∂F/∂q, 5×5.
    pub stiffness: Matrix5,
    /// Largest unbalanced force relative to the forces in play, moments by their arm.
    pub residual: f64,
    /// Newton steps taken.
    pub newton_steps: usize,
}

impl StaticProblem<'_> {
    /// Finds the displacement whose force is the load: `F(q) = load` in the free freedoms.
    ///
    /// Newton's step with the exact K is shortened where the force along it overshoots, and turned
    /// towards steepest descent where K is singular (no ball in contact yet). For conservative ball
    /// laws F is the gradient of a convex energy, so this finds the equilibrium from anywhere, if
    /// there is one; it goes on to round-off. Costly ball laws start where plain Hertz contacts
    /// would be in balance.
    ///
    /// # Errors
    /// [`EquilibriumError`] names the freedom that nothing carries.
    pub fn solve(&self) -> Result<Equilibrium, EquilibriumError> {
        self.check_finite()?;
        let (state, newton_steps) = self.newton().map_err(|lost| self.not_carried(&lost))?;
        Ok(state.into_equilibrium(newton_steps))
    }

    /// Newton from a start until the imbalance is below `enough` or at its round-off; the state and
    /// the number of steps, or where it got lost.
    fn newton(&self) -> Result<(State, usize), Box<State>> {
        let mut reach = 0.5 * self.groove_centre_distance();
        let mut state = self.evaluate(self.start);
        for newton_steps in 0..STEP_LIMIT {
            if state.imbalance() <= CONVERGED {
                return Ok((state, newton_steps));
            }
            let (step, shortened) = state.step(reach);
            if shortened {
                reach *= 2.0;
            }
            let next = self.search(&state, &step);
            let gained = next.imbalance() < 0.5 * state.imbalance();
            if state.imbalance() <= ACCEPTED_RESIDUAL && !gained {
                let next_is_better = next.imbalance() < state.imbalance();
                let best = if next_is_better { next } else { state };
                return Ok((best, newton_steps + 1));
            }
            state = next;
            if self.has_run_away(&state) {
                break;
            }
        }
        Err(Box::new(state))
    }

    fn check_finite(&self) -> Result<(), EquilibriumError> {
        for (axis, freedom) in FREEDOM_NAMES.into_iter().enumerate() {
            let load = if self.free[axis] {
                self.load[axis]
            } else {
                0.0
            };
            for value in [load, self.start[axis]] {
                if !value.is_finite() {
                    return Err(EquilibriumError::NotFinite { freedom, value });
                }
            }
        }
        Ok(())
    }

    /// Length that makes tilts comparable to displacements: the farthest groove from the centre.
    fn arm(&self) -> f64 {
        let reach = |support: &Support| {
            let definition = support.definition();
            definition.bearing.geometry.inner_groove_radius() + definition.position.abs()
        };
        self.supports.iter().map(reach).fold(0.0, f64::max)
    }

    fn groove_centre_distance(&self) -> f64 {
        Support::largest(self.supports, Geometry::groove_centre_distance)
    }

    fn evaluate(&self, displacement: Vector5) -> State {
        let lengths = lengths(self.arm());
        let (mut force, mut stiffness) = ([0.0; 5], Matrix5::zeros());
        let mut scale: f64 = 0.0;
        let rotation = BearingRotation::at_start(self.speed);
        for support in self.supports {
            let (share, tangent) = support.force_and_stiffness(&displacement, &rotation);
            stiffness += tangent;
            for axis in 0..5 {
                force[axis] += share[axis];
                scale = scale.max((share[axis] / lengths[axis]).abs());
            }
        }
        let mut excess = Scaled::zeros();
        let mut jacobian = Matrix5::identity();
        for row in (0..5).filter(|&row| self.free[row]) {
            excess[row] = (force[row] - self.load[row]) / lengths[row];
            scale = scale.max((self.load[row] / lengths[row]).abs());
            for column in 0..5 {
                jacobian[(row, column)] = if self.free[column] {
                    stiffness[(row, column)] / (lengths[row] * lengths[column])
                } else {
                    0.0
                };
            }
        }
        let mut state = State {
            displacement,
            force,
            stiffness,
            excess,
            jacobian,
            scale,
            lengths,
            free: self.free,
        };
        // no residual can be told from zero below what round-off of a position makes of it
        let round_off = POSITION_ROUND_OFF * self.groove_centre_distance() * state.free_diagonal();
        state.scale = state.scale.max(round_off / ACCEPTED_RESIDUAL);
        state
    }

    /// The state a step further, or nearer where the force along the step overshoots.
    fn search(&self, state: &State, step: &Scaled) -> State {
        let start_slope = state.excess.dot(step);
        let acceptable = 0.5 * start_slope.abs();
        let mut trial = self.evaluate(state.moved(step, 1.0));
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
            let part = secant.clamp(low + margin, high - margin);
            trial = self.evaluate(state.moved(step, part));
            slope = trial.excess.dot(step);
            if slope > 0.0 {
                (high, high_slope) = (part, slope);
            } else {
                (low, low_slope) = (part, slope);
            }
        }
        trial
    }

    fn has_run_away(&self, state: &State) -> bool {
        let limit = RUNAWAY * self.groove_centre_distance();
        (0..5).any(|axis| {
            let travel = (state.displacement[axis] - self.start[axis]) * state.lengths[axis];
            travel.is_nan() || travel.abs() > limit
        })
    }

    fn not_carried(&self, state: &State) -> EquilibriumError {
        let worst = state.excess.iamax();
        EquilibriumError::NotCarried {
            freedom: FREEDOM_NAMES[worst],
            displacement: state.displacement[worst],
            residual: state.force[worst] - self.load[worst],
            load: self.load[worst],
        }
    }
}

/// Five components in comparable units: forces in N, displacements in m.
type Scaled = SVector<f64, 5>;

fn lengths(arm: f64) -> Vector5 {
    [1.0, 1.0, 1.0, arm, arm]
}

/// One point of the search.
#[derive(Debug, Clone)]
struct State {
    displacement: Vector5,
    force: Vector5,
    stiffness: Matrix5,
    excess: Scaled,
    jacobian: Matrix5,
    scale: f64,
    lengths: Vector5,
    free: [bool; 5],
}

impl State {
    /// Largest unbalanced force relative to the forces in play.
    fn imbalance(&self) -> f64 {
        let largest = self.excess.amax();
        if largest == 0.0 {
            0.0
        } else {
            largest / self.scale
        }
    }

    /// Newton's step, no longer than `reach`, and whether that shortened it.
    fn step(&self, reach: f64) -> (Scaled, bool) {
        let stiffest = self.free_diagonal();
        let mut damping = 0.0;
        for _ in 0..40 {
            let mut matrix = self.jacobian;
            for axis in 0..5 {
                matrix[(axis, axis)] += damping;
            }
            if let Some(step) = matrix.lu().solve(&-self.excess)
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
            damping = f64::max(10.0 * damping, 1e-12 * stiffest);
            if stiffest == 0.0 {
                break;
            }
        }
        // unit first: the norm of a tiny excess would be rounded to zero
        let direction = self.excess / self.excess.amax();
        (direction * (-reach / direction.norm()), true)
    }

    fn free_diagonal(&self) -> f64 {
        (0..5)
            .filter(|&axis| self.free[axis])
            .map(|axis| self.jacobian[(axis, axis)].abs())
            .fold(0.0, f64::max)
    }

    fn moved(&self, step: &Scaled, part: f64) -> Vector5 {
        std::array::from_fn(|axis| self.displacement[axis] + part * step[axis] / self.lengths[axis])
    }

    fn into_equilibrium(self, newton_steps: usize) -> Equilibrium {
        Equilibrium {
            displacement: self.displacement,
            force: self.force,
            stiffness: self.stiffness,
            residual: self.imbalance(),
            newton_steps,
        }
    }
}
