"""Whether two results are the same."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Literal

from ._jeffcott import compare as _compare
from ._frozen import frozen
from ._results import Result
from ._scenario import text_of, whole

Compared = str | os.PathLike[str] | Result


class Comparison:
    """What a comparison found; true where both agree. `print` tells the worst places of every column."""

    def __init__(self, summary: dict[str, Any], text: str) -> None:
        self.summary = frozen(summary)
        self._text = text

    @property
    def agrees(self) -> bool:
        """Whether both are the same within the tolerances."""
        return bool(self.summary["agrees"])

    def __bool__(self) -> bool:
        return self.agrees

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<Comparison: {'agrees' if self else 'differs'}>"


def compare(
    first: Compared,
    second: Compared,
    *,
    relative: float = 1e-6,
    absolute: float = 0.0,
    columns: Mapping[str, tuple[float, float]] | None = None,
    lines: int | None = None,
    by: Literal["frequency", "order", "name"] = "frequency",
    reach: float | None = None,
    decibels: float | None = None,
    common: bool = False,
    worst: int = 1,
) -> Comparison:
    """Compares two CSV files, two run folders or two results.

    Values agree where |a − b| ≤ absolute + relative · max|column|; `columns` has (relative, absolute) for single ones,
    `absolute` in the unit of the column. `lines` compares that many of the strongest lines of spectra, wherever they
    stand: those of folders of runs and records `by` "frequency", "order" or "name"; each finds its partner within the part
    `reach` of its frequency, without it within a bin, and agrees within so many `decibels` in place of the tolerances. `common` leaves out what only one of them has; `worst` places of every column are reported.
    """
    if lines is None and (reach is not None or decibels is not None or by != "frequency"):
        raise ValueError("by, reach and decibels are of `lines`: say how many of them, as lines=10")
    if decibels is not None and columns:
        raise ValueError("columns: lines agree within `decibels`, or within tolerances; give one of them")
    with ExitStack() as stack:

        names: dict[str, str] = {}

        def path(result: Compared, name: str) -> Path:
            if not isinstance(result, Result):
                return Path(result)
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            names[str(folder)] = f"the {name} result, a {type(result).__name__},"
            result.write(folder)
            return folder

        lines = None if lines is None else whole("lines", lines, 1, 65535)
        worst = whole("worst", worst, 1, 65535)
        paths = path(first, "first"), path(second, "second")
        single = {text_of(name): pair for name, pair in (columns or {}).items()}
        try:
            found, text = _compare(*paths, relative, absolute, single, worst, lines, by, reach, decibels, common)
        except ValueError as error:
            # the folder of a result is gone when the message is read
            message = str(error)
            for folder, name in names.items():
                message = message.replace(folder, name)
            raise ValueError(message) from None
    return Comparison(json.loads(found), text)
