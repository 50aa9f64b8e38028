//! Ball-pass frequencies as multiples of the shaft speed: the Case Western Reserve University
//! bearing data (6205-2RS: 9 balls, 0.3126 in, pitch 1.537 in, 0°), and the 7205C default.

use std::f64::consts::TAU;

use crate::physics::ball_pass_frequencies;

use crate::tests::support::{
    assert_near, assert_printed, bearing, half_last_digit, mounted, supports,
};

#[test]
fn case_western_6205() {
    let (ball, pitch) = (0.3126, 1.537);
    let pass = ball_pass_frequencies(TAU, 9, ball, pitch, ball / pitch);
    // The printed multiples belong to more digits of ball and pitch than are printed: half a unit
    // of the last digit of both is allowed for.
    let ratio = ball / pitch;
    let rounding = ratio * (half_last_digit("0.3126") / ball + half_last_digit("1.537") / pitch);
    for (name, value, printed, slope) in [
        ("FTF", pass.cage, "0.39828", 0.5),
        ("BPFO", pass.outer, "3.5848", 4.5),
        ("BPFI", pass.inner, "5.4152", 4.5),
        ("2×BSF", 2.0 * pass.spin, "4.7135", ratio.powi(-2) + 1.0),
    ] {
        let expected = printed.parse().expect("a number");
        let tolerance = half_last_digit(printed) + slope * rounding;
        assert_near(name, value, expected, tolerance);
    }
}

#[test]
fn default_7205c() {
    let pass = supports(&[mounted(bearing("7205C"))])[0].ball_pass(TAU);
    assert_printed("BPFO", pass.outer, "4.80506");
    assert_printed("BPFI", pass.inner, "7.19494");
    assert_printed("FTF", pass.cage, "0.40042");
    assert_printed("BSF", pass.spin, "2.32886");
}
