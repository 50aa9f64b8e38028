//! The pair fulfils the order conditions: all of them, tree by tree.
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sec. II.2: a method
//! has order p where Σ_i b_i Φ_i(t) = 1/γ(t) for all rooted trees t of order up to p; an interpolant
//! where Σ_i b_i(θ) Φ_i(t) = θ^r/γ(t) for the trees of order r.

use super::verner76::{
    CROSSED, DENSE, ERROR, FACTORS, LAST, NODES, ORDER, STABILITY, STAGES, dense_weights,
};

/// A rooted tree: the subtrees at its root, as places in the list of all trees.
struct Tree {
    order: usize,
    subtrees: Vec<usize>,
    gamma: f64,
}

/// All rooted trees up to an order, small ones first.
fn trees(most: usize) -> Vec<Tree> {
    let mut trees = Vec::new();
    for order in 1..=most {
        let mut found = Vec::new();
        collect(&trees, order - 1, 0, &mut Vec::new(), &mut found);
        for subtrees in found {
            let below: f64 = subtrees
                .iter()
                .map(|&place: &usize| trees[place].gamma)
                .product();
            trees.push(Tree {
                order,
                subtrees,
                gamma: order as f64 * below,
            });
        }
    }
    trees
}

/// Choices of trees, from a place of the list on, whose orders add up to `left`.
fn collect(
    trees: &[Tree],
    left: usize,
    from: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if left == 0 {
        found.push(chosen.clone());
        return;
    }
    for (place, tree) in trees.iter().enumerate().skip(from) {
        if tree.order <= left {
            chosen.push(place);
            collect(trees, left - tree.order, place, chosen, found);
            chosen.pop();
        }
    }
}

/// Φ_i of every tree.
fn elementary(trees: &[Tree]) -> Vec<[f64; STAGES]> {
    let mut all: Vec<[f64; STAGES]> = Vec::new();
    for tree in trees {
        let mut weights = [1.0; STAGES];
        for &subtree in &tree.subtrees {
            for (stage, weight) in weights.iter_mut().enumerate() {
                *weight *= dot(&FACTORS[stage], &all[subtree]);
            }
        }
        all.push(weights);
    }
    all
}

fn dot(left: &[f64; STAGES], right: &[f64; STAGES]) -> f64 {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

/// Largest deviation of weights b_i(θ) from the conditions up to an order.
fn deviation(weights: &[f64; STAGES], part: f64, order: usize) -> f64 {
    let trees = trees(order);
    let conditions = elementary(&trees);
    let off = |(tree, phi): (&Tree, &[f64; STAGES])| {
        (dot(weights, phi) - part.powi(tree.order as i32) / tree.gamma).abs()
    };
    trees.iter().zip(&conditions).map(off).fold(0.0, f64::max)
}

fn difference(left: &[f64; STAGES], right: &[f64; STAGES]) -> [f64; STAGES] {
    std::array::from_fn(|stage| left[stage] - right[stage])
}

/// Coefficients are given to 16 digits and reach some hundreds, those of interpolants a thousand.
const ROUND_OFF: f64 = 1e-13;
const ROUND_OFF_DENSE: f64 = 2e-12;
/// A condition that does not hold is off by more than this.
const BROKEN: f64 = 1e-9;

/// The weights have an order and not the next one.
fn has_order(weights: &[f64; STAGES], part: f64, order: usize, round_off: f64) {
    let holds = deviation(weights, part, order);
    assert!(holds < round_off, "order {order} at {part}: {holds:e}");
    let broken = deviation(weights, part, order + 1);
    assert!(broken > BROKEN, "order {} at {part}: {broken:e}", order + 1);
}

fn nodes_are_row_sums() {
    for stage in 0..STAGES {
        let row = &FACTORS[stage];
        let sum: f64 = row.iter().sum();
        assert!(
            (sum - NODES[stage]).abs() < ROUND_OFF,
            "stage {stage}: {sum}"
        );
        assert!(
            row[stage..].iter().all(|later| *later == 0.0),
            "stage {stage}"
        );
    }
}

fn interpolant_meets_the_ends() {
    let end = difference(&dense_weights(1.0), &FACTORS[LAST]);
    assert!(
        end.iter().all(|weight| weight.abs() < ROUND_OFF_DENSE),
        "{end:?}"
    );
    // it leaves along the first stage
    for (stage, row) in DENSE.iter().enumerate() {
        let expected = if stage == 0 { 1.0 } else { 0.0 };
        assert!(
            (row[0] - expected).abs() < ROUND_OFF,
            "stage {stage}: {row:?}"
        );
    }
}

fn check(embedded: usize, interpolant: usize) {
    nodes_are_row_sums();
    interpolant_meets_the_ends();
    let weights = FACTORS[LAST];
    has_order(&weights, 1.0, ORDER as usize, ROUND_OFF);
    has_order(
        &difference(&weights, &FACTORS[ERROR]),
        1.0,
        embedded,
        ROUND_OFF,
    );
    for part in [0.1, 0.37, 0.6, 0.83] {
        has_order(&dense_weights(part), part, interpolant, ROUND_OFF_DENSE);
    }
}

/// |R(−z)|, R the factor by which a step multiplies a decaying motion.
fn decay(z: f64) -> f64 {
    let mut slopes = [0.0; STAGES];
    for stage in 0..=LAST {
        slopes[stage] = -z * (1.0 + dot(&FACTORS[stage], &slopes));
    }
    (1.0 + dot(&FACTORS[LAST], &slopes)).abs()
}

#[test]
fn limits_of_stability_are_those_of_the_coefficients() {
    assert!(decay(0.98 * STABILITY) < 1.0);
    assert!(decay(1.02 * STABILITY) > 1.0);
}

#[test]
fn there_are_as_many_trees_as_known() {
    let trees = trees(8);
    let counts: Vec<usize> = (1..=8)
        .map(|order| trees.iter().filter(|tree| tree.order == order).count())
        .collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn verner76_has_orders_seven_and_six_and_its_interpolant_six() {
    check(6, 6);
}

/// Error of a quadrature by weights at nodes of 0 … 1, root mean square over the places where a power 3/2 begins.
fn error_over_a_kink(weights: &[f64], nodes: &[f64]) -> f64 {
    const PLACES: u32 = 2000;
    let error = |place: f64| {
        let value = |node: &f64| (node - place).max(0.0).powf(1.5);
        let terms = weights.iter().zip(nodes);
        let sum: f64 = terms.map(|(weight, node)| weight * value(node)).sum();
        // ∫ x^(3/2) = 2/5 x^(5/2)
        0.4 * (1.0 - place).powf(2.5) - sum
    };
    let places = (0..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
    let squares: f64 = places.map(|place| error(place).powi(2)).sum();
    (squares / f64::from(PLACES + 1)).sqrt()
}

#[test]
fn the_error_over_a_kink_is_as_stated() {
    let found = error_over_a_kink(&FACTORS[LAST], &NODES);
    assert!((found / CROSSED - 1.0).abs() < 0.02, "{found}");
}
