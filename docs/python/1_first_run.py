# %% [markdown]
# # A first run
#
# A drive shaft on one angular contact bearing at constant speed: from the file to the picture, then a heavier shaft.

# %%
import jeffcott as jc

scenario = jc.Scenario("scenarios/steady-7205c.toml")
run = scenario.run()
print(run)

# %% [markdown]
# Columns are numpy arrays with the names of the files, the unit at the end. The error was measured by a second pass at a
# tenth of the tolerance.

# %%
print(run.t[-1], "s;", run["x_m"].std(), "m")
print("error", run.error.relative, "of the motion,", run.error.displacement_m, "m")
assert run.error.relative < 1e-7

# %%
run.figure("orbit")

# %% [markdown]
# What makes the lines of the spectrum:

# %%
for channel, frequency, amplitude, name in zip(*(run.peaks[key] for key in ("channel", "f_Hz", "amplitude", "name"))):
    if channel in ("x", "y"):
        print(f"{channel} {frequency:8.2f} Hz {1e6 * amplitude:9.4f} µm  {name}")

# %%
run.figure("spectrum")

# %% [markdown]
# Keys are those of the file and are checked when they are set; what is wrong names its key and what helps.

# %%
scenario["shaft.mass"] = "8 kg"
heavier = scenario.run()
print("1× grows from", run["x_m"].std(), "to", heavier["x_m"].std(), "m")

try:
    scenario["shaft.mas"] = "8 kg"
except jc.ScenarioError as error:
    print(error.problems[0].key, "-", error.problems[0].hint)

# %% [markdown]
# All files that the command writes, `report.html` among them:

# %%
print([path.name for path in run.write("output/first-run")])
