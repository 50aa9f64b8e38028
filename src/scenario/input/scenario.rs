//! The whole file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingInput;
use super::components::{InitialInput, StaticInput};
use super::damping::DampingInput;
use super::disc::DiscInput;
use super::element::ElementInput;
use super::load::LoadInput;
use super::measured::MeasuredInput;
use super::output::{Output, Turning};
use super::questions::Questions;
use super::recorded::Recorded;
use super::settings::{ContactChoice, IntegratorInput, MachineInput, ModelInput, TimeInput};
use super::shaft::{ShaftInput, TorsionInput};
use super::spectrum::{self, SpectrumInput};
use super::speed::SpeedInput;
use super::unbalance::UnbalanceInput;
use crate::quasi_static::StaticQuestion;
use crate::rotor::RotorDefinition;
use crate::scenario::problems::Problems;
use crate::simulate::{Model, MotionAnalysis};
use crate::study::{ContactChoice as ChosenContact, ContactQuestion, choose_contact};

/// Largest difference of the law that is chosen, where none is given.
const MODEL_ERROR: f64 = 1e-3;

/// A shaft on ball bearings, what drives and loads it, how long and how
/// exactly to simulate it, and what to keep. What has a dimension is a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Scenario of jeffcott")]
pub struct ScenarioInput {
    /// Where an editor finds the schema of this file; without effect on the run.
    #[serde(rename = "$schema")]
    pub schema: Option<String>,
    /// One line on what the scenario shows. Default: the name of the file.
    pub title: Option<String>,
    /// The shaft: a concentrated mass with an eccentricity, or sections that bend.
    #[schemars(extend("examples" = [{ "mass": "5 kg", "freedoms": "translational" }]))]
    pub shaft: ShaftInput,
    /// Unbalances in planes of the shaft, one `[[unbalance]]` for each; they and that of `[shaft]` add up.
    #[serde(default)]
    pub unbalance: Vec<UnbalanceInput>,
    /// Discs on a shaft with sections, one `[[disc]]` for each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub disc: Vec<DiscInput>,
    /// How fast the shaft turns.
    #[schemars(extend("examples" = [{ "constant": "500 rad/s" }]))]
    pub speed: SpeedInput,
    /// CSV file of your own bearings, which are looked up before those that are shipped; `jeffcott catalogue --csv`
    /// shows the columns.
    #[schemars(extend("examples" = ["bearings.csv"]))]
    pub catalogue_file: Option<String>,
    /// The rolling bearings that carry the shaft, one `[[bearing]]` for each; without any, elements must.
    #[serde(default)]
    #[schemars(extend("examples" = [[{ "catalogue": "7205C" }]]))]
    pub bearing: Vec<BearingInput>,
    /// What holds, damps or rubs the shaft besides them, one `[[element]]` for each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub element: Vec<ElementInput>,
    /// Which physics to simulate.
    #[serde(default)]
    pub model: ModelInput,
    /// Viscous damping. Without this table nothing is damped.
    pub damping: Option<DampingInput>,
    /// External loads, one `[[load]]` for each; they add up.
    #[serde(default)]
    pub load: Vec<LoadInput>,
    /// The machine that the shaft is part of, for the zones of ISO 20816-3. Without this table no zone is given.
    pub machine: Option<MachineInput>,
    /// Where the motion starts.
    #[serde(default)]
    pub initial: InitialInput,
    /// How long to simulate. Without this table only static questions (`jeffcott bearing`) are
    /// asked.
    #[schemars(extend("examples" = [{ "duration": "0.5 s" }]))]
    pub time: Option<TimeInput>,
    /// How to integrate and how exactly.
    #[serde(default)]
    pub integrator: IntegratorInput,
    /// What to keep of the run.
    #[serde(default)]
    pub output: Output,
    /// Further spectra, one `[[spectrum]]` for each.
    #[serde(default)]
    pub spectrum: Vec<SpectrumInput>,
    /// Measured records that are laid over the spectra of the run on its page, one `[[measured]]` for each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub measured: Vec<MeasuredInput>,
    /// What only static questions ask.
    #[serde(default, rename = "static")]
    pub statics: StaticInput,
}

impl ScenarioInput {
    /// The questions, as far as nothing contradicts them.
    pub fn build(&self, problems: &mut Problems<'_>) -> Option<Questions> {
        self.check_counts(problems)?;
        let (rotor, contact_choice) = self.chosen(self.rotor(problems), problems);
        let displacement = self.statics.displacement(&self.load, problems);
        let measured = problems.each("measured", &self.measured, |measured, problems| {
            measured.build(problems)
        });
        let model = match &self.time {
            Some(time) => Some(self.model(time, rotor.clone(), problems)?),
            None => None,
        };
        Some(Questions {
            question: StaticQuestion {
                rotor: rotor?,
                displacement,
                unbalance: self.statics.unbalance,
                torsion: self.shaft.torsion.as_ref().map(TorsionInput::build),
            },
            model,
            contact_choice,
            oils: self.bearing.iter().flat_map(BearingInput::oils).collect(),
            measured: measured?,
        })
    }

    /// The rotor with the law of its contacts chosen, where the scene leaves it open.
    fn chosen(
        &self,
        rotor: Option<RotorDefinition>,
        problems: &mut Problems<'_>,
    ) -> (Option<RotorDefinition>, Option<ChosenContact>) {
        let open = |bearing: &BearingInput| bearing.contact(&self.model) == ContactChoice::Auto;
        let any_open = self.bearing.iter().any(open);
        self.check_auto(any_open, problems);
        let (Some(rotor), true) = (&rotor, any_open && problems.issues.is_empty()) else {
            return (rotor, None);
        };
        let flags = |bearing| std::iter::repeat_n(open(bearing), bearing.count());
        let question = ContactQuestion {
            model_error: self.model.model_error.unwrap_or(MODEL_ERROR),
            open: self.bearing.iter().flat_map(flags).collect(),
            balls: self.output.balls,
            settle: self.time.as_ref().map(|time| time.settle.si()),
        };
        let (rotor, choice) = choose_contact(rotor, &question);
        (Some(rotor), Some(choice))
    }

    fn model(
        &self,
        time: &TimeInput,
        rotor: Option<RotorDefinition>,
        problems: &mut Problems<'_>,
    ) -> Option<Model> {
        time.check(problems);
        let rotor = rotor?;
        let speed = rotor.speed_profile().ok()?;
        let driven = rotor.drive.is_some();
        let steady = speed.steady_from(time.settle.si());
        let turning = Turning {
            key: self.speed.path(),
            highest: rotor.highest_speed(),
            steady: steady.filter(|_| !driven),
            changes: driven || !speed.is_constant(),
        };
        let spectra_taken = self.output.takes_spectra(turning.steady.is_some());
        let sampling = self.output.sampling(turning, time, problems)?;
        let recorded = Recorded {
            freedoms: rotor.shaft.freedoms,
            measured: None,
            window: time.window(),
            rate: sampling.rate(turning.highest),
            turning,
        };
        let spectra = spectrum::build(&self.spectrum, &recorded, problems);
        self.check_housings(&rotor, &spectra, problems);
        if spectra_taken && problems.node("time.settle").is_none() {
            problems.warn(
                "no `settle` in `[time]`: the spectra hold what decays after the start; set it to where that is gone \
                 (0 s keeps it)",
            );
        }
        let mut analyses = self.output.analyses(turning, problems);
        analyses.fits_window = self.output.window.is_none();
        analyses.machine = self.machine.as_ref().map(MachineInput::build);
        if self.machine.is_some() && analyses.motion == MotionAnalysis::None {
            problems.warn(
                "`[machine]` has no effect: the zones of ISO 20816-3 are those of a motion at constant speed after \
                 `settle`, which `motion` in `[output]` describes",
            );
        }
        Some(Model {
            rotor,
            duration: time.duration.si(),
            settle: time.settle.si(),
            sampling,
            integrator: self.integrator.build(),
            verify: self.integrator.verify,
            energy: self.output.energy,
            table: self.model.table,
            spectrum: spectra_taken.then_some(self.output.window.unwrap_or_default()),
            analyses,
            spectra,
        })
    }
}
