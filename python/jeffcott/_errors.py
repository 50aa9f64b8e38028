"""What can go wrong."""

from __future__ import annotations

import json
import re
import sys
import warnings
from collections.abc import Iterable
from typing import NamedTuple


OPTION = re.compile(
    r"--(at|bearing|by|channel|count|duration|from|period|points|pulses|rate|scale|speed|start|tacho|to|unit|window)\b( (?=\"))?"
)
"""Options of the command that are keywords here, with the blank in front of a value."""
OTHERWISE = {"from": "start", "to": "stop"}
"""Those that have another name."""


def by_keywords(text: str) -> str:
    """A message about the command line, about keywords: `--rate "12 kHz"` is `rate="12 kHz"`."""
    named = OPTION.sub(lambda it: OTHERWISE.get(it[1], it[1]) + ("=" if it[2] else ""), text)
    return named.replace("--> command line:", "--> keywords:")


class Problem(NamedTuple):
    """One thing that is wrong with a scenario or a study."""

    key: str
    """Path of the key, as `bearing[1].geometry.balls`; empty for the whole."""
    message: str
    """What is wrong, and which rule it breaks."""
    hint: str | None
    """What to do about it."""
    line: int | None
    """Line of the text, from 1, of a dict or of changed keys that of the JSON shown; None where none is to blame."""
    column: int | None
    """Column of that line, from 1."""


class ScenarioError(ValueError):
    """A scenario or a study that cannot be asked: everything that is wrong with it.

    `str()` shows every problem with its line; `problems` has them one by one.
    """

    problems: list[Problem]

    def __init__(self, text: str, problems: str = "[]") -> None:
        super().__init__(text, problems)
        self.problems = [
            Problem(p["key"], by_keywords(p["message"]), p["help"] and by_keywords(p["help"]), p["line"], p["column"])
            for p in json.loads(problems)
        ]

    def __str__(self) -> str:
        return by_keywords(str(self.args[0])).rstrip()


class RunError(RuntimeError):
    """A question that has no answer, as a shaft that leaves its bearings: its message says what to do."""

    def __init__(self, text: str, problems: str = "[]") -> None:
        super().__init__(text, problems)

    def __str__(self) -> str:
        return by_keywords(str(self.args[0]))


class ModelWarning(UserWarning):
    """What the reader of an answer should know: where the model or the numbers are to be doubted, and what to do.

    `warnings.simplefilter("ignore", jeffcott.ModelWarning)` silences all of them, "error" makes exceptions of them.
    """


def warn(messages: Iterable[str]) -> None:
    """Warns of every message once, at the line that called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        level, frame = level + 1, frame.f_back
    for message in dict.fromkeys(messages):
        warnings.warn(by_keywords(message), ModelWarning, stacklevel=level)
