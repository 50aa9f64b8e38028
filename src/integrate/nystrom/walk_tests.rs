//! Steps of equal size show the orders of the pairs, and that linear damping costs nothing.

use std::sync::atomic::AtomicBool;

use super::*;
use crate::integrate::nystrom::entries::{All, Few};
use crate::integrate::nystrom::{Dprkn8, Dprkn12};
use crate::integrate::{Method, Settings, VelocityDependence};

/// A = ∂q″/∂q′ without its sign: damping, and a gyroscopic coupling.
const BRAKE: [[f64; 2]; 2] = [[0.3, 0.8], [-0.8, 0.1]];

/// q″ + A q′ = −(1 + sin(t)/2) (q₁³, q₂³) + (cos 2t, q₁): time enters, and it is not linear.
struct Coupled {
    pushed: bool,
}

impl System<4> for Coupled {
    fn derivative(&self, time: f64, [x, y, u, v]: &[f64; 4], rate: &mut [f64; 4]) {
        let push = f64::from(u8::from(self.pushed));
        let stiffness = 1.0 + 0.5 * time.sin();
        let force = [
            push * ((2.0 * time).cos() - stiffness * x.powi(3)),
            push * (x - stiffness * y.powi(3)),
        ];
        let [[a, b], [c, d]] = BRAKE;
        *rate = [*u, *v, force[0] - a * u - b * v, force[1] - c * u - d * v];
    }

    fn velocity_slopes(&self) -> Result<[[f64; 4]; 4], VelocityDependence> {
        let mut slopes = [[0.0; 4]; 4];
        for (row, brake) in slopes.iter_mut().zip(&BRAKE) {
            row[0] = -brake[0];
            row[1] = -brake[1];
        }
        Ok(slopes)
    }
}

const START: [f64; 4] = [1.0, -0.5, 0.2, 0.4];

/// The end of a walk over a time in so many equal steps.
fn walked<P: Pair, E: Entries<4>>(pushed: bool, steps: u32, time: f64) -> [f64; 4] {
    let (stop, scaling) = (AtomicBool::new(false), Scaling::IDENTITY);
    let settings = Settings {
        method: Method::Dprkn8,
        tolerance: 1.0,
        step_limit: u64::MAX,
    };
    let course = Course {
        system: &Coupled { pushed },
        scaling: &scaling,
        settings: &settings,
        stop: &stop,
        end: 100.0,
        slack: 1e-9,
    };
    let mut walk = Walk::new(START);
    let slopes = course.system.velocity_slopes().unwrap();
    let mut factor = Factor::<E, 4>::new(&slopes);
    let size = time / f64::from(steps);
    for step in 1..=steps {
        walk.begin::<P, _, E>(&course, &factor);
        walk.size = size;
        walk.trial::<P, _, E>(&course, &mut factor);
        walk.to.time = size * f64::from(step);
        walk.finish::<P, _>(&course);
    }
    walk.to.state
}

fn distance(left: &[f64; 4], right: &[f64; 4]) -> f64 {
    let apart = left.iter().zip(right).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max)
}

fn steps_have_order<P: Pair>(steps: u32) {
    let end = |steps| walked::<P, Few<4>>(true, steps, 4.0);
    let truth = walked::<Dprkn12, Few<4>>(true, 200, 4.0);
    let error = |steps| distance(&end(steps), &truth);
    let (coarse, fine) = (error(steps), error(2 * steps));
    let observed = (coarse / fine).log2();
    println!("{coarse:e} {fine:e}");
    let excess = observed - f64::from(P::ORDER);
    assert!((-0.6..1.6).contains(&excess), "observed {observed}");
}

#[test]
fn equal_steps_converge_with_the_order_of_the_method() {
    steps_have_order::<Dprkn8>(12);
    steps_have_order::<Dprkn12>(8);
}

/// The truth by a Runge–Kutta pair that knows nothing of the factor.
#[test]
fn a_runge_kutta_pair_comes_to_the_same_end() {
    use crate::integrate::explicit::{self, Dop853};
    let (stop, scaling) = (AtomicBool::new(false), Scaling::IDENTITY);
    let settings = Settings {
        method: Method::Dop853,
        tolerance: 1e-13,
        step_limit: u64::MAX,
    };
    let course = Course {
        system: &Coupled { pushed: true },
        scaling: &scaling,
        settings: &settings,
        stop: &stop,
        end: 4.0,
        slack: 1e-9,
    };
    let truth = explicit::Walk::new(START).state_at::<Dop853, _>(&course, 4.0);
    let end = walked::<Dprkn12, Few<4>>(true, 50, 4.0);
    let off = distance(&end, &truth.unwrap());
    assert!(off < 1e-12, "{off:e}");
}

/// Where nothing but A acts, q = q₀ + A⁻¹ (v₀ − v), and one long step knows nearly all of it.
#[test]
fn linear_damping_and_coupling_cost_next_to_nothing() {
    let one = walked::<Dprkn8, Few<4>>(false, 1, 1.0);
    let many = walked::<Dprkn12, Few<4>>(false, 64, 1.0);
    assert!(distance(&one, &many) < 2e-8, "{one:?} {many:?}");
    let [[a, b], [c, d]] = BRAKE;
    let lost = [START[2] - many[2], START[3] - many[3]];
    let determinant = a * d - b * c;
    let place = [
        START[0] + (d * lost[0] - b * lost[1]) / determinant,
        START[1] + (a * lost[1] - c * lost[0]) / determinant,
    ];
    let velocity = [many[2], many[3]];
    assert!((place[0] - many[0]).abs() < 1e-14 && (place[1] - many[1]).abs() < 1e-14);
    let speed = |[u, v]: [f64; 2]| u * u + v * v;
    assert!(speed(velocity) < speed([START[2], START[3]]));
}

#[test]
fn all_entries_do_what_few_do() {
    let few = walked::<Dprkn8, Few<4>>(true, 20, 4.0);
    let all = walked::<Dprkn8, All<4>>(true, 20, 4.0);
    assert!(distance(&few, &all) < 1e-14, "{few:?} {all:?}");
}

#[test]
fn what_couples_more_than_the_last_two_needs_all_entries() {
    let few = |pairs: &[(usize, usize)]| {
        let mut matrix = [[0.0; 10]; 10];
        for &(row, column) in pairs {
            matrix[row][column] = 1.0;
        }
        Few::<10>::holds(&matrix)
    };
    assert!(few(&[]) && few(&[(0, 0), (3, 3)]) && few(&[(3, 4), (4, 3), (1, 1)]));
    assert!(!few(&[(3, 2)]) && !few(&[(0, 4)]) && !few(&[(0, 1)]));
}

#[test]
fn entries_of_motions_side_by_side_multiply_as_whole_matrices() {
    const N: usize = 24;
    // three freedoms of four motions: the last two are coupled
    let mut matrices = [[[0.0; N]; N]; 2];
    for (part, matrix) in matrices.iter_mut().enumerate() {
        for (index, row) in matrix.iter_mut().enumerate().take(N / 2) {
            row[index] = 1.0 + (index as f64 + part as f64).sin();
        }
        for motion in 0..4 {
            matrix[4 + motion][8 + motion] = 0.3 + motion as f64;
            matrix[8 + motion][4 + motion] = -0.7 * motion as f64 - part as f64;
        }
    }
    let [first, second] = matrices;
    assert!(Few::<N, 4>::holds(&first) && !Few::<N>::holds(&first));
    let mut vector = Row::ZERO;
    for (index, component) in vector.iter_mut().enumerate().take(N / 2) {
        *component = (1.3 * index as f64).cos();
    }
    let few = [first, second].map(|matrix| Few::<N, 4>::of(&matrix));
    let all = [first, second].map(|matrix| All::<N>::of(&matrix));
    let products = [
        few[0].product(&few[1]).times(Fallback::new(), &vector),
        all[0].product(&all[1]).times(Fallback::new(), &vector),
    ];
    for (few, all) in products[0].iter().zip(products[1].iter()) {
        assert!(
            (few - all).abs() < 1e-14 * all.abs().max(1.0),
            "{few} {all}"
        );
    }
    let mut coupled = first;
    coupled[4][9] = 1.0;
    assert!(!Few::<N, 4>::holds(&coupled));
}
