//! Takes the samples for the statistics of a steady motion and the maps of a run-up.

use std::f64::consts::TAU;

use super::run_up::{RunUp, RunUpRecorder};
use super::{Analyses, Model, MotionAnalysis};
use crate::analysis::{
    Channel, Motion, MotionRecorder, MotionSettings, OrderTracks, SectionKind, TrackRecorder,
    TrackedOrder, Waterfall, WaterfallRecorder,
};
use crate::integrate::Grid;
use crate::physics::velocity_band;
use crate::rotor::{FREEDOMS, Rotor, Sample};

/// Shaft orders that are tracked.
const SHAFT_ORDERS: u32 = 3;
/// Shaft orders that a waterfall reaches up to at the highest speed.
const SHOWN_ORDERS: f64 = 10.0;
/// Multiples of the highest ball-pass frequency that it reaches up to.
const SHOWN_PASSES: f64 = 2.5;
/// Windows of a waterfall in the duration: fewest and most.
const WINDOWS: [f64; 2] = [8.0, 64.0];
/// Revolutions at the highest speed that tell its orders apart in a window, and windows that are left to a
/// short run for it.
const FEWEST_REVOLUTIONS: f64 = 4.0;
const LEAST_WINDOWS: f64 = 4.0;
/// Shortest and longest windows of the order tracks, in revolutions, and in parts of √(2R) of R revolutions of the run: in a
/// linear run-up a vibration of two thirds of the highest speed rings for about half of that while its order passes.
const TRACK_REVOLUTIONS: [f64; 2] = [4.0, 16.0];
const TRACK_PARTS: [f64; 2] = [1.0 / 6.0, 1.0 / 3.0];

/// Maps of a run whose speed changes.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Maps {
    /// Short-time spectra.
    pub waterfall: Waterfall,
    /// Orders of the shaft's angle.
    pub tracks: OrderTracks,
}

/// Takes the samples for what was asked for.
pub(super) struct Recorders {
    motion: Option<MotionRecorder>,
    maps: Option<(WaterfallRecorder, TrackRecorder)>,
    run_up: Option<RunUpRecorder>,
}

impl Recorders {
    pub fn new(model: &Model, rotor: &Rotor, grid: &Grid) -> Self {
        let Analyses { motion, maps, .. } = model.analyses;
        let steady = rotor.steady_from(model.settle);
        let steady = steady.filter(|_| motion != MotionAnalysis::None);
        Self {
            motion: steady.map(|speed| MotionRecorder::new(settings(model, rotor, grid, speed))),
            maps: maps.then(|| maps_of(model, rotor, 1.0 / grid.interval)),
            run_up: RunUpRecorder::new(model, rotor),
        }
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        if let Some(motion) = &mut self.motion {
            motion.record(sample);
        }
        if let Some((waterfall, tracks)) = &mut self.maps {
            waterfall.record(sample);
            tracks.record(sample);
        }
        if let Some(run_up) = &mut self.run_up {
            run_up.record(sample);
        }
    }

    pub fn finish(self) -> (Option<Motion>, Option<Maps>, Option<RunUp>) {
        let maps = self.maps.map(|(waterfall, tracks)| Maps {
            waterfall: waterfall.finish(),
            tracks: tracks.finish(),
        });
        let motion = self.motion.and_then(MotionRecorder::finish);
        (motion, maps, self.run_up.and_then(RunUpRecorder::finish))
    }
}

fn settings(model: &Model, rotor: &Rotor, grid: &Grid, speed: f64) -> MotionSettings {
    let scale = rotor.motion_scale(model.integrator.tolerance);
    let mut sections = Vec::new();
    let motion = model.analyses.motion;
    if speed > 0.0 {
        sections.push((SectionKind::Revolution, 1.0));
        let passing = rotor.ball_pass_orders().first().copied();
        sections.extend(passing.map(|[outer, _]| (SectionKind::BallPass, outer)));
        if let MotionAnalysis::Statistics(asked) = motion {
            sections.retain(|(kind, _)| asked == Some(*kind));
        }
    }
    let end = grid.time(grid.count - 1);
    MotionSettings {
        freedoms: rotor.freedoms(),
        start: whole_revolutions(model.settle, end, speed, grid.interval),
        end,
        rate: 1.0 / grid.interval,
        levers: std::array::from_fn::<_, FREEDOMS, _>(|axis| scale.lever(axis)),
        sections,
        parts: Channel::of_parts(&model.rotor),
        housing_velocities: housing_velocities(model),
        revolution: (speed > 0.0).then(|| TAU / speed),
        passes: rotor
            .ball_pass_orders()
            .iter()
            .map(|pass| pass[0])
            .collect(),
        velocity_band: model.analyses.velocities.then(|| velocity_band(speed)),
        kind: motion == MotionAnalysis::Kind,
    }
}

/// Velocities along X and Y of the housings that have columns.
fn housing_velocities(model: &Model) -> Vec<Channel> {
    Channel::of_bodies(&model.rotor, 2)
        .filter(|channel| channel.is_housing_velocity())
        .collect()
}

/// Where the last whole revolutions begin, behind the sample that they begin after: the end of one is
/// the begin of the next, and counts once.
fn whole_revolutions(settle: f64, end: f64, speed: f64, interval: f64) -> f64 {
    let revolutions = ((end - settle) * speed / TAU + 1e-9).floor();
    if revolutions < 1.0 {
        return settle;
    }
    end - revolutions * TAU / speed + 0.5 * interval
}

/// What takes the maps of a run at so many samples a second.
pub(super) fn maps_of(
    model: &Model,
    rotor: &Rotor,
    rate: f64,
) -> (WaterfallRecorder, TrackRecorder) {
    let lengths = 0..rotor.freedoms().lengths();
    let channels: Vec<Channel> = lengths.map(Channel::Displacement).collect();
    let passes = rotor.ball_pass_orders();
    let shaft = rotor.highest_speed() / TAU;
    let pass = passes.iter().map(|pass| pass[0]).fold(1.0, f64::max);
    let modes = rotor.natural_frequencies();
    let natural = modes.iter().map(|mode| mode.frequency).fold(0.0, f64::max);
    // a machine without known speeds shows all that the sampling has
    let wanted = [
        SHOWN_ORDERS * shaft,
        SHOWN_PASSES * pass * shaft,
        1.5 * natural,
    ];
    let limit = wanted.into_iter().fold(0.0, f64::max);
    let limit = if limit > 0.0 { limit } else { rate };
    let window = waterfall_window(model, rotor);
    let orders = tracked_orders(&passes, &rotor.excited_orders());
    let revolutions = track_window(model, rotor, &orders);
    let half = 0.5 * rate / shaft;
    let tracks = TrackRecorder::new(orders, channels.clone(), revolutions, half);
    let waterfall = WaterfallRecorder::new(channels, rate, window, limit);
    (waterfall, tracks)
}

/// Within a window T a line that sweeps at a Hz/s moves by a T; it is sharpest where that is the
/// resolution 1/T, at T = 1/√a, here of twice the shaft's frequency: ball passes want a shorter one, the
/// shaft itself a longer one.
fn waterfall_window(model: &Model, rotor: &Rotor) -> f64 {
    let points: Vec<_> = rotor.speed_profile().points().collect();
    let sweeps = points.windows(2).map(|pair| {
        let change = (pair[1].speed - pair[0].speed).abs();
        2.0 * change / (pair[1].time - pair[0].time) / TAU
    });
    let fastest = sweeps.fold(0.0, f64::max);
    let [fewest, most] = WINDOWS;
    let sharpest = if fastest > 0.0 {
        fastest.sqrt().recip()
    } else {
        model.duration / fewest
    };
    let revolutions = match rotor.highest_speed() {
        0.0 => 0.0,
        highest => FEWEST_REVOLUTIONS * TAU / highest,
    };
    sharpest
        .clamp(model.duration / most, model.duration / fewest)
        .max(revolutions)
        .min(model.duration / LEAST_WINDOWS)
}

/// Revolutions of the shaft in a run; of one with a drive about as many.
pub(super) fn revolutions(model: &Model, rotor: &Rotor) -> f64 {
    let angle = match rotor.is_driven() {
        true => 0.5 * rotor.highest_speed() * model.duration,
        false => rotor.speed_profile().at(model.duration).angle,
    };
    angle.abs() / TAU
}

/// Revolutions of a window: as few as tell the orders apart, as far as the sweep leaves time for it.
fn track_window(model: &Model, rotor: &Rotor, orders: &[TrackedOrder]) -> f64 {
    let [least, most] = TRACK_REVOLUTIONS;
    let passing = TRACK_PARTS.map(|part| part * (2.0 * revolutions(model, rotor)).sqrt());
    let [shortest, longest] = passing.map(|revolutions| revolutions.round().clamp(least, most));
    let mut places: Vec<f64> = orders.iter().map(|order| order.order).collect();
    places.sort_by(f64::total_cmp);
    let apart = places.windows(2).map(|pair| 2.0 / (pair[1] - pair[0]));
    let needed = apart.filter(|revolutions| *revolutions <= longest);
    needed.fold(shortest, f64::max).ceil()
}

/// The first shaft orders, those that loads excite, and the ball passes of every bearing at both races.
pub(crate) fn tracked_orders(passes: &[[f64; 2]], excited: &[f64]) -> Vec<TrackedOrder> {
    let mut orders: Vec<TrackedOrder> = (1..=SHAFT_ORDERS)
        .map(|order| TrackedOrder {
            name: format!("{order}×"),
            order: f64::from(order),
        })
        .collect();
    for &order in excited {
        if !orders.iter().any(|known| known.order == order) {
            orders.push(TrackedOrder {
                name: format!("{order}×"),
                order,
            });
        }
    }
    for (index, pass) in passes.iter().enumerate() {
        if passes[..index].contains(pass) {
            continue;
        }
        let of = match index {
            0 => String::new(),
            _ => format!(" of bearing {}", index + 1),
        };
        let [outer, inner] = *pass;
        for (name, order) in [("BPFO", outer), ("BPFI", inner), ("2×BPFO", 2.0 * outer)] {
            orders.push(TrackedOrder {
                name: format!("{name}{of}"),
                order,
            });
        }
    }
    orders.retain(|order| order.order > 0.0);
    orders
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_of_loads_are_tracked_once() {
        let orders = tracked_orders(&[[3.5, 5.5]], &[2.5, 2.0, 2.5]);
        let orders: Vec<f64> = orders.iter().map(|own| own.order).collect();
        assert_eq!(orders, [1.0, 2.0, 3.0, 2.5, 3.5, 5.5, 7.0]);
    }
}
