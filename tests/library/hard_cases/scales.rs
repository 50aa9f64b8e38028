//! Scales far apart.

use super::{THRUST, error, run, work};

/// Light and heavy shafts on one bearing: natural frequencies a thousand times apart.
#[test]
fn masses_a_million_times_apart() {
    for mass in ["5 g", "5000 kg"] {
        let text = THRUST
            .replace("5 kg", mass)
            .replace("0.1 s", "0.02 s")
            .replace("gravity = true", "");
        let (run, extremes) = run(&text);
        assert!(error(&run) < 1e-6, "{mass}: {}", error(&run));
        assert!(extremes.reach[2] < 1e-3, "{mass}: {extremes:?}");
    }
}

/// Tilts a thousand times faster than the freedoms along the axes ring out within milliseconds, but
/// hold an explicit method to their period for ever. Of a heavy rotor they are slower than all else.
#[test]
fn moments_of_inertia_a_hundred_million_times_apart() {
    let pair = "catalogue = \"7205C\"\narrangement = \"back-to-back\"\nspacing = \"60 mm\"\n\
                preload = \"200 N\"";
    for (transverse, polar, method) in [
        ("1e-7", "1e-7", "rodas"),
        ("10", "15", "dop853"),
        ("10", "1e-7", "dop853"),
    ] {
        let inertia = format!(
            "inertia_transverse = \"{transverse} kg m^2\"\n\
             inertia_polar = \"{polar} kg m^2\"\ngravity = true"
        );
        let text = THRUST
            .replace("translational", "all")
            .replace("gravity = true", &inertia)
            .replace("catalogue = \"7205C\"", pair)
            .replace("0.1 s", "0.05 s")
            .replace("z = \"1000 N\"", "z = \"100 N\", tilt_x = \"2 N m\"")
            .replace(
                "tolerance = 1e-8",
                &format!("tolerance = 1e-6\nmethod = \"{method}\""),
            );
        let (run, extremes) = run(&text);
        println!(
            "{transverse} {polar}: {:e} {:?} {:?}",
            error(&run),
            run.counters,
            extremes.reach
        );
        assert!(error(&run) < 1e-5, "{:e}", error(&run));
        assert!(work(&run) < 3000, "{:?}", run.counters);
        // 2 N m on some 1e4 N m/rad
        assert!(extremes.reach[3] < 1e-3, "{extremes:?}");
    }
}
