//! The JSON Schema of a scenario: what editors read and what the file is checked against.

use std::sync::LazyLock;

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use super::input::ScenarioInput;

/// JSON Schema (draft 7) of a scenario file. Keys that begin with `x-` are ours: the dimension,
/// the units and the range in SI units of a quantity, and keys that exclude each other.
pub fn schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(schema_of::<ScenarioInput>);
    &SCHEMA
}

/// JSON Schema of a file that is read as strictly as a scenario.
pub(super) fn schema_of<T: JsonSchema>() -> Value {
    SchemaSettings::draft07()
        .with(|settings| settings.inline_subschemas = true)
        .with_transform(RecursiveTransform(without_null as fn(&mut Schema)))
        .into_generator()
        .into_root_schema_for::<T>()
        .to_value()
}

/// A key that may be left out is not a key that may be null.
fn without_null(schema: &mut Schema) {
    let Some(object) = schema.as_object_mut() else {
        return;
    };
    if object.get("default").is_some_and(Value::is_null) {
        object.remove("default");
    }
    if let Some(Value::Array(types)) = object.get_mut("type") {
        types.retain(|name| name != "null");
        if let [single] = &types[..] {
            object["type"] = single.clone();
        }
    }
    if let Some(Value::Array(words)) = object.get_mut("enum") {
        words.retain(|word| !word.is_null());
    }
    if let Some(Value::Array(variants)) = object.get_mut("anyOf") {
        variants.retain(|variant| variant["type"] != "null");
        if let [Value::Object(single)] = &variants[..] {
            let single = single.clone();
            object.remove("anyOf");
            for (key, value) in single {
                object.entry(key).or_insert(value);
            }
        }
    }
}
