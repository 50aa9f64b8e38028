//! `around.csv`: one row for each value, bearing and position around it.

use std::io::{self, Write};

use super::super::table::number;
use super::column_name;
use crate::study::{StudyRow, Variable};

/// Columns after the varied one.
const COLUMNS: [&str; 8] = [
    "bearing",
    "position",
    "azimuth_rad",
    "deformation_m",
    "load_inner_N",
    "load_outer_N",
    "angle_inner_rad",
    "angle_outer_rad",
];

/// Writes the table.
pub(super) fn write<W: Write>(variable: &Variable, rows: &[StudyRow], writer: W) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(writer);
    let varied = column_name(variable);
    writer.write_record(std::iter::once(varied.as_str()).chain(COLUMNS))?;
    for row in rows {
        for (bearing, around) in row.around.iter().enumerate() {
            for (position, place) in around.iter().enumerate() {
                let contact = &place.contact;
                let places = [bearing + 1, position + 1].map(|count| count.to_string());
                let values = [
                    place.azimuth,
                    place.deformation,
                    contact.load_inner,
                    contact.load_outer,
                    contact.angle_inner,
                    contact.angle_outer,
                ];
                let cells = std::iter::once(number(row.value)).chain(places);
                writer.write_record(cells.chain(values.map(number)))?;
            }
        }
    }
    writer.flush()
}
