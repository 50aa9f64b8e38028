//! The drops of all surfaces under the balls of a ring.

use std::f64::consts::{PI, TAU};

use super::slot::Slot;
use super::waves::Waves;
use super::{Defect, Imperfections, Passing, Surface};
use crate::bearing::number::LANES;
use crate::bearing::{Angle, Bearing, BearingRotation, Geometry};
use crate::physics::Race;

/// Drops of balls side by side, or their rates: at the inner and at the outer race.
type Drops = [[f64; LANES]; 2];

/// Imperfect surfaces, ready to be asked: under a ball the inner and the outer race lie lower by
///
/// ```text
/// h_o = h(φ_j) + h_j(χ) − Δ_j/2        h_i = h(φ_j − ψ) + h_j(χ + π) − Δ_j/2        χ = ψ_c (1 + γ) d_m/D
/// ```
///
/// in m, with φ_j − ψ at the outer race where that one turns: what belongs to the race, to the ball, and to its excess of
/// diameter Δ. The ball is taken to roll on the outer
/// race, to which its own weight presses it, about an axis that keeps its direction to the races; with a cage at rest
/// it does not turn.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::bearing) struct ImperfectSurfaces {
    /// Inner and outer race.
    races: [RaceSurface; 2],
    /// Surfaces of balls that are not perfect.
    balls: Vec<BallSurface>,
    /// Number of balls of a row; slots of races are under the first.
    row: usize,
    /// Angle that a ball turns by over that of the cage.
    rolling_ratio: f64,
    /// The ring that turns.
    turning: Race,
    /// When balls pass the places at which a drop is not smooth.
    pub passings: Vec<Passing>,
}

/// What lies on a race.
#[derive(Debug, Clone, PartialEq, Default)]
struct RaceSurface {
    slots: Vec<RaceSlot>,
    waves: Waves,
}

/// A slot at its place on a race.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RaceSlot {
    middle: Angle,
    slot: Slot,
    /// Radius of the circle on which balls meet the race, m.
    radius: f64,
    /// Cosine of half the angle that it takes.
    least_cos: f64,
}

/// What is on one ball.
#[derive(Debug, Clone, PartialEq)]
struct BallSurface {
    number: usize,
    radius: f64,
    /// Excess of its diameter, m.
    oversize: f64,
    /// Angles of dents, with what they are under the inner and the outer race.
    dents: Vec<(f64, [Slot; 2])>,
    waves: Waves,
}

impl ImperfectSurfaces {
    /// Surfaces of a bearing whose ball 0 starts at an azimuth in rad and whose balls turn by a ratio of the angle of the cage; none
    /// where they are perfect. What does not fit has been
    /// refused.
    pub fn new(
        imperfections: &Imperfections,
        bearing: &Bearing,
        first_ball: f64,
        rolling_ratio: f64,
    ) -> Option<Self> {
        if imperfections.has_perfect_surfaces() {
            return None;
        }
        let (geometry, turning) = (&bearing.geometry, bearing.rotating_ring);
        let races = [Surface::Inner, Surface::Outer]
            .map(|race| RaceSurface::new(race, imperfections, geometry));
        let balls = (0..geometry.all_balls())
            .map(|number| BallSurface::new(number, imperfections, geometry))
            .filter(|ball| !ball.is_perfect())
            .collect();
        let defects = imperfections.defects.iter();
        Some(Self {
            races,
            balls,
            row: geometry.balls(),
            rolling_ratio,
            turning,
            passings: defects
                .flat_map(|defect| defect.passings(bearing, first_ball, rolling_ratio))
                .collect(),
        })
    }

    /// Which of them turn.
    pub fn turning(&self) -> TurningSurfaces {
        let rolls = |ball: &BallSurface| !ball.dents.is_empty() || !ball.waves.is_none();
        TurningSurfaces {
            race: !self.races[self.turning as usize].is_perfect(),
            defects: !self.races[self.turning as usize].slots.is_empty()
                || self.balls.iter().any(|ball| !ball.dents.is_empty()),
            balls_differ: !self.balls.is_empty(),
            rolling: (self.balls.iter().any(rolls)).then_some(self.rolling_ratio.abs()),
        }
    }

    /// Sum of the largest drops of all surfaces, m, or of the largest rises where these are larger.
    pub fn bound(&self) -> f64 {
        let balls = self.balls.iter().map(BallSurface::bound);
        let races = self.races.iter().map(RaceSurface::bound);
        races.sum::<f64>() + balls.fold(0.0, f64::max)
    }

    /// Drops, m, of balls in directions (cos φ, sin φ).
    pub fn drops(
        &self,
        identity: BallIdentity,
        directions: [&[f64; LANES]; 2],
        rotation: &BearingRotation,
    ) -> Drops {
        let mut drops = [[0.0; LANES]; 2];
        self.visit(
            identity,
            directions,
            rotation,
            |race, lane, [drop, _], _| {
                drops[race][lane] += drop;
            },
        );
        drops
    }

    /// Rates of these drops, m/s, where cage and shaft turn at speeds in rad/s.
    pub fn rates(
        &self,
        first: usize,
        directions: [&[f64; LANES]; 2],
        rotation: &BearingRotation,
        [cage_speed, speed]: [f64; 2],
    ) -> Drops {
        let mut rates = [[0.0; LANES]; 2];
        let mut speeds = [cage_speed, cage_speed, self.rolling_ratio * cage_speed];
        speeds[self.turning as usize] -= speed;
        self.visit(
            BallIdentity::Numbered(first),
            directions,
            rotation,
            |race, lane, [_, slope], turns| {
                rates[race][lane] += slope * speeds[turns as usize];
            },
        );
        rates
    }

    /// Hands on each part of a drop with its slope by the angle that it depends on, m/rad, for each race and ball.
    #[inline(always)]
    fn visit(
        &self,
        identity: BallIdentity,
        [cos, sin]: [&[f64; LANES]; 2],
        rotation: &BearingRotation,
        mut take: impl FnMut(usize, usize, [f64; 2], Turns),
    ) {
        for (race, turns) in [Turns::PastInner, Turns::PastOuter].into_iter().enumerate() {
            let surface = &self.races[race];
            if surface.is_perfect() {
                continue;
            }
            let back = if race == self.turning as usize {
                rotation.shaft
            } else {
                Angle::ZERO
            };
            for lane in 0..LANES {
                // φ − ψ
                let direction = [
                    cos[lane] * back.cos + sin[lane] * back.sin,
                    sin[lane] * back.cos - cos[lane] * back.sin,
                ];
                let slots = match identity {
                    BallIdentity::Numbered(first) => first + lane < self.row,
                    BallIdentity::Perfect { row } => row == 0,
                };
                surface.at(direction, slots, |part| take(race, lane, part, turns));
            }
        }
        let BallIdentity::Numbered(first) = identity else {
            return;
        };
        for ball in &self.balls {
            if let Some(lane) = ball.number.checked_sub(first).filter(|lane| *lane < LANES) {
                let angle = self.rolling_ratio * rotation.cage_angle;
                for race in 0..2 {
                    take(race, lane, ball.at(race, angle), Turns::Rolling);
                }
            }
        }
    }
}

/// BallIdentity balls or rollers drops are of.
#[derive(Debug, Clone, Copy)]
pub enum BallIdentity {
    /// The ones from a number on, side by side.
    Numbered(usize),
    /// Perfect ones that may be anywhere in a row; 0 is the first.
    Perfect { row: usize },
}

/// Imperfect surfaces that turn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TurningSurfaces {
    /// Whether the race of the turning ring does.
    pub race: bool,
    /// Whether there is a defect on it or on a ball.
    pub defects: bool,
    /// Whether balls differ from each other, which go round with the cage.
    pub balls_differ: bool,
    /// How often balls with dents or waves turn as the cage turns once; none where there are none.
    pub rolling: Option<f64>,
}

/// The angle that a drop depends on.
#[derive(Debug, Clone, Copy)]
enum Turns {
    /// That of the ball past the inner race.
    PastInner,
    /// That past the outer race.
    PastOuter,
    /// That of the ball about its own axis.
    Rolling,
}

impl RaceSurface {
    fn new(race: Surface, imperfections: &Imperfections, geometry: &Geometry) -> Self {
        let radius = race.radius(geometry);
        let slots = imperfections.defects_on(race).map(|defect| RaceSlot {
            middle: Angle::new(defect.angle),
            slot: defect.slot(geometry, race == Surface::Inner),
            radius,
            least_cos: (0.5 * defect.length / radius).min(PI).cos(),
        });
        Self {
            slots: slots.collect(),
            waves: imperfections.waves_on(race),
        }
    }

    fn is_perfect(&self) -> bool {
        self.slots.is_empty() && self.waves.is_none()
    }

    fn bound(&self) -> f64 {
        let slots = self.slots.iter().map(|slot| slot.slot.deepest());
        slots.fold(0.0, f64::max) + self.waves.bound()
    }

    /// Hands on the parts of the drop in a direction from the mark of the race, without its slots where these are under
    /// another row; there is none where no ball is, at (0, 0).
    #[inline(always)]
    fn at(&self, direction: [f64; 2], slots: bool, mut take: impl FnMut([f64; 2])) {
        let [cos, sin] = direction;
        for on_race in self.slots.iter().filter(|_| slots) {
            let (middle, radius) = (on_race.middle, on_race.radius);
            // angle of the ball from the middle of the slot, worked out only where it is over it
            let along = cos * middle.cos + sin * middle.sin;
            if along > on_race.least_cos {
                let angle = (sin * middle.cos - cos * middle.sin).atan2(along);
                let [drop, slope] = on_race.slot.at(angle * radius);
                take([drop, slope * radius]);
            }
        }
        if !self.waves.is_none() {
            take(self.waves.at(direction));
        }
    }
}

impl BallSurface {
    fn new(number: usize, imperfections: &Imperfections, geometry: &Geometry) -> Self {
        let on = Surface::Ball(number);
        let dents = imperfections.defects_on(on).map(|defect| {
            let slots = [true, false].map(|inner| defect.slot(geometry, inner));
            (defect.angle, slots)
        });
        Self {
            number,
            radius: on.radius(geometry),
            oversize: imperfections.oversizes.get(number).copied().unwrap_or(0.0),
            dents: dents.collect(),
            waves: imperfections.waves_on(on),
        }
    }

    fn is_perfect(&self) -> bool {
        self.oversize == 0.0 && self.dents.is_empty() && self.waves.is_none()
    }

    fn bound(&self) -> f64 {
        let dents = self.dents.iter().map(|(_, [inner, _])| inner.deepest());
        self.oversize.abs() + 2.0 * self.waves.bound() + dents.fold(0.0, f64::max)
    }

    /// Drop at the inner (0) or the outer race (1), and its slope by the angle that the ball has turned by.
    fn at(&self, race: usize, angle: f64) -> [f64; 2] {
        // the inner race meets the side opposite to the outer one
        let angle = if race == 0 { angle + PI } else { angle };
        // −Δ/2 and what dents and waves add
        let mut sum = [-0.5 * self.oversize, 0.0];
        let mut add = |[drop, slope]: [f64; 2]| {
            sum[0] += drop;
            sum[1] += slope;
        };
        for (middle, slots) in &self.dents {
            // distance along the ball, −πR … πR
            let apart = angle - middle;
            let place = (apart - TAU * (apart / TAU).round()) * self.radius;
            let [drop, slope] = slots[race].at(place);
            add([drop, slope * self.radius]);
        }
        if !self.waves.is_none() {
            let (sin, cos) = angle.sin_cos();
            add(self.waves.at([cos, sin]));
        }
        sum
    }
}

impl Imperfections {
    fn defects_on(&self, surface: Surface) -> impl Iterator<Item = &Defect> {
        self.defects
            .iter()
            .filter(move |defect| defect.on == surface)
    }

    fn waves_on(&self, surface: Surface) -> Waves {
        let waves = self.waves.iter().filter(|(on, _)| *on == surface);
        Waves::new(waves.map(|(_, wave)| *wave))
    }
}
