//! How fast the shaft turns, and how far it has turned.

use super::RotorError;
use super::assembly::not_negative;

/// A speed that the shaft has at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedPoint {
    /// Time, s.
    pub time: f64,
    /// Angular speed, rad/s, zero or positive.
    pub speed: f64,
}

/// How the shaft turns at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation {
    /// Angle ψ since t = 0, rad.
    pub angle: f64,
    /// Angular speed ω = dψ/dt, rad/s.
    pub speed: f64,
    /// Angular acceleration ω̇ = dω/dt, rad/s².
    pub acceleration: f64,
}

/// A piecewise linear speed with its exact integral.
///
/// ```text
/// ω(t) = ω_k + ω̇_k (t − t_k)
/// ψ(t) = ψ_k + ω_k (t − t_k) + ½ ω̇_k (t − t_k)²,   ψ(0) = 0,   t_k ≤ t < t_(k+1)
/// ```
///
/// The speed of the last point is held for ever. At a point itself ω̇ is that of the piece after it.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedProfile {
    /// By start, the first at 0; a single one where the speed is constant.
    pieces: Vec<Piece>,
}

/// A stretch of constant acceleration, from its start to that of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    start: f64,
    rotation: Rotation,
}

impl Piece {
    #[inline]
    fn at(&self, time: f64) -> Rotation {
        let (since, from) = (time - self.start, &self.rotation);
        let gained = from.acceleration * since;
        Rotation {
            angle: from.angle + (from.speed + 0.5 * gained) * since,
            speed: from.speed + gained,
            acceleration: from.acceleration,
        }
    }

    /// The piece from this point to the next; the one after the last point holds its speed.
    fn towards(from: SpeedPoint, angle: f64, next: Option<&SpeedPoint>) -> Self {
        let acceleration = next.map_or(0.0, |next| {
            (next.speed - from.speed) / (next.time - from.time)
        });
        Self {
            start: from.time,
            rotation: Rotation {
                angle,
                speed: from.speed,
                acceleration,
            },
        }
    }
}

impl SpeedProfile {
    /// The speed `start` at t = 0, then linearly from point to point.
    ///
    /// # Errors
    /// [`RotorError::Range`] where a speed is negative or not finite;
    /// [`RotorError::SpeedTimes`] where the times do not rise from zero.
    pub fn new(start: f64, points: &[SpeedPoint]) -> Result<Self, RotorError> {
        let first = SpeedPoint {
            time: 0.0,
            speed: start,
        };
        let check = |speed| not_negative("the speed in rad/s", speed);
        check(start)?;
        let mut before = &first;
        for (index, point) in points.iter().enumerate() {
            check(point.speed)?;
            if !(point.time > before.time && point.time.is_finite()) {
                return Err(RotorError::SpeedTimes {
                    number: index + 1,
                    time: point.time,
                    before: before.time,
                });
            }
            before = point;
        }
        let varies = points.iter().any(|point| point.speed != start);
        let points = if varies { points } else { &[] };
        let mut pieces = vec![Piece::towards(first, 0.0, points.first())];
        for (index, point) in points.iter().enumerate() {
            let angle = pieces[index].at(point.time).angle;
            pieces.push(Piece::towards(*point, angle, points.get(index + 1)));
        }
        Ok(Self { pieces })
    }

    /// Angle, speed and acceleration at a time ≥ 0 in s.
    #[inline]
    pub fn at(&self, time: f64) -> Rotation {
        match &self.pieces[..] {
            [only] => only.at(time),
            _ => {
                // field by field, so that the constant speed's stay in registers
                let Rotation {
                    angle,
                    speed,
                    acceleration,
                } = self.passing(time);
                Rotation {
                    angle,
                    speed,
                    acceleration,
                }
            }
        }
    }

    /// Apart from the constant speed, which stays small.
    #[inline(never)]
    fn passing(&self, time: f64) -> Rotation {
        self.pieces[self.piece_at(time)].at(time)
    }

    /// The first time at which the shaft has turned by an angle in rad, s; none where it never does.
    pub fn time_of(&self, angle: f64) -> Option<f64> {
        let next = self.pieces[1..].partition_point(|piece| piece.rotation.angle <= angle);
        let Piece { start, rotation } = self.pieces[next];
        let (speed, ahead) = (rotation.speed, angle - rotation.angle);
        // ½ ω̇ s² + ω s = Δψ, in the form that keeps its digits
        let root = (speed * speed + 2.0 * rotation.acceleration * ahead).sqrt();
        let since = 2.0 * ahead / (speed + root);
        since.is_finite().then_some(start + since)
    }

    /// Number of the piece that holds a time.
    fn piece_at(&self, time: f64) -> usize {
        self.pieces[1..].partition_point(|piece| piece.start <= time)
    }

    /// Whether the speed never changes.
    pub fn is_constant(&self) -> bool {
        self.pieces.len() == 1
    }

    /// The speed that is kept from a time on; `None` where it changes after it.
    pub fn steady_from(&self, time: f64) -> Option<f64> {
        let pieces = &self.pieces[self.piece_at(time)..];
        let steady = |piece: &Piece| piece.rotation.acceleration == 0.0;
        pieces.iter().all(steady).then(|| pieces[0].rotation.speed)
    }

    /// Highest speed, rad/s.
    pub fn highest(&self) -> f64 {
        self.points().map(|point| point.speed).fold(0.0, f64::max)
    }

    /// The start and every point after it.
    pub fn points(&self) -> impl Iterator<Item = SpeedPoint> + '_ {
        self.pieces.iter().map(|piece| SpeedPoint {
            time: piece.start,
            speed: piece.rotation.speed,
        })
    }

    /// The first point after a time, where the acceleration jumps; infinite where there is none.
    pub fn next_break(&self, after: f64) -> f64 {
        let next = self.pieces.iter().find(|piece| piece.start > after);
        next.map_or(f64::INFINITY, |piece| piece.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_up_turns_the_shaft_by_its_mean_speed() -> Result<(), crate::rotor::RotorError> {
        // from rest to 100 rad/s in 2 s, then constant
        let profile = SpeedProfile::new(
            0.0,
            &[SpeedPoint {
                time: 2.0,
                speed: 100.0,
            }],
        )?;
        assert_eq!(profile.at(1.0).speed, 50.0);
        assert_eq!(profile.at(2.0).angle, 100.0);
        assert_eq!(profile.at(3.0).angle, 200.0);
        assert_eq!(profile.steady_from(2.0), Some(100.0));
        Ok(())
    }
}
