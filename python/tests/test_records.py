"""Records of sensors, against SciPy."""

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


def test_what_is_wrong_is_said():
    with pytest.raises(jc.ScenarioError, match="how many samples a second"):
        jc.analyze(noise(100))
    with pytest.raises(jc.ScenarioError, match="no channel `b`"):
        jc.analyze({"a": noise(100)}, rate=RATE, channel="b")
    with pytest.raises(ValueError, match="cannot be read"):
        jc.analyze("missing.csv")
