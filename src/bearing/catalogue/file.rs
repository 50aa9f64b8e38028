//! Reads catalogue files, the one that is shipped and the user's own.

use std::ops::Bound::{self, Excluded, Included, Unbounded};
use std::ops::RangeBounds;

use super::{Catalogue, CatalogueEntry, normal};
use crate::bearing::{CatalogueLine, RollerKind, RollerLine};

/// Columns of a catalogue file that must be there.
const NEEDED: [&str; 5] = [
    "designation",
    "bore_mm",
    "outside_diameter_mm",
    "contact_angle_deg",
    "dynamic_rating_N",
];

/// Columns that may be there.
const OPTIONAL: [&str; 6] = [
    "kind",
    "static_rating_N",
    "pitch_diameter_mm",
    "width_mm",
    "maker",
    "source",
];

/// Columns that ball bearings may have.
const OF_BALLS: [&str; 5] = [
    "f0",
    "balls",
    "ball_diameter_mm",
    "groove_factor_inner",
    "groove_factor_outer",
];

/// Columns that roller bearings may have.
const OF_ROLLERS: [&str; 3] = ["rollers", "roller_diameter_mm", "roller_length_mm"];

/// Kinds of bearings by their names; a ball bearing may say nothing.
const KINDS: [RollerKind; 4] = [
    RollerKind::Cylindrical,
    RollerKind::Needle,
    RollerKind::Tapered,
    RollerKind::Spherical,
];

/// Columns of numbers with the least and the largest that they may have, which are those of `[bearing.ratings]`,
/// `[bearing.geometry]` and `[bearing.roller]` of a scenario.
const LIMITS: [(&[&str], Bound<f64>, f64); 7] = [
    (
        &["bore_mm", "outside_diameter_mm", "width_mm"],
        Included(0.1),
        1e6,
    ),
    (
        &[
            "ball_diameter_mm",
            "pitch_diameter_mm",
            "roller_diameter_mm",
            "roller_length_mm",
        ],
        Included(0.01),
        1e6,
    ),
    (&["contact_angle_deg"], Included(0.0), 60.0),
    (
        &["dynamic_rating_N", "static_rating_N"],
        Excluded(0.0),
        1e12,
    ),
    (&["f0"], Excluded(0.0), 30.0),
    (&["balls", "rollers"], Included(3.0), 200.0),
    (
        &["groove_factor_inner", "groove_factor_outer"],
        Excluded(0.5),
        1.0,
    ),
];

/// Most problems of a catalogue file that are named.
const MOST_PROBLEMS: usize = 20;

/// Reads the bearings of a catalogue file: CSV with a header, one bearing a row.
///
/// # Errors
/// Everything that is wrong with it, each with its line.
pub(crate) fn read(text: &str) -> Result<Catalogue, Vec<String>> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
    let header = reader
        .headers()
        .map_err(|error| vec![error.to_string()])?
        .clone();
    let mut problems = header_problems(&header);
    if !problems.is_empty() {
        return Err(problems);
    }
    let mut catalogue = Catalogue::default();
    for record in reader.records() {
        let header = &header;
        let added = record
            .map_err(|error| vec![error.to_string()])
            .and_then(|record| Row { header, record }.add_to(&mut catalogue));
        problems.extend(added.err().into_iter().flatten());
    }
    if catalogue == Catalogue::default() && problems.is_empty() {
        problems.push("it has no bearing".to_owned());
    }
    if problems.len() > MOST_PROBLEMS {
        let more = problems.len() - MOST_PROBLEMS;
        problems.truncate(MOST_PROBLEMS);
        problems.push(format!("and {more} more"));
    }
    problems.is_empty().then_some(catalogue).ok_or(problems)
}

fn header_problems(header: &csv::StringRecord) -> Vec<String> {
    let known = || [&NEEDED[..], &OPTIONAL, &OF_BALLS, &OF_ROLLERS].concat();
    let missing = NEEDED
        .iter()
        .filter(|name| !header.iter().any(|h| h == **name));
    let missing = missing.map(|name| format!("it has no column `{name}`"));
    let strange = header.iter().filter(|name| !known().contains(name));
    let strange = strange.map(|name| {
        let names = known().join(", ");
        format!("it has a column `{name}`; known are {names}")
    });
    let twice = header.iter().enumerate();
    let twice = twice.filter(|(index, name)| header.iter().take(*index).any(|h| h == *name));
    let twice = twice.map(|(_, name)| format!("it has two columns `{name}`"));
    missing.chain(strange).chain(twice).collect()
}

/// A row of a catalogue file.
struct Row<'a> {
    header: &'a csv::StringRecord,
    record: csv::StringRecord,
}

impl Row<'_> {
    fn text(&self, column: &str) -> &str {
        let place = self.header.iter().position(|name| name == column);
        place.and_then(|place| self.record.get(place)).unwrap_or("")
    }

    /// The number of a column; none where it is empty.
    fn number(&self, column: &str, problems: &mut Vec<String>) -> Option<f64> {
        let text = self.text(column);
        if text.is_empty() {
            if NEEDED.contains(&column) {
                problems.push(format!("`{column}` is empty"));
            }
            return None;
        }
        let Ok(number) = text.parse::<f64>() else {
            problems.push(format!("`{column}` has \"{text}\", which is not a number"));
            return None;
        };
        let limits = LIMITS
            .iter()
            .find(|(columns, ..)| columns.contains(&column));
        let inside = |least: Bound<f64>, most| (least, Included(most)).contains(&number);
        match limits {
            Some(&(_, least, most)) if !inside(least, most) => {
                let least = match least {
                    Excluded(least) => format!("above {least}"),
                    Included(least) => format!("at least {least}"),
                    Unbounded => String::new(),
                };
                problems.push(format!(
                    "`{column}` must be {least} and at most {most}, not {text}"
                ));
                None
            }
            _ => Some(number),
        }
    }

    /// The length of a column in mm, m.
    fn length(&self, column: &str, problems: &mut Vec<String>) -> Option<f64> {
        self.number(column, problems).map(|length| length / 1e3)
    }

    /// A whole number of a column; none where it is empty.
    fn count(&self, column: &str, problems: &mut Vec<String>) -> Option<usize> {
        let number = self.number(column, problems)?;
        if number.fract() != 0.0 {
            problems.push(format!(
                "`{column}` must be a whole number, not {}",
                self.text(column)
            ));
        }
        Some(number as usize)
    }

    /// Adds the bearing of the row.
    fn add_to(&self, catalogue: &mut Catalogue) -> Result<(), Vec<String>> {
        let mut problems = Vec::new();
        if self.text("designation").is_empty() {
            problems.push("`designation` is empty".to_owned());
        }
        let added = match self.text("kind") {
            "" | "ball" => {
                self.refuse(&OF_ROLLERS, "a ball bearing", &mut problems);
                let line = self.ball_bearing(&mut problems);
                line.map(|line| catalogue.balls.push(self.entry(line)))
            }
            name => {
                self.refuse(&OF_BALLS, "a roller bearing", &mut problems);
                let line = self.roller_bearing(name, &mut problems);
                line.map(|line| catalogue.rollers.push(self.entry(line)))
            }
        };
        match added {
            Some(()) if problems.is_empty() => Ok(()),
            _ => {
                let line = self.record.position().map_or(0, csv::Position::line);
                let with_line = |problem: &String| format!("line {line}: {problem}");
                Err(problems.iter().map(with_line).collect())
            }
        }
    }

    /// Refuses what a bearing cannot have.
    fn refuse(&self, columns: &[&str], of: &str, problems: &mut Vec<String>) {
        let given = columns
            .iter()
            .filter(|column| !self.text(column).is_empty());
        problems.extend(given.map(|column| format!("{of} has no `{column}`")));
    }

    /// The bearing with what is printed of it.
    fn entry<L>(&self, line: L) -> CatalogueEntry<L> {
        CatalogueEntry {
            designation: self.text("designation").to_owned(),
            key: normal(self.text("designation")),
            maker: self.text("maker").to_owned(),
            source: self.text("source").to_owned(),
            line,
        }
    }

    fn ball_bearing(&self, problems: &mut Vec<String>) -> Option<CatalogueLine> {
        let balls = self.count("balls", problems);
        let [bore, outside, ball, pitch, width] = [
            "bore_mm",
            "outside_diameter_mm",
            "ball_diameter_mm",
            "pitch_diameter_mm",
            "width_mm",
        ]
        .map(|column| self.length(column, problems));
        let [angle, dynamic, statical, factor, inner, outer] = [
            "contact_angle_deg",
            "dynamic_rating_N",
            "static_rating_N",
            "f0",
            "groove_factor_inner",
            "groove_factor_outer",
        ]
        .map(|column| self.number(column, problems));
        let [has_inner, has_outer] = ["groove_factor_inner", "groove_factor_outer"]
            .map(|column| !self.text(column).is_empty());
        if has_inner != has_outer {
            problems.push("give both groove factors or none".to_owned());
        }
        Some(CatalogueLine {
            bore: bore?,
            outside_diameter: outside?,
            width,
            contact_angle: angle?.to_radians(),
            dynamic_rating: dynamic?,
            static_rating: statical,
            static_factor: factor,
            balls,
            ball_diameter: ball,
            pitch_diameter: pitch,
            groove_factors: inner.zip(outer).map(Into::into),
        })
    }

    fn roller_bearing(&self, kind: &str, problems: &mut Vec<String>) -> Option<RollerLine> {
        let named = KINDS.into_iter().find(|known| known.name() == kind);
        if named.is_none() {
            let names = KINDS.map(RollerKind::name).join(", ");
            problems.push(format!(
                "`kind` must be ball, {names} or empty, not \"{kind}\""
            ));
        }
        for column in ["width_mm", "static_rating_N"] {
            if self.text(column).is_empty() {
                problems.push(format!("a roller bearing needs `{column}`"));
            }
        }
        let rollers = self.count("rollers", problems);
        let [bore, outside, width, diameter, length, pitch] = [
            "bore_mm",
            "outside_diameter_mm",
            "width_mm",
            "roller_diameter_mm",
            "roller_length_mm",
            "pitch_diameter_mm",
        ]
        .map(|column| self.length(column, problems));
        let [angle, dynamic, statical] =
            ["contact_angle_deg", "dynamic_rating_N", "static_rating_N"]
                .map(|column| self.number(column, problems));
        Some(RollerLine {
            kind: named?,
            boundary: [bore?, outside?, width?],
            contact_angle: angle?.to_radians(),
            dynamic_rating: dynamic?,
            static_rating: statical?,
            rollers,
            diameter,
            length,
            pitch_diameter: pitch,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_that_is_wrong_is_told_with_its_line() {
        let needed = "designation,bore_mm,outside_diameter_mm,contact_angle_deg,dynamic_rating_N";
        let text = format!("{needed}\nA,25,52,0,many\nB,-1,52,0,1000\n,1,2,0,3\n");
        let problems = read(&text).expect_err("three problems");
        assert_eq!(problems.len(), 3, "{problems:?}");
        assert!(problems[1].starts_with("line 3: `bore_mm` must be at least 0.1"));
        let kinds = needed.to_owned() + ",kind,balls,rollers";
        let text = format!(
            "{kinds}\nA,25,52,0,1000,cone,,\nB,25,52,0,1000,needle,9,\nC,25,52,0,1000,,,11\n"
        );
        let problems = read(&text).expect_err("what does not belong together");
        for reported in [
            "line 2: `kind` must be ball, cylindrical, needle",
            "line 3: a roller bearing has no `balls`",
            "line 3: a roller bearing needs `width_mm`",
            "line 4: a ball bearing has no `rollers`",
        ] {
            assert!(
                problems.iter().any(|problem| problem.starts_with(reported)),
                "{problems:?}"
            );
        }
        for (column, wrong, right) in [
            ("bore_mm", "0.05", "10"),
            ("width_mm", "1e7", "9"),
            ("balls", "1e300", "9"),
            ("balls", "2", "3"),
            ("balls", "8.5", "200"),
            ("ball_diameter_mm", "inf", "5"),
            ("contact_angle_deg", "-15", "0"),
            ("contact_angle_deg", "60.1", "60"),
            ("dynamic_rating_N", "1e300", "1e12"),
            ("static_rating_N", "NaN", "7000"),
            ("f0", "31", "14.2"),
            ("groove_factor_inner", "0.5", "0.51"),
        ] {
            let file = |value: &str| {
                let mut columns = vec![
                    ("designation", "A"),
                    ("bore_mm", "25"),
                    ("outside_diameter_mm", "52"),
                    ("contact_angle_deg", "0"),
                    ("dynamic_rating_N", "14000"),
                    ("groove_factor_outer", "0.53"),
                    ("groove_factor_inner", "0.52"),
                ];
                columns.retain(|(name, _)| *name != column);
                columns.push((column, value));
                let (names, cells): (Vec<_>, Vec<_>) = columns.into_iter().unzip();
                format!("{}\n{}\n", names.join(","), cells.join(","))
            };
            let problems = read(&file(wrong)).expect_err(column);
            assert!(
                matches!(&problems[..], [only] if only.starts_with(&format!("line 2: `{column}`"))),
                "{problems:?}"
            );
            assert!(read(&file(right)).is_ok(), "{column}");
        }
        let problems = read("designation,bore\nA,1\n").expect_err("columns");
        assert!(problems.iter().any(|problem| problem.contains("`bore`")));
    }
}
