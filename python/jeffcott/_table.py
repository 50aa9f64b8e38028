"""Tables of results."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow

Array = np.ndarray[Any, Any]

SHOWN = 10
"""Rows that a notebook shows."""


def nearest(name: str, known: Sequence[str]) -> str:
    """Words on what a name could have been."""
    import difflib

    near = difflib.get_close_matches(name, known, 1)
    return f"did you mean {near[0]!r}?" if near else f"there are {', '.join(known)}"


def _read_only(values: Any) -> Array:
    """A column that cannot be changed; without rows one of words, which numpy cannot tell."""
    array: Array = np.asarray(values) if len(values) else np.asarray(values, dtype=getattr(values, "dtype", str))
    view = array.view()
    view.flags.writeable = False
    return view


def _same(first: Array, second: Array) -> bool:
    """Whether two columns are equal, NaN where NaN is."""
    return np.array_equal(first, second, equal_nan=first.dtype.kind == second.dtype.kind == "f")


class Table(Mapping[str, Array]):
    """Columns by their names, in the order of the file: numpy arrays of one length.

    Numbers are float64 (NaN where there is none), whole numbers int64, words text. The name of a column ends with its SI
    unit, as `x_velocity_m_s`. Columns are read only: `table["x_m"].copy()` can be changed. Tables are equal that have the
    same columns in the same order. A table is a mapping, and an Arrow stream (`__arrow_c_stream__`), which `polars.DataFrame`,
    `pyarrow.table` and others take; pandas takes `to_pandas()`, or `dict(table)`.
    """

    def __init__(self, name: str, columns: Sequence[tuple[str, Any]]) -> None:
        self.name = name
        self._columns = {column: _read_only(values) for column, values in columns}

    def __getitem__(self, column: str) -> Array:
        try:
            return self._columns[column]
        except KeyError:
            hint = nearest(column, list(self._columns))
            raise KeyError(f"the table {self.name!r} has no column {column!r}; {hint}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Table):
            return NotImplemented
        return list(self) == list(other) and all(_same(self[column], other[column]) for column in self)

    @property
    def rows(self) -> int:
        """Number of rows."""
        return next((len(values) for values in self._columns.values()), 0)

    def to_pandas(self) -> pandas.DataFrame:
        """As a pandas DataFrame."""
        import pandas

        return pandas.DataFrame(self._columns)

    def to_polars(self) -> polars.DataFrame:
        """As a polars DataFrame; what is missing is null."""
        import polars

        return polars.DataFrame(self).fill_nan(None)

    def to_arrow(self) -> pyarrow.Table:
        """As a pyarrow Table; what is missing is null."""
        import pyarrow

        return pyarrow.table(self)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The capsule of the Arrow PyCapsule interface."""
        from ._jeffcott import arrow_stream

        columns = [v if v.dtype.kind in "fi" else v.tolist() for v in self._columns.values()]
        return arrow_stream(list(self._columns), columns)

    def __repr__(self) -> str:
        return f"<Table {self.name!r}: {self.rows} rows of {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        from html import escape

        def cell(value: Any) -> str:
            return f"{value:.6g}" if isinstance(value, float) else escape(str(value))

        head = "".join(f"<th>{escape(name)}</th>" for name in self._columns)
        shown = zip(*(values[:SHOWN].tolist() for values in self._columns.values()))
        rows = "".join("<tr>" + "".join(f"<td>{cell(value)}</td>" for value in row) + "</tr>" for row in shown)
        more = f"<p>{self.rows} rows</p>" if self.rows > SHOWN else ""
        return f"<table><tr>{head}</tr>{rows}</table>{more}"
