//! The equations of a ball hold at every state that a law returns, computed anew from the state.

use crate::bearing::{Ball, BallLaw, BallState, ForceLaw, JonesFilmLaw, JonesLaw, RaceFilms};
use crate::physics::{BallMotion, RaceControl, ball_mass, centrifugal_force};

use super::OIL;
use super::random::{Case, Random};

const CONTROLS: [RaceControl; 3] = [RaceControl::Outer, RaceControl::Inner, RaceControl::Even];
const STATES: usize = 20_000;

/// 20 000 random states without film: balance to 1e-12, at most 40 trial positions.
#[test]
fn forces_on_a_dry_ball_balance_everywhere() {
    let mut random = Random::new(1);
    for number in 0..STATES {
        let case = random.case();
        let control = CONTROLS[number % 3];
        let law = JonesLaw::new(&case.bearing, control).unwrap();
        let ball = Ball::at(case.axial, case.radial);
        let state = law.state(&ball, case.speed).expect("a law with inertia");
        let couple = law.force(&ball, case.speed).couple;
        assert!(state.trials <= 40, "{} trials, {control:?}", state.trials);
        Check::new(&case, &state, couple, [0.0; 2]).run(control);
    }
}

/// 20 000 random states with film: balance to 1e-12, at most 60 trial positions.
#[test]
fn forces_on_a_lubricated_ball_balance_everywhere() {
    let mut random = Random::new(2);
    for number in 0..STATES {
        let case = random.case();
        let control = CONTROLS[number % 3];
        let law = JonesFilmLaw::with_film(&case.bearing, control, OIL, case.speed).unwrap();
        let ball = Ball::at(case.axial, case.radial);
        let state = law.state(&ball, case.speed).expect("a law with inertia");
        let couple = law.force(&ball, case.speed).couple;
        assert!(state.trials <= 60, "{} trials, {control:?}", state.trials);
        let loads = [state.contact.load_inner, state.contact.load_outer];
        let contacts = case.bearing.point_contacts().unwrap();
        let films = RaceFilms::new(&case.bearing, &contacts, &OIL).unwrap();
        let films = films.thickness(loads, case.speed);
        Check::new(&case, &state, couple, films.map(|film| film.central)).run(control);
    }
}

/// A state and what it takes to judge it.
struct Check<'a> {
    case: &'a Case,
    state: &'a BallState,
    /// Friction forces at the inner and the outer race, N.
    friction: [f64; 2],
    /// Film thickness at the inner and the outer race, m.
    films: [f64; 2],
    /// Sum of forces that rounding of the groove distances alone can leave, N.
    round_off: f64,
    /// Size of the loads, N.
    scale: f64,
}

impl<'a> Check<'a> {
    fn new(case: &'a Case, state: &'a BallState, couple: f64, films: [f64; 2]) -> Self {
        let geometry = &case.bearing.geometry;
        let diameter = geometry.ball_diameter();
        let contact = &state.contact;
        // couple = −f_i D T_i, T_i + T_o = 2 M_g/D
        let inner = -couple / (geometry.groove_factors()[0] * diameter);
        let outer = 2.0 * state.gyroscopic_moment / diameter - inner;
        // dQ/ds = 3/2 K^(2/3) Q^(1/3)
        let stiffness = 1.5
            * (case
                .bearing
                .inner_contact()
                .unwrap()
                .stiffness()
                .cbrt()
                .powi(2)
                * contact.load_inner.cbrt()
                + case
                    .bearing
                    .outer_contact()
                    .unwrap()
                    .stiffness()
                    .cbrt()
                    .powi(2)
                    * contact.load_outer.cbrt());
        Self {
            case,
            state,
            friction: [inner, outer],
            films,
            round_off: 4.0 * f64::EPSILON * stiffness * case.axial.hypot(case.radial),
            scale: contact.load_inner + contact.load_outer,
        }
    }

    fn run(&self, control: RaceControl) {
        self.forces_balance();
        self.distances_close();
        self.inertia_is_by_the_book(control);
    }

    fn forces_balance(&self) {
        let contact = &self.state.contact;
        let (sin_i, cos_i) = contact.angle_inner.sin_cos();
        let (sin_o, cos_o) = contact.angle_outer.sin_cos();
        let (q_i, q_o) = (contact.load_inner, contact.load_outer);
        let [t_i, t_o] = self.friction;
        let axial = q_i * sin_i - q_o * sin_o + t_i * cos_i - t_o * cos_o;
        let radial =
            q_i * cos_i - q_o * cos_o - t_i * sin_i + t_o * sin_o + self.state.centrifugal_force;
        let residual = axial.hypot(radial);
        let allowed = 1e-12 * self.scale + self.round_off;
        assert!(residual <= allowed, "{residual:e} N of {:e} N", self.scale);
    }

    fn distances_close(&self) {
        let (bearing, contact) = (&self.case.bearing, &self.state.contact);
        let geometry = &bearing.geometry;
        let distance = |groove_factor: f64, load: f64, stiffness: f64, film: f64| {
            (groove_factor - 0.5) * geometry.ball_diameter() + (load / stiffness).cbrt().powi(2)
                - film
        };
        let outer = distance(
            geometry.groove_factors()[1],
            contact.load_outer,
            bearing.outer_contact().unwrap().stiffness(),
            self.films[1],
        );
        let inner = distance(
            geometry.groove_factors()[0],
            contact.load_inner,
            bearing.inner_contact().unwrap().stiffness(),
            self.films[0],
        );
        let axial = self.case.axial - outer * contact.angle_outer.sin();
        let radial = self.case.radial - outer * contact.angle_outer.cos();
        let open = axial.hypot(radial) - inner;
        // a dry ball without load has a gap, and one at rest then has no place
        if contact.load_inner > 0.0 {
            assert!(open.abs() <= 1e-14 * geometry.ball_diameter(), "{open:e} m");
        } else if contact.load_outer > 0.0 {
            assert!(open <= 0.0);
            assert!(contact.angle_outer.abs() < 1e-12);
        }
    }

    /// Where the formulas of the books hold: inner race under load, contacts less than 75° apart.
    fn inertia_is_by_the_book(&self, control: RaceControl) {
        let (case, state) = (self.case, self.state);
        let contact = &state.contact;
        let geometry = &case.bearing.geometry;
        let (diameter, pitch) = (geometry.ball_diameter(), geometry.pitch_diameter());
        let mass = ball_mass(diameter, case.bearing.ball_material.density);
        let loaded = contact.load_inner >= 0.05 * mass * pitch * case.speed * case.speed;
        let apart = contact.angle_inner - contact.angle_outer;
        if !loaded || contact.load_inner == 0.0 || apart.cos() < 0.25 || !self.is_near() {
            return;
        }
        let ratio = diameter / pitch;
        let motion = BallMotion::new(control, ratio, contact.angle_inner, contact.angle_outer);
        let (orbital, rolling) = (
            motion.orbital_ratio * case.speed,
            motion.rolling_ratio * case.speed,
        );
        // M_g = J |ω_R| ω_m sin β, J = m_b D²/10
        let inertia = mass * diameter * diameter / 10.0;
        let moment = inertia * rolling.abs() * orbital * motion.pitch_angle.sin();
        let force = centrifugal_force(mass, pitch, orbital);
        let share = match control {
            RaceControl::Outer => 0.0,
            RaceControl::Even => 1.0,
            RaceControl::Inner => 2.0,
        };
        assert!((state.centrifugal_force - force).abs() <= 1e-13 * force);
        assert!((state.gyroscopic_moment - moment).abs() <= 1e-13 * force * diameter);
        assert!((self.friction[0] - share * moment / diameter).abs() <= 1e-13 * force);
    }

    /// With film a load can be left at a wide gap, where the orbit is the cage's.
    fn is_near(&self) -> bool {
        let geometry = &self.case.bearing.geometry;
        let stiffness = self.case.bearing.inner_contact().unwrap().stiffness();
        let load = self.state.contact.load_inner;
        let approach = (load / stiffness).cbrt().powi(2) - self.films[0];
        let first_touch = (geometry.groove_factors()[0] - 0.5) * geometry.ball_diameter();
        approach > -0.1 * first_touch
    }
}
