//! Dynamic equivalent load of ISO 281.

use super::at_least;

/// e, Y over the relative axial load F_a/(Z D²) of one nominal angle, N/mm².
type Rows = [(f64, [f64; 2]); 9];

#[rustfmt::skip]
const DEEP_GROOVE: Rows = [
    (0.172, [0.19, 2.30]), (0.345, [0.22, 1.99]), (0.689, [0.26, 1.71]), (1.03, [0.28, 1.55]), (1.38, [0.30, 1.45]),
    (2.07, [0.34, 1.31]), (3.45, [0.38, 1.15]), (5.17, [0.42, 1.04]), (6.89, [0.44, 1.00]),
];

#[rustfmt::skip]
const TEN_DEGREES: Rows = [
    (0.172, [0.29, 1.88]), (0.345, [0.32, 1.71]), (0.689, [0.36, 1.52]), (1.03, [0.38, 1.41]), (1.38, [0.40, 1.34]),
    (2.07, [0.44, 1.23]), (3.45, [0.49, 1.10]), (5.17, [0.54, 1.01]), (6.89, [0.54, 1.00]),
];

#[rustfmt::skip]
const FIFTEEN_DEGREES: Rows = [
    (0.172, [0.38, 1.47]), (0.345, [0.40, 1.40]), (0.689, [0.43, 1.30]), (1.03, [0.46, 1.23]), (1.38, [0.47, 1.19]),
    (2.07, [0.50, 1.12]), (3.45, [0.55, 1.02]), (5.17, [0.56, 1.00]), (6.89, [0.56, 1.00]),
];

/// X where e and Y depend on the load, by the angle in degrees; at 5° the standard has the values of 0°.
const FLAT: [(f64, f64, &Rows); 4] = [
    (0.0, 0.56, &DEEP_GROOVE),
    (5.0, 0.56, &DEEP_GROOVE),
    (10.0, 0.46, &TEN_DEGREES),
    (15.0, 0.44, &FIFTEEN_DEGREES),
];

/// Angle in degrees, e, X, Y where they do not depend on the load.
const STEEP: [(f64, [f64; 3]); 6] = [
    (20.0, [0.57, 0.43, 1.00]),
    (25.0, [0.68, 0.41, 0.87]),
    (30.0, [0.80, 0.39, 0.76]),
    (35.0, [0.95, 0.37, 0.66]),
    (40.0, [1.14, 0.35, 0.57]),
    (45.0, [1.34, 0.33, 0.50]),
];

/// Dynamic equivalent load P of a single-row ball bearing, N.
///
/// `P = F_r` where `F_a/F_r ≤ e`, else `X F_r + Y F_a`, never less than F_r; e, X and Y of the standard by the nominal
/// contact angle in rad, up to 15° also by the `relative_axial` load F_a/(Z D²) = f0 F_a/C_0 · cos α in N/mm²; straight lines
/// between its values and angles.
///
/// Source: ISO 281:2007, table 3.
///
/// ```
/// use jeffcott::physics::equivalent_load;
/// // deep groove, F_a/(Z D²) = 1.38 N/mm²: e = 0.30, X = 0.56, Y = 1.45
/// assert_eq!(equivalent_load(1000.0, 250.0, 0.0, 1.38), 1000.0);
/// assert!((equivalent_load(1000.0, 800.0, 0.0, 1.38) - 1720.0).abs() < 1e-9);
/// // 40°: e = 1.14, X = 0.35, Y = 0.57
/// let angle = 40f64.to_radians();
/// assert!((equivalent_load(1000.0, 2000.0, angle, 1.0) - 1490.0).abs() < 1e-9);
/// ```
pub fn equivalent_load(radial: f64, axial: f64, contact_angle: f64, relative_axial: f64) -> f64 {
    let (radial, axial) = (radial.abs(), axial.abs());
    let [e, x, y] = factors(contact_angle.to_degrees(), relative_axial);
    if axial <= e * radial {
        return radial;
    }
    at_least(x * radial + y * axial, radial)
}

/// Dynamic equivalent load P of a radial roller bearing with one row or two, N.
///
/// ```text
/// e = 1.5 tan α        F_a/F_r ≤ e                   above
/// one row              P = F_r                       P = 0.4 F_r + 0.4 cot α F_a
/// two rows             P = F_r + 0.45 cot α F_a      P = 0.67 F_r + 0.67 cot α F_a
/// ```
///
/// α is the nominal contact angle in rad; at α = 0 rollers bear no axial load, and P = F_r.
///
/// Source: ISO 281:2007, table 8.
///
/// ```
/// use jeffcott::physics::roller_equivalent_load;
/// // makers print e = 0.24, Y1 = 2.8, Y2 = 4.2 of a 22212: α = atan(0.24/1.5)
/// let angle = (0.24f64 / 1.5).atan();
/// let load = |axial| roller_equivalent_load(1000.0, axial, angle, 2);
/// assert!((load(100.0) - 1281.0).abs() < 1.0 && (load(1000.0) - 4857.0).abs() < 1.0);
/// ```
pub fn roller_equivalent_load(radial: f64, axial: f64, contact_angle: f64, rows: usize) -> f64 {
    let (radial, axial) = (radial.abs(), axial.abs());
    if contact_angle == 0.0 && !axial.is_nan() {
        return radial;
    }
    let slope = contact_angle.tan();
    let within = axial <= 1.5 * slope * radial;
    let [x, y] = match (within, rows) {
        (true, 1) => [1.0, 0.0],
        (true, _) => [1.0, 0.45],
        (false, 1) => [0.4, 0.4],
        (false, _) => [0.67, 0.67],
    };
    x * radial + y / slope * axial
}

fn factors(degrees: f64, relative: f64) -> [f64; 3] {
    let flat = FLAT.iter().map(|&(angle, x, rows)| {
        let [e, y] = between(rows, relative);
        (angle, [e, x, y])
    });
    let rows: Vec<_> = flat.chain(STEEP).collect();
    between(&rows, degrees)
}

/// Straight lines between rows that rise; the first and the last row beyond them, NaN at NaN.
pub(super) fn between<const M: usize>(rows: &[(f64, [f64; M])], at: f64) -> [f64; M] {
    match rows.partition_point(|(place, _)| *place <= at) {
        _ if at.is_nan() => [f64::NAN; M],
        0 => rows[0].1,
        above if above == rows.len() => rows[above - 1].1,
        above => {
            let ((from, low), (to, high)) = (rows[above - 1], rows[above]);
            let part = (at - from) / (to - from);
            std::array::from_fn(|index| low[index] + part * (high[index] - low[index]))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ISO 281:2007, table 3, first column of the block of 15°: f0 F_a/C_0 = 0.178 … 7.14, as makers of spindle bearings print
    /// it, too.
    #[test]
    fn the_rows_of_15_degrees_stand_at_the_printed_relative_loads() {
        let printed = [0.178, 0.357, 0.714, 1.07, 1.43, 2.14, 3.57, 5.35, 7.14];
        let cosine = 15f64.to_radians().cos();
        for (first, (second, [e, y])) in printed.into_iter().zip(FIFTEEN_DEGREES) {
            assert!(
                (first * cosine / second - 1.0).abs() < 5e-3,
                "{first} {second}"
            );
            let found = factors(15.0, second);
            assert_eq!(found, [e, 0.44, y]);
        }
    }

    #[test]
    fn factors_between_angles_are_between_theirs() {
        assert_eq!(factors(3.0, 1.38), factors(0.0, 1.38));
        // halfway from 15° to 20°
        let [e, x, y] = factors(17.5, 1.38);
        for (found, expected) in [(e, 0.52), (x, 0.435), (y, 1.095)] {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }
}
