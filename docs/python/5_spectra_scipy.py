# %% [markdown]
# # Spectra, compared with SciPy
#
# Spectra are estimated from the samples of a run, as many as one likes, without another run. `scipy.signal` finds the
# same.

# %%
import numpy as np
from scipy import signal

import jeffcott as jc

scenario = jc.Scenario("scenarios/steady-7205c.toml")
run = scenario.run()
settled = run.t >= 0.2
acceleration, rate = run["y_acceleration_m_s2"][settled], 1 / (run.t[1] - run.t[0])

# %% [markdown]
# A power density by Welch's method, segments of 1024 samples under a Hann window, half of each in the next:

# %%
ours = run.spectrum("y_acceleration", scaling="density", window="hann", segment_samples=1024, overlap=0.5)
print(list(ours))
frequency, theirs = signal.welch(
    acceleration, rate, window="hann", nperseg=1024, noverlap=512, detrend="constant", scaling="density"
)
density = ours[list(ours)[-1]]
worst = np.abs(density[1:] - theirs[1:]).max() / theirs.max()
print(f"largest difference {worst:.1e} of the largest value")
assert np.allclose(ours["f_Hz"], frequency, rtol=1e-12)
assert worst < 1e-9

# %% [markdown]
# The spectrum of the run itself takes whole revolutions, so that what turns with the shaft stands on a bin.

# %%
spectrum = run.spectrum()
line = spectrum["x_amplitude_m"][1:].argmax() + 1
print(f"x is loudest at {spectrum['f_Hz'][line]:.4f} Hz, order {spectrum['order'][line]:.6f}")

# %%
run.figure("spectrum")
