//! A ring whose ball law was compiled into a table.

use fearless_simd::Simd;

use super::any_ring::AnyRing;
use super::ring_lanes::{LaneSums, LaneVector};
use super::ring_lift_off::LiftOffs;
use super::ring_table::TabledBalls;
use super::{
    BallLaw, BallRegion, CageAngle, ContactLaw, HertzFilmLaw, JonesFilmLaw, JonesLaw, Matrix5,
    MountedBearing, Ring, TableError, TableLaw, TableReport, Vector5,
};
use crate::physics::RaceControl;

/// A ring of balls whose law is costly, as tables.
#[derive(Debug, Clone)]
pub(super) enum TableRing {
    HertzFilm(Ring<TableLaw<HertzFilmLaw, false>>),
    Jones(Ring<TableLaw<JonesLaw, false>>),
    JonesCouple(Ring<TableLaw<JonesLaw, true>>),
    JonesFilm(Ring<TableLaw<JonesFilmLaw, false>>),
    JonesFilmCouple(Ring<TableLaw<JonesFilmLaw, true>>),
}

/// Balls with a table, with a couple or without: all that the sum of their forces needs to know of the law.
enum AnyTabled<'a> {
    Plain(TabledBalls<'a, false>),
    Couple(TabledBalls<'a, true>),
}

/// Evaluates an expression for the ring inside, whatever its law.
macro_rules! with_table {
    ($any:expr, $ring:ident => $value:expr) => {
        match $any {
            TableRing::HertzFilm($ring) => $value,
            TableRing::Jones($ring) => $value,
            TableRing::JonesCouple($ring) => $value,
            TableRing::JonesFilm($ring) => $value,
            TableRing::JonesFilmCouple($ring) => $value,
        }
    };
}

/// What a table is to be good for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TableWish {
    /// Where the balls may come.
    pub region: BallRegion,
    /// Shaft speed, rad/s.
    pub speed: f64,
    /// Load that the tolerance refers to, N.
    pub load: f64,
    /// Largest error of a force over that load.
    pub tolerance: f64,
}

impl TableRing {
    /// The table of a ring; none where its law costs no more than a table.
    pub fn compile(
        ring: &AnyRing,
        definition: &MountedBearing,
        wish: &TableWish,
    ) -> Option<Result<(Self, TableReport), TableError>> {
        // under outer race control the inner race holds no moment
        let couple = !matches!(definition.law, ContactLaw::Jones(RaceControl::Outer));
        match (ring, couple) {
            (AnyRing::Hertz(_), _) => None,
            (AnyRing::HertzFilm(ring), _) => Some(compiled(ring, wish, Self::HertzFilm)),
            (AnyRing::Jones(ring), false) => Some(compiled(ring, wish, Self::Jones)),
            (AnyRing::Jones(ring), true) => Some(compiled(ring, wish, Self::JonesCouple)),
            (AnyRing::JonesFilm(ring), false) => Some(compiled(ring, wish, Self::JonesFilm)),
            (AnyRing::JonesFilm(ring), true) => Some(compiled(ring, wish, Self::JonesFilmCouple)),
        }
    }

    /// The balls and their table alone.
    #[inline(always)]
    fn tabled(&self) -> AnyTabled<'_> {
        match self {
            Self::HertzFilm(ring) => AnyTabled::Plain(ring.tabled()),
            Self::Jones(ring) => AnyTabled::Plain(ring.tabled()),
            Self::JonesFilm(ring) => AnyTabled::Plain(ring.tabled()),
            Self::JonesCouple(ring) => AnyTabled::Couple(ring.tabled()),
            Self::JonesFilmCouple(ring) => AnyTabled::Couple(ring.tabled()),
        }
    }

    /// Adds up the forces of the balls for the processor's level `S`; says whether all were inside the table,
    /// and leaves `sums` alone otherwise. What goes in and out is read as it was written, in whole
    /// registers.
    #[inline(never)]
    pub fn add_forces<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
        speed: f64,
        sums: &mut LaneSums<S>,
    ) -> bool {
        simd.vectorize(
            #[inline(always)]
            || match self.tabled() {
                AnyTabled::Plain(balls) => balls.add(simd, displacement, cage, speed, sums),
                AnyTabled::Couple(balls) => balls.add(simd, displacement, cage, speed, sums),
            },
        )
    }

    /// Radius of the inner groove centres, m: kept by the rings, while a geometry would ask for a cosine.
    #[inline(always)]
    pub fn arm(&self) -> f64 {
        with_table!(self, ring => ring.arm)
    }

    /// The force with a ball or more outside the table.
    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        with_table!(self, ring => ring.force(displacement, cage, speed))
    }

    pub fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        with_table!(self, ring => ring.force_and_stiffness(displacement, cage, speed))
    }

    /// The balls about their lift-off.
    pub fn lift_offs(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> LiftOffs {
        with_table!(self, ring => ring.lift_offs(displacement, cage, speed))
    }

    /// How far a ball is pressed past its lift-off, m.
    pub fn past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> f64 {
        with_table!(self, ring => ring.past_lift_off(ball, displacement, cage, speed))
    }

    /// Whether every ball is inside the table.
    pub fn covers(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> bool {
        with_table!(self, ring => ring
            .placed(*displacement, cage)
            .all(|ball| ring.law().covers(ball.axial, ball.radial, speed)))
    }
}

fn compiled<L: BallLaw + Clone, const COUPLE: bool>(
    ring: &Ring<L>,
    wish: &TableWish,
    name: fn(Ring<TableLaw<L, COUPLE>>) -> TableRing,
) -> Result<(TableRing, TableReport), TableError> {
    let law = ring.law().clone();
    let (table, report) =
        TableLaw::compile(law, wish.region, wish.speed, wish.load, wish.tolerance)?;
    Ok((name(ring.under(table)), report))
}
