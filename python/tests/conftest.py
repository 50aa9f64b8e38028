"""What the tests share."""

import os
import shutil
from pathlib import Path

import pytest

import jeffcott as jc

ROOT = Path(__file__).resolve().parents[2]


LINEAR = {
    "title": "linear",
    "shaft": {"mass": "5 kg", "eccentricity": "10 um", "freedoms": "radial"},
    "speed": {"constant": "300 rad/s"},
    "element": [
        {
            "linear": {
                "stiffness": {"x": "1e6 N/m", "y": "2e6 N/m"},
                "damping": {"x": "100 N s/m", "y": "150 N s/m"},
            }
        }
    ],
    "time": {"duration": "1 s", "settle": "0.5 s"},
}
"""A shaft whose answers take some milliseconds."""


@pytest.fixture(scope="session")
def linear_run() -> jc.Run:
    return jc.Scenario(LINEAR).run()


@pytest.fixture(scope="session")
def scenarios() -> Path:
    return ROOT / "scenarios"


@pytest.fixture(scope="session")
def steady_run(scenarios: Path) -> jc.Run:
    return jc.Scenario(scenarios / "steady-7205c.toml").run()


@pytest.fixture(scope="session")
def command() -> str:
    """The command of the same sources, whose files are those of the package byte for byte."""
    found = os.environ.get("JEFFCOTT") or shutil.which("jeffcott")
    if found is None:
        pytest.skip("JEFFCOTT names no command to compare with")
    return found


def short(scenarios: Path) -> jc.Scenario:
    """A run of some milliseconds."""
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    scenario.update({"time": {"duration": "0.05 s", "settle": "0.02 s"}, "integrator.tolerance": 1e-6})
    return scenario
