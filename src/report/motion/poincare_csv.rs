//! `poincare.csv`: the motion once per revolution and once per ball pass.

use std::io::{self, Write};

use super::super::columns::value_column;
use super::super::statics::number;
use crate::analysis::{Channel, Motion, PoincarePoint};
use crate::rotor::FREEDOMS;

/// Writes one row a point, section by section: which section, cycles since the start, time, then
/// displacements and velocities.
pub(in super::super) fn write_poincare(motion: &Motion, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(writer);
    csv.write_record(header())?;
    for section in &motion.sections {
        let name = section.kind.to_string();
        for point in &section.points {
            csv.write_record(row(&name, point))?;
        }
    }
    csv.flush()
}

fn header() -> Vec<String> {
    let mut names: Vec<String> = ["section", "number", "t_s"].map(str::to_owned).to_vec();
    names.extend((0..FREEDOMS).map(|axis| value_column(Channel::Displacement(axis))));
    names.extend((0..FREEDOMS).map(|axis| {
        let channel = Channel::Displacement(axis);
        format!("{channel}_velocity_{}_s", channel.unit())
    }));
    names
}

fn row(section: &str, point: &PoincarePoint) -> Vec<String> {
    let values = point.displacement.iter().chain(&point.velocity);
    let mut row = vec![
        section.to_owned(),
        point.number.to_string(),
        number(point.time),
    ];
    row.extend(values.map(|value| number(*value)));
    row
}
