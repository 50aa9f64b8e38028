//! What the contacts of a ring's balls are like: distance to lift-off, loads, life.

use fearless_simd::{Fallback, Simd, SimdBase, SimdFloat};

use super::number::{LANES, Lanes};
use super::ring::{Balls, Consumer, side_by_side};
use super::ring_forces::{ForceSums, total};
use super::{BallContact, BallLaw, BearingRotation, ForceLaw, Ring, Vector5};
use crate::registers::in_wide_registers;

/// Loads of the balls of one bearing at an instant, ball 0 first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BallLoads {
    /// Normal loads at the inner and the outer race, N.
    pub load: [Vec<f64>; 2],
    /// Contact angles at the inner and the outer race, rad; empty where they are not asked for.
    pub angle: [Vec<f64>; 2],
    /// Approaches, m, as [`BallContact::approach`].
    pub approach: Vec<f64>,
    /// Largest of the loads at the inner and the outer race, N.
    pub largest: [f64; 2],
    /// Sums over the balls of Q_i³ and Q_o^(10/3): what `RatingLife::consumption` takes.
    pub life_powers: [f64; 2],
}

impl BallLoads {
    /// Room for so many balls, and for their angles.
    pub(crate) fn new(balls: usize, angles: bool) -> Self {
        let zeros = |count| vec![0.0; count];
        let angles = if angles { balls } else { 0 };
        Self {
            load: [zeros(balls), zeros(balls)],
            angle: [zeros(angles), zeros(angles)],
            approach: zeros(balls),
            largest: [0.0; 2],
            life_powers: [0.0; 2],
        }
    }

    /// Number of balls.
    pub fn balls(&self) -> usize {
        self.approach.len()
    }

    /// Ball by ball; angles are zero where they are not asked for.
    pub fn contacts(&self) -> impl Iterator<Item = BallContact> {
        let angle = |race: usize, ball| self.angle[race].get(ball).copied().unwrap_or(0.0);
        (0..self.balls()).map(move |ball| BallContact {
            load_inner: self.load[0][ball],
            load_outer: self.load[1][ball],
            angle_inner: angle(0, ball),
            angle_outer: angle(1, ball),
            approach: self.approach[ball],
        })
    }
}

impl Ring {
    /// Leaves how far each ball is pressed past its lift-off, m, in `past`, ball 0 first.
    pub(super) fn past_lift_offs(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
        past: &mut [f64],
    ) {
        in_wide_registers!(self.level, simd => {
            let speed = rotation.speed;
            let mut lift_off = LiftOff { law, speed, past };
            self.visit(simd, &side_by_side(simd, displacement), rotation, &mut lift_off);
        });
    }

    /// Force as by [`Ring::force`]; leaves the loads of all balls in `loads`.
    pub(crate) fn loads(
        &self,
        law: &impl BallLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
        loads: &mut BallLoads,
    ) -> Vector5 {
        in_wide_registers!(self.level, simd => {
            let mut found = Loads {
                law,
                speed: rotation.speed,
                arm: self.arm,
                loads,
                powers: [Lanes::splat(simd, 0.0); 2],
                largest: [Lanes::splat(simd, 0.0); 2],
                sums: ForceSums::new(simd),
            };
            self.visit(simd, &side_by_side(simd, displacement), rotation, &mut found);
            found.finish()
        })
    }

    /// Energy, J, that the contacts store.
    pub(super) fn stored_energy(
        &self,
        law: &impl BallLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> f64 {
        let simd = Fallback::new();
        let mut energy = Energy {
            law,
            speed: rotation.speed,
            balls: self.balls(),
            sum: 0.0,
        };
        self.visit(
            simd,
            &side_by_side(simd, displacement),
            rotation,
            &mut energy,
        );
        energy.sum
    }
}

/// Copies the lanes that stand for balls to their places among all.
#[inline(always)]
fn store<S: Simd>(lanes: Lanes<S>, first: usize, all: &mut [f64]) {
    let count = LANES.min(all.len().saturating_sub(first));
    let Some(places) = all.get_mut(first..first + count) else {
        return;
    };
    if let Some(places) = places.first_chunk_mut::<LANES>() {
        *places = *lanes;
        return;
    }
    for (lane, place) in places.iter_mut().enumerate() {
        *place = lanes[lane];
    }
}

/// Distances past the lift-off.
struct LiftOff<'a, L> {
    law: &'a L,
    speed: f64,
    past: &'a mut [f64],
}

impl<L: ForceLaw, S: Simd> Consumer<S> for LiftOff<'_, L> {
    #[inline(always)]
    fn take(&mut self, at: &Balls<S>) {
        let past = self.law.distance_past_lift_off(&at.ball, self.speed);
        store(past, at.first, self.past);
    }
}

/// Loads, approaches and powers of loads, with the force.
struct Loads<'a, L, S: Simd> {
    law: &'a L,
    speed: f64,
    arm: f64,
    loads: &'a mut BallLoads,
    powers: [Lanes<S>; 2],
    largest: [Lanes<S>; 2],
    sums: ForceSums<S>,
}

impl<L: BallLaw, S: Simd> Consumer<S> for Loads<'_, L, S> {
    #[inline(always)]
    fn take(&mut self, at: &Balls<S>) {
        let response = self.law.response(&at.ball, self.speed);
        self.sums.add_force(at, self.law, &response.force, self.arm);
        let powers = self.law.life_powers(&response);
        for (race, power) in powers.into_iter().enumerate() {
            self.powers[race] += power * at.weight;
            self.largest[race] = (response.load[race] * at.weight).max(self.largest[race]);
            store(response.load[race], at.first, &mut self.loads.load[race]);
        }
        store(response.approach, at.first, &mut self.loads.approach);
        if !self.loads.angle[0].is_empty() {
            self.angles(at);
        }
    }
}

impl<L: BallLaw, S: Simd> Loads<'_, L, S> {
    #[inline(never)]
    fn angles(&mut self, at: &Balls<S>) {
        let count = self.loads.balls();
        for (number, ball) in at.single(count) {
            let contact = self.law.contact(&ball, self.speed);
            self.loads.angle[0][number] = contact.angle_inner;
            self.loads.angle[1][number] = contact.angle_outer;
        }
    }

    #[inline(always)]
    fn finish(&mut self) -> Vector5 {
        for race in 0..2 {
            self.loads.life_powers[race] = total(&self.powers[race]);
            let [a, b, c, d] = *self.largest[race];
            self.loads.largest[race] = a.max(b).max(c.max(d));
        }
        self.sums.force(self.arm)
    }
}

/// Stored energy, ball by ball.
struct Energy<'a, L> {
    law: &'a L,
    speed: f64,
    balls: usize,
    sum: f64,
}

impl<L: BallLaw, S: Simd> Consumer<S> for Energy<'_, L> {
    fn take(&mut self, at: &Balls<S>) {
        for (_, ball) in at.single(self.balls) {
            self.sum += self.law.stored_energy(&ball, self.speed);
        }
    }
}
