"""The notebooks of docs/python are their programs with outputs. `JEFFCOTT_BLESS=1 pytest python/tests/test_notebooks.py` makes
them anew."""

import json
import os
import re
import warnings
from pathlib import Path
from typing import Any

import notebooks
import pytest
from conftest import ROOT

SHOWN = ["1_first_run", "2_run_up", "4_bearing"]
"""Those that are kept: small, and of numpy alone."""
LARGEST = 200_000
"""Most bytes of a notebook."""


def program(name: str) -> list[dict[str, Any]]:
    return notebooks.cells((ROOT / "docs" / "python" / f"{name}.py").read_text(encoding="utf-8"))


def reported(cell: dict[str, Any]) -> list[tuple[str, str]]:
    """Kinds and words of the outputs; numbers differ in their last digits between machines."""
    found = []
    for output in cell.get("outputs", []):
        for kind, lines in output.get("data", {"stdout": output.get("text")}).items():
            words = re.sub(r"<[^>]*>", " ", "".join(lines)) if kind != "stdout" else "".join(lines)
            found.append((kind, " ".join(re.sub(r"[-+−]?\d[\d.,]*(e[-+]?\d+)?", "#", words).split())))
    return found


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "scenarios").symlink_to(ROOT / "scenarios", target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", SHOWN)
def test_a_notebook_shows_what_its_program_does(name: str, folder: Path) -> None:
    made = program(name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        notebooks.run_plainly(made)
    text = notebooks.text(made)
    assert len(text.encode()) < LARGEST
    file = ROOT / "docs" / "python" / f"{name}.ipynb"
    if os.environ.get("JEFFCOTT_BLESS"):
        file.write_text(text, encoding="utf-8")
    kept = json.loads(file.read_text(encoding="utf-8"))["cells"]
    again = "make it anew: JEFFCOTT_BLESS=1"
    assert [cell["source"] for cell in kept] == [cell["source"] for cell in made], again
    assert [reported(cell) for cell in kept] == [reported(cell) for cell in made], again


@pytest.mark.parametrize("name", SHOWN)
def test_the_plain_runner_does_what_jupyter_does(name: str, folder: Path) -> None:
    pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    plain, executed = program(name), program(name)
    notebooks.run_plainly(plain)
    notebooks.run_in_jupyter(executed, folder)
    assert plain == executed


def test_what_a_cell_prints_is_one_output_however_long_it_takes(folder: Path) -> None:
    pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    slow = "# %%\nimport time\n\nfor line in range(3):\n    print('speed', end=' ')\n    time.sleep(0.5)\n    print(line)"
    plain, executed = notebooks.cells(slow), notebooks.cells(slow)
    notebooks.run_plainly(plain)
    notebooks.run_in_jupyter(executed, folder)
    assert plain == executed
    assert plain[0]["outputs"][0]["text"] == ["speed 0\n", "speed 1\n", "speed 2\n"]
