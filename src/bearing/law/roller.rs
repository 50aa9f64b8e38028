//! Law of one roller between both races, lamina by lamina.

use std::sync::Arc;

use fearless_simd::{Simd, SimdBase};

use super::laminae::{Four, NEVER, Sums};
use super::line_contacts::LineContacts;
use super::ninth_root::ninth_root;
use super::roller_damping::LaminaDamping;
use super::table::RollerCells;
use super::{Ball, BallForce, BallLaw, BallResponse, ContactSpring, ForceLaw, Lamina};
use crate::bearing::Geometry;
use crate::bearing::number::{Function, LANES, Lanes, Number, Plain};
use crate::numerics::registers::in_wide_registers;
use crate::numerics::root::bisection;
use crate::physics::LINE_EXPONENT;

/// A roller cut into laminae that bear each by itself, both races in series, ball inertia neglected.
///
/// ```text
/// δ_k = A1 sin α + A2 cos α − T s_k − 2 P_k        q_k = c_s max(δ_k, 0)^(10/9)        c_s = C/n_s
/// F_a = sin α Σ q_k        F_r = cos α Σ q_k        couple = −Σ s_k q_k
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | A1, A2, T | where the inner ring is in the plane of the roller | m, m, rad |
/// | α | contact angle | rad |
/// | s_k, P_k | middle and drop of a lamina, [`crate::bearing::Rollers`] | m |
/// | q_k | its load | N |
/// | C | constant of the whole roller, [`crate::physics::line_stiffness`] | N/m^(10/9) |
///
/// The forces are the work conjugates of A1, A2 and T, so that they have a potential. Holds for rigid rings at speeds
/// where centrifugal force is small against the roller load. The flange of a tapered bearing, whose force is small, carries
/// nothing here. Without `TILTS` a roller follows the tilt of its ring, as in the sphere of a spherical bearing.
///
/// Source: ISO/TS 16281:2008, 4.2; H. T. Nguyen-Schäfer, *Computational Tapered and Cylinder Roller Bearings* (2019).
#[derive(Debug, Clone)]
pub struct RollerLaw<const TILTS: bool = true> {
    sin: f64,
    cos: f64,
    /// c_s.
    stiffness: f64,
    /// Width of a lamina, m.
    width: f64,
    laminae: usize,
    /// Number of laminae with the same drop, which part together where the roller is not tilted.
    together: f64,
    /// The laminae, and their sums as motions ask for them.
    cells: Arc<RollerCells>,
}

/// Unit of the cells over the diameter of the rollers.
const CELL_UNIT: f64 = 1.0 / 8192.0;

impl<const TILTS: bool> RollerLaw<TILTS> {
    /// The law of a roller of a bearing with its contacts.
    pub(super) fn new(geometry: &Geometry, contacts: &LineContacts) -> Self {
        let rollers = &contacts.rollers;
        let (sin, cos) = geometry.contact_angle().sin_cos();
        let slices = rollers.slices(geometry.ball_diameter());
        let laminae: Vec<_> = slices
            .map(|slice| [slice.position, 2.0 * slice.drop])
            .collect();
        let unit = CELL_UNIT * geometry.ball_diameter();
        let count = rollers.laminae as f64;
        let alike = |drop: f64| laminae.iter().filter(|lamina| lamina[1] == drop).count();
        let together = laminae.iter().map(|lamina| alike(lamina[1]));
        Self {
            sin,
            cos,
            stiffness: contacts.stiffness / count,
            width: rollers.length / count,
            laminae: rollers.laminae,
            together: together.max().unwrap_or(0) as f64,
            cells: Arc::new(RollerCells::new(
                &laminae,
                0.5 * rollers.length,
                unit,
                TILTS,
            )),
        }
    }

    /// A1 sin α + A2 cos α less the drops of both races.
    #[inline(always)]
    fn middle<T: Number>(&self, ball: &Ball<T>) -> T {
        let [inner, outer] = ball.drop;
        (ball.axial * self.sin + ball.radial * self.cos) - (inner + outer)
    }

    /// The tilt that its laminae see.
    #[inline(always)]
    fn tilt<T: Number>(ball: &Ball<T>) -> T {
        if TILTS {
            ball.tilt
        } else {
            ball.tilt.constant(0.0)
        }
    }

    /// Load of a roller, N, and its force.
    #[inline(always)]
    fn load_and_force<T: Number>(&self, ball: &Ball<T>) -> (T, BallForce<T>) {
        let [load, couple] = T::apply(self, [self.middle(ball), Self::tilt(ball)]);
        let force = BallForce {
            axial: load * self.sin,
            radial: load * self.cos,
            couple,
        };
        (load, force)
    }

    /// The laminae one by one: position and 2 P, m.
    fn slices(&self) -> impl Iterator<Item = [f64; 2]> {
        let four = |four: &Four| {
            let pairs = four.position.into_iter().zip(four.drop);
            pairs
                .map(|(position, drop)| [position, drop])
                .collect::<Vec<_>>()
        };
        self.cells.laminae.iter().flat_map(four).take(self.laminae)
    }

    /// Whether no lamina bears, decided by the end that is pressed most.
    #[inline(always)]
    fn is_apart(&self, [middle, tilt]: [f64; 2]) -> bool {
        middle + tilt.abs() * self.cells.half_length <= self.cells.least_drop
    }

    /// Sums with the middle of the roller approached by some m under a tilt in rad; those of the stiffness only where
    /// `SLOPES`.
    #[inline(always)]
    fn sums<S: Simd, const SLOPES: bool>(&self, simd: S, place: [f64; 2]) -> Sums<f64> {
        if self.is_apart(place) {
            return Sums {
                load: [0.0; 2],
                stiffness: [0.0; 3],
            };
        }
        let Sums { load, stiffness } =
            Sums::over::<SLOPES>(simd, &self.cells.laminae, place).total();
        let scale = self.stiffness;
        Sums {
            load: load.map(|sum| scale * sum),
            stiffness: stiffness.map(|sum| LINE_EXPONENT * scale * sum),
        }
    }
}

/// Load and couple of a roller by the approach of its middle and its tilt.
impl<const TILTS: bool> Function<2, 2> for RollerLaw<TILTS> {
    fn with_slopes(&self, place: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
        let Sums {
            load,
            stiffness: [k0, k1, k2],
        } = in_wide_registers!(self.cells.level, simd => self.sums::<_, true>(simd, place));
        (load, [[k0, -k1], [-k1, k2]])
    }

    fn values(&self, place: [f64; 2]) -> [f64; 2] {
        in_wide_registers!(self.cells.level, simd => self.sums::<_, false>(simd, place).load)
    }

    #[inline(always)]
    fn side_by_side<S: Simd>(&self, place: [Lanes<S>; 2]) -> [Lanes<S>; 2] {
        let [load, couple] = self.cells.loads(place);
        [load * self.stiffness, couple * self.stiffness]
    }
}

impl<const TILTS: bool> ForceLaw for RollerLaw<TILTS> {
    const HAS_COUPLE: bool = TILTS;
    const FOLLOWS_TILT: bool = TILTS;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallForce<T> {
        self.load_and_force(ball).1
    }

    /// The laminae; of a roller that does not tilt those of one half, with which the others part.
    fn places(&self) -> usize {
        match TILTS {
            true => self.laminae,
            false => self.laminae.div_ceil(2),
        }
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, place: usize, _speed: f64) -> T {
        let four = &self.cells.laminae[place / LANES];
        let (position, drop) = (four.position[place % LANES], four.drop[place % LANES]);
        (self.middle(ball) - Self::tilt(ball) * position) + (-drop)
    }
}

impl<const TILTS: bool> RollerLaw<TILTS> {
    /// Approach of the lamina that is pressed most, m.
    #[inline(always)]
    fn largest_approach<T: Number>(&self, ball: &Ball<T>) -> T {
        let (middle, tilt) = (self.middle(ball), Self::tilt(ball));
        let mut largest = middle - NEVER;
        for four in self.cells.laminae.iter() {
            for (position, drop) in four.position.iter().zip(&four.drop) {
                // max(a, b) = a + max(b − a, 0)
                let approach = (middle - tilt * *position) - *drop;
                largest = largest + (approach - largest).positive();
            }
        }
        largest
    }
}

impl<const TILTS: bool> BallLaw for RollerLaw<TILTS> {
    type Spring = Self;

    #[inline(always)]
    fn response<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallResponse<T> {
        let (load, force) = self.load_and_force(ball);
        BallResponse {
            force,
            load: [load; 2],
            approach: self.largest_approach(ball),
        }
    }

    fn spring(&self, _speed: f64) -> Self {
        self.clone()
    }

    fn load_past_lift_off(&self, distance: f64, _speed: f64) -> f64 {
        self.together * self.stiffness * distance.max(0.0).powf(LINE_EXPONENT)
    }

    fn exponent(&self) -> f64 {
        LINE_EXPONENT
    }

    /// Half of that of the lamina which is pressed most.
    #[inline(always)]
    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2] {
        [response.approach.positive() * 0.5; 2]
    }

    #[inline(always)]
    fn damped<T: Plain, const D: usize>(
        &self,
        ball: &Ball<T>,
        rate: &Ball<T>,
        coefficients: [f64; 2],
        speed: f64,
    ) -> (BallForce<T>, Ball<T>) {
        let damping = LaminaDamping {
            level: self.cells.level,
            laminae: &self.cells.laminae,
            stiffness: self.stiffness,
            coefficients,
        };
        let place = [self.middle(ball), Self::tilt(ball)];
        let rate = [self.middle(rate), Self::tilt(rate)];
        let [load, couple] = T::apply(&damping, [place[0], place[1], rate[0], rate[1]]);
        let resisting = Ball {
            axial: load * self.sin,
            radial: load * self.cos,
            tilt: couple,
            drop: [load * -1.0; 2],
        };
        (self.force(ball, speed), resisting)
    }

    /// That of the races, however the roller is pressed.
    fn contact_angle(&self, _ball: &Ball) -> f64 {
        self.sin.atan2(self.cos)
    }

    /// `Σ q_k δ_k/(1 + n)`, half of it at each race.
    fn elastic_energies(&self, ball: &Ball, _response: &BallResponse) -> [f64; 2] {
        let energy = |lamina: Lamina| lamina.load * lamina.approach / (1.0 + LINE_EXPONENT);
        let energy: f64 = self.laminae(ball).into_iter().map(energy).sum();
        [0.5 * energy; 2]
    }

    fn slice_loads(&self, ball: &Ball, loads: &mut [f64]) {
        let (middle, tilt) = (self.middle(ball), Self::tilt(ball));
        if self.is_apart([middle, tilt]) {
            loads.fill(0.0);
            return;
        }
        in_wide_registers!(self.cells.level, simd => {
            for (four, loads) in self.cells.laminae.iter().zip(loads.chunks_mut(LANES)) {
                let position = Lanes::load_array_ref(simd, &four.position);
                let drop = Lanes::load_array_ref(simd, &four.drop);
                let approach = (Lanes::splat(simd, middle) - position * tilt) - drop;
                let pressed = approach.max(Lanes::splat(simd, 0.0));
                let load = pressed * ninth_root(pressed) * self.stiffness;
                match loads.first_chunk_mut::<LANES>() {
                    Some(whole) => *whole = *load,
                    None => loads.copy_from_slice(&(*load)[..loads.len()]),
                }
            }
        });
    }

    fn laminae(&self, ball: &Ball) -> Vec<Lamina> {
        let (middle, tilt) = (self.middle(ball), Self::tilt(ball));
        let mut loads = vec![0.0; self.laminae];
        self.slice_loads(ball, &mut loads);
        let lamina = |([position, drop], load): ([f64; 2], f64)| Lamina {
            position,
            width: self.width,
            approach: middle - tilt * position - drop,
            load,
        };
        self.slices().zip(loads).map(lamina).collect()
    }
}

/// A roller that is not tilted, by the approach of the lamina that is pressed most: that with the least drop.
impl<const TILTS: bool> ContactSpring for RollerLaw<TILTS> {
    const IS_SMOOTH: bool = false;

    #[inline(always)]
    fn load<T: Number>(&self, approach: T) -> T {
        let [load, _] = T::apply(
            self,
            [approach + self.cells.least_drop, approach.constant(0.0)],
        );
        load
    }

    fn load_and_stiffness(&self, approach: f64) -> (f64, f64) {
        let (load, slopes) = self.with_slopes([approach + self.cells.least_drop, 0.0]);
        (load[0], slopes[0][0])
    }

    fn approach(&self, load: f64) -> f64 {
        if load <= 0.0 {
            return 0.0;
        }
        // a single lamina under the load is pressed in more than all of them
        let most = (load / self.stiffness).powf(1.0 / LINE_EXPONENT);
        let bears_more = |approach| self.load_and_stiffness(approach).0 > load;
        bisection(bears_more, [0.0, most], f64::EPSILON * most)
    }

    fn lift(&self) -> f64 {
        0.0
    }
}
