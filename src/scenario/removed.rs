//! Keys and words that scenarios do not have or have no longer, each with the way there is.

const REMOVED: [(&str, &str); 9] = [
    (
        "step",
        "steps follow from the error: tolerance = 1e-8; how often is written, `sample_rate` in [output] says",
    ),
    (
        "side_by_side",
        "leave it out: every run is integrated by itself",
    ),
    (
        "study",
        "write a study file with `base`, the name of this one, ask = \"bearing\" and an `[[axis]]` with `key` and values; \
         `jeffcott study` answers it",
    ),
    (
        "linear",
        "springs and dampers stand in an `[[element]]` of their own: [element.linear]",
    ),
    ("tsit5", "\"verner76\" takes its place"),
    ("dprkn8", "\"exponential\" takes its place"),
    ("dprkn12", "\"verner76\" takes its place"),
    ("ode_solvers_dop853", "\"dop853\" takes its place"),
    (
        "mat",
        "MATLAB reads CSV by `readtable` and Parquet by `parquetread`",
    ),
];

/// What to do instead of a key or word that is not there.
pub fn way_left(word: &str) -> Option<&'static str> {
    let found = REMOVED.iter().find(|(removed, _)| *removed == word);
    found.map(|(_, way)| *way)
}
