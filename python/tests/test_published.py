"""The numbers that the crate is tested by, asked for from Python."""

import math

import numpy as np
import pytest

import jeffcott as jc

MICRO = 1e-6

# F_z N, δz µm, K_zz N/µm, K_xx N/µm, K_tilt N m/rad: separate implementations of Jones (1960), Harris & Kotzalas
PURE_THRUST = [
    ("200 N", 12.93681, 26.0396, 134.4104, 4901.82),
    ("1000 N", 31.97643, 59.2163, 213.4804, 11147.2),
]

# speed rad/s, period in ball passes, peak to peak of y and x in µm: JIS 6306, Fukata et al. (1985)
VARYING_COMPLIANCE = [("100 rad/s", 1, 0.0591, 0.8138), ("150 rad/s", 2, 0.2987, 1.9526), ("200 rad/s", 1, 0.3118, 1.1927)]

# as the crate's own test of that paper describes it
JIS_6306 = {
    "shaft": {"mass": "20 kg", "freedoms": "radial"},
    "bearing": [
        {
            "first_ball": "-90 deg",
            "geometry": {
                "balls": 8,
                "ball_diameter": "11.9062 mm",
                "pitch_diameter": "52 mm",
                "radial_clearance": "3 um",
                "contact_stiffness": "1.334e10 N/m^1.5",
            },
        }
    ],
    "damping": {"coefficients": {"x": "200 N s/m", "y": "200 N s/m"}},
    "load": [{"constant": {"y": "-196 N"}}],
    "time": {"duration": "1 s"},
    "output": {"samples_per_revolution": 1240},
}


@pytest.mark.parametrize(("thrust", "z", "k_zz", "k_xx", "k_tilt"), PURE_THRUST)
def test_pure_thrust(thrust: str, z: float, k_zz: float, k_xx: float, k_tilt: float) -> None:
    held = {"x": "0 m", "y": "0 m", "tilt_x": "0 rad", "tilt_y": "0 rad"}
    found = jc.Bearing("7205C").answer({"z": thrust}, displacement=held)
    assert found.equilibrium[2] / MICRO == pytest.approx(z, abs=5e-6)
    stiffness = found.stiffness
    assert stiffness[2, 2] * MICRO == pytest.approx(k_zz, abs=5e-5)
    assert stiffness[0, 0] * MICRO == pytest.approx(k_xx, abs=5e-5)
    assert stiffness[3, 3] == pytest.approx(k_tilt, rel=1e-5)
    assert found.residual < 1e-9
    loads = found.balls["inner_load_N"]
    assert len(loads) == 12
    assert np.ptp(loads) < 1e-9 * loads[0]


def test_a_preload_is_where_the_bearing_carries_it() -> None:
    held = jc.Bearing("7205C").answer(preload="200 N")
    assert held.force[2] == pytest.approx(200.0, rel=1e-9)
    # where the thrust of 200 N stands
    assert held.stiffness[2, 2] * MICRO == pytest.approx(26.0396, abs=5e-5)


@pytest.mark.parametrize(("speed", "period", "y", "x"), VARYING_COMPLIANCE)
def test_varying_compliance(speed: str, period: int, y: float, x: float) -> None:
    motion = jc.Scenario({**JIS_6306, "speed": {"constant": speed}}).steady()
    assert motion.stable
    assert motion.summary["multiple"] == period
    assert np.ptp(motion["y_m"]) / MICRO == pytest.approx(y, rel=1e-3)
    assert np.ptp(motion["x_m"]) / MICRO == pytest.approx(x, rel=1e-3)
    assert motion.error is not None
    assert motion.error.relative < 1e-5


def test_the_front_page_of_the_crate() -> None:
    scenario = jc.Scenario(
        {
            "shaft": {"mass": "5 kg", "eccentricity": "0.01 mm", "freedoms": "translational"},
            "speed": {"constant": "500 rad/s"},
            "bearing": [{"catalogue": "7205C"}],
            "damping": {"ratio": 0.02},
            "load": [{"constant": {"z": "1000 N"}}],
            "time": {"duration": "0.1 s"},
        }
    )
    run = scenario.run()
    assert 250 < run["largest_ball_load_N"].max() < 260
    assert run.error is not None and run.error.relative < 1e-7


def test_the_drive_shaft(steady_run: jc.Run) -> None:
    assert steady_run.error is not None
    assert steady_run.error.relative < 1e-7
    # 40 revolutions at 128 samples, and the start
    assert len(steady_run) == len(steady_run.t) == math.floor(0.5 * 500 / (2 * math.pi) * 128) + 1
    line = steady_run.peaks
    first = line["f_Hz"][(line["channel"] == "x") & (line["name"] == "1×")]
    assert first == pytest.approx(500 / (2 * math.pi), rel=1e-6)


def test_critical_speeds_are_where_the_orders_cross() -> None:
    scenario = jc.Scenario(
        {
            "shaft": {"mass": "5 kg", "freedoms": "translational"},
            "speed": {"constant": "500 rad/s"},
            "bearing": [{"catalogue": "7205C"}],
            "load": [{"constant": {"z": "1000 N"}}],
        }
    )
    found = scenario.campbell("60000 rpm")
    stiffness = scenario.bearing().stiffness
    axial = math.sqrt(stiffness[2, 2] / 5.0)
    speeds = [critical["speed_rad_s"] for critical in found.critical_speeds]
    assert min(abs(speed / axial - 1) for speed in speeds) < 1e-9
    assert set(found.modes) >= {"speed_rad_s", "frequency_Hz", "damping_ratio", "whirl"}
