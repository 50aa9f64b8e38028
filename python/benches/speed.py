"""What the package costs beside the library, and what threads give. On two quiet cores:

    cargo build --release --workspace --examples
    pip install ./python
    python3 python/benches/speed.py target/release/examples/library_time
"""

import subprocess
import sys
import threading
import time
from pathlib import Path

import jeffcott as jc

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
FILE = SCENARIOS / "steady-7205c.toml"
REPEATS = 40


def library() -> list[float]:
    """Times of the library, s."""
    told = subprocess.run([sys.argv[1], str(FILE), str(REPEATS)], check=True, capture_output=True, text=True).stdout
    return [float(line.split()[0]) for line in told.splitlines()]


def package() -> list[float]:
    """Times of the same from Python, with a column taken, s."""
    times = []
    for _ in range(REPEATS):
        started = time.perf_counter()
        jc.Scenario(FILE).run()["x_m"]
        times.append(time.perf_counter() - started)
    return times


def threads(count: int, runs: int = 16) -> tuple[float, float]:
    """Wall and processor time of some runs on threads, s."""
    scenario = jc.Scenario(FILE).with_({"time.duration": "5 s"})
    left = iter(range(runs))
    lock = threading.Lock()

    def work() -> None:
        while True:
            with lock:
                if next(left, None) is None:
                    return
            scenario.run()

    wall, used = time.perf_counter(), time.process_time()
    workers = [threading.Thread(target=work) for _ in range(count)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return time.perf_counter() - wall, time.process_time() - used


def main() -> None:
    # in turn, so that what else the machine does meets both
    rounds = [(min(library()), min(package())) for _ in range(5)]
    in_rust, in_python = (min(times) for times in zip(*rounds))
    print(f"steady-7205c: library {1e3 * in_rust:.2f} ms, package {1e3 * in_python:.2f} ms, {in_python / in_rust:.3f} ×")
    one, two = threads(1), threads(2)
    print(f"one thread {one[0]:.2f} s (processor {one[1]:.2f} s), two {two[0]:.2f} s ({two[1]:.2f} s): {one[0] / two[0]:.2f} ×")
    print(f"processor time over wall time: one {one[1] / one[0]:.2f}, two {two[1] / two[0]:.2f}")


if __name__ == "__main__":
    main()
