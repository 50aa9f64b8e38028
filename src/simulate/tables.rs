//! Which ball laws a run took from tables, and how often it left them.

use serde::Serialize;

use crate::bearing::{TableError, TableReport};
use crate::keys;
use crate::rotor::{Rotor, Tabulation};

/// The table of one bearing in a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TableUse {
    /// What the table is good for, or why there is none and the exact law was used.
    #[serde(flatten, serialize_with = "keys::or_note")]
    pub table: Result<TableReport, TableError>,
    /// Samples with a ball outside the table, where the exact law was used.
    pub samples_outside: u64,
}

/// Follows the use of tables from sample to sample.
#[derive(Debug)]
pub(super) struct TableAudit {
    tabulations: Vec<Tabulation>,
    outside: Vec<u64>,
}

impl TableAudit {
    pub fn new(tabulations: Vec<Tabulation>) -> Self {
        let outside = vec![0; tabulations.len()];
        Self {
            tabulations,
            outside,
        }
    }

    /// Whether there is any table.
    pub fn is_due(&self) -> bool {
        self.tabulations.iter().any(Option::is_some)
    }

    pub fn sample(&mut self, rotor: &Rotor, time: f64, state: &[f64]) {
        if self.is_due() {
            rotor.count_outside_tables(time, state, &mut self.outside);
        }
    }

    /// What there is of every bearing; none without a table.
    pub fn finish(self) -> Vec<Option<TableUse>> {
        let tables = self.tabulations.into_iter().zip(self.outside);
        tables
            .map(|(table, samples_outside)| {
                table.map(|table| TableUse {
                    table,
                    samples_outside,
                })
            })
            .collect()
    }
}
