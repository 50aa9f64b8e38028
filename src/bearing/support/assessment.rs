//! From the place of the inner ring to everything that is known of a loaded bearing.

use std::f64::consts::TAU;

use super::{Cage, Support, Vector5};
use crate::bearing::bearing_friction::skf_moment;
use crate::bearing::law::{BallLaw, FilmLaw, FilmThickness, Law, Share, with_law};
use crate::bearing::static_rating::{fatigue_load_limit, static_rating};
use crate::bearing::surface::BallIdentity;
use crate::bearing::warnings::bearing_warnings;
use crate::bearing::{
    Around, Ball, BallContact, BallLine, Bearing, BearingRotation, BearingState, CageMotion,
    Elements, FilmState, Geometry, GeometryState, InternalGeometry, Lamina, LaminaLine,
    RaceContact, RaceContacts, RaceFilms, RollerGeometry, StiffnessShares,
};
use crate::physics::{BallMotion, RaceControl};

/// Share of the largest load at the inner race below which a ball counts as unloaded: behind an oil
/// film the load of a ball never quite vanishes.
pub(crate) const LOADED_SHARE: f64 = 1e-6;

/// A bearing to be assessed at one place and speed.
struct Assessment<'a> {
    support: &'a Support,
    /// Displacement of the inner ring.
    place: Vector5,
    /// Axial displacement of the shaft without load, m.
    unloaded: f64,
    rotation: BearingRotation,
    cage: Cage,
}

impl Support {
    /// What is known of the bearing with the shaft at `displacement`, its cage where it starts and turning as from an
    /// equilibrium there; without load the shaft is displaced axially by `unloaded`, m.
    ///
    /// A linear bearing knows no balls: its state is that of the Hertz law at this displacement,
    /// force and stiffness, too.
    pub(crate) fn state(
        &self,
        displacement: &Vector5,
        unloaded: f64,
        speed: f64,
        motion: CageMotion,
    ) -> BearingState {
        let rotation = BearingRotation::at_start(speed);
        let assessment = Assessment {
            support: self,
            place: self.settled(displacement, &rotation),
            unloaded,
            rotation,
            cage: self.cage_at(motion, Some(displacement), speed),
        };
        assessment.state()
    }

    /// Axial force in N at standstill with the shaft displaced along its axis alone, m.
    pub(crate) fn axial_force(&self, displacement: f64) -> f64 {
        let rotation = BearingRotation::at_start(0.0);
        let place = self.settled(&[0.0, 0.0, displacement, 0.0, 0.0], &rotation);
        self.ring_tangent(&place, &rotation).0[2]
    }

    /// What a ball of each row at each of `positions` azimuths from +X on would bear with the inner ring at `place`, its
    /// displacement from the outer one, or, where `None`, what every ball bears with the cage where it starts; row after row.
    pub(crate) fn around(
        &self,
        place: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        let rotation = BearingRotation::at_start(speed);
        let geometry = &self.definition.bearing.geometry;
        let at = |position, row, azimuth, identity| {
            let ball = self.ring.ball_at(place, azimuth, identity, &rotation);
            let contact = with_law!(&self.law, law => law.contact(&ball, speed));
            let side = self.ring.side(identity);
            Around {
                row: row + 1,
                position: position + 1,
                azimuth,
                deformation: self.deformation(&ball, &contact),
                contact: BallContact {
                    angle_inner: side * contact.angle_inner,
                    angle_outer: side * contact.angle_outer,
                    ..contact
                },
            }
        };
        let count = positions.unwrap_or(geometry.balls());
        let places = (0..geometry.rows()).flat_map(|row| (0..count).map(move |own| (row, own)));
        let places = places.map(|(row, own)| match positions {
            None => {
                let number = row * count + own;
                at(
                    own,
                    row,
                    self.ring.azimuths[number],
                    BallIdentity::Numbered(number),
                )
            }
            Some(_) => {
                let azimuth = TAU * own as f64 / count as f64;
                at(own, row, azimuth, BallIdentity::Perfect { row })
            }
        });
        places.collect()
    }

    /// Change of the distance of the groove centres d − A, m; of a roller, the approach of the slice that is pressed most.
    fn deformation(&self, ball: &Ball, contact: &BallContact) -> f64 {
        let geometry = &self.definition.bearing.geometry;
        match geometry.rollers() {
            Some(_) => contact.approach,
            None => ball.axial.hypot(ball.radial) - geometry.groove_centre_distance(),
        }
    }
}

impl Assessment<'_> {
    fn state(&self) -> BearingState {
        let (support, bearing, speed) = (self.support, self.bearing(), self.rotation.speed);
        let contacts = &support.contacts;
        let (force, stiffness) = support.ring_tangent(&self.place, &self.rotation);
        let balls = self.balls();
        let loads = balls.iter().flat_map(BallLine::rated_loads);
        let life = bearing.rating_life();
        let life = life.and_then(|rating| rating.life(loads));
        let carried = balls.iter().map(|ball| ball.inner.load).sum();
        let loaded: Vec<_> = loaded(&balls).collect();
        BearingState {
            rating_lives: life.and_then(|life| bearing.rating_lives(life, &force, carried, speed)),
            fit: bearing.fit,
            preload: support.axial_force(self.unloaded),
            friction_moment_skf: skf_moment(bearing, &support.rated_contacts, &force, speed),
            geometry: self.geometry(),
            clearance: bearing.clearance(),
            displacement: self.place,
            force,
            stiffness: support.seat.condense(stiffness),
            shares: self.shares(),
            balls_loaded: loaded.len(),
            life,
            static_safety: contacts.static_safety(&balls),
            friction_moment: support.friction_moment(&force, speed),
            has_oil: support.friction.has_oil(),
            ball_pass: self.cage.ball_pass(bearing, speed),
            nominal_ball_pass: support.nominal_ball_pass(speed),
            warnings: bearing_warnings(
                bearing,
                support.definition.law,
                speed,
                contacts.permissible_pressure(),
                self.squeeze(),
                &balls,
                &loaded,
            ),
            balls,
        }
    }

    /// By how much every ball or roller is squeezed without load, m. The races of a tapered bearing part as the shaft gives way.
    fn squeeze(&self) -> f64 {
        let (support, geometry) = (self.support, &self.bearing().geometry);
        if geometry.squeeze() == 0.0 || geometry.rollers().is_none() || geometry.is_symmetric() {
            return geometry.squeeze();
        }
        let still = BearingRotation::at_start(0.0);
        let place = support.settled(&[0.0, 0.0, self.unloaded, 0.0, 0.0], &still);
        let around = support.around(&place, 0.0, None);
        around.iter().map(|own| own.deformation).fold(0.0, f64::max)
    }

    fn geometry(&self) -> GeometryState {
        let (bearing, contacts) = (self.bearing(), &self.support.rated_contacts);
        let geometry = &bearing.geometry;
        GeometryState {
            elements: match geometry.rollers() {
                Some(rollers) => Elements::Rollers(RollerGeometry {
                    kind: rollers.kind,
                    rollers: geometry.balls(),
                    rows: geometry.rows(),
                    diameter: geometry.ball_diameter(),
                    length: rollers.length,
                    pitch_diameter: geometry.pitch_diameter(),
                    contact_angle: geometry.contact_angle(),
                    laminae: rollers.laminae,
                    dynamic_rating: geometry.dynamic_rating(),
                    static_rating: static_rating(geometry, contacts),
                }),
                None => Elements::Balls(internal_geometry(geometry, contacts)),
            },
            fatigue_load_limit: fatigue_load_limit(geometry, contacts),
            estimated: bearing.estimated,
        }
    }

    fn bearing(&self) -> &Bearing {
        &self.support.definition.bearing
    }

    fn balls(&self) -> Vec<BallLine> {
        let azimuths = self.support.ring.azimuths.iter().enumerate();
        with_law!(&self.support.law, law => {
            azimuths.map(|(number, &azimuth)| self.ball(law, number, azimuth)).collect()
        })
    }

    fn ball(&self, law: &impl BallLaw, number: usize, azimuth: f64) -> BallLine {
        let (ring, speed) = (&self.support.ring, self.rotation.speed);
        let geometry = &self.bearing().geometry;
        let identity = BallIdentity::Numbered(number);
        let ball = ring.ball_at(&self.place, azimuth, identity, &self.rotation);
        let laminae = law.laminae(&ball);
        let inertia = law.state(&ball, speed);
        let contact = inertia.map_or_else(|| law.contact(&ball, speed), |state| state.contact);
        let deformation = self.support.deformation(&ball, &contact);
        // the second row leans the other way
        let side = ring.side(identity);
        let [inner_angle, outer_angle] =
            [contact.angle_inner, contact.angle_outer].map(|a| side * a);
        // without inertia it rolls as under outer control at the common contact angle
        let ratio = geometry.ball_diameter() / geometry.pitch_diameter();
        let rolling = || BallMotion::new(RaceControl::Outer, ratio, inner_angle, outer_angle);
        let motion = inertia.map_or_else(rolling, |state| state.motion);
        let loads = [contact.load_inner, contact.load_outer];
        let films = self.films(loads);
        BallLine {
            row: number / geometry.balls() + 1,
            azimuth,
            deformation,
            inner: RaceContact {
                film: films[0],
                ..self.race_contact(
                    0,
                    loads[0],
                    inner_angle,
                    motion.spin_to_roll_inner,
                    &laminae,
                )
            },
            outer: RaceContact {
                film: films[1],
                ..self.race_contact(
                    1,
                    loads[1],
                    outer_angle,
                    motion.spin_to_roll_outer,
                    &laminae,
                )
            },
            centrifugal_force: inertia.map_or(0.0, |state| state.centrifugal_force),
            gyroscopic_moment: inertia.map_or(0.0, |state| state.gyroscopic_moment),
            controlling_race: inertia
                .filter(|_| loads[0] > 0.0)
                .map(|state| state.controlling_race),
            laminae: laminae.iter().map(|lamina| self.lamina(lamina)).collect(),
        }
    }

    /// A slice of a roller.
    fn lamina(&self, lamina: &Lamina) -> LaminaLine {
        LaminaLine {
            position: lamina.position,
            approach: lamina.approach,
            load: lamina.load,
            peak_pressure: [0, 1].map(|race| self.strip(race, lamina)[1]),
        }
    }

    /// Half-width, m, and largest pressure, Pa, of a slice of a roller on a race.
    fn strip(&self, race: usize, lamina: &Lamina) -> [f64; 2] {
        match &self.support.contacts {
            RaceContacts::Line(contacts) => contacts.strip(race, lamina),
            RaceContacts::Point(_) => [0.0; 2],
        }
    }

    /// All but the film of a contact.
    fn race_contact(
        &self,
        race: usize,
        load: f64,
        angle: f64,
        spin_to_roll: f64,
        laminae: &[Lamina],
    ) -> RaceContact {
        let contacts = &self.support.contacts;
        let ellipse = contacts.ellipse(race, load);
        let mut state = RaceContact {
            load,
            angle,
            approach: ellipse.approach,
            semi_major: ellipse.semi_major,
            semi_minor: ellipse.semi_minor,
            peak_pressure: ellipse.peak_pressure,
            contact_stiffness: contacts.stiffness_under(race, load),
            ..RaceContact::default()
        };
        for lamina in laminae {
            // the slice that is pressed most decides
            let [half_width, pressure] = self.strip(race, lamina);
            state.semi_minor = state.semi_minor.max(half_width);
            state.peak_pressure = state.peak_pressure.max(pressure);
        }
        if load > 0.0 {
            state.shoulder_margin = self.support.shoulder_margin(race, angle, load);
            if self.rotation.speed != 0.0 && laminae.is_empty() {
                state.spin_to_roll = spin_to_roll;
            }
        }
        state
    }

    /// Films at both races under their loads in N, where a loaded ball rolls on oil.
    fn films(&self, loads: [f64; 2]) -> [Option<FilmState>; 2] {
        let speed = self.rotation.speed;
        let Some(films) = self.support.films.filter(|_| speed != 0.0) else {
            return [None; 2];
        };
        let (thickness, stiffness) = (films.thickness(loads, speed), films.stiffness(loads, speed));
        let roughness = self.bearing().roughness;
        std::array::from_fn(|race| {
            let FilmThickness { central, minimum } = thickness[race];
            (loads[race] > 0.0).then(|| FilmState {
                central,
                minimum,
                stiffness: stiffness[race],
                // λ = h_min/σ
                lambda: roughness.map(|roughness| minimum / roughness),
            })
        })
    }

    /// Stiffness of contacts and films, each alone, where the bearing turns and has films.
    fn shares(&self) -> Option<StiffnessShares> {
        let films = self.support.films.filter(|_| self.rotation.speed != 0.0)?;
        match &self.support.law {
            Law::HertzFilm(law) => Some(self.shares_under(law, &films)),
            Law::JonesFilm(law) => Some(self.shares_under(law, &films)),
            _ => None,
        }
    }

    fn shares_under(&self, law: &impl FilmLaw, films: &RaceFilms) -> StiffnessShares {
        let Support { ring, seat, .. } = self.support;
        let [contacts, films] = Share::both(law, films, self.rotation.speed).map(|share| {
            let (_, stiffness) = ring.force_and_stiffness(&share, &self.place, &self.rotation);
            seat.condense(stiffness)
        });
        StiffnessShares { contacts, films }
    }
}

/// Balls, grooves and ratings of a ball bearing.
fn internal_geometry(geometry: &Geometry, contacts: &RaceContacts) -> InternalGeometry {
    let [groove_factor_inner, groove_factor_outer] = geometry.groove_factors();
    InternalGeometry {
        balls: geometry.balls(),
        ball_diameter: geometry.ball_diameter(),
        pitch_diameter: geometry.pitch_diameter(),
        contact_angle: geometry.contact_angle(),
        groove_factor_inner,
        groove_factor_outer,
        dynamic_rating: geometry.dynamic_rating(),
        static_rating: static_rating(geometry, contacts),
    }
}

/// Balls that bear at the inner race, with their numbers.
fn loaded(balls: &[BallLine]) -> impl Iterator<Item = (usize, &BallLine)> {
    let largest = balls.iter().map(|ball| ball.inner.load).fold(0.0, f64::max);
    let least = LOADED_SHARE * largest;
    let numbered = balls.iter().enumerate();
    numbered.filter(move |(_, ball)| ball.inner.load > least)
}
