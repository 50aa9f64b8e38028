//! What keeps the shaft moving, and how often it repeats.

use std::f64::consts::TAU;
use std::fmt;

use super::{LoadKind, Rotor};
use crate::bearing::Support;
use crate::physics::Race;

/// What repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForcingCause {
    /// The unbalance turns with the shaft.
    Unbalance,
    /// The balls of a bearing, counted from 0, pass a position that is fixed.
    BallPass(usize),
    /// The balls of a bearing, which differ, go round with their cage.
    Cage(usize),
    /// What is on the race of the turning ring of a bearing turns with it.
    TurningRace(usize, Race),
    /// What is on balls of a bearing turns with them.
    BallSpin(usize),
    /// A load, counted from 0 among those that vary.
    Load(usize),
}

/// `unbalance`, `ball pass of bearing 1`, `cage of bearing 1`, `inner race of bearing 1`, `rolling-element spin of bearing 1`, `varying load 1`.
impl fmt::Display for ForcingCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unbalance => f.write_str("unbalance"),
            Self::BallPass(bearing) => write!(f, "ball pass of bearing {}", bearing + 1),
            Self::Cage(bearing) => write!(f, "cage of bearing {}", bearing + 1),
            Self::TurningRace(bearing, Race::Inner) => {
                write!(f, "inner race of bearing {}", bearing + 1)
            }
            Self::TurningRace(bearing, Race::Outer) => {
                write!(f, "outer race of bearing {}", bearing + 1)
            }
            Self::BallSpin(bearing) => write!(f, "rolling-element spin of bearing {}", bearing + 1),
            Self::Load(number) => write!(f, "varying load {}", number + 1),
        }
    }
}

/// A forcing that repeats.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forcing {
    /// What it is.
    pub cause: ForcingCause,
    /// Its angular frequency, rad/s, positive.
    pub frequency: f64,
    /// Time from which on it repeats, s.
    pub from: f64,
}

/// Why the forcing of a shaft does not repeat.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unrepeated {
    /// The speed changes.
    #[error(
        "the speed of the shaft changes, so no motion of it repeats; a steady state belongs to one \
         constant speed: set speed.constant"
    )]
    Speed,
    /// A drive decides the speed.
    #[error(
        "a drive decides the speed of the shaft, so its angle is no given function of time; set \
         speed.constant to the speed that the drive settles at"
    )]
    Drive,
    /// Balls pass a defect that turns.
    #[error(
        "bearing {} has a defect on its turning race or on a rolling element: where and when it is rolled over repeats with no \
         period of the bearing, and what is not smooth cannot be followed round a torus; leave it out, or use `jeffcott run`",
        bearing + 1
    )]
    Defect {
        /// Bearing, from 0.
        bearing: usize,
    },
    /// A cage wanders.
    #[error(
        "the cage of bearing {} wanders at random (cage_jitter), so no motion of the shaft repeats; leave `cage_jitter` out, or use `jeffcott run`",
        bearing + 1
    )]
    CageJitter {
        /// Bearing, from 0.
        bearing: usize,
    },
    /// A load does not repeat.
    #[error("varying load {} is {what}, which does not repeat: leave it out, or use `jeffcott run`", number + 1)]
    Load {
        /// Load, from 0, among those that vary.
        number: usize,
        /// What it is.
        what: &'static str,
    },
}

impl Rotor {
    /// Everything that keeps the shaft moving at its constant speed; what has no amplitude is left out.
    ///
    /// # Errors
    /// [`Unrepeated`] names the first thing that does not repeat.
    pub(crate) fn forcing(&self) -> Result<Vec<Forcing>, Unrepeated> {
        if self.is_driven() {
            return Err(Unrepeated::Drive);
        }
        let speed = self.steady_from(0.0).ok_or(Unrepeated::Speed)?;
        let mut found = Vec::new();
        let mut add = |cause, frequency: f64, from| {
            if frequency > 0.0 {
                found.push(Forcing {
                    cause,
                    frequency,
                    from,
                });
            }
        };
        if self.is_unbalanced() {
            add(ForcingCause::Unbalance, speed, 0.0);
        }
        for (bearing, support) in self.elements.supports().enumerate() {
            let balls = support.definition().bearing.geometry.balls() as f64;
            let cage = support.cage_ratio() * speed;
            if support.cage_jitter().is_some() && cage > 0.0 {
                return Err(Unrepeated::CageJitter { bearing });
            }
            let surfaces = support.surfaces_that_turn();
            if surfaces.defects && cage > 0.0 {
                return Err(Unrepeated::Defect { bearing });
            }
            if surfaces.balls_differ {
                add(ForcingCause::Cage(bearing), cage, 0.0);
            } else if support.follows_cage() {
                add(ForcingCause::BallPass(bearing), balls * cage, 0.0);
            }
            if surfaces.race {
                let turning = support.definition().bearing.rotating_ring;
                add(ForcingCause::TurningRace(bearing, turning), speed, 0.0);
            }
            if let Some(ratio) = surfaces.rolling {
                add(ForcingCause::BallSpin(bearing), ratio * cage, 0.0);
            }
        }
        for (number, load) in self.excitation.loads.iter().enumerate() {
            let refused = |what| Unrepeated::Load { number, what };
            if let Some((frequency, from)) = load.kind.repetition(speed).map_err(refused)? {
                add(ForcingCause::Load(number), frequency, from);
            }
        }
        Ok(found)
    }

    /// Whether any unbalance turns with the shaft.
    pub(crate) fn is_unbalanced(&self) -> bool {
        self.excitation.is_unbalanced()
    }

    /// Whether a load or a cage moves by chance, or a load as a record does: it may vibrate at any frequency.
    pub(crate) fn is_random(&self) -> bool {
        let wanders = |support: &Support| support.cage_jitter().is_some();
        self.excitation
            .loads
            .iter()
            .any(|load| load.kind.is_random())
            || self.elements.supports().any(wanders)
    }

    /// Frequencies of the varying loads that repeat at a speed in rad/s, by their numbers from 0, Hz; not of sprockets.
    pub(crate) fn load_frequencies(&self, speed: f64) -> Vec<(usize, f64)> {
        let loads = self.excitation.loads.iter().enumerate();
        let repeating = loads.filter_map(|(number, load)| match load.kind {
            LoadKind::Sprocket(_) => None,
            _ => Some((number, load.kind.repetition(speed).ok()??.0 / TAU)),
        });
        repeating.collect()
    }

    /// Periods per revolution of the loads that go with the shaft's angle; not of sprockets.
    pub(crate) fn excited_orders(&self) -> Vec<f64> {
        let loads = self.excitation.loads.iter().map(|load| &load.kind);
        let harmonics = loads.filter(|kind| !matches!(kind, LoadKind::Sprocket(_)));
        let orders = harmonics.map(|kind| kind.main_vibration().order);
        orders.filter(|order| *order > 0.0).collect()
    }

    /// Ball passes a revolution at the standing and the turning race, of every bearing whose balls
    /// go round.
    pub(crate) fn ball_pass_orders(&self) -> Vec<[f64; 2]> {
        let supports = self.elements.supports();
        let passing = supports.filter(|support| support.follows_cage());
        let orders = passing.map(|support| {
            let balls = support.definition().bearing.geometry.balls() as f64;
            let standing = support.passes();
            [standing, balls - standing]
        });
        orders.filter(|[standing, _]| *standing > 0.0).collect()
    }

    /// Meshing frequency z ω/2π of every sprocket at a speed in rad/s, Hz.
    pub(crate) fn meshing_frequencies(&self, speed: f64) -> Vec<f64> {
        let sprockets = self
            .excitation
            .loads
            .iter()
            .filter_map(|load| match &load.kind {
                LoadKind::Sprocket(sprocket) => Some(sprocket.main_vibration().order),
                _ => None,
            });
        sprockets.map(|order| order * speed / TAU).collect()
    }
}
