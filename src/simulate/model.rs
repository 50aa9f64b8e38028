//! The question: what to simulate, how exactly, and what to keep.

use std::f64::consts::TAU;

use super::warnings::assembled_warnings;
use super::{Machine, SimulateError};
use crate::analysis::{SectionKind, SpectrumRequest, Window};
use crate::integrate::Settings;
use crate::rotor::{Rotor, RotorDefinition, check_constraints};

/// How often the motion is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// Samples per shaft revolution, at the highest speed where it varies: the grid is uniform in
    /// time, and at constant speed in shaft angle.
    PerRevolution(u32),
    /// Samples per second.
    Rate(f64),
}

impl Sampling {
    /// Samples a second of a shaft whose highest speed is `highest` rad/s.
    pub fn rate(self, highest: f64) -> f64 {
        match self {
            Self::PerRevolution(samples) => f64::from(samples) * highest / TAU,
            Self::Rate(rate) => rate,
        }
    }
}

/// A complete, checked question: what to simulate, how exactly, and what to keep.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Shaft, bearings, loads, speed and start.
    pub(crate) rotor: RotorDefinition,
    /// Simulated time, s.
    pub(crate) duration: f64,
    /// Time at the start that the spectra leave out, s.
    pub(crate) settle: f64,
    /// Sampling of trace and spectra.
    pub(crate) sampling: Sampling,
    /// Method and tolerance.
    pub(crate) integrator: Settings,
    /// Whether a second, tighter pass measures the error of the first.
    pub(crate) verify: bool,
    /// Whether the energy is accounted for; that of a driven shaft always is.
    pub(crate) energy: bool,
    /// Whether costly ball laws are compiled into tables before the motion starts.
    pub(crate) table: bool,
    /// Window of the spectra; `None` leaves the spectra out.
    pub(crate) spectrum: Option<Window>,
    /// What is made of the samples besides the spectra.
    pub(crate) analyses: Analyses,
    /// Spectra to estimate besides; without any, nothing is recorded for them.
    pub(crate) spectra: Vec<SpectrumRequest>,
}

impl Model {
    /// Number of samples, not rounded.
    pub(crate) fn samples(&self) -> f64 {
        self.duration * self.sampling.rate(self.rotor.highest_speed())
    }

    /// Warnings before anything moves, of its highest speed too.
    ///
    /// # Errors
    /// [`SimulateError`] where no motion can begin.
    pub(crate) fn first_warnings(&self) -> Result<Vec<String>, SimulateError> {
        let rotor = Rotor::assemble(&self.rotor)?;
        let unconstrained = check_constraints(&self.rotor, &rotor)?;
        let of_shaft = assembled_warnings(&self.rotor, &rotor);
        Ok(self
            .rotor
            .warnings_with(unconstrained.into_iter().chain(of_shaft)))
    }
}

/// What is made of the samples. By default all spectra, and all that is observed of the bearings, but neither the
/// kind of the motion nor maps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Analyses {
    /// What is found out of the last whole revolutions after the settle time, where the speed is constant there.
    pub motion: MotionAnalysis,
    /// The machine whose zones of ISO 20816-3 the motion is judged by.
    pub machine: Option<Machine>,
    /// Waterfall and order tracks of the whole run.
    pub maps: bool,
    /// Load zones and lives of the bearings.
    pub loads: bool,
    /// RMS velocities of shaft and housings.
    pub velocities: bool,
    /// Whether the bearings are observed after the settle time only: then no contacts part or meet.
    pub settled_only: bool,
    /// The spectra are those of the displacements alone, up to this order of the shaft; where `None`, all.
    pub highest_order: Option<f64>,
    /// The spectra up to an order are whole, and have their peaks, too.
    pub named_peaks: bool,
    /// Whether lines off their bins let a rectangular window be Hann's.
    pub fits_window: bool,
    /// These spectra are of the forces, too.
    pub force_lines: bool,
}

impl Default for Analyses {
    fn default() -> Self {
        Self {
            motion: MotionAnalysis::None,
            machine: None,
            maps: false,
            loads: true,
            velocities: true,
            settled_only: false,
            highest_order: None,
            named_peaks: false,
            fits_window: false,
            force_lines: false,
        }
    }
}

impl Analyses {
    /// Whether peaks of the spectra are sought and named.
    pub fn has_peaks(&self) -> bool {
        self.highest_order.is_none() || self.named_peaks
    }
}

/// What is found out of a steady motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionAnalysis {
    /// Nothing.
    None,
    /// Statistics and whether they have settled, and the points of a section where one is asked for.
    Statistics(Option<SectionKind>),
    /// These, the points of all sections, and its kind, which rests on them.
    Kind,
}

impl MotionAnalysis {
    /// At least the statistics.
    #[must_use]
    pub fn with_statistics(self) -> Self {
        match self {
            Self::None => Self::Statistics(None),
            more => more,
        }
    }
}
