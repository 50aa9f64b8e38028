//! The vibration of a run, judged by the zones of ISO 20816-3.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::analysis::{Channel, Motion, VelocityLevel};
use crate::physics::{MachineGroup, MachineSupport, VibrationZone, zone_boundaries};

/// Edition whose tables stand in [`zone_boundaries`].
const STANDARD: &str = "ISO 20816-3:2022";
/// Speeds that the standard speaks of, rpm.
const SPEEDS: [f64; 2] = [120.0, 30_000.0];
/// Speed below which it measures from 2 Hz on, rpm.
const SLOW: f64 = 600.0;
/// Upper end of the band that it measures in, Hz, less what the resolution of a spectrum takes away.
const BAND_END: f64 = 990.0;

/// The machine that a shaft is part of, as far as ISO 20816-3 asks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Machine {
    /// Its size.
    pub group: MachineGroup,
    /// Its support.
    pub support: MachineSupport,
}

/// The largest RMS velocity across the shaft, and its evaluation zone.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct VibrationSeverity {
    /// Standard and edition.
    pub standard: &'static str,
    /// Group of the machine, 1 or 2.
    pub group: u8,
    /// Its support.
    pub support: MachineSupport,
    /// Between zones A and B, B and C, C and D, m/s.
    #[serde(rename = "boundaries_m_s")]
    pub boundaries: [f64; 3],
    /// The velocity that is largest.
    #[serde(serialize_with = "Channel::serialize_with_unit")]
    pub channel: Channel,
    /// Its RMS.
    #[serde(flatten)]
    pub level: VelocityLevel,
    /// The zone that it lies in.
    pub zone: VibrationZone,
    /// What the standard says of it.
    pub meaning: &'static str,
    /// How far the standard holds here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
}

impl VibrationSeverity {
    /// Of a motion at a speed in rad/s: that of the housings, or of the shaft where none moves. None without a level.
    pub(super) fn of(machine: Machine, motion: &Motion, speed: f64) -> Option<Self> {
        let housings = motion.housing_velocity.iter();
        let mut levels: Vec<_> = housings.map(|each| (each.channel, each.level)).collect();
        let of_housing = !levels.is_empty();
        if !of_housing {
            let radial = motion.velocity.iter().take(2).enumerate();
            levels.extend(
                radial.filter_map(|(axis, level)| Some((Channel::Velocity(axis), (*level)?))),
            );
        }
        let largest = levels.into_iter();
        let (channel, level) = largest.max_by(|(_, a), (_, b)| a.rms.total_cmp(&b.rms))?;
        let boundaries = zone_boundaries(machine.group, machine.support);
        let zone = VibrationZone::of(level.rms, &boundaries);
        Some(Self {
            standard: STANDARD,
            group: match machine.group {
                MachineGroup::Large => 1,
                MachineGroup::Medium => 2,
            },
            support: machine.support,
            boundaries,
            channel,
            level,
            zone,
            meaning: zone.meaning(),
            remarks: remarks(of_housing, &level, speed * 60.0 / TAU),
        })
    }
}

/// How far the standard holds for a level at a speed in rpm.
fn remarks(of_housing: bool, level: &VelocityLevel, speed: f64) -> Vec<String> {
    let mut remarks = Vec::new();
    if !of_housing {
        remarks.push(
            "this is the velocity of the shaft: the zones speak of bearing housings, which most often move less; give the bearings \
             housings ([bearing.housing]) to see theirs"
                .to_owned(),
        );
    }
    let [slowest, fastest] = SPEEDS;
    if !(slowest..=fastest).contains(&speed) {
        remarks.push(format!(
            "the standard speaks of {slowest:.0} to {fastest:.0} rpm, and the shaft turns at {speed:.0} rpm"
        ));
    } else if speed < SLOW {
        remarks.push("below 600 rpm the standard measures from 2 Hz on".to_owned());
    }
    if level.band[1] < BAND_END {
        remarks.push(format!(
            "the samples show frequencies up to {:.0} Hz, and the standard counts those up to 1000 Hz",
            level.band[1]
        ));
    }
    remarks
}
