"""Many runs of one scenario."""

from __future__ import annotations

import csv
import json
import os
import shutil
import tempfile
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import warn
from ._jeffcott import CheckedScenario, StopSignal, StudyPlan, merge
from ._progress import Progress, reporting
from ._results import Columns, Error
from ._scenario import Scenario, dumped, text_of, whole
from ._table import Table

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

WORDS = ("direction", "status", "error", "warnings", "checksum")
"""Columns of a study that are text."""
COUNTS = ("run", "bearing", "position", "bytes")

PARTS_A_WORKER = 4
"""Parts of a study for each worker of an executor, so that none waits long for the last one."""

_stops: dict[str, StopSignal] = {}
"""What ends the parts that this process makes, by the study that they are of."""


def _read(path: Path) -> list[tuple[str, Any]]:
    """The columns of a CSV file of a study."""
    with path.open(newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    columns = list(zip(*rows)) if rows else [()] * len(names)

    def values(name: str, cells: Sequence[str]) -> Any:
        if name in WORDS:
            return np.array(cells, dtype=str)
        if name in COUNTS:
            return np.array(cells, dtype=np.int64)
        return np.array([cell or "nan" for cell in cells], dtype=float)

    return [(name, values(name, cells)) for name, cells in zip(names, columns)]


class _Folder:
    """The files of a study as the source of a result."""

    def __init__(self, path: Path, temporary: tempfile.TemporaryDirectory[str] | None) -> None:
        self.path = path
        self._temporary = temporary

    def _named(self, ending: str) -> list[str]:
        found = (path.stem for path in self.path.glob(f"*.{ending}") if ".part-" not in path.name)
        return sorted(found, key=lambda name: (name != "runs", name))

    def document(self) -> str:
        return (self.path / "runs.json").read_text(encoding="utf-8")

    def text(self) -> str:
        found = json.loads(self.document())
        digest = found["digest"]
        return f"{found['title']}\n  {digest['runs']} runs, {digest['failed']} of them failed; {self.path}"

    def warnings(self) -> list[str]:
        return list(json.loads(self.document())["warnings"])

    def tables(self) -> list[str]:
        return self._named("csv")

    def table(self, name: str) -> list[tuple[str, Any]] | None:
        return _read(self.path / f"{name}.csv") if name in self.tables() else None

    def figures(self) -> list[str]:
        return self._named("svg")

    def figure(self, name: str) -> str | None:
        return (self.path / f"{name}.svg").read_text(encoding="utf-8") if name in self.figures() else None

    def write(self, folder: os.PathLike[str]) -> list[Path]:
        if Path(folder).resolve() != self.path.resolve():
            shutil.copytree(self.path, folder, dirs_exist_ok=True)
        return sorted(Path(folder).iterdir())

    def __reduce__(self) -> tuple[Any, ...]:
        if self._temporary is None:
            return _Folder, (self.path, None)
        files = {str(file.relative_to(self.path)): file.read_bytes() for file in self.path.rglob("*") if file.is_file()}
        return _unpacked, (self.path.name, files)


def _unpacked(name: str, files: dict[str, bytes]) -> _Folder:
    """A folder that goes with its result, in another process."""
    temporary = tempfile.TemporaryDirectory()
    folder = Path(temporary.name) / name
    for file, content in files.items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(content)
    return _Folder(folder, temporary)


class Study(Columns):
    """Many runs: a row a run. `study["x_rms_m"]` is a column of `runs`."""

    _source: _Folder

    @property
    def folder(self) -> Path:
        """Where its files stand."""
        return self._source.path

    @property
    def runs(self) -> Table:
        """Values and numbers of every run, its status, error and warnings."""
        return self.table("runs")

    def __getitem__(self, column: str) -> Any:
        return self.runs[column]

    def keys(self) -> list[str]:
        """Names of the columns of `runs`."""
        return list(self.runs)

    @property
    def digest(self) -> dict[str, Any]:
        """Means, extremes, quantiles, resonances, sensitivities."""
        return dict(self.summary["digest"])

    @property
    def error(self) -> Error | None:
        """The largest measured error of the runs that have one, relative; None where none has."""
        largest = self.digest["largest_measured_error"]
        return None if largest is None else Error(float("nan"), largest, float("nan"))


Task = tuple[str, ...]
"""What a worker needs to know of a study: the path of its file, or text, name and axes of its scenario."""


def _plan(task: Task) -> StudyPlan:
    if len(task) == 1:
        return StudyPlan.load(Path(task[0]))
    text, name, study = task
    return StudyPlan.of(CheckedScenario.parse(text, name, True), study)


def _make_part(task: Task, folder: str, part: tuple[int, int], token: str) -> int:
    """Makes the runs of one part of a study that are not there, on a worker."""
    _plan(task).make(Path(folder), part, 1, False, _stops.get(token), None)
    return part[0]


def _by_parts(task: Task, folder: Path, parts: int | None, executor: Any, tell: Any) -> None:
    """Makes a study on an executor and puts its parts together."""
    from concurrent.futures import as_completed

    if hasattr(executor, "get_executor"):  # a client of Dask
        executor = executor.get_executor()
    workers: int = getattr(executor, "_max_workers", None) or os.cpu_count() or 1
    _, most = _plan(task).size()
    count = max(1, min(parts or PARTS_A_WORKER * workers, most))
    token, stop = uuid.uuid4().hex, StopSignal()
    _stops[token] = stop
    pool: Executor = executor
    futures: list[Future[int]] = []
    try:
        for number in range(1, count + 1):
            futures.append(pool.submit(_make_part, task, str(folder), (number, count), token))
        for done, future in enumerate(as_completed(futures), 1):
            future.result()
            if tell is not None:
                tell(done / count)
    except BaseException:
        stop.set()
        for future in futures:
            future.cancel()
        raise
    finally:
        del _stops[token]
    merge(folder)
    for path in folder.glob("*.part-*-of-*"):
        path.unlink()


def _made(
    task: Task,
    folder: Path,
    temporary: tempfile.TemporaryDirectory[str] | None,
    *,
    threads: int | None,
    executor: Any,
    parts: int | None,
    restart: bool,
    progress: Progress,
) -> Study:
    threads = None if threads is None else whole("threads", threads, 1, 1024)
    parts = None if parts is None else whole("parts", parts, 1, 2**32 - 1)
    folder = Path(os.path.abspath(folder))
    plan = _plan(task)
    with reporting(progress, plan.title()) as tell:
        if executor is None:
            plan.make(folder, (1, 1), threads, restart, None, tell)
        else:
            folder.mkdir(parents=True, exist_ok=True)
            for path in folder.glob("*.part-*-of-*") if restart else ():
                path.unlink()
            _by_parts(task, folder, parts, executor, tell)
    found = Study(_Folder(folder, temporary))
    warn(found.warnings)
    return found


def study(
    file: str | os.PathLike[str],
    *,
    out: str | os.PathLike[str] = "output",
    threads: int | None = None,
    executor: Any = None,
    parts: int | None = None,
    restart: bool = False,
    progress: Progress = None,
) -> Study:
    """Makes the runs of a study file and writes its files into `out`/<name of the file>, as `jeffcott study` does.

    On `threads` threads (one for each processor), the lock released; or in `parts` parts on an `executor`: any of
    `concurrent.futures` (threads, processes), or a client of Dask, whose workers see the same folder. The bytes of the
    files are the same however it is made. What Ctrl-C ends, the same call goes on with; `restart` begins anew.
    """
    folder = Path(out) / Path(file).stem
    task = (os.path.abspath(file),)
    return _made(
        task, folder, None, threads=threads, executor=executor, parts=parts, restart=restart, progress=progress
    )


def sweep(
    scenario: Scenario,
    axes: Mapping[str, Any],
    *,
    out: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    executor: Any = None,
    parts: int | None = None,
    progress: Progress = None,
    **settings: Any,
) -> Study:
    """Makes many runs of a scenario over the values of some of its keys.

    `axes` maps paths of keys to lists of values, or to keys of an `[[axis]]` of a study file:

        >>> sweep(s, {"speed.constant": ["300 rad/s", "400 rad/s"], "shaft.mass": ["5 kg", "6 kg"]})
        >>> sweep(s, {"speed.constant": {"from": "300 rad/s", "to": "900 rad/s", "count": 61}})
        >>> sweep(s, {"shaft.eccentricity": {"distribution": "uniform", "from": "2 um", "to": "15 um"}},
        ...       sampling="monte_carlo", runs=200, seed=1)

    Lists make a grid, the last key fastest. `settings` are the other keys of a study file: `ask`, `sampling`, `runs`, `seed`,
    `sweep`, `verify_every`, `cycles`, `keep`. Files go to `out`, or to a folder that goes with the result; `threads`,
    `executor` and `parts` are as in `study`.
    """
    listed = [
        {"key": text_of(key), **(values if isinstance(values, Mapping) else {"values": values})} for key, values in axes.items()
    ]
    text = dumped({"base": scenario.title, "axis": listed, **settings})
    task = (dumped(scenario.to_dict()), str(scenario.checked.place()), text)
    temporary = tempfile.TemporaryDirectory() if out is None else None
    folder = Path(temporary.name) / "sweep" if temporary is not None else Path(out or "")
    return _made(
        task, folder, temporary, threads=threads, executor=executor, parts=parts, restart=False, progress=progress
    )
