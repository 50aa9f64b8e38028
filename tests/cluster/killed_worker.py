"""Makes a study on two workers of Dask, kills one of them on the way, and compares the result byte by byte.

    python3 tests/cluster/killed_worker.py target/release/jeffcott

Needs dask and distributed.
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from distributed import Client, LocalCluster

root = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(root / "scenarios" / "studies"))
from dask_study import make_study  # noqa: E402

PARTS = 6


def kill_a_worker(client, killed):
    """Once the first part is made, the worker of another one dies in the midst of it."""

    def told(text):
        print(text, flush=True)
        if killed:
            return
        busy = [worker for worker, tasks in client.processing().items() if tasks]
        pids = client.run(os.getpid)
        killed.append(pids[busy[0]])
        os.kill(killed[0], signal.SIGKILL)
        print(f"killed worker {killed[0]}", flush=True)

    return told


def main():
    jeffcott = str(pathlib.Path(sys.argv[1]).resolve())
    study = root / "scenarios" / "studies" / "resonance-7205c.toml"
    with tempfile.TemporaryDirectory() as folder:
        whole, parts = pathlib.Path(folder) / "whole", pathlib.Path(folder) / "parts"
        subprocess.run([jeffcott, "study", str(study), "--out", str(whole)], check=True, stdout=subprocess.DEVNULL)
        killed = []
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
            with Client(cluster) as client:
                made = make_study(client, jeffcott, study, parts, PARTS, told=kill_a_worker(client, killed))
        assert killed, "no worker was killed"
        names = sorted(path.name for path in (whole / study.stem).iterdir())
        assert "runs.json" in names, names
        for name in names:
            assert (whole / study.stem / name).read_bytes() == (made / name).read_bytes(), f"{name} differs"
        print(f"{len(names)} files are those of the study made in one piece: {', '.join(names)}")


if __name__ == "__main__":
    main()
