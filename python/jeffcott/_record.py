"""Records of sensors: what is in them."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import warn
from ._jeffcott import analyze as _analyze
from ._results import Result, Run, Steady
from ._scenario import dumped
from ._table import Array, Table


class Analysis(Result):
    """What was found in a record: spectra, envelopes, orders, named lines, slip, statistics."""

    @property
    def peaks(self) -> Table:
        """Peaks of the spectra with what makes them; amplitudes in the unit of their row."""
        return self.table("peaks")

    def spectrum(self, name: str | None = None) -> Table:
        """The spectrum of all channels, or one of the further ones by its name, as "envelope"."""
        return self.table("spectrum" if name is None else f"spectrum_{name}")

    @property
    def lines(self) -> list[dict[str, Any]]:
        """Named lines of the envelopes: `name`, `at` in Hz or orders, `value`, `column`."""
        return [line for spectrum in self.summary["spectra"] for line in spectrum.get("lines", [])]


def _arrays(source: Any) -> list[tuple[str, Array]]:
    """Arrays by their names: of a table or mapping its columns, of a series its values, of a matrix its columns."""
    if isinstance(source, (Run, Steady)):
        source = source.trace
    # those of pyarrow, of pandas and polars, of structured arrays
    fields = getattr(getattr(source, "dtype", None), "names", None)
    names = getattr(source, "column_names", getattr(source, "columns", fields))
    if isinstance(source, Mapping):
        named = list(source.items())
    elif names is not None:
        named = [(name, source[name]) for name in names]
    elif getattr(source, "name", None):
        named = [(source.name, source)]
    else:
        matrix = np.asarray(source)
        if matrix.ndim not in (1, 2):
            raise ValueError(f"a record has one or two dimensions, a column a channel, not {matrix.ndim}: {source!r:.60}")
        columns = matrix[:, None] if matrix.ndim == 1 else matrix
        named = [(f"channel{number}", column) for number, column in enumerate(columns.T, 1)]
    return [_channel(str(name), values) for name, values in named]


def _channel(name: str, values: Any) -> tuple[str, Array]:
    """The samples of a channel; dates and times become seconds from the first one."""
    array = np.asarray(values)
    if array.ndim == 2 and array.shape[1] == 1:
        array = array[:, 0]
    if array.ndim != 1:
        raise ValueError(f"{name}: a channel has one dimension, not the shape {array.shape}; give each column a name")
    if array.dtype.kind in "mM":
        return "time_s", (array - array[:1]) / np.timedelta64(1, "s")
    if array.dtype.kind == "c":
        raise ValueError(f"{name}: a channel has real samples; take their real and imaginary parts by themselves")
    try:
        return name, np.ascontiguousarray(array, dtype=float)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: a channel has numbers: {error}") from None


def _texts(value: Any) -> list[str]:
    """The values of an option, as the command line has them."""
    if value is None:
        return []
    if isinstance(value, str) or not isinstance(value, Sequence):
        return [str(value)]
    return [str(entry) for entry in value]


def analyze(
    source: str | os.PathLike[str] | Mapping[str, Any] | Any,
    *,
    rate: float | str | None = None,
    unit: str | None = None,
    scale: float | None = None,
    channel: str | Sequence[str] | None = None,
    speed: str | None = None,
    tacho: str | None = None,
    pulses: float | None = None,
    bearing: str | Sequence[str] | None = None,
    window: str | None = None,
    start: str | None = None,
    duration: str | None = None,
    description: Mapping[str, Any] | None = None,
) -> Analysis:
    """Finds out what is in a record: as `jeffcott analyze`, with its options as keywords.

    `source` is a file, a file .toml that describes a record, an array (of a matrix each column is a channel), or a table: a
    run, one of its tables, a mapping of names to arrays, a frame or series of pandas or polars, a table of pyarrow. The names of
    columns are read as those of a file: "a [m/s^2]" has a unit, "time [s]" and "t_s" are times, by which `rate` is known.

    `rate` as a number is in Hz; `unit` "g" is the standard gravity; `speed` is "1797 rpm" or the name of a
    channel; `bearing` a designation, or "balls, ball diameter, pitch diameter, contact angle". `description` has keys of such a
    file, as `{"spectrum": [{"channels": ["channel1"], "kind": "envelope"}]}`.
    """
    file = source if isinstance(source, (str, os.PathLike)) else None
    arrays = [] if file is not None else _arrays(source)
    if rate is not None and not isinstance(rate, str):
        rate = f"{float(rate)!r} Hz"
    options = {
        "rate": rate,
        "unit": unit,
        "scale": scale,
        "channel": channel,
        "speed": speed,
        "tacho": tacho,
        "pulses": pulses,
        "bearing": bearing,
        "window": window,
        "start": start,
        "duration": duration,
    }
    given = [(name, _texts(value)) for name, value in options.items()]
    found = Analysis(_analyze(file, arrays, given, dumped(description or {})))
    warn(found.warnings)
    return found
