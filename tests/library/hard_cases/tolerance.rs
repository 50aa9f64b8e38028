//! Tolerances at both ends of what can be asked.

use super::{THRUST, error, run};

/// At 1e-13 the tolerance is at the round-off of the positions: the run must end and say so.
#[test]
fn a_tolerance_at_the_floor_of_round_off_ends() {
    let (run, _) = run(&THRUST.replace("1e-8", "1e-13"));
    assert!(error(&run) < 1e-10, "{}", error(&run));
    assert!(run.counters.steps < 100_000, "{:?}", run.counters);
}

/// A loose tolerance may be wrong, but must stay near the truth and say how far it is.
#[test]
fn a_loose_tolerance_stays_bounded() {
    let (loose, extremes) = run(&THRUST.replace("1e-8", "1e-2"));
    let (_, tight) = run(THRUST);
    assert!(error(&loose) < 0.1, "{}", error(&loose));
    assert!(
        (extremes.reach[2] - tight.reach[2]).abs() < 1e-8,
        "{extremes:?} {tight:?}"
    );
}
