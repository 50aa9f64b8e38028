//! Freedoms that hardly anything holds.

use super::{THRUST, error, run};

/// A radial load alone on an angular contact bearing that may move axially: it slides to the place
/// where no ball pushes it along.
#[test]
fn a_lone_radial_load_with_a_free_axial_freedom() {
    let text = THRUST.replace("z = \"1000 N\"", "y = \"-300 N\"");
    let (run, extremes) = run(&text);
    let place = run.equilibrium.displacement[2];
    // axially centred: −A sin α0 with A = 0.3969 mm, α0 = 15°
    assert!(
        (place + 0.3969e-3 * 15f64.to_radians().sin()).abs() < 1e-6,
        "{place}"
    );
    assert!(
        extremes.reach[1] < 200e-6 && error(&run) < 1e-3,
        "{extremes:?} {}",
        error(&run)
    );
}
