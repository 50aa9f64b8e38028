"""Scenarios are read, changed and refused as files are."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import LINEAR

import jeffcott as jc

TEXT = """
[shaft]
mass = "5 kg"
freedoms = "translational"
[speed]
constant = "500 rad/s"
[[bearing]]
catalogue = "7205C"
[[load]]
constant = { z = "1000 N" }
"""


def test_file_text_and_dict_say_the_same(scenarios: Path) -> None:
    file = jc.Scenario(scenarios / "steady-7205c.toml")
    text = jc.Scenario((scenarios / "steady-7205c.toml").read_text(encoding="utf-8"))
    tree = jc.Scenario(file.to_dict())
    assert file.defaults == text.defaults == tree.defaults
    assert file.title == "7205C drive shaft, 500 rad/s, 1000 N axial"


def test_keys_are_read_with_their_defaults_and_set_with_their_units(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    assert scenario["bearing[1].catalogue"] == "7205C"
    assert scenario["bearing[1].position"] == "0 m"
    assert "damping.stiffness_time" not in scenario
    scenario["shaft.mass"] = "6 kg"
    assert scenario["shaft.mass"] == "6 kg"
    scenario["load[2]"] = {"constant": {"y": "-50 N"}}
    assert len(scenario["load"]) == 2
    del scenario["load[2]"]
    assert len(scenario["load"]) == 1
    other = scenario.with_({"damping.ratio": None, "damping.stiffness_time": "10 us"})
    assert "damping.ratio" not in other
    assert scenario["damping.ratio"] == 0.02


def test_a_wrong_key_tells_the_nearest_one_and_changes_nothing(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    with pytest.raises(jc.ScenarioError) as caught:
        scenario["shaft.mas"] = "6 kg"
    [problem] = caught.value.problems
    assert problem.key == "shaft.mas"
    assert "`mass`" in str(problem.hint)
    assert "steady-7205c.changed" in str(caught.value)
    assert '"mas": "6 kg"' in str(caught.value)
    assert "shaft.mas" not in scenario
    with pytest.raises(jc.ScenarioError, match="needs a unit"):
        scenario["shaft.mass"] = 6
    assert scenario["shaft.mass"] == "5 kg"


def test_all_problems_come_at_once_with_their_lines() -> None:
    wrong = TEXT.replace('"5 kg"', "5").replace("7205C", "7205D")
    with pytest.raises(jc.ScenarioError) as caught:
        jc.Scenario(wrong)
    problems = caught.value.problems
    assert [(problem.key, problem.line) for problem in problems] == [
        ("shaft.mass", 3),
        ("bearing[1].catalogue", 8),
    ]
    assert isinstance(caught.value, ValueError)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == problems
    assert str(again) == str(caught.value)


def test_a_file_that_is_missing() -> None:
    with pytest.raises(jc.ScenarioError, match="cannot read the file") as caught:
        jc.Scenario("nowhere.toml")
    assert caught.value.problems[0].line is None


def test_a_path_that_leads_nowhere(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    for path in ("load[0].constant.z", "load[4].constant.x", "shaft.mass.x", "title[1]"):
        with pytest.raises(jc.ScenarioError) as caught:
            scenario[path] = "1 N"
        assert caught.value.problems[0].key == path
    with pytest.raises(jc.ScenarioError, match="no path"):
        scenario["load[1]..z"] = "1 N"
    with pytest.raises(KeyError):
        scenario["load[4]"]


def test_a_scenario_without_time_does_not_run() -> None:
    scenario = jc.Scenario(TEXT)
    with pytest.raises(jc.ScenarioError, match=r"no \[time\]"):
        scenario.run()
    assert scenario.bearing().stiffness.shape == (5, 5)


def test_a_scene_that_fails_says_why() -> None:
    scenario = jc.Scenario(
        TEXT + '[time]\nduration = "0.1 s"\n[[load]]\nshock = { peak = { y = "1e9 N" }, at = "0.01 s", duration = "5 ms" }\n'
    )
    with pytest.raises(jc.RunError, match="check the loads"):
        scenario.run()


def test_files_of_a_dict_are_looked_for_in_its_folder(tmp_path: Path) -> None:
    (tmp_path / "force.csv").write_text("t_s,x_N\n0,0\n0.1,10\n")
    tree = jc.Scenario(TEXT).to_dict()
    tree["load"].append({"series": {"file": "force.csv"}})
    assert jc.Scenario(tree, folder=tmp_path)["load[2].series.file"] == "force.csv"
    with pytest.raises(jc.ScenarioError):
        jc.Scenario(tree)


def test_parts_of_a_scenario_are_read_only() -> None:
    scenario = jc.Scenario(LINEAR)
    other = scenario.copy()
    stiffness = other["element"][0]["linear"]["stiffness"]
    for change in (
        lambda: stiffness.update(x="3e6 N/m"),
        lambda: other["shaft"].__setitem__("mass", "9 kg"),
        lambda: other["element"].append(stiffness),
    ):
        with pytest.raises(TypeError, match="read only"):
            change()
    assert other["shaft"] == LINEAR["shaft"] and other["element"] == LINEAR["element"]
    # by its own keys one changes, and not the other
    other["element[1].linear.stiffness.x"] = "3e6 N/m"
    assert [one.bearing().stiffness[0, 0] for one in (scenario, other)] == pytest.approx([1e6, 3e6])
    changed = copy.deepcopy(other["element"])
    changed[0]["linear"]["stiffness"]["x"] = "4e6 N/m"
    other["element"] = [*other["element"], *changed]
    assert other["element[1].linear.stiffness.x"] == "3e6 N/m" and len(other["element"]) == 2
    # what is handed over stays as it is
    own = {"linear": {"stiffness": {"x": "1 N/um", "y": "1 N/um"}}}
    for given in (own, other["element[2]"]):
        other.update({"element[3]": given, "element[3].linear.stiffness.x": "5e6 N/m"})
        assert other["element[3].linear.stiffness.x"] == "5e6 N/m"
    assert own["linear"]["stiffness"]["x"] == "1 N/um" and other["element[2].linear.stiffness.x"] == "4e6 N/m"


def test_a_scenario_is_gone_over_by_its_tables() -> None:
    scenario = jc.Scenario(LINEAR)
    assert list(scenario) == scenario.keys() == list(LINEAR) and len(scenario) == len(LINEAR)
    assert dict(scenario) == LINEAR


def test_files_are_found_from_another_current_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "force.csv").write_text("t_s,x_N\n0,0\n2,10\n")
    monkeypatch.chdir(tmp_path)
    tree = {**LINEAR, "load": [{"series": {"file": "force.csv"}}]}
    scenario = jc.Scenario(tree)
    monkeypatch.chdir(tmp_path / "elsewhere")
    heavier = scenario.with_({"shaft.mass": "6 kg"})
    assert scenario.bearing().sensitivity("element[1].linear.stiffness.x").rows > 0
    assert pickle.loads(pickle.dumps(heavier)).with_({"shaft.mass": "5 kg"}).defaults == scenario.defaults
    assert scenario.sweep({"shaft.mass": ["5 kg"]}, ask="bearing").runs.rows == 1


@pytest.mark.parametrize("number", [float("nan"), float("inf"), np.float32("-inf")])
def test_a_number_that_is_not_finite_is_named(number: float) -> None:
    scenario = jc.Scenario(LINEAR)
    with pytest.raises(jc.ScenarioError, match="finite") as caught:
        scenario.update({"integrator": {"tolerance": number}})
    assert caught.value.problems[0].key == "integrator.tolerance"
    with pytest.raises(jc.ScenarioError, match="finite") as caught:
        scenario.sweep({"integrator.tolerance": [1e-6, number]})
    assert caught.value.problems[0].key == "axis[1].values[2]"


def test_a_path_may_have_an_equals_sign(tmp_path: Path) -> None:
    path = tmp_path / "mass=5.toml"
    path.write_text(TEXT)
    assert jc.Scenario(str(path)).title == "mass=5"


def test_it_goes_to_another_process_and_back(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    scenario["shaft.mass"] = "7 kg"
    assert pickle.loads(pickle.dumps(scenario)).defaults == scenario.defaults


def test_a_bearing_is_checked_when_it_is_made() -> None:
    with pytest.raises(jc.ScenarioError, match="did you mean"):
        jc.Bearing("7205")
    assert "7205C" in jc.catalogue()


def test_a_bearing_by_its_ratings_is_that_of_the_catalogue() -> None:
    printed = {"bore": "40 mm", "outside_diameter": "80 mm", "dynamic": "29.1 kN", "static": "17.9 kN"}
    load = {"y": "-500 N", "z": "300 N"}
    found = jc.Bearing.from_ratings(**printed, f0=14.0, clearance_class="C3").stiffness(load)
    known = jc.Bearing("6208", clearance_class="C3").stiffness(load)
    assert abs(found[0, 0] / known[0, 0] - 1.0) < 1e-9
    with pytest.raises(jc.ScenarioError, match="no balls|does not belong|belong"):
        jc.Bearing.from_ratings(**{**printed, "static": "60 kN"})
