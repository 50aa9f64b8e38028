//! The whole file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingInput;
use super::components::{InitialInput, StaticInput};
use super::damping::{self, DampingInput};
use super::disc::DiscInput;
use super::element::{self, ElementInput};
use super::flexible;
use super::held::warn_where_unheld;
use super::load::{self, LoadContext, LoadInput};
use super::measured::MeasuredInput;
use super::output::{Output, Turning};
use super::questions::Questions;
use super::recorded::Recorded;
use super::settings::{ContactChoice, IntegratorInput, MachineInput, ModelInput, TimeInput};
use super::shaft::{ShaftInput, TorsionInput};
use super::spectrum::{self, SpectrumInput};
use super::speed::SpeedInput;
use super::unbalance::{self, UnbalanceInput};
use crate::bearing::MountedBearing;
use crate::bearing::catalogue::Catalogue;
use crate::quasi_static::StaticQuestion;
use crate::rotor::{
    Disc, Drive, ForceElement, Freedoms, InitialState, Load, RotorDefinition, Shaft,
};
use crate::scenario::problems::Problems;
use crate::scenario::{Issue, catalogue_file};
use crate::simulate::{Model, MotionAnalysis};
use crate::study::{ContactChoice as ChosenContact, ContactQuestion, choose_contact};

/// Largest difference of the law that is chosen, where none is given.
const MODEL_ERROR: f64 = 1e-3;

/// Place of z among the freedoms.
const AXIAL: usize = 2;

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
    /// The machine that the shaft is part of, for the zones of ISO 20816-3. Without this table no zone is told.
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

    fn rotor(&self, problems: &mut Problems<'_>) -> Option<RotorDefinition> {
        let turns = self.speed.drive.is_some();
        let mut flexible = flexible::build(&self.shaft, &self.disc, &self.unbalance, problems)?;
        let mut shaft = match &flexible {
            Some(flexible) => self.shaft.build_flexible(flexible),
            None => self.shaft.build(self.time.is_some(), turns, problems),
        };
        let context = LoadContext {
            freedoms: shaft.freedoms,
            duration: self.time.as_ref().map_or(0.0, |time| time.duration.si()),
            observed: flexible.as_ref().map(|shaft| shaft.observed),
        };
        let mut loads = load::build(&self.load, context, problems);
        loads.extend(self.element.iter().flat_map(ElementInput::loads));
        let initial = self.initial.build(shaft.freedoms, problems);
        let freedoms = self.held_along_z(shaft.freedoms, &loads, &initial, problems);
        shaft.freedoms = freedoms;
        self.check_race_control(problems);
        self.output.check_written(problems);
        let mut contacts = self.bearing.iter().map(|each| each.contact(&self.model));
        let known = contacts.any(|contact| contact != ContactChoice::Linear);
        self.output.check_balls(known, problems);
        let bearings = self.bearings(freedoms, problems);
        let damping = damping::build(self.damping.as_ref(), freedoms, problems);
        let pushes = |load: &Load| load.as_constant().is_some_and(|parts| parts[AXIAL] != 0.0);
        let speed = self.speed.build(problems)?;
        let mut points = speed.points();
        let bearings = bearings?;
        let held = !freedoms.moves(AXIAL) || self.element.iter().any(ElementInput::holds_z);
        if self.time.is_some() && !held && !loads.iter().any(pushes) {
            let last = self.bearing.len().saturating_sub(1);
            warn_where_unheld(&bearings, last, problems);
        }
        if let Some(flexible) = flexible.as_mut().filter(|_| self.shaft.massless) {
            flexible.discs.extend(bearings.iter().map(Disc::inner_ring));
            shaft = Shaft {
                freedoms,
                ..self.shaft.build_flexible(flexible)
            };
        }
        match &flexible {
            Some(shaft) => self.check_positions(shaft, &bearings, problems),
            None if freedoms.tilts() => self.warn_of_far_positions(&bearings, problems),
            None => {}
        }
        let mut rotor = RotorDefinition {
            speed: points.next()?.speed,
            speed_points: points.collect(),
            drive: self.drive(),
            cage: self.model.cage,
            damping,
            loads,
            initial,
            elements: self.elements(freedoms, problems)?,
            flexible,
            ..RotorDefinition::new(shaft, bearings)
        };
        let housings = rotor.housings().into_iter().map(|(place, _)| place);
        element::check_housings(&rotor.elements, &housings.collect::<Vec<_>>(), problems);
        for warning in rotor.beyond_tables() {
            problems.warn(warning);
        }
        if rotor.flexible.is_none() {
            let text = self.shaft.unbalance.as_deref();
            rotor.shaft.unbalance = unbalance::build(text, &self.unbalance, &rotor, problems);
        }
        self.check_standing_shaft(&rotor, problems);
        if self.time.is_some() {
            damping::warn_where_undamped(self.damping.as_ref(), &rotor, problems);
        }
        Some(rotor)
    }

    /// The freedoms that move: not z, where no bearing holds the shaft along it and nothing acts that way.
    fn held_along_z(
        &self,
        freedoms: Freedoms,
        loads: &[Load],
        initial: &InitialState,
        problems: &mut Problems<'_>,
    ) -> Freedoms {
        let acts = |load: &Load| {
            let constant = load.as_constant().map_or(0.0, |parts| parts[AXIAL]);
            let varying = load.kind.main_vibration().amplitude[AXIAL];
            [constant, varying, load.kind.static_part()[AXIAL]] != [0.0; 3]
        };
        let starts = [initial.displacement[AXIAL], initial.velocity[AXIAL]] != [None; 2];
        let holds = !self.bearing.is_empty() || self.element.iter().any(ElementInput::holds_z);
        let held = holds || loads.iter().any(acts) || starts;
        if held || !freedoms.moves(AXIAL) {
            return freedoms;
        }
        problems.warn(format!(
            "no bearing holds the shaft along z and nothing acts that way: z is held, as with freedoms = \"{}\"; a \
             `stiffness` along z in `[element.linear]` lets it move",
            freedoms.without_z().name()
        ));
        freedoms.without_z()
    }

    /// The elements, as far as nothing contradicts them.
    fn elements(
        &self,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<ForceElement>> {
        problems.each("element", &self.element, |element, problems| {
            element.build(freedoms, problems)
        })
    }

    fn drive(&self) -> Option<Drive> {
        let torsion = self.shaft.torsion.as_ref().map(TorsionInput::build);
        let compliance = torsion.map_or(0.0, |torsion| torsion.compliance());
        let input = self.speed.drive.as_ref()?;
        Some(input.build(compliance))
    }

    fn bearings(
        &self,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<MountedBearing>> {
        let catalogue = self.catalogue(problems)?;
        let sets = problems.each("bearing", &self.bearing, |bearing, problems| {
            bearing.build(&self.model, freedoms, &catalogue, problems)
        });
        let contact_damping = damping::contact(self.damping.as_ref());
        let damped = |bearing| MountedBearing {
            contact_damping,
            ..bearing
        };
        Some(sets?.into_iter().flatten().map(damped).collect())
    }

    /// The bearings of the user's catalogue file.
    fn catalogue(&self, problems: &mut Problems<'_>) -> Option<Catalogue> {
        let Some(file) = &self.catalogue_file else {
            return Some(Catalogue::default());
        };
        let read = catalogue_file::read(&problems.folder.join(file));
        let refuse = |found: Vec<String>| {
            for problem in found {
                let message = format!("`{file}` is no catalogue: {problem}");
                problems.refuse(Issue::new("catalogue_file", message));
            }
        };
        read.map_err(refuse).ok()
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
