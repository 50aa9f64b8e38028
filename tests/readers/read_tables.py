"""Reads the tables of a run folder by pandas and scipy, and compares all formats number by number.

Not part of `cargo test`. Needs numpy, pandas, pyarrow and scipy:

    cargo run --release --features parquet -- run scenarios/varying-compliance-6306.toml \
        --format csv,parquet,mat
    python3 tests/readers/read_tables.py output/varying-compliance-6306
"""

import json
import pathlib
import sys

import numpy
import pandas
import pyarrow.parquet
import scipy.io

folder = pathlib.Path(sys.argv[1])
summary = json.loads((folder / "summary.json").read_text())
tables = [path for path in sorted(folder.glob("*.csv")) if path.with_suffix(".mat").exists()]
assert tables, f"no tables in {folder}"
for path in tables:
    # cells as they are written: Python's own conversion is exact
    csv = pandas.read_csv(path, dtype=str, keep_default_na=False)
    mat = scipy.io.loadmat(path.with_suffix(".mat"))
    parquet_path = path.with_suffix(".parquet")
    parquet = pandas.read_parquet(parquet_path)
    metadata = pyarrow.parquet.read_metadata(parquet_path)
    texts = {key.decode(): value.decode() for key, value in metadata.metadata.items()}
    for version, scenario in [
        (texts["jeffcott_version"], texts["scenario_json"]),
        (mat["jeffcott_version"][0], mat["scenario_json"][0]),
    ]:
        assert version == summary["jeffcott"], path
        assert json.loads(scenario) == summary["scenario"], path
    variables = [name for name in mat if not name.startswith("__")]
    columns = [name for name in variables if name in csv.columns]
    assert columns == list(csv.columns) == list(parquet.columns), path
    for name in csv.columns:
        column = mat[name].reshape(-1)
        assert mat[name].shape == (len(csv), 1), (path, name, mat[name].shape)
        if name + "_names" in mat:
            words = [word.rstrip() for word in mat[name + "_names"]]
            column = [words[int(index) - 1] for index in column]
            assert column == list(csv[name]) == list(parquet[name]), (path, name)
            continue
        written = numpy.array([float(cell or "nan") for cell in csv[name]])
        same = parquet[name].to_numpy(dtype=float, na_value=numpy.nan)
        for read in [column, same]:
            assert written.tobytes() == read.tobytes(), (path, name)
    print(f"{path.stem}: {len(csv)} rows, {len(csv.columns)} columns, "
          f"{metadata.num_row_groups} row groups: all formats hold the same numbers")
