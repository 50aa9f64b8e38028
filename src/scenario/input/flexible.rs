//! `[[shaft.section]]` and `[[disc]]`: the shaft that bends.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::disc::{DiscInput, check_hubs};
use super::material::{MaterialInput, material};
use super::shaft::ShaftInput;
use super::unbalance::UnbalanceInput;
use crate::physics::{BeamElement, Material};
use crate::rotor::{FlexibleShaft, Freedoms, PointUnbalance};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Length, Quantity, si};
use crate::scenario::{Issue, matrices_file};

/// Steel of shafts, E = 210 GPa, ν = 0.3, 7850 kg/m³ (EN 1993-1-1 and tables of carbon steels).
pub(super) const STEEL: Material = Material {
    youngs_modulus: 210e9,
    poisson_ratio: 0.3,
    density: 7850.0,
};

/// Most sections of a shaft.
const MOST_SECTIONS: usize = 200;

/// A part of the shaft of one cross-section. Sections follow each other from the left end on, towards +Z.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SectionInput {
    /// Length, for instance "120 mm".
    #[schemars(extend("examples" = ["120 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Outer diameter, for instance "40 mm".
    #[schemars(extend("examples" = ["40 mm"], "x-above" = 0.0))]
    pub outer_diameter: Quantity<Length>,
    /// Inner diameter of a hollow section. Default: "0 m", solid.
    #[serde(default)]
    #[schemars(extend("examples" = ["20 mm"], "x-minimum" = 0.0))]
    pub inner_diameter: Quantity<Length>,
    /// Material where it differs from that of the shaft.
    pub material: Option<MaterialInput>,
}

/// The shaft that bends; `Some(None)` where it is rigid, `None` where something contradicts it.
pub fn build(
    shaft: &ShaftInput,
    discs: &[DiscInput],
    unbalances: &[UnbalanceInput],
    problems: &mut Problems<'_>,
) -> Option<Option<FlexibleShaft>> {
    if !shaft.bends() {
        refuse_without_sections(shaft, discs, problems);
        return Some(None);
    }
    refuse_of_rigid(shaft, problems);
    refuse_without_mass(shaft, discs, problems);
    let base = material(shaft.material.as_ref(), STEEL);
    let matrices = shaft.matrices.as_ref().map(|file| {
        matrices_file::read(&problems.folder.join(file)).map_err(|problem| {
            let message = format!("`{file}` is no shaft: {problem}");
            Issue::new("shaft.matrices", message)
        })
    });
    let matrices = problems.take(matrices.transpose())?;
    let sections = problems.each("shaft.section", &shaft.section, |section, problems| {
        let mut section = section.build(base, problems)?;
        if shaft.massless {
            section.material.density = 0.0;
        }
        Some(section)
    });
    let mut flexible = FlexibleShaft {
        sections: sections?,
        matrices,
        modes: shaft.modes.map(|modes| modes as usize),
        internal_damping: si(&shaft.internal_damping).unwrap_or(0.0),
        ..FlexibleShaft::default()
    };
    let discs = problems.each("disc", discs, |disc, problems| {
        disc.with_hub(&flexible, problems)
    });
    flexible.discs = discs?;
    check_hubs(&flexible.discs, problems);
    for (index, plane) in unbalances.iter().enumerate() {
        let path = format!("unbalance[{}].position", index + 1);
        if problems.node(&path).is_none() {
            let message = "an unbalance of a shaft that bends needs a `position`";
            let issue = Issue::new(format!("unbalance[{}]", index + 1), message);
            problems.refuse(issue.help("it counts from the left end of the shaft"));
        }
        check_position(&flexible, &path, plane.position.si(), problems);
        flexible.unbalances.push(PointUnbalance {
            position: plane.position.si(),
            amount: plane.amount.si(),
            angle: plane.angle.si(),
        });
    }
    flexible.observed = if let Some(position) = &shaft.observed {
        check_position(&flexible, "shaft.observed", position.si(), problems);
        position.si()
    } else {
        let discs = flexible.discs.iter();
        let heaviest = discs.max_by(|a, b| a.mass.total_cmp(&b.mass));
        heaviest.map_or(flexible.middle(), |disc| disc.position)
    };
    Some(Some(flexible))
}

/// Refuses a position off the shaft, or between the nodes of given matrices.
pub fn check_position(
    shaft: &FlexibleShaft,
    path: &str,
    position: f64,
    problems: &mut Problems<'_>,
) {
    if problems.has_fault("shaft.section") {
        return;
    }
    let [left, right] = shaft.ends();
    if !shaft.reaches(position) {
        let message = format!(
            "{:.1} mm lies off the shaft, which reaches from {:.1} to {:.1} mm",
            1e3 * position,
            1e3 * left,
            1e3 * right
        );
        let help = match shaft.matrices {
            Some(_) => "positions count as those of the nodes in the file do",
            None => "positions count from the left end of the first section",
        };
        problems.refuse(Issue::new(path, message).help(help));
        return;
    }
    let mesh = shaft.matrices.as_ref();
    let nearest = mesh.map(|mesh| mesh.nodes[mesh.node_at(position)]);
    if let Some(nearest) = nearest.filter(|nearest| (nearest - position).abs() > shaft.slack()) {
        let message = format!(
            "no node of the shaft's matrices lies at {:.3} mm: the nearest one is at {:.3} mm",
            1e3 * position,
            1e3 * nearest
        );
        let help = "put it at a node, or let the other program set a node there";
        problems.refuse(Issue::new(path, message).help(help));
    }
}

/// Refuses what only a shaft that bends has.
fn refuse_without_sections(shaft: &ShaftInput, discs: &[DiscInput], problems: &mut Problems<'_>) {
    let keys = [
        ("shaft.modes", shaft.modes.is_some()),
        ("shaft.observed", shaft.observed.is_some()),
        ("shaft.internal_damping", shaft.internal_damping.is_some()),
        ("shaft.material", shaft.material.is_some()),
        ("shaft.massless", shaft.massless),
        ("disc", !discs.is_empty()),
    ];
    for (path, _) in keys.into_iter().filter(|(_, given)| *given) {
        let key = path.trim_start_matches("shaft.");
        let message = format!("`{key}` belongs to a shaft that bends, and this one is rigid");
        let help = "describe it by [[shaft.section]], or leave this out";
        problems.refuse(Issue::new(path, message).help(help));
    }
    if shaft.mass.is_none() {
        let message = "`shaft` needs a `mass`, or sections that it consists of";
        problems.refuse(Issue::new("shaft", message).help(
            "for instance: mass = \"5 kg\", or [[shaft.section]] with length and outer_diameter",
        ));
    }
}

/// Refuses what follows from the sections and discs of a shaft that bends.
fn refuse_of_rigid(shaft: &ShaftInput, problems: &mut Problems<'_>) {
    if shaft.freedoms == Some(Freedoms::Translational) {
        let issue = Issue::new("shaft.freedoms", "a shaft that bends tilts, too");
        problems.refuse(issue.help("write \"all\", or \"lateral\" to hold it along z"));
    }
    let follows = "it follows from sections and discs";
    let planes = "write [[unbalance]] with amount and position";
    let tilts = "a shaft that bends tilts as it must";
    let keys = [
        ("mass", shaft.mass.is_some(), follows),
        (
            "inertia_transverse",
            shaft.inertia_transverse.is_some(),
            follows,
        ),
        ("inertia_polar", shaft.inertia_polar.is_some(), follows),
        ("eccentricity", shaft.eccentricity.si() != 0.0, planes),
        ("unbalance", shaft.unbalance.is_some(), planes),
        ("tilt_x", shaft.tilt_x.is_some(), tilts),
        ("tilt_y", shaft.tilt_y.is_some(), tilts),
    ];
    for (key, _, help) in keys.into_iter().filter(|(_, given, _)| *given) {
        let message = format!("`{key}` belongs to a rigid shaft, and this one bends");
        problems.refuse(Issue::new(format!("shaft.{key}"), message).help(help));
    }
    if !shaft.section.is_empty() && shaft.matrices.is_some() {
        let message = "`section` and `matrices` both say what the shaft is";
        let issue = Issue::new("shaft.matrices", message).help("keep one of them");
        problems.refuse(issue.against("shaft.section"));
    }
    if shaft.section.len() > MOST_SECTIONS {
        let message = format!("{} sections; at most {MOST_SECTIONS}", shaft.section.len());
        problems.refuse(Issue::new("shaft.section", message));
    }
}

/// Refuses a massless shaft that nothing gives a mass, or whose mass another program has given.
fn refuse_without_mass(shaft: &ShaftInput, discs: &[DiscInput], problems: &mut Problems<'_>) {
    if !shaft.massless {
        return;
    }
    if shaft.matrices.is_some() {
        let message = "the mass of `matrices` is in their file";
        let issue = Issue::new("shaft.massless", message).help("leave one of them out");
        problems.refuse(issue.against("shaft.matrices"));
    }
    if discs.is_empty() {
        let issue = Issue::new("shaft.massless", "a massless shaft needs a disc");
        problems.refuse(issue.help("add [[disc]] with position, outer_diameter and width"));
    }
}

/// Refuses a bore, m, that is as wide as what it is in.
pub(super) fn check_bore(
    inner: f64,
    outer: f64,
    part: &str,
    problems: &mut Problems<'_>,
) -> Option<()> {
    if inner < outer {
        return Some(());
    }
    let message = format!(
        "a bore of {:.2} mm leaves nothing of a {part} of {:.2} mm",
        1e3 * inner,
        1e3 * outer
    );
    let issue = Issue::new(".inner_diameter", message);
    problems.refuse(issue.against(".outer_diameter"));
    None
}

impl SectionInput {
    fn build(&self, base: Material, problems: &mut Problems<'_>) -> Option<BeamElement> {
        let (outer, inner) = (self.outer_diameter.si(), self.inner_diameter.si());
        check_bore(inner, outer, "section", problems)?;
        Some(BeamElement {
            length: self.length.si(),
            outer_diameter: outer,
            inner_diameter: inner,
            material: material(self.material.as_ref(), base),
        })
    }
}
