//! Whether the energy of a run adds up.

use crate::rotor::{EnergyBalance, Sample, Works};

/// Account of the energy of a run, J.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyReport {
    /// Kinetic energy at the end less that at the start.
    pub kinetic_change: f64,
    /// Energy stored in the bearings at the end less that at the start.
    pub stored_change: f64,
    /// Whether the work on the bearings is the change of what they store.
    pub conservative: bool,
    /// What was supplied and dissipated.
    pub works: Works,
    /// Largest residual of the balance at any sample: the error of the integration in energy.
    pub largest_residual: f64,
    /// The same relative to the largest term of the balance.
    pub relative_residual: f64,
}

/// Follows the balance from sample to sample.
#[derive(Debug, Default)]
pub(super) struct EnergyAudit {
    first: Option<EnergyBalance>,
    last: EnergyBalance,
    residual: f64,
    largest: f64,
}

impl EnergyAudit {
    pub fn sample(&mut self, sample: &Sample) {
        let Some(balance) = &sample.energy else {
            return;
        };
        let start = self.first.get_or_insert(*balance);
        self.residual = self.residual.max(balance.residual(start).abs());
        self.largest = self.largest.max(balance.largest(start));
        self.last = *balance;
    }

    /// The account; none where no sample had one.
    pub fn finish(self) -> Option<EnergyReport> {
        let (first, last) = (self.first?, self.last);
        Some(EnergyReport {
            kinetic_change: last.kinetic - first.kinetic,
            stored_change: last.stored - first.stored,
            conservative: last.conservative,
            works: last.works,
            largest_residual: self.residual,
            relative_residual: self.residual / self.largest.max(f64::MIN_POSITIVE),
        })
    }
}
