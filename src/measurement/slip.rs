//! Slip of a cage: where the lines of a bearing are, against where it would roll.

use std::f64::consts::TAU;

use serde::Serialize;

use super::MeasuredBearing;
use crate::analysis::{Axis, BearingFrequencies, EstimatedSpectrum, SpectrumKind};
use crate::physics::Race;

/// Part of a ball-pass frequency within which its line is looked for.
const REACH: f64 = 0.03;
/// Highest multiple of a line that is looked for.
const MULTIPLES: u32 = 5;
/// Bins to which the place of a line is known, and within which a multiple counts.
const KNOWN: f64 = 0.25;
const NEAR: f64 = 0.75;
/// Part of the power of all lines as high that those of a race have at least: other causes have some lines near those, too.
const LEAST_SHARE: f64 = 0.1;
/// Bins off a multiple of the shaft within which a line is taken for one of the shaft.
const OF_SHAFT: f64 = 2.0;

/// How a cage slips, as found from the line of a race, or of the spin of a ball, in an envelope.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Slip {
    /// The race whose line it is; none where it is that of a ball that meets both races as it spins.
    pub race: Option<Race>,
    /// Spectrum that it was found in.
    pub spectrum: String,
    /// Frequency of the line, multiples of the shaft.
    pub order: f64,
    /// Where it would be if the cage rolled, multiples of the shaft.
    pub kinematic_order: f64,
    /// How much slower than rolling the cage turns, as a part: what `cage_slip` of a bearing says. Negative where it is faster, as
    /// of a contact angle or a speed that differs.
    pub cage_slip: f64,
    /// How far that may be off by the resolution.
    pub uncertainty: f64,
    /// Multiples of the line that are there.
    pub multiples: Vec<u32>,
}

/// The slips of bearings at a speed in rad/s (2π over orders of a speed that changes), and their frequencies with it, or with the
/// slip that is given.
pub(super) fn found(
    bearings: &[MeasuredBearing],
    spectra: &[EstimatedSpectrum],
    speed: f64,
) -> (Vec<Option<Slip>>, Vec<BearingFrequencies>) {
    let slips: Vec<_> = bearings
        .iter()
        .map(|own| found_of(own, spectra, speed))
        .collect();
    let passes = bearings.iter().zip(&slips).map(|(own, found)| {
        let found = found.as_ref().map(|slip| slip.cage_slip);
        let slip = own.slip.or(found).unwrap_or(0.0);
        BearingFrequencies {
            simulated: own.bearing.rolling_ball_pass(slip, speed),
            nominal: own.bearing.rolling_ball_pass(0.0, speed),
        }
    });
    let passes = passes.collect();
    (slips, passes)
}

/// The slip by the lines of races; where these explain nothing, by that of the spin of a ball.
fn found_of(own: &MeasuredBearing, spectra: &[EstimatedSpectrum], speed: f64) -> Option<Slip> {
    let by_races = strongest(own, spectra, speed, &[Some(Race::Outer), Some(Race::Inner)]);
    by_races.or_else(|| strongest(own, spectra, speed, &[None]))
}

/// The slip by the line of a race, or of the spin of a ball, that is, with its multiples, strongest in any envelope.
fn strongest(
    own: &MeasuredBearing,
    spectra: &[EstimatedSpectrum],
    speed: f64,
    races: &[Option<Race>],
) -> Option<Slip> {
    if speed == 0.0 {
        return None;
    }
    let shaft = speed / TAU;
    let is_known = |spectrum: &&EstimatedSpectrum| {
        let is_envelope = matches!(spectrum.request.kind, SpectrumKind::Envelope { .. });
        is_envelope && (spectrum.request.axis == Axis::Order || spectrum.shaft_frequency > 0.0)
    };
    let candidates = spectra.iter().filter(is_known).flat_map(|spectrum| {
        // multiples of the shaft in a unit of the axis
        let orders = match spectrum.request.axis {
            Axis::Order => 1.0,
            Axis::Frequency => 1.0 / shaft,
        };
        spectrum.value_columns().flat_map(move |column| {
            let lines = spectrum.lines_above_noise(column).into_iter();
            let lines: Vec<_> = lines.map(|(at, value)| (at * orders, value)).collect();
            let resolution = spectrum.resolution * orders;
            let name = &spectrum.request.name;
            let slip = move |race: &Option<Race>| by_line(own, *race, &lines, resolution, name);
            races.iter().filter_map(slip)
        })
    });
    // of equal ones the first
    let stronger = |a: (f64, Slip), b: (f64, Slip)| if b.0 > a.0 { b } else { a };
    candidates.reduce(stronger).map(|(_, slip)| slip)
}

/// The slip by the line of a race, or of the spin of a ball, among the lines of a spectrum over orders, with the power of that line
/// and its multiples; none where they explain little.
fn by_line(
    own: &MeasuredBearing,
    race: Option<Race>,
    lines: &[(f64, f64)],
    resolution: f64,
    spectrum: &str,
) -> Option<(f64, Slip)> {
    let kinematic_order = order_of(own, race);
    let (power, order, multiples) = comb(lines, kinematic_order, resolution)?;
    let highest = (f64::from(MULTIPLES) + 0.5) * kinematic_order;
    let all = lines.iter().filter(|(at, _)| *at < highest);
    let all: f64 = all.map(|(_, value)| value * value).sum();
    if power < LEAST_SHARE * all {
        return None;
    }
    let highest = f64::from(multiples.last().copied().unwrap_or(1));
    let known = KNOWN * resolution / highest;
    let cage_slip = |order: f64| cage_slip(own, race, order);
    let slip = Slip {
        race,
        spectrum: spectrum.to_owned(),
        order,
        kinematic_order,
        cage_slip: cage_slip(order),
        uncertainty: (cage_slip(order + known) - cage_slip(order)).abs(),
        multiples,
    };
    Some((power, slip))
}

/// Order at which the balls of a bearing that rolls pass a race, or a spot of a ball meets one of both.
fn order_of(own: &MeasuredBearing, race: Option<Race>) -> f64 {
    let pass = own.bearing.rolling_ball_pass(0.0, TAU);
    match race {
        Some(Race::Outer) => pass.outer,
        Some(Race::Inner) => pass.inner,
        None => 2.0 * pass.spin,
    }
}

/// How much slower than rolling a cage turns whose balls pass a race at an order: Z |f_ring − f_c| of it; or spin at half an order, in
/// proportion to |f_o − f_c|.
pub(super) fn cage_slip(own: &MeasuredBearing, race: Option<Race>, order: f64) -> f64 {
    let rolling = own.bearing.rolling_ball_pass(0.0, TAU);
    let balls = own.bearing.geometry.balls() as f64;
    let past = match race {
        Some(_) => order / balls,
        None => order / (2.0 * rolling.spin) * rolling.outer / balls,
    };
    let cage = match race.unwrap_or(Race::Outer) == own.bearing.rotating_ring {
        true => 1.0 - past,
        false => past,
    };
    1.0 - cage / rolling.cage
}

/// Of the lines near a place the one whose multiples are strongest: its power with them, its place by the highest of them, and which
/// there are; none that is of the shaft, or alone and not the strongest of all.
fn comb(lines: &[(f64, f64)], expected: f64, resolution: f64) -> Option<(f64, f64, Vec<u32>)> {
    let strongest = lines
        .iter()
        .fold(0.0, |most: f64, (_, value)| most.max(*value));
    let near = |place: f64, reach: f64| {
        let near = lines
            .iter()
            .filter(move |(at, _)| (at - place).abs() <= reach);
        near.copied().max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let candidates = lines.iter().filter(|(at, _)| {
        let beside = (at - at.round()).abs();
        (at / expected - 1.0).abs() <= REACH && beside > OF_SHAFT * resolution
    });
    let combs = candidates.filter_map(|&(at, value)| {
        let (mut place, mut power, mut multiples) = (at, value * value, vec![1]);
        for multiple in 2..=MULTIPLES {
            let times = f64::from(multiple);
            // as far as the place is known from the multiples before
            let last = f64::from(*multiples.last().unwrap_or(&1));
            let reach = (NEAR + KNOWN * times / last) * resolution;
            if let Some((found, value)) = near(times * place, reach) {
                place = found / times;
                power += value * value;
                multiples.push(multiple);
            }
        }
        let is_sure = multiples.len() > 1 || value >= strongest;
        is_sure.then_some((power, place, multiples))
    });
    combs.max_by(|a, b| a.0.total_cmp(&b.0))
}
