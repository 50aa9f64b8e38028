//! Column names of a spectrum: quantity, scaling and unit.

use crate::analysis::column_unit;
use crate::analysis::{EstimatedSpectrum, Scaling, SpectrumQuantity};

/// `x_peak_m`, `x_velocity_rms_m_s`, `force_x_density_N2_per_Hz`, `x_iy_peak_m`,
/// `force_x_to_x_power_N_m`, `force_x_to_x_phase_rad`, `force_x_to_x_coherence` ….
pub(super) fn column(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity) -> String {
    match quantity {
        SpectrumQuantity::Value(channel) => scaled(spectrum, quantity, channel.name()),
        SpectrumQuantity::Phase(channel) => format!("{channel}_phase_rad"),
        SpectrumQuantity::Rotary(x, _) => {
            scaled(spectrum, quantity, &x.name().replacen('x', "x_iy", 1))
        }
        SpectrumQuantity::Cross(reference, other) => {
            scaled(spectrum, quantity, &format!("{reference}_to_{other}"))
        }
        SpectrumQuantity::CrossPhase(reference, other) => {
            format!("{reference}_to_{other}_phase_rad")
        }
        SpectrumQuantity::Coherence(reference, other) => {
            format!("{reference}_to_{other}_coherence")
        }
    }
}

fn scaled(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity, name: &str) -> String {
    let scaling = spectrum.request.scaling.name();
    let unit = column_unit(&spectrum.unit(quantity));
    format!("{name}_{scaling}_{unit}{}", per_axis(spectrum, "_per_"))
}

/// Unit of a column as text.
pub(super) fn unit(spectrum: &EstimatedSpectrum, quantity: SpectrumQuantity) -> String {
    let unit = spectrum.unit(quantity);
    match quantity {
        SpectrumQuantity::Value(_) | SpectrumQuantity::Rotary(..) | SpectrumQuantity::Cross(..) => {
            format!("{unit}{}", per_axis(spectrum, "/"))
        }
        _ => unit,
    }
}

/// The unit of the axis that a density is divided by.
fn per_axis(spectrum: &EstimatedSpectrum, per: &str) -> String {
    match spectrum.request.scaling {
        Scaling::Density => format!("{per}{}", spectrum.request.axis.unit()),
        _ => String::new(),
    }
}
