"""Records of sensors: what is in them."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import warn
from ._jeffcott import analyze as _analyze
from ._results import Result
from ._scenario import dumped
from ._table import Table


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


def _arrays(source: Any) -> list[tuple[str, Any]]:
    """Arrays by their names: of a mapping its entries, of a matrix its columns."""
    if isinstance(source, Mapping):
        named = [(str(name), values) for name, values in source.items()]
    else:
        matrix = np.asarray(source, dtype=float)
        if matrix.ndim > 2:
            raise ValueError(f"an array has one or two dimensions, a column a channel, not {matrix.ndim}")
        matrix = matrix.reshape(len(matrix), -1) if matrix.size else matrix.reshape(0, 1)
        named = [(f"channel{index + 1}", matrix[:, index]) for index in range(matrix.shape[1])]
    return [(name, np.ascontiguousarray(np.ravel(values), dtype=float)) for name, values in named]


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

    `source` is a file, a file .toml that describes a record, an array (of a matrix each column is a channel), or a mapping of
    names to arrays. `rate` as a number is in Hz; `unit` "g" is the standard gravity; `speed` is "1797 rpm" or the name of a
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
