//! A linearly implicit method for stiff systems: RODAS, order 4(3), L-stable, with dense output.
//!
//! ```text
//! (1/(hγ) − J) k_i = f(t + c_i h, y + Σ a_ij k_j) + Σ c_ij k_j/h + h d_i ∂f/∂t,   i = 1 … 6
//! y₁ = y + Σ a_5j k_j + k_5 + k_6,   error = k_6
//! ```
//!
//! with the exact Jacobian J. Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*,
//! 2nd ed. (1996), sec. IV.7 and the code RODAS, method 1.

use nalgebra::{DMatrix, DVector};

use super::problem::{Control, Problem, STRETCH};
use super::stepper::{MethodStepper, Reached, Start};
use super::{Counters, IntegrateError};

const GAMMA: f64 = 0.25;
const STAGES: usize = 6;

/// Coefficients a_ij of the arguments, zeros at the end of a row left out; the sixth row is the fifth plus k_5.
#[rustfmt::skip]
const ARGUMENT: [&[f64]; 5] = [
    &[],
    &[1.544],
    &[0.946_678_528_081_582_6, 0.255_701_169_898_328_4],
    &[3.314_825_187_068_521, 2.896_124_015_972_201, 0.998_641_913_997_781_7],
    &[1.221_224_509_226_641, 6.019_134_481_288_629, 12.537_083_329_320_87, -0.687_886_036_105_895],
];

/// Coefficients c_ij of the right-hand sides.
#[rustfmt::skip]
const COUPLING: [&[f64]; STAGES] = [
    &[],
    &[-5.6688],
    &[-2.430_093_356_833_875, -0.206_359_915_709_191_5],
    &[-0.107_352_905_815_137_5, -9.594_562_251_023_355, -20.470_286_148_096_16],
    &[7.496_443_313_967_647, -10.246_804_314_643_52, -33.999_903_528_199_05, 11.708_908_932_061_6],
    &[8.083_246_795_921_522, -7.981_132_988_064_893, -31.521_594_328_743_71, 16.319_305_431_231_36,
      -6.058_818_238_834_054],
];

/// Times c_i of the stages in steps.
const NODE: [f64; STAGES] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];
/// Coefficients d_i of the time derivative.
const TIME: [f64; STAGES] = [0.25, -0.1043, 0.1035, -0.036_200_000_000_000_23, 0.0, 0.0];
/// Coefficients of the dense output, orders 2 and 3.
#[rustfmt::skip]
const DENSE: [[f64; 5]; 2] = [
    [10.126_235_083_445_86, -7.487_995_877_610_167, -34.800_918_615_557_47, -7.992_771_707_568_823,
     1.025_137_723_295_662],
    [-0.676_280_339_280_125_3, 6.087_714_651_680_015, 16.430_843_208_924_78, 24.767_225_114_183_86,
     -6.594_389_125_716_872],
];

/// Error allowed in one step, as a part of the error aimed at over the run: local errors add up.
const LOCAL_PART: f64 = 0.4;
/// Order of the method, and the power of the step size that the error estimate falls with.
const ORDER: i32 = 4;

/// The latest step, and how to go on, in scaled states.
pub(super) struct RosenbrockStepper {
    /// Start and end of the latest step, s.
    start: f64,
    time: f64,
    /// Size of the latest step and of the next one, s.
    size: f64,
    next_size: f64,
    /// Time that no step reaches over, s.
    limit: f64,
    /// Scaled states at the start and at the end of the latest step, and the deviation there.
    from: DVector<f64>,
    to: DVector<f64>,
    deviation: Vec<f64>,
    control: Control,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    counters: Counters,
    jacobian: DMatrix<f64>,
    by_time: DVector<f64>,
    /// Stages k_i of the latest trial.
    stages: [DVector<f64>; STAGES],
    /// Room for a state.
    state: Vec<f64>,
}

impl RosenbrockStepper {
    /// Before the first step.
    pub fn new(problem: &Problem<'_>, start: &Start) -> Self {
        let (time, deviation) = (start.time, &start.deviation);
        let states = deviation.len();
        let scaled = DVector::from_column_slice(deviation);
        let scaled = scaled.component_div(&DVector::from_column_slice(&problem.scaling.scale));
        Self {
            start: time,
            time,
            size: 0.0,
            next_size: 0.0,
            limit: time,
            from: scaled.clone(),
            to: scaled,
            deviation: deviation.clone(),
            control: Control::default(),
            fault: false,
            counters: start.counters,
            jacobian: DMatrix::zeros(states, states),
            by_time: DVector::zeros(states),
            stages: std::array::from_fn(|_| DVector::zeros(states)),
            state: deviation.clone(),
        }
    }

    /// Size of the first step, s.
    fn first_size(&mut self, problem: &Problem<'_>) -> f64 {
        let mut slope = vec![0.0; self.deviation.len()];
        problem.write_state(&self.deviation, &mut self.state);
        problem
            .system
            .derivative(self.start, &self.state, &mut slope);
        self.counters.evaluations += 2;
        problem.first_size([self.start, self.limit], &self.deviation, &slope, ORDER)
    }

    /// Takes `∂f/∂y` and `∂f/∂t` at the start of the step, in scaled states.
    fn linearise(&mut self, problem: &Problem<'_>) {
        let (scaling, by_time) = (&problem.scaling, self.by_time.as_mut_slice());
        scaling.write_state(self.from.as_slice(), &mut self.state);
        let system = problem.system;
        system.linearisation(self.start, &self.state, &mut self.jacobian);
        system.rate_by_time(self.start, &self.state, by_time);
        scaling.scale_jacobian(&mut self.jacobian);
        for (rate, scale) in by_time.iter_mut().zip(&scaling.scale) {
            *rate /= scale;
        }
    }

    /// Tries a step; its error over what is allowed.
    fn trial(&mut self, problem: &Problem<'_>) -> f64 {
        let (states, size) = (self.from.len(), self.size);
        // 1/(hγ) − J, factorised once for all stages
        let unity = DMatrix::<f64>::identity(states, states);
        let factors = (unity / (size * GAMMA) - &self.jacobian).lu();
        let mut argument = self.from.clone();
        for stage in 0..STAGES {
            // y + Σ a_ij k_j
            match stage {
                5 => argument += &self.stages[4],
                _ => argument = &self.from + combine(ARGUMENT[stage], &self.stages),
            }
            // what begins at a break is no part of a step that ends there
            let time = (self.start + NODE[stage] * size).min(self.limit.next_down());
            // f + Σ c_ij k_j/h + h d_i ∂f/∂t
            let mut right = combine(COUPLING[stage], &self.stages) / size;
            let (scaling, rate) = (&problem.scaling, self.stages[stage].as_mut_slice());
            scaling.write_state(argument.as_slice(), &mut self.state);
            problem.system.derivative(time, &self.state, rate);
            for (rate, scale) in rate.iter_mut().zip(&scaling.scale) {
                *rate /= scale;
            }
            right += &self.stages[stage];
            right += &self.by_time * (size * TIME[stage]);
            // a singular matrix gives no step: the trial counts as infinitely wrong
            if !factors.solve_mut(&mut right) {
                right.fill(f64::NAN);
            }
            self.stages[stage] = right;
        }
        self.counters.evaluations += STAGES as u64;
        // y₁ = y + Σ a_5j k_j + k_5 + k_6
        self.to = argument + &self.stages[5];
        self.error(LOCAL_PART * problem.settings.tolerance)
    }

    /// Root mean square of the error, which is the last stage, over what is allowed.
    fn error(&self, tolerance: f64) -> f64 {
        let sizes = self.from.iter().zip(self.to.iter());
        let errors = self.stages[STAGES - 1].iter().zip(sizes);
        let sum: f64 = errors
            .map(|(error, (from, to))| {
                let size = from.abs().max(to.abs());
                (error / (tolerance * (1.0 + size))).powi(2)
            })
            .sum();
        let norm = (sum / self.to.len() as f64).sqrt();
        if norm.is_nan() { f64::INFINITY } else { norm }
    }
}

impl MethodStepper for RosenbrockStepper {
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        self.start = self.time;
        self.from.copy_from(&self.to);
        if self.time >= self.limit {
            self.limit = problem.limit_after(self.time);
        }
        if self.next_size == 0.0 {
            self.next_size = self.first_size(problem);
        }
        self.linearise(problem);
        loop {
            problem.check(self.start, self.next_size, &self.counters, self.fault)?;
            let cut = self.start + STRETCH * self.next_size >= self.limit;
            let end = if cut {
                self.limit
            } else {
                self.start + self.next_size
            };
            self.size = end - self.start;
            problem.check_progress([self.start, end], self.size, self.fault)?;
            let error = self.trial(problem);
            if error <= 1.0 {
                let growth = self.control.accepted(error, ORDER);
                if !cut {
                    self.next_size = self.size * growth;
                }
                self.time = end;
                self.deviation = problem.scaling.deviation(self.to.as_slice());
                self.counters.steps += 1;
                self.fault = false;
                return Ok(());
            }
            self.counters.rejected += 1;
            self.fault |= error == f64::INFINITY;
            self.next_size = self.size * self.control.rejected(error, ORDER);
        }
    }

    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
        if time >= self.time {
            problem.write_state(&self.deviation, state);
            return;
        }
        // y₀ (1 − θ) + θ (y₁ + (1 − θ)(d₂ + θ d₃))
        let theta = (time - self.start) / self.size;
        let rest = 1.0 - theta;
        let [second, third] = DENSE.map(|row| combine(&row, &self.stages));
        let bent = (second + third * theta) * rest;
        let scaled = &self.from * rest + (&self.to + bent) * theta;
        problem.scaling.write_state(scaled.as_slice(), state);
    }

    fn reached(&self) -> Reached<'_> {
        Reached {
            time: self.time,
            deviation: &self.deviation,
            step: self.next_size,
            counters: self.counters,
        }
    }
}

/// Σ factor_j k_j of the first stages
fn combine(factors: &[f64], stages: &[DVector<f64>; STAGES]) -> DVector<f64> {
    let mut sum = DVector::zeros(stages[0].len());
    for (factor, stage) in factors.iter().zip(stages) {
        if *factor != 0.0 {
            sum.axpy(*factor, stage, 1.0);
        }
    }
    sum
}
