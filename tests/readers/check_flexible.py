"""Compares shafts that bend with ROSS: natural frequencies, a run-up, and the time that a simulated second takes.

Part of `.ci/run` where ROSS can be installed, and by hand. Runs with ROSS 2 and 3:

    pip install ross-rotordynamics
    python3 tests/readers/check_flexible.py target/release/jeffcott

Without ROSS it says so and ends well. The mesh is ROSS's in both: its M, K and G go into a file for `[shaft] matrices`.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import numpy
    import ross
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(0)

jeffcott = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(tempfile.mkdtemp())
steel = ross.Material(name="steel", rho=7810, E=211e9, G_s=81.2e9)


def ask(verb, name, text, *more):
    """Files that the command leaves of a scenario, and its wall time in s."""
    (folder / f"{name}.toml").write_text(text)
    start = time.perf_counter()
    command = [jeffcott, "-q", verb, f"{name}.toml", "--out", "out", *more]
    subprocess.run(command, cwd=folder, check=True, stderr=subprocess.DEVNULL)
    return folder / "out" / name, time.perf_counter() - start


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def shaft(elements, length, diameter, discs, stiffness, damping):
    """The shaft in ROSS, on bearings of constant stiffness at its ends."""
    step = length / elements
    parts = [ross.ShaftElement(L=step, idl=0, odl=diameter, material=steel) for _ in range(elements)]
    wheels = [
        ross.DiskElement.from_geometry(n=round(at / step), material=steel, width=0.07, i_d=diameter, o_d=outer)
        for at, outer in discs
    ]
    supports = [ross.BearingElement(n=n, kxx=stiffness, cxx=damping) for n in (0, elements)]
    return ross.Rotor(parts, wheels, supports)


def export(rotor, name):
    """M, K and G of the shaft without its bearings, and the positions of its nodes."""
    bare = ross.Rotor(rotor.shaft_elements, rotor.disk_elements)
    file = {"nodes": list(map(float, bare.nodes_pos)), "M": bare.M(0), "K": bare.K(0), "G": bare.G()}
    file = {key: numpy.asarray(value).tolist() for key, value in file.items()}
    (folder / name).write_text(json.dumps(file))


def linear(position, stiffness, damping):
    return f"""[[element]]
position = "{position} m"
linear = {{ stiffness = {{ x = "{stiffness} N/m", y = "{stiffness} N/m" }}, damping = {{ x = "{damping} N s/m", y = "{damping} N s/m" }} }}
"""


# Natural frequencies of example 5.9.1 of Friswell et al., the same mesh of 6 elements on both sides.

rotor = shaft(6, 1.5, 0.05, [(0.5, 0.28), (1.0, 0.35)], 1e6, 0)
export(rotor, "friswell.json")
head = '[shaft]\nmatrices = "friswell.json"\nfreedoms = "radial"\nmodes = 40\nobserved = "0.5 m"\n'
text = head + linear(0, 1e6, 0) + linear(1.5, 1e6, 0) + '[speed]\nconstant = "4000 rpm"\n'
out, _ = ask("campbell", "friswell", text, "--to", "4000 rpm", "--count", "9")
branches = json.loads((out / "campbell.json").read_text())["branches"]
worst = 0.0
for end, speed in [("first_Hz", 0.0), ("last_Hz", 4000 * 2 * math.pi / 60)]:
    mine = sorted(branch[end] for branch in branches if branch[end])
    modal = rotor.run_modal(speed=speed, num_modes=40, sparse=False)
    theirs = sorted(float(w) / (2 * math.pi) for w in modal.wd)
    # ROSS has the axial and torsional modes of its six coordinates a node, too
    for frequency in mine[:8]:
        nearest = min(theirs, key=lambda other: abs(other - frequency))
        worst = max(worst, abs(nearest / frequency - 1))
print(f"natural frequencies of linear bearings: largest relative difference {worst:.1e}")
assert worst < 1e-6, worst

# A run-up with constant stiffness through the first critical speed, 24 elements.

rotor = shaft(24, 0.5, 0.025, [(0.25, 0.2)], 1e7, 100)
export(rotor, "run-up.json")
disc = rotor.disk_elements[0]
node, (kinetic, top, over) = disc.n, (5e-5, 500.0, 1.0)
damping = 30.0
head = f'[shaft]\nmatrices = "run-up.json"\nfreedoms = "radial"\nmodes = 20\nobserved = "0.25 m"\n'
ramp = f'[speed]\nfrom = "0 rad/s"\nto = "{top} rad/s"\nover = "{over} s"\n'
unbalance = f'[[unbalance]]\namount = "{kinetic} kg m"\nposition = "0.25 m"\n'
output = '[output]\nchannels = ["x", "y"]\nsample_rate = "2 kHz"\nspectrum = false\n'
text = (
    head + unbalance + linear(0, 1e7, 100) + linear(0.5, 1e7, 100)
    + f'[damping]\ncoefficients = {{ x = "{damping} N s/m", y = "{damping} N s/m" }}\n'
    + ramp + f'[time]\nduration = "{over} s"\nsettle = "0 s"\n' + output
)
out, _ = ask("run", "run-up", text, "--no-verify")
mine = table(out / "trace.csv")
times = numpy.array([float(row["t_s"]) for row in mine])
x_mine = numpy.array([float(row["x_m"]) for row in mine])
step = 5e-5
steps = numpy.arange(0, over + step / 2, step)
rate = top / over
angle, speed = 0.5 * rate * steps**2, rate * steps
force = numpy.zeros((len(steps), rotor.ndof))
across = rotor.number_dof * node
force[:, across] = kinetic * (speed**2 * numpy.cos(angle) + rate * numpy.sin(angle))
force[:, across + 1] = kinetic * (speed**2 * numpy.sin(angle) - rate * numpy.cos(angle))
# the disc's damping from outside, as one more bearing without stiffness
dashpot = ross.BearingElement(n=node, kxx=0, cxx=damping)
damped = ross.Rotor(rotor.shaft_elements, rotor.disk_elements, [*rotor.bearing_elements, dashpot])
start = time.perf_counter()
answer = damped.run_time_response(speed, force, steps, method="newmark")
print(f"ROSS, {over:g} s of run-up with constant stiffness: {time.perf_counter() - start:.1f} s")
x_ross = numpy.interp(times, steps, numpy.asarray(answer.yout)[:, across])
apart = numpy.abs(x_mine - x_ross).max() / numpy.abs(x_mine).max()
print(f"run-up: displacements of the disc are at most {apart:.1e} of the largest apart")
assert apart < 1e-2, apart

# The time of a simulated second on two bearings of Hertzian balls.

export(rotor, "balls.json")
bearing = '[[bearing]]\ncatalogue = "6205"\nposition = "{} m"\n'
head = '[shaft]\nmatrices = "balls.json"\nfreedoms = "radial"\nobserved = "0.25 m"\n'
duration = 5.0
load = '[[load]]\nconstant = { y = "-300 N" }\nposition = "0.25 m"\n'
tail = (
    f'[speed]\nfrom = "0 rad/s"\nto = "500 rad/s"\nover = "{duration} s"\n[damping]\nratio = 0.03\n[time]\n'
    f'duration = "{duration} s"\nsettle = "0 s"\n'
)
text = head + unbalance + bearing.format(0) + bearing.format(0.5) + load + tail + output
coarse = text.replace("[shaft]\n", "[shaft]\nmodes = 2\n") + "[integrator]\ntolerance = 1e-5\n"
fine_out, fine_time = ask("run", "balls", text, "--no-verify")
coarse_out, coarse_time = ask("run", "coarse", coarse, "--no-verify")
ours = {"tolerance 1e-8": fine_time, "tolerance 1e-5, 2 modes a plane": coarse_time}
x_fine, x_coarse = (
    numpy.array([float(row["x_m"]) for row in table(out / "trace.csv")]) for out in (fine_out, coarse_out)
)
apart = numpy.abs(x_coarse - x_fine).max() / numpy.abs(x_fine).max()
print(f"both runs on Hertzian balls: displacements along x are at most {apart:.1e} of the largest apart")
assert apart < 2e-4, apart
# the same forces: nine balls of 7.94 mm between grooves, with the clearance of class CN
BALLS, CLEARANCE, CONSTANT = 9, 12.5e-6, 8e9
azimuths = 2 * math.pi / BALLS * numpy.arange(BALLS)


def hertz(step, disp_resp, **_):
    """Forces of both bearings."""
    forces = numpy.zeros(rotor.ndof)
    for end in (0, 24):
        first = rotor.number_dof * end
        x, y = disp_resp[first], disp_resp[first + 1]
        turned = azimuths + 0.4 * 0.5 * 100.0 * steps[step] ** 2
        approach = x * numpy.cos(turned) + y * numpy.sin(turned) - CLEARANCE / 2
        loads = CONSTANT * numpy.maximum(approach, 0.0) ** 1.5
        forces[first] = -(loads * numpy.cos(turned)).sum()
        forces[first + 1] = -(loads * numpy.sin(turned)).sum()
    return forces


# bearings that hold next to nothing: the callback has the force
free = ross.Rotor(
    rotor.shaft_elements, rotor.disk_elements, [ross.BearingElement(n=n, kxx=1.0, cxx=100) for n in (0, 24)]
)
# the callback has the displacements of the step before: at longer steps the motion grows without end


def callback(duration, step=2e-6):
    """Displacement of the disc along y in ROSS, m, and its wall time, s."""
    global steps
    steps = numpy.arange(0, duration + step / 2, step)
    force = numpy.zeros((len(steps), rotor.ndof))
    force[:, across + 1] = -300.0
    start = time.perf_counter()
    answer = free.run_time_response(100.0 * steps, force, steps, method="newmark", add_to_RHS=hertz)
    assert numpy.isfinite(answer.yout).all()
    return numpy.asarray(answer.yout)[:, across + 1], time.perf_counter() - start


callback(2e-4)  # its compiler works at the first call
short = 0.02
y_ross, theirs = callback(short)
y_halved, _ = callback(short, 1e-6)
own = numpy.abs(y_ross - y_halved[::2]).max() / numpy.abs(y_halved).max()
print(f"a simulated second on Hertzian balls: {theirs / short:.1f} s in ROSS (of {short:g} s)")
print(f"steps of half the length move ROSS's displacements along y by at most {own:.1e} of the largest")
for setting, seconds in ours.items():
    ratio = theirs / short / (seconds / duration)
    print(f"{setting}: {seconds / duration:.3f} s here (of {duration:g} s), 1/{ratio:.0f} of that")
