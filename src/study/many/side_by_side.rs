//! Runs that are made side by side.

use super::Turn;
use super::chain::Maker;
use super::gathered::Gathered;
use super::record::{Outcome, RunRecord};
use crate::integrate::Method;
use crate::rotor::Sample;
use crate::simulate::{
    Model, Monitor, SIDE_BY_SIDE, TraceSink, Watched, pays_side_by_side, simulate,
    simulate_side_by_side,
};

impl Maker<'_> {
    /// Makes the runs of a chain side by side; none where they do not go so, where it does not pay, or where any
    /// of them fails.
    pub(super) fn side_by_side(&self, chain: u64) -> Option<Vec<RunRecord>> {
        if self.schedule.carries() || self.traces.is_some() {
            return None;
        }
        let turns: Vec<Turn> = self.schedule.chain(chain).collect();
        let turns: &[Turn; SIDE_BY_SIDE] = turns.as_slice().try_into().ok()?;
        let runs = self.schedule.runs();
        let pays = self
            .pilots
            .of(turns[0].number, runs, |pilot| self.pays(pilot));
        if !pays {
            return None;
        }
        let values = turns.map(|turn| self.plan.values(turn.point));
        let mut models = Vec::with_capacity(SIDE_BY_SIDE);
        for (turn, values) in turns.iter().zip(&values) {
            let mut model = self.model_of(*turn, values).ok()?;
            self.reduce(&mut model);
            models.push(model);
        }
        let models: [Model; SIDE_BY_SIDE] = models.try_into().ok()?;
        let outcomes = self.outcomes(&models)?;
        let records = turns.iter().zip(values).zip(outcomes);
        let records = records.map(|((turn, values), outcome)| RunRecord {
            turn: *turn,
            values,
            outcome: Ok(outcome),
        });
        Some(records.collect())
    }

    fn outcomes(&self, models: &[Model; SIDE_BY_SIDE]) -> Option<Vec<Outcome>> {
        let mut gathered = models
            .each_ref()
            .map(|model| Gathered::new(model, false, None));
        let sinks = gathered.each_mut().map(|own| own as &mut dyn TraceSink);
        let mut monitor = Monitor {
            stop: self.stop,
            progress: &mut |_| {},
        };
        let runs = simulate_side_by_side(models, sinks, &mut monitor)?;
        let outcomes = runs.iter().zip(models);
        let outcomes = outcomes.map(|(run, model)| self.outcome(run, model.rotor.speed));
        Some(outcomes.collect())
    }

    /// Whether runs like this one cost less side by side than by themselves.
    fn pays(&self, number: u64) -> bool {
        let mut turns = self.schedule.chain(self.schedule.chain_of(number));
        let Some(turn) = turns.find(|turn| turn.number == number) else {
            return false;
        };
        let Ok(mut model) = self.model_of(turn, &self.plan.values(turn.point)) else {
            return false;
        };
        if model.integrator.method != Method::Auto {
            return true;
        }
        self.reduce(&mut model);
        model.verify = false;
        model.spectrum = None;
        model.analyses.motion = false;
        model.analyses.watched = Watched::Nothing;
        let mut monitor = Monitor {
            stop: self.stop,
            progress: &mut |_| {},
        };
        let Ok(alone) = simulate(&model, &mut Unseen, &mut monitor) else {
            return false;
        };
        let models: [Model; SIDE_BY_SIDE] = std::array::from_fn(|_| model.clone());
        let mut unseen = [const { Unseen }; SIDE_BY_SIDE];
        let sinks = unseen.each_mut().map(|sink| sink as &mut dyn TraceSink);
        let beside = simulate_side_by_side(&models, sinks, &mut monitor);
        beside.is_some_and(|[beside, ..]| pays_side_by_side(&model, &alone, &beside))
    }
}

/// Looks at nothing.
struct Unseen;

impl TraceSink for Unseen {
    fn starts_at(&self) -> f64 {
        f64::INFINITY
    }

    fn takes_balls(&self) -> bool {
        false
    }

    fn sample(&mut self, _sample: &Sample) -> std::io::Result<()> {
        Ok(())
    }
}
