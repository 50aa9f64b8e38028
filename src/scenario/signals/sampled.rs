//! Samples of a channel at equal times, none of them missing.

use std::ops::Range;

use super::reader::SignalReader;
use super::{Issue, Problems};
use crate::record::{Gaps, RecordChannel, Sampling, at_even_times, bridge};
use crate::scenario::input::SignalInput;
use crate::scenario::quantity::{si, significant};

/// Part of a rate by which the one that is given may differ from that of the file.
pub(super) const ALMOST_THE_RATE: f64 = 1e-3;
/// Most missing samples that are bridged, as a part of all.
const MOST_MISSING: f64 = 0.1;
/// Missing samples in a row from which on a way around them is reported.
const LONG_GAP: f64 = 10.0;

/// Samples at equal times.
pub(super) struct SampledValues {
    /// Samples a second.
    pub rate: f64,
    /// Time of the first, s.
    pub start: f64,
    pub values: Vec<f64>,
}

impl SignalReader<'_> {
    /// The samples of a channel from the first to the last that is known, at equal times, none of them missing.
    pub(super) fn sampled(
        &self,
        channel: &mut RecordChannel,
        input: &SignalInput,
        problems: &mut Problems<'_>,
    ) -> Option<SampledValues> {
        let mut values = std::mem::take(&mut channel.samples);
        let count = values.len();
        let known = match known_range(&values) {
            Some(known) => known,
            None => {
                let message = format!("all samples of `{}` are missing", channel.name);
                problems.refuse(Issue::new(".column", message).help("leave it out"));
                return None;
            }
        };
        values.truncate(known.end);
        values.drain(..known.start);
        let mut found = self.at_equal_times(channel, input, values, &known, problems)?;
        let missing = [known.start, count - known.end];
        self.tell_cut(&channel.name, &found, missing, problems);
        self.bridge(&channel.name, &mut found, problems)?;
        Some(found)
    }

    /// The known values of a channel at the times that the file or the description says.
    fn at_equal_times(
        &self,
        channel: &RecordChannel,
        input: &SignalInput,
        values: Vec<f64>,
        known: &Range<usize>,
        problems: &mut Problems<'_>,
    ) -> Option<SampledValues> {
        let name = &channel.name;
        let given = si(&input.rate).or(si(&self.input.rate));
        let even = |rate: f64, start: f64, values| {
            let start = start + known.start as f64 / rate;
            SampledValues::new(rate, start, values)
        };
        Some(match (&channel.sampling, given) {
            (Sampling::Even { rate, start }, None) => even(*rate, *start, values),
            (Sampling::Even { rate, start }, Some(given)) => {
                if (given / rate - 1.0).abs() > ALMOST_THE_RATE {
                    problems.warn(format!(
                        "the file says that `{name}` has {} samples a second, and {} are taken as given",
                        significant(*rate),
                        significant(given)
                    ));
                }
                even(given, *start, values)
            }
            (sampling, Some(given)) => {
                if let Sampling::Times(times) = sampling
                    && let Some(gaps) = Gaps::find(times)
                {
                    let (behind, _) = gaps.gaps[0];
                    problems.warn(format!(
                        "by its times `{name}` lacks {} samples, the first behind {} s: at the rate that is given its parts follow one \
                         another without them",
                        gaps.missing(),
                        significant(times[behind - 1])
                    ));
                }
                even(given, 0.0, values)
            }
            (Sampling::Times(times), None) => {
                let times = &times[known.clone()];
                return match Gaps::find(times) {
                    Some(gaps) => self.with_gaps(name, times, values, gaps, problems),
                    None => self.uneven(name, times, values, problems),
                };
            }
            (Sampling::Unknown, None) => {
                problems.refuse(self.no_rate(name));
                return None;
            }
            (Sampling::Unordered(row), None) => {
                let message = format!("its times do not rise at row {row} of `{name}`");
                let help = "mend them, or give the `rate` if the samples are even";
                problems.refuse(Issue::new("", message).help(help));
                return None;
            }
        })
    }

    /// Values at uneven times, brought to their mean rate.
    fn uneven(
        &self,
        name: &str,
        times: &[f64],
        values: Vec<f64>,
        problems: &mut Problems<'_>,
    ) -> Option<SampledValues> {
        let (first, last) = (times[0], times[times.len() - 1]);
        let rate = (times.len() - 1) as f64 / (last - first);
        problems.warn(format!(
            "`{name}` was sampled at uneven times: it is brought to the mean rate of {} Hz on straight lines, which damps what is \
             above about a fifth of it; give the `rate` if the times are inexact and the samples even",
            significant(rate)
        ));
        let mut found = SampledValues::new(rate, first, values);
        self.bridge(name, &mut found, problems)?;
        found.values = at_even_times(times, &found.values, rate);
        Some(found)
    }

    /// Values at times with gaps, of which those within the part that is asked for are not too many: missing samples are NaN.
    fn with_gaps(
        &self,
        name: &str,
        times: &[f64],
        values: Vec<f64>,
        gaps: Gaps,
        problems: &mut Problems<'_>,
    ) -> Option<SampledValues> {
        let [from, to] = self.asked(times[0]);
        let behind = |gap: &&(usize, f64)| times[gap.0 - 1] < from;
        let before = |gap: &&(usize, f64)| times[gap.0] > to;
        let first = gaps.gaps.iter().rev().find(behind);
        let first = first.map_or(0, |gap| gap.0);
        let end = gaps.gaps.iter().filter(|gap| gap.0 > first).find(before);
        let end = end.map_or(values.len(), |gap| gap.0);
        let inner = gaps.gaps.iter().filter(|gap| first < gap.0 && gap.0 < end);
        let inner = inner.map(|(at, missing)| (at - first, *missing));
        let gaps = Gaps {
            gaps: inner.collect(),
            ..gaps
        };
        let (times, values) = (&times[first..end], &values[first..end]);
        if let Some((at, longest)) = gaps.longest() {
            let missing = Missing {
                count: gaps.missing(),
                all: values.len() as f64 + gaps.missing(),
                longest,
                beside: [times[at - 1], times[at]],
            };
            // before the places of a gap of days take memory
            missing.accept(name, problems)?;
        }
        Some(SampledValues::new(gaps.rate, times[0], gaps.filled(values)))
    }

    /// Bridges missing samples, if those of the part that is asked for are not too many, and tells them.
    fn bridge(
        &self,
        name: &str,
        found: &mut SampledValues,
        problems: &mut Problems<'_>,
    ) -> Option<()> {
        let place = |time: f64| ((time - found.start) * found.rate).round().max(0.0) as usize;
        let [from, end] = self.asked(found.start).map(place);
        let end = end.min(found.values.len());
        if let Some(missing) = Missing::within(found, from.min(end)..end) {
            missing.accept(name, problems)?;
            let way_around = missing.way_around().map(|way| format!("; {way}"));
            problems.warn(format!(
                "{}: they are bridged by straight lines, by which lines at half the rate lose up to {:.2} %{}",
                missing.reported(name),
                200.0 * missing.count / missing.all,
                way_around.unwrap_or_default()
            ));
        }
        bridge(&mut found.values);
        Some(())
    }

    /// Tells that samples are missing before the first and behind the last that is known, where they are asked for.
    fn tell_cut(
        &self,
        name: &str,
        found: &SampledValues,
        [before, behind]: [usize; 2],
        problems: &mut Problems<'_>,
    ) {
        let end = found.start + found.values.len() as f64 / found.rate;
        let [from, to] = self.asked(found.start - before as f64 / found.rate);
        // to the sample
        let near = 0.5 / found.rate;
        if before > 0 && from < found.start - near {
            problems.warn(format!(
                "the first {before} samples of `{name}` are missing: the record is analysed from {} s on",
                significant(found.start)
            ));
        }
        if behind > 0 && to > end + near {
            problems.warn(format!(
                "the last {behind} samples of `{name}` are missing: the record is analysed up to {} s",
                significant(end)
            ));
        }
    }

    /// First and last time, s, of the part that is asked for, of a channel that begins at a time.
    fn asked(&self, start: f64) -> [f64; 2] {
        let from = si(&self.input.start).map_or(start, |from| from.max(start));
        let duration = si(&self.input.duration).unwrap_or(f64::INFINITY);
        [from, from + duration]
    }
}

/// Samples that are missing in a part of a channel.
struct Missing {
    count: f64,
    /// How many the part has with them.
    all: f64,
    /// Most in a row, and the times in s of the samples on either side of these.
    longest: f64,
    beside: [f64; 2],
}

impl Missing {
    /// Those within a range of samples; `None` where there are none.
    fn within(found: &SampledValues, range: Range<usize>) -> Option<Self> {
        let all = range.len() as f64;
        let known = found.values[range.clone()].iter().enumerate();
        let known = known.filter(|(_, value)| value.is_finite());
        // a sample before the first and one behind the last count as known
        let known = known.map(|(place, _)| (range.start + place) as f64);
        let ends = [range.start as f64 - 1.0, range.end as f64];
        let (mut count, mut longest, mut last) = (0.0, 0.0, ends[0]);
        let mut beside = ends;
        for place in known.chain([ends[1]]) {
            let missing = place - last - 1.0;
            count += missing;
            if missing > longest {
                (longest, beside) = (missing, [last, place]);
            }
            last = place;
        }
        (count > 0.0).then(|| Self {
            count,
            all,
            longest,
            beside: beside.map(|place| found.start + place / found.rate),
        })
    }

    /// Refuses too many.
    fn accept(&self, name: &str, problems: &mut Problems<'_>) -> Option<()> {
        if self.count <= MOST_MISSING * self.all {
            return Some(());
        }
        let message = format!(
            "{}: up to {:.0} % are bridged",
            self.reported(name),
            100.0 * MOST_MISSING
        );
        let leave_out = || "leave the channel out, or record it without losses".to_owned();
        let help = self.way_around().unwrap_or_else(leave_out);
        problems.refuse(Issue::new("", message).help(help));
        None
    }

    fn reported(&self, name: &str) -> String {
        let [before, behind] = self.beside.map(significant);
        format!(
            "of {} samples of `{name}` {} ({:.2} %) are missing, at most {} in a row, from {before} to {behind} s",
            self.all,
            self.count,
            100.0 * self.count / self.all,
            self.longest,
        )
    }

    /// How a part without a long gap is analysed.
    fn way_around(&self) -> Option<String> {
        let behind = significant(self.beside[1]);
        (self.longest > LONG_GAP).then(|| {
            format!(
                "a part without them is analysed with `--start` and `--duration`, as with --start \"{behind} s\""
            )
        })
    }
}

impl SampledValues {
    fn new(rate: f64, start: f64, values: Vec<f64>) -> Self {
        Self {
            rate,
            start,
            values,
        }
    }
}

/// From the first to the last value that is known.
pub(super) fn known_range(values: &[f64]) -> Option<Range<usize>> {
    let first = values.iter().position(|value| value.is_finite())?;
    let last = values.iter().rposition(|value| value.is_finite())?;
    Some(first..last + 1)
}
