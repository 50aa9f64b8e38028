//! `docs/keys.md` is what the schemas of scenarios and studies say. `JEFFCOTT_BLESS=1` writes it anew.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use serde_json::Value;

use crate::support::{done, jeffcott_in, root, text};

const HEAD: &str = "# Keys

<!-- Written by tests/command/keys.rs from the schemas: JEFFCOTT_BLESS=1 cargo test --test command keys -->

All keys of a scenario, of a study, of a fit and of a file that describes a record, as `jeffcott schema` prints them for editors, with
`--study`, `--fit` or `--record`. A value with a dimension is a string with its unit, as in `\"5 kg\"`; [units](#units) are at the end.
A key in **bold** must be given where its table is.
";

/// What is read as a unit.
const UNITS: &str = "
## Units

Any product of powers of known units is read where it has the dimension of the key: `N s/m`, `N·s/m`, `kN*s/mm`, `Ns/m`,
`N s m^-1`, `N s m⁻¹`. What follows a `/` is one factor, or stands in brackets: `um/(m K)`. Known are

- of mass `g`, `t`, `lb`, `oz`; of length `m`, `in`, `ft`, `mil` or `thou`, `micron`; of time `s`, `min`, `h`, `day`
- of force `N`, `lbf`, `ozf`, `kip`, `kgf` or `kp`, `dyn`; of pressure `Pa`, `bar`, `psi`, `ksi`; of viscosity `P`, `St`
- of angle `rad`, `deg` or `°`, `arcmin`, `rev` or `r`; of frequency `Hz`, `cpm`; of speed `rpm`, `rps`; of acceleration `gn`
- of temperature `K`, `degC` or `°C`, `degF`; and `ppm`

with the SI prefixes that are in use: `nm`, `um` or `µm`, `mm`, `cm`, `km`, but no `Mm`, which would be a slip for `mm`. Capitals
count: `MN` is a million newtons, `mN` a thousandth of one. `g` is the gram; gravity is `gn`, 9.80665 m/s². `oz` and `lb` are masses, `ozf`
and `lbf` forces. `1/min`, `cpm` and `Hz` as a speed count turns; `1/s` could be turns or radians and is refused there. A unit of
another dimension, or one that is not known, is refused with units of the key, and with a spelling where capitals alone
were wrong. The decimal sign is a point. The table has some units of each dimension, its SI unit first.

| dimension | units |
|---|---|
";

/// Some units of every dimension that was met.
type Units = BTreeMap<String, String>;

fn string<'a>(node: &'a Value, key: &str) -> &'a str {
    node[key].as_str().unwrap_or_default()
}

/// One line of prose that fits a cell of a table.
fn line(prose: &str) -> String {
    prose.replace('\n', " ").replace('|', "\\|")
}

fn code(value: &Value) -> String {
    format!("`{value}`")
}

/// A list of words as code, as in "`a`, `b`".
fn codes(values: &Value) -> String {
    let words = values.as_array().into_iter().flatten();
    let words = words.map(|word| format!("`{}`", word.as_str().unwrap_or_default()));
    words.collect::<Vec<_>>().join(", ")
}

/// Names as they are shown: of more than two that differ by a number or an axis alone the first and the last.
fn families<'a>(names: impl Iterator<Item = &'a Value>, shown: impl Fn(&str) -> String) -> String {
    let mut families: Vec<(String, Vec<&str>)> = Vec::new();
    for name in names.filter_map(Value::as_str) {
        let numbered = name.contains('_');
        let parts = name.split('_').map(|part| match part {
            "x" | "y" | "z" => "*",
            part if numbered => part.trim_end_matches(char::is_numeric),
            part => part,
        });
        let family = parts.collect::<Vec<_>>().join("_");
        match families.iter_mut().find(|(known, _)| *known == family) {
            Some((_, members)) => members.push(name),
            None => families.push((family, vec![name])),
        }
    }
    let told = families.iter().flat_map(|(_, members)| match members[..] {
        [first, _, .., last] => vec![format!("{} to {}", shown(first), shown(last))],
        _ => members.iter().map(|name| shown(name)).collect(),
    });
    told.collect::<Vec<_>>().join(", ")
}

/// Fewest characters of a line of the page that nobody reads to its end.
const WIDEST: usize = 1000;

/// The keys of a table.
fn keys(node: &Value) -> impl Iterator<Item = (&String, &Value)> {
    node["properties"].as_object().into_iter().flatten()
}

/// Whether a table holds one quantity for each direction, and so fits a line of the table above it.
fn is_vector(node: &Value) -> bool {
    let directions = ["x", "y", "z", "tilt", "tilt_x", "tilt_y"];
    node["type"] == "object" && keys(node).all(|(key, _)| directions.contains(&key.as_str()))
}

/// What kind of value a key takes.
fn kind(node: &Value, units: &mut Units) -> String {
    if let Some(dimension) = node["x-dimension"].as_str() {
        units.insert(dimension.to_owned(), codes(&node["x-units"]));
        let sign = if node["x-above"] == 0.0 {
            ", above 0"
        } else if node["x-minimum"] == 0.0 {
            ", 0 or more"
        } else {
            ""
        };
        let example = node["examples"]
            .get(0)
            .map(|value| format!(", {}", code(value)));
        return format!("{dimension}{sign}{}", example.unwrap_or_default());
    }
    if let Some(choices) = node["oneOf"].as_array() {
        let words = choices.iter().filter(|choice| choice["const"].is_string());
        return families(words.map(|choice| &choice["const"]), |name| {
            format!("`\"{name}\"`")
        });
    }
    if node["items"].is_object() && node["type"].is_array() {
        return "text, or list: text".to_owned();
    }
    if node["type"].is_array() {
        return "as the key it stands for".to_owned();
    }
    match string(node, "type") {
        "boolean" => "`true`, `false`".to_owned(),
        "array" if node["items"]["oneOf"][0]["enum"].is_array() => "list of names".to_owned(),
        "array" => format!("list: {}", kind(&node["items"], units)),
        "object" if is_vector(node) => {
            let kinds: Vec<_> = keys(node)
                .map(|(key, inner)| format!("`{key}` {}", kind(inner, units)))
                .collect();
            format!("table: {}", kinds.join("; "))
        }
        "object" => "table, see below".to_owned(),
        "string" => "text".to_owned(),
        number => {
            let name = if number == "integer" {
                "whole number"
            } else {
                "number"
            };
            let least = [("minimum", ""), ("exclusiveMinimum", "above ")];
            let least = least
                .iter()
                .find(|(key, _)| !node[*key].is_null())
                .map(|(key, above)| format!("{above}{}", node[*key]));
            match (least, &node["maximum"]) {
                (None, Value::Null) => name.to_owned(),
                (Some(least), Value::Null) => format!("{name}, {least} or more"),
                (None, most) => format!("{name}, up to {most}"),
                (Some(least), most) => format!("{name}, {least} to {most}"),
            }
        }
    }
}

/// What a key means: its description, its words one by one, its default.
fn meaning(node: &Value) -> String {
    let mut says = line(string(node, "description"));
    for choice in node["oneOf"].as_array().into_iter().flatten() {
        let description = line(string(choice, "description"));
        if !description.is_empty() {
            write!(says, "<br>{}: {description}", code(&choice["const"])).expect("a string");
        }
    }
    let names = &node["items"]["oneOf"];
    if names[0]["enum"].is_array() {
        write!(
            says,
            "<br>{}",
            families(
                names[0]["enum"].as_array().into_iter().flatten(),
                |name| format!("`{name}`")
            )
        )
        .expect("a string");
    }
    let default = &node["default"];
    if !default.is_null()
        && !default.is_object()
        && *default != Value::Array(Vec::new())
        && !says.contains("Default")
    {
        write!(says, " Default: {}.", code(default)).expect("a string");
    }
    says
}

/// A table of the file with its keys, then the tables in it.
fn section(path: &str, node: &Value, list: bool, page: &mut String, units: &mut Units) {
    let name = if list {
        format!("[[{path}]]")
    } else {
        format!("[{path}]")
    };
    let inner = if list { &node["items"] } else { node };
    let depth = if path.contains('.') { "####" } else { "###" };
    write!(
        page,
        "\n{depth} `{name}`\n\n{}\n",
        string(node, "description")
    )
    .expect("a string");
    rules(inner, page);
    table(inner, page, units);
    nested(path, inner, page, units);
}

/// Which keys of a table exclude one another.
fn rules(node: &Value, page: &mut String) {
    for (rule, says) in [
        ("x-exactly-one", "Exactly one of"),
        ("x-at-most-one", "At most one of"),
    ] {
        if node[rule].is_array() {
            write!(page, "\n{says} {}.\n", codes(&node[rule])).expect("a string");
        }
    }
}

fn table(node: &Value, page: &mut String, units: &mut Units) {
    page.push_str("\n| key | value | meaning |\n|---|---|---|\n");
    let required = node["required"].as_array();
    for (key, inner) in keys(node) {
        let needed = required.is_some_and(|keys| keys.iter().any(|name| name == key));
        let name = if needed {
            format!("**`{key}`**")
        } else {
            format!("`{key}`")
        };
        let row = format!("| {name} | {} | {} |\n", kind(inner, units), meaning(inner));
        page.push_str(&row);
    }
}

fn nested(path: &str, node: &Value, page: &mut String, units: &mut Units) {
    for (key, inner) in keys(node) {
        let list = inner["items"]["type"] == "object";
        if list || (inner["type"] == "object" && !is_vector(inner)) {
            let path = if path.is_empty() {
                key.clone()
            } else {
                format!("{path}.{key}")
            };
            section(&path, inner, list, page, units);
        }
    }
}

fn printed(arguments: &[&str]) -> Value {
    let output = done(jeffcott_in(root(), arguments)).stdout;
    serde_json::from_str(&text(&output)).expect("JSON")
}

/// The page that the schemas make.
fn page() -> String {
    let mut page = HEAD.to_owned();
    let mut units = Units::new();
    for (title, schema) in [
        ("Scenario", printed(&["schema"])),
        ("Study", printed(&["schema", "--study"])),
        ("Fit", printed(&["schema", "--fit"])),
        ("Record", printed(&["schema", "--record"])),
    ] {
        write!(page, "\n## {title}\n\n{}\n", string(&schema, "description")).expect("a string");
        table(&schema, &mut page, &mut units);
        nested("", &schema, &mut page, &mut units);
    }
    page.push_str(UNITS);
    for (dimension, names) in units {
        writeln!(page, "| {dimension} | {names} |").expect("a string");
    }
    page
}

#[test]
fn the_keys_of_the_manual_are_those_of_the_schemas() {
    let file = root().join("docs/keys.md");
    let page = page();
    if std::env::var_os("JEFFCOTT_BLESS").is_some() {
        fs::write(&file, &page).expect("a writable folder");
    }
    let widest = page.lines().map(|line| line.chars().count()).max();
    assert!(widest < Some(WIDEST), "a line of {widest:?} characters");
    let committed = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        committed == page,
        "write it anew: JEFFCOTT_BLESS=1 cargo test --test command keys"
    );
}
