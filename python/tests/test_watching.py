"""Long work is stopped, followed, and leaves other threads alone."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from conftest import short

import jeffcott as jc

LONG = """
import sys, time
import jeffcott as jc
scenario = jc.Scenario(sys.argv[1])
scenario.update({"time.duration": "2000 s", "output.samples_per_revolution": 16})
print("begun", flush=True)
try:
    WORK
except KeyboardInterrupt:
    print("stopped", flush=True)
"""

STUDY = 'jc.sweep(scenario, {"shaft.mass": ["5 kg", "6 kg", "7 kg"]}, OPTIONS)'


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to a child there")
@pytest.mark.parametrize(
    "work",
    [
        "scenario.run()",
        "scenario.campbell('60000 rpm', count=100_000)",
        "scenario.frequency_response('0 mm', '500 rpm', '9000 rpm', count=100_000)",
        STUDY.replace("OPTIONS", "threads=2"),
        "from concurrent.futures import ThreadPoolExecutor\n    with ThreadPoolExecutor(2) as pool:\n        "
        + STUDY.replace("OPTIONS", "executor=pool"),
    ],
    ids=["run", "campbell", "frequency_response", "study", "executor"],
)
def test_an_interrupt_ends_it(work: str, scenarios: Path) -> None:
    script = LONG.replace("WORK", work)
    command = [sys.executable, "-c", script, str(scenarios / "steady-7205c.toml")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "begun\n"
        time.sleep(1.0)
        assert child.poll() is None
        os.kill(child.pid, signal.SIGINT)
        out, err = child.communicate(timeout=60)
    assert (out, err, child.returncode) == ("stopped\n", "", 0)


def test_progress_is_reported_and_a_callback_can_stop_the_run(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    scenario["time.duration"] = "2000 s"
    scenario["output.samples_per_revolution"] = 16
    reported: list[float] = []

    class Enough(Exception):
        pass

    def progress(part: float) -> None:
        reported.append(part)
        if len(reported) == 3:
            raise Enough

    with pytest.raises(Enough):
        scenario.run(progress=progress)
    assert 0 < reported[0] < reported[1] < reported[2] < 1


def test_only_a_long_run_shows_a_line(
    scenarios: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from jeffcott import _progress

    for patience, line in ((3600.0, ""), (0.0, "100 %\n")):
        monkeypatch.setattr(_progress, "PATIENCE", patience)
        short(scenarios).run(progress=True)
        out, err = capsys.readouterr()
        assert out == "" and err.endswith(line) and bool(err) == bool(line)


def test_other_threads_go_on_during_a_run(scenarios: Path) -> None:
    scenario = jc.Scenario(scenarios / "steady-7205c.toml")
    scenario["time.duration"] = "5 s"
    ended = threading.Event()

    def run() -> None:
        scenario.run()
        ended.set()

    counted = 0
    thread = threading.Thread(target=run)
    thread.start()
    while not ended.is_set():
        counted += 1
        time.sleep(1e-3)
    thread.join()
    # with the lock held there would be a turn before and one after the run
    assert counted > 10
