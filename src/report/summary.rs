//! The summary of a run as JSON.

use serde_json::{Map, Value, json};

use super::columns::{ball_pass, matrix};
use super::histories::histories_json;
use super::method_use::method_use_json;
use super::motion::motion_json;
use super::peaks_csv::other_names;
use super::run_up::maps_json;
use super::spectra::estimated_json;
use super::table_use::table_use_json;
use crate::analysis::{Channel, Peak, Spectrum};
use crate::bearing::Matrix5;
use crate::integrate::Counters;
use crate::rotor::FREEDOMS;
use crate::rotor::NaturalFrequency;
use crate::simulate::{EnergyReport, MeasuredError, Model, Run, StaticState};

/// Everything that a run answers except trace and spectra, every number with its unit in its name.
///
/// `scenario` is echoed as it is. The same run gives the same bytes: there is no date and no wall
/// time in it.
pub fn summary(title: &str, scenario: &Value, model: &Model, run: &Run) -> Value {
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "equilibrium": equilibrium(&run.equilibrium),
        "stiffness": stiffness(&run.equilibrium.stiffness),
        "natural_frequencies": run
            .equilibrium
            .natural_frequencies
            .iter()
            .map(natural_frequency)
            .collect::<Value>(),
        "ball_pass": run.ball_pass.iter().map(ball_pass).collect::<Value>(),
        "operating_ball_pass": run.operating_ball_pass.iter().map(ball_pass).collect::<Value>(),
        "bearings": histories_json(&run.bearings),
        "spectrum": run.spectrum.as_ref().map(spectrum),
        "spectra": run.spectra.iter().map(estimated_json).collect::<Value>(),
        "peaks": run
            .peaks
            .iter()
            .map(|peak| named_peak(peak, run.spectrum.as_ref()))
            .collect::<Value>(),
        "motion": run.motion.as_ref().map(motion_json),
        "maps": run.maps.as_ref().map(maps_json),
        "tables": run.tables.iter().map(|table| table.as_ref().map(table_use_json)).collect::<Value>(),
        "counters": counters(&run.counters),
        "method_use": run.method_use.as_ref().map(method_use_json),
        "measured_error": run
            .measured_error
            .as_ref()
            .map(|error| measured_error(error, model.integrator.tolerance, &run.counters)),
        "energy": run.energy.as_ref().map(energy),
        "samples": run.samples,
        "warnings": run.warnings,
    })
}

fn equilibrium(state: &StaticState) -> Value {
    let mut entries: Map<String, Value> = (0..FREEDOMS)
        .map(Channel::Displacement)
        .zip(state.displacement)
        .map(|(channel, value)| (channel.column(), value.into()))
        .collect();
    entries.insert("residual".into(), state.residual.into());
    entries.insert("newton_steps".into(), state.newton_steps.into());
    entries.into()
}

fn stiffness(rows: &[[f64; FREEDOMS]; FREEDOMS]) -> Value {
    matrix(&Matrix5::from_fn(|row, column| rows[row][column]))
}

fn natural_frequency(natural: &NaturalFrequency) -> Value {
    json!({
        "frequency_Hz": natural.frequency,
        "damped_frequency_Hz": natural.damped_frequency,
        "damping_ratio": natural.damping_ratio,
        "whirl": natural.whirl.to_string(),
    })
}

fn spectrum(spectrum: &Spectrum) -> Value {
    json!({
        "window": spectrum.window.name(),
        "length": spectrum.length,
        "resolution_Hz": spectrum.resolution,
        "shaft_frequency_Hz": spectrum.shaft_frequency,
        "start_s": spectrum.start,
        "scaling": "one-sided, peak values; phase of cos(2 pi f t + phase) with t from start_s",
    })
}

fn named_peak(peak: &Peak, spectrum: Option<&Spectrum>) -> Value {
    let order = spectrum
        .filter(|spectrum| spectrum.shaft_frequency > 0.0)
        .map(|spectrum| peak.frequency / spectrum.shaft_frequency);
    let distance = peak.line.map(|line| peak.frequency - line.frequency);
    json!({
        "channel": peak.channel.name(),
        "frequency_Hz": peak.frequency,
        "order": order,
        "amplitude": peak.amplitude,
        "phase_rad": peak.phase,
        "unit": peak.channel.unit(),
        "label": peak.line.map(|line| line.kind.to_string()),
        "label_Hz": peak.line.map(|line| line.frequency),
        "distance_Hz": distance,
        "distance_bins": distance
            .zip(spectrum)
            .map(|(distance, spectrum)| distance / spectrum.resolution),
        "operating_Hz": peak.line.and_then(|line| line.operating),
        "other_labels": other_names(peak),
    })
}

fn energy(energy: &EnergyReport) -> Value {
    let works = &energy.works;
    json!({
        "kinetic_change_J": energy.kinetic_change,
        "stored_change_J": energy.stored_change,
        "supplied_J": {
            "loads": works.loads,
            "unbalance": works.unbalance,
            "rotation": works.rotation,
            "drive": works.drive,
        },
        "dissipated_J": {
            "viscous_damping": works.viscous,
            "contact_damping": works.contact,
            "bearing_friction": works.friction,
            "load_torque": works.load_torque,
        },
        "work_on_bearings_J": works.bearings,
        "bearings_have_potential": energy.conservative,
        "largest_residual_J": energy.largest_residual,
        "relative_residual": energy.relative_residual,
    })
}

fn counters(counters: &Counters) -> Value {
    json!({
        "steps": counters.steps,
        "rejected": counters.rejected,
        "evaluations": counters.evaluations,
    })
}

fn measured_error(error: &MeasuredError, tolerance: f64, main: &Counters) -> Value {
    json!({
        "displacement_m": error.displacement,
        "relative": error.relative,
        "tolerance": tolerance,
        "reference_tolerance": error.reference_tolerance,
        "reference_counters": counters(&error.counters),
        "reference_share_of_evaluations": error.share_of_evaluations(main),
    })
}
