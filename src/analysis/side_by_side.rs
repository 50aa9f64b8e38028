//! Channels worked on side by side.

use std::num::NonZero;
use std::thread;

/// Fewer samples than this, all channels together, are done before a thread has started.
const FEWEST_SAMPLES: usize = 1 << 17;

/// What `work` makes of every item, in their order, on as many threads as the machine has; `samples` is
/// the size of it all. Which thread takes which item changes nothing of the result.
pub(super) fn side_by_side<T: Send, R: Send>(
    items: Vec<T>,
    samples: usize,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
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
