"""A shaft on rolling bearings: transient response and spectra, with the error of every answer.

    >>> import jeffcott as jc
    >>> scenario = jc.Scenario("scenarios/steady-7205c.toml")
    >>> scenario["shaft.mass"] = "6 kg"        # keys and units of the file, checked at once
    >>> run = scenario.run()                   # Ctrl-C stops it, other threads go on meanwhile
    >>> run["x_m"], run.error.relative         # numpy; the measured error is always there
    >>> run.figure("trace")                    # SVG, which notebooks show

A scenario (a file, a text or a dict) answers by `run`, `steady`, `bearing`, `campbell`, `frequency_response`, `matrices` and `accuracy`; `study` and
`sweep` make many runs of it, on threads or on any executor of `concurrent.futures`; `compare` tells whether two results
are the same; a `Bearing` is asked by itself; `analyze` finds out what is in a record of sensors, and `fit` which values
of a scenario explain what was measured.

Values with a dimension are given as text with a unit, "6 kg"; results are in SI units (m, N, s, rad), and the name of a
column ends with its unit, as `x_velocity_m_s`. What is wrong with a scenario is a `ScenarioError` with all its problems;
a question that has no answer is a `RunError`. What the reader should know of an answer is among its `warnings`, and a
Python warning of the class `ModelWarning`.
"""

from ._bearing import Bearing, catalogue
from ._compare import Comparison, compare
from ._errors import ModelWarning, Problem, RunError, ScenarioError
from ._fit import Fit, fit
from ._jeffcott import (
    CheckedScenario,
    Findings,
    RunFindings,
    StopSignal,
    StudyPlan,
    __version__,
)
from ._record import Analysis, analyze
from ._results import (
    Accuracy,
    Campbell,
    Error,
    Figure,
    FrequencyResponse,
    Matrices,
    Response,
    Result,
    Run,
    Statics,
    Steady,
)
from ._scenario import Scenario
from ._study import Study, study, sweep
from ._table import Table

__all__ = [
    "Accuracy",
    "Analysis",
    "Bearing",
    "Campbell",
    "CheckedScenario",
    "Comparison",
    "Error",
    "Figure",
    "Findings",
    "Fit",
    "FrequencyResponse",
    "Matrices",
    "ModelWarning",
    "Problem",
    "Response",
    "Result",
    "Run",
    "RunError",
    "RunFindings",
    "Scenario",
    "ScenarioError",
    "Statics",
    "Steady",
    "StopSignal",
    "Study",
    "StudyPlan",
    "Table",
    "__version__",
    "analyze",
    "catalogue",
    "compare",
    "fit",
    "study",
    "sweep",
]
