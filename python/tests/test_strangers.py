"""What nobody means to ask is refused in words, and results go to other processes."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import jeffcott as jc

from conftest import short


@pytest.mark.parametrize("count", [10**9, 10**30, 100_001, 1, 0, -3, 2.5, True])
def test_a_count_of_speeds_is_that_of_the_command(scenarios: Path, count: object) -> None:
    with pytest.raises(ValueError, match="^count: "):
        short(scenarios).campbell("6000 rpm", count=count)  # type: ignore[arg-type]


@pytest.mark.parametrize("wrong", [-1.0, 0.0, float("nan"), 2.0])
def test_tolerances_are_those_of_the_command(scenarios: Path, wrong: float) -> None:
    with pytest.raises(jc.ScenarioError, match="tolerance"):
        short(scenarios).accuracy(tolerances=[wrong])
    with pytest.raises(jc.ScenarioError, match="tolerance"):
        short(scenarios).run(tolerance=wrong)


def test_points_periods_threads_and_parts(scenarios: Path, tmp_path: Path) -> None:
    scenario = short(scenarios)
    for settings in ({"points": 0}, {"points": -1}, {"period": 0}, {"period": 65}):
        with pytest.raises(ValueError, match="is not in 1"):
            scenario.response("speed.constant", "500 rad/s", "510 rad/s", **settings)
    with pytest.raises(ValueError, match="^period: 0 is not in 1..=64"):
        scenario.steady(period=0)
    for settings in ({"threads": 0}, {"threads": 10**6}, {"parts": -1}):
        with pytest.raises(ValueError, match="is not in 1"):
            scenario.sweep({"shaft.mass": ["5 kg"]}, out=tmp_path, **settings)
    with pytest.raises(ValueError, match="^worst: 0"):
        jc.compare(tmp_path, tmp_path, worst=0)


def test_text_that_is_none_and_what_is_too_deep(scenarios: Path) -> None:
    scenario = short(scenarios)
    half = "\ud800"
    asked = [
        lambda: jc.Scenario({"title": half}),
        lambda: jc.Scenario(f"title = '{half}'\n"),
        lambda: scenario.with_({"title": half}),
        lambda: scenario.with_({half: "1 N"}),
        lambda: scenario.campbell(half),
        lambda: scenario.response(half, "1 N", "2 N"),
        lambda: scenario.accuracy(methods=[half]),
        lambda: jc.Bearing(half),
    ]
    for ask in asked:
        with pytest.raises(jc.ScenarioError, match="surrogate"):
            ask()
    for depth in (200, 100_000):
        for wrap in (lambda inner: [inner], lambda inner: {"a": inner}):
            deep: object = 1
            for _ in range(depth):
                deep = wrap(deep)
            with pytest.raises(jc.ScenarioError):
                jc.Scenario({"shaft": deep})
    itself: dict[str, object] = {}
    itself["shaft"] = itself
    with pytest.raises(jc.ScenarioError, match="itself"):
        jc.Scenario(itself)


def assert_same(first: jc.Result, second: jc.Result) -> None:
    assert type(first) is type(second)
    assert first.summary == second.summary
    assert first.warnings == second.warnings and repr(first.error) == repr(second.error)
    # a copy of a study has its files in a folder of its own
    assert str(first).rsplit(";", 1)[0] == str(second).rsplit(";", 1)[0]
    assert first.tables == second.tables and first.figures == second.figures
    for name in first.tables:
        for column, values in first.table(name).items():
            np.testing.assert_array_equal(values, second.table(name)[column])
    for name in first.figures:
        assert first.figure(name).svg == second.figure(name).svg


def test_results_are_copied_and_pickled(scenarios: Path, tmp_path: Path) -> None:
    scenario = short(scenarios)
    run = scenario.run()
    results = [run, scenario.bearing(), scenario.campbell("3000 rpm", count=3), scenario.sweep({"shaft.mass": ["5 kg", "6 kg"]})]
    for result in results:
        for other in (copy.copy(result), copy.deepcopy(result), pickle.loads(pickle.dumps(result))):
            assert_same(result, other)
            assert_same(result, pickle.loads(pickle.dumps(other)))
    again = pickle.loads(pickle.dumps(run))
    np.testing.assert_array_equal(again["y_acceleration_m_s2"], run["y_acceleration_m_s2"])
    asked = {"scaling": "rms", "window": "hann"}
    for column, values in run.spectrum("y_acceleration", **asked).items():
        np.testing.assert_array_equal(values, again.spectrum("y_acceleration", **asked)[column])
    for path in run.write(tmp_path / "run"):
        written = {one.name: one.read_bytes() for one in again.write(tmp_path / "again")}
        assert written[path.name] == path.read_bytes()


def test_warnings_are_those_of_the_documents(scenarios: Path) -> None:
    scenario = short(scenarios).with_({"time.settle": None, "output.window": "hann"})
    [warning] = scenario.warnings
    assert warning.startswith("no `settle`")
    for result in (scenario.run(), scenario.bearing(), scenario.steady(), scenario.campbell("3000 rpm", count=3)):
        assert result.warnings[0] == warning
        assert result.summary["warnings"] == result.warnings
    assert scenario.sweep({"shaft.mass": ["5 kg", "6 kg"]}).warnings[0] == f"run 0 and 1 more: {warning}"
