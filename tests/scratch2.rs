use jeffcott::{bearing::*, integrate::*, rotor::*};
#[test]
fn rhs() {
    for fr in [Freedoms::Radial, Freedoms::All] {
        let d = RotorDefinition {
            shaft: Shaft {
                mass: 5.,
                inertia_transverse: 0.01,
                inertia_polar: 0.004,
                eccentricity: 1e-5,
                freedoms: fr,
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
        };
        let r = Rotor::assemble(&d).unwrap();
        fn go<const N: usize>(r: &Rotor) {
            let q = r.equilibrium().displacement;
            let mut s = [0.; N];
            for i in 0..N / 2 {
                s[i] = q[i];
            }
            let mut rate = [0.; N];
            let mut best = 1e9f64;
            for _ in 0..60 {
                let t = std::time::Instant::now();
                for k in 0..50000 {
                    r.derivative(k as f64 * 1e-5, &s, &mut rate);
                    s[0] += 1e-20 * rate[N / 2];
                }
                best = best.min(t.elapsed().as_secs_f64() / 5e4 * 1e9);
            }
            println!("N {N} {best:.1} ns {}", s[0]);
            let t = std::time::Instant::now();
            let mut a = 0.;
            for k in 0..1000000 {
                let (x, y) = (k as f64 * 1e-3).sin_cos();
                a += x + y;
            }
            println!("sincos {:.1} ns {a}", t.elapsed().as_secs_f64() * 1e3);
            let mut f = q;
            let mut best = 1e9f64;
            for _ in 0..60 {
                let t = std::time::Instant::now();
                for k in 0..50000 {
                    let o = r.supports()[0].force(&f, CageAngle { cos: 0.6, sin: 0.8 }, 500.);
                    f[0] += 1e-25 * o[1] + 1e-30 * k as f64;
                }
                best = best.min(t.elapsed().as_secs_f64() / 5e4 * 1e9);
            }
            println!("force {best:.1} ns {}", f[0]);
        }
        if fr == Freedoms::Radial {
            go::<4>(&r)
        } else {
            go::<10>(&r)
        }
    }
}
