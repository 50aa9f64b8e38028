//! The table `poincare`: the motion once per revolution and once per ball pass.

use super::super::table::Column;
use super::super::{ReportError, RunFolder, WholeFile};
use crate::analysis::{Channel, Motion, PoincarePoint, SectionKind};
use crate::rotor::FREEDOMS;

/// Writes one row a point, section by section: which section, cycles since the start, time, then
/// displacements and velocities.
pub(in super::super) fn write_poincare(
    motion: &Motion,
    folder: &RunFolder,
) -> Result<Vec<WholeFile>, ReportError> {
    folder.write_rows("poincare", &columns(), |take| {
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
        Column::words("section", ["revolution", "ball_pass"]),
        Column::count("number"),
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
