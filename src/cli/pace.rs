//! How a run gets on: a line on the terminal, and a word where it hardly does.

use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use super::jobs::Job;
use super::progress::Progress;
use crate::integrate::{Counters, Pace};
use crate::rotor::Rotor;
use crate::simulate::Model;

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(100);
/// Looks that the present pace is taken from.
const LOOKS: usize = 40;
/// Time that a run goes without a word however slow it is.
const PATIENCE: Duration = Duration::from_secs(5);
/// Time left, s, from which on a run is slow.
const SLOW: f64 = 60.0;
/// Part of the work of both passes that is the first one's.
const FIRST_PASS: f64 = 0.44;
/// Steps in a period of the fastest natural vibration above which it is not what they follow.
const STEPS_A_PERIOD: f64 = 100.0;
/// Part of the trials that are rejected from which on it is worth a word.
const MANY_REJECTED: f64 = 0.25;
/// Evaluations a second below which they are costly.
const COSTLY: f64 = 5e4;

/// What both passes of a run have come to.
#[derive(Debug, Clone, Copy)]
struct Look {
    at: Instant,
    times: [f64; 2],
    work: Counters,
}

/// Watches a run from another thread.
pub struct PaceWatch<'a> {
    job: &'a Job,
    model: &'a Model,
    paces: &'a [Pace; 2],
    started: Instant,
    looks: VecDeque<Look>,
    is_told: bool,
}

impl<'a> PaceWatch<'a> {
    /// Of a run that begins.
    pub fn new(job: &'a Job, model: &'a Model, paces: &'a [Pace; 2]) -> Self {
        Self {
            job,
            model,
            paces,
            started: Instant::now(),
            looks: VecDeque::new(),
            is_told: false,
        }
    }

    /// Looks at the run until the other end of the channel is gone.
    pub fn until(mut self, ended: &Receiver<()>) {
        let mut progress = Progress::new(&self.job.scenario.title);
        while ended.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
            self.look();
            progress.show_with(self.part(), || self.standing());
            if let Some(warning) = self.slowness() {
                progress.hidden(|| self.job.warn([warning]));
                self.is_told = true;
            }
        }
    }

    fn look(&mut self) {
        let [first, second] = self.paces.each_ref().map(Pace::now);
        let mut work = first.1;
        work.add(&second.1);
        if self.looks.len() == LOOKS {
            self.looks.pop_front();
        }
        self.looks.push_back(Look {
            at: Instant::now(),
            times: [first.0, second.0],
            work,
        });
    }

    /// The part of the work that is done.
    fn part(&self) -> f64 {
        self.looks.back().map_or(0.0, |look| self.part_at(look))
    }

    fn part_at(&self, look: &Look) -> f64 {
        let [first, second] = look.times.map(|time| time / self.model.duration);
        match self.model.verify {
            true => FIRST_PASS * first + (1.0 - FIRST_PASS) * second,
            false => first,
        }
    }

    /// The looks that the present pace is taken from.
    fn span(&self) -> Option<[&Look; 2]> {
        Some([self.looks.front()?, self.looks.back()?])
    }

    /// Time left as the run goes now, s.
    fn left(&self) -> Option<f64> {
        let [from, to] = self.span()?;
        let seconds = (to.at - from.at).as_secs_f64();
        let gained = self.part_at(to) - self.part_at(from);
        (seconds > 0.0).then(|| (1.0 - self.part_at(to)) * seconds / gained.max(f64::MIN_POSITIVE))
    }

    /// Simulated time and what is left, in words.
    fn standing(&self) -> String {
        let time = self.time();
        let duration = self.model.duration;
        let left = self
            .left()
            .map_or_else(String::new, |left| format!(", {}", in_words(left)));
        format!("t = {time:.4e} of {duration} s{}{left}", self.pass())
    }

    /// The pass that has moved last, if both are made.
    fn active(&self) -> usize {
        let moved = self
            .span()
            .is_some_and(|[from, to]| to.times[1] > from.times[1]);
        usize::from(self.model.verify && moved)
    }

    fn time(&self) -> f64 {
        self.looks
            .back()
            .map_or(0.0, |look| look.times[self.active()])
    }

    fn pass(&self) -> &'static str {
        ["", " (second pass)"][self.active()]
    }

    /// Why the run hardly gets on, once where it does not.
    fn slowness(&self) -> Option<String> {
        if self.is_told || self.started.elapsed() < PATIENCE || self.looks.len() < LOOKS {
            return None;
        }
        let left = self.left().filter(|left| *left > SLOW)?;
        let [from, to] = self.span()?;
        let steps = (to.work.steps - from.work.steps) as f64;
        let rejected = (to.work.rejected - from.work.rejected) as f64;
        let seconds = (to.at - from.at).as_secs_f64();
        let evaluations = (to.work.evaluations - from.work.evaluations) as f64 / seconds;
        let active = self.active();
        let step = (to.times[active] - from.times[active]) / steps.max(1.0);
        let mut told = format!(
            "slow: at t = {:.4e} s of {} s{} after {:.0} s, {}; steps of {step:.1e} s, {:.0} a second, \
             {evaluations:.1e} evaluations a second",
            self.time(),
            self.model.duration,
            self.pass(),
            self.started.elapsed().as_secs_f64(),
            in_words(left),
            steps / seconds,
        );
        told += &self.what_the_steps_follow(step);
        if rejected > MANY_REJECTED * (steps + rejected) {
            told += &format!(
                "; {:.0} % of the trials are rejected, as where contacts part and meet again and again or a force \
                 has corners",
                100.0 * rejected / (steps + rejected)
            );
        }
        if 0.0 < evaluations && evaluations < COSTLY && !self.model.table {
            told += "; the bearings are costly to evaluate: table = true in [model] compiles their balls";
        }
        Some(
            told + &format!(
                "; a tolerance above {:.0e} in [integrator] takes longer steps, Ctrl-C ends the run",
                self.model.integrator.tolerance
            ),
        )
    }

    /// What a step of so many seconds resolves.
    fn what_the_steps_follow(&self, step: f64) -> String {
        let Ok(rotor) = Rotor::assemble(&self.model.rotor) else {
            return String::new();
        };
        let modes = rotor.natural_frequencies();
        let highest = modes.iter().map(|mode| mode.frequency).fold(0.0, f64::max);
        if !(highest > 0.0 && step > 0.0) {
            return String::new();
        }
        let steps = 1.0 / (highest * step);
        if steps < STEPS_A_PERIOD {
            return format!(
                ": they follow the vibration, {steps:.0} steps in a period of the highest natural frequency, \
                 {highest:.0} Hz"
            );
        }
        format!(
            ": {steps:.0} in a period of the highest natural frequency at rest, {highest:.0} Hz, so they follow \
             something faster, as balls that are pressed far harder than at rest, contacts that part and meet, or \
             strong damping (method = \"rodas\" in [integrator])"
        )
    }
}

/// Time left in words.
fn in_words(seconds: f64) -> String {
    match seconds {
        s if s < 100.0 => format!("{s:.0} s left"),
        s if s < 6000.0 => format!("{:.0} min left", s / 60.0),
        s if s < 2e5 => format!("{:.0} h left", s / 3600.0),
        s if s < 1e8 => format!("{:.0} days left", s / 86400.0),
        _ => "no end in sight".to_owned(),
    }
}
