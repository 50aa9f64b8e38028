//! Study files as they are written, and the study that they make of a scenario.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::axis::{AxisInput, AxisReader};
use super::document::Document;
use super::keep_input::KeepInput;
use super::key::{Key, all_keys};
use super::key_path::entry;
use super::problems::Problems;
use super::set_input::SetInput;
use super::study_file::{StudyFile, TIMES};
use super::{Issue, Scenario, ScenarioError, echo, key, questions, read_input, reader, without};
use crate::study::many::{Ask, Cycles, Keep, NumberColumn, Sweep, number_columns, static_columns};
use crate::study::plan::{Axis, MOST_RUNS, MOST_SOBOL_AXES, Plan, Sampling};

/// Tables of a scenario that play no part in what a study asks.
fn left_out(ask: Ask) -> &'static [&'static str] {
    match ask {
        Ask::Run => &["static"],
        Ask::Bearing => &["damping", "initial", "time", "integrator", "output"],
    }
}

/// Highest order of the spectra that are kept where none is given.
const HIGHEST_ORDER: f64 = 20.0;

/// Many runs of one scenario.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "jeffcott study")]
pub(super) struct StudyFileInput {
    /// What the study is called. Default: the name of its file.
    pub title: Option<String>,
    /// What is asked at every point: how the shaft moves, or its static equilibrium. Default: "run".
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
pub(super) enum SamplingKind {
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

impl StudyFileInput {
    /// The study of the scenario that it names, as far as nothing contradicts it.
    ///
    /// # Errors
    /// [`ScenarioError`] of that scenario.
    pub fn on_base(
        &self,
        document: &Document,
        problems: &mut Problems<'_>,
    ) -> Result<Option<StudyFile>, ScenarioError> {
        let Some((scenario, folder)) = document.base(&self.base, problems)? else {
            return Ok(None);
        };
        let title = self.title.clone().unwrap_or_else(|| document.stem());
        Ok(self.study(&scenario, title, folder, problems))
    }

    /// The study of a scenario whose files are in `folder`.
    pub fn study(
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
                let help = "add one, or ask for its static equilibrium: ask = \"bearing\"";
                problems.refuse(issue.help(help));
                return None;
            }
            Ask::Run => number_columns(rotor),
            Ask::Bearing => static_columns(rotor),
        };
        self.check_asked(problems);
        let columns = self.columns(all, problems);
        let (base, set, repeated) = self.base_scenario(scenario, &folder, problems)?;
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
        SetInput::refuse_decided(&set, &keys, "changes along an axis", problems);
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

    /// The scenario with what all runs have otherwise, the keys of that, and its warnings.
    fn base_scenario(
        &self,
        scenario: &Scenario,
        folder: &Path,
        problems: &mut Problems<'_>,
    ) -> Option<(Value, Vec<Key>, Vec<String>)> {
        let mut base = match self.ask {
            Ask::Run => scenario.echo.clone(),
            Ask::Bearing => without(&scenario.echo, left_out(self.ask)),
        };
        let known = all_keys(&base, left_out(self.ask));
        let set = SetInput::put(&self.set, &known, &mut base, problems)?;
        let found = questions(&base, folder, read_input).map_err(|issue| {
            let message = format!("the base with `set`: {}", issue.message);
            Issue::new("set", message)
        });
        let warnings = problems.take(found)?.question.rotor.warnings;
        Some((base, set, warnings))
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
