//! Columns of a table become channels: those that hold times say when the others were sampled.

use super::header::Heading;
use super::stamp;
use crate::record::unit::per_second;
use crate::record::{Problem, Record, RecordChannel, Sampling};

/// Bounds of hour, minute, second and microsecond.
const CLOCK: [f64; 4] = [24.0, 60.0, 60.0, 1e6];
/// Part of the steps of a clock that rise at least: one may be set back.
const RISING: f64 = 0.99;

/// Adds the columns as channels. A column of times holds for those to its right, up to the next one.
pub fn add(
    record: &mut Record,
    headings: Vec<Heading>,
    columns: Vec<Vec<f64>>,
) -> Result<(), Problem> {
    let is_named = headings.iter().any(|heading| !heading.name.is_empty());
    let clock = if is_named { None } else { clock(&columns) };
    let clocks = if clock.is_some() { CLOCK.len() } else { 0 };
    let mut sampling = clock.unwrap_or_default();
    let named = headings.into_iter().zip(columns).enumerate().skip(clocks);
    for (place, (heading, mut samples)) in named {
        // columns of different lengths end with empty cells
        let last = samples.iter().rposition(|value| !value.is_nan());
        samples.truncate(last.map_or(0, |last| last + 1));
        let (name, unit) = (&heading.name, heading.unit.as_deref());
        let per_second = unit.and_then(per_second);
        if let Some(per_second) = per_second.filter(|_| place == 0 || heading.is_time()) {
            samples.iter_mut().for_each(|time| *time /= per_second);
            sampling = Sampling::from_times(&samples);
            continue;
        }
        if samples.is_empty() {
            continue;
        }
        if unit.is_none() && heading.is_time() {
            record.warn(format!(
                "the times in `{name}` have no unit; the rate is unknown"
            ));
        }
        let sampling = match &sampling {
            Sampling::Times(times) if times.len() != samples.len() => Sampling::Unknown,
            known => known.clone(),
        };
        let name = match heading.name.is_empty() {
            true => format!("column{}", place + 1),
            false => heading.name,
        };
        record.add(RecordChannel {
            sampling,
            quantity: heading.quantity,
            unit: heading.unit,
            ..RecordChannel::new(name, samples)
        })?;
    }
    Ok(())
}

/// The sampling of columns that begin with hour, minute, second and microsecond, where these rise but for a few rows.
fn clock(columns: &[Vec<f64>]) -> Option<Sampling> {
    let (clock, [_, ..]) = columns.split_first_chunk::<4>()? else {
        return None;
    };
    let is_part = |(column, end): (&Vec<f64>, f64)| {
        let is_one = |value: &f64| (0.0..end).contains(value) && value.fract() == 0.0;
        column.iter().all(is_one)
    };
    if !clock.iter().zip(CLOCK).all(is_part) {
        return None;
    }
    let [hours, minutes, seconds, micros] = clock;
    let time =
        |row: usize| 3600.0 * hours[row] + 60.0 * minutes[row] + seconds[row] + micros[row] / 1e6;
    let mut times: Vec<f64> = (0..micros.len()).map(time).collect();
    stamp::over_midnight(&mut times);
    let steps = times.windows(2);
    let rising = steps.filter(|pair| pair[0] < pair[1]).count();
    let is_clock = rising > 0 && rising as f64 >= RISING * (times.len() - 1) as f64;
    is_clock.then(|| Sampling::from_times(&times))
}
