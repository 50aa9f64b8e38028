"""What a person must know is a Python warning, once each, at the line that asked."""

import pickle
import warnings
from pathlib import Path

import pytest
from conftest import short

import jeffcott as jc

FAST = "speed.constant"
"""At 60000 rpm the balls' inertia counts, and the speed is above the limit."""


def caught(record: list[warnings.WarningMessage]) -> list[str]:
    return [str(one.message) for one in record if issubclass(one.category, jc.ModelWarning)]


def test_a_scenario_and_its_answers_tell_every_warning_once(scenarios: Path) -> None:
    scenario = short(scenarios)
    with warnings.catch_warnings(record=True) as record:
        warnings.simplefilter("always")
        scenario[FAST] = "60000 rpm"
        found = scenario.bearing()
    reported = caught(record)
    assert scenario.warnings or found.warnings
    assert sorted(reported) == sorted(set(scenario.warnings) | set(found.warnings))
    assert all(one.filename == __file__ for one in record)


def test_an_answer_asked_again_tells_again(scenarios: Path) -> None:
    scenario = short(scenarios)
    for _ in range(2):
        with pytest.warns(jc.ModelWarning, match="limiting speed"):
            found = scenario.campbell("60000 rpm", count=3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = pickle.loads(pickle.dumps(found))
        copied = pickle.loads(pickle.dumps(scenario))
    assert again.warnings == found.warnings and copied.title == scenario.title


def test_warnings_can_be_exceptions(scenarios: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", jc.ModelWarning)
        with pytest.raises(jc.ModelWarning):
            short(scenarios).campbell("60000 rpm", count=3)


def test_a_bearing_tells_what_is_assumed_once() -> None:
    four = {"balls": 9, "ball_diameter": "7.94 mm", "pitch_diameter": "38.5 mm", "contact_angle": "0 deg"}
    with warnings.catch_warnings(record=True) as record:
        warnings.simplefilter("always")
        bearing = jc.Bearing(geometry=four)
        bearing.answer({"y": "-500 N"})
        bearing.answer({"y": "-600 N"})
    assert len([message for message in caught(record) if "groove" in message]) == 1


def test_studies_warn(scenarios: Path) -> None:
    with pytest.warns(jc.ModelWarning, match="run 0 and 1 more"):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            scenario = short(scenarios).with_({"time.settle": None, "output.window": "hann"})
        scenario.sweep({"shaft.mass": ["5 kg", "6 kg"]})
