//! The shaft with what holds, loads and turns it.

use super::damping;
use super::element::{self, ElementInput};
use super::flexible;
use super::held::warn_where_unheld;
use super::load::{self, LoadContext};
use super::scenario::ScenarioInput;
use super::settings::ContactChoice;
use super::shaft::TorsionInput;
use super::unbalance;
use crate::bearing::MountedBearing;
use crate::bearing::catalogue::Catalogue;
use crate::rotor::{
    Disc, Drive, ForceElement, Freedoms, InitialState, Load, RotorDefinition, Shaft,
};
use crate::scenario::problems::Problems;
use crate::scenario::{Issue, catalogue_file};

/// Place of z among the freedoms.
const AXIAL: usize = 2;

impl ScenarioInput {
    /// The rotor, as far as nothing contradicts it.
    pub(super) fn rotor(&self, problems: &mut Problems<'_>) -> Option<RotorDefinition> {
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
        for warning in rotor.beyond_tables(rotor.speed_range()) {
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
}
