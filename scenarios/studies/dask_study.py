"""Makes a study in parts on the workers of Dask and puts the parts together.

    pip install dask distributed
    python3 scenarios/studies/dask_study.py scenarios/studies/map-6306.toml --parts 16
    python3 scenarios/studies/dask_study.py STUDY.toml --parts 256 --scheduler tcp://HOST:8786

All workers see the folder of the study under the same path, and have `jeffcott`. A part whose worker dies is
made by another one, behind the rows that it left. The result has the bytes of `jeffcott study STUDY.toml`.
"""

import argparse
import ctypes
import pathlib
import signal
import subprocess
import sys

from distributed import Client, as_completed

PR_SET_PDEATHSIG = 1


def end_with_worker():
    """A worker that dies takes the part that it makes with it (Linux), so that no two make the same."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def make_part(jeffcott, study, out, part, parts, threads):
    """Makes one part; what the program says goes into the error."""
    command = [jeffcott, "study", study, "--out", out, "--shard", f"{part}/{parts}", "--threads", str(threads)]
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=end_with_worker)
    if done.returncode != 0:
        raise RuntimeError(f"part {part} of {parts}: {done.stderr.strip()}")
    return part


def make_study(client, jeffcott, study, out, parts, threads=1, told=print):
    """Makes all parts on the workers of `client`, then merges them; returns the folder of the study."""
    futures = [
        client.submit(make_part, jeffcott, str(study), str(out), part, parts, threads, retries=2, pure=False)
        for part in range(1, parts + 1)
    ]
    for count, future in enumerate(as_completed(futures), 1):
        part = future.result()
        # what nobody waits for any more is not made again where its worker dies later
        future.release()
        told(f"part {part} is made, {count} of {parts}")
    folder = pathlib.Path(out) / pathlib.Path(study).stem
    subprocess.run([jeffcott, "study", "merge", str(folder)], check=True)
    return folder


def main():
    parser = argparse.ArgumentParser(description="Makes a study on the workers of Dask.")
    parser.add_argument("study", type=pathlib.Path)
    parser.add_argument("--parts", type=int, default=16)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("output"))
    parser.add_argument("--scheduler", help="address; default: workers on this machine")
    parser.add_argument("--threads", type=int, default=1, help="threads of each part")
    parser.add_argument("--jeffcott", default="jeffcott", help="the program")
    given = parser.parse_args()
    with Client(given.scheduler) if given.scheduler else Client(threads_per_worker=1) as client:
        make_study(client, given.jeffcott, given.study.resolve(), given.out.resolve(), given.parts, given.threads)


if __name__ == "__main__":
    main()
