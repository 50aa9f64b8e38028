//! The spectra with their named peaks.

use serde_json::{Value, json};

use super::curve::{Panel, curve, prominent};
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum};
use crate::report::spectrum::frequency_limit;
use crate::report::terminal::MICRO;

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

/// Bins to draw, the mean left out.
fn prominent_bins(members: &[&ChannelSpectrum]) -> Vec<usize> {
    let bins = members.first().map_or(0, |entry| entry.amplitude.len());
    prominent((1..bins).collect(), |bin| {
        let amplitudes = members.iter().map(|entry| entry.amplitude[bin]);
        amplitudes.fold(0.0, f64::max)
    })
}
