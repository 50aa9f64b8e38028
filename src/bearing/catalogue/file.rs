//! Reads catalogue files, the one that is shipped and the user's own.

use super::CatalogueEntry;
use crate::bearing::CatalogueLine;

/// Columns of a catalogue file that must be there.
const NEEDED: [&str; 5] = [
    "designation",
    "bore_mm",
    "outside_diameter_mm",
    "contact_angle_deg",
    "dynamic_rating_N",
];

/// Columns that may be there.
const OPTIONAL: [&str; 10] = [
    "static_rating_N",
    "f0",
    "balls",
    "ball_diameter_mm",
    "pitch_diameter_mm",
    "groove_factor_inner",
    "groove_factor_outer",
    "width_mm",
    "maker",
    "source",
];

/// Most problems of a catalogue file that are named.
const MOST_PROBLEMS: usize = 20;

/// Reads the bearings of a catalogue file: CSV with a header, one bearing a row.
///
/// # Errors
/// Everything that is wrong with it, each with its line.
pub(crate) fn read(text: &str) -> Result<Vec<CatalogueEntry>, Vec<String>> {
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
    let mut entries = Vec::new();
    for record in reader.records() {
        let header = &header;
        let entry = record
            .map_err(|error| vec![error.to_string()])
            .and_then(|record| Row { header, record }.entry());
        match entry {
            Ok(entry) => entries.push(entry),
            Err(found) => problems.extend(found),
        }
    }
    if entries.is_empty() && problems.is_empty() {
        problems.push("it has no bearing".to_owned());
    }
    if problems.len() > MOST_PROBLEMS {
        let more = problems.len() - MOST_PROBLEMS;
        problems.truncate(MOST_PROBLEMS);
        problems.push(format!("and {more} more"));
    }
    problems.is_empty().then_some(entries).ok_or(problems)
}

fn header_problems(header: &csv::StringRecord) -> Vec<String> {
    let known = || NEEDED.iter().chain(&OPTIONAL);
    let missing = NEEDED
        .iter()
        .filter(|name| !header.iter().any(|h| h == **name));
    let missing = missing.map(|name| format!("it has no column `{name}`"));
    let strange = header
        .iter()
        .filter(|name| known().all(|known| known != name));
    let strange = strange.map(|name| {
        let names: Vec<_> = known().copied().collect();
        format!("it has a column `{name}`; known are {}", names.join(", "))
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

    /// The number of a column over a divisor; none where it is empty.
    fn number(&self, column: &str, divisor: f64, problems: &mut Vec<String>) -> Option<f64> {
        let text = self.text(column);
        if text.is_empty() {
            if NEEDED.contains(&column) {
                problems.push(format!("`{column}` is empty"));
            }
            return None;
        }
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() && (number > 0.0 || column == "contact_angle_deg") => {
                Some(number / divisor)
            }
            Ok(_) => {
                problems.push(format!("`{column}` must be above zero, not {text}"));
                None
            }
            Err(_) => {
                problems.push(format!("`{column}` has \"{text}\", which is not a number"));
                None
            }
        }
    }

    fn entry(&self) -> Result<CatalogueEntry, Vec<String>> {
        let mut problems = Vec::new();
        let designation = self.text("designation").to_owned();
        if designation.is_empty() {
            problems.push("`designation` is empty".to_owned());
        }
        let mut number = |column, divisor| self.number(column, divisor, &mut problems);
        let [bore, outside, ball, pitch, width] = [
            "bore_mm",
            "outside_diameter_mm",
            "ball_diameter_mm",
            "pitch_diameter_mm",
            "width_mm",
        ]
        .map(|column| number(column, 1e3));
        let [angle, dynamic, statical, factor, balls, inner, outer] = [
            "contact_angle_deg",
            "dynamic_rating_N",
            "static_rating_N",
            "f0",
            "balls",
            "groove_factor_inner",
            "groove_factor_outer",
        ]
        .map(|column| number(column, 1.0));
        if balls.is_some_and(|balls| balls.fract() != 0.0) {
            problems.push("`balls` is no whole number".to_owned());
        }
        if inner.is_some() != outer.is_some() {
            problems.push("give both groove factors or none".to_owned());
        }
        let (Some(bore), Some(outside), Some(angle), Some(dynamic), true) =
            (bore, outside, angle, dynamic, problems.is_empty())
        else {
            let line = self.record.position().map_or(0, csv::Position::line);
            let with_line = |problem: &String| format!("line {line}: {problem}");
            return Err(problems.iter().map(with_line).collect());
        };
        let line = CatalogueLine {
            bore,
            outside_diameter: outside,
            contact_angle: angle.to_radians(),
            dynamic_rating: dynamic,
            static_rating: statical,
            static_factor: factor,
            balls: balls.map(|balls| balls as usize),
            ball_diameter: ball,
            pitch_diameter: pitch,
            groove_factors: inner.zip(outer).map(|(inner, outer)| [inner, outer]),
        };
        Ok(CatalogueEntry {
            designation,
            maker: self.text("maker").to_owned(),
            source: self.text("source").to_owned(),
            width,
            line,
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
        assert!(problems[1].starts_with("line 3: `bore_mm` must be above zero"));
        let problems = read("designation,bore\nA,1\n").expect_err("columns");
        assert!(problems.iter().any(|problem| problem.contains("`bore`")));
    }
}
