//! What says which bearing it is: its designation, what a catalogue prints, or its dimensions.

use super::geometry::Printed;
use super::ratings::RatingsInput;
use crate::bearing::catalogue::Catalogue;
use crate::bearing::{ClearanceClass, catalogue};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// What says which bearing it is.
pub struct Identity<'a> {
    /// Its designation.
    pub catalogue: Option<&'a str>,
    /// What a catalogue prints of it.
    pub ratings: Option<&'a RatingsInput>,
    /// Whether dimensions are given.
    pub has_geometry: bool,
    /// Class of the clearance, where it is given.
    pub clearance_class: Option<ClearanceClass>,
}

impl Identity<'_> {
    /// What a catalogue prints of the bearing, `Some(None)` where only the geometry is given; `None` where nothing tells what
    /// the bearing is.
    pub fn printed(
        &self,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Option<Printed>> {
        let printed = match (self.catalogue, self.ratings) {
            (Some(_), Some(_)) => {
                let message = "`catalogue` and `ratings` both say what the bearing is";
                let issue = Issue::new(".ratings", message).help("keep one of them");
                Err(issue.against(".catalogue"))
            }
            (None, Some(ratings)) => Ok(Some(Printed {
                line: ratings.line(),
                name: "the bearing of these ratings".to_owned(),
                key: ".ratings",
                class: None,
            })),
            (None, None) if self.has_geometry => Ok(None),
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
    ) -> Result<Printed, Issue> {
        let found = catalogue::look_up(catalogue, designation).map_err(|unknown| {
            let message = format!("the catalogue has no bearing \"{designation}\"");
            Issue::new(".catalogue", message).help(unknown.help)
        })?;
        if let (Some(named), Some(given)) = (found.class, self.clearance_class)
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
        Ok(Printed {
            line: found.entry.line,
            name: found.entry.designation.clone(),
            key: ".catalogue",
            class: found.class,
        })
    }
}
