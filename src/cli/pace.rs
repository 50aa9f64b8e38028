//! How a run gets on: a line on the terminal, and a word where it hardly does.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use super::jobs::Job;
use super::terminal::{Progress, in_words};
use crate::integrate::{self, Counters, Method};
use crate::rotor::{Rotor, RotorError};
use crate::simulate::{Model, finer_modes};

/// Looks that the present pace is taken from.
const LOOKS: usize = 40;
/// Time that a run goes without a word however slow it is.
const PATIENCE: Duration = Duration::from_secs(5);
/// Time left, s, from which on a run is slow.
const SLOW: f64 = 60.0;
/// What the passes are called: the run, that of its error, and that with more modes of a shaft that bends.
const PASSES: [&str; 3] = ["", " (second pass)", " (pass with more modes)"];
/// Times the end that was last announced from which on a later one is announced, too.
const LATER: f64 = 2.0;
/// Steps in a period of the fastest natural vibration above which it is not what they follow.
const STEPS_A_PERIOD: f64 = 100.0;
/// Part of the trials that are rejected from which on it is worth a word.
const MANY_REJECTED: f64 = 0.25;
/// What steps follow that are far shorter than any natural period.
const FASTER: &str = "they follow something faster, as rolling elements that are pressed far harder than at rest, or contacts \
                      that part and meet";
const FASTER_OR_STIFF: &str = "they follow something faster, as rolling elements that are pressed far harder than at rest, \
                               contacts that part and meet, or strong damping (method = \"rodas\" in [integrator])";
/// Part of the work below which nothing is left: the last sample is before the end of the duration, and the spectra and
/// files that follow take no steps.
const NOTHING_LEFT: f64 = 1e-4;
/// Evaluations a second below which they are costly.
const COSTLY: f64 = 5e4;

/// What the passes of a run have come to: times, s, and work.
#[derive(Debug, Clone, Copy)]
struct Look {
    at: Instant,
    passes: [(f64, Counters); 3],
}

/// How a run gets on at present.
#[derive(Debug, Clone, Copy)]
struct Present {
    /// The pass that works most, and the time that it has come to, s.
    pass: usize,
    time: f64,
    /// The part of the work that is done, and the time left if it goes on so, s.
    part: f64,
    left: f64,
    /// Mean step of that pass, s, if it took any, and the seconds looked at.
    step: Option<f64>,
    seconds: f64,
    /// Its steps, rejected ones and evaluations a second.
    rates: [f64; 3],
}

/// Watches a run from another thread.
pub struct PaceWatch<'a> {
    job: &'a Job,
    model: &'a Model,
    passes: &'a [integrate::Progress; 3],
    started: Instant,
    looks: VecDeque<Look>,
    progress: Progress,
    /// The time from start to end, s, that was announced, if any.
    announced: Option<f64>,
}

impl<'a> PaceWatch<'a> {
    /// Of a run that begins.
    pub fn new(job: &'a Job, model: &'a Model, passes: &'a [integrate::Progress; 3]) -> Self {
        Self {
            job,
            model,
            passes,
            started: Instant::now(),
            looks: VecDeque::new(),
            progress: Progress::new(&job.scenario.title),
            announced: None,
        }
    }

    /// Looks at the run, shows how it gets on, and tells where it hardly does, again where its end moves far away.
    pub fn look(&mut self) {
        let present = self.present();
        let (time, duration) = (present.time, self.model.duration);
        let words = || {
            let (left, pass) = (in_words(present.left), PASSES[present.pass]);
            format!("{left}, t = {time:.4e} of {duration} s{pass}")
        };
        self.progress.show_with(present.part, words);
        let elapsed = self.started.elapsed();
        let all = elapsed.as_secs_f64() + present.left;
        let is_news = self.announced.is_none_or(|before| all > LATER * before);
        let is_due = elapsed > PATIENCE && self.looks.len() == LOOKS;
        if is_due && is_news && present.left > SLOW {
            let slowness = self.slowness(&present);
            self.progress.hidden(|| self.job.warn([slowness]));
            self.announced = Some(all);
        }
    }

    fn present(&mut self) -> Present {
        let now = Look {
            at: Instant::now(),
            passes: self.passes.each_ref().map(integrate::Progress::latest),
        };
        // a run that was begun anew
        let is_behind = |last: &Look| now.passes[0].0 < last.passes[0].0;
        if self.looks.back().is_some_and(is_behind) {
            self.looks.clear();
        }
        if self.looks.len() == LOOKS {
            self.looks.pop_front();
        }
        self.looks.push_back(now);
        let from = self.looks.front().copied().unwrap_or(now);
        let seconds = (now.at - from.at).as_secs_f64();
        let counts = |look: &Look, pass: usize| {
            let work = look.passes[pass].1;
            [work.steps, work.rejected, work.evaluations]
        };
        let done = [0, 1, 2].map(|pass| {
            let [then, now] = [&from, &now].map(|look| counts(look, pass));
            [0, 1, 2].map(|k| now[k].saturating_sub(then[k]) as f64)
        });
        let pass = (0..3)
            .rev()
            .max_by(|a, b| done[*a][2].total_cmp(&done[*b][2]));
        let pass = pass.unwrap_or(0);
        let weights = self.weights(&now);
        let [before, part] = [&from, &now].map(|look| {
            let parts = look.passes.iter().zip(weights);
            let parts = parts.map(|((time, _), weight)| weight * time / self.model.duration);
            parts.sum::<f64>()
        });
        let (steps, time) = (done[pass][0], now.passes[pass].0);
        let left = match 1.0 - part {
            rest if rest < NOTHING_LEFT => 0.0,
            rest => rest * seconds / (part - before).max(f64::MIN_POSITIVE),
        };
        Present {
            pass,
            time,
            part,
            left,
            step: (steps > 0.0).then(|| (time - from.passes[pass].0) / steps),
            seconds,
            rates: done[pass].map(|count| count / seconds),
        }
    }

    /// The part of each pass of all work; one that has not begun is taken to work as the first does.
    fn weights(&self, look: &Look) -> [f64; 3] {
        let has_finer = self.model.verify && self.model.rotor.flexible.is_some();
        let are_made = [true, self.model.verify, has_finer];
        // evaluations in a second of the motion
        let rate = |pass: usize| {
            let (time, work) = look.passes[pass];
            (time > 0.0).then(|| work.evaluations.max(1) as f64 / time)
        };
        let first = rate(0).unwrap_or(1.0);
        let work = [0, 1, 2].map(|pass| match are_made[pass] {
            true => rate(pass).unwrap_or(first),
            false => 0.0,
        });
        let all: f64 = work.iter().sum();
        work.map(|work| work / all)
    }

    /// Why the run hardly gets on.
    fn slowness(&self, present: &Present) -> String {
        let [steps, rejected, evaluations] = present.rates;
        let stepped = match present.step {
            Some(step) => format!("steps of {step:.1e} s, {steps:.0} a second"),
            None => format!("no step in the last {:.0} s", present.seconds),
        };
        let mut text = format!(
            "slow: at t = {:.4e} s of {} s{} after {:.0} s, {}; {stepped}, {evaluations:.1e} evaluations a second",
            present.time,
            self.model.duration,
            PASSES[present.pass],
            self.started.elapsed().as_secs_f64(),
            in_words(present.left),
        );
        let rotor = self.rotor(present.pass).ok();
        let follows = present.step.zip(rotor.as_ref());
        text += &follows.map_or_else(String::new, |(step, rotor)| {
            what_steps_follow(step, rotor, self.model.integrator.method)
        });
        if rejected > MANY_REJECTED * (steps + rejected) {
            text += &format!(
                "; {:.0} % of the trials are rejected, as where contacts part and meet again and again or a force \
                 has corners",
                100.0 * rejected / (steps + rejected)
            );
        }
        let gains = rotor.as_ref().is_some_and(Rotor::gains_from_tables);
        if evaluations < COSTLY && gains && !self.model.table {
            text += "; the bearings are costly to evaluate: table = true in [model] compiles their balls";
        }
        text + &format!(
            "; a tolerance above {:.0e} in [integrator] takes longer steps, Ctrl-C ends the run",
            self.model.integrator.tolerance
        )
    }

    /// The rotor of a pass.
    fn rotor(&self, pass: usize) -> Result<Rotor, RotorError> {
        let rotor = Rotor::assemble(&self.model.rotor)?;
        match rotor.bending_modes() {
            Some(modes) if pass == 2 => {
                Rotor::assemble(&self.model.rotor.with_modes(finer_modes(modes)))
            }
            _ => Ok(rotor),
        }
    }
}

/// What a step of so many seconds resolves.
fn what_steps_follow(step: f64, rotor: &Rotor, method: Method) -> String {
    let Some((highest, places)) = rotor.fastest() else {
        return String::new();
    };
    let steps = 1.0 / (highest * step);
    let what = match method {
        _ if steps < STEPS_A_PERIOD => "they follow it",
        Method::Rodas => FASTER,
        _ => FASTER_OR_STIFF,
    };
    format!(
        ", {steps:.0} in a period of the highest natural frequency at rest, {highest:.0} Hz ({places}): {what}"
    )
}
