//! A designation that is in no catalogue, and what to write instead.

use std::collections::BTreeMap;

use super::designation::normal;
use super::{Catalogue, CatalogueEntry, Odd, all_balls, all_rollers, kind};
use crate::bearing::{CatalogueLine, RollerLine};

/// A designation that is in no catalogue.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no bearing of the catalogue is called \"{designation}\": {help}")]
#[non_exhaustive]
pub struct UnknownBearing {
    /// The designation as given.
    pub designation: String,
    /// What comes near, or which bearings there are.
    pub help: String,
}

impl UnknownBearing {
    /// A design with other rollers than those of the entry.
    pub(super) fn of_other_rollers(
        designation: &str,
        (entry, suffix): Odd<'_, '_, RollerLine>,
    ) -> Self {
        let line = &entry.line;
        let kind = line.kind.name();
        let [bore, outside, width] = line.boundary.map(|length| (1e6 * length).round() / 1e3);
        let by_e = match line.contact_angle > 0.0 {
            true => ", and contact_angle = atan(e/1.5)",
            false => "",
        };
        let angle = (1e2 * line.contact_angle.to_degrees()).round() / 1e2;
        let help = format!(
            "it is a {kind} roller bearing of another design ({suffix}), with other rollers and other ratings than \"{}\" of \
             the catalogue (C {:.0} N, C0 {:.0} N): give C and C0 as its maker prints them{by_e}, \
             [bearing.ratings] with kind = \"{kind}\", bore = \"{bore} mm\", outside_diameter = \"{outside} mm\", \
             width = \"{width} mm\", contact_angle = \"{angle} deg\", dynamic = \"… kN\", static = \"… kN\"; or, to see its rollers: \
             jeffcott estimate --kind {kind} --bore {bore}mm --outside-diameter {outside}mm --width {width}mm \
             --contact-angle {angle}deg --dynamic …kN --static …kN",
            entry.designation, line.dynamic_rating, line.static_rating,
        );
        Self {
            designation: designation.to_owned(),
            help,
        }
    }

    /// None of the bearings that there are, where `odd` is one that differs by a suffix that is not known.
    pub(super) fn new(
        file: &Catalogue,
        designation: &str,
        odd: Option<Odd<'_, '_, CatalogueLine>>,
    ) -> Self {
        let wanted = normal(designation);
        let number = |text: &str| {
            let digits = text.trim_start_matches(|c: char| !c.is_ascii_digit());
            let end = digits.find(|c: char| !c.is_ascii_digit());
            digits[..end.unwrap_or(digits.len())].to_owned()
        };
        let wanted_number = number(&wanted);
        let same = |entry: &&CatalogueEntry| wanted_number == number(&entry.designation);
        let same = all_balls(file)
            .find(same)
            .filter(|_| !wanted_number.is_empty());
        let kind = kind::not_modelled(&wanted).filter(|_| odd.is_none());
        let angles = kind::contact_angle(&wanted).zip(same);
        let angles = angles.map(|(angle, entry)| (angle, entry.line.contact_angle.to_degrees()));
        let angles = angles.filter(|(angle, own)| (angle - own).abs() > 0.5);
        let help = match (kind, angles, odd, same) {
            (Some(kind), ..) if kind::has_rollers(kind) => format!(
                "it is {kind}: give its rollers in [bearing.roller], or the line of its maker's catalogue in [bearing.ratings] \
                 with `kind` and `width`"
            ),
            (Some(kind), ..) => format!(
                "it is {kind}; jeffcott models ball bearings with one row, deep groove and angular contact, and radial roller bearings only so far"
            ),
            (_, Some((angle, own)), _, Some(entry)) => format!(
                "its suffix stands for a contact angle of {angle}°, and \"{}\", of {own:.0}°, is another bearing: give the \
                 line of its maker's catalogue in [bearing.ratings] with contact_angle = \"{angle} deg\", or its inside in \
                 [bearing.geometry]",
                entry.designation
            ),
            (_, _, Some((entry, part)), _) => format!(
                "the suffix \"{part}\" is not known; if it changes neither balls nor races, write \"{}\", else give \
                 [bearing.ratings] with the line of its maker's catalogue",
                entry.designation
            ),
            (_, _, None, Some(entry)) => format!("did you mean \"{}\"?", entry.designation),
            (_, _, None, None) => format!(
                "there are {}; any other bearing with one row of balls, or with rollers, is found from its catalogue line in \
                 [bearing.ratings], which of rollers has `kind` and `width`",
                series(file)
            ),
        };
        Self {
            designation: designation.to_owned(),
            help,
        }
    }
}

/// The designations, balls before rollers, series by series: `6000 to 6024`.
fn series(file: &Catalogue) -> String {
    let balls = all_balls(file).map(|entry| (false, entry.designation.as_str()));
    let rollers = all_rollers(file).map(|entry| (true, entry.designation.as_str()));
    let mut groups: BTreeMap<_, [&str; 2]> = BTreeMap::new();
    for (rolls, name) in balls.chain(rollers) {
        let number = name.trim_start_matches(|c: char| !c.is_ascii_digit());
        let suffix = number.trim_start_matches(|c: char| c.is_ascii_digit());
        let series = number.len().saturating_sub(suffix.len() + 2);
        let prefix = &name[..name.len() - number.len()];
        let group = (rolls, prefix, &number[..series], suffix);
        let [first, last] = groups.entry(group).or_insert([name, name]);
        *first = name.min(first);
        *last = name.max(last);
    }
    let spans = groups.values().map(|[first, last]| match first == last {
        true => (*first).to_owned(),
        false => format!("{first} to {last}"),
    });
    spans.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::catalogue::EMPTY;

    #[test]
    fn series_of_balls_and_of_rollers_are_listed() {
        let series = series(&EMPTY);
        for expected in [
            "6200 to 6220",
            "7200C to 7210C",
            "30204 to 30212",
            "NU2205 to NU2212",
        ] {
            assert!(
                series.split(", ").any(|found| found == expected),
                "{series}"
            );
        }
    }
}
