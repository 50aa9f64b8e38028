//! Bytes a second of the tables of a run: a trace of 100 000 samples into files.

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
#[cfg(feature = "parquet")]
use jeffcott::internals::Origin;
use jeffcott::internals::{CsvTable, trace_columns};

/// Samples of the trace.
const ROWS: usize = 100_000;

/// Numbers with all their digits, as a run gives them.
fn rows() -> Vec<[f64; 20]> {
    let row = |n: usize| {
        let t = n as f64 / 48_000.0;
        std::array::from_fn(|column| match column {
            0 => t,
            19 => (n % 13) as f64,
            _ => 1e-6 * (500.0 * t + column as f64).sin() * (1.0 + column as f64).powi(4),
        })
    };
    (0..ROWS).map(row).collect()
}

fn buffered(path: &Path) -> BufWriter<File> {
    BufWriter::with_capacity(1 << 16, File::create(path).expect("a file"))
}

fn write_csv(path: &Path, rows: &[[f64; 20]]) {
    let mut table = CsvTable::new(buffered(path), &trace_columns()).expect("a header");
    for row in rows {
        table.row(row).expect("a row");
    }
    table.finish().expect("the rest");
}

/// As the library `csv` writes it, to compare with.
fn write_csv_serialized(path: &Path, rows: &[[f64; 20]]) {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(buffered(path));
    let columns = trace_columns();
    let names = columns.iter().map(|column| column.name());
    writer.write_record(names).expect("a header");
    for row in rows {
        writer.serialize(row).expect("a row");
    }
    writer.flush().expect("the rest");
}

#[cfg(feature = "parquet")]
fn write_parquet(path: &Path, rows: &[[f64; 20]]) {
    let table = jeffcott::internals::ParquetTable::new(buffered(path), &trace_columns(), &origin());
    let mut table = table.expect("a table");
    for row in rows {
        table.row(row).expect("a row");
    }
    table.finish().expect("the rest");
}

#[cfg(feature = "parquet")]
fn origin() -> Origin {
    Origin {
        scenario: "{}".to_owned(),
    }
}

/// Writes rows to a file.
type WriteTable = fn(&Path, &[[f64; 20]]);

fn tables(criterion: &mut Criterion) {
    let (rows, folder) = (rows(), tempfile::tempdir().expect("a folder"));
    let mut group = criterion.benchmark_group("trace of 100 000 samples");
    let formats: &[(&str, WriteTable)] = &[
        ("csv", write_csv),
        ("csv by the library", write_csv_serialized),
        #[cfg(feature = "parquet")]
        ("parquet", write_parquet),
    ];
    for (name, write) in formats {
        let path = folder.path().join(name);
        write(&path, &rows);
        let bytes = std::fs::metadata(&path).expect("a file").len();
        group.throughput(Throughput::Bytes(bytes));
        group.bench_function(*name, |bencher| bencher.iter(|| write(&path, &rows)));
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = tables
}
criterion_main!(benches);
