//! Made-up motions, recorded as a run would.

use crate::analysis::{
    Axis, Channel, Detrend, EstimateError, EstimatedSpectrum, Recording, SampleGrid, Scaling,
    Segment, SpectrumKind, SpectrumQuantity, SpectrumRequest, Window, estimate,
};
use crate::rotor::Sample;

pub const X: Channel = Channel::Displacement(0);
pub const Y: Channel = Channel::Displacement(1);

/// Samples a second.
pub const RATE: f64 = 1024.0;

/// Motion at an instant: angle and speed of the shaft, then x, y with derivatives.
pub struct Motion {
    pub turning: [f64; 2],
    pub displacement: [f64; 2],
    pub velocity: [f64; 2],
    pub acceleration: [f64; 2],
}

impl Motion {
    /// Of a shaft that stands.
    pub fn places(displacement: [f64; 2]) -> Self {
        Self {
            turning: [0.0; 2],
            displacement,
            velocity: [0.0; 2],
            acceleration: [0.0; 2],
        }
    }
}

pub fn request(kind: SpectrumKind, channels: &[Channel], scaling: Scaling) -> SpectrumRequest {
    SpectrumRequest {
        name: "test".to_owned(),
        kind,
        channels: channels.to_vec(),
        scaling,
        window: Window::Rectangular,
        segment: Segment::Whole,
        overlap: 0.5,
        detrend: Detrend::None,
        axis: Axis::Frequency,
    }
}

pub fn plain(scaling: Scaling) -> SpectrumRequest {
    request(SpectrumKind::Plain, &[X], scaling)
}

/// Estimates of `count` samples at [`RATE`]; the force on the shaft is −displacement.
pub fn estimated(
    request: &SpectrumRequest,
    count: usize,
    motion: impl Fn(f64) -> Motion,
) -> Result<EstimatedSpectrum, EstimateError> {
    let grid = SampleGrid {
        rate: RATE,
        shaft_frequency: 0.0,
        per_revolution: None,
    };
    let mut recording = Recording::new(grid, 0.0).with_requests(std::slice::from_ref(request));
    for n in 0..count {
        let time = n as f64 / RATE;
        let now = motion(time);
        let five = |[x, y]: [f64; 2]| [x, y, 0.0, 0.0, 0.0];
        let sample = Sample {
            time,
            angle: now.turning[0],
            speed: now.turning[1],
            displacement: five(now.displacement),
            velocity: five(now.velocity),
            acceleration: Some(five(now.acceleration)),
            force_on_shaft: Some(five(now.displacement.map(|x| -x))),
            ..Sample::default()
        };
        recording.record(&sample);
    }
    estimate(&recording, request)
}

/// A column of an estimate.
pub fn values(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity) -> &[f64] {
    let mut columns = spectrum.columns.iter();
    let found = columns.find(|column| column.quantity == quantity);
    &found.expect("the column is there").values
}
