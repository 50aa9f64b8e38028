//! One fault draws one message, on the key that has it, whatever else the table holds.

use serde_json::{Value, json};

use crate::scenario::{self, Format};

/// Keys and messages of what is wrong with a scenario.
fn problems(scenario: &Value) -> Vec<String> {
    match scenario::parse(&scenario.to_string(), "scenarios/one.json", Format::Json) {
        Ok(_) => Vec::new(),
        Err(error) => {
            let issues = error.issues.iter();
            issues
                .map(|issue| format!("{}: {}", issue.path, issue.message))
                .collect()
        }
    }
}

/// Pointers to all values that are no tables, and to the lists.
fn leaves(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(entries) => {
            for (key, inner) in entries {
                leaves(inner, &format!("{path}/{key}"), found);
            }
        }
        Value::Array(items) if items.iter().any(Value::is_object) => {
            for (index, inner) in items.iter().enumerate() {
                leaves(inner, &format!("{path}/{index}"), found);
            }
        }
        _ => found.push(path.to_owned()),
    }
}

/// The key path of a JSON pointer.
fn key_path(pointer: &str) -> String {
    let parts = pointer.split('/').skip(1);
    parts.fold(String::new(), |path, part| match part.parse::<usize>() {
        Ok(index) => format!("{path}[{}]", index + 1),
        Err(_) if path.is_empty() => part.to_owned(),
        Err(_) => format!("{path}.{part}"),
    })
}

fn shipped() -> Vec<(String, Value)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let files = std::fs::read_dir(folder).expect("the scenarios");
    let files = files.map(|file| file.expect("a file").path());
    let tomls = files.filter(|file| file.extension().is_some_and(|end| end == "toml"));
    let read = |file: std::path::PathBuf| {
        let text = std::fs::read_to_string(&file).expect("a text");
        let written = scenario::document::written(&text, "a.toml", Format::Toml);
        (file.display().to_string(), written.expect("a scenario"))
    };
    tomls.map(read).collect()
}

/// A value of a wrong kind: a quantity of no unit for quantities, a word for everything else.
fn wrong(pointer: &str, value: &Value) -> Value {
    match value {
        Value::String(text)
            if pointer != "/title"
                && text.starts_with(|c: char| c.is_ascii_digit() || c == '-') =>
        {
            json!("7 furlong")
        }
        Value::String(_) => json!(7),
        _ => json!("seven"),
    }
}

/// Changes every value of every shipped scenario in turn and counts those that draw other than one message.
fn one_message_each(change: impl Fn(&mut Value, &str), due: impl Fn(&str) -> String) {
    let (mut tried, mut failed) = (0, Vec::new());
    for (name, scenario) in shipped() {
        let mut pointers = Vec::new();
        leaves(&scenario, "", &mut pointers);
        for pointer in pointers {
            let mut changed = scenario.clone();
            change(&mut changed, &pointer);
            let found = problems(&changed);
            let due = due(&pointer);
            tried += 1;
            if found.len() != 1 || !found[0].starts_with(&due) {
                failed.push(format!("{name}: {due}: {found:#?}"));
            }
        }
    }
    assert!(tried > 300, "{tried}");
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

#[test]
fn a_wrong_value_of_any_key_draws_one_message_on_it() {
    let change = |scenario: &mut Value, pointer: &str| {
        let value = scenario.pointer_mut(pointer).expect("a value");
        *value = wrong(pointer, value);
    };
    one_message_each(change, key_path);
}

#[test]
fn a_misspelled_key_draws_one_message() {
    let change = |scenario: &mut Value, pointer: &str| {
        let (table, key) = pointer.rsplit_once('/').expect("a key");
        let table = scenario.pointer_mut(table).and_then(Value::as_object_mut);
        let table = table.expect("a table");
        let value = table.remove(key).expect("a value");
        table.insert(format!("{key}q"), value);
    };
    one_message_each(change, |pointer| key_path(pointer) + "q");
}

const MACHINE: &str = r#"
[shaft]
mass = "12 kg"
unbalance = "G 6.3"
freedoms = "radial"
[speed]
constant = "1480 rpm"
[[bearing]]
catalogue = "6308"
position = "-100 mm"
[[bearing]]
catalogue = "6308"
position = "100 mm"
[bearing.oil]
iso_vg = 68
temperature = "70 degC"
[damping]
ratio = 0.03
"#;

fn messages(text: &str) -> Vec<(String, String, Option<String>)> {
    let error = scenario::parse(text, "a.toml", Format::Toml).expect_err("a fault");
    let issue = |issue: scenario::Issue| (issue.path, issue.message, issue.help);
    error.issues.into_iter().map(issue).collect()
}

/// An oil that is wrong is not one without a viscosity; a speed that is wrong is no standstill.
#[test]
fn what_nobody_wrote_is_not_complained_of() {
    let text = MACHINE.replace(
        "iso_vg = 68\ntemperature = \"70 degC\"",
        "iso_vg = \"VG 68\"",
    );
    let found = messages(&text);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].0, "bearing[2].oil.iso_vg");
    for (wrong, key) in [
        (
            ["iso_vg = 68", "iso_vg = \"VG 68\""],
            "bearing[2].oil.iso_vg",
        ),
        (["iso_vg = 68", "iso_vgg = 68"], "bearing[2].oil.iso_vgg"),
        (["1480 rpm", "1480 furlong"], "speed.constant"),
        (["1480 rpm", "1480"], "speed.constant"),
        (["constant =", "constnt ="], "speed.constnt"),
        (["70 degC", "70 C"], "bearing[2].oil.temperature"),
    ] {
        let found = messages(&MACHINE.replace(wrong[0], wrong[1]));
        assert_eq!(found.len(), 1, "{wrong:?}: {found:?}");
        assert_eq!(found[0].0, key);
    }
    let found = messages(&MACHINE.replace("iso_vg = 68", "iso_vg = \"VG 68\""));
    let help = found[0].2.as_deref();
    assert_eq!(help, Some("write it without quotes: iso_vg = 68"));
}
