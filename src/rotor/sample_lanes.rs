//! What can be seen of the shaft at a few instants side by side.

use super::{BallContacts, FREEDOMS, Rotation, Rotor, Sample};
use crate::bearing::{LANES, LOADED_SHARE, SupportObservation, Vector5};

/// Samples of a rotor on plain Hertz bearings, [`LANES`] at a time: what [`Rotor::sample`] says of each, but for
/// round-off, at a fraction of its cost. An instant is the same whatever stands beside it.
#[derive(Debug)]
pub(crate) struct SampleLanes<'a> {
    rotor: &'a Rotor,
    /// None where nothing is said of them.
    bearings: Vec<SupportObservation>,
    /// Whether the balls are looked at, or the forces alone.
    balls: bool,
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
        Some(Self {
            rotor,
            bearings: bearings.collect::<Option<_>>()?,
            balls: !contacts.balls.is_empty(),
        })
    }

    /// Adds to `samples` what is observed in the first so many of states at times.
    pub fn observe<const N: usize>(
        &mut self,
        times: [f64; LANES],
        states: [&[f64; N]; LANES],
        count: usize,
        samples: &mut Vec<Sample>,
    ) {
        let (rotor, held) = (self.rotor, &self.rotor.equilibrium.displacement);
        let rotations = times.map(|time| rotor.speed.at(time));
        let displacements = states.map(|state| rotor.full(held, &state[..N / 2]));
        self.observe_bearings(&rotations, &displacements);
        for lane in 0..count.min(LANES) {
            samples.push(Sample {
                time: times[lane],
                angle: rotations[lane].angle,
                speed: rotations[lane].speed,
                displacement: displacements[lane],
                velocity: rotor.full(&[0.0; FREEDOMS], &states[lane][N / 2..]),
                force_on_shaft: self.force_on_shaft(lane),
                largest_ball_load: if self.balls {
                    self.largest_load(lane)
                } else {
                    0.0
                },
                balls_loaded: if self.balls { self.loaded(lane) } else { 0 },
                energy: None,
                drive: None,
            });
        }
    }

    /// Looks at nothing but the bearings, at one instant: those of [`SampleLanes::bearings`] are all at it.
    pub fn look_at(&mut self, time: f64, displacement: &Vector5) {
        let rotation = self.rotor.speed.at(time);
        self.observe_bearings(&[rotation; LANES], &[*displacement; LANES]);
    }

    /// Where the shaft is in a state.
    pub fn displacement<const N: usize>(&self, state: &[f64; N]) -> Vector5 {
        let held = &self.rotor.equilibrium.displacement;
        self.rotor.full(held, &state[..N / 2])
    }

    /// The bearings of the samples taken last.
    pub fn bearings(&self) -> &[SupportObservation] {
        &self.bearings
    }

    /// Load at the inner race above which a ball counts as loaded in a sample, N, as by
    /// [`BallContacts::least_load`].
    pub fn least_load(&self, lane: usize) -> f64 {
        LOADED_SHARE * self.largest_load(lane)
    }

    /// Leaves the balls of a sample in `contacts`, as [`Rotor::sample`] does.
    pub fn fill(&self, lane: usize, contacts: &mut BallContacts) {
        let angles = contacts.angles;
        let mut balls = contacts.balls.as_mut_slice();
        for (bearing, axial) in self.bearings.iter().zip(&mut contacts.axial_forces) {
            *axial = bearing.axial_force(lane);
            let (own, others) = balls.split_at_mut(bearing.count().min(balls.len()));
            bearing.fill(lane, angles, own);
            balls = others;
        }
        contacts.sum_up();
    }

    fn observe_bearings(
        &mut self,
        rotations: &[Rotation; LANES],
        displacements: &[Vector5; LANES],
    ) {
        for (bearing, support) in self.bearings.iter_mut().zip(&self.rotor.supports) {
            let ratio = self.rotor.cage_ratio(support);
            let cages = rotations.map(|rotation| ratio * rotation.angle);
            bearing.observe(displacements, cages);
        }
    }

    fn force_on_shaft(&self, lane: usize) -> Vector5 {
        let mut force = [0.0; FREEDOMS];
        for bearing in &self.bearings {
            for (sum, row) in force.iter_mut().zip(bearing.force()) {
                *sum -= row.0[lane];
            }
        }
        force
    }

    fn largest_load(&self, lane: usize) -> f64 {
        let bearings = self.bearings.iter();
        let largest = bearings.map(|bearing| bearing.load_range(lane)[0]);
        largest.fold(0.0, |a, b| if b > a { b } else { a })
    }

    fn loaded(&self, lane: usize) -> u32 {
        let least = self.least_load(lane);
        let mut count = 0;
        for bearing in &self.bearings {
            count += match bearing.load_range(lane) {
                [_, smallest] if smallest > least => bearing.count(),
                _ => bearing.loads(lane).filter(|load| *load > least).count(),
            };
        }
        count as u32
    }
}
