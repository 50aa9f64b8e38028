"""Results: their documents, tables, figures and errors."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, Self

import numpy as np

from ._errors import ScenarioError
from ._frozen import frozen
from ._table import Array, Table, nearest

if TYPE_CHECKING:
    import os

    from ._jeffcott import RunFindings
    from ._scenario import Scenario


class Error(NamedTuple):
    """How far a result is off, as a second computation at a tenth of the tolerance measured it."""

    displacement_m: float
    """Largest difference of a displacement (tilts times their arm), m."""
    relative: float
    """The same relative to the motion."""
    reference_tolerance: float
    """Tolerance of the second computation."""


class Figure:
    """A figure as SVG, which notebooks show; `save` writes it to a file."""

    def __init__(self, name: str, svg: str) -> None:
        self.name = name
        self.svg = svg

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the SVG to a file."""
        Path(path).write_text(self.svg, encoding="utf-8")

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Figure {self.name!r}: {len(self.svg)} characters of SVG>"


class _Source(Protocol):
    """What a result reads from: an answer of the compiled part, or a folder."""

    def document(self) -> str: ...
    def text(self) -> str: ...
    def warnings(self) -> list[str]: ...
    def tables(self) -> Sequence[str]: ...
    def table(self, name: str) -> Sequence[tuple[str, Any]] | None: ...
    def figures(self) -> Sequence[str]: ...
    def figure(self, name: str) -> str | None: ...
    def write(self, folder: os.PathLike[str]) -> list[Path]: ...


class _Kept:
    """All that a source answers, for another process."""

    def __init__(self, source: Any) -> None:
        if isinstance(source, _Kept):
            self.__dict__.update(source.__dict__)
            return
        self._document, self._text, self._warnings = source.document(), source.text(), source.warnings()
        self._tables = {name: source.table(name) for name in source.tables()}
        self._figures = {name: source.figure(name) for name in source.figures()}
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(path) for path in source.write(Path(folder))]
            self._files = {str(path.relative_to(folder)): path.read_bytes() for path in paths}

    def document(self) -> str:
        return str(self._document)

    def text(self) -> str:
        return str(self._text)

    def warnings(self) -> list[str]:
        return list(self._warnings)

    def tables(self) -> list[str]:
        return list(self._tables)

    def table(self, name: str) -> Sequence[tuple[str, Any]] | None:
        return self._tables.get(name)

    def figures(self) -> list[str]:
        return list(self._figures)

    def figure(self, name: str) -> str | None:
        return self._figures.get(name)

    def write(self, folder: os.PathLike[str]) -> list[Path]:
        Path(folder).mkdir(parents=True, exist_ok=True)
        for name, content in self._files.items():
            (Path(folder) / name).write_bytes(content)
        return [Path(folder) / name for name in self._files]


class _KeptRun(_Kept):
    """A run, with all that was observed of its samples."""

    def __init__(self, source: Any, scenario: Scenario) -> None:
        super().__init__(source)
        if isinstance(source, _KeptRun):
            return
        self._samples, self._error, self._scenario = source.samples(), source.error(), scenario
        self._columns = {name: source.column(name) for name in source.columns()}

    def samples(self) -> int:
        return int(self._samples)

    def error(self) -> tuple[float, float, float] | None:
        return self._error  # type: ignore[no-any-return]

    def columns(self) -> list[str]:
        return list(self._columns)

    def column(self, name: str) -> Array:
        if name not in self._columns:
            raise KeyError(f"no column is called {name!r}; the columns are {', '.join(self._columns)}")
        column: Array = self._columns[name].copy()
        return column

    def estimated(self, asked: Any) -> Sequence[tuple[str, Any]]:
        # the same run again, to the last digit
        return self._scenario.checked.run(None, []).estimated(asked)


class Result:
    """The answer to a question: a summary, tables, figures, warnings and the measured error.

    `print(result)` tells what the command tells; a notebook shows that and the first figure.
    """

    def __init__(self, source: _Source) -> None:
        self._source = source
        self._tables: dict[str, Table] = {}

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The JSON document that the command writes, as a dict that is read only; numbers are in the units of their keys."""
        document: dict[str, Any] = frozen(json.loads(self._source.document()))
        return document

    @property
    def error(self) -> Error | None:
        """The measured error; None where the scenario asks for none, or the question has none to measure."""
        found = self.summary.get("measured_error")
        if found is None:
            return None
        return Error(found["displacement_m"], found["relative"], found["reference_tolerance"])

    @property
    def warnings(self) -> list[str]:
        """What the reader should know, each with its numbers."""
        return self._source.warnings()

    @property
    def tables(self) -> list[str]:
        """Names of the tables."""
        return list(self._source.tables())

    @property
    def figures(self) -> list[str]:
        """Names of the figures."""
        return list(self._source.figures())

    def table(self, name: str) -> Table:
        """A table by its name: that of the file without its ending."""
        if name not in self._tables:
            columns = self._source.table(name)
            if columns is None:
                raise KeyError(f"this result has no table {name!r}; {nearest(name, self.tables)}")
            self._tables[name] = Table(name, columns)
        return self._tables[name]

    def figure(self, name: str | None = None) -> Figure:
        """A figure by its name: that of the file without its ending; the first one where none is given."""
        known = self.figures
        if name is None and known:
            name = known[0]
        svg = None if name is None else self._source.figure(name)
        if name is None or svg is None:
            raise KeyError(f"this result has no figure {name!r}; {nearest(name or '', known)}")
        return Figure(name, svg)

    def write(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Writes all files into `folder`, as the command does: whole, or not at all. Returns their paths."""
        return [Path(path) for path in self._source.write(Path(folder))]

    def __copy__(self) -> Self:
        """Another result from the same source, which never changes."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self, memo: object) -> Self:
        return self.__copy__()

    def __reduce__(self) -> tuple[Any, ...]:
        kept = _Kept(self._source) if hasattr(self._source, "write") and not hasattr(self._source, "path") else self._source
        return type(self), (kept,)

    def __str__(self) -> str:
        return self._source.text()

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.summary.get('title')!r}, error {self.error}>"

    def _repr_html_(self) -> str:
        from html import escape

        figures = self.figure().svg if self.figures else ""
        return f"{figures}<pre>{escape(str(self))}</pre>"


class Columns(Result):
    """A result whose columns are taken by their names: `result["x_m"]`, `"x_m" in result`, `dict(result)`."""

    def __getitem__(self, column: str) -> Any:
        """A column by its name."""
        raise NotImplementedError

    def keys(self) -> list[str]:
        """Names of the columns."""
        raise NotImplementedError

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, column: object) -> bool:
        return column in self.keys()


def _sensitivity(keys: tuple[str, ...], again: Callable[[list[str]], _Source]) -> Table:
    """The table of derivatives of a question that is asked again with keys."""
    if not keys:
        raise ValueError("name at least one key, as \"shaft.mass\"")
    found = again([str(key) for key in keys])
    name = next(name for name in found.tables() if name.endswith("_sensitivity"))
    return Table(name, found.table(name) or [])


class Run(Columns):
    """A run: samples of the motion, events, spectra.

    `run["x_m"]` is a column of all samples; `run.keys()` names them: those of the trace, and accelerations, energies, forces
    of every bearing and element, as far as they were observed. SI units.
    """

    _source: RunFindings

    def __init__(self, source: RunFindings, scenario: Scenario) -> None:
        super().__init__(source)
        self.scenario = scenario.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return Run, (_KeptRun(self._source, self.scenario), self.scenario)

    @property
    def error(self) -> Error | None:
        """The measured error: largest difference from a second pass at a tenth of the tolerance; None where the
        scenario says `verify = false`, or the pass failed, as a warning then says."""
        found = self._source.error()
        return None if found is None else Error(*found)

    @property
    def t(self) -> Array:
        """Times of the samples, s."""
        return self["t_s"]

    def __getitem__(self, column: str) -> Array:
        """A column of the samples: `x_m`, `y_velocity_m_s`, `z_acceleration_m_s2`, `force_x_N`, `kinetic_J` …; NaN
        where a value was not observed."""
        return self._source.column(column)

    def keys(self) -> list[str]:
        """Names of all columns of the samples."""
        return self._source.columns()

    def sensitivity(self, *keys: str) -> Table:
        """How its numbers change with quantities of the scenario, as those of `steady()`; of a motion that has settled."""
        return _sensitivity(keys, lambda asked: self.scenario.checked.run(None, asked))

    def __len__(self) -> int:
        """Number of samples."""
        return self._source.samples()

    @property
    def trace(self) -> Table:
        """All samples: time, angle, speed, displacements, velocities, forces of the bearings on the shaft, balls."""
        return self.table("trace")

    @property
    def events(self) -> Table:
        """Contacts that are lost and found: time, kind, bearing and ball, both from 1."""
        return self.table("events")

    @property
    def peaks(self) -> Table:
        """Peaks of the spectra with what makes them; amplitudes in the unit of their row."""
        return self.table("peaks")

    def spectrum(self, *channels: str, name: str = "spectrum", **settings: Any) -> Table:
        """A spectrum of the samples behind the settle time.

        Without arguments that of the run: amplitude (peak value) and phase of every displacement and force. With the
        name of a `[[spectrum]]` of the scenario that one, as `run.spectrum("envelope")`. With channels and keys of a
        `[[spectrum]]` one that is estimated from the samples of this run, as
        `run.spectrum("y_acceleration", scaling="rms", window="hann")`; channels are named as in the files, without the
        unit: `x`, `y_velocity`, `z_acceleration`, `force_x`. Units stand in the names of the columns.
        """
        if not channels and not settings:
            return self.table(name)
        of_scenario = [table.partition("_")[2] for table in self.tables if table.startswith("spectrum_")]
        if not settings and len(channels) == 1 and channels[0] in of_scenario:
            return self.table(f"spectrum_{channels[0]}")
        asked = self.scenario.copy()
        try:
            asked["spectrum"] = [{"name": name, "channels": list(channels), **settings}]
        except ScenarioError as error:
            named = ", ".join(map(repr, of_scenario)) or "none"
            error.add_note(f"spectra that the scenario asks for by name: {named}")
            raise
        return Table(name, self._source.estimated(asked.checked))


class Differentiable(Result):
    """A result whose numbers can be differentiated by quantities of its scenario."""

    def __init__(self, source: _Source, again: Callable[[list[str]], _Source]) -> None:
        super().__init__(source)
        self._again = again

    def sensitivity(self, *keys: str) -> Table:
        """How its numbers change with quantities of the scenario, as "shaft.mass" or "bearing[*].preload".

        A row a number and a key: derivative in SI units, per cent per per cent, and the errors of both, by two step sizes.
        """
        return _sensitivity(keys, self._again)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (*super().__reduce__()[1], self._again)


class Steady(Differentiable, Columns):
    """The motion that a shaft settles to."""

    @property
    def stable(self) -> bool:
        """Whether it is stable."""
        return bool(self.summary["stable"])

    @property
    def period(self) -> float:
        """Its period, s."""
        return float(self.summary["period_s"])

    @property
    def multipliers(self) -> Array:
        """Its Floquet multipliers, complex, the largest first; where the motion has two frequencies their sizes."""
        found = self.summary["multipliers"]
        return np.array([complex(m["re"], m["im"]) if "re" in m else complex(m["magnitude"]) for m in found])

    @property
    def trace(self) -> Table:
        """Samples of the motion, as those of a run."""
        return self.table("steady_trace")

    def __getitem__(self, column: str) -> Array:
        """A column of the trace."""
        return self.trace[column]

    def keys(self) -> list[str]:
        """Names of the columns of the trace."""
        return list(self.trace)

    @property
    def spectrum(self) -> Table:
        """Its exact lines: frequency in Hz, amplitude (peak value) and phase of every channel."""
        return self.table("steady_spectrum")


class Response(Result):
    """Steady motions along a number of the scenario, with turning points and doublings.

    Its `error` is that of the first motion, measured against one found by itself at a hundredth of the tolerance.
    """

    @property
    def points(self) -> Table:
        """Every motion of every branch: value, period, stability, ranges, multipliers."""
        return self.table("response")

    @property
    def specials(self) -> Table:
        """Where branches turn, or motions lose their stability."""
        return self.table("response_specials")


class Statics(Differentiable):
    """Where a shaft stands: equilibrium, stiffness, every ball."""

    @property
    def equilibrium(self) -> Array:
        """x, y, z in m and the tilts about x and y in rad."""
        return np.array(list(self.summary["equilibrium"].values()))

    @property
    def force(self) -> Array:
        """Force of the shaft onto the bearings: x, y, z in N, moments about x and y in N m."""
        return np.array(list(self.summary["force"].values()))

    @property
    def stiffness(self) -> Array:
        """K = ∂F/∂q, rows and columns x, y, z, tilt x, tilt y: N/m, N/rad, N m/m, N m/rad."""
        return np.array(self.summary["stiffness"]["matrix"])

    @property
    def error(self) -> Error:
        """How far the displacement can be off: the Newton step that is left, m, and the largest unbalanced force relative
        to the forces in play. Newton's method goes on to round-off, so there is no tolerance (NaN)."""
        return Error(float(self.summary["displacement_error_m"]), self.residual, float("nan"))

    @property
    def residual(self) -> float:
        """Largest unbalanced force relative to the forces in play."""
        return float(self.summary["residual"])

    @property
    def balls(self) -> Table:
        """Load, angle, pressure and more of every ball, of every bearing."""
        return self.table("balls")


class Campbell(Differentiable):
    """Natural frequencies over the speed, and critical speeds."""

    @property
    def modes(self) -> Table:
        """Frequency in Hz and damping ratio of every branch at every speed in rad/s."""
        return self.table("campbell")

    @property
    def error(self) -> Error | None:
        """The largest relative error of a frequency at a critical speed, as `relative`: of the search for it and, of a shaft
        that bends, of the modes that were left out. None without a critical speed; frequencies have no displacement (NaN)."""
        largest = self.summary["frequency_error"]
        return None if largest is None else Error(float("nan"), float(largest), float("nan"))

    @property
    def critical_speeds(self) -> list[dict[str, Any]]:
        """Crossings of natural frequencies and orders: `speed_rad_s`, `frequency_Hz`, `order`, `whirl` …."""
        return list(self.summary["critical_speeds"])


class FrequencyResponse(Columns):
    """The response of the linearised shaft to a force over its frequency, or to the unbalances over the speed.

    `response["x_1"]` is complex: receptance, or motion by the unbalances as `Re u exp(iψ)`, in the unit that `summary["at"]`
    tells; NaN at an undamped resonance.
    """

    @property
    def points(self) -> Table:
        """Amplitudes and phases; of a force receptance, mobility and accelerance."""
        return self.table("frequency_response")

    @property
    def over(self) -> Array:
        """Frequencies of the force in Hz, or speeds in rad/s."""
        return self.points[next(iter(self.points))]

    def __getitem__(self, column: str) -> Array:
        """The complex response of a place: its direction and its number among the positions, from 1, as "y_2"."""
        phase = f"{column}{self._phase}"
        phases, names = self.points[phase], list(self.points)
        found: Array = self.points[names[names.index(phase) - 1]] * np.exp(1j * phases)
        return found

    @property
    def _phase(self) -> str:
        """How names of phases end."""
        return "_phase_rad" if self.summary["by"] == "unbalance" else "_receptance_phase_rad"

    def keys(self) -> list[str]:
        """Names of the places: directions with their numbers, as "y_2"."""
        return [name.removesuffix(self._phase) for name in self.points if name.endswith(self._phase)]

    @property
    def resonances(self) -> Table:
        """Peaks with their amplification factors and separation margins."""
        return self.table("resonances")

    @property
    def error(self) -> Error | None:
        """Largest difference from the response with fewer modes of bending, as `relative`; None of a rigid shaft."""
        found = self.summary["reduction_error"]
        return None if found is None else Error(float("nan"), float(found), float("nan"))


class Matrices(Result):
    """`M q'' + (C + speed G) q' + K q = f` of the linearised shaft, and A of `d/dt (q, q') = A (q, q')`."""

    def _square(self, name: str) -> Array:
        return np.column_stack(list(self.table(name).values()))

    @property
    def M(self) -> Array:
        """Masses and moments of inertia."""
        return self._square("mass")

    @property
    def C(self) -> Array:
        """Damping of shaft and elements."""
        return self._square("damping")

    @property
    def G(self) -> Array:
        """Gyroscopic forces per velocity and rad/s."""
        return self._square("gyroscopic")

    @property
    def K(self) -> Array:
        """Stiffness of shaft, bearings and elements; unsymmetric with films and with damping inside the shaft."""
        return self._square("stiffness")

    @property
    def A(self) -> Array:
        """State matrix."""
        return self._square("state_matrix")

    @property
    def speed(self) -> float:
        """Speed of the shaft, rad/s."""
        return float(self.summary["speed_rad_s"])

    @property
    def coordinates(self) -> list[str]:
        """Names of the coordinates q."""
        return [own["name"] for own in self.summary["coordinates"]]

    @property
    def units(self) -> list[str]:
        """Units of q. Shares of modes of bending have a modal mass of one, and are in sqrt(kg) m."""
        return [own["unit"] for own in self.summary["coordinates"]]


class Accuracy(Result):
    """Speed against error of methods at tolerances, and what each level of the physics costs and changes."""

    @property
    def methods(self) -> Table:
        """Wall time in s, work and errors of every method at every tolerance."""
        return self.table("accuracy")

    @property
    def ladder(self) -> Table:
        """The same of every level of the physics."""
        return self.table("ladder")

    @property
    def error(self) -> Error:
        """How far the reference itself can be off: two methods agree on it so well."""
        of = self.summary["reference"]
        uncertainty = of["uncertainty"]
        return Error(uncertainty["displacement_m"], uncertainty["displacement_relative"], of["run"]["tolerance"])
