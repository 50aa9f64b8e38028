"""How far long work is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Progress = bool | Callable[[float], object] | None
"""True shows a line on stderr; a callback is called with the part that is done, 0 … 1."""

PATIENCE = 0.8
"""Seconds of work that show no line."""


@contextmanager
def reporting(progress: Progress, title: str) -> Iterator[Callable[[float], object] | None]:
    """The callback of the compiled part; a line that was shown is ended."""
    if progress is None or progress is False:
        yield None
        return
    if callable(progress):
        yield progress
        return
    started, shown = time.monotonic(), ""

    def show(part: float) -> None:
        nonlocal shown
        line = f"\r{title}: {100 * part:3.0f} %"
        if line != shown and time.monotonic() - started > PATIENCE:
            shown = line
            print(line, end="", file=sys.stderr, flush=True)

    try:
        yield show
    finally:
        if shown:
            print(file=sys.stderr)
