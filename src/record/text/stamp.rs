//! Times that a recorder writes as dates and clock times: `2026-03-01T12:00:00.000125`.

use toml::value::Datetime;

const SECONDS_PER_DAY: i64 = 86_400;
const NANOSECONDS: i128 = 1_000_000_000;

/// Nanoseconds of a date, a time of the day or both in the form of RFC 3339, from the year 0 or from midnight on; none of
/// other texts. Decimals may follow a comma.
pub(super) fn nanoseconds(cell: &[u8]) -> Option<i128> {
    // no number holds either sign behind its first
    let may_be_one = cell.iter().skip(1).any(|sign| b":-".contains(sign));
    let text = std::str::from_utf8(cell).ok().filter(|_| may_be_one)?;
    let stamp: Datetime = text.replace(',', ".").parse().ok()?;
    let days = stamp.date.map_or(0, |date| {
        days(date.year.into(), date.month.into(), date.day.into())
    });
    let [clock, parts] = stamp.time.map_or([0, 0], |time| {
        let minutes = 60 * i64::from(time.hour) + i64::from(time.minute);
        let second = i64::from(time.second.unwrap_or(0));
        [60 * minutes + second, time.nanosecond.unwrap_or(0).into()]
    });
    let ahead = match stamp.offset {
        Some(toml::value::Offset::Custom { minutes }) => 60 * i64::from(minutes),
        _ => 0,
    };
    let seconds = SECONDS_PER_DAY * i64::from(days) + clock - ahead;
    Some(NANOSECONDS * i128::from(seconds) + i128::from(parts))
}

/// Seconds from the first date or time of a column to one of a cell, and that first one where it is not known yet. Of the seconds
/// from the year 0 on, a double has steps of 8 µs.
pub(super) fn since_first(cell: &[u8], first: &mut Option<i128>) -> Option<f64> {
    let now = nanoseconds(cell)?;
    Some((now - *first.get_or_insert(now)) as f64 / NANOSECONDS as f64)
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

/// Puts neighbouring columns of dates and of times of the day, in seconds from their first rows, together into the first of them;
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
}

/// Lets times of the day in s, from midnight or the first of them on, rise over midnight: from each fall by more than half a day
/// on they are a day later. Times that span a day or more have their dates already, and stay.
pub(super) fn over_midnight(times: &mut [f64]) {
    let day = SECONDS_PER_DAY as f64;
    let is_of_day = |time: &f64| time.abs() < day;
    if !times.iter().all(is_of_day) {
        return;
    }
    let (mut before, mut midnight) = (0.0, 0.0);
    for time in times {
        if before - *time > 0.5 * day {
            midnight += day;
        }
        before = *time;
        *time += midnight;
    }
}

#[cfg(test)]
mod tests {
    use super::nanoseconds;

    #[test]
    fn dates_and_times_are_seconds() {
        let between = |from: &str, to: &str| {
            let [from, to] = [from, to].map(|text| nanoseconds(text.as_bytes()).unwrap());
            (to - from) as f64 / 1e9
        };
        // a leap year of a century
        assert_eq!(between("2000-02-28", "2000-03-01"), 2.0 * 86_400.0);
        assert_eq!(between("2100-02-28", "2100-03-01"), 86_400.0);
        assert_eq!(between("1970-01-01", "2026-11-28"), 20_785.0 * 86_400.0);
        let (utc, there) = ("2026-01-01T00:30:00Z", "2026-01-01 01:30:00,5+01:00");
        assert_eq!(between(utc, there), 0.5);
        assert_eq!(nanoseconds(b"12:00:00.25"), Some(43_200_250_000_000));
        let next = "2026-01-01T00:00:00.000000001";
        assert_eq!(between("2026-01-01T00:00:00", next), 1e-9);
        for text in [
            "",
            "-1",
            "1e-3",
            "12:00:61",
            "2026-02-30",
            "28.11.2026",
            "a:b",
        ] {
            assert_eq!(nanoseconds(text.as_bytes()), None, "{text}");
        }
    }
}
