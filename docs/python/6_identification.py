# %% [markdown]
# # Preload and clearance from a measured spectrum
#
# A tap with a hammer on a running shaft shows its natural frequencies. They depend on how strongly its two deep-groove
# bearings are pressed against each other, and on their clearance, which decides their contact angle: the stiffness along
# the shaft rises with both, that across it falls with the clearance. `jc.fit` finds both, and says how well they are known.

# %%
import warnings

import numpy as np
from scipy.optimize import curve_fit

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
KEYS = ("bearing[1].preload", "bearing[1].geometry.diametral_clearance")

# %% [markdown]
# The measurement: a pair with 120 N and 9 µm, its velocity with a thousandth of noise.

# %%
truth = dict(zip(KEYS, (120.0, 9e-6)))
run = scenario.with_({KEYS[0]: "120 N", KEYS[1]: "9 um"}).run()
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
measured = sorted(natural_frequency(axis, noise) for axis in "xyz")
print("natural frequencies:", np.round(measured, 2), "Hz")

# %% [markdown]
# The fit: three natural frequencies, each known to a thousandth, tell two unknowns. Those across the shaft are nearly one
# number, so that next to nothing is left over to test the model by: a warning says that a fit that good proves nothing.

# %%
warnings.simplefilter("default", jc.ModelWarning)
found = jc.fit(
    {
        "unknown": [
            {"key": KEYS[0], "from": "20 N", "to": "400 N"},
            {"key": KEYS[1], "from": "3 um", "to": "25 um"},
        ],
        "observation": [
            {"number": f"natural_frequency_{k}_Hz", "value": f"{f} Hz", "sigma": "0.1 %"}
            for k, f in enumerate(measured, 1)
        ],
    },
    scenario,
)
print(found)
for key in KEYS:
    print(f"{key}: {found.values[key]:.4g} ± {found.standard_errors[key]:.2g}, true is {truth[key]:.4g}")
    assert abs(found.values[key] / truth[key] - 1) < 0.05

# %% [markdown]
# What they rest on: by how many per cent each natural frequency changes where a key changes by one per cent. The load along
# the shaft moves the axial one most.

# %%
table = found.scenario.campbell().sensitivity(*KEYS)
for number, key, part in zip(table["number"], table["key"], table["percent_per_percent"]):
    if number.startswith("natural_frequency"):
        print(f"{number} by {key}: {part:+.3f}")
