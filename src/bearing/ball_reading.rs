//! What the law of its balls says of every ball of a ring.

use super::any_ring::AnyRing;
use super::film_shares::FilmShares;
use super::jones::{BallState, JonesLaw};
use super::races::{RaceFilms, Races};
use super::{
    BallContact, BallForce, BallLaw, BallTangent, CageAngle, Matrix5, Ring, StiffnessShares,
    Vector5,
};

/// One ball in its place, the cage where it starts.
#[derive(Debug, Clone, Copy)]
pub(super) struct BallReading {
    /// Azimuth, rad.
    pub azimuth: f64,
    /// Distance of the groove centres, m.
    pub distance: f64,
    /// Loads and angles.
    pub contact: BallContact,
    /// Inertia and motion; none where the law neglects inertia.
    pub inertia: Option<BallState>,
}

impl AnyRing {
    /// Every ball with the inner ring at `place`, ball 0 first.
    pub fn readings(&self, place: &Vector5, speed: f64) -> Vec<BallReading> {
        match self {
            Self::Hertz(ring) => without_inertia(ring, place, speed),
            Self::HertzFilm(ring) => without_inertia(ring, place, speed),
            Self::Jones(ring) => with_inertia(ring, place, speed),
            Self::JonesFilm(ring) => with_inertia(ring, place, speed),
        }
    }

    /// Oil films of both races, where the law has them.
    pub fn films(&self) -> Option<&RaceFilms> {
        match self {
            Self::Hertz(_) | Self::Jones(_) => None,
            Self::HertzFilm(ring) => Some(ring.law().films()),
            Self::JonesFilm(ring) => Some(ring.law().films()),
        }
    }

    /// K of the contacts and of the films alone; none where there are no films.
    pub fn shares(&self, place: &Vector5, speed: f64) -> Option<StiffnessShares> {
        match self {
            Self::HertzFilm(ring) if speed != 0.0 => Some(shares(ring, place, speed)),
            Self::JonesFilm(ring) if speed != 0.0 => Some(shares(ring, place, speed)),
            _ => None,
        }
    }
}

fn without_inertia(ring: &Ring<impl BallLaw>, place: &Vector5, speed: f64) -> Vec<BallReading> {
    ring.places(*place)
        .map(|(azimuth, [axial, radial])| BallReading {
            azimuth,
            distance: axial.hypot(radial),
            contact: ring.law().contact(axial, radial, speed),
            inertia: None,
        })
        .collect()
}

fn with_inertia<R: Races>(
    ring: &Ring<JonesLaw<R>>,
    place: &Vector5,
    speed: f64,
) -> Vec<BallReading> {
    ring.places(*place)
        .map(|(azimuth, [axial, radial])| {
            let state = ring.law().state(axial, radial, speed);
            BallReading {
                azimuth,
                distance: axial.hypot(radial),
                contact: state.contact,
                inertia: Some(state),
            }
        })
        .collect()
}

fn shares<L: FilmShares>(ring: &Ring<L>, place: &Vector5, speed: f64) -> StiffnessShares {
    let law = ring.law();
    let sum = |tangent: &dyn Fn(f64, f64) -> BallTangent| -> Matrix5 {
        let ball = |axial, radial| (BallForce::default(), tangent(axial, radial));
        ring.assemble(place, CageAngle::START, ball).1
    };
    StiffnessShares {
        contacts: sum(&|axial, radial| law.contact_tangent(axial, radial, speed)),
        films: sum(&|axial, radial| law.film_tangent(axial, radial, speed)),
    }
}
