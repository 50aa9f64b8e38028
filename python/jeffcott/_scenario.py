"""Scenarios: read, changed, and asked."""

from __future__ import annotations

import copy
import json
import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _results as results
from ._errors import ScenarioError, warn
from ._frozen import frozen
from ._jeffcott import CheckedScenario, Findings
from ._progress import Progress, reporting

if TYPE_CHECKING:
    from ._study import Study

Answered = TypeVar("Answered", bound=results.Result)


def plain(value: Any) -> Any:
    """A value as JSON has it: of numpy the number, the list or the text."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Iterable):
        return list(value)
    raise TypeError(f"a scenario has no value of type {type(value).__name__}: {value!r}")


def dumped(tree: Any) -> str:
    """JSON of a tree, a line a value, so that messages show where they belong."""
    try:
        return text_of(json.dumps(tree, default=plain, indent=2, ensure_ascii=False, allow_nan=False))
    except RecursionError:
        raise _wrong("", "tables and lists stand too deep in each other", "a scenario has a few levels") from None
    except ValueError as error:
        if isinstance(error, ScenarioError):
            raise
        if "Circular" in str(error):
            raise _wrong("", "a table or list holds itself", "write it out") from None
        numbers = _numbers(json.loads(json.dumps(tree, default=plain)))
        path, number = next((path, number) for path, number in numbers if not math.isfinite(number))
        raise _wrong(path, f"{number} is no value", "give a finite number") from None


def _numbers(tree: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """All numbers that are not whole, with their paths."""
    if isinstance(tree, float):
        yield path, tree
    elif isinstance(tree, dict):
        for key, value in tree.items():
            yield from _numbers(value, f"{path}.{key}" if path else key)
    elif isinstance(tree, list):
        for place, value in enumerate(tree, 1):
            yield from _numbers(value, f"{path}[{place}]")


def text_of(value: object, key: str = "") -> str:
    """A value as text, which has to be Unicode."""
    text = str(value)
    try:
        text.encode()
    except UnicodeEncodeError as error:
        found = f"{text[error.start]!r} at character {error.start} is half of a surrogate pair and no text"
        raise _wrong(key, found, "decode what it comes from as UTF-8") from None
    return text


def whole(name: str, value: Any, least: int, most: int) -> int:
    """A whole number of a range; raises ValueError in the words of the command."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise ValueError(f"{name}: {value!r} is not a whole number")
    number = int(value.__index__())
    if not least <= number <= most:
        raise ValueError(f"{name}: {number} is not in {least}..={most}")
    return number


def _steps(path: str) -> list[str | int]:
    """`load[1].constant.z` → `load`, 0, `constant`, `z`: the entries of a list are counted from 1."""
    text_of(path)
    if not re.fullmatch(r"[^.\[\]]+(\[\d+\]|\.[^.\[\]]+)*", path):
        raise _wrong(path, "this is no path of a key", 'for instance: "load[1].constant.z"')
    found = re.findall(r"[^.\[\]]+|\[\d+\]", path)
    steps = [int(step[1:-1]) - 1 if step.startswith("[") else step for step in found]
    if -1 in steps:
        raise _wrong(path, "there is no entry [0]", "the entries of a list are counted from 1")
    return steps


def _wrong(path: str, message: str, hint: str) -> ScenarioError:
    problem = {"key": path, "message": message, "help": hint, "line": None, "column": None}
    place = f"{path}: " if path else ""
    return ScenarioError(f"error: {place}{message}; {hint}", json.dumps([problem]))


def _find(tree: Any, path: str) -> Any:
    """The value at a path; raises KeyError where there is none."""
    for step in _steps(path):
        try:
            tree = tree[step]
        except (KeyError, IndexError, TypeError):
            raise KeyError(path) from None
    return tree


def _put(tree: Any, path: str, value: Any) -> None:
    """Puts a value, making the tables on its way; None takes it away. A list grows by its next entry only."""
    *way, last = _steps(path)
    for step, following in zip(way, [*way[1:], last]):
        if isinstance(step, str):
            _table(tree, path)
            tree = tree.setdefault(step, [] if isinstance(following, int) else {})
        else:
            _entry(tree, step, path)
            if step == len(tree):
                tree.append({})
            tree = tree[step]
    if isinstance(last, str):
        _table(tree, path)
    else:
        _entry(tree, last, path)
    if value is None:
        if isinstance(last, str):
            tree.pop(last, None)
        elif last < len(tree):
            del tree[last]
    elif isinstance(last, int) and last == len(tree):
        tree.append(value)
    else:
        tree[last] = value


def _table(tree: Any, path: str) -> None:
    if not isinstance(tree, dict):
        raise _wrong(path, "no table stands on this path", "a list has entries [1], [2] …, a value has no keys")


def _entry(tree: Any, index: int, path: str) -> None:
    if not isinstance(tree, list) or index > len(tree):
        have = len(tree) if isinstance(tree, list) else "no"
        raise _wrong(path, f"there is no entry [{index + 1}]", f"the list has {have} entries; the next one may be set")


class Scenario:
    """A shaft, its bearings and loads, and what is asked of them.

    `source` is the path of a file (.toml or .json), a text in TOML or JSON, or a dict of the same structure. Files that
    it names are looked for in `folder`: that of the file, or else the current one.

        >>> s = Scenario("scenarios/steady-7205c.toml")
        >>> s["shaft.mass"] = "6 kg"            # checked at once; None or `del` takes a key away
        >>> s["load[2]"] = {"harmonic": {"x": "20 N", "frequency": "80 Hz"}}   # a further load
        >>> s.update({"speed.constant": "300 rad/s", "time.duration": "1 s"})  # checked together

    `s["shaft"]` and `s["load[2]"]` can be read only: keys are written by their paths, as above, and `s.to_dict()` is a copy
    to change as a whole. `s.keys()` has the tables that are written; `dict(s)` and `list(s)` go over them.

    Raises `ScenarioError`, whose `problems` have key, message, hint and line.
    """

    def __init__(
        self,
        source: str | os.PathLike[str] | Mapping[str, Any],
        *,
        folder: str | os.PathLike[str] | None = None,
    ) -> None:
        self._read(source, folder)
        self._tell()

    def _read(
        self,
        source: str | os.PathLike[str] | Mapping[str, Any],
        folder: str | os.PathLike[str] | None,
        name: str = "scenario.dict",
    ) -> None:
        self._tree: dict[str, Any] | None = None
        self._warned: frozenset[str] = frozenset()
        if isinstance(source, Mapping):
            self._tree = json.loads(dumped(source))
            self.checked = self._parsed(dumped(source), name, folder, True)
        elif isinstance(source, str) and _is_text(source):
            is_json = source.lstrip().startswith("{")
            self.checked = self._parsed(text_of(source), f"scenario.{'json' if is_json else 'toml'}", folder, is_json)
        else:
            self.checked = CheckedScenario.load(Path(source))

    @staticmethod
    def _parsed(text: str, name: str, folder: str | os.PathLike[str] | None, is_json: bool) -> CheckedScenario:
        return CheckedScenario.parse(text, name if folder is None else os.path.join(os.fspath(folder), name), is_json)

    def _tell(self) -> None:
        """Warns of what it, or the scenario that it comes from, has not given."""
        found = self.checked.warnings()
        unsaid = [message for message in found if message not in self._warned]
        self._warned |= set(found)
        warn(unsaid)

    def _answer(self, result: Answered) -> Answered:
        """A result, with the warnings that the scenario has not given."""
        warn(message for message in result.warnings if message not in self._warned)
        return result

    def copy(self) -> Scenario:
        """Another scenario of the same keys."""
        other = object.__new__(Scenario)
        other.checked, other._tree, other._warned = self.checked, self._tree, self._warned  # a tree is never changed
        return other

    def _written(self) -> dict[str, Any]:
        if self._tree is None:
            self._tree = json.loads(self.checked.written())
        return self._tree

    def to_dict(self) -> dict[str, Any]:
        """The keys as they are written."""
        tree: dict[str, Any] = json.loads(json.dumps(self._written()))
        return tree

    @property
    def defaults(self) -> dict[str, Any]:
        """All keys, those with their default values too."""
        tree: dict[str, Any] = json.loads(self.checked.echo())
        return tree

    @property
    def title(self) -> str:
        """Its title, or the name of its file."""
        return self.checked.title()

    @property
    def warnings(self) -> list[str]:
        """What the user should know although the scenario can be run."""
        return self.checked.warnings()

    def __getitem__(self, path: str) -> Any:
        """The value of a key by its path, `bearing[1].geometry.balls`; its default where it is not written. A table or a
        list is read only."""
        try:
            return frozen(_find(self._written(), path))
        except KeyError:
            return frozen(_find(self.defaults, path))

    def keys(self) -> list[str]:
        """The tables, and the keys beside them, that are written."""
        return list(self._written())

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def __contains__(self, path: object) -> bool:
        try:
            self[str(path)]
        except KeyError:
            return False
        return True

    def __setitem__(self, path: str, value: Any) -> None:
        self.update({path: value})

    def __delitem__(self, path: str) -> None:
        _find(self._written(), path)
        self.update({path: None})

    def update(self, changes: Mapping[str, Any]) -> None:
        """Sets several keys by their paths and checks them together; None takes a key away. Where something is wrong
        the scenario stays as it was."""
        tree = self.to_dict()
        for path, value in changes.items():
            _put(tree, path, copy.deepcopy(value))
        text, place = dumped(tree), Path(self.checked.place())
        self.checked = CheckedScenario.parse(text, str(place.with_suffix(".changed")), True)
        self._tree = json.loads(text)
        self._tell()

    def with_(self, changes: Mapping[str, Any]) -> Scenario:
        """A copy with some keys set, as by `update`."""
        other = self.copy()
        other.update(changes)
        return other

    def __repr__(self) -> str:
        return f"<Scenario {self.title!r}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.to_dict(), str(self.checked.place()))

    def _with_integrator(self, tolerance: float | None, verify: bool | None) -> Scenario:
        changes = {"integrator.tolerance": tolerance, "integrator.verify": verify}
        given = {key: value for key, value in changes.items() if value is not None}
        return self.with_(given) if given else self

    def run(
        self, *, tolerance: float | None = None, verify: bool | None = None, progress: Progress = None
    ) -> results.Run:
        """Integrates the motion and keeps all samples in memory.

        `tolerance` and `verify` stand in place of those of `[integrator]`; `verify=False` leaves out the second pass,
        which measures the error. `progress=True` shows a line on stderr, a callback gets the part that is done, 0 … 1.
        Ctrl-C stops the run (KeyboardInterrupt). Raises `RunError` where the motion cannot be integrated.
        """
        asked = self._with_integrator(tolerance, verify)
        with reporting(progress, self.title) as tell:
            return asked._answer(results.Run(asked.checked.run(tell, []), asked))

    def bearing(self) -> results.Statics:
        """Where the shaft stands, without motion: equilibrium, stiffness, every ball. Of many values `sweep` with
        `ask="bearing"` answers it."""
        again = partial(_bearing, self.copy())
        return self._answer(results.Statics(again([]), again))

    def steady(
        self,
        *,
        period: int | None = None,
        tolerance: float | None = None,
        verify: bool | None = None,
    ) -> results.Steady:
        """The motion that the shaft settles to, found without waiting for it, its stability and its exact lines.

        `period`: how many periods of the forcing it takes; otherwise one, or those of a stable motion beside it.
        """
        asked = self._with_integrator(tolerance, verify)
        again = partial(_steady, asked.copy(), None if period is None else whole("period", period, 1, 64))
        return asked._answer(results.Steady(again([]), again))

    def response(
        self,
        over: str,
        start: str,
        stop: str,
        *,
        period: int = 1,
        points: int = 20_000,
        doubled: bool = True,
        progress: Progress = None,
    ) -> results.Response:
        """Steady motions along a number of the scenario, past turning points and doublings of the period.

        `over` is the path of a key, as "speed.constant", `start` and `stop` are its values with their units; at most
        `points` motions a branch, and none of doubled periods where `doubled` is false.
        """
        with reporting(progress, self.title) as tell:
            followed = (text_of(over), text_of(start), text_of(stop))
            period, points = whole("period", period, 1, 64), whole("points", points, 1, 2**32 - 1)
            found = self.checked.response(followed, period, points, doubled, tell)
        return self._answer(results.Response(found))

    def campbell(
        self,
        to: str | None = None,
        *,
        start: str = "0 rpm",
        count: int = 61,
        orders: Sequence[float | str] = (1.0,),
        highest_frequency: str | None = None,
    ) -> results.Campbell:
        """Natural frequencies from `start` to `to`, as "60000 rpm", or to 1.5 times the highest speed of the scenario.

        They are those at `count` speeds. Critical speeds are where one is `orders` times the frequency of the shaft.
        Branches reach up to `highest_frequency`, as "20 kHz", or 1.5 times the highest order at the highest speed.
        """
        ends, speeds = (text_of(start), None if to is None else text_of(to)), whole("count", count, 2, 100_000)
        highest = None if highest_frequency is None else text_of(highest_frequency)
        again = partial(_campbell, self.copy(), ends, speeds, [str(order) for order in orders], highest)
        return self._answer(results.Campbell(again([]), again))

    def frequency_response(
        self,
        at: str | Sequence[str],
        start: str,
        stop: str,
        *,
        by: str | None = None,
        speed: str | None = None,
        count: int = 301,
    ) -> results.FrequencyResponse:
        """The motion at places of the linearised shaft by its unbalances from speed `start` to `stop`, or by a harmonic force.

        `at` names places, as "250 mm" for x and y, "y@250 mm" or "tilt_x@250 mm". With `by`, as "y@100 mm" for a force and
        "tilt_x@100 mm" for a moment, `start` and `stop` are frequencies, and `speed` is that of the shaft, or that at the
        start of the scenario.
        """
        if speed is not None and by is None:
            raise ValueError("speed: that of a shaft that a force acts on; name it by `by`, or leave out `speed`")
        found = self.checked.frequency_response(
            _places(at),
            (text_of(start), text_of(stop)),
            None if by is None else text_of(by),
            None if speed is None else text_of(speed),
            whole("count", count, 3, 100_000),
        )
        return self._answer(results.FrequencyResponse(found))

    def matrices(self, speed: str | None = None, *, at: str | Sequence[str] = ()) -> results.Matrices:
        """M, C, G, K and the state matrix A of the shaft linearised about its static equilibrium at `speed`, as "3000 rpm", or
        at that of the start of the scenario.

        A shaft that bends has coordinates at bearings, elements, loads and unbalances, and at the places that `at` names.
        """
        found = self.checked.matrices(_places(at), None if speed is None else text_of(speed))
        return self._answer(results.Matrices(found))

    def accuracy(
        self,
        *,
        methods: Sequence[str] = (),
        tolerances: Sequence[float] | None = None,
        longest: str = "2 s",
        progress: Progress = None,
    ) -> results.Accuracy:
        """Speed against error of `methods` (all where none are named) at `tolerances` (1e-4, 1e-6, 1e-8 and 1e-10), without
        what runs longer than `longest`."""
        given = [] if tolerances is None else [float(tolerance) for tolerance in tolerances]
        if tolerances is not None and not given:
            raise ValueError("tolerances: name at least one, as 1e-6")
        with reporting(progress, self.title) as tell:
            named = [text_of(method) for method in methods]
            found = self.checked.accuracy(named, given, text_of(longest), tell)
        return self._answer(results.Accuracy(found))

    def sweep(self, axes: Mapping[str, Any], **settings: Any) -> Study:
        """Many runs of this scenario; see `jeffcott.sweep`."""
        from ._study import sweep

        return sweep(self, axes, **settings)


def _is_text(source: str) -> bool:
    """Whether it is a text rather than a path."""
    if "\n" in source or source.lstrip().startswith("{"):
        return True
    return "=" in source and not os.path.exists(source)


def _places(at: str | Sequence[str]) -> list[str]:
    return [text_of(at)] if isinstance(at, str) else [text_of(place) for place in at]


def _bearing(scenario: Scenario, keys: list[str]) -> Findings:
    return scenario.checked.bearing(keys)


def _steady(scenario: Scenario, period: int | None, keys: list[str]) -> Findings:
    return scenario.checked.steady(period, keys)


def _campbell(
    scenario: Scenario,
    ends: tuple[str, str | None],
    count: int,
    orders: list[str],
    highest: str | None,
    keys: list[str],
) -> Findings:
    return scenario.checked.campbell(ends, count, orders, highest, keys)


def warned_before(tree: dict[str, Any], place: str, warned: frozenset[str] | None) -> Scenario:
    """A scenario of a path, some of whose warnings were given already: all of them where none are named."""
    scenario = object.__new__(Scenario)
    scenario._read(tree, *os.path.split(place))
    scenario._warned = frozenset(scenario.checked.warnings()) if warned is None else warned
    scenario._tell()
    return scenario


def _restored(tree: dict[str, Any], place: str) -> Scenario:
    return warned_before(tree, place, None)


