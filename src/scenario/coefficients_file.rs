//! Stiffness and damping of a bearing or seal over the speed: a CSV file, or a bearing that ROSS has saved.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

use serde_json::Value;

use super::document::file_text;
use super::series_file::read_columns;
use crate::rotor::{CoefficientTable, ElementLaw, LinearLaw};

/// Most bytes of a file of ROSS.
const LARGEST: u64 = 64 << 20;
/// Directions of the coefficients, in the order of their entries.
const ENTRIES: [&str; 5] = ["xx", "xy", "yx", "yy", "zz"];

/// Columns by their names without unit: `speed` in rad/s, `kxx` …, `cxx` ….
type Columns = BTreeMap<String, Vec<f64>>;

/// The law of a file.
///
/// # Errors
/// What is wrong with it.
pub(super) fn read(path: &Path) -> Result<ElementLaw, String> {
    let ending = path.extension().and_then(|ending| ending.to_str());
    let columns = match ending {
        Some("csv") => from_csv(path)?,
        Some("toml") => from_ross(&ross(path, |text| {
            toml::from_str(text).map_err(|e| e.message().to_owned())
        })?)?,
        Some("json") => from_ross(&ross(path, |text| {
            serde_json::from_str(text).map_err(|e| e.to_string())
        })?)?,
        _ => return Err("its name must end in .csv, or .toml or .json of ROSS".to_owned()),
    };
    law(columns)
}

fn from_csv(path: &Path) -> Result<Columns, String> {
    let (names, values) = read_columns(path, |header| {
        header
            .iter()
            .map(|name| column(name))
            .collect::<Result<Vec<_>, _>>()
    })?;
    let mut columns = Columns::new();
    for ((name, factor), values) in names.into_iter().zip(values) {
        let values = values.iter().map(|value| factor * value).collect();
        if columns.insert(name.clone(), values).is_some() {
            return Err(format!("it has two columns of `{name}`"));
        }
    }
    if !columns.contains_key("speed") {
        return Err("it needs a column `speed_rad_s` or `speed_rpm`".to_owned());
    }
    Ok(columns)
}

/// What the name of a column of a CSV file says, and the factor to SI units.
fn column(name: &str) -> Result<(String, f64), String> {
    let units = [("k", "_N_m"), ("c", "_N_s_m")];
    let known = |(letter, unit): (&str, &str)| {
        let entry = name.strip_suffix(unit)?.strip_prefix(letter)?;
        let entry = ENTRIES.into_iter().find(|known| *known == entry)?;
        Some((format!("{letter}{entry}"), 1.0))
    };
    match name {
        "speed_rad_s" => Ok(("speed".to_owned(), 1.0)),
        "speed_rpm" => Ok(("speed".to_owned(), TAU / 60.0)),
        _ => units.into_iter().find_map(known).ok_or_else(|| {
            format!(
                "it has a column `{name}`; known are speed_rad_s, speed_rpm, kxx_N_m, kxy_N_m, kyx_N_m, kyy_N_m, \
                 kzz_N_m, cxx_N_s_m, cxy_N_s_m, cyx_N_s_m, cyy_N_s_m and czz_N_s_m"
            )
        }),
    }
}

/// The only element with coefficients that ROSS has saved in a file.
fn ross(path: &Path, parse: impl Fn(&str) -> Result<Value, String>) -> Result<Value, String> {
    let file = parse(&file_text(path, LARGEST)?)?;
    let elements = file.as_object().into_iter().flatten();
    let bearings: Vec<_> = elements
        .filter(|(_, own)| own.get("kxx").is_some())
        .collect();
    match &bearings[..] {
        [(_, bearing)] => Ok((*bearing).clone()),
        [] => Err(
            "it has no table with `kxx`; a bearing of ROSS is written by `bearing.save(FILE)`"
                .to_owned(),
        ),
        several => {
            let names: Vec<_> = several.iter().map(|(name, _)| name.as_str()).collect();
            Err(format!(
                "it has several bearings, {}: keep one",
                names.join(", ")
            ))
        }
    }
}

/// The columns of a bearing of ROSS. Before version 3 its speeds were called `frequency`; in version 3 that is the frequency
/// of the whirl, and `speed` is next to it where coefficients depend on both.
fn from_ross(bearing: &Value) -> Result<Columns, String> {
    let mut columns = Columns::new();
    let list = |key: &str| match bearing.get(key) {
        None | Some(Value::Null) => Ok(None),
        Some(Value::Array(all)) => {
            let numbers: Option<Vec<f64>> = all.iter().map(Value::as_f64).collect();
            numbers
                .map(Some)
                .ok_or_else(|| format!("`{key}` is no list of numbers"))
        }
        Some(one) => {
            let number = one.as_f64().map(|number| Some(vec![number]));
            number.ok_or_else(|| format!("`{key}` is no number"))
        }
    };
    for entry in ENTRIES {
        for letter in ["k", "c"] {
            let key = format!("{letter}{entry}");
            if let Some(values) = list(&key)? {
                columns.insert(key, values);
            }
        }
        let masses = list(&format!("m{entry}"))?.unwrap_or_default();
        if masses.iter().any(|mass| *mass != 0.0) {
            return Err(format!(
                "it has a mass m{entry}, which an element cannot have"
            ));
        }
    }
    let speeds = match (list("speed")?, list("frequency")?) {
        (Some(_), Some(_)) => {
            return Err(
                "its coefficients depend on the frequency of the whirl besides the speed"
                    .to_owned(),
            );
        }
        (speed, frequency) => speed.or(frequency),
    };
    columns.extend(speeds.map(|speeds| ("speed".to_owned(), speeds)));
    for letter in ["k", "c"] {
        // ROSS has yy as xx where it is not given
        let same = columns.get(&format!("{letter}xx")).cloned();
        if let Some(same) = same {
            columns.entry(format!("{letter}yy")).or_insert(same);
        }
    }
    Ok(columns)
}

/// The law of columns, which are alike in length or constant: over the speed, where there is one.
fn law(mut columns: Columns) -> Result<ElementLaw, String> {
    let speeds = columns.remove("speed").unwrap_or_default();
    let rows = speeds.len().max(1);
    let mut all = Vec::new();
    for letter in ["k", "c"] {
        let of_letter = ENTRIES.map(|entry| {
            let key = format!("{letter}{entry}");
            let values = columns.remove(&key).unwrap_or_else(|| vec![0.0]);
            match values.len() {
                1 => Ok(vec![values[0]; rows]),
                count if count == rows => Ok(values),
                count => Err(format!("`{key}` has {count} values at {rows} speeds")),
            }
        });
        all.push(of_letter.into_iter().collect::<Result<Vec<_>, _>>()?);
    }
    let [stiffness, damping] = [0, 1].map(|which: usize| std::mem::take(&mut all[which]));
    let mut values = speeds
        .iter()
        .chain(stiffness.iter().chain(&damping).flatten());
    if let Some(value) = values.find(|value| !value.is_finite()) {
        return Err(format!("it has the value {value}"));
    }
    if let Some(pair) = speeds.windows(2).find(|pair| pair[1] <= pair[0]) {
        return Err(format!(
            "its speed {} rad/s follows {} rad/s: speeds must rise",
            pair[1], pair[0]
        ));
    }
    if speeds.is_empty() {
        let [k, c] = [&stiffness, &damping].map(|own| {
            (
                [own[0][0], own[3][0], own[4][0], 0.0, 0.0],
                [own[1][0], own[2][0]],
            )
        });
        return Ok(ElementLaw::Linear(Box::new(LinearLaw::new(k, c))));
    }
    let table = CoefficientTable::new(&speeds, [stiffness, damping]);
    table
        .map(ElementLaw::OverSpeed)
        .map_err(|error| error.to_string())
}
