//! What in the tables of a scenario contradicts each other, or is hardly meant.

use super::bearing::{BearingInput, no_race_control};
use super::flexible::check_position;
use super::load::LoadInput;
use super::scenario::ScenarioInput;
use super::settings::ContactChoice;
use crate::analysis::SpectrumRequest;
use crate::bearing::{Housing, MountedBearing};
use crate::physics::Race;
use crate::rotor::{FlexibleShaft, Load, LoadKind, MOST_BEARINGS, MOST_HOUSINGS, RotorDefinition};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// How far outside the bearings a position is doubtful, in spans of theirs or pitch diameters.
const FAR: f64 = 10.0;

/// Most loads.
const MOST_LOADS: usize = 1000;

/// Most spectra to be estimated.
const MOST_SPECTRA: usize = 200;

impl ScenarioInput {
    /// Refuses more of a kind than any machine has, before room is made for them.
    pub(super) fn check_counts(&self, problems: &mut Problems<'_>) -> Option<()> {
        let bearings = self.bearing.iter().map(BearingInput::count).sum();
        if self.bearing.is_empty() && self.element.is_empty() {
            let message = "nothing carries the shaft: it has neither a bearing nor an element";
            let help = "for instance: [[bearing]] with catalogue = \"7205C\"";
            problems.refuse(Issue::new("bearing", message).help(help));
        }
        let counts = [
            ("bearing", bearings, MOST_BEARINGS),
            ("element", self.element.len(), MOST_BEARINGS),
            ("load", self.load.len(), MOST_LOADS),
            ("spectrum", self.spectrum.len(), MOST_SPECTRA),
            ("unbalance", self.unbalance.len(), MOST_LOADS),
        ];
        let mut few_enough = true;
        for (key, count, most) in counts.into_iter().filter(|(_, count, most)| count > most) {
            few_enough = false;
            let message = format!("{count} `[[{key}]]` tables; at most {most}");
            problems.refuse(Issue::new(key, message));
        }
        few_enough.then_some(())
    }

    /// Refuses what belongs to a choice where there is none, and what leaves none.
    pub(super) fn check_auto(&self, any_open: bool, problems: &mut Problems<'_>) {
        if self.model.model_error.is_some() && !any_open {
            let message = "`model_error` needs contact = \"auto\": any other law is taken as it is";
            let issue = Issue::new("model.model_error", message)
                .help("remove it, or set contact = \"auto\"");
            problems.refuse(issue.against("model.contact"));
        }
        if self.model.film && self.model.contact == ContactChoice::Auto {
            let message =
                "contact = \"auto\" decides on oil films itself, wherever [bearing.oil] is given";
            let issue = Issue::new("model.film", message)
                .help("remove it, or set film = true in `[[bearing]]`");
            problems.refuse(issue.against("model.contact"));
        }
    }

    /// Refuses what lies off a shaft that bends.
    pub(super) fn check_positions(
        &self,
        shaft: &FlexibleShaft,
        bearings: &[MountedBearing],
        problems: &mut Problems<'_>,
    ) {
        let mut mounted = bearings.iter();
        for (index, bearing) in self.bearing.iter().enumerate() {
            let path = format!("bearing[{}].position", index + 1);
            // those of a set lie on both sides of its position
            for own in mounted.by_ref().take(bearing.count()) {
                check_position(shaft, &path, own.position, problems);
            }
        }
        for (index, element) in self.element.iter().enumerate() {
            if let Some(position) = &element.position {
                let path = format!("element[{}].position", index + 1);
                check_position(shaft, &path, position.si(), problems);
            }
        }
        for (index, load) in self.load.iter().enumerate() {
            if let Some(position) = &load.position {
                let path = format!("load[{}].position", index + 1);
                check_position(shaft, &path, position.si(), problems);
            }
        }
    }

    /// Refuses columns of housings and bearings that are not there, and housings that have no columns.
    pub(super) fn check_housings(
        &self,
        rotor: &RotorDefinition,
        spectra: &[SpectrumRequest],
        problems: &mut Problems<'_>,
    ) {
        let housings = rotor.housings();
        let beyond = |(bearing, _): &(usize, Housing)| *bearing >= MOST_HOUSINGS;
        if housings.iter().any(beyond) {
            let message = format!("only the first {MOST_HOUSINGS} bearings can stand in housings");
            let issue = Issue::new("bearing", message);
            problems.refuse(issue.help("write bearings with a housing first"));
        }
        let shown = self.output.channels.iter().flatten();
        let shown = shown.map(|channel| ("output.channels".to_owned(), channel));
        let analysed = spectra.iter().enumerate().flat_map(|(index, request)| {
            let path = format!("spectrum[{}].channels", index + 1);
            request.channels.iter().map(move |one| (path.clone(), one))
        });
        for (path, channel) in shown.chain(analysed) {
            if let Some([message, help]) = channel.missing_of(rotor) {
                problems.refuse(Issue::new(path, message).help(help));
            }
        }
    }

    /// Warns where the centre of mass or a load is far outside the bearings: most often a unit mistaken.
    pub(super) fn warn_of_far_positions(
        &self,
        bearings: &[MountedBearing],
        problems: &mut Problems<'_>,
    ) {
        let elements = self.element.iter();
        let elements = elements.filter_map(|own| Some(own.position.as_ref()?.si()));
        let positions = bearings.iter().map(|bearing| bearing.position);
        let positions = positions.chain(elements);
        let first = positions.clone().fold(f64::INFINITY, f64::min);
        let last = positions.fold(f64::NEG_INFINITY, f64::max);
        let diameters = bearings.iter();
        let diameters = diameters.map(|bearing| bearing.bearing.geometry.pitch_diameter());
        let reach = FAR * diameters.fold(last - first, f64::max);
        let load = |(index, load): (usize, &LoadInput)| {
            let position = load.position.as_ref()?.si();
            Some((
                format!("the load at `load[{}].position`", index + 1),
                position,
            ))
        };
        let loads = self.load.iter().enumerate().filter_map(load);
        let centre = std::iter::once(("the centre of mass".to_owned(), 0.0));
        for (what, position) in centre.chain(loads) {
            let outside = (first - position).max(position - last);
            if outside > reach && reach > 0.0 {
                problems.warn(format!(
                    "{what} is {:.1} mm outside the bearings, which span {:.1} mm: look at the units of \
                     the positions",
                    1e3 * outside,
                    1e3 * (last - first)
                ));
            }
        }
    }

    /// Refuses what turns with a stationary shaft while the outer rings of its bearings turn.
    pub(super) fn check_standing_shaft(
        &self,
        rotor: &RotorDefinition,
        problems: &mut Problems<'_>,
    ) {
        let mut bearings = self.bearing.iter();
        let Some(index) = bearings.position(|own| own.rotating_ring == Race::Outer) else {
            return;
        };
        let is_sprocket = |load: &Load| matches!(load.kind, LoadKind::Sprocket(_));
        let found = [
            (
                "an unbalance",
                rotor.is_unbalanced(),
                "give what turns with the ring as a `[[load]]` with order = 1",
            ),
            (
                "`speed.drive`",
                rotor.drive.is_some(),
                "give the speed of the ring",
            ),
            (
                "`shaft.internal_damping`",
                self.shaft.internal_damping.is_some(),
                "leave it out",
            ),
            (
                "a sprocket",
                rotor.loads.iter().any(is_sprocket),
                "leave it out",
            ),
            (
                "a bearing whose inner ring turns",
                self.bearing
                    .iter()
                    .any(|own| own.rotating_ring == Race::Inner),
                "give all bearings the same rotating_ring",
            ),
        ];
        for (what, _, help) in found.into_iter().filter(|(_, given, _)| *given) {
            let message = format!(
                "the outer ring turns and the shaft is stationary, but the scene has {what}"
            );
            let key = format!("bearing[{}].rotating_ring", index + 1);
            problems.refuse(Issue::new(key, message).help(help));
        }
    }

    /// Refuses a race control that no bearing's law knows.
    pub(super) fn check_race_control(&self, problems: &mut Problems<'_>) {
        let mut contacts = self.bearing.iter().map(|each| each.contact(&self.model));
        let control = self.model.race_control;
        if control.is_some() && !contacts.any(ContactChoice::knows_inertia) {
            let issue = no_race_control("model.race_control");
            problems.refuse(issue.against("model.contact"));
        }
    }
}
