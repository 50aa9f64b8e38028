"""The package as it stands: types, words, the time of its import."""

import inspect
import os
import subprocess
import sys
from pathlib import Path

import pytest

import jeffcott as jc

LIMIT = 0.35
"""Longest import beside that of numpy, in imports of numpy: seconds depend on the machine."""


def test_stubs_are_those_of_the_module() -> None:
    pytest.importorskip("mypy")
    checked = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "jeffcott._jeffcott", "--ignore-disjoint-bases"],
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_types_hold(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--package", "jeffcott"]
    checked = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_it_says_that_it_is_typed() -> None:
    assert (Path(jc.__file__).parent / "py.typed").exists()


def test_everything_public_is_reported() -> None:
    unnamed = []
    for name in jc.__all__:
        thing = getattr(jc, name)
        if not callable(thing):
            continue
        if not inspect.getdoc(thing):
            unnamed.append(name)
        members = vars(thing).items() if inspect.isclass(thing) else []
        for member, value in members:
            if member.startswith("_") or not (callable(value) or isinstance(value, property)):
                continue
            if not inspect.getdoc(value):
                unnamed.append(f"{name}.{member}")
    assert unnamed == []


def test_the_import_is_short() -> None:
    code = (
        "from time import process_time as now; start = now(); import numpy; between = now(); import jeffcott;"
        "print((now() - between) / (between - start))"
    )
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}
    parts = [
        float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment).stdout)
        for _ in range(5)
    ]
    assert min(parts) < LIMIT
