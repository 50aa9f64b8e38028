//! What a reader should know of a loaded bearing: one line each, with its numbers.

use std::f64::consts::PI;

use super::{BallLine, Bearing, ContactLaw, LaminaLine, RaceContact};
use crate::physics::{PER_MINUTE, Race, ball_mass, centrifugal_force, nominal_cage_speed};

/// A contact of a numbered ball at a race with a name.
struct Place<'a> {
    race: &'static str,
    /// `ball` or `roller`.
    name: &'static str,
    /// From 1.
    number: usize,
    ball: &'a BallLine,
    contact: &'a RaceContact,
}

impl Place<'_> {
    fn degrees(&self) -> f64 {
        self.ball.azimuth.to_degrees()
    }
}

/// Warnings of a bearing at a shaft speed in rad/s and a permissible pressure in Pa; `squeeze` is by how much every ball is
/// squeezed without load, m, `loaded` are the balls that bear at the inner race, with their numbers.
pub(super) fn bearing_warnings(
    bearing: &Bearing,
    law: ContactLaw,
    speed: f64,
    permissible: f64,
    squeeze: f64,
    balls: &[BallLine],
    loaded: &[(usize, &BallLine)],
) -> Vec<String> {
    let first = [
        too_fast(bearing, speed),
        inertia_left_out(bearing, law, speed),
        wrong_way(bearing, loaded),
        without_thrust(bearing, loaded),
        squeezed(bearing, squeeze),
        edge_loaded(loaded),
        without_life(bearing),
        doubtful_rating(bearing),
        life_of_steel(bearing),
        thinly_lubricated(bearing, speed),
    ];
    let mut warnings: Vec<String> = first.into_iter().flatten().collect();
    for (side, race) in ["inner", "outer"].into_iter().enumerate() {
        let place = |(number, ball)| Place {
            race,
            name: bearing.geometry.element(),
            number: number + 1,
            ball,
            contact: [&ball.inner, &ball.outer][side],
        };
        let places: Vec<Place> = balls.iter().enumerate().map(place).collect();
        warnings.extend(cut_off(bearing, &places));
        warnings.extend(overstressed(&places, permissible));
        warnings.extend(thin_film(&places));
    }
    warnings
}

/// Speed factor d_m·n, mm/min, above which the centrifugal forces of the balls move their contact angles.
const INERTIA_FREE: f64 = 5e5;

/// A speed at which a law without the inertia of the balls is off.
fn inertia_left_out(bearing: &Bearing, law: ContactLaw, speed: f64) -> Option<String> {
    let geometry = &bearing.geometry;
    let factor = 1e3 * geometry.pitch_diameter() * speed.abs() * PER_MINUTE;
    // of a turning outer ring nothing better is known
    let left_out = law == ContactLaw::Hertz && bearing.rotating_ring == Race::Inner;
    (left_out && factor > INERTIA_FREE).then(|| {
        let density = bearing.ball_material.density;
        let (name, diameter) = (geometry.element(), geometry.ball_diameter());
        let (mass, advice) = match geometry.rollers() {
            // a cylinder
            Some(rollers) => (
                0.25 * PI * diameter * diameter * rollers.length * density,
                "no law of rollers counts that",
            ),
            None => (
                ball_mass(diameter, density),
                "contact = \"jones\" counts that, and gives other stiffnesses and frequencies",
            ),
        };
        let orbit = nominal_cage_speed(speed, geometry.gamma());
        format!(
            "contact = \"hertz\" leaves out the inertia of the {name}s, and d_m·n is {factor:.0} mm/min, above \
             {INERTIA_FREE:.0}: a {name} is pressed outwards with {:.1} N; {advice}",
            centrifugal_force(mass, geometry.pitch_diameter(), orbit)
        )
    })
}

/// A speed that cage and lubrication of the bearing are not made for.
fn too_fast(bearing: &Bearing, speed: f64) -> Option<String> {
    let limit = bearing.highest_permissible_speed();
    let (source, advice) = match bearing.limiting_speed {
        Some(_) => ("its limiting speed", ""),
        None => (
            "the estimated limiting speed",
            " (set `limiting_speed` to the maker's)",
        ),
    };
    (speed.abs() > limit).then(|| {
        format!(
            "{:.0} rpm is {:.2} times {source}, {:.0} rpm{advice}",
            speed.abs() * PER_MINUTE,
            speed.abs() / limit,
            limit * PER_MINUTE
        )
    })
}

/// A bearing whose lives are not those of a radial one.
fn without_life(bearing: &Bearing) -> Option<String> {
    bearing
        .dynamic_rating
        .filter(|_| bearing.is_thrust_bearing())?;
    Some(format!(
        "no life is given: with a contact angle of {:.1}° this is a thrust bearing after ISO 281, whose dynamic load rating is \
         axial; lives are those of radial bearings, up to 45°",
        bearing.geometry.nominal_angle().to_degrees(),
    ))
}

/// How many times the rating of ISO 281 a maker's is at most, or a part of it at least: makers print up to 1.1 times that of
/// balls and 1.2 times that of rollers.
const LIKELY_RATING: f64 = 1.3;

/// A dynamic load rating that balls or rollers of this size do not have.
fn doubtful_rating(bearing: &Bearing) -> Option<String> {
    let given = bearing.radial_rating()?;
    let expected = bearing.geometry.dynamic_rating();
    let ratio = given / expected;
    let element = bearing.geometry.element();
    let likely = 1.0 / LIKELY_RATING..=LIKELY_RATING;
    (!likely.contains(&ratio)).then(|| {
        format!(
            "the dynamic load rating is {given:.0} N, and ISO 281 gives {expected:.0} N by the {element}s: lives go with its third \
             power; look at the unit of the rating, and at number and size of the {element}s",
        )
    })
}

/// A modified life of a hybrid bearing.
fn life_of_steel(bearing: &Bearing) -> Option<String> {
    bearing.radial_rating()?;
    bearing.lubrication?.contamination?;
    bearing.is_hybrid().then(|| {
        format!(
            "a_ISO and C_u of ISO 281 are those of bearings of steel, and these {}s are lighter than steel (hybrid): L_nm is no \
             more than an estimate",
            bearing.geometry.element()
        )
    })
}

/// Least viscosity ratio κ for which ISO 281 gives a_ISO.
const LEAST_RATIO: f64 = 0.1;

/// A lubricant that is too thin for the modified life.
fn thinly_lubricated(bearing: &Bearing, speed: f64) -> Option<String> {
    bearing.lubrication?.contamination?;
    let ratio = bearing.viscosity_ratio(speed)?;
    (ratio < LEAST_RATIO && !bearing.is_thrust_bearing()).then(|| {
        format!(
            "the viscosity ratio κ is {ratio:.3}, and ISO 281 gives a_ISO from {LEAST_RATIO} on: below it a_ISO is taken as its least, \
             0.1; a more viscous oil, or static safety, decides there"
        )
    })
}

/// Least contact angle, rad, that is an axial load: that of a ball without any is zero but for round-off.
const LEANING: f64 = 1e-5;

/// Loaded balls of an angular contact bearing that lean against the wrong shoulders.
fn wrong_way(bearing: &Bearing, loaded: &[(usize, &BallLine)]) -> Option<String> {
    let nominal = bearing.geometry.nominal_angle();
    if nominal == 0.0 || bearing.geometry.rollers().is_some() {
        return None;
    }
    let leaning = loaded
        .iter()
        .filter(|(_, ball)| ball.inner.angle < -LEANING);
    let count = leaning.clone().count();
    let (number, ball) = leaning.min_by(|a, b| a.1.inner.angle.total_cmp(&b.1.inner.angle))?;
    Some(format!(
        "loaded the wrong way: {count} of {} loaded balls have a negative contact angle, ball \
         {} (at {:.1}°) the most with {:.2}°; an angular contact bearing of {:.1}° bears \
         axially one way only: turn its `facing`, or the load along z",
        loaded.len(),
        number + 1,
        ball.azimuth.to_degrees(),
        ball.inner.angle.to_degrees(),
        nominal.to_degrees(),
    ))
}

/// An angular contact bearing that bears at right angles to the axis, for nothing presses it along.
fn without_thrust(bearing: &Bearing, loaded: &[(usize, &BallLine)]) -> Option<String> {
    let nominal = bearing.geometry.nominal_angle();
    let is_angular = nominal > 0.0 && bearing.geometry.rollers().is_none();
    let is_upright = |ball: &BallLine| ball.inner.angle.abs() <= LEANING;
    let without =
        is_angular && !loaded.is_empty() && loaded.iter().all(|(_, ball)| is_upright(ball));
    without.then(|| {
        format!(
            "an angular contact bearing of {:.1}° without any axial force: its balls bear at 0°, with a play that it has nowhere \
             else; give it a preload, an axial load, or a second bearing with the other `facing`",
            nominal.to_degrees()
        )
    })
}

/// Contact ellipses that reach over the shoulder of a race.
fn cut_off(bearing: &Bearing, places: &[Place]) -> Option<String> {
    let shoulder = bearing.shoulder_angle?;
    let margin = |place: &Place| place.contact.shoulder_margin.unwrap_or(f64::INFINITY);
    let (count, worst) = worst(places, |place| -margin(place), 0.0)?;
    let (angle, margin) = (worst.contact.angle.abs(), margin(worst));
    Some(format!(
        "the contact ellipse is cut off at the shoulder of the {} race on {count} of {} balls: ball \
         {} (at {:.1}°) reaches {:.2}° past it (contact angle {:.2}°, half the ellipse {:.2}°, \
         shoulder at {:.2}°)",
        worst.race,
        places.len(),
        worst.number,
        worst.degrees(),
        -margin.to_degrees(),
        angle.to_degrees(),
        (shoulder - margin - angle).to_degrees(),
        shoulder.to_degrees(),
    ))
}

/// Contacts beyond the permissible pressure of ISO 76.
fn overstressed(places: &[Place], permissible: f64) -> Option<String> {
    let pressure = |place: &Place| place.contact.peak_pressure;
    let (count, worst) = worst(places, pressure, permissible)?;
    let name = worst.name;
    Some(format!(
        "the contact pressure at the {} race exceeds the {:.0} MPa of ISO 76 on {count} of {} {name}s: \
         {:.0} MPa on {name} {} (at {:.1}°)",
        worst.race,
        permissible / 1e6,
        places.len(),
        worst.contact.peak_pressure / 1e6,
        worst.number,
        worst.degrees(),
    ))
}

/// Balls that are loaded without any load on the bearing.
fn squeezed(bearing: &Bearing, squeeze: f64) -> Option<String> {
    (squeeze > 0.0).then(|| {
        format!(
            "the clearance is negative: every {} is squeezed by {:.2} µm without load, and a warmer inner ring squeezes \
             it more; loads and life include it, the friction moment does not",
            bearing.geometry.element(),
            1e6 * squeeze
        )
    })
}

/// How many times the mean of a roller its end must bear to be reported.
const EDGE: f64 = 1.2;

/// Rollers whose ends bear most.
fn edge_loaded(loaded: &[(usize, &BallLine)]) -> Option<String> {
    let load = |lamina: &LaminaLine| lamina.load;
    // load of the more loaded end over the mean of the roller, where no other slice bears more
    let excess = |ball: &BallLine| {
        let (first, last) = (ball.laminae.first()?, ball.laminae.last()?);
        let end = load(first).max(load(last));
        let most = ball.laminae.iter().map(load).fold(0.0, f64::max);
        let mean = ball.inner.load / ball.laminae.len() as f64;
        Some(end / mean).filter(|part| end == most && *part > EDGE)
    };
    let ends = loaded
        .iter()
        .filter_map(|(number, ball)| Some((*number, *ball, excess(ball)?)));
    let count = ends.clone().count();
    let (number, ball, excess) = ends.max_by(|a, b| a.2.total_cmp(&b.2))?;
    let pressure = ball.inner.peak_pressure.max(ball.outer.peak_pressure);
    Some(format!(
        "edge loading: the end of {count} of {} loaded rollers bears most; roller {} (at {:.1}°) bears {excess:.2} times its \
         mean there, {:.0} MPa, and the stress concentration at a sharp end, which the laminae do not know, adds to it: align \
         the shaft, or give the rollers a `profile`",
        loaded.len(),
        number + 1,
        ball.azimuth.to_degrees(),
        pressure / 1e6,
    ))
}

/// Films thinner than the surfaces are rough.
fn thin_film(places: &[Place]) -> Option<String> {
    let lambda = |place: &Place| place.contact.film.and_then(|film| film.lambda);
    let thinness = |place: &Place| lambda(place).map_or(0.0, f64::recip);
    let (count, worst) = worst(places, thinness, 1.0)?;
    let (film, name) = (worst.contact.film?, worst.name);
    Some(format!(
        "the oil film at the {} race is thinner than the surfaces are rough on {count} of {} {name}s: \
         λ = {:.3} (h_min = {:.4} µm) on {name} {} (at {:.1}°)",
        worst.race,
        places.len(),
        film.lambda?,
        film.minimum * 1e6,
        worst.number,
        worst.degrees(),
    ))
}

/// Number of places whose value exceeds a limit, and the one where it is largest; none if none does.
fn worst<'a, 'b>(
    places: &'b [Place<'a>],
    value: impl Fn(&Place<'a>) -> f64,
    limit: f64,
) -> Option<(usize, &'b Place<'a>)> {
    let beyond = places.iter().filter(|place| value(place) > limit);
    let count = beyond.clone().count();
    let worst = beyond.max_by(|a, b| value(a).total_cmp(&value(b)))?;
    Some((count, worst))
}
