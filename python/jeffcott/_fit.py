"""Which values explain what was measured."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ._errors import warn
from ._jeffcott import Findings
from ._jeffcott import fit as _fit
from ._results import Result
from ._scenario import Scenario, dumped, whole
from ._table import Array, Table


class Fit(Result):
    """Values of quantities of a scenario that explain what was measured, and how well they are known."""

    def __init__(self, source: Any, fitted: str, folder: str) -> None:
        super().__init__(source)
        self._fitted, self._folder = fitted, folder

    def _by_key(self, name: str) -> dict[str, float]:
        return {found["key"]: float(found[name]) for found in self.summary["unknowns"]}

    @property
    def values(self) -> dict[str, float]:
        """The values by their keys, in SI units."""
        return self._by_key("value")

    @property
    def standard_errors(self) -> dict[str, float]:
        """Their standard errors; of one that is not identified the length of its range."""
        return self._by_key("standard_error")

    @property
    def correlations(self) -> Array:
        """Correlations of the values, in their order."""
        return np.array(self.summary["correlations"], dtype=float)

    @property
    def chi_square(self) -> float:
        """Sum of the squares of the residuals, each in standard deviations."""
        return float(self.summary["chi_square"])

    @property
    def observations(self) -> Table:
        """What was measured and what is computed, with residuals in standard deviations."""
        return self.table("fit_observations")

    @property
    def minima(self) -> Table:
        """All minima that were found, the lowest first."""
        return self.table("fit_minima")

    @property
    def profiles(self) -> Table:
        """The least chi-square around the values."""
        return self.table("fit_profiles")

    @property
    def scenario(self) -> Scenario:
        """The scenario with the values."""
        return Scenario(self._fitted, folder=self._folder)

    def __reduce__(self) -> tuple[Any, ...]:
        return Fit, (*super().__reduce__()[1], self._fitted, self._folder)


def fit(
    source: str | os.PathLike[str] | Mapping[str, Any],
    scenario: Scenario | None = None,
    *,
    threads: int | None = None,
) -> Fit:
    """Finds the values of quantities that explain what was measured.

    `source` is a fit file, as `jeffcott fit` takes it, or a dict of its keys about a `scenario`:

        >>> jc.fit({
        ...     "unknown": [{"key": "bearing[*].preload", "from": "50 N", "to": "500 N"}],
        ...     "observation": [{"number": "natural_frequency_1_Hz", "value": "412 Hz", "sigma": "3 Hz"}],
        ... }, scenario)

    Ctrl-C stops it (KeyboardInterrupt). Raises `ScenarioError` where something in the file is wrong, `RunError` where the
    scene has no answer.
    """
    threads = None if threads is None else whole("threads", threads, 1, 1024)
    found: Findings
    if isinstance(source, Mapping):
        if scenario is None:
            raise ValueError("a fit by a dict needs the scenario that it is about")
        folder = scenario.checked.place().parent
        found = _fit(None, (scenario.checked, dumped({"base": "-", **source})), threads)
    elif scenario is not None:
        raise ValueError("a fit file names its scenario itself: give a dict of its keys about another one")
    else:
        folder = Path(source).parent
        found = _fit(Path(source), None, threads)
    result = Fit(found, found.file("fitted.toml") or "", os.path.abspath(folder))
    warn(result.warnings)
    return result
