//! Work with the lock of the interpreter released, which Ctrl-C ends and a callback follows.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors::other;

/// How often signals are looked for, and the callback is told.
const EVERY: Duration = Duration::from_millis(50);
/// Stack of the thread that works, bytes: as much as a main thread has.
const STACK: usize = 8 << 20;

/// Ends work that goes on elsewhere: of one object, all calls that were given it.
#[pyclass(frozen, module = "jeffcott")]
#[derive(Default)]
pub struct StopSignal(Arc<AtomicBool>);

#[pymethods]
impl StopSignal {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    fn __repr__(&self) -> &'static str {
        match self.0.load(Ordering::Relaxed) {
            true => "<StopSignal: set>",
            false => "<StopSignal: not set>",
        }
    }

    /// Ends the work at its next step.
    fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// What is handed to the work: whether it is to stop, and whom to tell of the part that is done.
pub struct Watch<'a> {
    /// Set where it is to stop.
    pub stop: &'a AtomicBool,
    /// Takes the part that is done, 0 … 1.
    pub progress: &'a mut dyn FnMut(f64),
}

/// Works on a thread of its own while this one, with the lock released, looks for signals and tells `progress` of the
/// part that is done.
///
/// # Errors
/// What a signal raises, as KeyboardInterrupt, or the callback; the work has then stopped.
pub fn watched<T: Send>(
    py: Python<'_>,
    stop: Option<&StopSignal>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&mut Watch<'_>) -> T + Send,
) -> PyResult<T> {
    let stop = stop.map_or_else(Arc::default, |stop| stop.0.clone());
    let begun = 0.0_f64.to_bits();
    let part = AtomicU64::new(begun);
    let tell = |reported: &mut u64| {
        Python::attach(|py| -> PyResult<()> {
            py.check_signals()?;
            let now = part.load(Ordering::Relaxed);
            if let Some(callback) = progress.filter(|_| now != *reported) {
                callback.call1(py, (f64::from_bits(now),))?;
                *reported = now;
            }
            Ok(())
        })
    };
    let result = py.detach(|| {
        thread::scope(|scope| -> PyResult<_> {
            let (working, ended) = channel::<()>();
            let (stop, part) = (&stop, &part);
            let worker = thread::Builder::new().stack_size(STACK);
            let worker = worker.spawn_scoped(scope, move || {
                let _working = working;
                work(&mut Watch {
                    stop,
                    progress: &mut |done| part.store(done.to_bits(), Ordering::Relaxed),
                })
            });
            let worker = worker.map_err(other)?;
            let (mut raised, mut reported) = (Ok(()), begun);
            while let Err(RecvTimeoutError::Timeout) = ended.recv_timeout(EVERY) {
                if raised.is_ok() {
                    raised = tell(&mut reported);
                    stop.fetch_or(raised.is_err(), Ordering::Relaxed);
                }
            }
            let result = match worker.join() {
                Ok(result) => result,
                Err(panic) => std::panic::resume_unwind(panic),
            };
            raised?;
            Ok((result, reported))
        })
    });
    let (result, mut reported) = result?;
    tell(&mut reported)?;
    Ok(result)
}
