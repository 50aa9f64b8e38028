//! Tsitouras's pair of orders 5 and 4: seven stages, the last of which is the next step's first, and
//! an interpolant of order 4 from the same stages.
//!
//! Source: Ch. Tsitouras, "Runge–Kutta pairs of order 5(4) satisfying only the first column
//! simplifying assumption", *Computers & Mathematics with Applications* 62 (2011) 770–775. The paper
//! prints e_7 with the wrong sign.

use super::tableau::{DEGREE, MOST, Pair, padded, padded_rows};

/// Tsitouras's pair 5(4).
pub(in crate::integrate) struct Tsit5;

impl Pair for Tsit5 {
    const TRIAL: usize = 7;
    const LAST: usize = 6;
    const STAGES: usize = 7;
    const ORDER: i32 = 5;
    const ERROR_POWER: i32 = 5;
    const LOCAL_PART: f64 = 0.1;
    const STABILITY: f64 = 3.55;
    const CROSSED: f64 = 4.3e-3;
    const NODES: [f64; MOST] = padded([0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0]);
    const ARGUMENTS: [[f64; MOST]; MOST] = padded_rows([
        [0.0; MOST],
        padded([0.161]),
        padded([-0.008480655492356989, 0.335480655492357]),
        padded([2.8971530571054935, -6.359448489975075, 4.3622954328695815]),
        padded([
            5.325864828439257,
            -11.748883564062828,
            7.4955393428898365,
            -0.09249506636175525,
        ]),
        padded([
            5.86145544294642,
            -12.92096931784711,
            8.159367898576159,
            -0.071584973281401,
            -0.028269050394068383,
        ]),
        padded([
            0.09646076681806523,
            0.01,
            0.4798896504144996,
            1.379008574103742,
            -3.290069515436081,
            2.324710524099774,
        ]),
    ]);
    const ERROR: [f64; MOST] = padded([
        -0.001780011052225777,
        -0.0008164344596567469,
        0.007880878010261995,
        -0.1447110071732629,
        0.5823571654525552,
        -0.458082105929187,
        1.0 / 66.0,
    ]);
    const DENSE: [[f64; DEGREE]; MOST] = padded_rows([
        padded([
            1.0,
            -2.763706197274826,
            2.9132554618219126,
            -1.0530884977290216,
        ]),
        padded([0.0, 0.1317, -0.2234, 0.1017]),
        padded([
            0.0,
            3.9302962368947516,
            -5.941033872131505,
            2.490627285651253,
        ]),
        padded([
            0.0,
            -12.411077166933676,
            30.33818863028232,
            -16.548102889244902,
        ]),
        padded([0.0, 37.50931341651104, -88.1789048947664, 47.37952196281928]),
        padded([
            0.0,
            -27.896526289197286,
            65.09189467479366,
            -34.87065786149661,
        ]),
        padded([0.0, 1.5, -4.0, 2.5]),
    ]);
}
