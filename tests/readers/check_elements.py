"""Compares elements with those of ROSS: tables over the speed of a bearing and a seal, and a squeeze film damper.

Part of `.ci/run`, and by hand. Needs ROSS 3:

    pip install 'ross-rotordynamics>=3'
    python3 tests/readers/check_elements.py target/release/jeffcott

Natural frequencies, damping, the response to unbalance, and files of bearings read and written both ways. The mesh is ROSS's in
both programs.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
import ross

jeffcott = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(tempfile.mkdtemp())
steel = ross.Material(name="steel", rho=7810, E=211e9, G_s=81.2e9)
RPM = 2 * math.pi / 60


def ask(verb, name, text, *more):
    """Files that the command leaves of a scenario."""
    (folder / f"{name}.toml").write_text(text)
    command = [jeffcott, "-q", verb, f"{name}.toml", "--out", "out", *more]
    subprocess.run(command, cwd=folder, check=True, stderr=subprocess.DEVNULL)
    return folder / "out" / name


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


# A shaft of 1.5 m with two discs, on a bearing by a table, a bearing of constant stiffness, and a seal by a table in the middle.

speeds = numpy.linspace(0, 900, 10)
parts = [ross.ShaftElement(L=0.25, idl=0, odl=0.05, material=steel) for _ in range(6)]
discs = [
    ross.DiskElement.from_geometry(n=n, material=steel, width=0.07, i_d=0.05, o_d=o_d) for n, o_d in [(2, 0.28), (4, 0.35)]
]
bearing = ross.BearingElement(
    n=0, kxx=4e6 + 2e3 * speeds, kyy=6e6 - 1e3 * speeds, kxy=8e2 * speeds, kyx=-9e2 * speeds,
    cxx=900 - 0.2 * speeds, cyy=1100 + 0.1 * speeds, speed=speeds, tag="journal",
)  # fmt: skip
other = ross.BearingElement(n=6, kxx=5e6, cxx=700, tag="other")
seal = ross.SealElement(
    n=3, kxx=2e5 + 3e2 * speeds, kxy=4e2 * speeds, kyx=-4e2 * speeds, cxx=300 + 0.1 * speeds,
    speed=speeds, seal_leakage=numpy.full(len(speeds), 0.1), tag="seal",
)  # fmt: skip
rotor = ross.Rotor(parts, discs, [bearing, other, seal])
bare = ross.Rotor(parts, discs)
matrices = {"nodes": list(map(float, bare.nodes_pos)), "M": bare.M(0), "K": bare.K(0), "G": bare.G()}
(folder / "shaft.json").write_text(json.dumps({key: numpy.asarray(own).tolist() for key, own in matrices.items()}))
text = '[shaft]\nmatrices = "shaft.json"\nfreedoms = "radial"\nmodes = 40\nobserved = "0.5 m"\n[speed]\nconstant = "500 rad/s"\n'
text += '[[unbalance]]\namount = "100 g mm"\nposition = "0.5 m"\n'
for element, position in [(bearing, 0), (other, 1.5), (seal, 0.75)]:
    element.save(folder / f"{element.tag}.toml")
    text += f'[[element]]\nposition = "{position} m"\ncoefficients = "{element.tag}.toml"\n'

out = ask("campbell", "tables", text, "--to", "800 rad/s", "--count", "9")
rows = table(out / "campbell.csv")
worst = {"frequency": 0.0, "damping": 0.0}
compared = 0
for speed in (0.0, 400.0, 800.0):
    modal = rotor.run_modal(speed=speed, num_modes=40, sparse=False)
    theirs = list(zip(numpy.asarray(modal.wd) / (2 * math.pi), modal.damping_ratio))
    for row in rows:
        own = [float(row[key] or "nan") for key in ("speed_rad_s", "frequency_Hz", "damping_ratio")]
        if abs(own[0] - speed) > 1e-6 or not own[1] < 200:
            continue
        # the axial and torsional modes of ROSS have no partner here
        near = min(theirs, key=lambda pair: math.hypot(pair[0] / own[1] - 1, pair[1] - own[2]))
        worst["frequency"] = max(worst["frequency"], abs(near[0] / own[1] - 1))
        worst["damping"] = max(worst["damping"], abs(near[1] - own[2]))
        compared += 1
print(f"{compared} modes on a bearing and a seal by tables: frequencies {worst['frequency']:.1e}, damping {worst['damping']:.1e} apart")
assert compared >= 12 and max(worst.values()) < 1e-5, (compared, worst)

out = ask("response", "tables", text, "--at", "1 m", "--from", "100 rad/s", "--to", "800 rad/s", "--count", "8")
rows = table(out / "frequency_response.csv")
asked = numpy.array([float(row["speed_rad_s"]) for row in rows])
answer = rotor.run_unbalance_response(2, 1e-4, 0.0, asked)
worst = 0.0
for axis, name in enumerate("xy"):
    theirs = numpy.asarray(answer.forced_resp)[rotor.number_dof * 4 + axis]
    amplitude, phase = (
        numpy.array([float(row[f"{name}_1_{what}"]) for row in rows]) for what in ("amplitude_m", "phase_rad")
    )
    mine = amplitude * numpy.exp(1j * phase)
    worst = max(worst, (numpy.abs(mine - theirs) / numpy.abs(theirs)).max())
print(f"response to unbalance, amplitude and phase: {worst:.1e} apart")
assert worst < 1e-5, worst

# A table that this program reads is written by ROSS, and read back to the last bit.

again = ross.BearingElement.load(folder / "journal.toml")
for name in ("kxx", "kxy", "kyx", "kyy", "cxx", "cyy"):
    assert list(getattr(again, name)) == list(getattr(bearing, name)), name

# A squeeze film damper with a groove in its middle is two of half the length: the circle that the whole equations settle to is
# that of ROSS's coefficients at its eccentricity.

mass, stiffness, length, diameter, clearance = 50.0, 1e6, 0.04, 0.1, 1e-4
probe = ross.SqueezeFilmDamper(
    n=0, frequency=[300.0], axial_length=length, journal_diameter=diameter, radial_clearance=clearance,
    eccentricity_ratio=0.1, lubricant="ISOVG32", geometry="groove", cavitation=True,
)  # fmt: skip
film = (
    f'[[element]]\n[element.squeeze_film]\ndiameter = "{diameter} m"\nlength = "{length / 2} m"\n'
    f'clearance = "{clearance} m"\nviscosity = "{probe.lubricant!r} Pa s"\n'
)
worst = 0.0
for name, eccentricity, speed in [("small", 5e-6, 300.0), ("large", 80e-6, 500.0)]:
    text = (
        f'[shaft]\nmass = "{mass} kg"\neccentricity = "{eccentricity} m"\nfreedoms = "radial"\n{film}{film}'
        f'[[element]]\nlinear = {{ stiffness = {{ x = "{stiffness} N/m", y = "{stiffness} N/m" }} }}\n[speed]\n'
        f'constant = "{speed} rad/s"\n[time]\nduration = "1 s"\nsettle = "0.5 s"\n[integrator]\ntolerance = 1e-10\n'
    )
    out = ask("steady", name, text)
    lines = table(out / "steady_spectrum.csv")
    line = min(lines, key=lambda row: abs(float(row["f_Hz"]) - speed / (2 * math.pi)))
    radius = float(line["x_amplitude_m"])
    theirs = ross.SqueezeFilmDamper(
        n=0, frequency=[speed], axial_length=length, journal_diameter=diameter, radial_clearance=clearance,
        eccentricity_ratio=radius / clearance, lubricant="ISOVG32", geometry="groove", cavitation=True,
    )  # fmt: skip
    dynamic = stiffness + theirs.kxx[0] - mass * speed**2 + 1j * speed * theirs.cxx[0]
    worst = max(worst, abs(mass * eccentricity * speed**2 / abs(dynamic) / radius - 1))
    print(f"squeeze film damper at an eccentricity of {radius / clearance:.2f}")
print(f"its circle and that of the coefficients of ROSS: {worst:.1e} apart")
assert worst < 1e-6, worst
