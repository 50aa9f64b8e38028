//! Ctrl-C and requests to terminate.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is set when the command is to stop; from the first call on, an interrupt sets it.
pub fn flag() -> &'static AtomicBool {
    static STOP: AtomicBool = AtomicBool::new(false);
    static LISTENING: Once = Once::new();
    LISTENING.call_once(|| {
        // Without a handler an interrupt ends the process at once; what is written stays safe as well.
        let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    });
    &STOP
}
