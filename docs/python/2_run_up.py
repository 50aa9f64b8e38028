# %% [markdown]
# # A run-up and its waterfall
#
# From rest to 600 rad/s in a quarter of a second. The ball pass and its multiples cross the natural frequencies.

# %%
import numpy as np

import jeffcott as jc

run = jc.Scenario("scenarios/run-up-7205c.toml").run(progress=True)
print(run.tables)

# %%
run.figure("waterfall")

# %% [markdown]
# The waterfall is a long table, a row a cell; as a matrix of times and frequencies:

# %%
waterfall = run.table("waterfall")
times, frequencies = np.unique(waterfall["t_s"]), np.unique(waterfall["f_Hz"])
level = waterfall["z_amplitude_m"].reshape(len(times), len(frequencies))
loudest = frequencies[1 + level[:, 1:].argmax(axis=1)]
speed = waterfall["speed_rad_s"].reshape(level.shape)[:, 0]
for place in range(0, len(times), max(1, len(times) // 8)):
    print(f"{speed[place]:6.1f} rad/s: z is loudest at {loudest[place]:7.1f} Hz")

# %% [markdown]
# Orders are tracked over the angle of the shaft. Where the ball pass is largest is a resonance:

# %%
tracks = run.table("order_tracks")
passing = tracks["BPFO_z_amplitude_m"]
print("the ball pass is largest at", tracks["speed_rad_s"][passing.argmax()], "rad/s")
run.figure("order_tracks")

# %%
print(run.table("campbell").rows, "modes over the speed; error", run.error.relative)
assert len(times) > 5
