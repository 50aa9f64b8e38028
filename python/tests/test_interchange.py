"""Tables hand themselves to pandas, polars and Arrow."""

import numpy as np
import pytest

import jeffcott as jc


def test_pandas(steady_run: jc.Run) -> None:
    pandas = pytest.importorskip("pandas")
    frame = steady_run.trace.to_pandas()
    assert list(frame.columns) == list(steady_run.trace)
    assert frame["x_m"].to_numpy() == pytest.approx(steady_run["x_m"], abs=0)
    assert frame["balls_loaded"].dtype == np.int64
    assert isinstance(steady_run.peaks.to_pandas(), pandas.DataFrame)


def test_polars(steady_run: jc.Run) -> None:
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame(steady_run.peaks)
    assert frame.fill_nan(None).equals(steady_run.peaks.to_polars())
    assert frame["channel"].dtype == polars.String
    assert frame.height == steady_run.peaks.rows
    # what is missing is null, not NaN
    table = jc.Table("table", [("a", np.array([1.0, np.nan])), ("b", ["x", "y"]), ("c", np.array([1, 2]))])
    assert table.to_polars().rows() == [(1.0, "x", 1), (None, "y", 2)]


def test_arrow(steady_run: jc.Run) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table(steady_run.trace)
    assert table.column_names == list(steady_run.trace)
    assert str(table.schema.field("balls_loaded").type) == "int64"
    assert np.array_equal(table["x_m"].to_numpy(), steady_run["x_m"])
    assert steady_run.trace.to_arrow().equals(table)


def test_a_capsule_that_nobody_takes_is_freed(steady_run: jc.Run) -> None:
    for _ in range(100):
        steady_run.trace.__arrow_c_stream__()


def test_notebooks_show_tables(steady_run: jc.Run) -> None:
    html = steady_run.trace._repr_html_()
    assert html.count("<tr>") == 11
    assert f"{len(steady_run)} rows" in html
    assert "x_m" in repr(steady_run.trace)
