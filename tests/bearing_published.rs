//! scratch
use jeffcott::bearing::*;
fn support(desig: &str, first: f64) -> Support {
    Support::new(&MountedBearing {
        bearing: catalogue::find(desig).unwrap().bearing().unwrap(),
        law: ContactLaw::Hertz,
        position: 0.,
        facing: Facing::PlusZ,
        preload: Preload::AxialOffset(0.),
        first_ball: first,
    })
    .unwrap()
}
#[test]
fn thrust() {
    for (first, load, free) in [
        (0., [0., 0., 200., 0., 0.], [true; 5]),
        (0., [0., 0., 1000., 0., 0.], [true; 5]),
        (
            90f64.to_radians(),
            [0., 300., 1000., 0., 0.],
            [true, true, true, false, false],
        ),
        (90f64.to_radians(), [0., 300., 1000., 0., 0.], [true; 5]),
        (0., [0., -5., 0., 0., 0.], [true, true, true, false, false]),
        (0., [0., -5., 0., 0., 0.], [true; 5]),
    ] {
        let s = [support("7205C", first)];
        let p = equilibrium::StaticProblem {
            supports: &s,
            load,
            free,
            start: [0.; 5],
            speed: 0.,
        };
        match p.solve() {
            Ok(e) => {
                println!(
                    "{:?} res {:e} steps {}\n{:.6}",
                    e.displacement, e.residual, e.newton_steps, e.stiffness
                );
                let q: Vec<_> = s[0]
                    .contacts(&e.displacement, CageAngle::START, 0.)
                    .map(|c| (c.load_inner, c.angle_inner.to_degrees()))
                    .collect();
                println!("{q:?}");
            }
            Err(e) => println!("{e}"),
        }
    }
    for (load, free) in [
        ([1000., 0., 0., 0., 0.], [true, true, false, false, false]),
        ([0., 0., 1000., 0., 0.], [true, true, true, false, false]),
        ([0., 0., 0., 1.0, 0.], [true; 5]),
    ] {
        let s = [support("6305", 0.)];
        let p = equilibrium::StaticProblem {
            supports: &s,
            load,
            free,
            start: [0.; 5],
            speed: 0.,
        };
        match p.solve() {
            Ok(e) => println!(
                "6305 {:?} res {:e} steps {}",
                e.displacement, e.residual, e.newton_steps
            ),
            Err(e) => println!("{e}"),
        }
    }
}
