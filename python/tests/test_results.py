"""Results have the columns, tables, figures and files of the command."""

import copy
import pickle
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import LINEAR, short

import jeffcott as jc


def test_columns_are_those_of_the_file(steady_run: jc.Run, tmp_path: Path) -> None:
    assert steady_run.keys()[:4] == ["t_s", "angle_rad", "speed_rad_s", "x_m"]
    assert steady_run["y_acceleration_m_s2"].dtype == np.float64
    assert np.array_equal(steady_run["x_m"], steady_run.trace["x_m"])
    assert steady_run.trace["balls_loaded"].dtype == np.int64
    with pytest.raises(KeyError, match="the columns are t_s"):
        steady_run["x"]
    with pytest.raises(KeyError, match="did you mean 'x_m'"):
        steady_run.trace["xm"]
    with pytest.raises(KeyError, match="did you mean 'spectrum'"):
        steady_run.table("spectra")


def test_the_summary_is_the_document(steady_run: jc.Run) -> None:
    error = steady_run.error
    assert error is not None
    assert error.displacement_m == steady_run.summary["measured_error"]["displacement_m"]
    assert error.reference_tolerance == pytest.approx(1e-9)
    assert "equilibrium" in str(steady_run)
    assert "<svg" in steady_run._repr_html_()
    assert steady_run.figure("spectrum")._repr_svg_().startswith("<svg")
    assert set(steady_run.figures) == {"trace", "spectrum", "orbit"}
    with pytest.raises(KeyError, match="no figure"):
        steady_run.figure("waterfall")


def test_tolerance_and_second_pass_can_be_chosen(scenarios: Path) -> None:
    scenario = short(scenarios)
    tight, bare = scenario.run(tolerance=1e-9), scenario.run(verify=False)
    assert tight.error is not None
    assert tight.error.reference_tolerance == pytest.approx(1e-10)
    assert bare.error is None
    assert scenario["integrator.tolerance"] == 1e-6


@pytest.mark.parametrize("name", ["steady-7205c", "run-up-7205c", "coal-impact-7205c"])
def test_a_run_writes_the_bytes_of_the_command(name: str, scenarios: Path, tmp_path: Path, command: str) -> None:
    file = scenarios / f"{name}.toml"
    subprocess.run([command, "run", file, "--out", tmp_path / "command"], check=True, capture_output=True)
    run = jc.Scenario(file).run()
    written = run.write(tmp_path / "package")
    theirs = sorted((tmp_path / "command" / name).iterdir())
    assert sorted(path.name for path in written) == [path.name for path in theirs]
    for path in theirs:
        assert (tmp_path / "package" / path.name).read_bytes() == path.read_bytes(), path.name
    # tables and figures in memory are those of the files
    for path in theirs:
        if path.suffix == ".svg":
            assert run.figure(path.stem).svg == path.read_text(encoding="utf-8")
        if path.suffix == ".csv":
            header = path.read_text(encoding="utf-8").partition("\n")[0]
            assert list(run.table(path.stem)) == header.split(",")


def test_answers_write_the_bytes_of_the_command(scenarios: Path, tmp_path: Path, command: str) -> None:
    file = scenarios / "steady-7205c.toml"
    scenario = jc.Scenario(file)
    asked: dict[str, tuple[list[str], jc.Result]] = {
        "bearing": ([], scenario.bearing()),
        "steady": ([], scenario.steady()),
        "campbell": (["--to", "60000 rpm"], scenario.campbell("60000 rpm")),
        "matrices": (["--speed", "3000 rpm"], scenario.matrices("3000 rpm")),
        "response": (
            ["--at", "0 mm", "--from", "500 rpm", "--to", "9000 rpm"],
            scenario.frequency_response("0 mm", "500 rpm", "9000 rpm"),
        ),
    }
    for verb, (options, answer) in asked.items():
        subprocess.run([command, verb, file, *options, "--out", tmp_path / verb], check=True, capture_output=True)
        answer.write(tmp_path / f"{verb}-package")
        for path in (tmp_path / verb / "steady-7205c").iterdir():
            assert (tmp_path / f"{verb}-package" / path.name).read_bytes() == path.read_bytes(), path.name


def test_matrices_answer_what_the_shaft_answers(scenarios: Path, tmp_path: Path) -> None:
    scenario = jc.Scenario(scenarios / "flexible-spindle-7205c.toml")
    scenario["shaft.modes"] = 12
    found = scenario.matrices("9000 rpm", at="100 mm")
    size = len(found.coordinates)
    assert found.speed == pytest.approx(300 * np.pi) and len(found.units) == size
    # frequencies of the damped vibration are the imaginary parts of the eigenvalues of A
    modes = scenario.campbell("9000 rpm", start="8000 rpm", count=2, highest_frequency="2 kHz").modes
    eigenvalues = np.linalg.eigvals(found.A)
    frequencies = modes["frequency_Hz"][modes["speed_rad_s"] > 290 * np.pi]
    assert len(frequencies) >= 4
    for frequency in frequencies:
        assert np.abs(eigenvalues.imag / (2 * np.pi) - frequency).min() < 1e-6 * frequency
    # and so is the response to a force that of M, C, G and K, but for the error of the modes that they lack
    at = found.coordinates.index("y of the shaft at 100.0 mm")
    response = scenario.frequency_response("y@100 mm", "10 Hz", "900 Hz", by="y@100 mm", speed="9000 rpm", count=5)
    error = response.summary["reduction_error"]
    assert error < 1e-4
    for frequency, receptance in zip(response.over, response["y_1"], strict=True):
        w = 2 * np.pi * frequency
        dynamic = found.K - w**2 * found.M + 1j * w * (found.C + found.speed * found.G)
        assert abs(np.linalg.inv(dynamic)[at, at] - receptance) < 1.01 * error * abs(receptance)
    found.write(tmp_path)
    with np.load(tmp_path / "matrices.npz") as file:
        for name in "MCGKA":
            assert np.array_equal(file[name], getattr(found, name)), name
        assert list(file["coordinates"]) == found.coordinates and list(file["units"]) == found.units
    assert np.array_equal(np.loadtxt(tmp_path / "state_matrix.csv", delimiter=",", skiprows=1), found.A)


def test_tilts_answer_moments(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "flexible-spindle-7205c.toml")
    asked = {"start": "10 Hz", "stop": "900 Hz", "speed": "0 rpm", "count": 3}
    tilt = scenario.frequency_response("tilt_x@100 mm", by="y@50 mm", **asked)
    motion = scenario.frequency_response("y@50 mm", by="tilt_x@100 mm", **asked)
    assert [own["unit"] for own in (tilt.summary["at"][0], motion.summary["at"][0])] == ["rad/N", "m/(N m)"]
    assert np.allclose(tilt["tilt_x_1"], motion["y_1"], rtol=1e-6, atol=0)


def test_a_motion_is_followed_along_a_key(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "varying-compliance-6306.toml")
    found = scenario.response("speed.constant", "198 rad/s", "200 rad/s", doubled=False)
    values = found.points["speed_constant_rad_s"]
    assert values.min() == pytest.approx(198) and values.max() == pytest.approx(200)
    assert found.points["stable"].dtype == np.int64
    with pytest.raises(jc.ScenarioError, match="no number"):
        scenario.response("speed.const", "190 rad/s", "200 rad/s")
    with pytest.raises(ValueError, match="same value"):
        scenario.response("speed.constant", "190 rad/s", "190 rad/s")


def test_a_run_up_has_its_maps(scenarios: Path) -> None:
    run = jc.Scenario(scenarios / "run-up-7205c.toml").run(tolerance=1e-6)
    waterfall = run.table("waterfall")
    assert list(waterfall)[:3] == ["t_s", "speed_rad_s", "f_Hz"]
    assert run.table("order_tracks").rows > 10
    assert {"waterfall", "order_tracks", "campbell"} <= set(run.figures)


def test_a_run_up_that_is_too_short_for_maps_draws_none(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "run-up-7205c.toml")
    scenario.update({"speed.over": "1 ms", "time": {"duration": "2 ms"}})
    run = scenario.run(tolerance=1e-6)
    for name in run.figures:
        assert run.figure(name).svg
    assert "trace" in run.figures
    empty = [name for name in ("waterfall", "order_tracks") if run.table(name).rows == 0]
    assert empty and not set(empty) & set(run.figures)


def test_accuracy_is_measured(scenarios: Path) -> None:
    found = short(scenarios).accuracy(methods=["verner76"], tolerances=[1e-6, 1e-4], longest="2 s")
    assert list(found.methods["tolerance"]) == [1e-4, 1e-6]
    errors = found.methods["error_displacement_relative"]
    assert errors[1] < errors[0]
    assert found.error.relative < 1e-7
    with pytest.raises(jc.ScenarioError, match="method"):
        short(scenarios).accuracy(methods=["euler"])


def test_spectra_are_estimated_from_the_samples(steady_run: jc.Run) -> None:
    amplitude = steady_run.spectrum()["x_amplitude_m"]
    rms = steady_run.spectrum("x", scaling="rms", window="rectangular")["x_rms_m"]
    # the record of the run ends with the settle time that its own spectrum leaves out, too
    assert rms.max() == pytest.approx(amplitude[1:].max() / np.sqrt(2), rel=1e-9)
    with pytest.raises(jc.ScenarioError, match="y_accelerations"):
        steady_run.spectrum("y_accelerations")


def test_results_are_compared(steady_run: jc.Run, scenarios: Path, tmp_path: Path) -> None:
    steady_run.write(tmp_path / "one")
    same = jc.compare(tmp_path / "one", steady_run)
    assert same and same.agrees
    heavier = jc.Scenario(scenarios / "steady-7205c.toml").with_({"shaft.mass": "6 kg"}).run()
    differs = jc.compare(steady_run, heavier, relative=1e-3)
    assert not differs
    assert "x_m" in str(differs)
    with pytest.raises(FileNotFoundError):
        jc.compare(tmp_path / "two", tmp_path / "one")
    with pytest.raises(ValueError):
        jc.compare(tmp_path / "one", tmp_path / "one", relative=-1.0)


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -1.0])
def test_lines_do_not_agree_without_bounds(wrong: float, linear_run: jc.Run) -> None:
    for allowed in ({"decibels": wrong}, {"reach": wrong}, {"decibels": wrong, "reach": 0.1}):
        with pytest.raises(ValueError, match="finite"):
            jc.compare(linear_run, linear_run, lines=3, **allowed)
    with pytest.raises(ValueError, match="lines"):
        jc.compare(linear_run, linear_run, decibels=1.0)
    heavier = jc.Scenario(LINEAR).with_({"shaft.mass": "5.1 kg"}).run()
    assert not jc.compare(linear_run, heavier, lines=3, decibels=0.01)
    assert jc.compare(linear_run, heavier, lines=3, decibels=20.0, reach=0.1)


def test_columns_are_those_that_the_machine_has(linear_run: jc.Run) -> None:
    assert linear_run.keys() == list(linear_run) and "x_acceleration_m_s2" in linear_run
    assert np.array_equal(dict(linear_run)["element1_force_x_N"], linear_run["element1_force_x_N"])
    assert all(np.isfinite(linear_run[column]).all() for column in linear_run)
    # there is no bearing, and one element
    for column in ("bearing1_force_x_N", "bearing7_force_x_N", "element2_force_x_N", "kinetic_J", "x"):
        assert column not in linear_run
        with pytest.raises(KeyError, match="element1_force_x_N"):
            linear_run[column]
    again = pickle.loads(pickle.dumps(linear_run))
    assert again.keys() == linear_run.keys()


def test_columns_of_other_results_have_names() -> None:
    scenario = jc.Scenario(LINEAR)
    steady = scenario.steady()
    assert "x_m" in steady and "x" not in steady and list(steady) == list(steady.trace)
    response = scenario.frequency_response("0 mm", "100 rpm", "500 rpm", count=3)
    assert list(response) == ["x_1", "y_1"]
    assert all(np.iscomplexobj(column) for column in dict(response).values())


def test_results_cannot_be_changed(linear_run: jc.Run) -> None:
    steady = jc.Scenario(LINEAR).steady()
    for result in (steady, copy.deepcopy(steady), pickle.loads(pickle.dumps(steady))):
        with pytest.raises(TypeError, match="read only"):
            result.summary["stable"] = False
        with pytest.raises(ValueError, match="read-only"):
            result.trace["x_m"][0] = 1.0
        assert result.stable
    values = np.zeros(3)
    table = jc.Table("own", [("x", values)])
    values[0] = 1.0  # the array of the caller stays one that can be changed
    assert table["x"][0] == 1.0
    columns = linear_run["x_m"], linear_run["x_m"]
    columns[0][:] = 0.0
    assert np.abs(columns[1]).max() > 0.0


def test_tables_are_equal_by_their_columns(linear_run: jc.Run) -> None:
    trace = linear_run.trace
    assert trace == jc.Table("other", list(trace.items())) and not trace != trace
    assert trace != jc.Table("trace", list(trace.items())[1:]) and trace != linear_run.peaks
    assert jc.Table("a", [("x", [1.0])]) != jc.Table("a", [("x", ["1.0"])])


def test_words_of_a_table_without_rows_are_words(linear_run: jc.Run) -> None:
    assert linear_run.events.rows == 0
    assert linear_run.events["event"].dtype.kind == "U"


def test_questions_that_say_nothing_are_refused() -> None:
    scenario = jc.Scenario(LINEAR)
    with pytest.raises(ValueError, match="`by`"):
        scenario.frequency_response("0 mm", "1 Hz", "5 Hz", speed="5 rpm")
    with pytest.raises(jc.ScenarioError, match="no place"):
        scenario.frequency_response([], "100 rpm", "500 rpm")
    with pytest.raises(ValueError, match="tolerances"):
        scenario.accuracy(tolerances=[])


def test_a_shaft_that_bends_is_drawn(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "laval-rotor.toml")
    assert "deflection" in scenario.bearing().figures
    campbell = scenario.campbell("3000 rpm", count=5)
    assert "mode_shapes" in campbell.figures
    assert all(critical["reduction_error"] < 1e-4 for critical in campbell.critical_speeds)


def test_a_spectrum_of_the_scenario_is_found_by_its_name(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "spall-outer-6205.toml")
    scenario.update({"time.duration": "0.4 s", "integrator": {"tolerance": 1e-5, "verify": False}})
    run = scenario.run()
    envelope = run.spectrum("envelope")
    assert envelope.name == "spectrum_envelope"
    assert np.array_equal(envelope["f_Hz"], run.table("spectrum_envelope")["f_Hz"])
    with pytest.raises(jc.ScenarioError) as caught:
        run.spectrum("envelop")
    assert "'envelope'" in caught.value.__notes__[0]


def test_static_answers_state_how_far_they_are_off(scenarios: Path) -> None:
    found = jc.Bearing("7205C").answer({"z": "1 kN"})
    error = found.error
    assert 0 <= error.relative < 1e-9 and 0 <= error.displacement_m < 1e-13
    # the step that is left is that of the unbalanced force
    assert error.displacement_m <= 1.01 * error.relative * 1e3 / found.stiffness[2, 2] + 1e-18


def test_critical_speeds_state_their_error(scenarios: Path) -> None:
    found = jc.Scenario(scenarios / "laval-rotor.toml").campbell("3000 rpm", count=5)
    errors = [critical["reduction_error"] for critical in found.critical_speeds]
    assert found.error is not None and found.error.relative == max(errors) > 0
    rigid = jc.Scenario(scenarios / "back-to-back-7205c.toml").campbell("40000 rpm", count=5)
    # the search for the crossing ends at round-off
    assert rigid.error is not None and rigid.error.relative < 1e-9
    assert short(scenarios).campbell("60 rpm", count=3).error is None


def test_a_response_states_the_error_of_its_first_motion(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "varying-compliance-6306.toml").with_({"integrator.tolerance": 1e-4})
    found = scenario.response("speed.constant", "199 rad/s", "199.5 rad/s")
    assert found.error is not None and 0 < found.error.relative < 1e-4
    exact = scenario.with_({"speed.constant": "199 rad/s"}).steady(tolerance=1e-9, verify=False).summary["ranges"]
    ranges = {swing["channel"].removesuffix("_m"): swing for swing in exact}
    for axis in ("x", "y"):
        for what in ("mean", "peak_to_peak"):
            true = abs(found.points[f"{axis}_{what}_m"][0] - ranges[axis][what])
            assert true < 3 * found.error.displacement_m
    unmeasured = scenario.with_({"integrator.verify": False})
    assert unmeasured.response("speed.constant", "199 rad/s", "199.1 rad/s", points=2).error is None


def test_compiled_classes_have_names_of_the_field(steady_run: jc.Run, scenarios: Path) -> None:
    for kind in (jc.CheckedScenario, jc.Findings, jc.RunFindings, jc.StopSignal, jc.StudyPlan):
        assert kind.__module__ == "jeffcott" and getattr(jc, kind.__name__) is kind
    checked = short(scenarios).checked
    assert repr(checked) == f'<CheckedScenario "{checked.title()}">'
    assert repr(jc.StopSignal()) == "<StopSignal: not set>"
    assert repr(steady_run._source) == f"<RunFindings: {len(steady_run)} samples>"
