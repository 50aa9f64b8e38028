"""Notebooks with outputs from programs of cells (`# %%`): executed by Jupyter's kernel, or by a plain runner of the same rules."""

import ast
import contextlib
import io
import json
from pathlib import Path
from typing import Any

RICH = {"image/svg+xml": "_repr_svg_", "text/html": "_repr_html_"}
"""Forms of a value that a notebook shows instead of its text."""


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


def cells(program: str) -> list[dict[str, Any]]:
    """The cells of a program, without outputs."""
    found: list[dict[str, Any]] = []
    for part in program.split("# %%")[1:]:
        head, _, body = part.partition("\n")
        cell: dict[str, Any] = {"id": f"cell-{len(found) + 1}", "metadata": {}}
        if head.strip() == "[markdown]":
            prose = "\n".join(line.removeprefix("#").removeprefix(" ") for line in body.strip().splitlines())
            cell |= {"cell_type": "markdown", "source": _lines(prose)}
        else:
            cell |= {"cell_type": "code", "source": _lines(body.strip()), "execution_count": None, "outputs": []}
        found.append(cell)
    return found


def _result(value: Any) -> dict[str, Any]:
    """What a notebook keeps of the value of a cell."""
    for kind, form in RICH.items():
        if hasattr(value, form):
            return {kind: _lines(getattr(value, form)())}
    return {"text/plain": _lines(repr(value))}


def run_plainly(notebook: list[dict[str, Any]]) -> None:
    """Executes the cells in turn: what they print, and the value of the expression that a cell ends with."""
    names: dict[str, Any] = {"__name__": "__main__"}
    code = [cell for cell in notebook if cell["cell_type"] == "code"]
    for count, cell in enumerate(code, 1):
        tree = ast.parse("".join(cell["source"]))
        last = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None  # type: ignore[attr-defined]
        printed, value = io.StringIO(), None
        with contextlib.redirect_stdout(printed):
            exec(compile(tree, cell["id"], "exec"), names)
            if last is not None:
                value = eval(compile(last, cell["id"], "eval"), names)
        outputs: list[dict[str, Any]] = []
        if printed.getvalue():
            outputs.append({"output_type": "stream", "name": "stdout", "text": _lines(printed.getvalue())})
        if value is not None:
            outputs.append(
                {"output_type": "execute_result", "execution_count": count, "metadata": {}, "data": _result(value)}
            )
        cell |= {"execution_count": count, "outputs": outputs}


def run_in_jupyter(notebook: list[dict[str, Any]], folder: Path) -> None:
    """Executes the cells by a kernel of Jupyter, and keeps of their outputs what the plain runner keeps."""
    import nbclient
    import nbformat

    node = nbformat.reads(text(notebook), as_version=4)
    nbclient.NotebookClient(node, kernel_name="python3", resources={"metadata": {"path": str(folder)}}).execute()
    for cell, executed in zip(notebook, node.cells):
        if cell["cell_type"] != "code":
            continue
        kept: list[dict[str, Any]] = []
        for output in executed.outputs:
            if output.output_type == "stream" and output.name == "stdout":
                # The kernel sends what is printed every 0.2 s, wherever that cuts it.
                before = kept.pop()["text"] if kept and kept[-1]["output_type"] == "stream" else []
                printed = _lines("".join(before) + output.text)
                kept.append({"output_type": "stream", "name": "stdout", "text": printed})
            elif output.output_type == "execute_result":
                kinds = [kind for kind in RICH if kind in output.data] or ["text/plain"]
                data = {kinds[0]: _lines(output.data[kinds[0]])}
                number = executed.execution_count
                kept.append({"output_type": "execute_result", "execution_count": number, "metadata": {}, "data": data})
        cell |= {"execution_count": executed.execution_count, "outputs": kept}


def document(notebook: list[dict[str, Any]]) -> dict[str, Any]:
    """The notebook as its file has it."""
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": notebook, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def text(notebook: list[dict[str, Any]]) -> str:
    """The text of the file."""
    return json.dumps(document(notebook), indent=1, ensure_ascii=False) + "\n"
