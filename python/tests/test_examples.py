"""Every example of docs/python runs as it stands."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

EXAMPLES = sorted((ROOT / "docs" / "python").glob("*.py"))
NEEDED = {"scipy", "polars", "pandas"}


def test_there_are_seven() -> None:
    assert len(EXAMPLES) == 7


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(example: Path, tmp_path: Path) -> None:
    text = example.read_text(encoding="utf-8")
    for name in NEEDED:
        if f"import {name}" in text or f"from {name}" in text:
            pytest.importorskip(name)
    (tmp_path / "scenarios").symlink_to(ROOT / "scenarios", target_is_directory=True)
    done = subprocess.run(
        [sys.executable, "-W", "error", str(example)], cwd=tmp_path, capture_output=True, text=True, env=os.environ
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout


@pytest.mark.parametrize("page", ["README.md", "python/README.md", "docs/python/README.md", "docs/how-to/balancing.md"])
def test_what_a_page_shows_runs(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scenarios: Path) -> None:
    blocks = (ROOT / page).read_text(encoding="utf-8").split("```python\n")[1:]
    assert blocks
    (tmp_path / "scenarios").symlink_to(scenarios, target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    for block in blocks:
        exec(block.partition("```")[0], {})
