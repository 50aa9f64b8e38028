//! The matrices of the linearised shaft: tables and arrays.

use nalgebra::DMatrix;
use serde_json::{Value, json};

use super::npz::Npz;
use super::terminal::Lines;
use super::{FileSet, Findings};
use crate::numerics::digits::to_digits;
use crate::physics::PER_MINUTE;
use crate::rotor::LinearMatrices;
use crate::scenario::Scenario;
use crate::table::{Column, Table};

/// The equation that the matrices belong to.
const EQUATION: &str = "M q'' + (C + speed G) q' + K q = f, d/dt (q, q') = A (q, q')";

/// The matrices with the names of their coordinates.
pub fn matrices_findings(
    scenario: &Scenario,
    found: &LinearMatrices,
    warnings: Vec<String>,
) -> Findings {
    let coordinates = &found.coordinates;
    let list = coordinates
        .iter()
        .map(|(name, unit)| json!({ "name": name, "unit": unit }));
    let document = json!({
        "speed_rad_s": found.speed,
        "equation": EQUATION,
        "coordinates": list.collect::<Value>(),
        "natural_frequencies_up_to_Hz": found.natural_up_to,
        "warnings": warnings,
    });
    let mut text = Lines::titled(&scenario.title);
    text.line(
        "matrices",
        format!(
            "M, C, G, K and the state matrix A, linear about the static equilibrium at {:.0} 1/min",
            PER_MINUTE * found.speed
        ),
    );
    text.line("equation", EQUATION);
    let names = coordinates
        .iter()
        .map(|(name, unit)| format!("{name} ({unit})"));
    text.line("coordinates", names.collect::<Vec<_>>().join(", "));
    let reduction = found.natural_up_to.map(|highest| {
        format!(
            "natural frequencies up to about {} Hz are those of the shaft; further ones with more `modes` in [shaft]",
            to_digits(highest, 2)
        )
    });
    text.each("reduction", reduction);
    let list = Table::from_items(coordinates)
        .word("coordinate", |own| &own.0)
        .word("unit", |own| own.1)
        .end();
    let npz = Npz::default()
        .matrix("M", &found.mass)
        .matrix("C", &found.damping)
        .matrix("G", &found.gyroscopic)
        .matrix("K", &found.stiffness)
        .matrix("A", &found.state)
        .words("coordinates", coordinates.iter().map(|own| &*own.0))
        .words("units", coordinates.iter().map(|own| own.1))
        .number("speed_rad_s", found.speed);
    let columns = columns(found);
    let rates = columns.iter().map(|own| format!("{own}_rate"));
    let states: Vec<_> = columns.iter().cloned().chain(rates).collect();
    Findings {
        tables: vec![("coordinates", list)],
        long_tables: vec![
            ("mass".to_owned(), table(&columns, &found.mass)),
            ("damping".to_owned(), table(&columns, &found.damping)),
            ("gyroscopic".to_owned(), table(&columns, &found.gyroscopic)),
            ("stiffness".to_owned(), table(&columns, &found.stiffness)),
            ("state_matrix".to_owned(), table(&states, &found.state)),
        ],
        files: vec![("matrices.npz", npz.bytes())],
        ..Findings::new(FileSet::sealed("matrices.json"), scenario, document, text)
    }
}

/// Names of columns, each once: points of the shaft may be nearer to each other than their names tell.
fn columns(found: &LinearMatrices) -> Vec<String> {
    let mut columns: Vec<String> = Vec::new();
    for (name, _) in &found.coordinates {
        let name = name.replace([' ', '.'], "_");
        let name = match columns.contains(&name) {
            true => format!("{name}_{}", columns.len() + 1),
            false => name,
        };
        columns.push(name);
    }
    columns
}

fn table(columns: &[String], matrix: &DMatrix<f64>) -> Table<'static> {
    let mut table = Table::default();
    for (name, column) in columns.iter().zip(matrix.column_iter()) {
        table.add(Column::number(name.clone(), ""), column.iter().copied());
    }
    table
}
