//! Results as JSON documents.

use serde::Serialize;
use serde_json::Value;

/// What every document begins with.
#[derive(Serialize)]
struct Document<'a, T> {
    jeffcott: &'static str,
    title: &'a str,
    scenario: &'a Value,
    #[serde(flatten)]
    result: T,
}

/// A result with version, title and the scenario as it is, every number with its unit in its name.
///
/// The fields of the result's type describe the keys. What is missing is `null`. The same result gives the
/// same bytes: there is no date in it, and no wall time but where that is the result.
pub fn document(title: &str, scenario: &Value, result: impl Serialize) -> Value {
    value(Document {
        jeffcott: env!("CARGO_PKG_VERSION"),
        title,
        scenario,
        result,
    })
}

/// A part of a document.
pub(super) fn value(result: impl Serialize) -> Value {
    serde_json::to_value(result).expect("the keys of results are texts")
}
