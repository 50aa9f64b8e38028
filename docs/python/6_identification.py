# %% [markdown]
# # Preload and clearance from a measured spectrum
#
# A tap with a hammer on a running shaft shows its natural frequencies. They depend on how strongly its two deep-groove
# bearings are pressed against each other, and on their clearance, which decides their contact angle: the stiffness along
# the shaft rises with both, that across it falls with the clearance. Both are found back by SciPy's least squares.

# %%
import numpy as np
from scipy.optimize import curve_fit, least_squares

import jeffcott as jc

scenario = jc.Scenario(
    {
        "title": "shaft on a pair of 6205, tapped",
        "shaft": {"mass": "5 kg", "freedoms": "translational", "gravity": True},
        "speed": {"constant": "1500 rpm"},
        "bearing": [
            {
                "catalogue": "6205",
                "arrangement": "back-to-back",
                "spacing": "60 mm",
                "preload": "50 N",
                "geometry": {"diametral_clearance": "15 um"},
            }
        ],
        "damping": {"ratio": 0.02},
        "load": [{"shock": {"peak": {"x": "20 N", "y": "20 N", "z": "20 N"}, "at": "50 ms", "duration": "0.2 ms"}}],
        "time": {"duration": "0.3 s", "settle": "0.051 s"},
        "output": {"sample_rate": "20 kHz", "motion": False},  # what decays does not settle
    }
)


def bearing(preload: float, clearance: float) -> dict[str, str]:
    return {"bearing[1].preload": f"{preload} N", "bearing[1].geometry.diametral_clearance": f"{clearance} um"}


# %% [markdown]
# The measurement: a pair with 120 N and 9 µm, its velocity with a thousandth of noise.

# %%
truth = (120.0, 9.0)
run = scenario.with_(bearing(*truth)).run()
spectrum = run.spectrum("x_velocity", "y_velocity", "z_velocity", window="rectangular")
print(list(spectrum), "error", run.error.relative)

# %% [markdown]
# The line of a mode that decays: amplitude, natural frequency and damping ratio fitted around its peak.


# %%
def decay(f: np.ndarray, amplitude: float, natural: float, ratio: float) -> np.ndarray:
    return amplitude * f / np.abs(natural**2 - f**2 + 2j * ratio * natural * f)


def natural_frequency(axis: str, noise: np.random.Generator) -> float:
    f, values = spectrum["f_Hz"], spectrum[f"{axis}_velocity_peak_m_s"]
    values = values * (1 + 1e-3 * noise.standard_normal(len(values)))
    peak = f[f > 200][values[f > 200].argmax()]
    near = np.abs(f / peak - 1) < 0.15
    start = (values[near].max() * 0.04 * peak, peak, 0.02)
    return float(curve_fit(decay, f[near], values[near], start)[0][1])


noise = np.random.default_rng(1)
measured = np.array([natural_frequency(axis, noise) for axis in "xyz"])
print("natural frequencies of x, y, z:", np.round(measured, 2), "Hz")

# %% [markdown]
# The model: the stiffness where the shaft stands, without motion; a question of milliseconds.


# %%
def natural(logs: np.ndarray) -> np.ndarray:
    stiffness = scenario.with_(bearing(*np.exp(logs))).bearing().stiffness
    return np.sqrt(np.diag(stiffness)[:3] / 5.0) / (2 * np.pi)


found = least_squares(lambda logs: natural(logs) / measured - 1, np.log([50.0, 15.0]), diff_step=1e-4)
preload, clearance = np.exp(found.x)
print(f"preload {preload:.1f} N, clearance {clearance:.2f} µm, after {found.nfev} evaluations; true are {truth}")
assert abs(preload / truth[0] - 1) < 0.05
assert abs(clearance / truth[1] - 1) < 0.05

# %% [markdown]
# How well they are known, where the natural frequencies are known to a thousandth:

# %%
deviation = 1e-3 * np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))
print(f"± {100 * deviation[0]:.1f} % of the preload, ± {100 * deviation[1]:.1f} % of the clearance")
