"""Sensitivities and fits."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import jeffcott as jc

PAIR = {
    "title": "pair",
    "shaft": {"mass": "5 kg", "freedoms": "translational", "gravity": True},
    "speed": {"constant": "500 rad/s"},
    "bearing": [{"catalogue": "7205C", "arrangement": "back-to-back", "spacing": "40 mm", "preload": "200 N"}],
    "damping": {"ratio": 0.02},
}


def test_a_result_is_differentiated_by_keys_of_its_scenario() -> None:
    scenario = jc.Scenario(PAIR)
    result = pickle.loads(pickle.dumps(scenario.bearing()))
    table = result.sensitivity("bearing[1].preload")
    row = list(table["number"]).index("stiffness_z_N_m")
    stiffness = [
        scenario.with_({"bearing[1].preload": f"{force} N"}).bearing().stiffness[2, 2] for force in (199.0, 201.0)
    ]
    assert table["derivative"][row] == pytest.approx((stiffness[1] - stiffness[0]) / 2, rel=1e-4)
    with pytest.raises(jc.ScenarioError, match="did you mean"):
        result.sensitivity("bearing[1].prelaod")
    moving = scenario.with_({"shaft.eccentricity": "1 um", "time": {"duration": "0.3 s", "settle": "0.2 s"}})
    table = moving.run(verify=False).sensitivity("shaft.eccentricity")
    row = list(table["number"]).index("x_order_1_m")
    assert table["percent_per_percent"][row] == pytest.approx(1, abs=0.05)


def test_a_preload_is_found() -> None:
    scenario = jc.Scenario(PAIR)
    truth = scenario.with_({"bearing[1].preload": "310 N"}).bearing().stiffness
    observed = [
        {"number": f"stiffness_{axis}_N_m", "value": f"{truth[k, k]} N/m", "sigma": "2 %"}
        for k, axis in enumerate("xyz")
    ]
    asked = {"unknown": [{"key": "bearing[1].preload", "from": "50 N", "to": "900 N"}], "observation": observed}
    found = jc.fit(asked, scenario)
    assert found.values["bearing[1].preload"] == pytest.approx(310.0, rel=1e-6)
    assert 0 < found.standard_errors["bearing[1].preload"] < 30
    assert np.allclose(found.correlations, [[1.0]])
    assert np.allclose(found.scenario.bearing().stiffness, truth, rtol=1e-6)
    again = pickle.loads(pickle.dumps(found))
    assert again.values == found.values and len(again.observations["residual"]) == 3
    mass = {"key": "shaft.mass", "from": "3 kg", "to": "8 kg"}
    with pytest.raises(jc.ScenarioError, match="cannot tell"):
        jc.fit({"unknown": [*asked["unknown"], mass], "observation": observed[:1]}, scenario)


def test_what_a_fit_would_not_heed_is_refused() -> None:
    scenario = jc.Scenario(PAIR)
    with pytest.raises(ValueError, match="scenario"):
        jc.fit("fit.toml", scenario)
    for threads in (0, -1, True, 1.5):
        with pytest.raises(ValueError, match="threads"):
            jc.fit({"unknown": []}, scenario, threads=threads)
