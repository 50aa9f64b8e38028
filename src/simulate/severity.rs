//! The vibration of a run, judged by the zones of ISO 20816-3.

use std::fmt::Display;

use serde::Serialize;

use crate::analysis::{Channel, ChannelLevel, Motion, VelocityLevel};
use crate::physics::{
    MachineGroup, MachineSupport, PER_MINUTE, VibrationZone, velocity_band, zone_boundaries,
};

/// Edition of the tables in [`zone_boundaries`].
const STANDARD: &str = "ISO 20816-3:2022";
/// Speeds that the standard speaks of, rpm.
const SPEEDS: [f64; 2] = [120.0, 30_000.0];
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
    /// Of a motion at a speed in rad/s: that of the housings, or of the shaft where none moves.
    ///
    /// # Errors
    /// Why there is no zone: the standard does not speak of the speed, or the record does not hold its band.
    pub(super) fn from_motion(
        machine: Machine,
        motion: &Motion,
        speed: f64,
    ) -> Result<Self, String> {
        let length = motion.end - motion.start + 1.0 / motion.rate;
        let longer = |by| {
            format!(
                "{length:.3} s, the whole revolutions after the settle time, do not show them: make `duration` longer by {by:.2} s or \
                 more"
            )
        };
        let finer =
            |samples| format!("set samples_per_revolution = {samples:.0} or more in [output]");
        covered(speed, [length, motion.rate], longer, finer)?;
        let housings = motion.housing_velocity.iter();
        let mut levels: Vec<_> = housings.map(|each| (each.channel, each.level)).collect();
        let of_housing = !levels.is_empty();
        if !of_housing {
            let radial = motion.velocity.iter().take(2).enumerate();
            levels.extend(
                radial.filter_map(|(axis, level)| Some((Channel::Velocity(axis), (*level)?))),
            );
        }
        let remarks = (!of_housing).then(|| OF_SHAFT.to_owned());
        Self::of_largest(machine, levels, remarks.into_iter().collect())
    }

    /// Of measured velocities at a speed in rad/s: of records of a length in s with so many samples a second.
    ///
    /// # Errors
    /// As [`Self::from_motion`].
    pub(crate) fn from_levels(
        machine: Machine,
        levels: &[ChannelLevel],
        speed: f64,
        [length, rate]: [f64; 2],
    ) -> Result<Self, String> {
        let longer =
            |by| format!("the record of {length:.3} s does not show them: it takes {by:.2} s more");
        let finer = |_| format!("it takes {:.0} Hz", 2.0 * velocity_band(speed)[1]);
        covered(speed, [length, rate], longer, finer)?;
        let levels = levels.iter().map(|each| (each.channel, each.level));
        Self::of_largest(machine, levels.collect(), Vec::new())
    }

    /// The zone of the largest of some levels.
    fn of_largest(
        machine: Machine,
        levels: Vec<(Channel, VelocityLevel)>,
        remarks: Vec<String>,
    ) -> Result<Self, String> {
        let largest = levels.into_iter();
        let largest = largest.max_by(|(_, a), (_, b)| a.rms.total_cmp(&b.rms));
        let (channel, level) = largest.ok_or_else(|| refused(TOO_FEW))?;
        let boundaries = zone_boundaries(machine.group, machine.support);
        let zone = VibrationZone::from_velocity(level.rms, &boundaries);
        let zone = zone.ok_or_else(|| refused("the RMS velocity is not a number"))?;
        Ok(Self {
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
            remarks,
        })
    }
}

/// What is said of a level of the shaft.
const OF_SHAFT: &str = "this is the velocity of the shaft: the zones speak of bearing housings, which most often move less; \
    give the bearings housings ([bearing.housing]) to see theirs";
/// What is said of a record without a level.
const TOO_FEW: &str = "the samples are too few";
/// Revolutions that keep the line of the shaft away from the mean.
const FEWEST_REVOLUTIONS: f64 = 2.0;

/// Why there is no zone.
fn refused(why: impl Display) -> String {
    format!("no zone of {STANDARD}: {why}")
}

/// Whether the standard speaks of a speed in rad/s, and a record at it is long and fine enough; what to do where it is too short
/// by a time in s, or has too few samples a revolution.
fn covered(
    speed: f64,
    [length, rate]: [f64; 2],
    longer: impl Fn(f64) -> String,
    finer: impl Fn(f64) -> String,
) -> Result<(), String> {
    let rpm = speed.abs() * PER_MINUTE;
    let [slowest, fastest] = SPEEDS;
    if !(slowest * (1.0 - 1e-9)..=fastest * (1.0 + 1e-9)).contains(&rpm) {
        return Err(refused(format!(
            "it speaks of {slowest:.0} to {fastest:.0} rpm, and the shaft turns at {rpm:.0} rpm"
        )));
    }
    let [low, high] = velocity_band(speed);
    let least = (1.0 / low).max(FEWEST_REVOLUTIONS * 60.0 / rpm);
    if length < least * (1.0 - 1e-9) {
        let advice = longer(least - length + 60.0 / rpm);
        return Err(refused(format!(
            "at {rpm:.0} rpm it counts frequencies from {low:.0} Hz on, and {advice}"
        )));
    }
    if rate < 2.0 * high * (1.0 - 1e-9) {
        let advice = finer((2.0 * high * 60.0 / rpm).ceil());
        return Err(refused(format!(
            "it counts frequencies up to {high:.0} Hz, and the samples show those up to {:.0} Hz: {advice}",
            0.5 * rate
        )));
    }
    Ok(())
}
