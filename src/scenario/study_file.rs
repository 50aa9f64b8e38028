//! Study files: many runs of one scenario.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::axis::{AxisInput, AxisReader, Scalar};
use super::document::Document;
use super::input::Questions;
use super::key::{Key, KeyPaths, all_keys, entry, set_value};
use super::problems::Problems;
use super::schema::schema_of;
use super::{Format, Issue, Scenario, ScenarioError, built, echo, key, questions, reader, without};
use crate::analysis::SectionKind;
use crate::quasi_static::StaticQuestion;
use crate::simulate::Model;
use crate::study::Variable;
use crate::study::many::{
    Ask, Cycles, Keep, Maker, NumberColumn, Outcome, Schedule, Sweep, number_columns,
    static_columns, static_outcome,
};
use crate::study::plan::{Axis, MOST_RUNS, MOST_SOBOL_AXES, Plan, Sampling};

/// Tables of a scenario that play no part in what a study asks.
fn left_out(ask: Ask) -> &'static [&'static str] {
    match ask {
        Ask::Run => &["static"],
        Ask::Bearing => &["damping", "initial", "time", "integrator", "output"],
    }
}

/// Keys of settle time and duration.
const TIMES: [&str; 2] = ["time.settle", "time.duration"];

/// Highest order of the spectra that are kept where none is given.
const HIGHEST_ORDER: f64 = 20.0;

/// A checked study: which runs there are and how each is made.
#[derive(Debug, Clone)]
pub struct StudyFile {
    /// Its title, or the name of its file.
    pub title: String,
    /// What it asks at every point.
    pub ask: Ask,
    /// The values of every run.
    pub plan: Plan,
    /// What varies, an entry an axis.
    pub variables: Vec<Variable>,
    /// Order in which each run goes on from its neighbour, where it does.
    pub sweep: Option<Sweep>,
    /// Every so many runs the error is measured; 0 on none.
    pub verify_every: u64,
    /// What is kept of every run beside its numbers.
    pub keep: Keep,
    /// At how many azimuths around a bearing static answers are looked at; where `None`, at those of its balls.
    pub positions: Option<usize>,
    /// The numbers that are kept of every run, in the order of the table.
    pub columns: Vec<NumberColumn>,
    /// The study with its defaults and the scenario that it starts from.
    pub echo: Value,
    base: Value,
    folder: PathBuf,
    keys: Vec<Key>,
    cycles: Option<Cycles>,
    /// Warnings of the file of the base that its tables with their defaults do not give again.
    warnings: Vec<String>,
}

/// JSON Schema (draft 7) of a study file.
pub fn study_schema() -> &'static Value {
    static SCHEMA: std::sync::LazyLock<Value> =
        std::sync::LazyLock::new(schema_of::<StudyFileInput>);
    &SCHEMA
}

/// Reads and checks a study file, with some values in place of its own, and the scenario that it starts from.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong, of the study or else of the scenario.
pub fn load_study(path: &Path, settings: &[String]) -> Result<StudyFile, ScenarioError> {
    check_study(&Document::open(path)?.with(settings)?)
}

/// Checks a study and the scenario that it starts from.
pub(super) fn check_study(document: &Document) -> Result<StudyFile, ScenarioError> {
    if document.is_scenario() {
        let message = "this is a scenario, not a study file, which names one by `base`";
        let help = "use `jeffcott run`, `bearing`, `steady`, `campbell` or `accuracy`, or write a study file";
        let issue = Issue::new("shaft", message).help(help);
        return Err(document.refused(issue));
    }
    if document.is_fit() {
        let issue =
            Issue::new("unknown", "this is a fit file, not a study").help("use `jeffcott fit`");
        return Err(document.refused(issue));
    }
    let mut problems = document.problems().about("the study");
    let study = match read(&mut problems) {
        Some(input) => input.on_base(document, &mut problems)?,
        None => None,
    };
    document.finish(study, problems).map(|(study, _)| study)
}

/// Reads and checks the text of a study of a scenario that is there already, whatever `base` says; the files that
/// the scenario names are in `folder`.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn parse_study(
    text: &str,
    format: Format,
    scenario: &Scenario,
    folder: &Path,
) -> Result<StudyFile, ScenarioError> {
    let document = Document::parse(text, "study", format)?;
    let mut problems = document.problems().about("the study");
    let study = read(&mut problems).and_then(|input| {
        let title = input.title.as_ref().unwrap_or(&scenario.title).clone();
        input.study(scenario, title, folder.to_owned(), &mut problems)
    });
    document.finish(study, problems).map(|(study, _)| study)
}

fn read(problems: &mut Problems<'_>) -> Option<StudyFileInput> {
    let input: StudyFileInput = reader::read(study_schema(), problems)?;
    super::check_title(input.title.as_deref(), problems);
    Some(input)
}

/// The scenario that a file in a folder names by its `base`; `None` where nothing is there.
pub(super) fn base_of(named: &str, folder: &Path, problems: &mut Problems<'_>) -> Option<PathBuf> {
    if problems.is_faulty("base") {
        return None;
    }
    let base = folder.join(named);
    if base.exists() {
        return Some(base);
    }
    let message = format!("there is no scenario {}", base.display());
    let help = format!(
        "`{named}` is looked for from the folder of {}",
        problems.subject
    );
    problems.add(Issue::new("base", message).help(help));
    None
}

impl StudyFileInput {
    /// The study of the scenario that it names, as far as nothing contradicts it.
    ///
    /// # Errors
    /// [`ScenarioError`] of that scenario.
    fn on_base(
        &self,
        document: &Document,
        problems: &mut Problems<'_>,
    ) -> Result<Option<StudyFile>, ScenarioError> {
        let Some(base) = base_of(&self.base, document.folder(), problems) else {
            return Ok(None);
        };
        let scenario = super::load(&base)?;
        let title = self.title.clone().unwrap_or_else(|| document.stem());
        let folder = base.parent().unwrap_or(Path::new("")).to_owned();
        Ok(self.study(&scenario, title, folder, problems))
    }

    /// The study of a scenario whose files are in `folder`.
    fn study(
        &self,
        scenario: &Scenario,
        title: String,
        folder: PathBuf,
        problems: &mut Problems<'_>,
    ) -> Option<StudyFile> {
        let rotor = &scenario.question.rotor;
        let all = match self.ask {
            Ask::Run if scenario.model.is_none() => {
                let issue = Issue::new("base", "runs need a scenario with a `[time]`");
                let help = "add one, or ask where the shaft stands: ask = \"bearing\"";
                problems.refuse(issue.help(help));
                return None;
            }
            Ask::Run => number_columns(rotor),
            Ask::Bearing => static_columns(rotor),
        };
        self.check_asked(problems);
        let columns = self.columns(all, problems);
        let (base, repeated) = self.base_scenario(scenario, &folder, problems)?;
        let known = all_keys(&base, left_out(self.ask));
        let (mut axes, mut variables, mut keys) = (Vec::new(), Vec::new(), Vec::new());
        problems.each("axis", &self.axis, |input, problems| {
            let key = problems.take(key::find(&known, input.key.all(), ".key"))?;
            if let Some(place) = keys.iter().find_map(|other| key.shared_with(other)) {
                let message = format!("`{place}` changes along another axis already");
                problems.refuse(Issue::new(".key", message).help("give every key one axis"));
                return None;
            }
            let reader = AxisReader {
                named: ".key",
                input,
                key: &key,
                problems,
            };
            let (axis, variable) = reader.build()?;
            axes.push(axis);
            variables.push(variable);
            keys.push(key);
            Some(())
        });
        let sampling = self.sampling(&axes, problems)?;
        let plan = Plan::new(axes, sampling, self.seed);
        self.check_count(&plan, problems);
        self.check_sweep(problems);
        self.check_cycles(problems);
        let echo = json!({ "study": echo(self), "base": base });
        problems.issues.is_empty().then(|| StudyFile {
            title,
            ask: self.ask,
            plan,
            variables,
            sweep: self.sweep,
            verify_every: self.verify_every,
            keep: self.keep(),
            positions: self.keep.positions.map(|count| count as usize),
            columns,
            echo,
            base,
            folder,
            keys,
            cycles: self.cycles,
            warnings: self.further_warnings(scenario, &repeated),
        })
    }

    /// Warnings of the scenario that are not among `repeated` and concern no key that the study decides.
    fn further_warnings(&self, scenario: &Scenario, repeated: &[String]) -> Vec<String> {
        let axes = self.axis.iter().map(|axis| &axis.key);
        let keys = axes.chain(self.set.iter().map(|set| &set.key));
        let keys = keys.flat_map(|keys| keys.all().iter().map(String::as_str));
        let keys: Vec<_> = keys
            .chain(TIMES.into_iter().filter(|_| self.cycles.is_some()))
            .collect();
        let decided = |warning: &String| {
            let mut names = keys.iter().map(|key| format!("`{}`", reader::last(key)));
            names.any(|name| warning.contains(&name))
        };
        let warnings = scenario.warnings.iter().cloned();
        warnings
            .filter(|one| !repeated.contains(one) && !decided(one))
            .collect()
    }

    /// The scenario with what all runs have otherwise, and its warnings.
    fn base_scenario(
        &self,
        scenario: &Scenario,
        folder: &Path,
        problems: &mut Problems<'_>,
    ) -> Option<(Value, Vec<String>)> {
        let mut base = match self.ask {
            Ask::Run => scenario.echo.clone(),
            Ask::Bearing => without(&scenario.echo, left_out(self.ask)),
        };
        let known = all_keys(&base, left_out(self.ask));
        SetInput::put(&self.set, &known, &mut base, problems)?;
        let found = questions(&base, folder).map_err(|issue| {
            let message = format!("the base with `set`: {}", issue.message);
            Issue::new("set", message)
        });
        let warnings = problems.take(found)?.question.rotor.warnings;
        Some((base, warnings))
    }

    /// The numbers that are kept: of a scene all, or those that are named and the measured error.
    fn columns(&self, all: Vec<NumberColumn>, problems: &mut Problems<'_>) -> Vec<NumberColumn> {
        let Some(named) = &self.keep.numbers else {
            return all.into_iter().filter(|own| !own.on_request).collect();
        };
        let known: Vec<String> = all.iter().map(|own| own.column.name()).collect();
        for (index, name) in named.iter().enumerate() {
            if !known.contains(name) {
                let message = format!("no run of this scene has a number `{name}`");
                let known = known.iter().map(String::as_str).collect::<Vec<_>>();
                let issue = Issue::new(entry("keep.numbers", index), message);
                let list = format!("its numbers are {}", known.join(", "));
                problems.refuse(issue.help_nearest(name, known, &list));
            }
        }
        let kept =
            |column: &NumberColumn| named.contains(&column.column.name()) || column.is_error();
        all.into_iter().filter(kept).collect()
    }

    /// Refuses what plays no part in what is asked.
    fn check_asked(&self, problems: &mut Problems<'_>) {
        let keep = &self.keep;
        let idle = match self.ask {
            Ask::Run => vec![("keep.positions", keep.positions.is_some())],
            Ask::Bearing => vec![
                ("sweep", self.sweep.is_some()),
                ("cycles", self.cycles.is_some()),
                ("keep.spectra", keep.spectra),
                ("keep.traces", keep.traces),
                ("keep.bearing_stiffness", keep.bearing_stiffness),
                ("keep.poincare", keep.poincare.is_some()),
            ],
        };
        for (key, _) in idle.into_iter().filter(|(_, given)| *given) {
            let message = match self.ask {
                Ask::Run => "runs are not looked at around a bearing",
                Ask::Bearing => "nothing moves where a static question is asked",
            };
            let issue = Issue::new(key, message).help("remove it, or change `ask`");
            problems.refuse(issue.against("ask"));
        }
    }

    fn sampling(&self, axes: &[Axis], problems: &mut Problems<'_>) -> Option<Sampling> {
        let drawn: fn(u64) -> Sampling = match self.sampling {
            SamplingKind::Grid => return self.grid(axes, problems),
            SamplingKind::LatinHypercube => Sampling::LatinHypercube,
            SamplingKind::Sobol => Sampling::Sobol,
            SamplingKind::MonteCarlo => Sampling::MonteCarlo,
        };
        if self.sampling == SamplingKind::Sobol && axes.len() > MOST_SOBOL_AXES {
            let message = format!("Sobol's sequence has at most {MOST_SOBOL_AXES} axes");
            problems.refuse(Issue::new("sampling", message).help("take \"latin_hypercube\""));
        }
        let missing = || {
            let issue = Issue::new("sampling", "runs that are drawn need a number of them");
            issue.help("for instance: runs = 1000")
        };
        problems.take(self.runs.map(drawn).ok_or_else(missing))
    }

    fn grid(&self, axes: &[Axis], problems: &mut Problems<'_>) -> Option<Sampling> {
        if self.runs.is_some() {
            let issue = Issue::new("runs", "a grid has as many runs as its axes make");
            problems.refuse(issue.help("remove it, or draw: sampling = \"sobol\""));
        }
        for (index, axis) in axes.iter().enumerate() {
            if matches!(axis, Axis::Drawn(_)) {
                let path = format!("axis[{}].distribution", index + 1);
                let issue = Issue::new(path, "a distribution has no values for a grid");
                let help = "set sampling = \"latin_hypercube\", \"sobol\" or \"monte_carlo\"";
                problems.refuse(issue.help(help).against("sampling"));
            }
        }
        Some(Sampling::Grid)
    }

    fn check_count(&self, plan: &Plan, problems: &mut Problems<'_>) {
        let runs = plan.runs();
        if runs.is_none_or(|runs| runs > MOST_RUNS) {
            let shown = runs.map_or_else(|| "more than 1e19".to_owned(), |runs| runs.to_string());
            let message = format!("the axes make {shown} runs: at most {MOST_RUNS:e} in a study");
            let issue = Issue::new("axis", message).help("take fewer values, or draw the runs");
            let counts = (0..self.axis.len()).map(|index| format!("axis[{}].count", index + 1));
            problems.refuse(issue.against_all(counts));
        }
    }

    fn check_sweep(&self, problems: &mut Problems<'_>) {
        if self.sweep.is_some() && self.sampling != SamplingKind::Grid {
            let message = "runs that are drawn have no neighbours to go on from";
            let issue = Issue::new("sweep", message).help("take a grid");
            problems.refuse(issue.against("sampling"));
        }
        if self.keep.highest_order.is_some() && !self.keep.spectra {
            let issue = Issue::new("keep.highest_order", "no spectra are kept");
            problems.refuse(issue.help("set spectra = true, or remove it"));
        }
    }

    /// Refuses times that cycles decide.
    fn check_cycles(&self, problems: &mut Problems<'_>) {
        if self.cycles.is_none() {
            return;
        }
        let axes = self.axis.iter().map(|axis| &axis.key).enumerate();
        let sets = self.set.iter().map(|set| &set.key).enumerate();
        let all = axes.map(|each| ("axis", each));
        for (table, (index, keys)) in all.chain(sets.map(|each| ("set", each))) {
            let mut keys = keys.all().iter();
            if let Some(key) = keys.find(|key| TIMES.contains(&key.as_str())) {
                let path = format!("{table}[{}].key", index + 1);
                let issue = Issue::new(path, format!("`cycles` decides `{key}`"));
                problems.refuse(issue.help("remove one of them").against("cycles"));
            }
        }
    }

    fn keep(&self) -> Keep {
        let highest_order = self.keep.highest_order.unwrap_or(HIGHEST_ORDER);
        Keep {
            highest_order: self.keep.spectra.then_some(highest_order),
            bearing_stiffness: self.keep.bearing_stiffness,
            traces: self.keep.traces,
            section: self.keep.poincare,
        }
    }
}

impl StudyFile {
    /// The scenario of a run with its values put in, as JSON.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn scenario(&self, values: &[f64]) -> Result<Value, Issue> {
        let mut scenario = self.base.clone();
        for ((key, variable), value) in self.keys.iter().zip(&self.variables).zip(values) {
            let word = variable.word(*value).map(Value::from);
            key.set(&mut scenario, &word.unwrap_or_else(|| key.written(*value)));
        }
        if let Some(cycles) = &self.cycles {
            let rotor = questions(&scenario, &self.folder)?.motion()?.rotor;
            let times = cycles.times(&rotor);
            let times = times.map_err(|error| Issue::new("cycles", error.to_string()))?;
            for (key, time) in TIMES.iter().zip(times) {
                set_value(&mut scenario, key, &json!(format!("{time} s")));
            }
        }
        Ok(scenario)
    }

    /// What makes its runs, without traces; `model` gives the motion of a run's values.
    pub(crate) fn maker<'a>(
        &'a self,
        schedule: Schedule,
        model: &'a (dyn Fn(&[f64]) -> Result<Model, String> + Sync),
        stop: &'a AtomicBool,
    ) -> Maker<'a> {
        Maker {
            plan: &self.plan,
            schedule,
            keep: self.keep,
            verify_every: self.verify_every,
            traces: None,
            columns: &self.columns,
            model,
            stop,
        }
    }

    /// The motion of a run.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn model(&self, values: &[f64]) -> Result<Model, Issue> {
        self.questions(values)?.motion()
    }

    /// The static question of a point.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn question(&self, values: &[f64]) -> Result<StaticQuestion, Issue> {
        Ok(self.questions(values)?.question)
    }

    fn questions(&self, values: &[f64]) -> Result<Questions, Issue> {
        let (_, questions, warnings) = built(&self.scenario(values)?, &self.folder)?;
        Ok(questions.with_warnings(&self.all_warnings(warnings)))
    }

    /// The scenario of a point by itself, under a title.
    ///
    /// # Errors
    /// [`Issue`] where its values make none.
    pub(crate) fn alone(&self, values: &[f64], title: String) -> Result<Scenario, Issue> {
        let mut scenario = self.scenario(values)?;
        scenario["title"] = title.into();
        let (input, questions, warnings) = built(&scenario, &self.folder)?;
        let warnings = self.all_warnings(warnings);
        Ok(Scenario::new(input, questions, warnings, String::new))
    }

    /// Warnings of the file of the base, and those of a point.
    fn all_warnings(&self, of_point: Vec<String>) -> Vec<String> {
        self.warnings.iter().cloned().chain(of_point).collect()
    }

    /// The answer to the static question of a point, or why there is none.
    pub(crate) fn static_outcome(&self, values: &[f64]) -> Result<Outcome, String> {
        let question = self.question(values).map_err(|error| error.message)?;
        let found = static_outcome(&question, &self.columns, self.positions);
        found.map_err(|error| error.to_string())
    }
}

/// Many runs of one scenario.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "jeffcott study")]
struct StudyFileInput {
    /// What the study is called. Default: the name of its file.
    pub title: Option<String>,
    /// What is asked at every point: how the shaft moves, or where it stands. Default: "run".
    #[serde(default)]
    pub ask: Ask,
    /// The scenario that all runs start from, relative to this file.
    #[schemars(extend("examples" = ["../steady-7205c.toml"]))]
    pub base: String,
    /// How the values of the axes are combined. Default: "grid".
    #[serde(default)]
    pub sampling: SamplingKind,
    /// How many runs are drawn; only where they are drawn.
    #[schemars(range(min = 1, max = MOST_RUNS))]
    pub runs: Option<u64>,
    /// Decides all that is drawn. Default: 0.
    #[serde(default)]
    pub seed: u64,
    /// Every so many runs the error is measured by a second pass, from the first run on; 0 on none.
    /// Default: 10.
    #[serde(default = "every_tenth")]
    pub verify_every: u64,
    /// Whether each run goes on from where its neighbour along the last axis ended, and in which order.
    /// Default: every run starts by itself.
    pub sweep: Option<Sweep>,
    /// The numbers that vary, on a grid the last one fastest.
    #[schemars(extend("minItems" = 1, "maxItems" = 16))]
    pub axis: Vec<AxisInput>,
    /// What all runs have otherwise than the base.
    #[serde(default)]
    pub set: Vec<SetInput>,
    /// How long every run is in cycles at its own speed, in place of the `[time]` of the base.
    pub cycles: Option<Cycles>,
    /// What is kept of every run.
    #[serde(default)]
    pub keep: KeepInput,
}

fn every_tenth() -> u64 {
    10
}

/// How the values of the axes are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum SamplingKind {
    /// Every value with every other.
    #[default]
    Grid,
    /// Drawn, each part of every axis once.
    LatinHypercube,
    /// Sobol's sequence, shifted at random.
    Sobol,
    /// Drawn independently.
    MonteCarlo,
}

/// One value that all runs have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SetInput {
    /// Path of the key of a number, or of a word out of several; "bearing[*].contact", or a list of paths, sets
    /// several keys.
    #[schemars(extend("examples" = ["time.duration", "model.contact"]))]
    pub key: KeyPaths,
    /// Its value, written as that key is.
    #[schemars(extend("examples" = ["0.5 s"]))]
    pub value: Scalar,
}

impl SetInput {
    /// Puts values into a scenario.
    pub fn apply(all: &[Self], scenario: &mut Value, problems: &mut Problems<'_>) -> Option<()> {
        let known = all_keys(scenario, &[]);
        Self::put(all, &known, scenario, problems)
    }

    /// Puts values of known keys into a scenario.
    fn put(
        all: &[Self],
        known: &[Key],
        scenario: &mut Value,
        problems: &mut Problems<'_>,
    ) -> Option<()> {
        let set = problems.each("set", all, |set, problems| {
            let key = problems.take(key::find(known, set.key.all(), ".key"))?;
            let value = key.read(&problems.path(".value"), problems)?;
            key.set(scenario, &value);
            Some(())
        });
        set.map(|_| ())
    }
}

/// What is kept of every run, beside its numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
struct KeepInput {
    /// Which numbers, by the names of their columns; the figures draw them in this order. The measured error
    /// is always kept. Default: all but the lines of forces, as `bearing1_force_x_order_1_N`; the figures draw some.
    #[schemars(extend("minItems" = 1, "maxItems" = 64, "examples" = [["x_rms_m", "bearing_1_life_h"]]))]
    pub numbers: Option<Vec<String>>,
    /// At how many azimuths around a bearing, from +X on, the answers of ask = "bearing" have deformation, loads and
    /// contact angles, in `around.csv`. Default: where its balls are.
    #[schemars(range(min = 3, max = 3600))]
    pub positions: Option<u32>,
    /// Whether the amplitudes of the displacements are kept, in `spectra.csv`. Default: false.
    pub spectra: bool,
    /// Highest frequency of them in shaft orders. Default: 20.
    #[schemars(range(min = 0.0))]
    pub highest_order: Option<f64>,
    /// Whether the trace of every run is kept, in `traces/trace-<number>.csv`; `traces.csv` says what they are
    /// known by. Default: false.
    pub traces: bool,
    /// Whether stiffness and damping of every bearing at the static equilibrium are kept, in
    /// `stiffness.csv`, and for rotor dynamics with ROSS, in `ross_*.toml`, as functions of the speed.
    /// Default: false.
    pub bearing_stiffness: bool,
    /// Whether the place of the shaft is kept once a revolution or once a ball pass after the settle
    /// time, in `poincare.csv`. Default: not.
    pub poincare: Option<SectionKind>,
}
