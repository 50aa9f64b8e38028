"""Studies have the same bytes however they are made."""

from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from conftest import short

import jeffcott as jc

STUDY = """
title = "eccentricity"
base = "steady-7205c.toml"
sampling = "latin_hypercube"
runs = 9
seed = 3
verify_every = 4
[[axis]]
key = "shaft.eccentricity"
distribution = "uniform"
from = "2 um"
to = "15 um"
[[set]]
key = "time.duration"
value = "0.05 s"
[[set]]
key = "time.settle"
value = "0.02 s"
[[set]]
key = "integrator.tolerance"
value = 1e-6
"""


@pytest.fixture(scope="module")
def study_file(tmp_path_factory: pytest.TempPathFactory, scenarios: Path) -> Path:
    folder = tmp_path_factory.mktemp("study")
    (folder / "steady-7205c.toml").write_text((scenarios / "steady-7205c.toml").read_text(encoding="utf-8"))
    file = folder / "eccentricity.toml"
    file.write_text(STUDY)
    return file


@pytest.fixture(scope="module")
def whole(study_file: Path, tmp_path_factory: pytest.TempPathFactory) -> jc.Study:
    return jc.study(study_file, out=tmp_path_factory.mktemp("whole"), threads=1)


def processes() -> ProcessPoolExecutor:
    return ProcessPoolExecutor(2, mp_context=get_context("spawn"))


def test_a_study_is_written_where_it_stands(whole: jc.Study) -> None:
    before = {path: path.read_bytes() for path in whole.folder.iterdir()}
    assert {path.resolve() for path in whole.write(whole.folder)} == {path.resolve() for path in before}
    assert all(path.read_bytes() == content for path, content in before.items())
    assert list(whole) == list(whole.runs) and "status" in whole


def test_a_study_has_a_row_a_run(whole: jc.Study) -> None:
    assert whole.runs.rows == 9
    assert list(whole["status"]) == ["done"] * 9
    assert 2e-6 <= whole["shaft_eccentricity_m"].min() <= whole["shaft_eccentricity_m"].max() <= 15e-6
    # the amplitude at the shaft's frequency follows the unbalance
    ratio = whole["x_order_1_m"] / whole["shaft_eccentricity_m"]
    assert np.ptp(ratio) < 0.01 * ratio.mean()
    assert whole.error is not None and whole.error.relative < 1e-4
    assert whole.digest["runs"] == 9
    assert whole.figures == ["response"]
    assert whole.figure().svg.startswith("<svg")
    assert "9 runs, 0 of them failed" in str(whole)


@pytest.mark.parametrize("pool", [lambda: ThreadPoolExecutor(2), processes], ids=["threads", "processes"])
def test_parts_make_the_same_bytes(
    pool: Callable[[], Executor], study_file: Path, whole: jc.Study, tmp_path: Path
) -> None:
    reported: list[float] = []
    with pool() as executor:
        parted = jc.study(study_file, out=tmp_path, executor=executor, parts=4, progress=reported.append)
    same_bytes(whole, parted)
    assert reported[-1] == 1.0 and reported == sorted(reported)


def test_threads_make_the_same_bytes(study_file: Path, whole: jc.Study, tmp_path: Path) -> None:
    same_bytes(whole, jc.study(study_file, out=tmp_path, threads=2))


def test_a_client_of_dask_makes_the_same_bytes(study_file: Path, whole: jc.Study, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    with distributed.Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        same_bytes(whole, jc.study(study_file, out=tmp_path, executor=client, parts=3))


def same_bytes(one: jc.Study, other: jc.Study) -> None:
    names = sorted(path.name for path in one.folder.iterdir())
    assert sorted(path.name for path in other.folder.iterdir()) == names
    for name in names:
        assert (one.folder / name).read_bytes() == (other.folder / name).read_bytes(), name


def test_a_part_that_stands_is_not_made_again(study_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from jeffcott import _study

    folder = tmp_path / "eccentricity"
    _study._make_part((str(study_file),), str(folder), (1, 3), "")
    rows = folder / "runs.part-1-of-3.jsonl"
    # a row that was made anew would not say so
    marked = rows.read_text().replace('"direction":"alone"', '"direction":"up"')
    rows.write_text(marked)
    _study._make_part((str(study_file),), str(folder), (1, 3), "")
    assert rows.read_text() == marked


def test_a_wrong_study_tells_its_problems(tmp_path: Path, scenarios: Path) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text(f'base = "{scenarios / "steady-7205c.toml"}"\n[[axis]]\nkey = "shaft.mas"\nvalues = ["5 kg"]\n')
    with pytest.raises(jc.ScenarioError) as caught:
        jc.study(file, out=tmp_path)
    assert caught.value.problems[0].key == "axis[1].key"
    assert caught.value.problems[0].line == 3
    with pytest.raises(jc.ScenarioError, match="a scenario, not a study"):
        jc.study(scenarios / "steady-7205c.toml", out=tmp_path)


def test_a_sweep_needs_no_file(scenarios: Path, tmp_path: Path) -> None:
    scenario = short(scenarios)
    masses = ["4 kg", "5 kg", "6 kg"]
    found = jc.sweep(scenario, {"shaft.mass": masses, "damping.ratio": np.array([0.02, 0.04])}, threads=2)
    assert list(found["shaft_mass_kg"]) == [4, 4, 5, 5, 6, 6]
    assert list(found["damping_ratio"]) == [0.02, 0.04] * 3
    alone = scenario.with_({"shaft.mass": "6 kg", "damping.ratio": 0.04}).run()
    behind = alone["x_m"][alone.t >= 0.02]
    assert found["x_peak_to_peak_m"][-1] == pytest.approx(np.ptp(behind), rel=1e-3)
    with ThreadPoolExecutor(2) as executor:
        axes = {"shaft.mass": {"from": "4 kg", "to": "6 kg", "count": 3}}
        kept = scenario.sweep(axes, keep={"numbers": ["x_rms_m"]}, out=tmp_path / "kept", executor=executor)
    assert list(kept.runs)[:4] == ["run", "direction", "shaft_mass_kg", "x_rms_m"]
    assert (tmp_path / "kept" / "runs.csv").exists()
    with pytest.raises(jc.ScenarioError, match="no number"):
        scenario.sweep({"shaft.mas": masses})


def test_a_study_that_is_no_study_of_runs(scenarios: Path) -> None:
    with pytest.raises(jc.ScenarioError):
        short(scenarios).sweep({"shaft.mass": ["4 kg"]}, sampling="monte_carlo")


def test_a_sweep_asks_where_the_shaft_stands(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "bearing-7205c.toml")
    found = scenario.sweep({"load[1].constant.z": ["500 N", "1000 N"]}, ask="bearing", keep={"positions": 16})
    alone = scenario.with_({"load[1].constant.z": "500 N"}).bearing()
    assert found["stiffness_z_N_m"][0] == alone.summary["stiffness"]["named"]["stiffness_z_N_m"]
    around = found.table("around")
    assert list(around["run"]) == 16 * [0] + 16 * [1] and list(around["position"][:3]) == [1, 2, 3]
    assert {"stiffness", "deformation", "contact_angle"} <= set(found.figures)
