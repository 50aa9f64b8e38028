//! The trace as a figure: one panel for each freedom that moves.

use super::Decimator;
#[cfg(test)]
use super::ReportError;
use super::figure::{Axis, CURVE_BUCKETS, Curve, Figure, Panel, distinct};
use crate::analysis::Channel;
use crate::report::units::MICRO;
use crate::rotor::{FREEDOMS, Sample};

/// Height of up to three panels together, px.
const HEIGHT: u32 = 486;
/// Height of a panel of more, px.
const PANEL_HEIGHT: u32 = 120;

/// Collects the envelope of every moving freedom; its memory does not grow with the run.
#[derive(Debug, Clone)]
pub struct TraceFigure {
    panels: Vec<(Channel, Decimator)>,
    /// First and last time, s.
    time: Option<(f64, f64)>,
}

impl TraceFigure {
    /// For the first `freedoms` of x, y, z, θx, θy.
    pub fn new(freedoms: usize) -> Self {
        let channels = (0..freedoms.min(FREEDOMS)).map(Channel::Displacement);
        Self {
            panels: channels
                .map(|channel| (channel, Decimator::new(CURVE_BUCKETS)))
                .collect(),
            time: None,
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        let (start, _) = self.time.unwrap_or((sample.time, sample.time));
        self.time = Some((start, sample.time));
        for (channel, envelope) in &mut self.panels {
            if let Some(value) = channel.of(sample) {
                envelope.push(sample.time, MICRO * value);
            }
        }
    }

    /// Draws the SVG.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails.
    #[cfg(test)]
    pub fn draw(&self, title: &str) -> Result<String, ReportError> {
        self.figure("trace.svg", title).svg()
    }

    /// One panel below the other over the same time, which the last one names.
    pub(super) fn figure(&self, file: &str, title: &str) -> Figure {
        let time = match self.time {
            Some((start, end)) if end > start => start..end,
            _ => 0.0..1.0,
        };
        let count = self.panels.len();
        let height = match count {
            0..=3 => HEIGHT / count.max(1) as u32,
            _ => PANEL_HEIGHT,
        };
        let panel = |(index, (channel, envelope)): (usize, &(Channel, Decimator))| {
            let name = if index + 1 == count { "time in s" } else { "" };
            let curve = Curve::line(distinct(index), envelope.points().collect());
            let time = Axis::over(name, time.clone());
            Panel::of(time, axis_name(*channel), height, vec![curve])
        };
        let panels = self.panels.iter().enumerate().map(panel);
        Figure::new(file, title, 1, panels.collect())
    }
}

/// Quantity and unit, as `x in µm`.
fn axis_name(channel: Channel) -> String {
    let name = match channel {
        Channel::Displacement(3) => "θx",
        Channel::Displacement(4) => "θy",
        other => other.name(),
    };
    format!("{name} in µ{}", channel.unit())
}
