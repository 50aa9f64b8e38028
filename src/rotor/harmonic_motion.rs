//! The motion of a linear rotor under harmonic forces, in closed form.

use nalgebra::{Complex, DMatrix, DVector};

use super::Rotor;
use crate::integrate::System;

/// ```text
/// y(t) = ȳ + Σ_k Re (1, iω_k) q_k e^(iω_k t),   D(ω_k) q_k = f_k
/// ```
///
/// with D the dynamic stiffness at the speed of the shaft. Beside it every motion of the rotor dies out, or grows, as a free
/// vibration `exp(J t)`.
#[derive(Debug, Clone)]
pub(crate) struct HarmonicMotion {
    /// ȳ.
    mean: Vec<f64>,
    /// ω_k in rad/s, and (q_k, iω_k q_k).
    parts: Vec<(f64, DVector<Complex<f64>>)>,
    /// J.
    free: DMatrix<f64>,
}

impl Rotor {
    /// `K_t − ωH` and `C + ωG` of the rotor linearised at its static equilibrium, at a speed ω: with the stiffness of all that
    /// holds it, and the damping of all but the contacts of the balls.
    pub(super) fn linearised(&self, speed: f64) -> [DMatrix<f64>; 2] {
        [
            &self.start.tangent - &self.linear.circulatory.entries * speed,
            self.linear.by_rate(speed) + &self.start.law_damping,
        ]
    }

    /// The forced motion where the rotor is linear, turns at a constant speed and all that drives it are harmonics; none at an
    /// undamped resonance, or where nothing holds it.
    pub(crate) fn harmonic_motion(&self) -> Option<HarmonicMotion> {
        let speed = self.steady_from(0.0).filter(|_| self.is_linear())?;
        let (dofs, states) = (self.dofs(), self.states());
        let mut mean = vec![0.0; states];
        mean[..dofs].copy_from_slice(&self.start.rest[..dofs]);
        let (mut rate, mut free) = (vec![0.0; states], DMatrix::zeros(states, states));
        self.linearisation(0.0, &mean, &mut free);
        self.derivative(0.0, &mean, &mut rate);
        let mut parts = Vec::new();
        for (omega, force) in self.excitation.harmonics(speed, dofs)? {
            let dynamic = self
                .linear
                .dynamic_stiffness(&self.linearised(speed), omega);
            let response = dynamic.lu().solve(&force)?;
            let velocity = &response * Complex::new(0.0, omega);
            let both = response.iter().chain(&velocity).copied();
            parts.push((omega, DVector::from_iterator(states, both)));
            // what is left of the accelerations at rest without the harmonics
            let mut accelerations: Vec<f64> = force.iter().map(|part| part.re).collect();
            self.linear.mass.accelerate(&mut accelerations);
            for (rate, own) in rate[dofs..].iter_mut().zip(accelerations) {
                *rate -= own;
            }
        }
        // J (ȳ − y₀) = −f(y₀)
        let shift = free.clone().lu().solve(&DVector::from_vec(rate))?;
        mean.iter_mut()
            .zip(&shift)
            .for_each(|(mean, shift)| *mean -= shift);
        let motion = HarmonicMotion { mean, parts, free };
        let state = motion.state(0.0);
        state.iter().all(|part| part.is_finite()).then_some(motion)
    }
}

impl HarmonicMotion {
    /// The state at a time in s.
    pub(crate) fn state(&self, time: f64) -> Vec<f64> {
        let mut state = self.mean.clone();
        for (omega, amplitudes) in &self.parts {
            let turned = Complex::from_polar(1.0, omega * time);
            for (state, amplitude) in state.iter_mut().zip(amplitudes) {
                *state += (amplitude * turned).re;
            }
        }
        state
    }

    /// What becomes of a small departure from it in a time in s, `exp(J t)`, by scaling and squaring.
    ///
    /// Source: N. J. Higham, *SIAM J. Matrix Anal. Appl.* 26 (2005) 1179–1193.
    pub(crate) fn departure(&self, time: f64) -> DMatrix<f64> {
        (&self.free * time).exp()
    }
}
