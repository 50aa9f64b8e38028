//! Measured records: every form gives the samples that were written, broken files are refused with their place.

use std::fs;
use std::path::PathBuf;

use crate::record::{Problem, Record, RecordChannel, RecordError, Sampling};
use crate::tests::allocations::measured;

const LENGTH: usize = 100;
const RATE: f64 = 25600.0;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/records")
}

fn record(file: &str) -> Record {
    Record::open(&folder().join(file)).unwrap()
}

/// Reads bytes; with the most memory that was in use for it.
fn read_measured(bytes: &[u8], name: &str) -> (Result<Record, RecordError>, usize) {
    let mut read = None;
    let (_, most) = measured(|| read = Some(Record::from_bytes(bytes, name)));
    (read.unwrap(), most as usize)
}

/// Every record of the folder with its name.
fn all() -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap());
    let mut all: Vec<_> = entries
        .map(|entry| (entry.file_name().into_string().unwrap(), entry.path()))
        .filter(|(name, _)| !name.ends_with(".py") && !name.ends_with(".md"))
        .map(|(name, path)| (name, fs::read(path).unwrap()))
        .collect();
    all.sort();
    all
}

/// The sample that `make.py` wrote, as a whole number of 16 bits.
fn whole(channel: usize, index: usize) -> f64 {
    let wrapped = (7919 * index + 104_729 * channel + 12_345) % 65_536;
    wrapped as f64 - 32_768.0
}

#[track_caller]
fn assert_samples(record: &Record, name: &str, channel: usize, error: f64) {
    let found = record.channel(name);
    let found = found.unwrap_or_else(|| panic!("no {name} in {record:?}"));
    assert_eq!(found.samples.len(), LENGTH);
    for (index, sample) in found.samples.iter().enumerate() {
        let expected = whole(channel, index) / 32_768.0;
        assert!(
            (sample - expected).abs() <= error,
            "{name} {index}: {sample} {expected}"
        );
    }
}

#[track_caller]
fn assert_even(channel: &RecordChannel, rate: f64) {
    let found = channel.sampling.rate().unwrap();
    assert!((found / rate - 1.0).abs() < 1e-12, "{found}");
}

/// Files whose channels are `make.py`'s 0, 1, 2 … in their order, to an error, with their rate if they say it.
#[rustfmt::skip]
const FILES: [(&str, &[&str], f64, Option<f64>); 28] = [
    ("xjtu.csv", &["Horizontal_vibration_signals", "Vertical_vibration_signals"], 0.0, None),
    ("ims", &["column1", "column2", "column3", "column4"], 0.0, None),
    ("mafaulda.csv", &["column1", "column2", "column3", "column4", "column5", "column6", "column7", "column8"], 0.0, None),
    ("timed.csv", &["acc x", "acc y"], 0.0, Some(RATE)),
    ("german.csv", &["Weg x", "Weg y"], 0.0, Some(RATE)),
    ("latin1.txt", &["x", "y"], 0.0, Some(RATE)),
    ("units_row.csv", &["Acc 1", "Acc 2"], 0.0, Some(RATE)),
    ("savetxt.txt", &["left", "right"], 0.0, None),
    ("percent.dat", &["column1", "column2"], 0.0, None),
    ("quoted.csv", &["acc, x"], 0.0, Some(RATE)),
    ("trace.csv", &["x_m", "x_velocity_m_s"], 0.0, Some(RATE)),
    ("i16.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("i24.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("i32.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("f32.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("f64.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("u8.wav", &["channel1", "channel2"], 0.0079, Some(RATE)),
    ("extensible.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("long.wav", &["channel1", "channel2"], 0.0, Some(RATE)),
    ("cwru.mat", &["X112_DE_time", "X112_FE_time", "X112_BA_time"], 0.0, None),
    ("cwru_packed.mat", &["X112_DE_time", "X112_FE_time", "X112_BA_time"], 0.0, None),
    ("curtin.mat", &["Channel_1", "Channel_2"], 0.0, None),
    ("mfpt.mat", &["bearing.gs"], 0.0, None),
    ("text.uff", &["sensor 0", "node11-x"], 1e-12, Some(RATE)),
    ("text_single.uff", &["sensor 0"], 6e-6, Some(RATE)),
    ("text_complex.uff", &["sensor 0.real", "sensor 0.imaginary"], 1e-12, Some(RATE)),
    ("binary.uff", &["sensor 0", "sensor 1"], 0.0, Some(RATE)),
    ("binary_complex.uff", &["sensor 0.real", "sensor 0.imaginary"], 0.0, Some(RATE)),
];

#[test]
fn every_form_gives_the_samples_that_were_written() {
    for (file, names, error, rate) in FILES {
        let record = record(file);
        for (channel, name) in names.iter().enumerate() {
            assert_samples(&record, name, channel, error);
            let sampling = &record.channel(name).unwrap().sampling;
            assert_eq!(sampling.rate().is_some(), rate.is_some(), "{file}");
            if let Some(rate) = rate {
                assert_even(record.channel(name).unwrap(), rate);
            }
        }
    }
    for file in ["binary_single.uff", "binary_stray.uff"] {
        let record = record(file);
        assert_samples(&record, &record.channels[0].name, 0, 0.0);
        assert_eq!(record.channels[0].unit.as_deref(), Some("m"));
    }
}

#[test]
fn units_quantities_and_places_are_those_of_the_file() {
    let units = |file| {
        let record = record(file);
        let units = record.channels.into_iter().map(|channel| channel.unit);
        units.collect::<Vec<_>>()
    };
    let some = |unit: &str| Some(unit.to_owned());
    assert_eq!(units("timed.csv"), [some("m/s^2"), some("g")]);
    assert_eq!(units("german.csv"), [some("\u{b5}m"), some("\u{3bc}m")]);
    assert_eq!(units("latin1.txt"), [some("\u{b5}m"), some("m/s\u{b2}")]);
    assert_eq!(units("units_row.csv"), [some("g"), some("m/s^2")]);
    assert_eq!(units("trace.csv"), [some("m"), some("m/s"), None]);
    assert_eq!(units("xjtu.csv"), [None, None]);
    let trace = record("trace.csv");
    let quantity = trace.channels[1].quantity.as_deref();
    assert_eq!(quantity, Some("x_velocity"));
    let universal = record("text.uff");
    let channel = universal.channel("node11-x").unwrap();
    assert_eq!(channel.quantity.as_deref(), Some("acceleration"));
    assert_eq!(
        (channel.node, channel.direction.as_deref()),
        (Some(11), Some("-x"))
    );
}

#[test]
fn uneven_times_stay_and_rounded_ones_are_even() {
    let times = |file| match &record(file).channels[0].sampling {
        Sampling::Times(times) => times.to_vec(),
        other => panic!("{file}: {other:?}"),
    };
    for file in ["uneven.csv", "text_uneven.uff", "binary_uneven.uff"] {
        let times = times(file);
        let mut expected = 0.0;
        for (index, time) in times.iter().enumerate() {
            expected += 1e-3 * (1.0 + 0.5 * (index % 3) as f64);
            assert!(
                (time - expected).abs() < 1e-6 * expected,
                "{file}: {time} {expected}"
            );
        }
    }
    assert_eq!(times("binary_mixed.uff")[10], 50.0);
    for file in ["femto.csv", "femto_semicolons.csv"] {
        let record = self::record(file);
        // 100 samples with times in whole microseconds
        let rate = record.channels[0].sampling.rate().unwrap();
        assert!((rate / RATE - 1.0).abs() < 1e-6 / (99.0 / RATE));
        assert_samples(&record, "column5", 0, 0.0);
        assert_samples(&record, "column6", 1, 0.0);
    }
    let text = fs::read_to_string(folder().join("text.uff")).unwrap();
    let in_ms = text.replace(" s                  ", " ms                 ");
    let record = Record::from_bytes(in_ms.as_bytes(), "a.uff").unwrap();
    assert_even(&record.channels[0], 1e3 * RATE);
    let record = self::record("two_rates.csv");
    assert_even(record.channel("fast").unwrap(), RATE);
    assert_even(record.channel("slow").unwrap(), RATE / 10.0);
    assert_eq!(record.channel("slow").unwrap().samples.len(), LENGTH / 2);
    let unordered = |times: &[f64]| match Sampling::from_times(times) {
        Sampling::Unordered(row) => row,
        other => panic!("{other:?}"),
    };
    assert_eq!(unordered(&[0.0, 1.0, 1.0]), 3);
    assert_eq!(unordered(&[0.0, f64::NAN, 2.0]), 2);
    assert_eq!(unordered(&[0.0, 1.0, f64::INFINITY]), 3);
    assert_eq!(Sampling::from_times(&[0.0]), Sampling::Unknown);
}

#[test]
fn matlab_values_of_every_kind_are_read() {
    let record = record("kinds.mat");
    for (name, channel) in [("single", 0), ("complex.real", 0), ("complex.imaginary", 1)] {
        assert_samples(&record, name, channel, 0.0);
    }
    for channel in 0..3 {
        for shape in ["tall", "wide"] {
            assert_samples(&record, &format!("{shape}[{}]", channel + 1), channel, 0.0);
        }
    }
    assert_samples(&record, "cells[1]", 0, 0.0);
    assert_samples(&record, "cells[3]", 1, 0.0);
    let wholes = |name: &str, of: fn(f64) -> f64| {
        let samples = &record.channel(name).unwrap().samples;
        let expected = (0..LENGTH).map(|index| of(whole(0, index)));
        assert!(samples.iter().copied().eq(expected), "{name}");
    };
    wholes("int16", |value| value);
    wholes("int64", |value| value);
    wholes("uint8", |value| value.rem_euclid(256.0));
    wholes("int8", |value| value.rem_euclid(128.0));
    wholes("logical", |value| f64::from(value > 0.0));
    assert_eq!(record.numbers, [("fs".to_owned(), RATE)]);
    assert!(
        record
            .texts
            .contains(&("label".to_owned(), "m/s\u{b2} of a housing".to_owned()))
    );
    assert!(
        record
            .warnings
            .iter()
            .any(|warning| warning.contains("`sparse`"))
    );
    let big = self::record("big_endian.mat");
    assert_samples(&big, "x", 0, 0.0);
    assert_samples(&big, "y", 0, 0.0);
}

#[test]
fn structs_with_a_name_and_data_are_channels_of_that_name() {
    let record = record("paderborn.mat");
    assert_samples(&record, "phase_current_1", 1, 0.0);
    assert_samples(&record, "vibration_1", 4, 0.0);
    assert_eq!(record.channel("force").unwrap().samples.len(), 20);
    assert_eq!(
        record.channel("speed").unwrap().unit.as_deref(),
        Some("rpm")
    );
    assert_eq!(
        self::record("cwru.mat").numbers,
        [("X112RPM".to_owned(), 1797.0)]
    );
    assert!(
        self::record("mfpt.mat")
            .numbers
            .contains(&("bearing.sr".to_owned(), 97_656.0))
    );
}

#[test]
fn missing_samples_are_counted_and_spectra_left_out() {
    let gaps = record("gaps.csv");
    assert!(gaps.channel("b").unwrap().samples[7].is_nan());
    assert_eq!(gaps.missing().len(), 1);
    let response = record("response.uff");
    assert_eq!((response.channels.len(), response.warnings.len()), (1, 1));
    let whole = Record::from_bytes(b"a,b\n1,2\n3,4\n5,6\n7,", "a.csv").unwrap();
    assert_eq!(whole.channel("a").unwrap().samples, [1.0, 3.0, 5.0, 7.0]);
    let cut = Record::from_bytes(b"a,b\n1,2\n3,4\n5,6\n7", "a.csv").unwrap();
    assert_eq!(cut.channel("a").unwrap().samples, [1.0, 3.0, 5.0]);
    assert_eq!(cut.warnings.len(), 1);
}

#[test]
fn a_table_with_words_is_refused_at_its_first_row() {
    let rows = |row: &str, above: &str| {
        let text = format!("{above}{}", row.repeat(50));
        let error = Record::from_bytes(text.as_bytes(), "a.csv").unwrap_err();
        error.problem.to_string()
    };
    let said = rows("0.5,1,ON\n", "Rate,100,Hz\n\ntime [s],x,state\n");
    assert!(said.starts_with("line 4: `ON` in column 3"), "{said}");
    let said = rows("0,1.0X+00\n", "time [s],x\n");
    assert!(said.starts_with("line 2: `1.0X+00` in column 2"), "{said}");
    let said = rows("1.0X+00,1.0X+00\n", "time [s],x\n");
    assert!(said.starts_with("line 2: `1.0X+00` in column 1"), "{said}");
    let said = rows("0.5;0,25\n", "t [s];x\n0;0\n");
    assert!(said.starts_with("line 3: `0,25` in column 2"), "{said}");
}

#[test]
fn what_a_file_lacks_is_not_guessed() {
    let unknown = |text: &str| {
        let record = Record::from_bytes(text.as_bytes(), "a.csv").unwrap();
        record
            .channels
            .iter()
            .all(|it| it.sampling == Sampling::Unknown && it.unit.is_none())
    };
    assert!(unknown("time,a\n0,1\n1,2\n2,3\n"));
    assert!(unknown("0,1\n1,2\n2,3\n"));
    assert!(unknown("m/s,a(1),b [DE]\n0,1,3\n1,2,3\n2,3,3\n"));
    let record = Record::from_bytes(b"t [s],a\n0,1\n2,2\n1,3\n", "a.csv").unwrap();
    assert_eq!(record.channels[0].sampling, Sampling::Unordered(3));
    // one column with decimal commas looks the same
    let record = Record::from_bytes(b"0,1\n1,2\n2,3\n", "a.csv").unwrap();
    assert_eq!(record.warnings.len(), 1);
    let record = Record::from_bytes(b"x (mm)\n0,1\n1,2\n2,3\n", "a.csv").unwrap();
    assert_eq!(record.channels[0].samples, [0.1, 1.2, 2.3]);
}

#[test]
fn lines_above_the_rows_give_names_and_numbers() {
    let labview = "Samples\t3\nDelta_X\t0.5\nX_Value\tVolt\tComment\n0\t1\n2\t3\n4\t5\n";
    let record = Record::from_bytes(labview.as_bytes(), "a.lvm").unwrap();
    let names: Vec<_> = record.channels.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(names, ["X_Value", "Volt"]);
    assert_eq!(record.numbers[1], ("Delta_X".to_owned(), 0.5));
    let text = "Fs = 25600 Hz\nCh1 [g] Ch2 [mm/s]\n1 2\n3 4\n5 6\n";
    let record = Record::from_bytes(text.as_bytes(), "a.txt").unwrap();
    assert_eq!(record.numbers, [("Fs".to_owned(), RATE)]);
    assert_eq!(record.channels[1].unit.as_deref(), Some("mm/s"));
    let text = "sep=;\nt/s;a/(m/s\u{b2})\n0;1\n0,5;2\n1;3\n";
    let record = Record::from_bytes(text.as_bytes(), "a.csv").unwrap();
    assert_eq!(
        (
            record.channels[0].name.as_str(),
            record.channels[0].sampling.rate()
        ),
        ("a", Some(2.0))
    );
}

/// Recorders write dates and times of the day in one column or in two.
#[test]
fn dates_and_clock_times_are_times() {
    let texts = [
        "timestamp,a\n2026-02-28T23:59:59.9990,1\n2026-02-28T23:59:59.9995,2\n2026-03-01T00:00:00,3\n",
        "2026-02-28 23:59:59,9990;1\n2026-02-28 23:59:59,9995;2\n2026-03-01 00:00:00;3\n",
        "date\ttime\ta\n2026-02-28\t23:59:59.9990\t1\n2026-02-28\t23:59:59.9995\t2\n2026-03-01\t00:00:00\t3\n",
        "12:00:00.5000 1\n12:00:00.5005 2\n12:00:00.5010 3\n",
        "23:59:59.9990 1\n23:59:59.9995 2\n00:00:00.0000 3\n",
    ];
    for text in texts {
        let record = Record::from_bytes(text.as_bytes(), "a.csv").unwrap();
        let [channel] = &record.channels[..] else {
            panic!("{text}: {record:?}");
        };
        assert_eq!(channel.samples, [1.0, 2.0, 3.0], "{text}");
        let Sampling::Even { rate, start } = channel.sampling else {
            panic!("{text}: {channel:?}");
        };
        assert!(start == 0.0 && (rate / 2000.0 - 1.0).abs() < 1e-7, "{rate}");
    }
    let text = "timestamp,a\n28/02/2026 23:59,1\n28/02/2026 23:59,2\n01/03/2026 00:00,3\n";
    let error = Record::from_bytes(text.as_bytes(), "a.csv").unwrap_err();
    assert!(
        error.to_string().contains("2026-03-01T12:00:00.5"),
        "{error}"
    );
    // between numbers a date is none
    let text = "a\n1\n2\n3\n2026-03-01\n4\n";
    assert!(Record::from_bytes(text.as_bytes(), "a.csv").is_err());
}

/// Hour, minute, second and microsecond at 2 kHz, from an hour on; one row may be of another time.
fn clock(rows: u32, hour: u32, other: Option<(u32, &str)>) -> Record {
    let row = |row: u32| {
        let micros = 500 * row + 900_000;
        let (carry, micros) = (micros / 1_000_000, micros % 1_000_000);
        let second = 3600 * hour + 3599 + carry;
        let [hour, minute, second] = [second / 3600 % 24, second / 60 % 60, second % 60];
        match other {
            Some((place, time)) if place == row => format!("{time},{row}\n"),
            _ => format!("{hour},{minute},{second},{micros},{row}\n"),
        }
    };
    let text: String = (0..rows).map(row).collect();
    Record::from_bytes(text.as_bytes(), "a.csv").unwrap()
}

/// Over midnight it runs on; where it is set back or repeats a time, that is told with the row.
#[test]
fn a_clock_in_columns_runs_on_over_midnight() {
    for hour in [9, 23] {
        let record = clock(1000, hour, None);
        let [channel] = &record.channels[..] else {
            panic!("{hour}: {:?}", record.list());
        };
        let rate = channel.sampling.rate().expect("an even rate");
        assert!((rate - 2000.0).abs() < 1e-3, "{rate}");
        assert_eq!(record.warnings.len(), 0);
    }
    let back = clock(1000, 23, Some((100, "23,59,0,0")));
    assert_eq!(back.channels.len(), 1);
    assert_eq!(back.channels[0].sampling, Sampling::Unordered(101));
    assert_eq!(back.warnings.len(), 1);
    // what does not rise in most rows is data
    let data = (0..100).map(|row| format!("{},{},0,{row},1\n", row % 7, row % 3));
    let data = data.collect::<String>();
    let data = Record::from_bytes(data.as_bytes(), "a.csv").unwrap();
    assert_eq!(data.channels.len(), 5);
}

#[test]
fn commas_between_cells_and_before_decimals_are_refused() {
    let text = b"t,a\n0,001,1,25\n0,002,1,50\n0,003,1,75\n";
    let error = Record::from_bytes(text, "a.csv").unwrap_err().to_string();
    assert!(error.contains("decimal points"), "{error}");
}

#[test]
fn names_beside_times_in_seconds_keep_their_units() {
    let text = b"t_s,v_mm_s,x_m_s,a_mm_s2,h_m\n0,1,2,3,4\n1,1,2,3,4\n2,1,2,3,4\n";
    let record = Record::from_bytes(text, "a.csv").unwrap();
    let units: Vec<_> = record
        .channels
        .iter()
        .map(|it| it.unit.as_deref())
        .collect();
    let expected = [Some("mm/s"), Some("m/s"), Some("mm/s2"), Some("m")];
    assert_eq!(units, expected);
    assert_eq!(record.channels[0].quantity.as_deref(), Some("v"));
}

/// Fortran writes exponents behind a D, old Macintosh programs end lines with a carriage return, and quotes within quotes are doubled.
#[test]
fn rarer_ways_to_write_a_table_are_read() {
    let samples = |text: &str, name: &str| {
        let record = Record::from_bytes(text.as_bytes(), "a.csv").unwrap();
        let channel = record.channel(name);
        channel
            .unwrap_or_else(|| panic!("{record:?}"))
            .samples
            .clone()
    };
    let expected = [-1.0e-3, 2.5e4, 0.5];
    let text = "t [s],a\n0,-1.0D-3\n1,2.5d+04\n2,0.5D0\n";
    assert_eq!(samples(text, "a"), expected);
    let text = "t [s];a\n0;-1,0D-3\n1;2,5D+04\n2;0,5\n";
    assert_eq!(samples(text, "a"), expected);
    let text = "t [s],a\r0,-1e-3\r1,2.5e4\r2,0.5\r";
    assert_eq!(samples(text, "a"), expected);
    let text = "t [s],\"housing \"\"left\"\", x\"\n0,-1e-3\n1,2.5e4\n2,0.5\n";
    assert_eq!(samples(text, "housing \"left\", x"), expected);
    let alone = Record::from_bytes(b"t [s],a\n", "a.csv").unwrap_err();
    assert!(matches!(alone.problem, Problem::Unfit(_)), "{alone}");
}

#[test]
fn names_are_unique_and_a_list_shows_them() {
    let record = Record::from_bytes(b"a,a,b\n1,2,3\n1,2,3\n1,2,3\n", "a.csv").unwrap();
    let names: Vec<_> = record.channels.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(names, ["a", "a#2", "b"]);
    // a name that is there already is not given again
    let text = b"a,a,a#2,a,a#2\n1,2,3,4,5\n1,2,3,4,5\n1,2,3,4,5\n";
    let record = Record::from_bytes(text, "a.csv").unwrap();
    let names: Vec<_> = record.channels.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(names, ["a", "a#3", "a#2", "a#4", "a#2#2"]);
    let list = self::record("timed.csv").list();
    let (_, rates) = list.column("rate").unwrap();
    assert!((rates[0] - RATE).abs() < 1e-6);
    assert_eq!(list.column("samples").unwrap().1, [LENGTH as f64; 2]);
    // as long as the analysis says
    let (_, durations) = list.column("duration").unwrap();
    assert!((durations[0] * RATE / LENGTH as f64 - 1.0).abs() < 1e-9);
    let (units, places) = list.column("unit").unwrap();
    assert_eq!(units.kind.word(places[1]), "g");
}

#[test]
fn broken_files_say_where() {
    let line = |text: &[u8]| match Record::from_bytes(text, "a.csv").unwrap_err().problem {
        Problem::Line { line, .. } => line,
        other => panic!("{other:?}"),
    };
    assert_eq!(line(b"a,b\n1,2\n3,4\n5,6\n7,x\n8,9\n"), 5);
    assert_eq!(line(b"a,b\n1,2\n3,4\n5,6\n7\n8,9\n"), 5);
    assert_eq!(line(b"a,b\n1,x\n2,x\n3,x\n"), 2);
    let text = fs::read(folder().join("text.uff")).unwrap();
    let broken =
        String::from_utf8(text)
            .unwrap()
            .replacen("3.43414306641e-01", "3.4341430x641e-01", 1);
    assert_eq!(line(broken.as_bytes()), 15);
    let byte = |file: &str, length: usize| {
        let bytes = fs::read(folder().join(file)).unwrap();
        match Record::from_bytes(&bytes[..length], file)
            .unwrap_err()
            .problem
        {
            Problem::Byte { byte, .. } | Problem::Cut { byte } => byte,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(byte("cwru.mat", 500), 500);
    assert_eq!(byte("cwru_packed.mat", 700), 700);
    assert_eq!(byte("i16.wav", 40), 40);
    assert!(byte("binary.uff", 1500) > 700);
    // a bit that was turned over
    let mut bytes = fs::read(folder().join("cwru_packed.mat")).unwrap();
    bytes[400] ^= 4;
    let problem = Record::from_bytes(&bytes, "a.mat").unwrap_err().problem;
    assert!(
        matches!(problem, Problem::Byte { byte: 128, .. }),
        "{problem:?}"
    );
    assert!(Record::open(&folder()).is_err());
    assert!(Record::open(&folder().join("none.csv")).is_err());
}

#[test]
fn other_forms_are_refused_with_a_way_out() {
    let heads: [(&[u8], &str); 7] = [
        (b"MATLAB 7.3 MAT-file, Platform: GLNXA64", "-v7"),
        (b"\x89HDF\r\n\x1a\n", "-v7"),
        (b"TDSm\x0e\0\0\0", "CSV"),
        (b"\x1f\x8b\x08\0", "gunzip"),
        (b"\xff\xfea\0", "UTF-8"),
        (b"\x93NUMPY\x01\0", "savetxt"),
        (b"PK\x03\x04", "CSV"),
    ];
    for (head, way_out) in heads {
        match Record::from_bytes(head, "a").unwrap_err().problem {
            Problem::Foreign { way, .. } => assert!(way.contains(way_out)),
            other => panic!("{other:?}"),
        }
    }
    let version4 = Record::open(&folder().join("version4.mat")).unwrap_err();
    assert!(matches!(version4.problem, Problem::Foreign { .. }));
    assert!(Record::from_bytes(b"\0\x01\x02", "a.bin").is_err());
    assert!(Record::from_bytes(b"", "a.csv").is_err());
}

/// A zlib stream of nothing but zeros, which unpacks to a thousand times its length, as a variable.
#[test]
fn little_that_unpacks_to_much_is_refused() {
    let count = 40 << 20_u32;
    let mut matrix = Vec::new();
    for word in [
        14,
        count + 48,
        6,
        8,
        6,
        0,
        5,
        8,
        count / 8,
        1,
        0x10001,
        0x78,
        9,
        count,
    ] {
        matrix.extend(u32::to_le_bytes(word));
    }
    matrix.resize(matrix.len() + count as usize, 0);
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut encoder, &matrix).unwrap();
    let packed = encoder.finish().unwrap();
    let mut bytes = fs::read(folder().join("cwru_packed.mat")).unwrap();
    bytes.truncate(128);
    bytes.extend(15_u32.to_le_bytes());
    bytes.extend((packed.len() as u32).to_le_bytes());
    bytes.extend(&packed);
    drop(matrix);
    let (read, most) = read_measured(&bytes, "bomb.mat");
    assert!(matches!(
        read.unwrap_err().problem,
        Problem::Byte { byte: 128, .. }
    ));
    assert!(most < 1 << 20, "{most}");
}

/// The same numbers every time: xorshift by Marsaglia.
struct Chance(u64);

impl Chance {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count.max(1) as u64) as usize
    }
}

/// Bytes that are changed in a few places.
fn mutant(bytes: &[u8], seed: u64) -> Vec<u8> {
    let mut chance = Chance(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut bytes = bytes.to_vec();
    for _ in 0..=chance.below(4) {
        let at = chance.below(bytes.len());
        let end = bytes.len().min(at + chance.below(64));
        match chance.below(6) {
            0 => bytes[at] = chance.below(256) as u8,
            1 => bytes[at] ^= 1 << chance.below(8),
            2 => bytes.truncate(at),
            3 => drop(bytes.drain(at..end)),
            4 => {
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
            _ => {
                let counts = [0, 1, 14, 15, 0x7fff_ffff, 0x8000_0000, u32::MAX, 1 << 20];
                let at = at & !3;
                let count = counts[chance.below(counts.len())].to_le_bytes();
                bytes
                    .iter_mut()
                    .skip(at)
                    .zip(count)
                    .for_each(|(to, from)| *to = from);
            }
        }
        if bytes.is_empty() {
            bytes.push(0);
        }
    }
    bytes
}

/// `JEFFCOTT_MUTANTS=20000 cargo test --lib record` changes each file so often.
#[test]
fn changed_files_are_taken_or_refused_in_little_memory() {
    let asked = std::env::var("JEFFCOTT_MUTANTS").ok();
    let count = asked.map_or(200, |text| text.parse().unwrap());
    for (name, bytes) in all() {
        for seed in 1..=count {
            let bytes = mutant(&bytes, seed);
            let (_, most) = read_measured(&bytes, &name);
            assert!(
                most < (1 << 19) + 64 * bytes.len(),
                "{name}, mutant {seed}: {most} bytes"
            );
        }
    }
}

#[cfg(feature = "parquet")]
#[test]
fn a_trace_as_parquet_is_read_back() {
    use crate::report::{Origin, ParquetTable};
    use crate::table::Column;
    let columns = [
        Column::number("t", "s"),
        Column::number("x_velocity", "m/s"),
        Column::count("balls_loaded"),
    ];
    let scenario = "{}".to_owned();
    let mut table = ParquetTable::new(Vec::new(), &columns, &Origin { scenario }).unwrap();
    for index in 0..LENGTH {
        let time = index as f64 / RATE;
        table.row(&[time, whole(0, index) / 32_768.0, 7.0]).unwrap();
    }
    let bytes = table.finish().unwrap();
    let record = Record::from_bytes(&bytes, "trace.parquet").unwrap();
    assert_samples(&record, "x_velocity_m_s", 0, 0.0);
    let channel = record.channel("x_velocity_m_s").unwrap();
    assert_even(channel, RATE);
    assert_eq!(channel.quantity.as_deref(), Some("x_velocity"));
    assert_eq!(
        record.channel("balls_loaded").unwrap().samples,
        [7.0; LENGTH]
    );
    for seed in 1..=400 {
        let bytes = mutant(&bytes, seed);
        // the library that reads it may say on the terminal that it panics
        let _ = Record::from_bytes(&bytes, "trace.parquet");
    }
}
