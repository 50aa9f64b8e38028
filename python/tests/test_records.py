"""Records of sensors, against SciPy."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jeffcott as jc

scipy_signal = pytest.importorskip("scipy.signal")

RATE = 5000.0


def noise(count: int = 20_000) -> np.ndarray:
    return np.random.default_rng(5).standard_normal(count)


def test_welch_and_cross_spectra_are_those_of_scipy():
    x, y = noise(), np.roll(noise(), 3) + 0.1
    asked = {
        "spectrum": [
            {"name": "welch", "channels": ["x_signal"], "scaling": "density", "segment_samples": 1024},
            {"name": "cross", "kind": "cross", "channels": ["x_signal", "y_signal"], "segment_samples": 1024},
        ]
    }
    found = jc.analyze({"x_signal": x, "y_signal": y}, rate=RATE, unit="m/s^2", description=asked)
    f, expected = scipy_signal.welch(x, RATE, "hann", 1024)
    table = found.spectrum("welch")
    assert np.allclose(table["f_Hz"], f, rtol=1e-14)
    values = table["x_signal_density_m2_s4_per_Hz"]
    assert np.max(np.abs(values - expected)) < 1e-12 * expected.max()
    _, expected = scipy_signal.csd(x, y, RATE, "hann", 1024)
    values = found.spectrum("cross")["x_signal_to_y_signal_density_m2_s4_per_Hz"]
    assert np.max(np.abs(values - np.abs(expected))) < 1e-12 * np.abs(expected).max()


def test_an_envelope_is_that_of_hilbert():
    x = noise()
    asked = {
        "spectrum": [
            {"name": "all", "kind": "envelope", "channels": ["channel1"], "band": ["0 Hz", "2500 Hz"], "scaling": "power"}
        ]
    }
    found = jc.analyze(x, rate="5 kHz", unit="m/s^2", description=asked).spectrum("all")
    envelope = np.abs(scipy_signal.hilbert(x - np.mean(x)))
    _, expected = scipy_signal.welch(envelope, RATE, "hann", len(x), scaling="spectrum")
    assert np.max(np.abs(found["channel1_power_m2_s4"] - expected)) < 1e-12 * expected.max()


def test_short_time_spectra_are_those_of_scipy():
    x = noise()
    speed = np.linspace(900.0, 1500.0, len(x))
    found = jc.analyze(
        {"a": x, "speed": speed},
        rate=RATE,
        channel="a",
        unit="m/s^2",
        description={"speed": {"channel": "speed", "unit": "rpm"}},
    )
    table = found.table("waterfall")
    window = found.summary["maps"]["waterfall"]
    bins, length = window["frequencies"], window["samples"]
    hop = length - window["overlap_samples"]
    values = table["a_amplitude_m_s2"].reshape(-1, bins)
    _, _, expected = scipy_signal.stft(
        x, RATE, "hann", length, length - hop, detrend="constant", boundary=None, padded=False, scaling="spectrum"
    )
    expected = 2 * np.abs(expected[:bins, : len(values)]).T
    assert len(expected) == len(values)
    assert np.max(np.abs(values[:, 1:] - expected[:, 1:])) < 1e-12 * expected.max()


def test_a_file_and_its_arrays_give_the_same(tmp_path):
    x = noise(4000)
    np.savetxt(tmp_path / "made.csv", x, fmt="%.17g")
    options = dict(rate=RATE, unit="g", speed="1500 rpm", bearing="6205")
    of_file = jc.analyze(tmp_path / "made.csv", **options)
    of_array = jc.analyze(x, **options)
    assert of_file.summary["ball_pass"] == of_array.summary["ball_pass"]
    first, second = (np.array(found.peaks["amplitude"]) for found in (of_file, of_array))
    assert np.array_equal(first, second)
    assert "ball pass" in str(of_file)


def test_tables_are_read_as_their_files(linear_run: jc.Run, tmp_path: Path) -> None:
    linear_run.write(tmp_path)
    of_file = jc.analyze(tmp_path / "trace.csv")
    trace = linear_run.trace
    tables: list[Any] = [linear_run, trace, dict(trace)]
    for module, made in (("pandas", trace.to_pandas), ("polars", trace.to_polars), ("pyarrow", trace.to_arrow)):
        pytest.importorskip(module)
        tables.append(made())
    for table in tables:
        found = jc.analyze(table)
        assert found.summary["channels"] == of_file.summary["channels"]
        for name in of_file.tables:
            assert found.table(name) == of_file.table(name), name


def test_names_say_units_and_times():
    x, times = noise(4000), np.arange(4000) / RATE
    assert "acc_amplitude_m_s2" in jc.analyze({"time [s]": times, "acc [g]": x}).spectrum()
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    for series in (pandas.Series(x, name="acc [m/s^2]"), polars.Series("acc [m/s^2]", x)):
        assert "acc_amplitude_m_s2" in jc.analyze(series, rate=RATE).spectrum()
    frame = pandas.DataFrame({"when": pandas.date_range("2026-01-01", periods=4000, freq="ms"), "acc [g]": x})
    spectrum = jc.analyze(frame).spectrum()
    assert spectrum["f_Hz"][-1] == pytest.approx(500.0)
    structured = np.rec.fromarrays([times, x], names="t_s,x_m")
    assert "x_amplitude_m" in jc.analyze(structured).spectrum()


def test_only_a_column_is_a_channel():
    x = noise(4000)
    assert jc.analyze({"m": x[:, None]}, rate=RATE).peaks == jc.analyze({"m": x}, rate=RATE).peaks
    for source in ({"m": x.reshape(-1, 4)}, {"m": x[None]}, {"m": 1j * x}, {"m": ["a"] * 100}, None, 3.0):
        with pytest.raises(ValueError):
            jc.analyze(source, rate=RATE)


def test_a_speed_below_zero_is_no_channel():
    with pytest.raises(jc.ScenarioError) as caught:
        jc.analyze(noise(100), rate=RATE, speed="-3000 rpm")
    assert "channel" not in str(caught.value)


def test_messages_speak_of_keywords():
    with pytest.raises(jc.ScenarioError) as caught:
        jc.analyze(noise(100))
    assert "rate=" in str(caught.value.problems[0].hint) and "--rate" not in str(caught.value)
    with pytest.warns(jc.ModelWarning, match="é"):
        jc.analyze({"é": noise(100)}, rate=RATE)


def test_what_is_wrong_is_said():
    with pytest.raises(jc.ScenarioError, match="how many samples a second"):
        jc.analyze(noise(100))
    with pytest.raises(jc.ScenarioError, match="no channel `b`"):
        jc.analyze({"a": noise(100)}, rate=RATE, channel="b")
    with pytest.raises(ValueError, match="cannot be read"):
        jc.analyze("missing.csv")
