//! How a run gets on: a line on the terminal, and a word where it hardly does.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use super::jobs::Job;
use super::terminal::{Progress, in_words};
use crate::integrate::{Counters, Method, Pace};
use crate::rotor::Rotor;
use crate::simulate::Model;

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
/// What steps follow that are far shorter than any natural period.
const FASTER: &str = "they follow something faster, as balls that are pressed far harder than at rest, or contacts \
                      that part and meet";
const FASTER_OR_STIFF: &str = "they follow something faster, as balls that are pressed far harder than at rest, \
                               contacts that part and meet, or strong damping (method = \"rodas\" in [integrator])";
/// Evaluations a second below which they are costly.
const COSTLY: f64 = 5e4;

/// What both passes of a run have come to.
#[derive(Debug, Clone, Copy)]
struct Look {
    at: Instant,
    times: [f64; 2],
    work: Counters,
}

/// How a run gets on at present.
#[derive(Debug, Clone, Copy)]
struct Present {
    /// Time that it has come to, s, and the pass that has moved last, if both are made.
    time: f64,
    pass: &'static str,
    /// The part of the work that is done, and the time left if it goes on so, s.
    part: f64,
    left: f64,
    /// Mean step, s, and steps, rejected ones and evaluations a second.
    step: f64,
    rates: [f64; 3],
}

/// Watches a run from another thread.
pub struct PaceWatch<'a> {
    job: &'a Job,
    model: &'a Model,
    paces: &'a [Pace; 2],
    started: Instant,
    looks: VecDeque<Look>,
    progress: Progress,
    /// Whether it was told that the run is slow.
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
            progress: Progress::new(&job.scenario.title),
            is_told: false,
        }
    }

    /// Looks at the run, shows how it gets on, and tells once where it hardly does.
    pub fn look(&mut self) {
        let present = self.present();
        let (time, duration) = (present.time, self.model.duration);
        let words = || {
            let left = in_words(present.left);
            format!("{left}, t = {time:.4e} of {duration} s{}", present.pass)
        };
        self.progress.show_with(present.part, words);
        let is_due = self.started.elapsed() > PATIENCE && self.looks.len() == LOOKS;
        if is_due && !self.is_told && present.left > SLOW {
            let slowness = self.slowness(&present);
            self.progress.hidden(|| self.job.warn([slowness]));
            self.is_told = true;
        }
    }

    fn present(&mut self) -> Present {
        let [first, second] = self.paces.each_ref().map(Pace::now);
        let mut work = first.1;
        work.add(&second.1);
        let now = Look {
            at: Instant::now(),
            times: [first.0, second.0],
            work,
        };
        // a run that was begun anew
        if self
            .looks
            .back()
            .is_some_and(|last| now.times[0] < last.times[0])
        {
            self.looks.clear();
        }
        if self.looks.len() == LOOKS {
            self.looks.pop_front();
        }
        self.looks.push_back(now);
        let from = self.looks.front().copied().unwrap_or(now);
        let seconds = (now.at - from.at).as_secs_f64();
        let part = self.part(&now);
        let gained = (part - self.part(&from)).max(f64::MIN_POSITIVE);
        let active = usize::from(now.times[1] > from.times[1]);
        let counts = |work: &Counters| [work.steps, work.rejected, work.evaluations];
        let [then, counts] = [&from.work, &now.work].map(counts);
        let rates = [0, 1, 2].map(|k| (counts[k] - then[k]) as f64 / seconds);
        Present {
            time: now.times[active],
            pass: ["", " (second pass)"][active],
            part,
            left: (1.0 - part) * seconds / gained,
            step: (now.times[active] - from.times[active]) / (rates[0] * seconds).max(1.0),
            rates,
        }
    }

    /// The part of the work that is done.
    fn part(&self, look: &Look) -> f64 {
        let [first, second] = look.times.map(|time| time / self.model.duration);
        match self.model.verify {
            true => FIRST_PASS * first + (1.0 - FIRST_PASS) * second,
            false => first,
        }
    }

    /// Why the run hardly gets on.
    fn slowness(&self, present: &Present) -> String {
        let [steps, rejected, evaluations] = present.rates;
        let mut told = format!(
            "slow: at t = {:.4e} s of {} s{} after {:.0} s, {}; steps of {:.1e} s, {steps:.0} a second, \
             {evaluations:.1e} evaluations a second",
            present.time,
            self.model.duration,
            present.pass,
            self.started.elapsed().as_secs_f64(),
            in_words(present.left),
            present.step,
        );
        told += &self.what_the_steps_follow(present.step);
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
        told + &format!(
            "; a tolerance above {:.0e} in [integrator] takes longer steps, Ctrl-C ends the run",
            self.model.integrator.tolerance
        )
    }

    /// What a step of so many seconds resolves.
    fn what_the_steps_follow(&self, step: f64) -> String {
        let Ok(rotor) = Rotor::assemble(&self.model.rotor) else {
            return String::new();
        };
        let modes = rotor.natural_frequencies();
        let highest = modes.iter().map(|mode| mode.frequency).fold(0.0, f64::max);
        if highest == 0.0 || step == 0.0 {
            return String::new();
        }
        let steps = 1.0 / (highest * step);
        let what = match self.model.integrator.method {
            _ if steps < STEPS_A_PERIOD => "they follow the vibration",
            Method::Rodas => FASTER,
            _ => FASTER_OR_STIFF,
        };
        format!(
            ", {steps:.0} in a period of the highest natural frequency at rest, {highest:.0} Hz: {what}"
        )
    }
}
