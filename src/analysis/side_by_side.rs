//! Channels worked on side by side.

use std::num::NonZero;
use std::sync::LazyLock;
use std::thread;

/// Fewer samples than this, all channels together, are done before a thread has started.
const FEWEST_SAMPLES: usize = 1 << 17;

/// Number of threads that may be worked on; by default as many as the machine has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Threads(NonZero<usize>);

impl Threads {
    /// One.
    pub const ONE: Self = Self(NonZero::<usize>::MIN);

    /// So many.
    pub fn new(count: NonZero<usize>) -> Self {
        Self(count)
    }

    /// How many.
    pub fn count(self) -> usize {
        self.0.get()
    }
}

impl Default for Threads {
    fn default() -> Self {
        // the answer stands in files of the system, which are not to be read for every run
        static AVAILABLE: LazyLock<NonZero<usize>> =
            LazyLock::new(|| thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN));
        Self(*AVAILABLE)
    }
}

/// What `work` makes of every item, in their order, on up to so many threads; `samples` is the size of it
/// all. Which thread takes which item changes nothing of the result.
pub(super) fn side_by_side<T: Send, R: Send>(
    items: Vec<T>,
    samples: usize,
    threads: Threads,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let threads = threads.count();
    if threads == 1 || samples < FEWEST_SAMPLES {
        return items.into_iter().map(work).collect();
    }
    let share = items.len().div_ceil(threads).max(1);
    let mut items = items.into_iter();
    let shares: Vec<Vec<T>> = (0..threads)
        .map(|_| items.by_ref().take(share).collect())
        .collect();
    let work = &work;
    thread::scope(|scope| {
        let started = shares
            .into_iter()
            .map(|share| scope.spawn(move || share.into_iter().map(work).collect::<Vec<R>>()));
        let started: Vec<_> = started.collect();
        let done = started.into_iter().map(|thread| match thread.join() {
            Ok(results) => results,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        done.flatten().collect()
    })
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;
    use std::sync::{Barrier, Mutex};

    use super::*;

    #[test]
    fn one_thread_is_the_callers_own() {
        let caller = thread::current().id();
        let own = side_by_side(vec![(); 4], usize::MAX, Threads::ONE, |()| {
            thread::current().id() == caller
        });
        assert_eq!(own, [true; 4]);
    }

    #[test]
    fn as_many_threads_work_as_are_given() {
        let three = Threads::new(NonZero::new(3).expect("not zero"));
        let (seen, together) = (Mutex::new(HashSet::new()), Barrier::new(3));
        let order = side_by_side(vec![0, 1, 2], usize::MAX, three, |item| {
            together.wait();
            seen.lock()
                .expect("no panic")
                .insert(thread::current().id());
            item
        });
        assert_eq!(order, [0, 1, 2]);
        assert_eq!(seen.into_inner().expect("no panic").len(), 3);
    }
}
