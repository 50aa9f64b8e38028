"""Loads the bearings of a stiffness study into ROSS and compares coefficients and natural frequencies.

Part of `.ci/run` where ROSS 3 can be installed, which needs Python 3.13, and by hand:

    pip install 'ross-rotordynamics>=3'
    jeffcott study scenarios/studies/stiffness-7205c.toml
    python3 tests/readers/check_ross.py output/stiffness-7205c

The rotor in ROSS is the shaft of the study: stiff, massless between its bearings, its mass in the middle.
Both bearings are alike, so that the shaft moves up and down and to and fro without tilting; that a bearing in
ROSS has no stiffness against tilts does not matter to these two modes.
"""

import csv
import json
import math
import pathlib
import sys

import numpy
import ross

folder = pathlib.Path(sys.argv[1])
base = json.loads((folder / "runs.json").read_text())["study"]["base"]
with open(folder / "runs.csv", newline="") as file:
    runs = {row["run"]: row for row in csv.DictReader(file)}
with open(folder / "stiffness.csv", newline="") as file:
    table = list(csv.DictReader(file))


def quantity(text, unit):
    number, given = str(text).split(" ", 1)
    assert given == unit, (text, unit)
    return float(number)


# Coefficients.

files = {1: sorted(folder.glob("ross_bearing_1*.toml")), 2: sorted(folder.glob("ross_bearing_2*.toml"))}
assert files[1] and len(files[1]) == len(files[2]), f"no pairs of ross_bearing_*.toml in {folder}"
PLACES = {"xx": (0, 0), "xy": (0, 1), "yx": (1, 0), "yy": (1, 1), "zz": (2, 2)}
worst, compared = {"k": 0.0, "c": 0.0}, 0
loaded = {}
for bearing, paths in files.items():
    for path in paths:
        element = ross.BearingElement.load(path)
        lines = [line for line in path.read_text().splitlines() if line.startswith("# bearing_1_preload_N = ")]
        preload = float(lines[0].split("=")[1])
        loaded[bearing, preload] = element
        rows = [
            row for row in table
            if int(row["bearing"]) == bearing and float(runs[row["run"]]["bearing_1_preload_N"]) == preload
        ]
        speeds = [float(row["speed_rad_s"]) for row in rows]
        # over the speed of the rotor, whatever the frequency of its whirl
        assert speeds == list(element.speed) and element.frequency is None, path
        for letter, unit in [("k", "N_m"), ("c", "N_s_m")]:
            for name, place in PLACES.items():
                written = [float(row[f"{letter}{name}_{unit}"]) for row in rows]
                assert written == list(getattr(element, letter + name)), (path, letter, name)
                for speed, value in zip(speeds, written):
                    matrix = element.K(speed) if letter == "k" else element.C(speed)
                    worst[letter] = max(worst[letter], abs(matrix[place] - value))
                    compared += 1
print(f"{compared} coefficients of ROSS are those of the table to the last bit; its spline through them is off")
print(f"by at most {worst['k']:.2g} N/m of K and {worst['c']:.2g} N s/m of C at the speeds of the table")
# the spline smooths until the sum of squares is about as many units as there are speeds, whatever the unit
assert max(worst.values()) < 2 * math.sqrt(6), worst

# Natural frequencies.

mass = quantity(base["shaft"]["mass"], "kg")
stiff = ross.Material(name="stiff", rho=1e-2, E=1e14, Poisson=0.3)
worst = 0.0
for (bearing, preload), first in sorted(loaded.items(), key=lambda entry: entry[0]):
    if bearing != 1:
        continue
    second = loaded[2, preload]
    first.n, second.n = 0, 2
    shaft = [ross.ShaftElement(L=0.03, idl=0.0, odl=0.2, material=stiff, n=n) for n in (0, 1)]
    disk = ross.DiskElement(n=1, m=mass, Id=0.01, Ip=0.004)
    rotor = ross.Rotor(shaft, [disk], [first, second])
    for run in runs.values():
        if float(run["bearing_1_preload_N"]) != preload:
            continue
        speed = float(run["speed_constant_rad_s"])
        own = [float(run[f"natural_frequency_{k}_Hz"]) for k in range(1, 6)]
        answer = rotor.run_modal(speed=speed, num_modes=12, sparse=False)
        theirs = numpy.asarray(answer.wn) / (2 * math.pi)
        for axis in "xy":
            # the mode without tilt stands where the stiffness of both bearings says
            expected = math.sqrt(float(run[f"stiffness_{axis}_N_m"]) / mass) / (2 * math.pi)
            mine = min(own, key=lambda value: abs(value - expected))
            other = min(theirs, key=lambda value: abs(value - mine))
            worst = max(worst, abs(other / mine - 1))
    print(f"preload {preload} N: translation at {mine:.4f} Hz here and {other:.4f} Hz in ROSS, at {speed} rad/s")
print(f"largest relative difference of a natural frequency: {worst:.1e}")
assert worst < 1e-4, worst
