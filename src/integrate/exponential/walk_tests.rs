//! How a step begins.

use super::*;

/// A walk whose latest step, of one second, saw a slow part that grows by one a second from 1/3 on.
fn after_a_step() -> Walk<1> {
    let mut walk = Walk::new([0.0, 1.0], [0.0], 0.0, Counters::default());
    walk.slow_size = 1.0;
    walk.slow = NODES.part.map(|part| [1.0 / 3.0 + part]);
    walk
}

/// Up to [`MOST_AHEAD`] the slow part is carried on by its polynomial. Far beyond, as behind a step that was cut
/// next to a sample, the polynomial is round-off: what is guessed there is off by the change of the slow part and
/// no more.
#[test]
fn a_guess_is_never_further_off_than_the_slow_part_changes() {
    for ratio in [
        0.1,
        1.0,
        4.0,
        MOST_AHEAD,
        1.01 * MOST_AHEAD,
        100.0,
        1e4,
        1e8,
    ] {
        let mut walk = after_a_step();
        walk.size = ratio;
        let guess = walk.guess();
        for (part, [guess]) in NODES.part.iter().zip(guess) {
            let change = ratio * part;
            let off = (guess - (4.0 / 3.0 + change)).abs();
            let allowed = if ratio <= MOST_AHEAD { 1e-3 } else { change };
            assert!(
                off <= allowed + 1e-9,
                "{ratio} times as far, at {part}: {off:e}"
            );
        }
    }
}

/// Without a step before, the slow part is taken as it is at the start.
#[test]
fn a_first_guess_stays_where_it_is() {
    let mut walk = after_a_step();
    (walk.slow_size, walk.size) = (0.0, 1.0);
    assert_eq!(walk.guess(), [[4.0 / 3.0]; POINTS]);
}
