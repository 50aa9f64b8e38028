//! What a reader should know of a loaded bearing: one line each, with its numbers.

use std::f64::consts::TAU;

use super::{BallLine, Bearing, RaceContact, RaceContacts};

/// A contact of a numbered ball at a race with a name.
struct Place<'a> {
    race: &'static str,
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

/// Warnings of a bearing at a shaft speed in rad/s; `loaded` are the balls that bear at the inner race,
/// with their numbers.
pub(super) fn bearing_warnings(
    bearing: &Bearing,
    speed: f64,
    balls: &[BallLine],
    loaded: &[(usize, &BallLine)],
) -> Vec<String> {
    let first = [
        too_fast(bearing, speed),
        wrong_way(bearing, loaded),
        squeezed(bearing),
    ];
    let mut warnings: Vec<String> = first.into_iter().flatten().collect();
    for (side, race) in ["inner", "outer"].into_iter().enumerate() {
        let place = |(number, ball)| Place {
            race,
            number: number + 1,
            ball,
            contact: [&ball.inner, &ball.outer][side],
        };
        let places: Vec<Place> = balls.iter().enumerate().map(place).collect();
        warnings.extend(cut_off(bearing, &places));
        warnings.extend(overstressed(&places));
        warnings.extend(thin_film(&places));
    }
    warnings
}

/// A speed that cage and lubrication of the bearing are not made for.
fn too_fast(bearing: &Bearing, speed: f64) -> Option<String> {
    const PER_MINUTE: f64 = 60.0 / TAU;
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

/// Least contact angle, rad, that is an axial load: that of a ball without any is zero but for round-off.
const LEANING: f64 = 1e-5;

/// Loaded balls of an angular contact bearing that lean against the wrong shoulders.
fn wrong_way(bearing: &Bearing, loaded: &[(usize, &BallLine)]) -> Option<String> {
    let nominal = bearing.geometry.nominal_angle();
    if nominal == 0.0 {
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
fn overstressed(places: &[Place]) -> Option<String> {
    let permissible = RaceContacts::PERMISSIBLE_PRESSURE;
    let pressure = |place: &Place| place.contact.peak_pressure;
    let (count, worst) = worst(places, pressure, permissible)?;
    Some(format!(
        "the contact pressure at the {} race exceeds the {:.0} MPa of ISO 76 on {count} of {} balls: \
         {:.0} MPa on ball {} (at {:.1}°)",
        worst.race,
        permissible / 1e6,
        places.len(),
        worst.contact.peak_pressure / 1e6,
        worst.number,
        worst.degrees(),
    ))
}

/// Balls that are loaded without any load on the bearing.
fn squeezed(bearing: &Bearing) -> Option<String> {
    let squeeze = bearing.geometry.squeeze();
    (squeeze > 0.0).then(|| {
        format!(
            "the clearance is negative: every ball is squeezed by {:.2} µm without load, and a warmer inner ring squeezes \
             it more; ball loads and life include it, the friction moment does not",
            1e6 * squeeze
        )
    })
}

/// Films thinner than the surfaces are rough.
fn thin_film(places: &[Place]) -> Option<String> {
    let lambda = |place: &Place| place.contact.film.and_then(|film| film.lambda);
    let thinness = |place: &Place| lambda(place).map_or(0.0, f64::recip);
    let (count, worst) = worst(places, thinness, 1.0)?;
    let film = worst.contact.film?;
    Some(format!(
        "the oil film at the {} race is thinner than the surfaces are rough on {count} of {} balls: \
         λ = {:.3} (h_min = {:.4} µm) on ball {} (at {:.1}°)",
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
