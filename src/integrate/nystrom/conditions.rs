//! The pairs fulfil the order conditions: all of them, tree by tree.
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sec. II.14: of
//! q″ = f(t, q) a tree stands for a product of powers of c and of sums over a, which along the true motion
//! is a number times τ^s. Then Σ b_i Φ_i = number/((s+1)(s+2)) up to s = p − 2 makes the place of order p,
//! Σ d_i Φ_i = number/(s+1) up to s = p − 1 the velocity.

use super::tableau::{MOST, Pair};
use super::{Dprkn8, Dprkn12};
use crate::integrate::stride::error_over_a_kink;

/// A tree: its power of τ, how many leaves it has at its root that are velocities, and the subtrees there.
struct Tree {
    power: usize,
    leaves: usize,
    subtrees: Vec<usize>,
}

/// All trees up to a power, small ones first.
fn trees(most: usize) -> Vec<Tree> {
    let mut trees: Vec<Tree> = Vec::new();
    for power in 0..=most {
        let mut found = Vec::new();
        collect(&trees, power, 0, &mut Vec::new(), &mut found);
        trees.extend(found.into_iter().map(|(leaves, subtrees)| Tree {
            power,
            leaves,
            subtrees,
        }));
    }
    trees
}

/// Choices of subtrees, from a place of the list on, and of leaves for the power that they leave.
fn collect(
    trees: &[Tree],
    left: usize,
    from: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<(usize, Vec<usize>)>,
) {
    found.push((left, chosen.clone()));
    for (place, tree) in trees.iter().enumerate().skip(from) {
        // two integrations add two powers
        if tree.power + 2 <= left {
            chosen.push(place);
            collect(trees, left - tree.power - 2, place, chosen, found);
            chosen.pop();
        }
    }
}

/// Φ_i of a tree and its number.
type Value = ([f64; MOST], f64);

fn values<P: Pair>(trees: &[Tree]) -> Vec<Value> {
    let mut values: Vec<Value> = Vec::new();
    for tree in trees {
        let mut phi = P::NODES.map(|node| node.powi(tree.leaves as i32));
        let mut number = 1.0;
        for &place in &tree.subtrees {
            let (below, part) = values[place];
            for (stage, phi) in phi.iter_mut().enumerate() {
                *phi *= dot(&P::ARGUMENTS[stage], &below);
            }
            let power = trees[place].power as f64;
            number *= part / ((power + 1.0) * (power + 2.0));
        }
        values.push((phi, number));
    }
    values
}

fn dot(left: &[f64; MOST], right: &[f64; MOST]) -> f64 {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

fn difference(left: &[f64; MOST], right: &[f64; MOST]) -> [f64; MOST] {
    std::array::from_fn(|stage| left[stage] - right[stage])
}

/// Largest deviation of weights of place and velocity from the conditions of an order alone.
fn deviation<P: Pair>([place, velocity]: [&[f64; MOST]; 2], order: usize) -> f64 {
    let trees = trees(order - 1);
    let mut worst: f64 = 0.0;
    for (tree, (phi, number)) in trees.iter().zip(values::<P>(&trees)) {
        let next = tree.power as f64 + 1.0;
        if tree.power + 1 == order {
            worst = worst.max((dot(velocity, &phi) - number / next).abs());
        }
        if tree.power + 2 == order {
            worst = worst.max((dot(place, &phi) - number / (next * (next + 1.0))).abs());
        }
    }
    worst
}

/// A condition that holds is off by round-off.
const ROUND_OFF: f64 = 1e-15;
/// A condition that does not hold is off by more than this.
const BROKEN: f64 = 1e-8;

/// The weights have an order and not the next one.
fn has_order<P: Pair>(weights: [&[f64; MOST]; 2], order: usize) {
    for order in 1..=order {
        let off = deviation::<P>(weights, order);
        assert!(off < ROUND_OFF, "order {order}: {off:e}");
    }
    let broken = deviation::<P>(weights, order + 1);
    assert!(broken > BROKEN, "order {}: {broken:e}", order + 1);
}

fn rows_sum_to_half_the_square_of_their_node<P: Pair>() {
    for stage in 0..P::STAGES {
        let row = &P::ARGUMENTS[stage];
        let off = row.iter().sum::<f64>() - 0.5 * P::NODES[stage].powi(2);
        let size: f64 = row.iter().map(|factor| factor.abs()).sum();
        assert!(off.abs() <= size * f64::EPSILON, "stage {stage}: {off:e}");
        assert!(
            row[stage..].iter().all(|later| *later == 0.0),
            "stage {stage}"
        );
    }
}

fn check<P: Pair>(embedded: usize) {
    rows_sum_to_half_the_square_of_their_node::<P>();
    assert_eq!(P::NODES[P::STAGES - 1], 1.0);
    if P::ENDS_ON_STAGE {
        assert_eq!(P::ARGUMENTS[P::STAGES - 1], P::PLACE);
    }
    has_order::<P>([&P::PLACE, &P::VELOCITY], P::ORDER as usize);
    let place = difference(&P::PLACE, &P::PLACE_ERROR);
    let velocity = difference(&P::VELOCITY, &P::VELOCITY_ERROR);
    has_order::<P>([&place, &velocity], embedded);
}

/// The coarser estimate vanishes where f is a polynomial in time of less than a degree, and not at it.
fn coarse_estimate_sees_degree<P: Pair>(degree: i32) {
    let at = |degree: i32| dot(&P::COARSE_ERROR, &P::NODES.map(|node| node.powi(degree)));
    let unit = at(degree);
    assert!(unit > 0.0);
    for less in 0..degree {
        assert!(at(less).abs() < 1e-10 * unit, "{less}: {}", at(less));
    }
}

#[test]
fn there_are_as_many_trees_as_known() {
    let trees = trees(8);
    let of = |power| trees.iter().filter(|tree| tree.power == power).count();
    let counts: Vec<usize> = (0..=8).map(of).collect();
    assert_eq!(counts, [1, 1, 2, 3, 6, 10, 20, 36, 72]);
}

#[test]
fn dprkn8_has_orders_eight_and_six() {
    check::<Dprkn8>(6);
    coarse_estimate_sees_degree::<Dprkn8>(4);
}

#[test]
fn dprkn12_has_orders_twelve_and_ten() {
    check::<Dprkn12>(10);
    coarse_estimate_sees_degree::<Dprkn12>(8);
}

/// Largest factor by which a step enlarges an undamped oscillation, from step × circular frequency.
fn growth<P: Pair>(phase: f64) -> f64 {
    let step = |place: f64, velocity: f64| {
        let mut stages = [0.0; MOST];
        for stage in 0..P::STAGES {
            let moved = place + P::NODES[stage] * velocity + dot(&P::ARGUMENTS[stage], &stages);
            stages[stage] = -phase * phase * moved;
        }
        let end = place + velocity + dot(&P::PLACE, &stages);
        [end, velocity + dot(&P::VELOCITY, &stages)]
    };
    let ([a, c], [b, d]) = (step(1.0, 0.0), step(0.0, 1.0));
    let (half, product) = (0.5 * (a + d), a * d - b * c);
    let apart = half * half - product;
    if apart < 0.0 {
        product.sqrt()
    } else {
        half.abs() + apart.sqrt()
    }
}

/// Growth that damping of a few parts in a thousand outweighs.
const HARMLESS: f64 = 1.01;

fn check_stability<P: Pair>() {
    assert!(growth::<P>(0.98 * P::STABILITY) < HARMLESS);
    assert!(growth::<P>(1.02 * P::STABILITY) > HARMLESS);
}

#[test]
fn limits_of_stability_are_those_of_the_coefficients() {
    check_stability::<Dprkn8>();
    check_stability::<Dprkn12>();
}

fn check_error_over_a_kink<P: Pair>() {
    let found = error_over_a_kink(&P::VELOCITY, &P::NODES);
    assert!((found / P::CROSSED - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn the_error_over_a_kink_is_as_stated() {
    check_error_over_a_kink::<Dprkn8>();
    check_error_over_a_kink::<Dprkn12>();
}
