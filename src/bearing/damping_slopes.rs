//! How the damping of dry Hertz contacts changes with place, rate and time, exactly.

use nalgebra::{ArrayStorage, SMatrix, SVector};

use super::any_ring::AnyRing;
use super::contact_damping::DampedRaces;
use super::hertz_law::SMALLEST_DISTANCE;
use super::ring::{CageAngle, Matrix5, PlacedBall, Vector5, quarter_turn};
use super::seat::Seat;
use super::support::Support;
use super::{HertzLaw, Ring};

type Matrix2 = SMatrix<f64, 2, 2>;
type Column2 = SMatrix<f64, 2, 1>;

/// The force against the damping of a bearing's contacts, and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DampingSlopes {
    /// ∂F/∂q at a fixed velocity.
    pub by_place: Matrix5,
    /// ∂F/∂q̇.
    pub by_rate: Matrix5,
    /// ∂F/∂t at a fixed place and velocity: the cage turns.
    pub by_time: Vector5,
}

impl DampingSlopes {
    /// Of no damping.
    pub const NONE: Self = Self {
        by_place: Matrix5::from_array_storage(ArrayStorage([[0.0; 5]; 5])),
        by_rate: Matrix5::from_array_storage(ArrayStorage([[0.0; 5]; 5])),
        by_time: [0.0; 5],
    };

    /// Those of both forces together.
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            by_place: self.by_place + other.by_place,
            by_rate: self.by_rate + other.by_rate,
            by_time: std::array::from_fn(|axis| self.by_time[axis] + other.by_time[axis]),
        }
    }
}

impl Support {
    /// Slopes of [`Support::damping_force`], the cage turning at a speed in rad/s that grows by an
    /// acceleration in rad/s²; none where only differences find them: under films and the balance of the
    /// balls, and where the outer ring floats.
    pub(crate) fn damping_slopes(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        cage: CageAngle,
        cage_motion: [f64; 2],
    ) -> Option<DampingSlopes> {
        let Some(races) = &self.damped else {
            return Some(DampingSlopes::NONE);
        };
        let local = match (&self.frozen, &self.ring, self.seat) {
            (Some(linear), ..) => DampingSlopes {
                by_rate: linear.damping,
                ..DampingSlopes::NONE
            },
            (None, AnyRing::Hertz(ring), Seat::Fixed { offset }) => {
                let (place, rate) = (self.imposed(displacement), self.imposed(velocity));
                seen_standing(ring, races, offset, [place, rate], cage, cage_motion)
            }
            _ => return None,
        };
        let transform = self.transform();
        let on_shaft = |slopes: Matrix5| transform.transpose() * slopes * transform;
        Some(DampingSlopes {
            by_place: on_shaft(local.by_place),
            by_rate: on_shaft(local.by_rate),
            by_time: self.on_shaft(&local.by_time),
        })
    }
}

/// Slopes seen by one who stands, from those seen by one who turns with the cage.
///
/// ```text
/// w = q̇ − ω_c S q     ∂F/∂q|q̇ = ∂F/∂q|w − ω_c ∂F/∂w S
/// ∂F/∂t = ω_c (S F − ∂F/∂q|w S q − ∂F/∂w S w) − ω̇_c ∂F/∂w S q
/// ```
///
/// with S the generator of rotations about Z: turning the cage is turning place and rate back and the
/// force forth.
fn seen_standing(
    ring: &Ring<HertzLaw>,
    races: &DampedRaces,
    offset: f64,
    [imposed, rate]: [Vector5; 2],
    cage: CageAngle,
    [cage_speed, cage_acceleration]: [f64; 2],
) -> DampingSlopes {
    let swept = quarter_turn(&imposed);
    let rate: Vector5 = std::array::from_fn(|axis| rate[axis] - cage_speed * swept[axis]);
    let mut place = imposed;
    place[2] += offset;
    let (force, by_place, by_rate) = ring.series_damping_slopes(&place, &rate, cage, races);
    let vector = |vector: &Vector5| SVector::from(*vector);
    let turned_back = by_place * vector(&swept) + by_rate * vector(&quarter_turn(&rate));
    let faster = by_rate * vector(&swept);
    let turned = quarter_turn(&force);
    DampingSlopes {
        by_place: by_place - by_rate * generator() * cage_speed,
        by_rate,
        by_time: std::array::from_fn(|axis| {
            cage_speed * (turned[axis] - turned_back[axis]) - cage_acceleration * faster[axis]
        }),
    }
}

/// S, the matrix of [`quarter_turn`].
fn generator() -> Matrix5 {
    let mut generator = Matrix5::zeros();
    for axis in 0..5 {
        let mut unit = [0.0; 5];
        unit[axis] = 1.0;
        generator.set_column(axis, &quarter_turn(&unit).into());
    }
    generator
}

impl Ring<HertzLaw> {
    /// Force as by [`Ring::series_damping`], and its derivatives by place and by rate.
    fn series_damping_slopes(
        &self,
        displacement: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        races: &DampedRaces,
    ) -> (Vector5, Matrix5, Matrix5) {
        let (mut force, mut by_place, mut by_rate) =
            (Vector5::default(), Matrix5::zeros(), Matrix5::zeros());
        for ball in self.placed(*displacement, cage) {
            let (axial, radial) = self.place_slopes(&ball);
            let reach = SMatrix::<f64, 2, 5>::from_fn(|row, axis| [axial, radial][row][axis]);
            let moved = reach * SVector::from(*rate);
            let pushed = push_slopes(self.law(), races, &ball, &moved);
            let push = reach.transpose() * pushed.push;
            for axis in 0..5 {
                force[axis] += push[axis];
            }
            by_place += reach.transpose() * pushed.by_place * reach;
            by_rate += reach.transpose() * pushed.by_rate * reach;
        }
        (force, by_place, by_rate)
    }
}

/// Axial and radial force on a ball against its damping, and its derivatives.
struct PushSlopes {
    push: Column2,
    by_place: Matrix2,
    by_rate: Matrix2,
}

/// The force on a ball whose inner groove centre is at A and moves at u.
///
/// ```text
/// p = Q D(v) n   n = A/d   v = n·u   D = Σ_i s_i max(c_i s_i v, −1)
/// ∂p/∂u = Q D′ n nᵀ
/// ∂p/∂A = Q′ D n nᵀ + Q D (1 − n nᵀ)/d + Q D′ n (u − v n)ᵀ/d
/// ```
fn push_slopes(
    law: &HertzLaw,
    races: &DampedRaces,
    ball: &PlacedBall,
    rate: &Column2,
) -> PushSlopes {
    let place = Column2::new(ball.axial, ball.radial);
    let distance = place.norm() + SMALLEST_DISTANCE;
    let approach = (distance - law.distance).max(0.0);
    let stiffness = 1.5 * law.load_deflection_constant * approach.sqrt();
    let load = law.load_deflection_constant * approach * approach.sqrt();
    let along = place / distance;
    let approach_rate = along.dot(rate);
    let (mut damped, mut slope) = (0.0, 0.0);
    for (share, coefficient) in races.shares().into_iter().zip(races.coefficients) {
        let loss = coefficient * share * approach_rate;
        damped += share * loss.max(-1.0);
        slope += if loss > -1.0 {
            share * share * coefficient
        } else {
            0.0
        };
    }
    let normal = along * along.transpose();
    let across = (rate - along * approach_rate) / distance;
    PushSlopes {
        push: along * (load * damped),
        by_place: normal * (stiffness * damped)
            + (Matrix2::identity() - normal) * (load * damped / distance)
            + along * across.transpose() * (load * slope),
        by_rate: normal * (load * slope),
    }
}

#[cfg(test)]
mod tests {
    use super::super::contact_damping::ContactDamping;
    use super::super::{FreePosition, Geometry, HertzSpring};
    use super::*;

    /// A ring of unlike races, damped.
    fn damped() -> (Ring<HertzLaw>, DampedRaces) {
        let free = FreePosition::ContactAngle(0.26);
        let geometry = Geometry::new(13, 7.938e-3, 38.5e-3, free, 0.52, 0.53).unwrap();
        let law = HertzLaw {
            load_deflection_constant: 4.4e9,
            distance: geometry.groove_centre_distance(),
        };
        let loss = ContactDamping {
            inner: 3.0,
            outer: 40.0,
        };
        let springs = [1.1e10, 1.4e10].map(|stiffness| HertzSpring { stiffness });
        let races = loss.races(springs).unwrap().unwrap();
        (Ring::new(&geometry, 0.3, law), races)
    }

    /// Whether all balls stay pressed, some are apart, or some leave faster than their race can follow.
    #[test]
    fn slopes_are_those_of_the_force() {
        let (ring, races) = damped();
        let cage = CageAngle::new(0.7);
        for (place, rate) in [
            (
                [2e-6, -3e-6, 30e-6, 1e-5, 2e-5],
                [1e-3, 2e-3, -1e-3, 0.02, -0.01],
            ),
            ([40e-6, 10e-6, 0.0, 0.0, 1e-4], [1e-3, 0.0, 2e-3, 0.1, 0.0]),
            (
                [2e-6, -3e-6, 30e-6, 1e-5, 2e-5],
                [0.2, -0.1, 0.3, 1.0, -2.0],
            ),
        ] {
            let force =
                |place: &Vector5, rate: &Vector5| ring.series_damping(place, rate, cage, &races);
            let (found, by_place, by_rate) =
                ring.series_damping_slopes(&place, &rate, cage, &races);
            let near = |found: f64, expected: f64, size: f64| {
                assert!(
                    (found - expected).abs() < 1e-6 * size,
                    "{found:e} {expected:e} of {size:e}"
                );
            };
            let expected = force(&place, &rate);
            let largest = |vector: &Vector5| vector.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            for axis in 0..5 {
                near(found[axis], expected[axis], 1e-6 * largest(&expected));
            }
            for column in 0..5 {
                let lever = if column < 3 { 1.0 } else { 50.0 };
                let moved = |vector: &Vector5, step: f64| {
                    let mut moved = *vector;
                    moved[column] += step;
                    moved
                };
                let slope = |step: f64, at: &dyn Fn(f64) -> Vector5| -> Vector5 {
                    let (up, down) = (at(step), at(-step));
                    std::array::from_fn(|row| (up[row] - down[row]) / (2.0 * step))
                };
                let place_slope = slope(1e-9 * lever, &|step| force(&moved(&place, step), &rate));
                let rate_slope = slope(1e-7 * lever, &|step| force(&place, &moved(&rate, step)));
                for row in 0..5 {
                    near(
                        by_place[(row, column)],
                        place_slope[row],
                        largest(&place_slope),
                    );
                    near(
                        by_rate[(row, column)],
                        rate_slope[row],
                        largest(&rate_slope),
                    );
                }
            }
        }
    }
}
