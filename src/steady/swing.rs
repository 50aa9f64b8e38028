//! One period of a steady motion, and how far its quantities swing.

use std::f64::consts::TAU;

use nalgebra::DMatrix;
use serde::Serialize;

use crate::analysis::Channel;
use crate::rotor::Sample;
use crate::shooting::Circle;

/// Phases of the second frequency, per place, at which extremes are looked for.
const FINER: usize = 4;

/// How far a quantity swings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Swing {
    /// The quantity.
    #[serde(serialize_with = "Channel::serialize_with_unit")]
    pub channel: Channel,
    /// Its mean, in its unit.
    pub mean: f64,
    /// Distance of its extremes.
    pub peak_to_peak: f64,
    /// Root mean square about the mean.
    pub rms: f64,
}

/// Values of a channel over one period: a row a place, a column an instant; not a number where samples
/// do not carry it.
pub(super) fn values(channel: Channel, sampled: &[Vec<Sample>]) -> DMatrix<f64> {
    let instants = sampled.first().map_or(0, Vec::len);
    DMatrix::from_fn(sampled.len(), instants, |place, instant| {
        channel.of(&sampled[place][instant]).unwrap_or(f64::NAN)
    })
}

/// How far channels swing.
pub(super) fn swings(channels: &[Channel], circle: &Circle, sampled: &[Vec<Sample>]) -> Vec<Swing> {
    let places = circle.places();
    let finer = if places == 1 { 1 } else { FINER * places };
    let angles: Vec<f64> = (0..finer).map(|k| TAU * k as f64 / finer as f64).collect();
    let around = circle.values_at(&angles);
    let swing = |channel: &Channel| {
        let all = &around * values(*channel, sampled);
        let mean = all.mean();
        Swing {
            channel: *channel,
            mean,
            peak_to_peak: all.max() - all.min(),
            rms: all.map(|value| (value - mean).powi(2)).mean().sqrt(),
        }
    };
    channels.iter().map(swing).collect()
}
