//! Records of sensors: the lines of known signals, by the code that runs are analysed by.

use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::ask::record_setting;
use crate::measurement::{Measured, Slip};
use crate::record::Record;
use crate::rotor::load::SplitMix64;
use crate::scenario::{ScenarioError, describe_record};

/// The bearing of the drive end of the Case Western Reserve rig: multiples of the shaft are published.
const CWRU_6205: &str = "9, 0.3126 in, 1.537 in";
/// A sensor beside it at 12 kHz.
const BESIDE_CWRU_6205: [(&str, &str); 4] = [
    ("rate", "12 kHz"),
    ("unit", "m/s^2"),
    ("speed", "1800 rpm"),
    ("bearing", CWRU_6205),
];

fn settings(options: &[(&str, &str)]) -> Vec<String> {
    let setting = |(name, value): &(&str, &str)| record_setting(name, &[(*value).to_owned()]);
    options.iter().filter_map(setting).collect()
}

fn described(record: Record, options: &[(&str, &str)]) -> Result<Measured, ScenarioError> {
    let file = describe_record(record, "made.csv", "{}", &settings(options))?;
    Ok(file.measurement.analyse())
}

fn analysed(record: Record, options: &[(&str, &str)]) -> Measured {
    described(record, options).unwrap_or_else(|error| panic!("{error}"))
}

fn columns(columns: Vec<(&str, Vec<f64>)>) -> Record {
    let named = columns
        .into_iter()
        .map(|(name, values)| (name.to_owned(), values));
    Record::from_columns(named, "made").unwrap()
}

/// What rings at 3 kHz whenever the shaft has turned by a part of a revolution, at a speed in Hz that rises by some Hz a second,
/// in noise.
fn ringing(rate: f64, count: u32, [speed, rise]: [f64; 2], order: f64) -> Vec<f64> {
    let noise = SplitMix64::new(7);
    let turns = |time: f64| time * (speed + 0.5 * rise * time);
    let mut struck = (0.0, 0.0);
    let at = |index: u32| {
        let time = f64::from(index) / rate;
        let strikes = (turns(time) * order).floor();
        if strikes > struck.0 {
            // when it was struck, by the speed now
            let late = (turns(time) * order - strikes) / (order * (speed + rise * time));
            struck = (strikes, time - late);
        }
        let since = time - struck.1;
        let ring = 8.0 * (-600.0 * since).exp() * (TAU * 3000.0 * since).sin();
        ring + noise.uniform(u64::from(index)) - 0.5 + 0.3 * (TAU * turns(time)).cos()
    };
    (0..count).map(at).collect()
}

/// Numbers of the data sets' own papers; each within half a unit of its last digit, and where those were made from dimensions with more
/// digits than are printed, also within what half a unit of the last digit of those makes.
#[test]
fn lines_are_at_the_published_multiples_of_the_shaft() {
    // balls, ball diameter, pitch diameter, angle; half units of the dimensions' last digits as parts; Hz; outer, inner, cage, spin
    let cases = [
        (
            CWRU_6205,
            0.0,
            1.0,
            ["3.584776", "5.415224", "0.398308", "2.356722"],
        ),
        (
            "8, 0.2656 in, 1.122 in",
            0.0,
            1.0,
            ["3.05312", "4.94688", "0.381640", ""],
        ),
        (
            "9, 7.9375 mm, 38.50 mm",
            0.0,
            1.0,
            ["3.572", "5.428", "0.3969", "2.32"],
        ),
        (
            "8, 0.235 in, 1.245 in",
            0.0005 / 0.235 + 0.0005 / 1.245,
            25.0,
            ["81.13", "118.87", "10.14", "63.86"],
        ),
        (
            // 296.90 Hz by these dimensions, of which 8.4 mm is 0.331 in
            "16, 8.4 mm, 71.5 mm, 15.17 deg",
            0.05 / 8.4 + 0.05 / 71.5,
            100.0 / 3.0,
            ["236.4", "297.0", "", ""],
        ),
    ];
    for (bearing, rounding, shaft, expected) in cases {
        let record = columns(vec![("a", vec![0.0; 64])]);
        let speed = format!("{} rpm", 60.0 * shaft);
        let options = [("rate", "1 kHz"), ("speed", &speed), ("bearing", bearing)];
        let found = analysed(record, &options).nominal[0];
        // lines of a race and the cage are Z f (1 ± x)/2 and f (1 − x)/2 with x = d cos α/D; that of a ball is f (1/x − x)/2
        let x = 1.0 - 2.0 * found.cage / shaft;
        let moved = [found.outer, found.inner, found.cage].map(|line| {
            let factor = line / (1.0 + if line == found.inner { x } else { -x });
            factor * x * rounding
        });
        let spin_moved = 0.5 * shaft * (1.0 / x + x) * rounding;
        let moved = [moved[0], moved[1], moved[2], spin_moved];
        let found = [found.outer, found.inner, found.cage, found.spin];
        for ((found, printed), moved) in found.into_iter().zip(expected).zip(moved) {
            let Ok(expected) = printed.parse::<f64>() else {
                continue;
            };
            let decimals = printed.split('.').nth(1).map_or(0, str::len);
            let allowed = 0.5000001 * 10f64.powi(-(decimals as i32)) + moved;
            assert!(
                (found - expected).abs() <= allowed,
                "{bearing}: {found} {printed} ± {allowed}"
            );
        }
    }
}

/// The strongest line of the envelope bears the name of the race, and the slip is found to the resolution.
#[test]
fn the_slip_of_a_cage_is_measured() {
    for (order, slip, name) in [
        (3.584_776 * 0.99, 0.01, "BPFO"),
        // Z (f − f_c) with a cage at 0.98 of 0.398308
        (9.0 * (1.0 - 0.98 * 0.398_308), 0.02, "BPFI"),
        (3.584_776, 0.0, "BPFO"),
        (2.0 * 2.356_722 * 0.992, 0.008, "2×BSF"),
    ] {
        let signal = ringing(12_000.0, 60_000, [30.0, 0.0], order);
        let found = analysed(columns(vec![("a", signal)]), &BESIDE_CWRU_6205);
        let Some(Slip {
            cage_slip,
            uncertainty,
            ..
        }) = &found.slips[0]
        else {
            panic!("no slip of {name}");
        };
        assert!(
            (cage_slip - slip).abs() <= *uncertainty,
            "{name}: {cage_slip} ± {uncertainty}"
        );
        assert!(*uncertainty < 1e-3, "{uncertainty}");
        let line = &found.spectra[0].lines[0];
        assert_eq!(line.line.kind.to_string(), name);
        assert!((line.place - 30.0 * order).abs() < 0.1, "{}", line.place);
    }
}

/// Warnings, first time, rate and RMS of the first channel of a table.
fn of_table(table: &str, options: &[(&str, &str)]) -> (Vec<String>, [f64; 3]) {
    let record = Record::from_bytes(table.as_bytes(), "made.csv").unwrap();
    let file = describe_record(record, "made.csv", "{}", &settings(options));
    let file = file.unwrap_or_else(|error| panic!("{error}"));
    let (start, rate) = (file.measurement.start, file.measurement.rate);
    let rms = file.measurement.analyse().statistics[0].moments.rms();
    (file.about.warnings, [start, rate, rms])
}

/// A table at 1 kHz of a tone of an RMS of one, and a channel that lacks some samples.
fn table(rows: impl Iterator<Item = u32>, lacks: impl Fn(u32) -> bool) -> String {
    let row = |n: u32| {
        let tone = 2f64.sqrt() * (TAU * 0.05 * f64::from(n)).sin();
        let other = if lacks(n) { f64::NAN } else { tone };
        format!("{},{other},{tone}\n", f64::from(n) * 1e-3)
    };
    let rows: String = rows.map(row).collect();
    format!("time [s],b [g],a [g]\n{rows}")
}

/// The rate is that between the gaps; a part beside them has none, and of a long one nothing is made.
#[test]
fn a_gap_in_the_times_is_no_other_rate() {
    let gap = table((0..1000).chain(1040..3000), |_| false);
    let (warnings, [_, rate, _]) = of_table(&gap, &[]);
    assert!((rate - 1000.0).abs() < 1e-6, "{rate}");
    assert!(warnings[0].contains("from 0.999 to 1.04 s"), "{warnings:?}");
    for part in [("start", "1.04 s"), ("duration", "0.9 s")] {
        let (warnings, [_, _, rms]) = of_table(&gap, &[part]);
        assert_eq!(warnings, [""; 0]);
        assert!((rms / 9.80665 - 1.0).abs() < 1e-6, "{rms}");
    }
    let (warnings, _) = of_table(&gap, &[("rate", "1 kHz")]);
    assert!(warnings[0].contains("lacks 40 samples"), "{warnings:?}");
    let long = table((0..1000).chain(900_000_000..900_001_000), |_| false);
    let record = Record::from_bytes(long.as_bytes(), "made.csv").unwrap();
    let error = described(record, &[]).unwrap_err().to_string();
    assert!(error.contains("--start \"900000 s\""), "{error}");
    let (_, [start, ..]) = of_table(&long, &[("start", "900000 s")]);
    assert!((start - 900_000.0).abs() < 1e-6, "{start}");
}

/// Rows that are left out and values that are missing count alike: up to a tenth of them is bridged.
#[test]
fn up_to_a_tenth_of_the_samples_is_bridged() {
    let noise = SplitMix64::new(5);
    let is_lost =
        |part: f64| move |n: u32| (1..2999).contains(&n) && noise.uniform(n.into()) < part;
    for part in [0.02, 0.07] {
        let tables = [
            table((0..3000).filter(|n| !is_lost(part)(*n)), |_| false),
            table(0..3000, is_lost(part)),
        ];
        for table in tables {
            let (warnings, [_, rate, rms]) = of_table(&table, &[("channel", "b")]);
            assert!((rate - 1000.0).abs() < 1e-6, "{rate}");
            // a line at f loses p (1 - cos 2πf/rate) of its amplitude, where single samples are missing
            let lost = part * (1.0 - (TAU * 0.05).cos());
            let found = rms / 9.80665;
            assert!(
                (found + lost - 1.0).abs() < 0.02 * lost + 5e-4,
                "{found} {lost}"
            );
            assert_eq!(warnings.len(), 1, "{warnings:?}");
        }
    }
    for part in [0.13, 0.5, 0.8] {
        let rows = table((0..3000).filter(|n| !is_lost(part)(*n)), |_| false);
        for table in [rows, table(0..3000, is_lost(part))] {
            let record = Record::from_bytes(table.as_bytes(), "made.csv").unwrap();
            assert!(described(record, &[("channel", "b")]).is_err(), "{part}");
        }
    }
    // a speed that was written less often is on lines between
    let speed = table(0..3000, |n| n % 10 != 0)
        .replace("b [g]", "b [rpm]")
        .replace(",-", ",");
    let (_, [_, rate, rms]) = of_table(&speed, &[("channel", "a"), ("speed", "b")]);
    assert!((rate - 1000.0).abs() < 1e-6 && rms > 1.0, "{rate} {rms}");
}

/// At a rate that is given, a column that rises by its step is the time, whatever its name and part of a second.
#[test]
fn times_without_a_unit_are_no_channel() {
    for (factor, offset) in [(1.0, 0.0), (1e3, 5.0)] {
        let row = |n: u32| {
            let at = offset + factor * f64::from(n) / 2000.0;
            format!("{at},{},{}\n", 0.1 * f64::from(n % 7), 3 * n)
        };
        let rows: String = (0..200).map(row).collect();
        let record = Record::from_bytes(format!("t,a,count\n{rows}").as_bytes(), "made.csv");
        let found = analysed(record.unwrap(), &[("rate", "2 kHz"), ("unit", "g")]);
        let names = found.statistics.iter().map(|one| one.channel.name());
        assert!(names.eq(["a", "count"]), "{:?}", found.statistics);
    }
}

#[test]
fn a_part_that_the_record_does_not_hold_is_told() {
    let (of_3_s, part) = (
        table(0..3000, |_| false),
        [("start", "1 s"), ("duration", "5 s")],
    );
    let (warnings, [start, ..]) = of_table(&of_3_s, &part);
    assert!(
        warnings.len() == 1 && warnings[0].contains("2 s are analysed"),
        "{warnings:?}"
    );
    assert!((start - 1.0).abs() < 1e-9);
    assert_eq!(of_table(&of_3_s, &[("start", "-1 s")]).0.len(), 1);
    let part = [("start", "1 s"), ("duration", "2 s")];
    assert_eq!(of_table(&of_3_s, &part).0, [""; 0]);
}

#[test]
fn a_unit_that_is_not_understood_is_told() {
    let rms = table(0..100, |_| false).replace("b [g]", "b [mm/s rms]");
    let (warnings, _) = of_table(&rms, &[]);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].contains("`mm/s rms`") && warnings[0].contains("--unit"));
    let unit = [("unit", "mm/s"), ("channel", "b [mm/s rms]")];
    assert_eq!(of_table(&rms, &unit).0, [""; 0]);
}

#[test]
fn where_samples_are_missing_at_the_ends_nothing_is_analysed() {
    let lacking = table(0..1000, |n| !(200..900).contains(&n));
    let of_b = [("channel", "b")];
    let (warnings, [start, _, rms]) = of_table(&lacking, &of_b);
    assert!((rms / 9.80665 - 1.0).abs() < 1e-6 && (start - 0.2).abs() < 1e-9);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].contains("the first 200 samples of `b` are missing"));
    let part = [("start", "0.3 s"), ("duration", "0.5 s"), of_b[0]];
    assert_eq!(of_table(&lacking, &part).0, [""; 0]);
    // nor beside a channel of speed that is not known there
    let speed = lacking.replace("b [g]", "b [rpm]").replace(",-", ",");
    let options = [("channel", "a"), ("speed", "b")];
    let (warnings, [start, ..]) = of_table(&speed, &options);
    assert!((start - 0.199).abs() < 1e-9, "{start} {warnings:?}");
    assert!(warnings[1].contains("up to 0.901 s"), "{warnings:?}");
}

/// A tone has a steady envelope: what round-off leaves of it has no lines.
#[test]
fn round_off_is_no_line() {
    let tone = (0..4000)
        .map(|n| (TAU * 0.1 * f64::from(n)).sin())
        .collect();
    let options = [
        ("rate", "2 kHz"),
        ("speed", "1800 rpm"),
        ("bearing", CWRU_6205),
    ];
    let found = analysed(columns(vec![("a", tone)]), &options);
    assert!(found.spectra[0].lines.is_empty() && found.unnamed_lines.is_empty());
}

/// Of a column that rests at 500; a tone of 1e-6 about it is more than round-off.
#[test]
fn a_constant_column_has_no_lines() {
    let tone = |n: i32| (TAU * 0.1 * f64::from(n)).sin();
    for (unit, amplitude, lines) in [("m/s^2", 0.0, 0), ("1", 0.0, 0), ("1", 1e-6, 1)] {
        let values = (0..4000).map(|n| 500.0 + amplitude * tone(n)).collect();
        let options = [("unit", unit), BESIDE_CWRU_6205[0], BESIDE_CWRU_6205[2]];
        let found = analysed(columns(vec![("a", values)]), &options);
        let strong = found.peaks.iter().filter(|peak| peak.amplitude > 1e-7);
        assert_eq!(
            (found.peaks.len(), strong.count()),
            (lines, lines),
            "{unit}"
        );
        assert!(found.spectra[0].lines.is_empty(), "{unit}");
    }
}

#[test]
fn a_strong_line_that_nothing_causes_is_told() {
    let signal = ringing(12_000.0, 60_000, [30.0, 0.0], 4.23);
    let found = analysed(columns(vec![("a", signal)]), &BESIDE_CWRU_6205);
    assert_eq!(found.slips, [None]);
    let [line] = &found.unnamed_lines[..] else {
        panic!("{:?}", found.unnamed_lines);
    };
    assert!((line.place - 30.0 * 4.23).abs() < 0.2, "{line:?}");
    assert!(line.above_noise > 20.0, "{line:?}");
}

#[test]
fn a_speed_that_nobody_gave_is_estimated_as_such() {
    let signal = ringing(12_000.0, 60_000, [30.0, 0.0], 3.584_776);
    let options = [("rate", "12 kHz"), ("unit", "g"), ("bearing", CWRU_6205)];
    let found = analysed(columns(vec![("a", signal)]), &options);
    assert!(found.speed.is_none() && found.spectra[0].lines.is_empty());
    let likeliest = &found.speed_estimates[0];
    let error = likeliest.shaft_frequency / 30.0 - 1.0;
    assert!(error.abs() < 2e-3, "{likeliest:?}");
}

/// The envelope of a quiet channel comes first.
#[test]
fn a_speed_is_estimated_by_every_channel_of_an_envelope() {
    let signal = ringing(12_000.0, 60_000, [30.0, 0.0], 3.584_776);
    let noise = SplitMix64::new(3);
    let quiet = (0..60_000).map(|n| noise.uniform(n) - 0.5).collect();
    let description = r#"{ "spectrum": [ { "channels": ["quiet", "a"], "kind": "envelope", "band": ["2 kHz", "4 kHz"] } ] }"#;
    let options = settings(&[("rate", "12 kHz"), ("unit", "g"), ("bearing", CWRU_6205)]);
    let record = columns(vec![("quiet", quiet), ("a", signal)]);
    let file = describe_record(record, "made.csv", description, &options).expect("a description");
    let found = file.measurement.analyse();
    let likeliest = &found.speed_estimates[0];
    let error = likeliest.shaft_frequency / 30.0 - 1.0;
    assert!(error.abs() < 2e-3, "{likeliest:?}");
}

/// Under a speed that rises by two thirds, the order of the line is found over the angle of a tacho.
#[test]
fn a_tacho_brings_a_run_up_to_orders() {
    let (rate, count) = (20_000.0, 100_000);
    let signal = ringing(rate, count, [15.0, 2.0], 3.584_776);
    let turns = |time: f64| time * (15.0 + time);
    let tacho = (0..count).map(|n| {
        let part = turns(f64::from(n) / rate).fract();
        if part < 0.3 { 1.0 } else { 0.0 }
    });
    let record = columns(vec![("a", signal), ("tacho", tacho.collect())]);
    let options = [
        ("rate", "20 kHz"),
        ("unit", "m/s^2"),
        ("channel", "a"),
        ("tacho", "tacho"),
        ("bearing", CWRU_6205),
    ];
    let found = analysed(record, &options);
    let [_, lowest, highest] = found.speed.unwrap().map(|speed| speed / TAU);
    assert!(
        (lowest - 15.0).abs() < 0.3 && (highest - 25.0).abs() < 0.3,
        "{lowest} {highest}"
    );
    let line = &found.spectra[0].lines[0];
    assert_eq!(line.line.kind.to_string(), "BPFO");
    assert!((line.place - 3.584_776).abs() < 0.01, "{}", line.place);
    let smear = found
        .warnings
        .iter()
        .filter(|it| it.contains("spectrum_orders.csv"));
    assert_eq!(smear.count(), 1, "{:?}", found.warnings);
    assert!(
        found
            .maps
            .is_some_and(|maps| !maps.tracks.points.is_empty())
    );
}

/// Channels 0 and 1 of the made files, in every form and precision.
#[test]
fn every_form_gives_the_same_lines() {
    let files = [
        ("xjtu.csv", "1", 0.0),
        ("ims", "1", 1e-14),
        ("femto.csv", "1", 1e-14),
        ("german.csv", "1", 2e-14),
        ("i16.wav", "1", 0.0),
        ("i24.wav", "1", 0.0),
        ("f32.wav", "1", 0.0),
        ("f64.wav", "1", 0.0),
        ("cwru.mat", "1", 0.0),
        ("cwru_packed.mat", "1", 0.0),
        ("curtin.mat", "1", 0.0),
        ("mfpt.mat", "bearing.gs", 0.0),
    ];
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/records");
    let lines = |file: &str, channel: &str| {
        let record = Record::open(&folder.join(file)).unwrap();
        let options = [("rate", "25.6 kHz"), ("channel", channel), ("unit", "um")];
        let found = analysed(record, &options).spectrum.unwrap();
        found.channels[0].amplitude.clone()
    };
    let expected = lines("xjtu.csv", "1");
    let scale = expected.iter().copied().fold(0.0, f64::max);
    for (file, channel, allowed) in files {
        for (found, expected) in lines(file, channel).iter().zip(&expected) {
            assert!(
                (found - expected).abs() <= allowed * scale,
                "{file}: {found} {expected}"
            );
        }
    }
}

/// A fast channel and a slow one of other samples, each with tones of 1 m/s² below and above half the slow rate.
#[test]
fn channels_of_different_rates_are_analysed_together() {
    let tone = |frequency: f64, rate: f64, count: u32| {
        let at = |n: u32| (TAU * frequency * f64::from(n) / rate).cos();
        (0..count).map(at).collect::<Vec<_>>()
    };
    let fast = tone(5000.0, 20_000.0, 20_000);
    let slow = tone(600.0, 2000.0, 2001);
    let record = columns(vec![("fast", fast), ("slow", slow)]);
    let description = r#"{ "record": { "unit": "m/s^2", "channel": [
        { "column": "fast", "rate": "20 kHz" }, { "column": "slow", "rate": "2 kHz" } ] } }"#;
    let file = describe_record(record, "made.csv", description, &[]).unwrap();
    assert_eq!(file.about.warnings.len(), 1);
    let found = file.measurement.analyse();
    assert_eq!(found.rate, 20_000.0);
    let spectrum = found.spectrum.unwrap();
    let amplitude = |channel: usize, frequency: f64| {
        let bin = (frequency / spectrum.resolution).round() as usize;
        let values = &spectrum.channels[channel].amplitude;
        values[bin - 2..=bin + 2]
            .iter()
            .copied()
            .fold(0.0, f64::max)
    };
    for (channel, frequency) in [(0, 5000.0), (1, 600.0)] {
        let found = amplitude(channel, frequency);
        assert!((found - 1.0).abs() < 2e-3, "{found}");
    }
    // mirrored at the slow rate
    for mirrored in [1400.0, 2600.0, 5000.0] {
        assert!(amplitude(1, mirrored) < 1e-3, "{mirrored}");
    }
}

/// What rings in the first third of a record of two million samples alone is in the mean over all of it.
#[test]
fn envelopes_rest_on_the_whole_record() {
    let rate = 48_000.0;
    let mut signal = ringing(rate, 700_000, [30.0, 0.0], 3.584_776);
    let noise = SplitMix64::new(3);
    signal.extend((0..1_400_000).map(|n| noise.uniform(n) - 0.5));
    let options = [
        ("rate", "48 kHz"),
        ("unit", "m/s^2"),
        ("speed", "1800 rpm"),
        ("bearing", CWRU_6205),
    ];
    let found = analysed(columns(vec![("a", signal)]), &options);
    let spectrum = &found.spectra[0];
    // as many whole segments as there are
    let left = 2_100_000 - spectrum.samples;
    assert!(left < spectrum.segment - spectrum.overlap, "{left}");
    assert!(spectrum.averages > 1, "{}", spectrum.averages);
    assert_eq!(spectrum.lines[0].line.kind.to_string(), "BPFO");
}

#[test]
fn times_that_do_not_rise_are_told_with_their_row() {
    let text = "t [s],a [g]\n0,1\n1,2\n3,1\n2,1\n4,0\n";
    let record = || Record::from_bytes(text.as_bytes(), "made.csv").unwrap();
    let error = described(record(), &[]).expect_err("the times do not rise");
    let told = error.render(false);
    assert!(told.contains("do not rise at row 4"), "{told}");
    assert!(record().warnings[0].contains("row 4"));
}

#[test]
fn what_is_missing_is_asked_for() {
    let signal = || {
        columns(vec![
            ("acc x", vec![0.5; 200]),
            ("speed", vec![1500.0; 200]),
        ])
    };
    let refused = |options: &[(&str, &str)]| {
        let error = described(signal(), options).expect_err("it is wrong");
        error.render(false)
    };
    for (options, words) in [
        (&[][..], "how many samples a second"),
        (
            &[("rate", "1 kHz"), ("channel", "acc y")],
            "did you mean `acc x`",
        ),
        (&[("rate", "1 kHz"), ("channel", "7")], "no channel `7`"),
        (
            &[("rate", "1 kHz"), ("speed", "speed")],
            "no unit of `speed`",
        ),
        (&[("rate", "1 kHz"), ("tacho", "speed")], "0 pulses"),
        (
            &[("rate", "1 kHz"), ("start", "3 s")],
            "the record ends at 0.2 s",
        ),
        (
            &[("rate", "1 kHz"), ("bearing", "62O5")],
            "the catalogue has no bearing",
        ),
        (&[("rate", "1000")], "needs a unit"),
        (
            &[("rate", "1 kHz"), ("duration", "0.001 ms")],
            "record.duration",
        ),
        (&[("rate", "1 kHz"), ("duration", "15 ms")], "15 samples"),
        (&[("rate", "1 kHz"), ("scale", "0")], "record.scale"),
        (&[("rate", "1 kHz"), ("scale", "-1e31")], "record.scale"),
        (&[("rate", "1 kHz"), ("scale", "1e300")], "record.scale"),
        (&[("rate", "1 kHz"), ("scale", "1e-31")], "record.scale"),
    ] {
        let told = refused(options);
        assert!(told.contains(words), "{words}: {told}");
    }
    let shortest = analysed(signal(), &[("rate", "1 kHz"), ("duration", "16 ms")]);
    assert_eq!(shortest.recording.length(), 16);
    let inverted = analysed(signal(), &[("rate", "1 kHz"), ("scale", "-1")]);
    assert_eq!(inverted.statistics[0].moments.mean(), -0.5);
    let found = analysed(signal(), &[("rate", "1 kHz"), ("unit", "g")]);
    assert_eq!(found.statistics[0].channel.name(), "acc_x");
    assert!((found.statistics[0].moments.mean() - 0.5 * 9.806_65).abs() < 1e-12);
}

/// Three pulses within nine samples.
#[test]
fn a_tacho_whose_pulses_span_few_samples_is_refused() {
    let pulse = |n: u32| f64::from(u8::from([100, 104, 108].contains(&n)));
    let tacho = (0..200).map(pulse).collect();
    let record = columns(vec![("a", vec![0.5; 200]), ("tacho", tacho)]);
    let error = described(record, &[("rate", "1 kHz"), ("tacho", "tacho")]).expect_err("too few");
    assert!(error.render(false).contains("speed"), "{error}");
}

#[test]
fn samples_of_which_powers_overflow_are_refused() {
    let kurtosis = |largest: f64, unit: &str| {
        let samples = (0..200).map(|n| largest * f64::from(n % 2)).collect();
        let options = [("rate", "1 kHz"), ("unit", unit)];
        let found = described(columns(vec![("a", samples)]), &options);
        found.map(|found| found.statistics[0].moments.kurtosis())
    };
    let known = kurtosis(1e60, "m/s^2").expect("it is not too large");
    assert!((known.expect("it moves") - 1.0).abs() < 1e-9, "{known:?}");
    for (largest, unit) in [(1e61, "m/s^2"), (1e300, ""), (1e59, "km"), (1e308, "km")] {
        assert!(kurtosis(largest, unit).is_err(), "{largest:e} {unit}");
    }
}

/// The shaft turns as fast as a wrong unit says.
#[test]
fn a_speed_too_fast_for_its_sampling_has_no_orders() {
    let speeds = (0..4000).map(|n| 1e14 * (1.0 + 1e-3 * f64::from(n)));
    let signal = (0..4000).map(|n| f64::from(n).sin()).collect();
    let record = columns(vec![("a", signal), ("n [rad/s]", speeds.collect())]);
    let description = r#"{ "speed": { "channel": "n" } }"#;
    let options = settings(&[("rate", "10 kHz"), ("bearing", CWRU_6205)]);
    let file = describe_record(record, "made.csv", description, &options).expect("a description");
    let found = file.measurement.analyse();
    assert!(found.spectra.is_empty());
    let maps = found.maps.expect("the speed changes");
    assert!(maps.tracks.points.is_empty() && maps.tracks.tracked.is_empty());
    // two spectra and the tracks
    let told = |word: &str| found.warnings.iter().filter(|it| it.contains(word)).count();
    assert_eq!(told("unit"), 3, "{:?}", found.warnings);
}

/// The rollers of Koyo's NU206 roll as their published number and sizes say; what belongs to balls is refused.
#[test]
fn rollers_are_found_from_their_ratings() {
    let analysed = |bearing: &str| {
        let settings = [
            "record.rate=\"1 kHz\"".to_owned(),
            "record.unit=\"g\"".to_owned(),
            "speed={ constant = \"1500 rpm\" }".to_owned(),
            format!("bearing=[{{ {bearing} }}]"),
        ];
        let record = columns(vec![("acc x", vec![0.5; 200])]);
        let file = describe_record(record, "made.csv", "{}", &settings);
        file.map(|file| file.measurement.analyse())
            .map_err(|error| error.render(false))
    };
    let ratings = |width: &str| {
        format!(
            "ratings = {{ kind = \"cylindrical\", bore = \"30 mm\", outside_diameter = \"62 mm\", {width} \
             contact_angle = \"0 deg\", dynamic = \"29.3 kN\", static = \"28.7 kN\" }}"
        )
    };
    let found = analysed(&ratings("width = \"16 mm\",")).expect("13 rollers of 7.5 mm on 46 mm");
    let order = found.nominal[0].outer / 25.0;
    assert!((order - 6.5 * (1.0 - 7.5 / 46.0)).abs() < 1e-9, "{order}");
    for (bearing, told) in [
        (ratings(""), "the ratings of rollers need `width`"),
        (
            "catalogue = \"NU206\", geometry = { balls = 9 }".to_owned(),
            "this belongs to balls",
        ),
    ] {
        let error = analysed(&bearing).expect_err(told);
        assert!(error.contains(told), "{error}");
    }
}
