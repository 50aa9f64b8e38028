//! What the force of a bearing costs.

use super::{ContactLaw, Support};

/// Of a ball by each law, s on one core of one server: measured by `benches/right_hand_side`.
const HERTZ: f64 = 4.2e-9;
const HERTZ_FILM: f64 = 65e-9;
const JONES: f64 = 270e-9;
const JONES_FILM: f64 = 630e-9;
const TABLE: f64 = 18e-9;
/// Of the damping of its contacts: two dry Hertz contacts in series, in one pass with their force, and any others.
const HERTZ_DAMPED: f64 = 2.6e-9;
const DAMPED: f64 = 60e-9;

impl Support {
    /// Price of the force at a displacement, s: only ratios are of use on other machines.
    pub(crate) fn price(&self) -> f64 {
        let definition = &self.definition;
        let ball = match (definition.law, definition.oil.is_some()) {
            (ContactLaw::Linear, _) => 0.0,
            (ContactLaw::Hertz, false) => HERTZ,
            _ if self.table.is_some() => TABLE,
            (ContactLaw::Hertz, true) => HERTZ_FILM,
            (ContactLaw::Jones(_), false) => JONES,
            (ContactLaw::Jones(_), true) => JONES_FILM,
        };
        ball * definition.bearing.geometry.balls() as f64
    }

    /// Price of the force against the damping of the contacts, s.
    pub(crate) fn damping_price(&self) -> f64 {
        let definition = &self.definition;
        let ball = match (definition.law, definition.oil.is_some()) {
            _ if self.damped.is_none() => 0.0,
            (ContactLaw::Linear | ContactLaw::Hertz, false) => HERTZ_DAMPED,
            _ => DAMPED,
        };
        ball * definition.bearing.geometry.balls() as f64
    }
}
