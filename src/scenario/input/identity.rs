//! What says which bearing it is: its designation, what a catalogue prints, or its dimensions.

use super::ratings::RatingsInput;
use crate::bearing::catalogue::{self, Catalogue, CatalogueEntry, Found, Suffixes};
use crate::bearing::{CatalogueLine, ClearanceClass, EstimateError, RollerLine};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// What says which bearing it is.
pub struct Identity<'a> {
    /// Its designation.
    pub catalogue: Option<&'a str>,
    /// What a catalogue prints of it.
    pub ratings: Option<&'a RatingsInput>,
    /// Whether dimensions are given.
    pub has_dimensions: bool,
    /// Class of the clearance, where it is given.
    pub clearance_class: Option<ClearanceClass>,
}

/// What a catalogue prints of a bearing.
pub struct Printed<L = CatalogueLine> {
    /// The line.
    pub line: L,
    /// Its designation, or what stands for it.
    pub name: String,
    /// The key that gives it, from the bearing.
    pub key: &'static str,
    /// Class of the clearance that its suffixes name.
    pub class: Option<ClearanceClass>,
    /// Whether they name seals whose lips rub.
    pub rubs: bool,
}

/// What a catalogue prints of a bearing of balls or rollers.
pub enum PrintedBearing {
    Balls(Printed),
    Rollers(Printed<RollerLine>),
}

impl PrintedBearing {
    /// Whether it has seals whose lips rub.
    pub fn rubs(&self) -> bool {
        match self {
            Self::Balls(printed) => printed.rubs,
            Self::Rollers(printed) => printed.rubs,
        }
    }
}

impl<L: Copy> Printed<L> {
    /// The line of `[bearing.ratings]`.
    fn rated(line: L) -> Self {
        Self {
            line,
            name: "the bearing of these ratings".to_owned(),
            key: ".ratings",
            class: None,
            rubs: false,
        }
    }

    fn found(entry: &CatalogueEntry<L>, suffixes: Suffixes) -> Self {
        Self {
            line: entry.line,
            name: entry.designation.clone(),
            key: ".catalogue",
            class: suffixes.class,
            rubs: suffixes.rubs,
        }
    }

    /// The problem of a line that belongs to no bearing.
    pub fn wrong(&self, error: &EstimateError) -> Issue {
        Issue::new(self.key, format!("{}: {error}", self.name))
    }
}

impl Identity<'_> {
    /// What a catalogue prints of the bearing, `Some(None)` where only the dimensions are given; `None` where nothing tells what
    /// the bearing is.
    pub fn printed(
        &self,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Option<PrintedBearing>> {
        let printed = match (self.catalogue, self.ratings) {
            (Some(_), Some(_)) => {
                let message = "`catalogue` and `ratings` both say what the bearing is";
                let issue = Issue::new(".ratings", message).help("keep one of them");
                Err(issue.against(".catalogue"))
            }
            (None, Some(ratings)) => Ok(Some(match ratings.kind {
                None => PrintedBearing::Balls(Printed::rated(ratings.line())),
                Some(kind) => {
                    let line = ratings.roller_line(kind, problems)?;
                    PrintedBearing::Rollers(Printed::rated(line))
                }
            })),
            (None, None) if self.has_dimensions => Ok(None),
            (None, None) => {
                let message = format!(
                    "`{}` needs `catalogue`, a table `[bearing.ratings]`, `[bearing.geometry]` or `[bearing.roller]`",
                    problems.path(".")
                );
                let issue =
                    Issue::new(".catalogue", message).help("for instance: catalogue = \"7205C\"");
                Err(issue.against_all([".geometry", ".ratings"]))
            }
            (Some(designation), None) => self.found(catalogue, designation, problems).map(Some),
        };
        problems.take(printed)
    }

    fn found(
        &self,
        catalogue: &Catalogue,
        designation: &str,
        problems: &mut Problems<'_>,
    ) -> Result<PrintedBearing, Issue> {
        let found = catalogue::look_up(catalogue, designation);
        let (found, suffixes) = found.map_err(|unknown| {
            let message = format!("the catalogue has no bearing \"{designation}\"");
            Issue::new(".catalogue", message).help(unknown.help)
        })?;
        if let (Some(named), Some(given)) = (suffixes.class, self.clearance_class)
            && named != given
        {
            let message = format!(
                "\"{designation}\" has the clearance {}, and `clearance_class` is {}",
                named.name(),
                given.name()
            );
            let issue = Issue::new(".clearance_class", message).help("keep one of them");
            problems.refuse(issue.against(".catalogue"));
        }
        Ok(match found {
            Found::Balls(entry) => PrintedBearing::Balls(Printed::found(entry, suffixes)),
            Found::Rollers(entry) => PrintedBearing::Rollers(Printed::found(entry, suffixes)),
        })
    }
}
