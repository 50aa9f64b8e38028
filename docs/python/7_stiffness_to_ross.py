# %% [markdown]
# # Stiffness tables for ROSS
#
# K and C of every bearing over the speed, for several preloads, as ROSS (rotordynamics in Python) reads them.

# %%
import tomllib

import numpy as np

import jeffcott as jc

scenario = jc.Scenario("scenarios/back-to-back-7205c.toml")
scenario.update(
    {
        "load": None,
        "model.contact": "jones",
        "integrator.tolerance": 1e-5,
        "time": {"duration": "0.1 s", "settle": "0.05 s"},
    }
)
study = scenario.sweep(
    {
        "bearing[1].preload": ["100 N", "400 N"],
        "speed.constant": {"from": "200 rad/s", "to": "1600 rad/s", "count": 5},
    },
    keep={"bearing_stiffness": True, "numbers": ["stiffness_x_N_m"]},
    verify_every=0,
    out="output/stiffness",
    threads=2,
)

# %% [markdown]
# A row a bearing and run:

# %%
table = study.table("stiffness")
first = table["bearing"] == 1
print(table.to_pandas()[first].iloc[:, :6])

# %% [markdown]
# And a file a bearing and preload, for ROSS 3; ROSS 2 calls `frequency` what is `speed` in it. In ROSS: `ross.BearingElement.load("output/stiffness/ross_bearing_1_1.toml")`.

# %%
files = sorted(study.folder.glob("ross_bearing_*.toml"))
print([file.name for file in files])
element = tomllib.loads(files[0].read_text(encoding="utf-8"))
kxx = np.array(next(iter(element.values()))["kxx"])
assert np.array_equal(kxx, table["kxx_N_m"][first][: len(kxx)])
print(f"K_xx of bearing 1 falls from {kxx[0]:.4g} to {kxx[-1]:.4g} N/m: at speed its balls are thrown outwards")

try:
    import ross
except ImportError:
    print("ROSS is not installed: pip install ross-rotordynamics")
else:
    print(ross.BearingElement.load(files[0]))
