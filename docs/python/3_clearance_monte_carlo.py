# %% [markdown]
# # Monte-Carlo of the clearance
#
# What the clearance of two deep-groove bearings does to the vibration of a fan shaft: drawn at random within its class,
# on all processors. Runs follow from the seed alone: the same numbers on any number of threads.

# %%
import numpy as np

import jeffcott as jc

scenario = jc.Scenario("scenarios/fan-6205.toml")
scenario.update({"time": {"duration": "0.5 s", "settle": "0.3 s"}, "integrator.tolerance": 1e-5})

clearance = {"distribution": "uniform", "from": "5 um", "to": "20 um"}
study = scenario.sweep(
    {"bearing[1].geometry.diametral_clearance": clearance, "bearing[2].geometry.diametral_clearance": clearance},
    sampling="monte_carlo",
    runs=24,
    seed=7,
    keep={"numbers": ["x_rms_m", "y_rms_m", "y_peak_to_peak_m", "largest_ball_load_N"]},
    threads=2,
    progress=True,
)
print(study)

# %% [markdown]
# A row a run; `to_pandas`, `to_polars` and `to_arrow` hand it on.

# %%
swing = 1e6 * study["y_peak_to_peak_m"]
print("y peak to peak:", np.quantile(swing, [0.05, 0.5, 0.95]), "µm")
mean = study["bearing_1_geometry_diametral_clearance_m"] + study["bearing_2_geometry_diametral_clearance_m"]
print("correlation with the clearance of both:", np.corrcoef(mean, swing)[0, 1])
print(study.runs.to_pandas().describe().T[["mean", "min", "max"]])

# %%
study.figure("sensitivity")

# %% [markdown]
# Every tenth run was integrated twice; the largest error of them:

# %%
print("error", study.error.relative)
assert study.digest["failed"] == 0
