//! Runs that cannot begin or cannot go on.

use super::{THRUST, try_run};

/// A load that no bearing of this size carries.
#[test]
fn an_impossible_load_is_refused_before_the_first_step() {
    let (result, extremes) = try_run(&THRUST.replace("1000 N", "800 MN"));
    let message = result.expect_err("nothing carries 800 MN").to_string();
    assert!(
        message.contains("no static equilibrium") && message.contains(" z "),
        "{message}"
    );
    assert_eq!(extremes.samples, 0);
}

/// Steps run out: the trace up to there has been handed over.
#[test]
fn a_limit_on_steps_keeps_the_trace_so_far() {
    let text = THRUST.replace("tolerance = 1e-8", "tolerance = 1e-8\n    step_limit = 100");
    let (result, extremes) = try_run(&text);
    let message = result.expect_err("100 steps are too few").to_string();
    assert!(message.contains("100 steps are used up"), "{message}");
    assert!(extremes.samples > 100, "{}", extremes.samples);
}
