//! The events of a run as rows of a table.

use super::table::Column;
use crate::simulate::{Event, EventKind};

/// Columns of `events.csv`, in their order.
pub const EVENT_COLUMNS: [&str; 4] = ["t_s", "event", "bearing", "ball"];

/// Columns of a table of events; what happens to a bearing as a whole has no ball.
pub fn event_columns() -> [Column; 4] {
    let [time, event, bearing, ball] = EVENT_COLUMNS;
    [
        Column::number(time),
        Column::words(event, EventKind::ALL.map(EventKind::name)),
        Column::count(bearing),
        Column::count(ball),
    ]
}

/// The row of an event; bearings and balls count from 1.
pub fn event_row(event: &Event) -> [f64; 4] {
    let ball = event.ball.map_or(f64::NAN, |ball| (ball + 1) as f64);
    let kind = f64::from(event.kind as u8);
    [event.time, kind, (event.bearing + 1) as f64, ball]
}
