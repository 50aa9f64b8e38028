//! Times that a recorder writes as dates and clock times: `2026-03-01T12:00:00.000125`.

use toml::value::Datetime;

const SECONDS_PER_DAY: f64 = 86_400.0;

/// Seconds of a date, a time of the day or both in the form of RFC 3339, from the year 0 or from midnight on; none of
/// other texts. Decimals may follow a comma.
pub(super) fn seconds(cell: &[u8]) -> Option<f64> {
    // no number holds either sign behind its first
    let may_be_one = cell.iter().skip(1).any(|sign| b":-".contains(sign));
    let text = std::str::from_utf8(cell).ok().filter(|_| may_be_one)?;
    let stamp: Datetime = text.replace(',', ".").parse().ok()?;
    let days = stamp.date.map_or(0, |date| {
        days(date.year.into(), date.month.into(), date.day.into())
    });
    let clock = stamp.time.map_or(0.0, |time| {
        let whole = 3600 * u32::from(time.hour) + 60 * u32::from(time.minute);
        let second = f64::from(time.second.unwrap_or(0));
        f64::from(whole) + second + 1e-9 * f64::from(time.nanosecond.unwrap_or(0))
    });
    let ahead = match stamp.offset {
        Some(toml::value::Offset::Custom { minutes }) => 60.0 * f64::from(minutes),
        _ => 0.0,
    };
    Some(SECONDS_PER_DAY * f64::from(days) + clock - ahead)
}

/// Days from the first of March of the year 0 to a date of the Gregorian calendar.
fn days(year: i32, month: i32, day: i32) -> i32 {
    // years begin with March, so that a leap day is their last
    let (year, month) = match month {
        3.. => (year, month - 3),
        _ => (year - 1, month + 9),
    };
    let leap_days = year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400);
    365 * year + leap_days + (153 * month + 2) / 5 + day - 1
}

/// Puts neighbouring columns of dates and of times of the day together into the first of them, as seconds from its first row;
/// the others are emptied.
pub(super) fn join(columns: &mut [Vec<f64>]) {
    let Some((first, others)) = columns.split_first_mut() else {
        return;
    };
    for other in others {
        let parts = std::mem::take(other);
        first
            .iter_mut()
            .zip(parts)
            .for_each(|(sum, part)| *sum += part);
    }
    over_midnight(first);
    if let Some(start) = first.first().copied() {
        first.iter_mut().for_each(|time| *time -= start);
    }
}

/// Lets times of the day in s rise over midnight: from each fall by nearly a day on they are a day later. Dates stay.
pub(super) fn over_midnight(times: &mut [f64]) {
    let is_of_day = |time: &f64| (0.0..SECONDS_PER_DAY).contains(time);
    if !times.iter().all(is_of_day) {
        return;
    }
    let (mut before, mut midnight) = (0.0, 0.0);
    for time in times {
        if before - *time > 0.5 * SECONDS_PER_DAY {
            midnight += SECONDS_PER_DAY;
        }
        before = *time;
        *time += midnight;
    }
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn dates_and_times_are_seconds() {
        let between = |from: &str, to: &str| {
            seconds(to.as_bytes()).unwrap() - seconds(from.as_bytes()).unwrap()
        };
        // a leap year of a century
        assert_eq!(between("2000-02-28", "2000-03-01"), 2.0 * 86_400.0);
        assert_eq!(between("2100-02-28", "2100-03-01"), 86_400.0);
        assert_eq!(between("1970-01-01", "2026-11-28"), 20_785.0 * 86_400.0);
        let (utc, there) = ("2026-01-01T00:30:00Z", "2026-01-01 01:30:00,5+01:00");
        assert_eq!(between(utc, there), 0.5);
        assert_eq!(seconds(b"12:00:00.25"), Some(43_200.25));
        for text in [
            "",
            "-1",
            "1e-3",
            "12:00:61",
            "2026-02-30",
            "28.11.2026",
            "a:b",
        ] {
            assert_eq!(seconds(text.as_bytes()), None, "{text}");
        }
    }
}
