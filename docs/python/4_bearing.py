# %% [markdown]
# # A bearing by itself
#
# Stiffness over preload and speed, the load of every ball, and the same bearing of a shaft.

# %%
import numpy as np

import jeffcott as jc

bearing = jc.Bearing("7205C", contact="jones")
print(jc.catalogue()["7205C"])

# %% [markdown]
# The inner ring held where it is mounted, under a preload: K in N/µm and N m/mrad. At speed the balls are thrown outwards.

# %%
for preload in ("50 N", "200 N", "800 N"):
    for speed in ("0 rad/s", "2500 rad/s"):
        k = bearing.stiffness(preload=preload, speed=speed)
        print(f"{preload:>6} {speed:>10}: K_x {1e-6 * k[0, 0]:7.2f}  K_z {1e-6 * k[2, 2]:6.2f}  K_tilt {1e-3 * k[3, 3]:6.3f}")

# %% [markdown]
# Under a radial load beside the thrust the balls share it unevenly.

# %%
loaded = bearing.answer({"y": "-500 N", "z": "800 N"}, displacement={"tilt_x": "0 rad", "tilt_y": "0 rad"})
print("it moves by", loaded.equilibrium)
assert loaded.balls["inner_load_N"].min() >= 0
loaded.balls

# %%
loaded.figure("balls")

# %% [markdown]
# A bearing that no catalogue here has, by the ratings that its maker prints. Several sets of balls may fit them; their number settles which.

# %%
printed = {"bore": "40 mm", "outside_diameter": "80 mm", "dynamic": "29.1 kN", "static": "17.9 kN", "balls": 9}
print(jc.Bearing.from_ratings(**printed).stiffness({"y": "-500 N", "z": "300 N"})[0, 0])

# %% [markdown]
# Dimensions of one's own stand in place of the catalogue:

# %%
own = jc.Bearing(
    geometry={
        "balls": 12,
        "ball_diameter": "7.938 mm",
        "pitch_diameter": "38.5 mm",
        "contact_angle": "15 deg",
        "groove_factor_inner": 0.52,
        "groove_factor_outer": 0.53,
    }
)
assert np.allclose(own.stiffness(preload="200 N"), jc.Bearing("7205C").stiffness(preload="200 N"), rtol=1e-9, atol=1e-3)
