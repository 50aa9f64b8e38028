//! What can be seen of the shaft at a few instants side by side.

use super::sample_rows::SampleRow;
use super::{BallContacts, FREEDOMS, Rotor, Sample, SampleRows};
use crate::bearing::{LANES, LOADED_SHARE, LaneRow, SupportObservation, Vector5};

/// Groups of instants in [`SampleRows`]; behind them stands one for an instant that is not among them.
const GROUPS: usize = SampleRows::MOST / LANES;

/// Samples of a rotor on plain Hertz bearings, [`LANES`] at a time: what [`Rotor::sample`] says of each, but for
/// round-off, at a fraction of its cost. An instant is the same whatever stands beside it.
#[derive(Debug)]
pub(crate) struct SampleLanes<'a> {
    rotor: &'a Rotor,
    /// None where nothing is said of them.
    bearings: Vec<SupportObservation>,
    /// Whether the balls are looked at, or the forces alone.
    balls: bool,
    /// Largest load on a ball of any bearing, N, by group of instants.
    largest: [LaneRow; GROUPS],
}

impl<'a> SampleLanes<'a> {
    /// For samples that say as much as those that leave what they see of the balls in `contacts`; none where a
    /// drive decides the speed, or where they say more of the bearings than plain Hertz contacts tell.
    pub fn new(rotor: &'a Rotor, contacts: &BallContacts) -> Option<Self> {
        if rotor.drive.is_some() || (contacts.forces && rotor.contacts_damped) {
            return None;
        }
        let seen = match contacts.forces {
            true => &rotor.supports[..],
            false => &[],
        };
        let bearings = seen.iter().map(SupportObservation::new);
        let mut bearings: Vec<_> = bearings.collect::<Option<_>>()?;
        for bearing in &mut bearings {
            bearing.make_room(GROUPS + 1);
        }
        Some(Self {
            rotor,
            bearings,
            balls: !contacts.balls.is_empty(),
            largest: [LaneRow::default(); GROUPS],
        })
    }

    /// Says in `rows` how the shaft turns and moves in states, [`SampleRows::MOST`] of them at most, at times by
    /// their index; what the bearings bear is still to be looked at.
    pub fn place<const N: usize>(
        &self,
        time: impl Fn(usize) -> f64,
        states: &[[f64; N]],
        rows: &mut SampleRows,
    ) {
        self.displace(states, rows);
        let count = rows.length;
        for index in 0..count {
            let rotation = self.rotor.speed.at(time(index));
            rows.time[index] = time(index);
            rows.angle[index] = rotation.angle;
            rows.speed[index] = rotation.speed;
        }
        fill_up(&mut rows.angle, count);
        for (axis, velocity) in rows.velocity.iter_mut().enumerate() {
            match axis < N / 2 {
                true => set(velocity, states, N / 2 + axis),
                false => velocity[..count].fill(0.0),
            }
        }
    }

    /// Says in `rows` where the shaft is in states, as [`SampleLanes::place`], and nothing else.
    pub fn displace<const N: usize>(&self, states: &[[f64; N]], rows: &mut SampleRows) {
        rows.length = states.len().min(SampleRows::MOST);
        let held = &self.rotor.equilibrium.displacement;
        for (axis, place) in rows.displacement.iter_mut().enumerate() {
            match axis < N / 2 {
                true => set(place, states, axis),
                false => place[..rows.length].fill(held[axis]),
            }
            fill_up(place, rows.length);
        }
    }

    /// Looks at the bearings at all samples, and at no ball by itself; adds to `rows` what they bear.
    pub fn look_at_all(&mut self, rows: &mut SampleRows) {
        let groups = rows.length.div_ceil(LANES);
        let displacement = rows.displacement.each_ref();
        let displacement = displacement.map(|row| &row.as_chunks::<LANES>().0[..groups]);
        let angles = &rows.angle.as_chunks::<LANES>().0[..groups];
        for (bearing, support) in self.bearings.iter_mut().zip(&self.rotor.supports) {
            bearing.observe_all(displacement, angles, self.rotor.cage_ratio(support));
        }
        (0..groups).for_each(|number| self.sum_up(rows, number));
    }

    /// Looks at the bearings and all their balls at the samples in the lanes of a number, and adds to `rows` what
    /// they bear.
    pub fn look(&mut self, rows: &mut SampleRows, number: usize) {
        let angles = &rows.angle.as_chunks::<LANES>().0[number];
        self.observe(number, angles, rows.displacement_lanes(number));
        self.sum_up(rows, number);
    }

    /// Adds up what the bearings bear in the lanes of a number.
    fn sum_up(&mut self, rows: &mut SampleRows, number: usize) {
        for (axis, row) in rows.force_on_shaft.iter_mut().enumerate() {
            let mut force = [0.0; LANES];
            for bearing in &self.bearings {
                for (sum, part) in force.iter_mut().zip(&bearing.force(number)[axis].0) {
                    *sum -= part;
                }
            }
            row.as_chunks_mut::<LANES>().0[number] = force;
        }
        let mut largest = [0.0; LANES];
        for bearing in &self.bearings {
            for (largest, own) in largest.iter_mut().zip(bearing.largest_loads(number)) {
                *largest = if own > largest { *own } else { *largest };
            }
        }
        self.largest[number] = LaneRow(largest);
        if self.balls {
            rows.largest_ball_load.as_chunks_mut::<LANES>().0[number] = largest;
        }
    }

    /// The sample in a lane of those whose balls were looked at last, in the lanes of a number.
    pub fn sample(&self, rows: &SampleRows, number: usize, lane: usize) -> Sample {
        Sample {
            balls_loaded: if self.balls {
                self.loaded(number, lane)
            } else {
                0
            },
            ..rows.sample(LANES * number + lane)
        }
    }

    /// Looks at the bearings and all their balls at one instant that is not among the samples; answers the number of
    /// the lanes that all are at it.
    pub fn look_at(&mut self, time: f64, displacement: &Vector5) -> usize {
        let angle = self.rotor.speed.at(time).angle;
        let displacement = displacement.map(|axis| [axis; LANES]);
        self.observe(GROUPS, &[angle; LANES], displacement.each_ref());
        GROUPS
    }

    fn observe(
        &mut self,
        number: usize,
        angles: &[f64; LANES],
        displacement: [&[f64; LANES]; FREEDOMS],
    ) {
        for (bearing, support) in self.bearings.iter_mut().zip(&self.rotor.supports) {
            let ratio = self.rotor.cage_ratio(support);
            bearing.observe(number, displacement, angles, ratio);
        }
    }

    /// The bearings as they were seen last.
    pub fn bearings(&self) -> &[SupportObservation] {
        &self.bearings
    }

    /// Load at the inner race above which a ball counts as loaded in the lanes of a number, N, as by
    /// [`BallContacts::least_load`].
    pub fn least_loads(&self, number: usize) -> [f64; LANES] {
        self.largest[number].0.map(|largest| LOADED_SHARE * largest)
    }

    /// Leaves the balls of such a sample in `contacts`, as [`Rotor::sample`] does.
    pub fn fill(&self, number: usize, lane: usize, contacts: &mut BallContacts) {
        let angles = contacts.angles;
        let mut balls = contacts.balls.as_mut_slice();
        for (bearing, axial) in self.bearings.iter().zip(&mut contacts.axial_forces) {
            *axial = bearing.axial_force(number, lane);
            let (own, others) = balls.split_at_mut(bearing.count().min(balls.len()));
            bearing.fill(lane, angles, own);
            balls = others;
        }
        contacts.sum_up();
    }

    fn loaded(&self, number: usize, lane: usize) -> u32 {
        let least = self.least_loads(number)[lane];
        let mut count = 0;
        for bearing in &self.bearings {
            count += match bearing.smallest_loads(number)[lane] > least {
                true => bearing.count(),
                false => bearing.loads(lane).filter(|load| *load > least).count(),
            };
        }
        count as u32
    }
}

/// One component of states.
fn set<const N: usize>(row: &mut SampleRow, states: &[[f64; N]], component: usize) {
    for (value, state) in row.iter_mut().zip(states) {
        *value = state[component];
    }
}

/// Lanes that are left over see the last sample once more.
fn fill_up(row: &mut SampleRow, count: usize) {
    if !count.is_multiple_of(LANES) {
        let last = row[count - 1];
        row[count..count.next_multiple_of(LANES)].fill(last);
    }
}
