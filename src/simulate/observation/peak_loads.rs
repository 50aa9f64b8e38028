//! The hardest that balls are pressed in a run, and whether Hertz contact still means something there.

use crate::bearing::{BallLine, BallLoads, BearingState, Support};
use crate::rotor::{BallContacts, Rotor};

const RACES: [&str; 2] = ["inner", "outer"];

/// A ball or roller is pressed into its races by more than its radius, which is no contact any more.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "bearing {bearing}: at t = {time:.4e} s a {element} {} {load:.3e} N and its contact gives way by {:.2} mm, more \
     than the radius of the {element}, {:.2} mm: no bearing bears that; check the loads, shocks and base \
     motion of the scenario and their units",
    if *linear { "would carry, where contact = \"linear\" moves the rings to," } else { "carries" },
    1e3 * approach, 1e3 * radius
)]
#[non_exhaustive]
pub struct BeyondContact {
    /// Number of the bearing, from 1.
    pub bearing: usize,
    /// What rolls in it: `ball` or `roller`.
    pub element: &'static str,
    /// Time of the largest load, s.
    pub time: f64,
    /// That load, N.
    pub load: f64,
    /// Approach of ball or roller and race under it, m.
    pub approach: f64,
    /// Radius of the ball or roller, m.
    pub radius: f64,
    /// Whether the bearing is linear and knows no balls: the load is that of Hertz contacts at its displacement.
    pub linear: bool,
}

/// Watches how hard the balls of all bearings of a rotor are pressed.
#[derive(Debug)]
pub(crate) struct PeakWatch<'a> {
    bearings: Vec<(&'a Support, PeakLoads)>,
}

impl<'a> PeakWatch<'a> {
    pub fn new(rotor: &'a Rotor) -> Self {
        let supports = rotor.supports();
        Self {
            bearings: supports
                .map(|support| (support, PeakLoads::default()))
                .collect(),
        }
    }

    /// Room for the balls of a rotor; with their contact angles, too, where a shoulder bounds them.
    pub fn contacts(rotor: &Rotor) -> BallContacts {
        let bounded = |support: &Support| support.definition().bearing.shoulder_angle.is_some();
        match rotor.supports().any(bounded) {
            true => rotor.ball_contacts(),
            false => rotor.ball_loads(),
        }
    }

    /// Takes the balls at a time, s.
    pub fn take(&mut self, time: f64, contacts: &BallContacts) {
        for ((support, peaks), balls) in self.bearings.iter_mut().zip(contacts.bearings()) {
            peaks.take(time, balls, support);
        }
    }

    /// Takes what the balls of linear bearings would bear in a state at a time, s.
    pub fn take_linear(&mut self, rotor: &Rotor, time: f64, state: &[f64]) {
        let approaches = rotor.frozen_approaches(time, state);
        for ((_, peaks), approach) in self.bearings.iter_mut().zip(approaches) {
            raise(&mut peaks.approach, approach.unwrap_or(0.0), time);
        }
    }

    /// What to know of the peaks.
    ///
    /// # Errors
    /// [`BeyondContact`] where a ball is pressed into its races by more than its radius.
    pub fn warnings(&self, rotor: &Rotor) -> Result<Vec<String>, BeyondContact> {
        let states = rotor.bearing_states(rotor.highest_speed());
        let mut warnings = Vec::new();
        for (index, ((support, peaks), state)) in self.bearings.iter().zip(states).enumerate() {
            warnings.extend(peaks.warnings(index + 1, support, &state)?);
        }
        Ok(warnings)
    }
}

/// What the balls of a bearing came to at each race, and when, s.
#[derive(Debug, Default)]
struct PeakLoads {
    /// Largest load, N.
    load: [(f64, f64); 2],
    /// Largest approach that balls would have which a linear law does not know, m.
    approach: (f64, f64),
    /// Farthest reach of a contact ellipse over the shoulder, rad.
    overhang: [(f64, f64); 2],
}

impl PeakLoads {
    fn take(&mut self, time: f64, balls: &BallLoads, support: &Support) {
        for (peak, &load) in self.load.iter_mut().zip(&balls.largest) {
            raise(peak, load, time);
        }
        if support.definition().bearing.shoulder_angle.is_none() {
            return;
        }
        for race in 0..2 {
            let ends = balls.load[race].iter().zip(&balls.angle[race]);
            for (&load, &angle) in ends.filter(|(load, _)| **load > 0.0) {
                let margin = support.shoulder_margin(race, angle, load);
                raise(&mut self.overhang[race], -margin.unwrap_or(0.0), time);
            }
        }
    }

    /// What to know of the peaks in a bearing of a number; nothing where the static equilibrium, whose state is
    /// given, is as hard pressed: that has its own warnings.
    ///
    /// # Errors
    /// [`BeyondContact`] where a ball is pressed into its races by more than its radius.
    fn warnings(
        &self,
        number: usize,
        support: &Support,
        at_rest: &BearingState,
    ) -> Result<Vec<String>, BeyondContact> {
        let linear = support.known_balls() == 0;
        let contacts = support.contacts();
        let permissible = contacts.permissible_pressure();
        let geometry = &support.definition().bearing.geometry;
        let (element, radius) = (geometry.element(), 0.5 * geometry.ball_diameter());
        let mut warnings = Vec::new();
        for race in 0..2 {
            let (load, time) = match linear {
                true => (contacts.load_at(self.approach.0), self.approach.1),
                false => self.load[race],
            };
            let ellipse = contacts.ellipse(race, load);
            if ellipse.approach > radius {
                return Err(BeyondContact {
                    bearing: number,
                    element,
                    time,
                    load,
                    approach: ellipse.approach,
                    radius,
                    linear,
                });
            }
            let there = |ball: &BallLine| [ball.inner, ball.outer][race];
            let mut static_contacts = at_rest.balls.iter().map(there);
            // at rest nothing is said of a linear bearing
            let known = !linear
                && static_contacts
                    .clone()
                    .any(|contact| contact.peak_pressure > permissible);
            if ellipse.peak_pressure > permissible && !known {
                warnings.push(format!(
                    "bearing {number}: at t = {time:.4e} s a {element} {} pressed onto the {} race with {load:.0} N, \
                     {:.0} MPa where ISO 76 permits {:.0}: the race is dented; the model stays {}",
                    if linear { "would be" } else { "is" },
                    RACES[race],
                    ellipse.peak_pressure / 1e6,
                    permissible / 1e6,
                    if linear { "linear" } else { "elastic" },
                ));
            }
            let (overhang, time) = self.overhang[race];
            let known = static_contacts.any(|contact| contact.shoulder_margin < Some(0.0));
            if overhang > 0.0 && !known {
                warnings.push(format!(
                    "bearing {number}: at t = {time:.4e} s the contact ellipse of a {element} reaches {:.2}° past the shoulder \
                     of the {} race: the edge is pressed harder than the model knows",
                    overhang.to_degrees(),
                    RACES[race]
                ));
            }
        }
        Ok(warnings)
    }
}

fn raise(peak: &mut (f64, f64), value: f64, time: f64) {
    if value > peak.0 {
        *peak = (value, time);
    }
}
