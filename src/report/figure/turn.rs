//! Curves over one turn.

use super::Point;

/// A full turn, degrees.
const TURN: f64 = 360.0;

/// Values at azimuths in rad, as points over one turn in degrees.
pub(in crate::report) fn turned(values: impl IntoIterator<Item = Point>) -> Vec<Point> {
    let turned = |(azimuth, value): Point| (azimuth.to_degrees().rem_euclid(TURN), value);
    let mut points: Vec<_> = values.into_iter().map(turned).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The curve through points of one turn, from its start to its end.
pub(in crate::report) fn all_around(mut points: Vec<Point>) -> Vec<Point> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return points;
    };
    // the line from the last point over the end of the turn to the first
    let gap = first.0 + TURN - last.0;
    let part = (TURN - last.0) / gap;
    let seam = last.1 + part * (first.1 - last.1);
    points.insert(0, (0.0, seam));
    points.push((TURN, seam));
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_is_closed_at_its_seam() {
        let points = all_around(turned([
            (-90f64.to_radians(), 4.0),
            (90f64.to_radians(), 2.0),
        ]));
        assert_eq!(points[0], (0.0, 3.0));
        assert_eq!(points[3], (360.0, 3.0));
    }
}
