//! One ball in its place, for people to read: what follows from loads and angles.

use super::{
    BallContact, BallLine, BallState, Bearing, FilmState, HertzSpring, RaceContact, RaceFilms,
};
use crate::physics::{BallMotion, HertzContact, RaceControl};

/// What its law says of one ball, the cage where it starts.
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

/// What turns the readings of one bearing into lines.
pub(super) struct BallLines<'a> {
    pub bearing: &'a Bearing,
    /// Hertz contacts of the geometry, inner race first.
    pub contacts: &'a [HertzContact; 2],
    /// Oil films; none without oil or without a law that has them.
    pub films: Option<&'a RaceFilms>,
    /// Shaft speed, rad/s.
    pub speed: f64,
}

impl BallLines<'_> {
    /// The line of one ball.
    pub fn line(&self, reading: &BallReading) -> BallLine {
        let contact = &reading.contact;
        let motion = self.motion(reading);
        let films = self.films([contact.load_inner, contact.load_outer]);
        let inertia = reading.inertia.as_ref();
        BallLine {
            azimuth: reading.azimuth,
            // d − A
            deformation: reading.distance - self.bearing.geometry.groove_centre_distance(),
            inner: self.race_contact(
                0,
                [contact.load_inner, contact.angle_inner],
                films[0],
                motion.map_or(0.0, |motion| motion.spin_to_roll_inner),
            ),
            outer: self.race_contact(
                1,
                [contact.load_outer, contact.angle_outer],
                films[1],
                motion.map_or(0.0, |motion| motion.spin_to_roll_outer),
            ),
            centrifugal_force: inertia.map_or(0.0, |state| state.centrifugal_force),
            gyroscopic_moment: inertia.map_or(0.0, |state| state.gyroscopic_moment),
            controlling_race: inertia
                .filter(|_| contact.load_inner > 0.0)
                .map(|state| state.controlling_race),
        }
    }

    /// Motion of the ball: under the race control of a law with inertia, otherwise under outer
    /// control at the common contact angle; none at rest.
    fn motion(&self, reading: &BallReading) -> Option<BallMotion> {
        if self.speed == 0.0 {
            return None;
        }
        Some(match &reading.inertia {
            Some(state) => state.motion,
            None => {
                let geometry = &self.bearing.geometry;
                BallMotion::new(
                    RaceControl::Outer,
                    geometry.ball_diameter() / geometry.pitch_diameter(),
                    reading.contact.angle_inner,
                    reading.contact.angle_outer,
                )
            }
        })
    }

    fn race_contact(
        &self,
        race: usize,
        [load, angle]: [f64; 2],
        film: Option<FilmState>,
        spin_to_roll: f64,
    ) -> RaceContact {
        let contact = &self.contacts[race];
        let ellipse = contact.ellipse(load);
        let spring = HertzSpring {
            stiffness: contact.stiffness(),
        };
        let loaded = load > 0.0;
        RaceContact {
            load,
            angle,
            approach: ellipse.approach,
            semi_major: ellipse.semi_major,
            semi_minor: ellipse.semi_minor,
            peak_pressure: ellipse.peak_pressure,
            contact_stiffness: spring.stiffness_under(load),
            film,
            spin_to_roll: if loaded { spin_to_roll } else { 0.0 },
            shoulder_margin: loaded
                .then(|| {
                    self.bearing
                        .shoulder_margin(race, angle, ellipse.semi_major)
                })
                .flatten(),
        }
    }

    /// Films at both races under their loads in N, where a loaded ball rolls on oil.
    fn films(&self, loads: [f64; 2]) -> [Option<FilmState>; 2] {
        let Some(films) = self.films.filter(|_| self.speed != 0.0) else {
            return [None; 2];
        };
        let thickness = films.thickness(loads, self.speed);
        let stiffness = films.stiffness(loads, self.speed);
        std::array::from_fn(|race| {
            let minimum = thickness[race].minimum;
            (loads[race] > 0.0).then(|| FilmState {
                central: thickness[race].central,
                minimum,
                stiffness: stiffness[race],
                // λ = h_min/σ
                lambda: self.bearing.roughness.map(|roughness| minimum / roughness),
            })
        })
    }
}
