//! What the force of a bearing costs.

use super::{ContactLaw, Support};

/// Of a bearing, and of a ball by each law, s on one core of one server: measured by `benches/right_hand_side`.
const BEARING: f64 = 22e-9;
const HERTZ: f64 = 1.6e-9;
const HERTZ_FILM: f64 = 62e-9;
const JONES: f64 = 230e-9;
const JONES_FILM: f64 = 560e-9;
const TABLE: f64 = 7e-9;
/// Of the slopes of the force of a ball, beyond the force.
const BALL_SLOPES: f64 = 45e-9;
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
        BEARING + ball * self.balls()
    }

    /// Price of the slopes of the force, s, beyond that of the force itself.
    pub(crate) fn slopes_price(&self) -> f64 {
        match self.definition.law {
            ContactLaw::Linear => 0.0,
            ContactLaw::Hertz | ContactLaw::Jones(_) => BALL_SLOPES * self.balls(),
        }
    }

    /// Price of the force against the damping of the contacts, s.
    pub(crate) fn damping_price(&self) -> f64 {
        let definition = &self.definition;
        let ball = match (definition.law, definition.oil.is_some()) {
            _ if self.damped.is_none() => 0.0,
            (ContactLaw::Linear | ContactLaw::Hertz, false) => HERTZ_DAMPED,
            _ => DAMPED,
        };
        ball * self.balls()
    }

    fn balls(&self) -> f64 {
        self.definition.bearing.geometry.balls() as f64
    }
}
