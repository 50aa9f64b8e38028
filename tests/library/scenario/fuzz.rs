//! Nothing that can be written into a scenario file makes the reader panic, and what it refuses
//! it can show.

use crate::scenario::{self, Format};
use proptest::prelude::*;

const SCENARIO: &str = include_str!("../../../scenarios/back-to-back-7205c.toml");

fn read(text: &str, format: Format) {
    if let Err(error) = scenario::parse(text, "fuzz", format) {
        assert!(!error.issues.is_empty());
        assert!(!error.render(false).is_empty());
        assert!(error.issues_json().is_array());
    }
}

/// A text with one stretch of characters replaced.
fn mutated(text: &str, start: usize, length: usize, insert: &str) -> String {
    let head: String = text.chars().take(start).collect();
    let tail: String = text.chars().skip(start + length).collect();
    head + insert + &tail
}

/// The shipped scenario in JSON.
fn as_json() -> String {
    let scenario = scenario::parse(SCENARIO, "fuzz", Format::Toml);
    scenario.map_or_else(
        |error| panic!("{error}"),
        |scenario| scenario.echo.to_string(),
    )
}

/// Fragments that are near to valid.
fn fragment() -> impl Strategy<Value = String> {
    prop_oneof![
        "[\\[\\]{}=\",.a-zµ0-9 \n-]{0,12}",
        any::<String>(),
        Just("\"1e308 N\"".to_owned()),
        Just("-0".to_owned()),
        Just("[[bearing]]\n".to_owned()),
        Just("99999999999999999999999".to_owned()),
    ]
}

#[test]
fn deep_keys_and_many_unknown_keys_are_refused_in_time() {
    read(&format!("{}a = 1", "a.".repeat(100_000)), Format::Toml);
    read(&format!("[{}a]\nb = 1", "a.".repeat(100_000)), Format::Toml);
    let many: String = (0..20_000).map(|key| format!("key{key} = 1\n")).collect();
    read(&many, Format::Toml);
}

proptest! {
    #[test]
    fn arbitrary_text_is_read_or_refused(text: String) {
        read(&text, Format::Toml);
        read(&text, Format::Json);
    }

    #[test]
    fn mutated_scenarios_are_read_or_refused(
        start in 0..SCENARIO.len(), length in 0..40_usize, insert in fragment(),
    ) {
        read(&mutated(SCENARIO, start, length, &insert), Format::Toml);
        read(&mutated(&as_json(), start, length, &insert), Format::Json);
    }

    #[test]
    fn any_quantity_is_read_or_refused(text in "[+-]?[0-9.eE]{0,6} ?[a-zµ/^*.0-9 ]{0,8}") {
        let quoted = serde_json::to_string(&text).expect("a string is JSON");
        read(&format!("{{\"shaft\":{{\"mass\":{quoted}}}}}"), Format::Json);
    }
}
