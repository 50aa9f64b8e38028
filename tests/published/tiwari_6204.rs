//! Ball bearing 6204 of Tiwari, Gupta & Prakash (2000).

use crate::support::{literature_bearing, model, mounted, rotor, samples, settings, shaft};
use jeffcott::bearing::MountedBearing;
use jeffcott::rotor::{Damping, Freedoms, RotorDefinition, Shaft};

#[test]
fn scan() {
    for clearance in [0.5e-6, 1e-6] {
        for rpm in [500.0f64, 2000.0, 5000.0, 9000.0, 11000.0, 12000.0, 13000.0, 13250.0, 13500.0, 14000.0, 15000.0, 15250.0, 15500.0, 16000.0, 18000.0, 20000.0] {
            let speed = rpm * std::f64::consts::PI / 30.0;
            let diameters = [7.938e-3, 7.938e-3 / (1.0 - 2.0 * 3.05 / 8.0)];
            let definition = RotorDefinition {
                speed,
                damping: Damping::Coefficients([200.0, 200.0, 0.0, 0.0, 0.0]),
                load: [0.0, -6.0, 0.0, 0.0, 0.0],
                ..rotor(
                    Shaft { mass: 0.6, ..shaft(Freedoms::Radial) },
                    vec![MountedBearing { first_ball: -std::f64::consts::FRAC_PI_2, ..mounted(literature_bearing(8, diameters, clearance, 7.055e9)) }],
                )
            };
            let pass = std::f64::consts::TAU / (3.05 * speed);
            let n = 2000.0f64.max(2.0 / pass).min(2000.0);
            let mut model = model(definition, (n + 0.5) * pass, 1.0 / pass);
            model.integrator = settings(1e-9);
            let s = samples(&model, (n - 64.5) * pass);
            let y: Vec<f64> = s.iter().map(|s| s.displacement[1]).collect();
            let x: Vec<f64> = s.iter().map(|s| s.displacement[0]).collect();
            let ch = |p: usize| (0..y.len() - p).map(|k| (y[k] - y[k + p]).abs().max((x[k]-x[k+p]).abs())).fold(0.0, f64::max);
            println!("{clearance:e} {rpm} {:.2e} {:.2e} {:.2e} {:.2e}", ch(1), ch(2), ch(4), ch(8));
        }
    }
}
