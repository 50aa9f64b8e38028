//! Whether the energy of a run adds up.

use serde::{Serialize, Serializer, ser::SerializeMap};

use crate::keys;
use crate::rotor::{EnergyBalance, Sample, Works};

/// Account of the energy of a run, J.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EnergyReport {
    /// Kinetic energy at the end less that at the start.
    #[serde(rename = "kinetic_change_J")]
    pub kinetic_change: f64,
    /// Energy stored in all that is elastic at the end less that at the start.
    #[serde(rename = "stored_change_J")]
    pub stored_change: f64,
    /// The part of that in shaft, housings and bearings of constant stiffness: all but the ball bearings.
    #[serde(rename = "elastic_change_J")]
    pub elastic_change: f64,
    /// Whether the work on the ball bearings is the change of what they store.
    #[serde(rename = "bearings_have_potential")]
    pub conservative: bool,
    /// What was supplied and dissipated.
    #[serde(flatten, serialize_with = "works")]
    pub(crate) works: Works,
    /// Largest residual of the balance at any sample: the error of the integration in energy.
    #[serde(rename = "largest_residual_J")]
    pub largest_residual: f64,
    /// That residual relative to the largest term of the balance.
    pub relative_residual: f64,
    /// Largest energy that was stored at any sample, of whose round-off no residual can be free.
    #[serde(skip)]
    stored: f64,
}

/// A residual is worth a warning above this part of the energy exchanged, if it is above that of [`STORED`], too.
const EXCHANGED: f64 = 1e-3;
/// Part of the energy stored below which a residual is round-off.
const STORED: f64 = 1e-10;

impl EnergyReport {
    /// What to say of an account that does not close.
    pub(super) fn warning(&self) -> Option<String> {
        let open = self.relative_residual > EXCHANGED;
        (open && self.largest_residual > STORED * self.stored).then(|| {
            format!(
                "the energy does not close: {:.1e} J are missing, {:.1e} of the largest part of the balance; the motion \
                 is not more exact than that: tighten `tolerance` in [integrator]",
                self.largest_residual, self.relative_residual
            )
        })
    }
}

/// Works by who supplies and who dissipates them.
fn works<S: Serializer>(works: &Works, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Side<'a>(#[serde(serialize_with = "keys::by_name")] &'a [(&'a str, f64)]);
    let supplied = [
        ("loads", works.loads),
        ("unbalance", works.unbalance),
        ("rotation", works.rotation),
        ("drive", works.drive),
    ];
    let dissipated = [
        ("viscous_damping", works.viscous),
        ("contact_damping", works.contact),
        ("bearing_friction", works.friction),
        ("load_torque", works.load_torque),
    ];
    let mut map = serializer.serialize_map(None)?;
    map.serialize_entry("supplied_J", &Side(&supplied))?;
    map.serialize_entry("dissipated_J", &Side(&dissipated))?;
    map.serialize_entry("work_on_bearings_J", &works.bearings)?;
    map.end()
}

/// Follows the balance from sample to sample.
#[derive(Debug, Default)]
pub(super) struct EnergyAudit {
    first: Option<EnergyBalance>,
    last: EnergyBalance,
    residual: f64,
    largest: f64,
    stored: f64,
}

impl EnergyAudit {
    pub fn sample(&mut self, sample: &Sample) {
        let Some(balance) = &sample.energy else {
            return;
        };
        let start = self.first.get_or_insert(*balance);
        self.residual = self.residual.max(balance.residual(start).abs());
        self.largest = self.largest.max(balance.largest(start));
        self.stored = self.stored.max(balance.stored.abs());
        self.last = *balance;
    }

    /// The account; none where no sample had one.
    pub fn finish(self) -> Option<EnergyReport> {
        let (first, last) = (self.first?, self.last);
        Some(EnergyReport {
            kinetic_change: last.kinetic - first.kinetic,
            stored_change: last.stored - first.stored,
            elastic_change: last.elastic - first.elastic,
            conservative: last.conservative,
            works: last.works,
            largest_residual: self.residual,
            relative_residual: self.residual / self.largest.max(f64::MIN_POSITIVE),
            stored: self.stored,
        })
    }
}
