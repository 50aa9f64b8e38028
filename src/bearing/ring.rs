//! The ring of balls: from the displacement of the inner ring to the position of every ball, once.

use fearless_simd::{Level, Simd, SimdBase};
use nalgebra::SMatrix;

use super::number::{LANES, Lanes, Number};
use super::surface::{BallIdentity, ImperfectSurfaces};
use super::{Angle, Ball, BearingRotation, Geometry};

/// Displacement or force of the inner ring: x, y, z, θx, θy or F_x, F_y, F_z, M_x, M_y.
pub type Vector5 = [f64; 5];

/// Derivative of a force by a displacement, both of five components.
pub type Matrix5 = SMatrix<f64, 5, 5>;

/// A displacement or velocity of a ring for balls side by side.
pub(super) type LaneVector<S> = [Lanes<S>; 5];

/// The balls of a bearing at their azimuths.
///
/// ```text
/// A1_j = A sin α0 + s_j z + R_i T_j   A2_j = A cos α0 + x cos φ_j + y sin φ_j   T_j = θx sin φ_j − θy cos φ_j
/// ```
///
/// s_j is 1, but −1 in the second row of a bearing of two, whose contact lines lean the other way. `Ring::visit` hands these positions to a consumer, four balls at a time, with the drops of the surfaces
/// under them: forces, stiffness, damping, lift-off, loads and life are consumers.
///
/// The balls never move in the tables: cosines and sines of their azimuths are constants, turned with
/// the cage.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 7; Jones (1960).
#[derive(Debug, Clone)]
pub struct Ring {
    /// What the processor has.
    pub(super) level: Level,
    groups: Vec<Azimuths>,
    /// Azimuths of the balls with the cage where it starts, rad.
    pub(super) azimuths: Vec<f64>,
    free_axial: f64,
    free_radial: f64,
    pub(super) arm: f64,
    /// None where they are perfect.
    pub(super) surfaces: Option<Box<ImperfectSurfaces>>,
}

/// Azimuths of a few balls in the cage's frame, and which way each leans; a lane without a ball has zeros throughout.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
struct Azimuths {
    cos: [f64; LANES],
    sin: [f64; LANES],
    side: [f64; LANES],
}

/// Balls side by side in their positions.
#[derive(Clone, Copy)]
pub(super) struct Balls<S: Simd> {
    /// Number of the first of them.
    pub first: usize,
    pub cos: Lanes<S>,
    pub sin: Lanes<S>,
    /// How A1 follows z: 1, of the second row −1, and zero for a lane without ball.
    pub side: Lanes<S>,
    pub ball: Ball<Lanes<S>>,
}

impl<S: Simd> Balls<S> {
    /// Each ball by itself with its number, of `count` in all.
    pub fn single(&self, count: usize) -> impl Iterator<Item = (usize, Ball)> {
        let (first, balls) = (self.first, self.ball);
        (first..count.min(first + LANES)).map(move |number| {
            let lane = number - first;
            let ball = Ball {
                tilt: balls.tilt[lane],
                drop: balls.drop.map(|drop| drop[lane]),
                ..Ball::at(balls.axial[lane], balls.radial[lane])
            };
            (number, ball)
        })
    }
}

impl Ring {
    /// Places the balls of `geometry` evenly from azimuth `first_ball` in rad, a second row beside the first; their surfaces
    /// are perfect.
    pub fn new(geometry: &Geometry, first_ball: f64) -> Self {
        let balls = geometry.balls();
        let azimuths: Vec<f64> = (0..geometry.all_balls())
            .map(|ball| first_ball + std::f64::consts::TAU * (ball % balls) as f64 / balls as f64)
            .collect();
        let firsts = (0..).step_by(LANES);
        let groups = azimuths.chunks(LANES).zip(firsts);
        let groups = groups.map(|(azimuths, first)| Azimuths::new(azimuths, first, balls));
        Self {
            level: Level::new(),
            groups: groups.collect(),
            azimuths,
            free_axial: geometry.free_axial(),
            free_radial: geometry.free_radial(),
            arm: geometry.arm(),
            surfaces: None,
        }
    }

    /// Number of balls in all rows.
    pub(super) fn balls(&self) -> usize {
        self.azimuths.len()
    }

    /// 1 of a ball of the first row; of the second row, which leans the other way, −1.
    pub(super) fn side(&self, identity: BallIdentity) -> f64 {
        match identity {
            BallIdentity::Numbered(number) => self.groups[number / LANES].side[number % LANES],
            BallIdentity::Perfect { row } => side(row),
        }
    }

    /// Hands the positions of all balls to a consumer, some balls side by side after the other. A consumer whose speed
    /// counts must be inlined.
    #[inline(always)]
    pub(super) fn visit<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
        take: impl FnMut(&Balls<S>),
    ) {
        match &self.surfaces {
            None => self.visit_perfect(simd, displacement, rotation, take),
            Some(surfaces) => self.visit_imperfect(simd, surfaces, displacement, rotation, take),
        }
    }

    /// Visits the balls as if their surfaces were perfect: a drop of nothing is folded away.
    #[inline(always)]
    pub(super) fn visit_perfect<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
        take: impl FnMut(&Balls<S>),
    ) {
        self.visit_on(
            simd,
            displacement,
            rotation,
            #[inline(always)]
            |_, _| [Lanes::splat(simd, 0.0); 2],
            take,
        );
    }

    /// Visits the balls on the surfaces of the ring. Out of line, so that what perfect surfaces need stays small.
    #[inline(never)]
    pub(super) fn visit_imperfect<S: Simd>(
        &self,
        simd: S,
        surfaces: &ImperfectSurfaces,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
        take: impl FnMut(&Balls<S>),
    ) {
        simd.vectorize(
            #[inline(always)]
            || {
                self.visit_on(
                    simd,
                    displacement,
                    rotation,
                    #[inline(always)]
                    |first, [cos, sin]| {
                        let drops =
                            surfaces.drops(BallIdentity::Numbered(first), [&cos, &sin], rotation);
                        drops.map(|drops| Lanes::load_array(simd, drops))
                    },
                    take,
                );
            },
        );
    }

    /// Visits with drops, m, at the inner and the outer race of balls in directions (cos φ, sin φ), the first of which
    /// has a number: chosen outside the loop, so that perfect surfaces cost nothing.
    #[inline(always)]
    fn visit_on<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
        drops: impl Fn(usize, [Lanes<S>; 2]) -> [Lanes<S>; 2],
        mut take: impl FnMut(&Balls<S>),
    ) {
        for (group, azimuths) in self.groups.iter().enumerate() {
            let [cos, sin] = azimuths.turned(simd, rotation.cage);
            let start = [self.free_axial, self.free_radial];
            let side = Lanes::load_array_ref(simd, &azimuths.side);
            let [axial, radial, tilt] = self.components(start, displacement, [cos, sin, side]);
            take(&Balls {
                first: LANES * group,
                cos,
                sin,
                side,
                ball: Ball {
                    axial,
                    radial,
                    tilt,
                    drop: drops(LANES * group, [cos, sin]),
                },
            });
        }
    }

    /// Axial and radial component and tilt, where balls are, of a ring's displacement or velocity, from a start on.
    #[inline(always)]
    pub(super) fn components<T: Number>(
        &self,
        [axial, radial]: [f64; 2],
        [x, y, z, tilt_x, tilt_y]: &[T; 5],
        [cos, sin, side]: [T; 3],
    ) -> [T; 3] {
        let arm = self.arm;
        // A1 = start + s z + R_i (θx sin φ − θy cos φ), A2 = start + x cos φ + y sin φ, T = θx sin φ − θy cos φ
        [
            (*z * side + axial) + (*tilt_x * arm * sin - *tilt_y * arm * cos),
            (*x * cos + *y * sin) + radial,
            *tilt_x * sin - *tilt_y * cos,
        ]
    }

    /// A single ball at an azimuth in rad.
    pub(super) fn ball_at(
        &self,
        displacement: &Vector5,
        azimuth: f64,
        identity: BallIdentity,
        rotation: &BearingRotation,
    ) -> Ball {
        let (sin, cos) = azimuth.sin_cos();
        let start = [self.free_axial, self.free_radial];
        let directions = [cos, sin, self.side(identity)];
        let [axial, radial, tilt] = self.components(start, displacement, directions);
        let drop = self.surfaces.as_ref().map_or([0.0; 2], |surfaces| {
            let alone = [cos, sin].map(|part| [part, 0.0, 0.0, 0.0]);
            let drops = surfaces.drops(identity, alone.each_ref(), rotation);
            drops.map(|[drop, ..]| drop)
        });
        Ball {
            tilt,
            drop,
            ..Ball::at(axial, radial)
        }
    }

    /// Middles of A1 and A2 of all balls at any angle of the cage, each with the square of their amplitude, in m and
    /// m².
    #[inline(always)]
    pub(super) fn amplitudes(&self, displacement: &Vector5) -> [[f64; 2]; 2] {
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        let tilt = self.arm * self.arm * (tilt_x * tilt_x + tilt_y * tilt_y);
        [
            [self.free_axial + z, tilt],
            [self.free_radial, x * x + y * y],
        ]
    }
}

impl Azimuths {
    /// Cosines and sines of at most `LANES` azimuths in rad, from the ball with a number on; of so many balls a row.
    fn new(azimuths: &[f64], first: usize, row: usize) -> Self {
        let [mut cos, mut sin, mut side] = [[0.0; LANES]; 3];
        for (lane, azimuth) in azimuths.iter().enumerate() {
            (sin[lane], cos[lane]) = azimuth.sin_cos();
            side[lane] = self::side((first + lane) / row);
        }
        Self { cos, sin, side }
    }

    /// Cosines and sines with the cage turned: no displacement enters, so that this can be worked out before one
    /// is known.
    #[inline(always)]
    fn turned<S: Simd>(&self, simd: S, cage: Angle) -> [Lanes<S>; 2] {
        let cos = Lanes::load_array_ref(simd, &self.cos);
        let sin = Lanes::load_array_ref(simd, &self.sin);
        // cos(φ + ψ_c) and sin(φ + ψ_c)
        [
            cos * cage.cos - sin * cage.sin,
            sin * cage.cos + cos * cage.sin,
        ]
    }
}

/// 1 of the first row, 0; −1 of the second.
fn side(row: usize) -> f64 {
    if row == 0 { 1.0 } else { -1.0 }
}

/// A vector for balls side by side. Number by number: what was just written in parts is then not
/// read as a whole.
#[inline(always)]
pub(super) fn side_by_side<S: Simd>(simd: S, [x, y, z, tilt_x, tilt_y]: &Vector5) -> LaneVector<S> {
    [
        Lanes::splat(simd, *x),
        Lanes::splat(simd, *y),
        Lanes::splat(simd, *z),
        Lanes::splat(simd, *tilt_x),
        Lanes::splat(simd, *tilt_y),
    ]
}

/// A vector in components of its own. Keeps what a function out of line is given, or returns, from sharing its memory
/// with what is worked out in place: reading that as a whole right after writing it in parts waits for the
/// parts.
#[inline(always)]
pub(crate) fn in_registers([x, y, z, tilt_x, tilt_y]: Vector5) -> Vector5 {
    [x, y, z, tilt_x, tilt_y]
}

/// A vector turned by a right angle about Z: the generator of rotations.
pub(crate) fn quarter_turn(vector: &Vector5) -> Vector5 {
    let [x, y, _, tilt_x, tilt_y] = *vector;
    [-y, x, 0.0, -tilt_y, tilt_x]
}
