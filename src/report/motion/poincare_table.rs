//! The table `poincare`: the motion once per revolution and once per ball pass.

use super::super::table::{Column, ColumnKind, TableTarget};
use super::super::{ReportError, WholeFile};
use crate::analysis::{Channel, Motion, PoincarePoint, SectionKind};
use crate::rotor::FREEDOMS;

/// Names of the sections in the table.
const SECTIONS: &[&str] = &["revolution", "ball_pass"];

/// Writes one row a point, section by section: which section, cycles since the start, time, then
/// displacements and velocities.
pub(in super::super) fn write_poincare(
    motion: &Motion,
    target: TableTarget<'_>,
) -> Result<Vec<WholeFile>, ReportError> {
    target.write("poincare", &columns(), |take| {
        motion.sections.iter().try_for_each(|section| {
            let word = match section.kind {
                SectionKind::Revolution => 0.0,
                SectionKind::BallPass => 1.0,
            };
            let mut points = section.points.iter();
            points.try_for_each(|point| take(&row(word, point)))
        })
    })
}

fn columns() -> Vec<Column> {
    let mut columns = vec![
        Column::of("section", ColumnKind::Word(SECTIONS)),
        Column::of("number", ColumnKind::Count),
        Column::number("t_s"),
    ];
    let channels = || (0..FREEDOMS).map(Channel::Displacement);
    columns.extend(channels().map(|channel| Column::number(channel.column())));
    columns.extend(
        channels()
            .map(|channel| Column::number(format!("{channel}_velocity_{}_s", channel.unit()))),
    );
    columns
}

fn row(section: f64, point: &PoincarePoint) -> Vec<f64> {
    let mut row = vec![section, point.number as f64, point.time];
    row.extend(point.displacement.iter().chain(&point.velocity));
    row
}
