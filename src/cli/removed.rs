//! Words of the command line that are none or none any more, each with the way there is.

use clap::error::{ContextKind, ContextValue, Error, ErrorKind};

use crate::scenario::way_left;

const RUN_AGAIN: &str = "a run is made in one go: run it again, or with a shorter `duration`; studies go on where they ended";

/// What the verb that is asked for most does.
const RUN: &str = "did you mean `run`? `jeffcott run FILE` simulates a scenario";

const REMOVED: [(&str, &str); 6] = [
    ("simulate", RUN),
    (
        "report",
        "`jeffcott compare A B ... --report FILE.html` puts two and more runs on one page",
    ),
    (
        "--figure-format",
        "figures are written as SVG; the page saves each as PNG (600 pixels an inch), and printed by a browser it is a PDF",
    ),
    ("--stop-at", RUN_AGAIN),
    ("--restartable", RUN_AGAIN),
    ("--resume", RUN_AGAIN),
];

/// Tells of a word that is gone what to do instead, in place of words that are like it.
pub fn with_way_left(mut error: Error) -> Error {
    let kinds = [
        ContextKind::InvalidArg,
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidValue,
    ];
    let words = kinds.iter().filter_map(|kind| error.get(*kind));
    let mut ways = words.filter_map(|word| {
        let word = word.to_string();
        let found = REMOVED.iter().find(|(removed, _)| *removed == word);
        found.map(|(_, way)| *way).or_else(|| way_left(&word))
    });
    let way = ways.next();
    drop(ways);
    let no_verb = error.kind() == ErrorKind::InvalidSubcommand
        && error.get(ContextKind::SuggestedSubcommand).is_none();
    let Some(way) = way.or(no_verb.then_some(RUN)) else {
        return error;
    };
    for alike in [
        ContextKind::SuggestedArg,
        ContextKind::SuggestedSubcommand,
        ContextKind::SuggestedValue,
    ] {
        error.remove(alike);
    }
    error.insert(
        ContextKind::Suggested,
        ContextValue::StyledStrs(vec![way.into()]),
    );
    error
}
