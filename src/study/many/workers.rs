//! Work on many threads, whose results come back as they are ready.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;

/// How many tasks ahead of the oldest unfinished one another may be begun: results then come back nearly in
/// order, and what has to be remembered to sort them does not grow with their number.
pub const LEAD: u64 = 4096;

/// The tasks that are left, and those that are being worked on.
struct Queue<I> {
    left: I,
    next: Option<u64>,
    begun: BTreeSet<u64>,
}

/// Works on `tasks`, in ascending order, on so many threads; `take` gets each result on the calling thread
/// as it is ready, and ends the work by an error.
///
/// A task is begun unless `stop` is set; those begun are finished.
///
/// # Errors
/// What `take` answers.
pub fn work<R: Send, E>(
    tasks: impl Iterator<Item = u64> + Send,
    threads: usize,
    stop: &AtomicBool,
    task: impl Fn(u64) -> R + Sync,
    mut take: impl FnMut(u64, R) -> Result<(), E>,
) -> Result<(), E> {
    let queue = Mutex::new(Queue {
        left: tasks,
        next: None,
        begun: BTreeSet::new(),
    });
    let (freed, ended) = (Condvar::new(), AtomicBool::new(false));
    let (sender, results) = mpsc::sync_channel(2 * threads.max(1));
    thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            let (sender, queue, freed, ended, task) =
                (sender.clone(), &queue, &freed, &ended, &task);
            scope.spawn(move || {
                let stopped = || stop.load(Ordering::Relaxed) || ended.load(Ordering::Relaxed);
                while let Some(number) = claim(queue, freed, &stopped) {
                    let result = task(number);
                    locked(queue).begun.remove(&number);
                    freed.notify_all();
                    if sender.send((number, result)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        let mut outcome = Ok(());
        for (number, result) in results {
            if outcome.is_ok() {
                outcome = take(number, result);
                ended.store(outcome.is_err(), Ordering::Relaxed);
            }
        }
        outcome
    })
}

/// The next task, once it is not too far ahead of the oldest that is begun.
fn claim<I: Iterator<Item = u64>>(
    queue: &Mutex<Queue<I>>,
    freed: &Condvar,
    stopped: &impl Fn() -> bool,
) -> Option<u64> {
    let mut queue = locked(queue);
    loop {
        if stopped() {
            return None;
        }
        let next = match queue.next {
            Some(next) => next,
            None => queue.left.next()?,
        };
        let oldest = queue.begun.first().copied().unwrap_or(next);
        if next - oldest < LEAD {
            queue.next = None;
            queue.begun.insert(next);
            return Some(next);
        }
        queue.next = Some(next);
        queue = freed.wait(queue).unwrap_or_else(PoisonError::into_inner);
    }
}

/// A thread that panicked held nothing half done: what it guards is whole.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
