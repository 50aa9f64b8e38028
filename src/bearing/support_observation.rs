//! What a plain Hertz bearing bears at a few instants side by side.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, dispatch};

use super::hertz_law::SMALLEST_DISTANCE;
use super::support::{imposed, on_shaft};
use super::support_ensemble::plain;
use super::{BallContact, HertzLaw, LANES, LaneRow, Lanes, RatingLife, Support};
use crate::physics::sines_and_cosines;

/// A plain Hertz bearing at [`LANES`] instants side by side, an instant a lane: every number is what
/// [`Support::force`] and [`Support::observe_balls`] say of it, but for round-off.
///
/// Every lane is a motion of its own, so that an instant is the same whatever stands beside it.
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
    force: [LaneRow; 5],
    summary: Summary,
}

/// A ball at every instant.
#[derive(Debug, Clone, Copy, Default)]
struct BallRows {
    /// As [`BallContact::approach`], m.
    approach: LaneRow,
    /// At either race, N.
    load: LaneRow,
    /// Place (A1, A2) of its inner groove centre, m.
    place: [LaneRow; 2],
}

/// All balls together at every instant.
#[derive(Debug, Clone, Copy, Default)]
struct Summary {
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
            force: [LaneRow::default(); 5],
            summary: Summary::default(),
        })
    }

    /// Looks at the bearing with the shaft at these displacements, axis by axis, its cage at these angles in rad.
    pub fn observe(&mut self, displacement: [&[f64; LANES]; 5], cages: &[f64; LANES]) {
        dispatch!(self.level, simd => self.observe_by(simd, displacement, cages));
    }

    /// As [`SupportObservation::observe`], for the processor's level `S`.
    #[inline(always)]
    fn observe_by<S: Simd>(
        &mut self,
        simd: S,
        displacement: [&[f64; LANES]; 5],
        cages: &[f64; LANES],
    ) {
        let mut place = [Lanes::splat(simd, 0.0); 5];
        for axis in 0..5 {
            place[axis] = simd.load_array_ref_f64x4(displacement[axis]);
        }
        let [cage_sin, cage_cos] = sines_and_cosines(simd.load_array_ref_f64x4(cages));
        let [x, y, z, tilt_x, tilt_y] = imposed(&place, self.sign, self.position);
        let start = self.free_axial + (z + self.offset);
        let [arm_x, arm_y] = [self.arm * tilt_x, self.arm * tilt_y];
        // in registers from here on: the loop writes to what `self` might hold
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
        let [mut highest, mut lowest] =
            [f64::NEG_INFINITY, f64::INFINITY].map(|value| Lanes::splat(simd, value));
        for ([cos, sin], ball) in self.azimuths.iter().zip(&mut self.balls) {
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
            *ball = BallRows {
                approach: LaneRow(*reach),
                load: LaneRow(*load),
                place: [LaneRow(*axial), LaneRow(*radial)],
            };
        }
        let moments = [self.arm * moment_x, -(self.arm * moment_y)];
        let force = [radial_x, radial_y, thrust, moments[0], moments[1]];
        let force = on_shaft(&force, self.sign, self.position);
        for (row, lanes) in self.force.iter_mut().zip(force) {
            *row = LaneRow(*lanes);
        }
        // as of the balls themselves: the higher the approach, the larger the load
        let [largest, smallest] = [highest, lowest].map(|reach| {
            let approach = reach.max(none);
            constant * approach * approach.sqrt()
        });
        self.summary = Summary {
            largest: LaneRow(*largest),
            smallest: LaneRow(*smallest),
            lowest: LaneRow(*lowest),
            powers: [LaneRow(*cubes), LaneRow(*(self.root * powers))],
        };
    }

    /// Force and moment that hold the shaft against the bearing, N and N m, instant by instant.
    pub fn force(&self) -> &[LaneRow; 5] {
        &self.force
    }

    /// Axial force in the bearing's own orientation, positive the way its facing loads it, N.
    pub fn axial_force(&self, lane: usize) -> f64 {
        self.sign * self.force[2].0[lane]
    }

    /// Number of its balls.
    pub fn count(&self) -> usize {
        self.balls.len()
    }

    /// Largest load of a ball at each instant, N.
    pub fn largest_loads(&self) -> &[f64; LANES] {
        &self.summary.largest.0
    }

    /// Smallest load of a ball at each instant, N.
    pub fn smallest_loads(&self) -> &[f64; LANES] {
        &self.summary.smallest.0
    }

    /// Lowest approach of any ball at each instant, m.
    pub fn lowest_approach(&self) -> [f64; LANES] {
        self.summary.lowest.0
    }

    /// Approaches of every ball, instant by instant, m.
    pub fn approaches(&self) -> impl Iterator<Item = &[f64; LANES]> {
        self.balls.iter().map(|ball| &ball.approach.0)
    }

    /// Load of every ball, N.
    pub fn loads(&self, lane: usize) -> impl ExactSizeIterator<Item = f64> + Clone {
        self.balls.iter().map(move |ball| ball.load.0[lane])
    }

    /// What [`RatingLife::consumption`] says of the loads at every instant.
    pub fn consumptions(&self, rating: &RatingLife) -> [f64; LANES] {
        let powers = &self.summary.powers;
        dispatch!(self.level, _simd => rating.consumptions_of([&powers[0].0, &powers[1].0]))
    }

    /// Leaves the contacts of every ball in `balls`, ball 0 first; without `angles` the contact angles are zero.
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
pub(super) mod tests {
    use super::*;
    use crate::bearing::{
        CageAngle, ContactDamping, ContactLaw, Facing, MountedBearing, Preload, Vector5, catalogue,
    };

    /// A preset bearing off the centre of mass that faces −z.
    pub(in crate::bearing) fn support(name: &str) -> Support {
        let entry = catalogue::find(name).expect("in the catalogue");
        let mounted = MountedBearing {
            bearing: entry.bearing().expect("a bearing"),
            law: ContactLaw::Hertz,
            oil: None,
            position: 0.03,
            facing: Facing::MinusZ,
            preload: Preload::AxialOffset(8e-6),
            contact_damping: ContactDamping::default(),
            first_ball: 0.1,
        };
        Support::new(&mounted, 0.0).expect("a support")
    }

    fn places(step: i32) -> ([Vector5; LANES], [f64; LANES]) {
        let part = |lane: usize| f64::from(step) * 0.37 + 1.3 * lane as f64;
        let place = |lane| [3e-5, 2e-5, 4e-5, 1e-3, 2e-3].map(|size| size * part(lane).sin());
        (std::array::from_fn(place), std::array::from_fn(part))
    }

    /// Axis by axis.
    fn look(seen: &mut SupportObservation, places: &[Vector5; LANES], cages: [f64; LANES]) {
        let rows: [[f64; LANES]; 5] =
            std::array::from_fn(|axis| places.each_ref().map(|place| place[axis]));
        seen.observe(rows.each_ref(), &cages);
    }

    fn near(found: f64, expected: f64, scale: f64) {
        assert!(
            (found - expected).abs() < 1e-11 * scale,
            "{found:e} {expected:e}"
        );
    }

    #[test]
    fn every_instant_is_what_it_is_by_itself() {
        for name in ["7205C", "6306"] {
            let support = support(name);
            let mut seen = SupportObservation::new(&support).expect("a plain bearing");
            let mut alone = vec![BallContact::default(); support.known_balls()];
            let mut beside = alone.clone();
            for step in 0..200 {
                let (places, cages) = places(step);
                look(&mut seen, &places, cages);
                for lane in 0..LANES {
                    let cage = CageAngle::new(cages[lane]);
                    let force = support.force(&places[lane], cage, 0.0);
                    support.observe_balls(&places[lane], cage, 0.0, true, &mut alone);
                    seen.fill(lane, true, &mut beside);
                    let largest = alone.iter().map(|ball| ball.load_inner);
                    let largest = largest.fold(1.0, f64::max);
                    for (row, expected) in seen.force().iter().zip(force) {
                        near(row.0[lane], expected, 10.0 * largest);
                    }
                    for (ball, expected) in beside.iter().zip(&alone) {
                        near(ball.load_inner, expected.load_inner, largest);
                        near(ball.load_outer, expected.load_outer, largest);
                        near(ball.angle_outer, expected.angle_outer, 1.0);
                        near(ball.approach, expected.approach, 1e-4);
                    }
                    near(seen.axial_force(lane), -force[2], 10.0 * largest);
                }
            }
        }
    }

    #[test]
    fn extremes_and_powers_are_those_of_its_balls() {
        let support = support("6306");
        let mut seen = SupportObservation::new(&support).expect("a plain bearing");
        let rating = RatingLife::new(&support.definition().bearing.geometry, 23_400.0);
        for step in 0..200 {
            let (places, cages) = places(step);
            look(&mut seen, &places, cages);
            for lane in 0..LANES {
                let loads = || seen.loads(lane);
                let extremes = [loads().fold(0.0, f64::max), loads().fold(1e9, f64::min)];
                let found = [seen.largest_loads(), seen.smallest_loads()];
                assert_eq!(found.map(|loads| loads[lane]), extremes);
                let approaches = seen.approaches().map(|approaches| approaches[lane]);
                let lowest = approaches.fold(f64::INFINITY, f64::min);
                assert_eq!(seen.lowest_approach()[lane], lowest);
                for (found, power) in seen.summary.powers.iter().zip([3.0, 10.0 / 3.0]) {
                    let expected: f64 = loads().map(|load| load.powf(power)).sum();
                    near(found.0[lane], expected, expected);
                }
                let life = rating.consumption(loads().map(|load| [load; 2]));
                near(seen.consumptions(&rating)[lane], life, life);
            }
        }
    }

    #[test]
    fn neighbours_and_widths_of_registers_change_no_byte() {
        let wide = SupportObservation::new(&support("7205C")).expect("a plain bearing");
        let narrow = SupportObservation {
            level: Level::baseline(),
            ..wide.clone()
        };
        let bytes = |mut seen: SupportObservation, places, cages, lane: usize| {
            look(&mut seen, &places, cages);
            let loads: Vec<u64> = seen.loads(lane).map(f64::to_bits).collect();
            (loads, seen.force().map(|row| row.0[lane].to_bits()))
        };
        for step in 0..50 {
            let (places, cages) = places(step);
            let together = bytes(wide.clone(), places, cages, 2);
            let copies = bytes(wide.clone(), [places[2]; LANES], [cages[2]; LANES], 0);
            assert_eq!(together, copies);
            assert_eq!(together, bytes(narrow.clone(), places, cages, 2));
        }
    }
}
