//! What the contacts of a ring's balls are like: distance to lift-off, loads, life.

use fearless_simd::{Simd, SimdBase};

use super::number::{LANES, Lanes};
use super::ring::{Balls, side_by_side};
use super::ring_forces::ForceSums;
use super::{BallContact, BallLaw, BearingRotation, ForceLaw, RaceFilms, Ring, Vector5};
use crate::numerics::registers::{in_baseline_registers, in_wide_registers};

/// Loads of the balls of one bearing at an instant, ball 0 first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BallLoads {
    /// Normal loads at the inner and the outer race, N.
    pub load: [Vec<f64>; 2],
    /// Contact angles at the inner and the outer race, rad; empty where they are not asked for.
    pub angle: [Vec<f64>; 2],
    /// Approaches, m, as [`BallContact::approach`].
    pub approach: Vec<f64>,
    /// Loads of the slices of every roller, N; empty of balls, and where nobody asks for them.
    pub slices: Vec<f64>,
    /// Largest of the loads at the inner and the outer race, N.
    pub largest: [f64; 2],
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
            ..Self::default()
        }
    }

    /// With room for so many slices of each.
    pub(super) fn with_slices(self, slices: usize) -> Self {
        let slices = vec![0.0; slices * self.balls()];
        Self { slices, ..self }
    }

    /// Number of balls.
    pub fn balls(&self) -> usize {
        self.approach.len()
    }

    /// Loads that the life goes by, N: of each ball at the inner and the outer race, or of each slice of the rollers.
    pub(crate) fn rated_loads(&self) -> impl Iterator<Item = [f64; 2]> {
        let [inner, outer] = match self.slices.is_empty() {
            true => self.load.each_ref(),
            false => [&self.slices; 2],
        };
        inner
            .iter()
            .zip(outer)
            .map(|(inner, outer)| [*inner, *outer])
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
    /// Leaves how far each place of each ball is pressed past its lift-off, m, in `past`, ball 0 first of every place.
    pub(super) fn past_lift_offs(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
        past: &mut [f64],
    ) {
        in_wide_registers!(self.level, simd => {
            let displacement = side_by_side(simd, displacement);
            self.visit(
                simd,
                &displacement,
                rotation,
                #[inline(always)]
                |at| {
                    for (place, past) in past.chunks_exact_mut(self.balls()).enumerate() {
                        let speed = rotation.speed;
                        store(law.distance_past_lift_off(&at.ball, place, speed), at.first, past);
                    }
                },
            );
        });
    }

    /// How far one of these places is pressed past its lift-off, m.
    pub(super) fn past_lift_off(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
        number: usize,
    ) -> f64 {
        let (place, ball) = (number / self.balls(), number % self.balls());
        in_wide_registers!(self.level, simd => {
            let displacement = side_by_side(simd, displacement);
            let mut past = f64::INFINITY;
            self.visit(
                simd,
                &displacement,
                rotation,
                #[inline(always)]
                |at| {
                    if (at.first..at.first + LANES).contains(&ball) {
                        let distances = law.distance_past_lift_off(&at.ball, place, rotation.speed);
                        past = distances[ball - at.first];
                    }
                },
            );
            past
        })
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
            let zero = Lanes::splat(simd, 0.0);
            let mut largest = [zero; 2];
            let mut sums = ForceSums::new(simd, self.arm);
            let displacement = side_by_side(simd, displacement);
            self.visit(
                simd,
                &displacement,
                rotation,
                #[inline(always)]
                |at| {
                    let response = law.response(&at.ball, rotation.speed);
                    sums.add_force(at, law, &response.force);
                    for (race, load) in response.load.into_iter().enumerate() {
                        largest[race] = (load * at.side.abs()).max(largest[race]);
                        store(load, at.first, &mut loads.load[race]);
                    }
                    store(response.approach, at.first, &mut loads.approach);
                    if !loads.angle[0].is_empty() {
                        store_angles(law, at, rotation.speed, loads);
                    }
                    if !loads.slices.is_empty() {
                        store_slices(law, at, loads);
                    }
                },
            );
            loads.largest = largest.map(|lanes| {
                let [a, b, c, d] = *lanes;
                a.max(b).max(c.max(d))
            });
            sums.force()
        })
    }

    /// Energy, J, that elastic contacts and films store: `Σ_balls Σ_races ∫ Q ds` with `s(Q) = δ(Q) − h(Q)`.
    pub(super) fn stored_energy(
        &self,
        law: &impl BallLaw,
        films: Option<&RaceFilms>,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> f64 {
        let mut energy = 0.0;
        in_baseline_registers!(simd => {
        self.visit(simd, &side_by_side(simd, displacement), rotation, |at| {
            for (_, ball) in at.single(self.balls()) {
                let response = law.response(&ball, rotation.speed);
                let elastic = law.elastic_energies(&ball, &response);
                let in_films = films.map_or([0.0; 2], |films| {
                    films.stored_energies(response.load, rotation.speed)
                });
                energy += (elastic[0] + in_films[0]) + (elastic[1] + in_films[1]);
            }
        });
        });
        energy
    }
}

/// Copies the lanes that have a ball to their places among all.
#[inline(always)]
fn store<S: Simd>(lanes: Lanes<S>, first: usize, all: &mut [f64]) {
    let Some(places) = all.get_mut(first..) else {
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

/// Leaves the contact angles of balls in `loads`.
#[inline(never)]
fn store_angles<S: Simd>(law: &impl BallLaw, at: &Balls<S>, speed: f64, loads: &mut BallLoads) {
    for (number, ball) in at.single(loads.balls()) {
        let contact = law.contact(&ball, speed);
        // the second row leans the other way
        let side = at.side[number - at.first];
        loads.angle[0][number] = side * contact.angle_inner;
        loads.angle[1][number] = side * contact.angle_outer;
    }
}

/// Leaves the loads of the slices of rollers in `loads`.
#[inline(never)]
fn store_slices<S: Simd>(law: &impl BallLaw, at: &Balls<S>, loads: &mut BallLoads) {
    let count = loads.slices.len() / loads.balls();
    for (number, ball) in at.single(loads.balls()) {
        law.slice_loads(&ball, &mut loads.slices[number * count..][..count]);
    }
}
