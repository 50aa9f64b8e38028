"""Roller bearings answer as ball bearings do, and roller by roller cut into laminae."""

import math
from pathlib import Path

import numpy as np
import pytest

import jeffcott as jc

ROLLERS, LAMINAE = 13, 30
DIAMETER, PITCH_DIAMETER, SPEED = 7.5e-3, 46e-3, 2950 * math.tau / 60


@pytest.fixture
def motor(scenarios: Path) -> jc.Scenario:
    """A 6206 and cylindrical rollers."""
    return jc.Scenario(scenarios / "motor-6206-nu206.toml")


def test_laminae_add_up_to_their_rollers_and_these_to_the_force(motor: jc.Scenario) -> None:
    statics = motor.bearing()
    balls, laminae = statics.balls, statics.table("laminae")
    own = balls["bearing"] == 2
    loads = balls["inner_load_N"][own]
    assert own.sum() == ROLLERS
    assert set(laminae["bearing"]) == {2}
    by_lamina = laminae["load_N"].reshape(ROLLERS, LAMINAE)
    assert by_lamina.sum(axis=1) == pytest.approx(loads, rel=1e-12)
    # F = Σ Q (cos φ, sin φ), and nothing along z: the 6206 locates
    force = statics.summary["bearings"][1]["force"]
    azimuths = balls["azimuth_rad"][own]
    size = loads.max()
    assert force["force_x_N"] == pytest.approx(loads @ np.cos(azimuths), abs=1e-9 * size)
    assert force["force_y_N"] == pytest.approx(loads @ np.sin(azimuths), abs=1e-9 * size)
    assert force["force_z_N"] == 0.0
    # the shaft tilts: one end of a roller bears more than the other
    most = by_lamina[loads.argmax()]
    assert not np.allclose(most, most[::-1], rtol=1e-2)
    assert np.allclose(statics.stiffness, statics.stiffness.T, rtol=1e-9, atol=1.0)
    assert statics.residual < 1e-9


def test_lines_of_the_kinematics_are_those_of_the_geometry(motor: jc.Scenario) -> None:
    geometry = motor.bearing().summary["bearings"][1]["geometry"]
    assert (geometry["kind"], geometry["rollers"], geometry["laminae"]) == ("cylindrical", ROLLERS, LAMINAE)
    lines = motor.bearing().summary["bearings"][1]["ball_pass"]
    turns, ratio = SPEED / math.tau, DIAMETER / PITCH_DIAMETER
    assert lines["cage_Hz"] == pytest.approx(0.5 * turns * (1 - ratio))
    assert lines["outer_Hz"] == pytest.approx(0.5 * ROLLERS * turns * (1 - ratio))
    assert lines["inner_Hz"] == pytest.approx(0.5 * ROLLERS * turns * (1 + ratio))
    assert lines["spin_Hz"] == pytest.approx(0.5 * turns / ratio * (1 - ratio**2))


def test_a_run_holds_its_loads_and_knows_its_error(motor: jc.Scenario) -> None:
    motor.update({"time": {"duration": "0.08 s", "settle": "0.04 s"}, "integrator.tolerance": 1e-6})
    run = motor.run()
    assert run.error is not None
    assert run.error.relative < 1e-4
    assert np.all(run["bearing2_force_z_N"] == 0.0)
    # belt, fan and weight, and the thrust of 60 N on the ball bearing
    late = run.t > 0.04
    assert run["force_y_N"][late].mean() == pytest.approx(900 + 250, rel=0.05)
    assert run["bearing1_force_z_N"][late].mean() == pytest.approx(-60, rel=0.05)
    life = run.summary["bearings"][1]["life"]["after_settle"]["life_Mrev"]
    assert life > 0


def test_rollers_are_refused_as_in_files(motor: jc.Scenario) -> None:
    for changes, message in [
        ({"bearing[2].roller.laminae": 1}, "at least 4 and at most 500"),
        ({"bearing[2].roller.width": "6 mm"}, "more than the bearing is wide"),
        ({"bearing[2].roller.kind": "tapered", "bearing[2].roller.bore": None}, "must be above zero"),
        ({"bearing[2].roller.balls": 9}, "has no key `balls`"),
    ]:
        with pytest.raises(jc.ScenarioError, match=message):
            motor.with_(changes)


def test_rollers_of_the_catalogue_and_of_ratings_are_bearings() -> None:
    known = jc.catalogue()
    assert "NU206" in known and "7205C" in known
    # the line of the catalogue
    printed = {"bore": "30 mm", "outside_diameter": "62 mm", "width": "16 mm", "dynamic": "23.5 kN", "static": "21.5 kN"}
    rated = jc.Bearing.from_ratings(kind="cylindrical", pitch_diameter="46 mm", **printed)
    load = {"y": "-500 N"}
    radial = [one.stiffness(load)[1, 1] for one in (rated, jc.Bearing("NU206"))]
    assert radial[0] == pytest.approx(radial[1], rel=1e-9)
