//! Which runs a study of many has, and what each is given.

use std::collections::BTreeSet;

use crate::analysis::SectionKind;
use crate::study::many::{Cycles, Schedule, Shard, Sweep};
use crate::study::plan::{Axis, Distribution, Plan, Sampling, Shape, sobol};

/// scipy.stats.qmc.Sobol(d=16, scramble=False, bits=32) of SciPy 1.17.
#[test]
fn sobols_points_are_those_of_scipy() {
    let points: [(u64, [f64; 16]); 4] = [
        (
            1,
            [
                0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5,
            ],
        ),
        (
            5,
            [
                0.875, 0.875, 0.125, 0.375, 0.875, 0.625, 0.875, 0.375, 0.375, 0.125, 0.375, 0.875,
                0.875, 0.125, 0.875, 0.375,
            ],
        ),
        (
            100,
            [
                0.414_062_5,
                0.257_812_5,
                0.773_437_5,
                0.726_562_5,
                0.882_812_5,
                0.742_187_5,
                0.023_437_5,
                0.476_562_5,
                0.632_812_5,
                0.695_312_5,
                0.460_937_5,
                0.679_687_5,
                0.476_562_5,
                0.851_562_5,
                0.320_312_5,
                0.492_187_5,
            ],
        ),
        (
            1023,
            [
                0.000_976_562_5,
                0.752_929_687_5,
                0.612_304_687_5,
                0.145_507_812_5,
                0.186_523_437_5,
                0.438_476_562_5,
                0.139_648_437_5,
                0.618_164_062_5,
                0.344_726_562_5,
                0.850_585_937_5,
                0.678_710_937_5,
                0.036_132_812_5,
                0.129_882_812_5,
                0.665_039_062_5,
                0.362_304_687_5,
                0.463_867_187_5,
            ],
        ),
    ];
    for (index, point) in points {
        for (axis, coordinate) in point.into_iter().enumerate() {
            assert_eq!(sobol(index, axis), coordinate, "point {index}, axis {axis}");
        }
    }
}

/// Every one of n parts of every axis is met once.
#[test]
fn a_latin_hypercube_meets_every_part_once() {
    let axis = |to| Axis::Spaced {
        from: 0.0,
        to,
        count: 2,
        logarithmic: false,
    };
    for runs in [1, 2, 7, 64, 1000] {
        let plan = Plan::new(
            vec![axis(1.0), axis(1.0)],
            Sampling::LatinHypercube(runs),
            5,
        );
        for place in 0..2 {
            let parts: BTreeSet<u64> = (0..runs)
                .map(|run| (plan.values(run)[place] * runs as f64) as u64)
                .collect();
            assert_eq!(parts.len() as u64, runs);
        }
    }
}

/// Mean and deviation of a cut normal distribution, from its closed form with bounds at ±1 deviation:
/// variance 1 − 2 φ(1)/(2 Φ(1) − 1) = 0.291 124 72.
#[test]
fn draws_have_the_moments_of_their_distribution() {
    let axis = Axis::Drawn(Distribution {
        lowest: 1.0,
        highest: 5.0,
        shape: Shape::Normal {
            mean: 3.0,
            deviation: 2.0,
        },
    });
    let runs = 4096;
    let plan = Plan::new(vec![axis], Sampling::Sobol(runs), 9);
    let drawn: Vec<f64> = (0..runs).map(|run| plan.values(run)[0]).collect();
    let mean = drawn.iter().sum::<f64>() / runs as f64;
    let variance = drawn.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / runs as f64;
    // the sequence integrates smooth functions to about 1/n
    assert!((mean - 3.0).abs() < 1e-3, "{mean}");
    assert!((variance - 4.0 * 0.291_124_72).abs() < 3e-3, "{variance}");
}

/// The values of a run depend on its number and the seed alone.
#[test]
fn another_seed_draws_other_values() {
    let axis = Axis::Drawn(Distribution {
        lowest: 0.0,
        highest: 1.0,
        shape: Shape::Uniform,
    });
    for sampling in [
        Sampling::MonteCarlo(100),
        Sampling::LatinHypercube(100),
        Sampling::Sobol(100),
    ] {
        let plan = |seed| Plan::new(vec![axis.clone()], sampling, seed);
        assert_eq!(plan(1).values(17), plan(1).values(17));
        assert_ne!(plan(1).values(17), plan(2).values(17));
    }
}

/// Every chain stands in one part, whatever the number of parts.
#[test]
fn parts_hold_every_chain_once() {
    let schedule = Schedule::new(300, 3, Some(Sweep::Both));
    for count in [1, 2, 7, 99, 100, 250] {
        let chains = (1..=count).flat_map(|number| Shard { number, count }.chains(&schedule));
        assert!(chains.eq(0..schedule.chains()));
    }
}

#[test]
fn times_of_cycles_are_whole_ball_passes() {
    let scene = crate::scenario::load("scenarios/varying-compliance-6306.toml".as_ref()).unwrap();
    let cycles = Cycles {
        of: SectionKind::BallPass,
        settle: 200,
        kept: 100,
    };
    let [settle, duration] = cycles.times(&scene.model.unwrap().rotor).unwrap();
    // at 150 rad/s 8 balls pass 8 (1 − 11.9062/52)/2 = 3.0841 times a revolution of 41.888 ms
    assert!((settle - 200.0 * 0.0418879 / 3.084138).abs() < 1e-6);
    assert!((duration / settle - 1.5).abs() < 1e-12);
}
