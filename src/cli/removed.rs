//! Words of the command line that earlier versions knew, each with the way that is left.

use clap::error::{ContextKind, ContextValue, Error};

const RUN_AGAIN: &str = "a run is made in one go: run it again, or with a shorter `duration`; studies go on where they ended";

const REMOVED: [(&str, &str); 4] = [
    (
        "report",
        "`jeffcott compare A B ... --report FILE.html` puts two and more runs on one page",
    ),
    ("--stop-at", RUN_AGAIN),
    ("--restartable", RUN_AGAIN),
    ("--resume", RUN_AGAIN),
];

/// Tells of a word that is gone what to do instead, in place of words that are like it.
pub fn with_way_left(mut error: Error) -> Error {
    let word = [
        ContextKind::InvalidArg,
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidValue,
    ];
    let is_word = |known: &str| {
        let words = word.iter().filter_map(|kind| error.get(*kind));
        words.into_iter().any(|word| word.to_string() == known)
    };
    let Some((_, way)) = REMOVED.iter().find(|(known, _)| is_word(known)) else {
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
        ContextValue::StyledStrs(vec![(*way).into()]),
    );
    error
}
