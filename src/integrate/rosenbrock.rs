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

use nalgebra::{Const, SMatrix, SVector};

use super::block::{Block, Outcome};
use super::{Counters, IntegrateError, Linearised, Square};

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

/// Smallest and largest growth of a step, and the safety of its choice.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;
const SAFETY: f64 = 0.9;
/// First step in units of the scaling's time, where none is known.
const FIRST_STEP: f64 = 1e-3;

/// Integrates a block from a scaled state.
pub(super) fn integrate<S, const N: usize>(block: &Block<'_, S, N>, start: &[f64; N]) -> Outcome<N>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    let mut walk = Walk::new(block, start);
    let error = walk.run().err();
    Outcome {
        states: walk.states,
        end: walk.state.into(),
        last_step: walk.full_step * block.scaling.time,
        counters: walk.counters,
        error,
    }
}

/// A block being walked through, in scaled states and scaled time from the block's start.
struct Walk<'a, S, const N: usize> {
    block: &'a Block<'a, S, N>,
    time: f64,
    state: SVector<f64, N>,
    /// Size of the next step, and of the latest one that the end of the block did not cut.
    step: f64,
    full_step: f64,
    counters: Counters,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    states: Vec<[f64; N]>,
}

/// An attempted step.
struct Trial<const N: usize> {
    end: SVector<f64, N>,
    /// Error over tolerance; a step is good at 1 or less.
    error: f64,
    dense: [SVector<f64, N>; 2],
}

impl<'a, S, const N: usize> Walk<'a, S, N>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    fn new(block: &'a Block<'a, S, N>, start: &[f64; N]) -> Self {
        let known = block.first_step / block.scaling.time;
        let step = if known > 0.0 { known } else { FIRST_STEP };
        Self {
            block,
            time: 0.0,
            state: SVector::from(*start),
            step,
            full_step: step,
            counters: Counters::default(),
            fault: false,
            states: Vec::with_capacity(block.intervals),
        }
    }

    fn run(&mut self) -> Result<(), IntegrateError> {
        let interval = self.block.interval / self.block.scaling.time;
        let end = interval * self.block.intervals as f64;
        while self.time < end {
            self.check_limits()?;
            let cut = self.time + 1.01 * self.step >= end;
            let size = if cut { end - self.time } else { self.step };
            let trial = self.attempt(size);
            let growth = (SAFETY * trial.error.powf(-0.25)).clamp(SHRINK, GROW);
            if trial.error <= 1.0 {
                self.counters.steps += 1;
                self.fault = false;
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
                // growth is NaN where the trial was not finite
                self.step = size * if growth < 1.0 { growth } else { SHRINK };
            }
        }
        Ok(())
    }

    fn check_limits(&self) -> Result<(), IntegrateError> {
        let time = self.block.start + self.time * self.block.scaling.time;
        if self.block.stop.load(Ordering::Relaxed) {
            return Err(IntegrateError::Interrupted { time });
        }
        if self.counters.steps + self.counters.rejected >= self.block.steps_left {
            let limit = self.block.settings.step_limit;
            return Err(IntegrateError::StepLimit { time, limit });
        }
        if self.step <= 10.0 * f64::EPSILON * self.time.max(FIRST_STEP) {
            return Err(if self.fault {
                IntegrateError::NotFinite { time }
            } else {
                let step = self.step * self.block.scaling.time;
                IntegrateError::StepUnderflow { time, step }
            });
        }
        Ok(())
    }

    /// Hands out the grid points within the step that ends at `reached`.
    fn hand_out(&mut self, trial: &Trial<N>, size: f64, reached: f64, interval: f64) {
        while self.states.len() < self.block.intervals {
            let point = interval * self.states.len() as f64;
            if point >= reached {
                return;
            }
            let theta = (point - self.time) / size;
            let rest = 1.0 - theta;
            let bent = (trial.dense[0] + trial.dense[1] * theta) * rest;
            let state = self.state * rest + (trial.end + bent) * theta;
            self.states.push(state.into());
        }
    }

    /// Derivative of the scaled state by scaled time.
    fn derivative(&self, time: f64, state: &SVector<f64, N>) -> SVector<f64, N> {
        let scaling = self.block.scaling;
        let mut rate = [0.0; N];
        let physical = scaling.state(state.as_slice());
        let time = self.block.start + time * scaling.time;
        self.block.system.derivative(time, &physical, &mut rate);
        SVector::from_fn(|row, _| rate[row] * (scaling.time / scaling.scale[row]))
    }

    /// `∂f/∂y` and `∂f/∂t` in scaled quantities.
    fn linearisation(&self) -> (SMatrix<f64, N, N>, SVector<f64, N>) {
        let scaling = self.block.scaling;
        let physical = scaling.state(self.state.as_slice());
        let time = self.block.start + self.time * scaling.time;
        let (jacobian, by_time) = self.block.system.linearisation(time, &physical);
        let scaled = SMatrix::from_fn(|row, column| {
            jacobian[(row, column)] * scaling.time * scaling.scale[column] / scaling.scale[row]
        });
        let by_time = SVector::from_fn(|row, _| {
            by_time[row] * scaling.time * scaling.time / scaling.scale[row]
        });
        (scaled, by_time)
    }

    fn attempt(&mut self, size: f64) -> Trial<N> {
        let (jacobian, by_time) = self.linearisation();
        let factors = (SMatrix::<f64, N, N>::identity() / (size * GAMMA) - jacobian).lu();
        let mut stages = [SVector::<f64, N>::zeros(); STAGES];
        let mut argument = self.state;
        for stage in 0..STAGES {
            argument = match stage {
                5 => argument + stages[4],
                _ => self.state + combine(&ARGUMENT[stage], &stages),
            };
            let rate = self.derivative(self.time + NODE[stage] * size, &argument);
            let right =
                rate + combine(&COUPLING[stage], &stages) / size + by_time * (size * TIME[stage]);
            // a singular matrix gives no step: the trial counts as infinitely wrong
            stages[stage] = factors
                .solve(&right)
                .unwrap_or_else(|| SVector::repeat(f64::NAN));
        }
        self.counters.evaluations += STAGES as u64;
        let end = argument + stages[5];
        Trial {
            error: self.error(&end, &stages[5]),
            end,
            dense: DENSE.map(|row| combine(&row, &stages)),
        }
    }

    /// Root mean square of the error over what is allowed.
    fn error(&self, end: &SVector<f64, N>, error: &SVector<f64, N>) -> f64 {
        let tolerance = self.block.local_tolerance();
        let sum: f64 = (0..N)
            .map(|row| {
                let size = self.state[row].abs().max(end[row].abs());
                (error[row] / (tolerance * (1.0 + size))).powi(2)
            })
            .sum();
        let norm = (sum / N as f64).sqrt();
        if norm.is_nan() {
            f64::INFINITY
        } else {
            norm.max(1e-12)
        }
    }
}

/// Σ factor_j k_j
fn combine<const N: usize, const M: usize>(
    factors: &[f64; M],
    stages: &[SVector<f64, N>; STAGES],
) -> SVector<f64, N> {
    let mut sum = SVector::zeros();
    for (factor, stage) in factors.iter().zip(stages) {
        sum += stage * *factor;
    }
    sum
}
