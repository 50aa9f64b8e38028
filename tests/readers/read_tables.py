"""Reads the tables of a run folder by pandas, and compares both formats number by number.

Not part of `cargo test`. Needs numpy, pandas and pyarrow:

    cargo run --release --features parquet -- run scenarios/varying-compliance-6306.toml --format csv,parquet
    python3 tests/readers/read_tables.py output/varying-compliance-6306
"""

import json
import pathlib
import sys

import numpy
import pandas
import pyarrow.parquet

folder = pathlib.Path(sys.argv[1])
summary = json.loads((folder / "summary.json").read_text())
tables = sorted(folder.glob("*.parquet"))
assert tables, f"no tables in {folder}"
for path in tables:
    # cells as they are written: Python's own conversion is exact
    csv = pandas.read_csv(path.with_suffix(".csv"), dtype=str, keep_default_na=False)
    parquet = pandas.read_parquet(path)
    metadata = pyarrow.parquet.read_metadata(path)
    texts = {key.decode(): value.decode() for key, value in metadata.metadata.items()}
    assert texts["jeffcott_version"] == summary["jeffcott"], path
    assert json.loads(texts["scenario_json"]) == summary["scenario"], path
    assert list(csv.columns) == list(parquet.columns), path
    for name in csv.columns:
        if not pandas.api.types.is_numeric_dtype(parquet[name]):
            assert list(csv[name]) == list(parquet[name]), (path, name)
            continue
        written = numpy.array([float(cell or "nan") for cell in csv[name]])
        read = parquet[name].to_numpy(dtype=float, na_value=numpy.nan)
        assert written.tobytes() == read.tobytes(), (path, name)
    print(f"{path.stem}: {len(csv)} rows, {len(csv.columns)} columns, "
          f"{metadata.num_row_groups} row groups: both formats hold the same numbers")
