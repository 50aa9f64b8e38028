use jeffcott::{analysis::Window, bearing::*, integrate::*, rotor::*, simulate::*};
use std::sync::atomic::AtomicBool;
struct Sink(Vec<Sample>);
impl TraceSink for Sink {
    fn sample(&mut self, s: &Sample) -> std::io::Result<()> {
        self.0.push(*s);
        Ok(())
    }
}
#[test]
fn steady() {
    for (ecc, method, tol) in [
        (1e-5, Method::Dop853, 1e-8),
        (1e-5, Method::Dopri5, 1e-8),
        (0., Method::Dop853, 1e-8),
        (1e-5, Method::Dop853, 1e-5),
        (1e-5, Method::Dop853, 1e-12),
    ] {
        let m = Model {
            rotor: RotorDefinition {
                shaft: Shaft {
                    mass: 5.,
                    inertia_transverse: 0.,
                    inertia_polar: 0.,
                    eccentricity: ecc,
                    freedoms: Freedoms::Translational,
                    gravity: true,
                },
                speed: 500.,
                cage: CageMotion::Rolling,
                damping: Damping::Ratio(0.02),
                load: [0., 0., 1000., 0., 0.],
                initial: InitialState {
                    from: InitialPosition::Equilibrium,
                    displacement: [None; 5],
                    velocity: [None; 5],
                },
                bearings: vec![MountedBearing {
                    bearing: catalogue::find("7205C").unwrap().bearing().unwrap(),
                    law: ContactLaw::Hertz,
                    position: 0.,
                    facing: Facing::PlusZ,
                    preload: Preload::AxialOffset(0.),
                    first_ball: 0.,
                }],
            },
            duration: 0.5,
            settle: 0.2,
            sampling: Sampling::PerRevolution(128),
            integrator: Settings {
                method,
                tolerance: tol,
                step_limit: 100000000,
            },
            verify: true,
            spectrum: Some(Window::Rectangular),
        };
        let stop = AtomicBool::new(false);
        let mut sink = Sink(vec![]);
        let t = std::time::Instant::now();
        let r = simulate(
            &m,
            &mut sink,
            &mut Monitor {
                stop: &stop,
                progress: &mut |_| {},
            },
        )
        .unwrap();
        println!("{:?} {:?}", t.elapsed(), r.counters);
        println!(
            "{:?}\n{:?}",
            r.measured_error, r.equilibrium.natural_frequencies
        );
        println!("{:?}", Rotor::assemble(&m.rotor).unwrap().motion_scale(1e-9));
        for p in r.peaks.iter().take(8) {
            println!("{p:?}");
        }
        println!("{:?}", sink.0.last());
        for w in r.warnings {
            println!("{w}");
        }
    }
}
