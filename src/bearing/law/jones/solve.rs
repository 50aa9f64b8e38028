//! Position of a ball between its races: damped Newton from an explicit start.

use super::balance::{Balance, Ball, Plane, Positions, apply, inverse};
use crate::bearing::dual::Dual;
use crate::bearing::law::{ContactSpring, HertzSpring};
use crate::bearing::number::Number;
use crate::physics::series_stiffness;

/// Trial positions after which a solve ends with what it has.
pub(super) const MOST_TRIALS: usize = 200;

/// Step, over the approaches, of which the forces are linear to round-off.
const LINEAR: f64 = 1e-9;

/// A ball at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    pub(super) positions: Positions,
    pub(super) balance: Balance<f64>,
    /// Number of trial positions that it took.
    pub(super) trials: usize,
}

impl Ball {
    /// Balance at the ball's position of rest, from a start of its centre.
    ///
    /// Newton's method on the sum of forces r. A step is halved until the next one, with the same
    /// slopes, is shorter: the natural monotonicity test, which measures the error in metres and
    /// so is not misled by contacts that are stiff along their normal and soft across it.
    ///
    /// Source: P. Deuflhard, *Newton Methods for Nonlinear Problems* (2004), sec. 3.3.
    #[inline(always)]
    pub(super) fn solve(
        &self,
        start: Positions,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Rest {
        // r(X) and ∂r/∂X at the start
        let (mut positions, mut trials) = (start, 1);
        let mut balance = self.linearised(&start, springs, force_scale);
        let ended = |positions, balance: Balance<Dual<f64, 2>>, step, trials| Rest {
            positions,
            balance: balance.moved(step),
            trials,
        };
        while trials < MOST_TRIALS
            && let Some(inverse) = balance.slopes_inverse()
        {
            // Newton's step ΔX = −(∂r/∂X)⁻¹ r
            let centre = positions.centre;
            let mut step = apply(&inverse, balance.residual.map(|part| -part.value));
            let newton = square(step);
            if newton <= balance.linear_step() {
                // the next trial would say no more than the slopes
                positions.centre = [centre[0] + step[0], centre[1] + step[1]];
                return ended(positions, balance, step, trials);
            }
            // not beyond where the slopes hold
            let longest = self.longest_step(&balance);
            if newton > longest {
                let part = (longest / newton).sqrt();
                step = step.map(|step| part * step);
            }
            loop {
                // the step is taken where the next one, (∂r/∂X)⁻¹ r(X + ΔX), is shorter
                let trial = Positions {
                    centre: [centre[0] + step[0], centre[1] + step[1]],
                    ..positions
                };
                let tried = self.linearised(&trial, springs, force_scale);
                trials += 1;
                let next = square(apply(&inverse, tried.residual.map(|part| part.value)));
                if next < newton {
                    (positions, balance) = (trial, tried);
                    break;
                }
                let is_round_off = square(step) <= f64::EPSILON * f64::EPSILON * square(centre);
                if is_round_off || trials >= MOST_TRIALS {
                    return ended(positions, balance, [0.0; 2], trials);
                }
                // else half of it is tried
                step = step.map(|step| 0.5 * step);
            }
        }
        ended(positions, balance, [0.0; 2], trials)
    }

    /// Balance in some positions with slopes by the ball's centre.
    #[inline(always)]
    fn linearised(
        &self,
        positions: &Positions,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Balance<Dual<f64, 2>> {
        let Positions {
            centre: [x, y],
            groove,
            drop,
        } = *positions;
        let positions = Positions {
            centre: [Dual::variable(x, 0), Dual::variable(y, 1)],
            groove: groove.map(Dual::fixed),
            drop: drop.map(Dual::fixed),
        };
        self.balance(
            &positions,
            #[inline(always)]
            |race, approach| springs[race].load_and_stiffness(approach),
            force_scale,
        )
    }

    /// Square of the step in m² whose sagitta is as large as the present approaches: a longer one
    /// leaves the slopes it was computed from.
    #[inline(always)]
    fn longest_step(&self, balance: &Balance<Dual<f64, 2>>) -> f64 {
        let [inner, outer] = balance.approaches();
        4.0 * self.free[0].min(self.free[1]) * (inner + outer)
    }
}

impl Balance<Dual<f64, 2>> {
    /// The balance with the ball's centre moved by a short step in m.
    #[inline(always)]
    fn moved(&self, [x, y]: Plane<f64>) -> Balance<f64> {
        self.map(|part| part.value + (part.slopes[0] * x + part.slopes[1] * y))
    }

    /// Sizes of the approaches at both races, m.
    #[inline(always)]
    fn approaches(&self) -> [f64; 2] {
        let contacts = self.contacts.each_ref();
        contacts.map(|contact| contact.approach.value.abs())
    }

    /// Square of the longest step in m² over which everything is linear to round-off.
    #[inline(always)]
    fn linear_step(&self) -> f64 {
        let [inner, outer] = self.approaches();
        (LINEAR * inner.min(outer)).powi(2)
    }

    /// `(∂r/∂X)⁻¹`; nothing where the residual is round-off already, or there is none.
    #[inline(always)]
    fn slopes_inverse(&self) -> Option<[Plane<f64>; 2]> {
        let round_off = self.round_off();
        if square(self.residual.map(|part| part.value)) <= round_off * round_off {
            return None;
        }
        inverse(&self.residual.map(|part| part.slopes))
    }

    /// Residual in N that rounding of lengths and loads alone can leave.
    #[inline(always)]
    fn round_off(&self) -> f64 {
        let [inner, outer] = &self.contacts;
        let stiffness = inner.stiffness + outer.stiffness;
        let length = inner.length.value + outer.length.value;
        f64::EPSILON * (stiffness * length + inner.load.value + outer.load.value)
    }
}

/// `|x|²`
#[inline(always)]
pub(super) fn square([x, y]: Plane<f64>) -> f64 {
    x * x + y * y
}

/// Stiffness constants of dry contacts as the first guess needs them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StartConstants {
    /// K_o, N/m^1.5.
    outer: f64,
    /// K_n of both races in series, N/m^1.5.
    series: f64,
    /// Share of the outer race in the approach under equal loads.
    outer_share: f64,
}

impl StartConstants {
    /// From the elastic contacts of both races, inner first.
    pub(super) fn new(springs: [HertzSpring; 2]) -> Self {
        let [inner, outer] = springs.map(|spring| spring.stiffness);
        // shares of the approach are as the compliances K^(−2/3)
        let ratio = (inner / outer).cbrt().powi(2);
        Self {
            outer,
            series: series_stiffness(inner, outer),
            outer_share: ratio / (1.0 + ratio),
        }
    }
}

impl Ball {
    /// First guess of the ball's centre with the inner groove centre at `groove`.
    ///
    /// Thrown outwards, the ball rests on the outer race alone. Where the inner race is in its
    /// way, it is wedged between both: the overlap S of the races grows as the ball is pushed
    /// off the line of the groove centres, `S = δ + c Δ²` for an angle Δ between the contacts,
    /// until `K_n S^(3/2) Δ` holds the inertia forces across that line: `S³ (S − δ) = c φ²`.
    #[inline(always)]
    pub(super) fn start(
        &self,
        constants: &StartConstants,
        groove: Plane<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Plane<f64> {
        let free_inner = self.free[0] - springs[0].lift();
        let free_outer = self.free[1] - springs[1].lift();
        let distance = square(groove).sqrt().max(f64::MIN_POSITIVE);
        let [sin, cos] = groove.map(|part| part / distance);
        // (ω_m/ω)² at equal contact angles
        let orbit = 0.5 * (1.0 - self.inertia.diameter_ratio * cos);
        let centrifugal = force_scale * orbit * orbit;
        let overlap = distance - free_inner - free_outer;
        // K_o δ^(3/2) > F_c: no outward yielding of the ball can undo the overlap
        let floor = overlap.max(0.0);
        if constants.outer * floor * floor.sqrt() <= centrifugal {
            let thrown = self.free[1] + springs[1].approach(centrifugal);
            if square([groove[0], groove[1] - thrown]) <= free_inner * free_inner {
                return [0.0, thrown];
            }
        }
        let lever = 0.5 * free_inner * free_outer / distance;
        let across = 1.4 * centrifugal * sin / constants.series;
        let wedged = wedge(overlap, lever * across * across);
        // the outer race bears F_c cos α more than the inner one
        let (share_outer, share_inner) = (constants.outer_share, 1.0 - constants.outer_share);
        let stiffness = 1.5 * constants.series * wedged.sqrt() / (share_inner * share_outer);
        let shift = (centrifugal * cos / stiffness)
            .min(0.5 * share_inner * wedged)
            .max(0.0);
        let length_outer = free_outer + share_outer * wedged + shift;
        let length_inner = free_inner + share_inner * wedged - shift;
        // triangle over the line of groove centres, its apex on the outward side
        let along = (distance * distance + length_outer * length_outer
            - length_inner * length_inner)
            / (2.0 * distance);
        let height = (length_outer * length_outer - along * along)
            .max(0.0)
            .sqrt();
        let outward = height * sin.signum();
        [along * sin - outward * cos, along * cos + outward * sin]
    }
}

/// Rounds after which the position of a thrown ball is right to round-off, whatever its contact angle.
const ROUNDS: usize = 4;

impl Ball {
    /// How far the inner race, its groove centre at `groove`, reaches into the ball that rests on the dry outer race
    /// alone, m; negative where they are apart. The surfaces are lower by their drops.
    ///
    /// The ball presses itself a distance s into the outer race, `K_o s^(3/2) = F_c(s)`: by Newton's method, with F_c,
    /// which hardly changes with s, as it was a round before.
    #[inline(always)]
    pub(super) fn overlap_when_thrown<T: Number>(
        &self,
        [axial, radial]: Plane<T>,
        [drop_inner, drop_outer]: [T; 2],
        outer: &HertzSpring,
        force_scale: f64,
    ) -> T {
        let (free_inner, free_outer) = (drop_inner + self.free[0], drop_outer + self.free[1]);
        if force_scale == 0.0 {
            // nothing throws it: it gives way into the line of the groove centres
            return (axial * axial + radial * radial).sqrt() - free_inner - free_outer;
        }
        let orbit = 0.5 * (1.0 - self.inertia.diameter_ratio);
        // s under F_c of a ball that orbits at the nominal cage speed
        let mut approach = axial.constant(outer.approach(force_scale * orbit * orbit));
        for _ in 0..ROUNDS {
            // cos α_i of the ball so far inside the outer race
            let height = radial - (free_outer + approach);
            let length = (axial * axial + height * height).sqrt();
            let cosine = height / (length + f64::MIN_POSITIVE);
            // s ← s/3 + 2/3 F_c/(K_o √s)
            let centrifugal = self.inertia.thrown(cosine) * force_scale;
            let pressed = centrifugal / (approach.sqrt() * outer.stiffness);
            approach = approach * (1.0 / 3.0) + pressed * (2.0 / 3.0);
        }
        // distance to the inner groove centre less that at first touch
        let height = radial - (free_outer + approach);
        (axial * axial + height * height).sqrt() - free_inner
    }
}

/// Overlap S ≥ max(δ, 0) of `S³ (S − δ) = C`: two steps of Newton's method from above.
#[inline(always)]
fn wedge(overlap: f64, constant: f64) -> f64 {
    let floor = overlap.max(0.0);
    // S − δ is less than C/δ³ and than C^(1/4)
    let above = constant
        .sqrt()
        .sqrt()
        .min(constant / (floor * floor * floor));
    let mut s = floor + above;
    for _ in 0..2 {
        let square = s * s;
        let slope = square * (4.0 * s - 3.0 * overlap);
        s -= (square * s * (s - overlap) - constant) / slope.max(f64::MIN_POSITIVE);
    }
    s
}
