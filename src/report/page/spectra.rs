//! The spectra with their named peaks.

use serde_json::{Value, json};

use super::curve::{BUCKETS, Panel, curve};
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum};
use crate::report::figure_spectrum::frequency_limit;

/// m → µm, rad → µrad.
const MICRO: f64 = 1e6;

/// Spectra of one unit: name of the panel, unit of the channels, unit shown, and how many of it make one
/// of theirs.
struct Group {
    name: &'static str,
    unit: &'static str,
    shown: &'static str,
    factor: f64,
}

const GROUPS: [Group; 4] = [
    Group {
        name: "displacement",
        unit: "m",
        shown: "µm",
        factor: MICRO,
    },
    Group {
        name: "tilt",
        unit: "rad",
        shown: "µrad",
        factor: MICRO,
    },
    Group {
        name: "force",
        unit: "N",
        shown: "N",
        factor: 1.0,
    },
    Group {
        name: "moment",
        unit: "N m",
        shown: "N m",
        factor: 1.0,
    },
];

/// One panel for each unit that there is.
pub(super) fn panels(spectrum: &Spectrum, peaks: &[Peak]) -> Vec<Value> {
    let panels = GROUPS
        .iter()
        .filter_map(|group| group.panel(spectrum, peaks));
    panels.collect()
}

impl Group {
    fn holds(&self, channel: Channel) -> bool {
        channel.unit() == self.unit
    }

    fn panel(&self, spectrum: &Spectrum, peaks: &[Peak]) -> Option<Value> {
        let members: Vec<_> = spectrum
            .channels
            .iter()
            .filter(|entry| self.holds(entry.channel))
            .collect();
        members.first()?;
        let bins = prominent_bins(&members);
        let curves = members.iter().map(|entry| {
            let points = bins
                .iter()
                .map(|&k| (spectrum.frequency(k), self.factor * entry.amplitude[k]));
            curve(entry.channel.name(), points)
        });
        let named = peaks.iter().filter(|peak| self.holds(peak.channel));
        let marks = named.filter_map(|peak| {
            Some(json!({
                "at": peak.frequency,
                "height": self.factor * peak.amplitude,
                "name": peak.line?.kind.to_string(),
            }))
        });
        let panel = Panel {
            name: self.name,
            unit: self.shown,
            over: ["frequency", "Hz"],
            shown: Some(frequency_limit(spectrum, peaks)),
            logarithmic: true,
        };
        Some(panel.json(curves.collect(), marks.collect()))
    }
}

/// Bins to draw, the mean left out: all of them or, of too many, from every stretch the one where a
/// channel is strongest and the one where none is.
fn prominent_bins(members: &[&ChannelSpectrum]) -> Vec<usize> {
    let bins = members.first().map_or(0, |entry| entry.amplitude.len());
    let all: Vec<usize> = (1..bins).collect();
    let stretch = all.len().div_ceil(BUCKETS);
    if stretch <= 2 {
        return all;
    }
    let height = |k: &usize| {
        let amplitudes = members.iter().map(|entry| entry.amplitude[*k]);
        amplitudes.fold(0.0, f64::max)
    };
    let by_height = |a: &&usize, b: &&usize| height(a).total_cmp(&height(b));
    all.chunks(stretch)
        .flat_map(|stretch| {
            let lowest = stretch.iter().min_by(by_height).copied();
            let highest = stretch.iter().max_by(by_height).copied();
            let [first, last] = [lowest.min(highest), lowest.max(highest)];
            first.into_iter().chain(last.filter(|_| first != last))
        })
        .collect()
}
