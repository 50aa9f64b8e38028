//! A linearly implicit method for stiff systems: RODAS, order 4(3), L-stable, with dense output.
//!
//! ```text
//! (1/(hγ) − J) k_i = f(t + c_i h, y + Σ a_ij k_j) + Σ c_ij k_j/h + h d_i ∂f/∂t,   i = 1 … 6
//! y₁ = y + Σ a_5j k_j + k_5 + k_6,   error = k_6
//! ```
//!
//! with the exact Jacobian J. Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*,
//! 2nd ed. (1996), sec. IV.7 and the code RODAS, method 1.

use std::sync::atomic::Ordering;

use nalgebra::{DMatrix, DVector};

use super::block::{Block, Outcome};
use super::control::Control;
use super::{Counters, IntegrateError, States};

const GAMMA: f64 = 0.25;
const STAGES: usize = 6;

/// Coefficients a_ij of the arguments; the sixth row is the fifth plus k_5.
const ARGUMENT: [[f64; 4]; 5] = [
    [0.0, 0.0, 0.0, 0.0],
    [1.544, 0.0, 0.0, 0.0],
    [0.946_678_528_081_582_6, 0.255_701_169_898_328_4, 0.0, 0.0],
    [
        3.314_825_187_068_521,
        2.896_124_015_972_201,
        0.998_641_913_997_781_7,
        0.0,
    ],
    [
        1.221_224_509_226_641,
        6.019_134_481_288_629,
        12.537_083_329_320_87,
        -0.687_886_036_105_895,
    ],
];

/// Coefficients c_ij of the right-hand sides.
const COUPLING: [[f64; 5]; STAGES] = [
    [0.0, 0.0, 0.0, 0.0, 0.0],
    [-5.6688, 0.0, 0.0, 0.0, 0.0],
    [
        -2.430_093_356_833_875,
        -0.206_359_915_709_191_5,
        0.0,
        0.0,
        0.0,
    ],
    [
        -0.107_352_905_815_137_5,
        -9.594_562_251_023_355,
        -20.470_286_148_096_16,
        0.0,
        0.0,
    ],
    [
        7.496_443_313_967_647,
        -10.246_804_314_643_52,
        -33.999_903_528_199_05,
        11.708_908_932_061_6,
        0.0,
    ],
    [
        8.083_246_795_921_522,
        -7.981_132_988_064_893,
        -31.521_594_328_743_71,
        16.319_305_431_231_36,
        -6.058_818_238_834_054,
    ],
];

/// Times c_i of the stages in steps.
const NODE: [f64; STAGES] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];
/// Coefficients d_i of the time derivative.
const TIME: [f64; STAGES] = [0.25, -0.1043, 0.1035, -0.036_200_000_000_000_23, 0.0, 0.0];
/// Coefficients of the dense output, orders 2 and 3.
const DENSE: [[f64; 5]; 2] = [
    [
        10.126_235_083_445_86,
        -7.487_995_877_610_167,
        -34.800_918_615_557_47,
        -7.992_771_707_568_823,
        1.025_137_723_295_662,
    ],
    [
        -0.676_280_339_280_125_3,
        6.087_714_651_680_015,
        16.430_843_208_924_78,
        24.767_225_114_183_86,
        -6.594_389_125_716_872,
    ],
];

/// Power of the step size that the error estimate falls with.
const ERROR_POWER: i32 = 4;
/// Part of the step that the error estimate would allow.
const SAFETY: f64 = 0.9;
/// First step in units of the scaling's time, where none is known.
const FIRST_STEP: f64 = 1e-3;

/// Integrates a block from a scaled state.
pub(super) fn integrate(block: &Block<'_>, start: &[f64]) -> Outcome {
    let mut stepper = Stepper::new(block, start);
    let error = stepper.run().err();
    Outcome {
        states: stepper.states,
        end: stepper.state.as_slice().to_vec(),
        last_step: stepper.full_step * block.problem.scaling.time,
        counters: stepper.counters,
        error,
    }
}

/// A block under way, in scaled states and scaled time from the block's start.
struct Stepper<'a> {
    block: &'a Block<'a>,
    time: f64,
    state: DVector<f64>,
    /// Size of the next step, and of the latest one that the end of the block did not cut.
    step: f64,
    full_step: f64,
    control: Control,
    counters: Counters,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    states: States,
    jacobian: DMatrix<f64>,
    by_time: DVector<f64>,
    /// Stages k_i of the latest trial.
    stages: [DVector<f64>; STAGES],
    /// Room for a state.
    room: Vec<f64>,
}

/// An attempted step.
struct Trial {
    end: DVector<f64>,
    /// Error over tolerance; a step is good at 1 or less.
    error: f64,
    dense: [DVector<f64>; 2],
}

impl<'a> Stepper<'a> {
    fn new(block: &'a Block<'a>, start: &[f64]) -> Self {
        let known = block.first_step / block.problem.scaling.time;
        let step = if known > 0.0 { known } else { FIRST_STEP };
        let states = start.len();
        Self {
            block,
            time: 0.0,
            state: DVector::from_column_slice(start),
            step,
            full_step: step,
            control: Control::new(SAFETY),
            counters: Counters::default(),
            fault: false,
            states: States::with_capacity(states, block.intervals),
            jacobian: DMatrix::zeros(states, states),
            by_time: DVector::zeros(states),
            stages: std::array::from_fn(|_| DVector::zeros(states)),
            room: start.to_vec(),
        }
    }

    fn run(&mut self) -> Result<(), IntegrateError> {
        let interval = self.block.interval / self.block.problem.scaling.time;
        let end = interval * self.block.intervals as f64;
        while self.time < end {
            self.check_limits()?;
            let cut = self.time + 1.01 * self.step >= end;
            let size = if cut { end - self.time } else { self.step };
            let trial = self.attempt(size);
            if trial.error <= 1.0 {
                self.counters.steps += 1;
                self.fault = false;
                let growth = self.control.accepted(trial.error, ERROR_POWER);
                let reached = if cut { end } else { self.time + size };
                self.hand_out(&trial, size, reached, interval);
                (self.time, self.state) = (reached, trial.end);
                if !cut {
                    self.step = size * growth;
                    self.full_step = self.step;
                }
            } else {
                self.counters.rejected += 1;
                self.fault |= trial.error == f64::INFINITY;
                self.step = size * self.control.rejected(trial.error, ERROR_POWER);
            }
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), IntegrateError> {
        let problem = &self.block.problem;
        let time = self.seconds(self.time);
        if problem.stop.load(Ordering::Relaxed) {
            return Err(IntegrateError::Interrupted { time });
        }
        if self.counters.steps + self.counters.rejected >= self.block.steps_left {
            let limit = problem.settings.step_limit;
            return Err(IntegrateError::StepLimit { time, limit });
        }
        if self.step <= 10.0 * f64::EPSILON * self.time.max(FIRST_STEP) {
            return Err(if self.fault {
                IntegrateError::NotFinite { time }
            } else {
                let step = self.step * problem.scaling.time;
                IntegrateError::StepUnderflow { time, step }
            });
        }
        Ok(())
    }

    /// Time in s at a scaled time from the block's start.
    fn seconds(&self, time: f64) -> f64 {
        self.block.start + time * self.block.problem.scaling.time
    }

    /// Hands out the grid points within the step that ends at `reached`.
    fn hand_out(&mut self, trial: &Trial, size: f64, reached: f64, interval: f64) {
        while self.states.len() < self.block.intervals {
            let point = interval * self.states.len() as f64;
            if point >= reached {
                return;
            }
            let theta = (point - self.time) / size;
            let rest = 1.0 - theta;
            let bent = (&trial.dense[0] + &trial.dense[1] * theta) * rest;
            let state = &self.state * rest + (&trial.end + bent) * theta;
            self.states.push(state.as_slice());
        }
    }

    /// Takes `∂f/∂y` and `∂f/∂t` in scaled quantities.
    fn linearise(&mut self) {
        let (time, problem) = (self.seconds(self.time), &self.block.problem);
        let scaling = problem.scaling;
        scaling.write_state(self.state.as_slice(), &mut self.room);
        let by_time = self.by_time.as_mut_slice();
        problem
            .system
            .linearisation(time, &self.room, &mut self.jacobian, by_time);
        scaling.scale_jacobian(&mut self.jacobian);
        for (rate, scale) in by_time.iter_mut().zip(&scaling.scale) {
            *rate = *rate * scaling.time * scaling.time / scale;
        }
    }

    fn attempt(&mut self, size: f64) -> Trial {
        self.linearise();
        let states = self.state.len();
        let unity = DMatrix::<f64>::identity(states, states);
        let factors = (unity / (size * GAMMA) - &self.jacobian).lu();
        let mut argument = self.state.clone();
        for stage in 0..STAGES {
            match stage {
                5 => argument += &self.stages[4],
                _ => argument = &self.state + combine(&ARGUMENT[stage], &self.stages),
            }
            let time = self.seconds(self.time + NODE[stage] * size);
            let mut right = combine(&COUPLING[stage], &self.stages) / size;
            let rate = self.stages[stage].as_mut_slice();
            self.block
                .scaled_derivative(time, argument.as_slice(), &mut self.room, rate);
            right += &self.stages[stage];
            right += &self.by_time * (size * TIME[stage]);
            // a singular matrix gives no step: the trial counts as infinitely wrong
            if !factors.solve_mut(&mut right) {
                right.fill(f64::NAN);
            }
            self.stages[stage] = right;
        }
        self.counters.evaluations += STAGES as u64;
        let end = argument + &self.stages[5];
        Trial {
            error: self.error(&end),
            dense: DENSE.map(|row| combine(&row, &self.stages)),
            end,
        }
    }

    /// Root mean square of the error, which is the last stage, over what is allowed.
    fn error(&self, end: &DVector<f64>) -> f64 {
        let tolerance = self.block.local_tolerance();
        let sizes = self.state.iter().zip(end.iter());
        let errors = self.stages[STAGES - 1].iter().zip(sizes);
        let sum: f64 = errors
            .map(|(error, (from, to))| {
                let size = from.abs().max(to.abs());
                (error / (tolerance * (1.0 + size))).powi(2)
            })
            .sum();
        let norm = (sum / end.len() as f64).sqrt();
        if norm.is_nan() { f64::INFINITY } else { norm }
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
