//! Dormand, El-Mikkawy and Prince's pair 8(6): nine stages, the last of which is the first of the next step.
//!
//! Source: J. R. Dormand, M. E. A. El-Mikkawy & P. J. Prince, "High-order embedded Runge–Kutta–Nyström
//! formulae", *IMA J. Numer. Anal.* 7 (1987) 423–430. The errors are differences of its two sets of weights.

use super::tableau::{MOST, Pair, difference, padded, padded_rows};

/// Dormand, El-Mikkawy and Prince's pair 8(6).
pub(in crate::integrate) struct Dprkn8;

impl Pair for Dprkn8 {
    const STAGES: usize = 9;
    const ENDS_ON_STAGE: bool = true;
    const ORDER: i32 = 8;
    const ERROR_POWER: i32 = 9;
    const LOCAL_PART: f64 = 1.0;
    const STABILITY: f64 = 4.2096;
    const CROSSED: f64 = 3.56e-4;
    const NODES: [f64; MOST] = padded([
        0.0,
        1.0 / 20.0,
        1.0 / 10.0,
        3.0 / 10.0,
        1.0 / 2.0,
        7.0 / 10.0,
        9.0 / 10.0,
        1.0,
        1.0,
    ]);
    const ARGUMENTS: [[f64; MOST]; MOST] = padded_rows([
        padded([]),
        padded([1.0 / 800.0]),
        padded([1.0 / 600.0, 1.0 / 300.0]),
        padded([9.0 / 200.0, -9.0 / 100.0, 9.0 / 100.0]),
        padded([
            -66701.0 / 197352.0,
            28325.0 / 32892.0,
            -2665.0 / 5482.0,
            2170.0 / 24669.0,
        ]),
        padded([
            227015747.0 / 304251000.0,
            -54897451.0 / 30425100.0,
            12942349.0 / 10141700.0,
            -9499.0 / 304251.0,
            539.0 / 9250.0,
        ]),
        padded([
            -1131891597.0 / 901789000.0,
            41964921.0 / 12882700.0,
            -6663147.0 / 3220675.0,
            270954.0 / 644135.0,
            -108.0 / 5875.0,
            114.0 / 1645.0,
        ]),
        padded([
            13836959.0 / 3667458.0,
            -17731450.0 / 1833729.0,
            1063919505.0 / 156478208.0,
            -33213845.0 / 39119552.0,
            13335.0 / 28544.0,
            -705.0 / 14272.0,
            1645.0 / 57088.0,
        ]),
        padded([
            223.0 / 7938.0,
            0.0,
            1175.0 / 8064.0,
            925.0 / 6048.0,
            41.0 / 448.0,
            925.0 / 14112.0,
            1175.0 / 72576.0,
        ]),
    ]);
    const PLACE: [f64; MOST] = padded([
        223.0 / 7938.0,
        0.0,
        1175.0 / 8064.0,
        925.0 / 6048.0,
        41.0 / 448.0,
        925.0 / 14112.0,
        1175.0 / 72576.0,
    ]);
    const VELOCITY: [f64; MOST] = padded([
        223.0 / 7938.0,
        0.0,
        5875.0 / 36288.0,
        4625.0 / 21168.0,
        41.0 / 224.0,
        4625.0 / 21168.0,
        5875.0 / 36288.0,
        223.0 / 7938.0,
    ]);
    const PLACE_ERROR: [f64; MOST] = padded([
        -0.044557986852984274,
        0.0,
        0.10965442077101599,
        -0.14620589436135464,
        0.1315853049252192,
        -0.06265966901200913,
        0.012183824530112887,
    ]);
    const VELOCITY_ERROR: [f64; MOST] = padded([
        -0.044557986852984274,
        0.0,
        0.12183824530112887,
        -0.2088655633733638,
        0.2631706098504384,
        -0.2088655633733638,
        0.12183824530112887,
        0.10544201314701572,
        -0.15,
    ]);
    const COARSE_ERROR: [f64; MOST] = difference(&Self::NODES, &[0, 3, 4, 5, 7], 1e-3);
}
