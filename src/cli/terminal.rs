//! The terminal: results on stdout, messages and progress on stderr, and Ctrl-C.

use std::fmt::Display;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Once, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

use clap::ColorChoice;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::Outcome;
use crate::scenario::{ScenarioError, visible};

/// How much is printed, and in which colours: options of every verb.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct Manner {
    /// Tell warnings and errors only, and what --json asks for
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Tell also how the answer was computed: methods, steps, evaluations, wall time
    #[arg(short, long, global = true)]
    verbose: bool,
    /// Colours of messages; "auto": on a terminal, unless NO_COLOR is set
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t)]
    color: ColorChoice,
}

static MANNER: OnceLock<Manner> = OnceLock::new();

fn manner() -> Manner {
    MANNER.get().copied().unwrap_or_default()
}

impl Manner {
    /// Takes the manner for the rest of the process.
    pub fn set(self) {
        let _ = MANNER.set(self);
    }
}

/// Whether people want to know how answers were computed.
pub fn details() -> bool {
    manner().verbose
}

/// Whether messages are coloured.
pub fn color() -> bool {
    match manner().color {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto => {
            let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
            !refused && io::stderr().is_terminal()
        }
    }
}

/// Writes a result to stdout.
///
/// # Errors
/// Whatever keeps stdout from taking it.
pub fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(visible(text).as_bytes())?;
    stdout.flush()
}

/// Writes a summary for people to stdout, unless they want quiet.
///
/// # Errors
/// Whatever keeps stdout from taking it.
pub fn summarise(text: &str) -> io::Result<()> {
    if manner().quiet {
        return Ok(());
    }
    print(text)
}

/// Writes a warning or an error to stderr; there is nowhere to tell that it could not be written.
pub fn tell(text: &str) {
    tell_as_it_is(&visible(text));
}

/// Tells what is wrong with a file, in colours where they are wanted.
pub fn tell_problems(error: &ScenarioError) {
    // what is left of control characters in the quoted text is seen; those of the colours are the renderer's
    let parts = error.render(color());
    let parts: Vec<String> = parts.split('\u{1b}').map(visible).collect();
    tell_as_it_is(&parts.join("\u{1b}"));
}

fn tell_as_it_is(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Tells why the input is wrong.
pub fn refuse(error: impl Display) -> Outcome {
    tell(&format!("error: {error}\n"));
    Outcome::WrongInput
}

/// Writes a remark to stderr, unless they want quiet.
pub fn remark(text: &str) {
    if !manner().quiet {
        tell(text);
    }
}

/// Lets a limit on the size of files be an error of the file, which then is removed, not the end of the process.
pub fn survive_limits() {
    #[cfg(unix)]
    {
        let ignored = std::sync::Arc::default();
        let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, ignored);
    }
}

/// The exit code of a verb. A reader that closed the pipe has what it wanted.
pub fn finish(outcome: io::Result<Outcome>) -> ExitCode {
    match outcome {
        Ok(outcome) => outcome.into(),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            tell(&format!("error: cannot write the result: {error}\n"));
            ExitCode::FAILURE
        }
    }
}

/// What is set when the command is to stop; from the first call on, an interrupt sets it.
pub fn stop() -> &'static AtomicBool {
    static STOP: AtomicBool = AtomicBool::new(false);
    static LISTENING: Once = Once::new();
    LISTENING.call_once(|| {
        // Without a handler an interrupt ends the process at once; what is written stays safe as well.
        let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    });
    &STOP
}

/// Opens the page among the files of a result; says so where there is none.
pub fn open_page(files: &[PathBuf]) {
    let is_page = |file: &&PathBuf| file.extension().is_some_and(|ending| ending == "html");
    match files.iter().find(is_page) {
        Some(page) => open(page),
        None => tell("warning: there is no page to open: [output] has report = false\n"),
    }
}

/// Opens a page in a browser: that of `$BROWSER`, or the one that the system has for pages; where there is none, says
/// so.
fn open(page: &Path) {
    let named = std::env::var_os("BROWSER").filter(|name| !name.is_empty());
    let system = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    let browser = named.unwrap_or_else(|| system.into());
    let mut command = Command::new(&browser);
    command.arg(page).stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let refused = match command.spawn().map(refusal) {
        Ok(None) => return,
        Ok(Some(status)) => status.to_string(),
        Err(error) => error.to_string(),
    };
    tell(&format!(
        "warning: {} does not open the page ({refused}): open {} in a browser, or name one in $BROWSER\n",
        browser.display(),
        page.display()
    ));
}

/// How a browser ended if it ends at once without success; one that goes on shows the page.
fn refusal(mut browser: Child) -> Option<ExitStatus> {
    let started = Instant::now();
    while started.elapsed() < PATIENCE {
        match browser.try_wait() {
            Ok(Some(status)) => return (!status.success()).then_some(status),
            Ok(None) => thread::sleep(Duration::from_millis(20)),
            Err(_) => return None,
        }
    }
    None
}

/// Time between two looks at work.
const LOOK: Duration = Duration::from_millis(100);

/// Works while another thread looks on again and again; unwatched where the system has no further thread.
pub fn watched<T>(look: impl FnMut() + Send, work: impl FnOnce() -> T) -> T {
    let (working, ended) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let mut look = look;
        let _ = thread::Builder::new().spawn_scoped(scope, move || {
            while ended.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
                look();
            }
        });
        let _working = working;
        work()
    })
}

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
            title: visible(title),
            started: Instant::now(),
            bar: None,
        }
    }

    /// Shows that `part` (0 … 1) of the run is done.
    pub fn show(&mut self, part: f64) {
        let elapsed = self.started.elapsed().as_secs_f64();
        let left = (1.0 - part) * elapsed / part.max(f64::MIN_POSITIVE);
        self.show_with(part, || in_words(left));
    }

    /// Shows the same with what is known of it in words, such as the time left.
    pub fn show_with(&mut self, part: f64, words: impl Fn() -> String) {
        if manner().quiet || (self.bar.is_none() && self.started.elapsed() < PATIENCE) {
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

/// Time left, s, in words.
pub fn in_words(seconds: f64) -> String {
    match seconds {
        s if s < 100.0 => format!("{s:.0} s left"),
        s if s < 6000.0 => format!("{:.0} min left", s / 60.0),
        s if s < 2e5 => format!("{:.0} h left", s / 3600.0),
        s if s < 1e8 => format!("{:.0} days left", s / 86400.0),
        _ => "no end in sight".to_owned(),
    }
}

fn new_bar(title: &str, started: Instant) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr())
        .with_elapsed(started.elapsed())
        .with_message(title.to_owned());
    match ProgressStyle::with_template("{msg} {bar:30} {percent} %, {prefix}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
