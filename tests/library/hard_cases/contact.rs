//! Balls at the edge of contact.

use super::{clearance_scene, error, run};

/// Clearance zero is the edge at which the whole ring of balls is at once at the edge of contact.
#[test]
fn clearance_of_exactly_zero_and_of_a_picometre() {
    let (zero, at_zero) = run(&clearance_scene("0 um", 8));
    let (tiny, at_tiny) = run(&clearance_scene("1e-6 um", 8));
    let difference = (at_zero.reach[1] - at_tiny.reach[1]).abs();
    assert!(
        difference < 5e-12,
        "a picometre moved the shaft by {difference} m"
    );
    assert!(error(&zero) < 1e-4 && error(&tiny) < 1e-4);
    assert!(at_zero.fewest_balls >= 3);
}

/// Three balls: for a part of every passage the shaft hangs between two of them.
#[test]
fn three_balls_carry_a_shaft() {
    let (run, extremes) = run(&clearance_scene("3 um", 3));
    assert!(run.counters.steps < 200_000, "{:?}", run.counters);
    assert!(extremes.reach[1] < 100e-6 && extremes.fewest_balls <= 1);
}

/// A wide clearance under a light load: balls leave and meet the races thousands of times.
#[test]
fn contact_lost_and_regained_thousands_of_times() {
    let text = clearance_scene("20 um", 8)
        .replace("\"1 s\"", "\"40 s\"")
        .replace("-196 N", "-20 N")
        + "[integrator]\nverify = false\n";
    let (run, extremes) = run(&text);
    assert!(
        extremes.contact_changes > 10_000,
        "{}",
        extremes.contact_changes
    );
    assert!(extremes.reach[1] < 60e-6, "{:?}", extremes.reach);
    assert!(
        run.counters.rejected < run.counters.steps,
        "{:?}",
        run.counters
    );
}
