//! Films so thin that they hardly are, and so thick that they are all there is.

use super::{THRUST, error, run, work};
use crate::tests::support::assert_near;

/// A 7205C under thrust, behind films of an oil of a viscosity in Pa s where one is given.
fn scene(contact: &str, viscosity: Option<f64>) -> String {
    let oil = viscosity.map_or(String::new(), |viscosity| {
        format!(
            "film = true\n[bearing.oil]\nviscosity = \"{viscosity:e} Pa s\"\n\
             pressure_viscosity = \"22 1/GPa\""
        )
    });
    let bearing = format!("catalogue = \"7205C\"\ncontact = \"{contact}\"\n{oil}");
    THRUST.replace("catalogue = \"7205C\"", &bearing)
}

/// Of a film thinner than an atom only its law is left: it must not drown in round-off, nor make the
/// force a wall. The shaft stands as far off its dry place as the film is thick: h ∝ η^0.67.
#[test]
fn a_film_thinner_than_an_atom() {
    for contact in ["hertz", "jones"] {
        let (dry_run, dry) = run(&scene(contact, None));
        let dry_place = dry_run.equilibrium.displacement[2];
        let shift = |viscosity: f64| {
            let (run, wet) = run(&scene(contact, Some(viscosity)));
            assert!(error(&run) < 1e-7, "{contact}: {:e}", error(&run));
            assert!(work(&run) < 1200, "{contact}: {:?}", run.counters);
            assert_near("swing", wet.reach[0], dry.reach[0], 1e-3 * dry.reach[0]);
            dry_place - run.equilibrium.displacement[2]
        };
        let (thin, thinner) = (shift(1e-6), shift(1e-9));
        println!("{contact}: {thin:e} m, {thinner:e} m");
        // films of 0.8 nm and 8 pm at both races together, over the sine of 19°
        assert!((1e-9..1e-8).contains(&thin), "{thin:e}");
        assert_near(
            "η^0.67",
            thinner / thin,
            1e-3_f64.powf(0.67),
            1e-3 * 1e-3_f64.powf(0.67),
        );
    }
}

/// A film many times thicker than the groove centres are apart (a wax of 10 kPa s): the balls ride on
/// oil alone, a thousand times their load wedges them between the races, and the inner ring is
/// centred axially, z = −A sin α0, whatever the thrust. The contacts are stiff, the motion small.
#[test]
fn a_film_thicker_than_the_room_for_it() {
    for contact in ["hertz", "jones"] {
        let mut before = f64::INFINITY;
        for viscosity in [0.04, 1.0, 100.0, 1e4] {
            let (run, extremes) = run(&scene(contact, Some(viscosity)));
            let place = run.equilibrium.displacement[2];
            println!(
                "{contact}, {viscosity} Pa s: z {place:e} m, {:e}, {:?}",
                error(&run),
                run.counters
            );
            assert!(place < before, "a thicker film presses the ring back");
            assert!(error(&run) < 1e-7, "{:e}", error(&run));
            assert!(work(&run) < 5000, "{:?}", run.counters);
            assert_eq!(extremes.fewest_balls, 12);
            before = place;
        }
        let centred = -0.3969e-3 * 15f64.to_radians().sin();
        assert_near("z", before, centred, 0.001 * centred.abs());
    }
}
