//! What a plain Hertz bearing bears at a few instants side by side.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, dispatch};

use super::hertz_law::SMALLEST_DISTANCE;
use super::support::{imposed, on_shaft};
use super::support_ensemble::plain;
use super::{BallContact, HertzLaw, LANES, LaneRow, Lanes, RatingLife, Support};
use crate::physics::sines_and_cosines;

/// A plain Hertz bearing at instants side by side, [`LANES`] of them a group and an instant a lane: every number is
/// what [`Support::force`] and [`Support::observe_balls`] say of it, but for round-off.
///
/// Every lane is a motion of its own, so that an instant is the same whatever stands beside it. What all balls bear
/// together is kept of all groups, ball by ball what those of one group bear.
#[derive(Debug, Clone)]
pub(crate) struct SupportObservation {
    pub(super) level: Level,
    pub(super) law: HertzLaw,
    /// K_n^(1/3).
    root: f64,
    /// Cosine and sine of the azimuth of every ball, the cage where it starts.
    azimuths: Vec<[f64; 2]>,
    pub(super) sign: f64,
    pub(super) position: f64,
    pub(super) offset: f64,
    pub(super) free_axial: f64,
    pub(super) free_radial: f64,
    pub(super) arm: f64,
    balls: Vec<BallRows>,
    /// By group.
    seen: Vec<Summary>,
}

/// A ball at every instant of a group.
#[derive(Debug, Clone, Copy, Default)]
struct BallRows {
    /// As [`BallContact::approach`], m.
    approach: LaneRow,
    /// At either race, N.
    load: LaneRow,
    /// Place (A1, A2) of its inner groove centre, m.
    place: [LaneRow; 2],
}

/// All balls together at every instant of a group.
#[derive(Debug, Clone, Copy, Default)]
struct Summary {
    force: [LaneRow; 5],
    largest: LaneRow,
    smallest: LaneRow,
    lowest: LaneRow,
    powers: [LaneRow; 2],
}

impl SupportObservation {
    /// For a bearing; none unless it is a plain Hertz ring in a fixed seat.
    pub fn new(support: &Support) -> Option<Self> {
        let (ring, offset) = plain(support)?;
        let law = *ring.law();
        let balls = ring.azimuths.iter();
        Some(Self {
            level: support.level,
            law,
            root: law.load_deflection_constant.cbrt(),
            azimuths: balls
                .map(|azimuth| [azimuth.cos(), azimuth.sin()])
                .collect(),
            sign: support.sign,
            position: support.definition.position,
            offset,
            free_axial: ring.free_axial,
            free_radial: ring.free_radial,
            arm: ring.arm,
            balls: vec![BallRows::default(); ring.azimuths.len()],
            seen: Vec::new(),
        })
    }

    /// Makes room for so many groups of instants.
    pub fn make_room(&mut self, groups: usize) {
        self.seen.resize(groups, Summary::default());
    }

    /// Looks at the instants of all groups from the first on that there is a displacement of, axis by axis, and at
    /// no ball by itself; the cage is at so many times the angles, rad.
    pub fn observe_all(
        &mut self,
        displacement: [&[[f64; LANES]]; 5],
        angles: &[[f64; LANES]],
        ratio: f64,
    ) {
        dispatch!(self.level, simd => self.observe_all_by(simd, displacement, angles, ratio));
    }

    /// As [`SupportObservation::observe_all`], for the processor's level `S`.
    #[inline(always)]
    fn observe_all_by<S: Simd>(
        &mut self,
        simd: S,
        displacement: [&[[f64; LANES]]; 5],
        angles: &[[f64; LANES]],
        ratio: f64,
    ) {
        let [x, y, z, tilt_x, tilt_y] = displacement;
        let groups = x.iter().zip(y).zip(z).zip(tilt_x).zip(tilt_y).zip(angles);
        for (number, (((((x, y), z), tilt_x), tilt_y), angles)) in groups.enumerate() {
            let place = [x, y, z, tilt_x, tilt_y];
            self.seen[number] = self.observe_by(simd, place, angles, ratio, &mut []);
        }
    }

    /// Looks at the instants of the group of a number with the shaft at these displacements, axis by axis, and at
    /// every ball; the cage is at so many times the angles, rad.
    pub fn observe(
        &mut self,
        number: usize,
        displacement: [&[f64; LANES]; 5],
        angles: &[f64; LANES],
        ratio: f64,
    ) {
        let mut balls = std::mem::take(&mut self.balls);
        self.seen[number] = dispatch!(self.level, simd => {
            self.observe_by(simd, displacement, angles, ratio, &mut balls)
        });
        self.balls = balls;
    }

    /// What all balls bear together in one group, for the processor's level `S`; leaves what each does in `balls`,
    /// as far as there is room.
    #[inline(always)]
    fn observe_by<S: Simd>(
        &self,
        simd: S,
        displacement: [&[f64; LANES]; 5],
        angles: &[f64; LANES],
        ratio: f64,
        balls: &mut [BallRows],
    ) -> Summary {
        let mut place = [Lanes::splat(simd, 0.0); 5];
        for axis in 0..5 {
            place[axis] = simd.load_array_ref_f64x4(displacement[axis]);
        }
        let cage = ratio * simd.load_array_ref_f64x4(angles);
        let [cage_sin, cage_cos] = sines_and_cosines(cage);
        let [x, y, z, tilt_x, tilt_y] = imposed(&place, self.sign, self.position);
        let start = self.free_axial + (z + self.offset);
        let [arm_x, arm_y] = [self.arm * tilt_x, self.arm * tilt_y];
        let none = Lanes::splat(simd, 0.0);
        let free_radial = Lanes::splat(simd, self.free_radial);
        let free_distance = Lanes::splat(simd, self.law.distance);
        let constant = Lanes::splat(simd, self.law.load_deflection_constant);
        let least_distance = Lanes::splat(simd, SMALLEST_DISTANCE);
        let [
            mut radial_x,
            mut radial_y,
            mut thrust,
            mut moment_x,
            mut moment_y,
        ] = [none; 5];
        let [mut cubes, mut powers] = [none; 2];
        let mut highest = Lanes::splat(simd, f64::NEG_INFINITY);
        let mut lowest = Lanes::splat(simd, f64::INFINITY);
        for (ball, [cos, sin]) in self.azimuths.iter().enumerate() {
            let [cos, sin] = [
                *cos * cage_cos - *sin * cage_sin,
                *sin * cage_cos + *cos * cage_sin,
            ];
            let axial = start + (arm_x * sin - arm_y * cos);
            let radial = free_radial + (x * cos + y * sin);
            let distance = (axial * axial + radial * radial).sqrt();
            let reach = distance - free_distance;
            // δ ≤ 0: separated
            let approach = reach.max(none);
            let root = approach.sqrt();
            let load = constant * approach * root;
            let lateral = load / (distance + least_distance);
            let [push, pull] = [lateral * axial, lateral * radial];
            radial_x += pull * cos;
            radial_y += pull * sin;
            thrust += push;
            moment_x += push * sin;
            moment_y += push * cos;
            let cube = load * load * load;
            cubes += cube;
            powers += cube * root;
            highest = reach.max(highest);
            lowest = reach.min(lowest);
            if let Some(ball) = balls.get_mut(ball) {
                *ball = BallRows {
                    approach: LaneRow(*reach),
                    load: LaneRow(*load),
                    place: [LaneRow(*axial), LaneRow(*radial)],
                };
            }
        }
        let moments = [self.arm * moment_x, -(self.arm * moment_y)];
        let force = [radial_x, radial_y, thrust, moments[0], moments[1]];
        let force = on_shaft(&force, self.sign, self.position);
        // as of the balls themselves: the higher the approach, the larger the load
        let [most, least] = [highest.max(none), lowest.max(none)];
        let [largest, smallest] = [constant * most, constant * least];
        Summary {
            force: [
                LaneRow(*force[0]),
                LaneRow(*force[1]),
                LaneRow(*force[2]),
                LaneRow(*force[3]),
                LaneRow(*force[4]),
            ],
            largest: LaneRow(*(largest * most.sqrt())),
            smallest: LaneRow(*(smallest * least.sqrt())),
            lowest: LaneRow(*lowest),
            powers: [LaneRow(*cubes), LaneRow(*(self.root * powers))],
        }
    }

    /// Force and moment that hold the shaft against the bearing, N and N m, instant by instant of a group.
    pub fn force(&self, number: usize) -> &[LaneRow; 5] {
        &self.seen[number].force
    }

    /// Axial force in the bearing's own orientation, positive the way its facing loads it, N, in a lane of a group.
    pub fn axial_force(&self, number: usize, lane: usize) -> f64 {
        self.sign * self.seen[number].force[2].0[lane]
    }

    /// Number of its balls.
    pub fn count(&self) -> usize {
        self.balls.len()
    }

    /// Largest load of a ball at each instant of a group, N.
    pub fn largest_loads(&self, number: usize) -> &[f64; LANES] {
        &self.seen[number].largest.0
    }

    /// Smallest load of a ball at each instant of a group, N.
    pub fn smallest_loads(&self, number: usize) -> &[f64; LANES] {
        &self.seen[number].smallest.0
    }

    /// Lowest approach of any ball at each instant of a group, m.
    pub fn lowest_approach(&self, number: usize) -> &[f64; LANES] {
        &self.seen[number].lowest.0
    }

    /// Approaches of every ball, instant by instant of the group whose balls were looked at last, m.
    pub fn approaches(&self) -> impl Iterator<Item = &[f64; LANES]> {
        self.balls.iter().map(|ball| &ball.approach.0)
    }

    /// Load of every ball in a lane of that group, N.
    pub fn loads(&self, lane: usize) -> impl ExactSizeIterator<Item = f64> + Clone {
        self.balls.iter().map(move |ball| ball.load.0[lane])
    }

    /// What [`RatingLife::consumption`] says of the loads at the instants of the first groups.
    pub fn consumptions(&self, rating: &RatingLife, found: &mut [[f64; LANES]]) {
        dispatch!(self.level, _simd => self.consumptions_by(rating, found));
    }

    /// As [`SupportObservation::consumptions`], in registers as wide as what it is inlined into has them.
    #[inline(always)]
    fn consumptions_by(&self, rating: &RatingLife, found: &mut [[f64; LANES]]) {
        for (found, summary) in found.iter_mut().zip(&self.seen) {
            let [inner, outer] = &summary.powers;
            *found = rating.consumptions_of([&inner.0, &outer.0]);
        }
    }

    /// Leaves the contacts of every ball in a lane of that group in `balls`, ball 0 first; without `angles` the contact angles are zero.
    pub fn fill(&self, lane: usize, angles: bool, balls: &mut [BallContact]) {
        for (ball, rows) in balls.iter_mut().zip(&self.balls) {
            let load = rows.load.0[lane];
            let angle = if angles {
                let [axial, radial] = rows.place.map(|row| row.0[lane]);
                axial.atan2(radial)
            } else {
                0.0
            };
            *ball = BallContact {
                load_inner: load,
                load_outer: load,
                angle_inner: angle,
                angle_outer: angle,
                approach: rows.approach.0[lane],
            };
        }
    }
}

#[cfg(test)]
#[path = "support_observation_tests.rs"]
pub(super) mod tests;
