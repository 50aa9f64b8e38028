#!/usr/bin/env python3
"""Makes scipy_spectra.json: spectra of two signals as SciPy estimates them.

    python3 tests/library/spectra/scipy_spectra.py > tests/library/spectra/scipy_spectra.json

The signals are the ones of tests/spectra/signal.rs: lines on and between bins, a mean, a drift, and
noise of a 64-bit linear congruential generator, whose integers are the same in both languages.
"""

import json
import sys

import numpy as np
import scipy
from scipy import signal

RATE = 1000.0


def noise(seed, length):
    """Uniform on -0.5 ... 0.5, of the upper 53 bits of the generator of Knuth's MMIX."""
    state, values = seed, []
    for _ in range(length):
        state = (6364136223846793005 * state + 1442695040888963407) % 2**64
        values.append((state >> 11) / 2**53 - 0.5)
    return np.array(values)


def signals(length):
    t = np.arange(length) / RATE
    x = (
        0.7
        + 0.4 * t
        + 1.5 * np.cos(2 * np.pi * 50.0 * t + 0.3)
        + 0.8 * np.sin(2 * np.pi * 123.4 * t)
        + 0.5 * noise(1, length)
    )
    y = (
        -0.2
        + 1.1 * np.cos(2 * np.pi * 50.0 * t - 0.9)
        + 0.3 * np.cos(2 * np.pi * 310.7 * t) * (1 + 0.5 * np.cos(2 * np.pi * 12.0 * t))
        + 0.4 * noise(2, length)
    )
    return x, y


WINDOWS = {
    "rectangular": "boxcar",
    "hann": "hann",
    "hamming": "hamming",
    "blackman_harris": "blackmanharris",
    "flat_top": "flattop",
}
DETRENDS = {"none": False, "constant": "constant", "linear": "linear"}
SCALINGS = {"power": "spectrum", "density": "density"}


def settings(length, window, segment, overlap, detrend, scaling):
    return {
        "length": length,
        "window": window,
        "segment": segment,
        "overlap": overlap,
        "detrend": detrend,
        "scaling": scaling,
    }


def arguments(case):
    return {
        "fs": RATE,
        "window": signal.get_window(WINDOWS[case["window"]], case["segment"], fftbins=True),
        "nperseg": case["segment"],
        "noverlap": case["overlap"],
        "detrend": DETRENDS[case["detrend"]],
    }


def welch(case):
    x, _ = signals(case["length"])
    _, power = signal.welch(x, scaling=SCALINGS[case["scaling"]], **arguments(case))
    return {**case, "values": list(power)}


def cross(case):
    x, y = signals(case["length"])
    by = arguments(case)
    _, power = signal.csd(x, y, scaling=SCALINGS[case["scaling"]], **by)
    _, coherence = signal.coherence(x, y, **by)
    return {
        **case,
        "real": list(power.real),
        "imaginary": list(power.imag),
        "coherence": list(coherence),
    }


def whirl(case):
    x, y = signals(case["length"])
    _, power = signal.welch(
        x + 1j * y, scaling=SCALINGS[case["scaling"]], return_onesided=False, **arguments(case)
    )
    return {**case, "values": list(np.fft.fftshift(power))}


def envelope(length, band):
    _, y = signals(length)
    bins = np.fft.fft(y)
    frequency = np.abs(np.fft.fftfreq(length, 1 / RATE))
    bins[(frequency < band[0]) | (frequency > band[1])] = 0
    magnitude = np.abs(signal.hilbert(np.fft.ifft(bins).real))
    return {"length": length, "band": band, "values": list(magnitude)}


def window(name, length):
    weights = signal.get_window(WINDOWS[name], length, fftbins=True)
    return {
        "window": name,
        "length": length,
        "values": list(weights),
        "coherent_gain": float(np.mean(weights)),
        "noise_bandwidth": float(length * np.sum(weights**2) / np.sum(weights) ** 2),
    }


def amplitude(length, name):
    """The peak values of one segment without detrending, from numpy's transform alone."""
    x, _ = signals(length)
    weights = signal.get_window(WINDOWS[name], length, fftbins=True)
    bins = np.abs(np.fft.rfft(x * weights)) / np.sum(weights)
    bins[1 : (length + 1) // 2] *= 2
    return {"length": length, "window": name, "values": list(bins)}


def main():
    welches = [
        settings(700, "hann", 128, 64, "constant", "density"),
        settings(700, "hann", 128, 64, "constant", "power"),
        settings(700, "rectangular", 700, 350, "none", "density"),
        settings(501, "hamming", 125, 31, "linear", "density"),
        settings(640, "blackman_harris", 160, 120, "constant", "power"),
        settings(640, "flat_top", 127, 0, "linear", "power"),
        settings(499, "hann", 499, 249, "linear", "density"),
    ]
    crosses = [
        settings(1000, "hann", 128, 64, "constant", "density"),
        settings(600, "flat_top", 101, 75, "linear", "power"),
    ]
    whirls = [
        settings(700, "hann", 128, 64, "constant", "density"),
        settings(500, "rectangular", 125, 0, "none", "power"),
    ]
    json.dump(
        {
            "made_by": f"scipy {scipy.__version__}, numpy {np.__version__}",
            "rate": RATE,
            "windows": [window(name, n) for name in WINDOWS for n in (16, 33)],
            "amplitude": [amplitude(400, "rectangular"), amplitude(255, "flat_top")],
            "welch": [welch(case) for case in welches],
            "cross": [cross(case) for case in crosses],
            "whirl": [whirl(case) for case in whirls],
            "envelope": [envelope(400, [250.0, 370.0]), envelope(297, [100.0, 500.0])],
        },
        sys.stdout,
        indent=1,
    )
    sys.stdout.write("\n")


if __name__ == "__main__":
    main()
