//! A progress bar for runs that take long enough to wonder.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A run shorter than this shows no bar.
const PATIENCE: Duration = Duration::from_millis(800);
/// Steps of the bar.
const STEPS: u64 = 1000;

/// Shows the part of a run that is done, on stderr where that is a terminal.
pub struct Progress {
    title: String,
    started: Instant,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Starts to watch a run.
    pub fn new(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            started: Instant::now(),
            bar: None,
        }
    }

    /// Shows that `part` (0 … 1) of the run is done.
    pub fn show(&mut self, part: f64) {
        self.show_with(part, String::new);
    }

    /// Shows the same with what is known of it in words.
    pub fn show_with(&mut self, part: f64, words: impl Fn() -> String) {
        if self.bar.is_none() && self.started.elapsed() < PATIENCE {
            return;
        }
        let new = || new_bar(&self.title, self.started);
        let bar = self.bar.get_or_insert_with(new);
        bar.set_prefix(words());
        bar.set_position((part * STEPS as f64) as u64);
    }

    /// Does something that writes to the terminal, too.
    pub fn hidden(&self, tell: impl FnOnce()) {
        match &self.bar {
            Some(bar) => bar.suspend(tell),
            None => tell(),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn new_bar(title: &str, started: Instant) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr())
        .with_elapsed(started.elapsed())
        .with_message(title.to_owned());
    match ProgressStyle::with_template("{msg} {bar:30} {percent} %, {eta} left{prefix}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
