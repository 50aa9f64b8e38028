//! A load series in a CSV file: times and values with their units in the header; columns of numbers of any CSV file.

use std::path::Path;

use crate::rotor::load::SeriesComponent;

/// Most bytes of a file.
const LARGEST: u64 = 512 << 20;
/// Name of the column of times.
const TIME: &str = "t_s";
/// Names of the columns of the freedoms, in their order.
const COLUMNS: [&str; 5] = ["x_N", "y_N", "z_N", "tilt_x_N_m", "tilt_y_N_m"];

/// Times in s and the columns beside them.
///
/// # Errors
/// What is wrong with the file. Rows count from the first below the header.
pub(super) fn read(path: &Path) -> Result<(Vec<f64>, Vec<SeriesComponent>), String> {
    let (mut columns, mut values) = read_columns(path, columns)?;
    let times = values.remove(0);
    for (column, values) in columns.iter_mut().zip(values) {
        column.values = values;
    }
    Ok((times, columns))
}

/// What `check` makes of the header of a CSV file of numbers, and its columns.
///
/// # Errors
/// What is wrong with the file. Rows count from the first below the header.
pub(super) fn read_columns<T>(
    path: &Path,
    check: impl FnOnce(&[&str]) -> Result<T, String>,
) -> Result<(T, Vec<Vec<f64>>), String> {
    let known = std::fs::metadata(path).map_err(|error| format!("it cannot be read: {error}"))?;
    if !known.is_file() {
        return Err("it is not a file".to_owned());
    }
    if known.len() > LARGEST {
        return Err(format!(
            "it has {} MB, and {} MB are the most that is kept in memory; give fewer rows, or divide it in time and run \
             the scenario for each part",
            known.len() >> 20,
            LARGEST >> 20
        ));
    }
    let not_csv = |error: csv::Error| format!("it is not CSV: {error}");
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .flexible(true)
        .from_path(path)
        .map_err(not_csv)?;
    let header = reader.headers().map_err(not_csv)?.clone();
    // a file from a spreadsheet may begin with a byte order mark
    let header = header
        .iter()
        .map(|name| name.trim_start_matches('\u{feff}'));
    let header: Vec<&str> = header.collect();
    if let [first] = &header[..]
        && first.contains(';')
    {
        let commas = first.replace(',', ".").replace(';', ",");
        return Err(format!(
            "semicolons part its columns: write commas between them and points in numbers, as in `{commas}`"
        ));
    }
    let checked = check(&header)?;
    let mut columns = vec![Vec::new(); header.len()];
    for (index, record) in reader.records().enumerate() {
        let (record, row) = (record.map_err(not_csv)?, index + 1);
        let (found, expected) = (record.len(), header.len());
        if found != expected {
            return Err(format!(
                "row {row} has {found} entries, the header {expected}"
            ));
        }
        for (pair, column) in record.iter().zip(&header).zip(&mut columns) {
            column.push(number(pair, row)?);
        }
    }
    Ok((checked, columns))
}

/// The empty columns that a header promises.
fn columns(header: &[&str]) -> Result<Vec<SeriesComponent>, String> {
    let first = header.first().unwrap_or(&"");
    if *first != TIME {
        return Err(format!("its first column must be `{TIME}`, not `{first}`"));
    }
    let known = COLUMNS.join(", ");
    let mut columns: Vec<SeriesComponent> = Vec::new();
    for name in &header[1..] {
        let Some(axis) = COLUMNS.iter().position(|known| known == name) else {
            return Err(format!(
                "it has a column `{name}`; known are {TIME}, {known}"
            ));
        };
        if columns.iter().any(|column| column.axis == axis) {
            return Err(format!("it has two columns `{name}`"));
        }
        let values = Vec::new();
        columns.push(SeriesComponent { axis, values });
    }
    match columns.is_empty() {
        true => Err(format!(
            "it has no column but `{TIME}`; add some of {known}"
        )),
        false => Ok(columns),
    }
}

fn number((text, column): (&str, &&str), row: usize) -> Result<f64, String> {
    if text.is_empty() {
        return Err(format!("row {row} has nothing in column `{column}`"));
    }
    text.parse()
        .map_err(|_| format!("row {row} has `{text}` in column `{column}`, which is not a number"))
}
