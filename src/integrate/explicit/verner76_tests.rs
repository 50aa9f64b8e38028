//! A pair fulfils the order conditions: all of them, tree by tree.
//!
//! Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sec. II.2: a method
//! has order p where Σ_i b_i Φ_i(t) = 1/γ(t) for all rooted trees t of order up to p; an interpolant
//! where Σ_i b_i(θ) Φ_i(t) = θ^r/γ(t) for the trees of order r.

use super::*;
use crate::numerics::registers::in_baseline_registers;

/// A row of coefficients, a stage each.
type Weights = [f64; STAGES];

/// A row of the tableau, filled up with zeros.
fn padded(row: &[f64]) -> Weights {
    std::array::from_fn(|stage| entry(row, stage))
}

/// a_ij of a stage.
fn factors(stage: usize) -> Weights {
    padded(FACTORS[stage])
}

/// A rooted tree: the subtrees at its root, as positions in the list of all trees.
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
                .map(|&position: &usize| trees[position].gamma)
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

/// Choices of trees, from a position of the list on, whose orders add up to `left`.
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
    for (position, tree) in trees.iter().enumerate().skip(from) {
        if tree.order <= left {
            chosen.push(position);
            collect(trees, left - tree.order, position, chosen, found);
            chosen.pop();
        }
    }
}

/// Φ_i of every tree.
fn elementary(trees: &[Tree]) -> Vec<Weights> {
    let mut all: Vec<Weights> = Vec::new();
    for tree in trees {
        let mut weights = [1.0; STAGES];
        for &subtree in &tree.subtrees {
            for (stage, weight) in weights.iter_mut().enumerate() {
                *weight *= dot(&factors(stage), &all[subtree]);
            }
        }
        all.push(weights);
    }
    all
}

fn dot(left: &Weights, right: &Weights) -> f64 {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

/// Largest deviation of weights b_i(θ) from the conditions up to an order.
fn deviation(weights: &Weights, part: f64, order: usize) -> f64 {
    let trees = trees(order);
    let conditions = elementary(&trees);
    let off = |(tree, phi): (&Tree, &Weights)| {
        (dot(weights, phi) - part.powi(tree.order as i32) / tree.gamma).abs()
    };
    trees.iter().zip(&conditions).map(off).fold(0.0, f64::max)
}

fn difference(left: &Weights, right: &Weights) -> Weights {
    std::array::from_fn(|stage| left[stage] - right[stage])
}

/// Coefficients are given to 16 digits and reach some hundreds, those of interpolants a thousand.
const ROUND_OFF: f64 = 1e-13;
const ROUND_OFF_DENSE: f64 = 2e-12;
/// A condition that does not hold is off by more than this.
const BROKEN: f64 = 1e-9;

/// The weights have an order and not the next one.
fn has_order(weights: &Weights, part: f64, order: usize, round_off: f64) {
    let holds = deviation(weights, part, order);
    assert!(holds < round_off, "order {order} at {part}: {holds:e}");
    let broken = deviation(weights, part, order + 1);
    assert!(broken > BROKEN, "order {} at {part}: {broken:e}", order + 1);
}

fn nodes_are_row_sums() {
    assert_eq!(FACTORS.len(), NODES.len());
    for (stage, (row, node)) in FACTORS.iter().zip(NODES).enumerate() {
        let sum: f64 = row.iter().sum();
        assert!((sum - node).abs() < ROUND_OFF, "stage {stage}: {sum}");
        assert!(row.len() <= stage, "stage {stage}");
    }
}

/// The weights b_i(θ) stage by stage.
fn weights_within(part: f64) -> Weights {
    let weights = in_baseline_registers!(simd => dense_weights(simd, part));
    std::array::from_fn(|stage| weights.as_flattened()[stage])
}

fn interpolant_meets_the_ends() {
    let end = difference(&weights_within(1.0), &factors(LAST));
    assert!(
        end.iter().all(|weight| weight.abs() < ROUND_OFF_DENSE),
        "{end:?}"
    );
    // it leaves along the first stage
    for (stage, row) in DENSE.iter().enumerate() {
        let expected = if stage == 0 { 1.0 } else { 0.0 };
        assert!(
            (entry(row, 0) - expected).abs() < ROUND_OFF,
            "stage {stage}: {row:?}"
        );
    }
}

/// |R(−z)|, R the factor by which a step multiplies a decaying motion.
fn decay(z: f64) -> f64 {
    let mut slopes = [0.0; STAGES];
    for stage in 0..=LAST {
        slopes[stage] = -z * (1.0 + dot(&factors(stage), &slopes));
    }
    (1.0 + dot(&factors(LAST), &slopes)).abs()
}

fn limit_of_stability_is_that_of_the_coefficients() {
    assert!(decay(0.98 * STABILITY) < 1.0);
    assert!(decay(1.02 * STABILITY) > 1.0);
}

/// Error of the quadrature over 0 … 1, root mean square over the positions where a power begins.
fn quadrature_error(exponent: f64) -> f64 {
    const POSITIONS: u32 = 2000;
    let error = |position: f64| {
        let value = |node: &f64| (node - position).max(0.0).powf(exponent);
        let terms = FACTORS[LAST].iter().zip(NODES);
        let sum: f64 = terms.map(|(weight, node)| weight * value(&node)).sum();
        // ∫ x^n = x^(n+1)/(n+1)
        (1.0 - position).powf(exponent + 1.0) / (exponent + 1.0) - sum
    };
    let positions = (0..=POSITIONS).map(|position| f64::from(position) / f64::from(POSITIONS));
    let squares: f64 = positions.map(|position| error(position).powi(2)).sum();
    (squares / f64::from(POSITIONS + 1)).sqrt()
}

fn the_error_over_a_surface_is_as_stated() {
    for (exponent, within) in [(1.0, 0.34), (1.5, 0.02), (2.0, 0.34)] {
        let found = quadrature_error(exponent) / error_over_surface(exponent);
        assert!((found - 1.0).abs() < within, "{exponent}: {found}");
    }
}

#[test]
fn the_orders_are_seven_six_and_six_of_the_interpolant() {
    nodes_are_row_sums();
    interpolant_meets_the_ends();
    let weights = factors(LAST);
    has_order(&weights, 1.0, ORDER as usize, ROUND_OFF);
    let embedded_weights = difference(&weights, &padded(ERROR));
    has_order(&embedded_weights, 1.0, 6, ROUND_OFF);
    for part in [0.1, 0.37, 0.6, 0.83] {
        let weights = weights_within(part);
        has_order(&weights, part, 6, ROUND_OFF_DENSE);
    }
    limit_of_stability_is_that_of_the_coefficients();
    the_error_over_a_surface_is_as_stated();
}

#[test]
fn there_are_as_many_trees_as_known() {
    let trees = trees(8);
    let counts: Vec<usize> = (1..=8)
        .map(|order| trees.iter().filter(|tree| tree.order == order).count())
        .collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}
