//! A peak of a spectrum and what it is called.

use serde::Serialize;

use crate::analysis::{Peak, Spectrum};

/// A peak, the line that it is named after, and how far it is from it.
#[derive(Debug, Serialize)]
pub(super) struct NamedPeak<'a> {
    pub channel: &'a str,
    pub unit: &'a str,
    #[serde(rename = "frequency_Hz")]
    pub frequency: f64,
    /// Multiple of the shaft's frequency; none where it stands still or its speed changes.
    pub order: Option<f64>,
    pub amplitude: f64,
    #[serde(rename = "phase_rad")]
    pub phase: f64,
    pub name: Option<String>,
    #[serde(rename = "name_Hz")]
    pub name_frequency: Option<f64>,
    /// Of the peak from the line that it is named after.
    #[serde(rename = "distance_Hz")]
    pub distance: Option<f64>,
    pub distance_bins: Option<f64>,
    /// Where the same line stands with the cage rolling at the operating contact angle.
    #[serde(rename = "operating_Hz")]
    pub operating: Option<f64>,
    /// What else the peak could be called, nearest first.
    pub other_names: Vec<String>,
}

impl<'a> NamedPeak<'a> {
    /// Of a spectrum.
    pub fn new(peak: &'a Peak, spectrum: Option<&Spectrum>) -> Self {
        let turning = spectrum.filter(|spectrum| spectrum.shaft_frequency > 0.0);
        let distance = peak.line.map(|line| peak.frequency - line.frequency);
        let bins = |(distance, spectrum): (f64, &Spectrum)| distance / spectrum.resolution;
        let others = peak.others.iter();
        Self {
            channel: peak.channel.name(),
            unit: peak.channel.unit(),
            frequency: peak.frequency,
            order: turning.map(|spectrum| peak.frequency / spectrum.shaft_frequency),
            amplitude: peak.amplitude,
            phase: peak.phase,
            name: peak.line.map(|line| line.kind.to_string()),
            name_frequency: peak.line.map(|line| line.frequency),
            distance,
            distance_bins: distance.zip(spectrum).map(bins),
            operating: peak.line.and_then(|line| line.operating),
            other_names: others.map(|line| line.kind.to_string()).collect(),
        }
    }
}
