//! What is drawn over time: its envelope, with parts of it sample by sample.

use std::collections::VecDeque;

use crate::analysis::Channel;
use crate::report::envelope::{Decimator, SCREEN_BUCKETS};
use crate::report::figure::{Axis, Curve, Figure, Panel, distinct};
use crate::report::terminal::shown_column;
use crate::rotor::{Freedoms, Sample};

/// Height of up to four panels of a figure together, px.
const HEIGHT: u32 = 440;
/// Samples at the end that are shown one by one.
const LAST: usize = 2048;
/// Samples before and after an event that are.
const AROUND: usize = 256;
/// What changes by less than this part of the largest value of its unit does not change.
const ROUND_OFF: f64 = 1e-9;
/// Events around which they are: the first ones.
const MOST_EVENTS: usize = 4;

/// A column of the samples over time: whole where it is short; of a long run the band that it stays in, and in full
/// its end and what is around events.
#[derive(Debug, Clone)]
struct History {
    channel: Channel,
    envelope: Decimator,
    /// Times and values of the last samples.
    last: VecDeque<(f64, f64)>,
    /// Times and values of the samples around events.
    segments: Vec<Vec<(f64, f64)>>,
}

/// A place of a history: its value, or the lowest and the highest value around it.
struct Place {
    time: f64,
    value: f64,
    band: [f64; 2],
}

/// What is drawn besides displacements and forces.
const FURTHER: [Channel; 5] = [
    Channel::LargestBallLoad,
    Channel::BallsLoaded,
    Channel::Speed,
    Channel::KINETIC_ENERGY,
    Channel::STORED_ENERGY,
];

/// Every quantity that figure and page draw over time.
#[derive(Debug, Clone)]
pub struct Histories {
    histories: Vec<History>,
    /// First and last time, s.
    time: Option<[f64; 2]>,
    /// Samples that the segment around an event still takes.
    open: usize,
}

impl Histories {
    /// For the freedoms that move.
    pub fn new(freedoms: Freedoms) -> Self {
        let moving = Channel::of_freedoms(freedoms).into_iter();
        Self {
            histories: moving.chain(FURTHER).map(History::new).collect(),
            time: None,
            open: 0,
        }
    }

    /// Of columns at equal times, the first values at a time in s.
    pub(in crate::report) fn of_columns<'a>(
        columns: impl Iterator<Item = (Channel, &'a [f64])>,
        start: f64,
        rate: f64,
    ) -> Self {
        let mut found = Self {
            histories: Vec::new(),
            time: None,
            open: 0,
        };
        for (channel, values) in columns {
            let mut history = History::new(channel);
            for (index, value) in values.iter().enumerate() {
                history.take(start + index as f64 / rate, *value, false);
            }
            found.time = Some([start, start + values.len().saturating_sub(1) as f64 / rate]);
            found.histories.push(history);
        }
        found
    }

    /// A panel for each.
    pub(in crate::report) fn all(&self, name: &str, title: &str) -> Figure {
        self.panels(name, title, self.histories.iter().collect())
    }

    /// Takes note of an event since the last sample.
    pub fn event(&mut self) {
        if self.open > 0 {
            return;
        }
        for history in &mut self.histories {
            if history.segments.len() < MOST_EVENTS {
                let before = history.last.len().saturating_sub(AROUND);
                let before = history.last.iter().skip(before).copied();
                history.segments.push(before.collect());
                self.open = AROUND;
            }
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        let [start, _] = self.time.unwrap_or([sample.time; 2]);
        self.time = Some([start, sample.time]);
        for history in &mut self.histories {
            if let Some(value) = history.channel.value(sample) {
                history.take(sample.time, value, self.open > 0);
            }
        }
        self.open = self.open.saturating_sub(1);
    }

    /// A panel for each displacement, one below the other over the same time.
    pub(crate) fn displacements(&self, name: &str, title: &str) -> Figure {
        let displacements = self.histories.iter().filter(|own| own.is_displacement());
        self.panels(name, title, displacements.collect())
    }

    /// A panel for each other quantity of a page, but for what is unknown and for what does not change, no more than
    /// round-off compared with the largest value of its unit.
    pub(in crate::report) fn others(&self, title: &str) -> Option<Figure> {
        let others = || self.histories.iter().filter(|own| !own.is_displacement());
        let magnitude = |unit: &str| {
            let alike = others().filter(|history| history.channel.unit() == unit);
            let magnitudes = alike.map(|history| history.envelope.magnitude());
            magnitudes.fold(0.0, f64::max)
        };
        let changing = others().filter(|history| {
            let round_off = ROUND_OFF * magnitude(history.channel.unit());
            let range = history.envelope.range();
            range.is_some_and(|[low, high]| high - low > round_off)
        });
        let figure = self.panels("histories", title, changing.collect());
        (!figure.panels.is_empty()).then(|| figure.only_on_page())
    }

    fn panels(&self, name: &str, title: &str, histories: Vec<&History>) -> Figure {
        let time = match self.time {
            Some([start, end]) if end > start => start..end,
            _ => 0.0..1.0,
        };
        let height = HEIGHT / histories.len().clamp(1, 4) as u32;
        let panels = histories.iter().enumerate().map(|(index, history)| {
            let (label, scale) = shown_column(&history.channel.column());
            let time = Axis::over(shown_column(&Channel::Time.column()).0, time.clone());
            Panel::holding(time, label, height, vec![history.curve(index, scale)])
        });
        Figure::new(name, title, 1, panels.collect())
    }
}

impl History {
    fn new(channel: Channel) -> Self {
        Self {
            channel,
            envelope: Decimator::new(SCREEN_BUCKETS),
            last: VecDeque::with_capacity(LAST),
            segments: Vec::new(),
        }
    }

    fn is_displacement(&self) -> bool {
        matches!(self.channel, Channel::Displacement(_))
    }

    fn take(&mut self, time: f64, value: f64, near_event: bool) {
        self.envelope.push(time, value);
        if self.last.len() == LAST {
            self.last.pop_front();
        }
        self.last.push_back((time, value));
        if let Some(segment) = self.segments.last_mut().filter(|_| near_event) {
            segment.push((time, value));
        }
    }

    /// The segments that are known sample by sample, in order, none over another.
    fn in_full(&self) -> Vec<Vec<(f64, f64)>> {
        let last = self.last.iter().copied().collect();
        let mut until = f64::NEG_INFINITY;
        let mut segments: Vec<Vec<(f64, f64)>> = Vec::new();
        for mut segment in self.segments.iter().cloned().chain([last]) {
            segment.retain(|(time, _)| *time > until);
            until = segment.last().map_or(until, |(time, _)| *time);
            segments.push(segment);
        }
        segments.retain(|segment| !segment.is_empty());
        segments
    }

    /// Values where they are known one by one, elsewhere the band: joining the extremes of a bucket by lines would
    /// show a wave that there is not.
    fn places(&self) -> Vec<Place> {
        let segments = self.in_full();
        let known = |time: f64| {
            let mut segments = segments.iter();
            segments.any(|segment| segment[0].0 <= time && time <= segment[segment.len() - 1].0)
        };
        let band = self.envelope.buckets().map(|bucket| Place {
            time: 0.5 * (bucket.first.0 + bucket.last.0),
            value: f64::NAN,
            band: [bucket.low(), bucket.high()],
        });
        let single = segments.iter().flat_map(|segment| {
            let end = segment.len() - 1;
            segment
                .iter()
                .enumerate()
                .map(move |(index, &(time, value))| {
                    // the band reaches to where single values begin, so that there is no gap between them
                    let band = match index == 0 || index == end {
                        true => self.band_about(time),
                        false => [f64::NAN; 2],
                    };
                    Place { time, value, band }
                })
        });
        let band = band.filter(|place| !known(place.time));
        let mut places: Vec<Place> = band.chain(single).collect();
        places.sort_by(|a, b| a.time.total_cmp(&b.time));
        places
    }

    /// Lowest and highest value of the buckets before and after a time.
    fn band_about(&self, time: f64) -> [f64; 2] {
        let buckets: Vec<_> = self.envelope.buckets().collect();
        let after = buckets.partition_point(|bucket| bucket.first.0 < time);
        let both = buckets[after.saturating_sub(1)..].iter().take(2);
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        both.fold(none, |[low, high], bucket| {
            [low.min(bucket.low()), high.max(bucket.high())]
        })
    }

    /// Its values times `scale`: all of a short one, of a long one what is known one by one and the band elsewhere.
    fn curve(&self, index: usize, scale: f64) -> Curve {
        if self.envelope.is_whole() {
            let points = self.envelope.points();
            let points = points.map(|(time, value)| (time, scale * value));
            return Curve::line(distinct(index), points.collect());
        }
        let places = self.places();
        let points = places.iter().map(|place| (place.time, scale * place.value));
        let band = places
            .iter()
            .map(|place| place.band.map(|edge| scale * edge));
        Curve {
            band: band.collect(),
            ..Curve::line(distinct(index), points.collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A long wave is a band, its last samples and those around an event are itself.
    #[test]
    fn a_long_history_shows_no_wave_that_there_is_not() {
        let wave = |time: f64| (std::f64::consts::TAU * 50.0 * time).sin();
        let mut histories = Histories::new(Freedoms::Radial);
        for n in 0..200_000 {
            let time = f64::from(n) * 1e-3 / 6.4;
            if n == 100_000 {
                histories.event();
            }
            histories.sample(&Sample {
                time,
                displacement: [wave(time), 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
        }
        let places = histories.histories[0].places();
        let known = places.iter().filter(|place| !place.value.is_nan());
        assert_eq!(known.clone().count(), LAST + 2 * AROUND);
        for place in known {
            assert_eq!(place.value, wave(place.time));
        }
        for place in places.iter().filter(|place| place.value.is_nan()) {
            assert!(
                place.band[0] < -0.9 && place.band[1] > 0.9,
                "{}",
                place.time
            );
        }
        assert!(places.is_sorted_by(|a, b| a.time <= b.time));
        // between neighbours there is always a line or a band: no time is without either
        let is_drawn = |a: &Place, b: &Place| {
            let both = |value: fn(&Place) -> f64| !value(a).is_nan() && !value(b).is_nan();
            both(|place| place.value) || both(|place| place.band[0])
        };
        let gaps = places
            .windows(2)
            .filter(|pair| !is_drawn(&pair[0], &pair[1]));
        assert_eq!(gaps.count(), 0);
    }
}
