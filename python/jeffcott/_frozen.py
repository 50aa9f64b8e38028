"""Trees that cannot be changed: parts of scenarios, and documents of results."""

from __future__ import annotations

from typing import Any


def _refused(self: object, *_: object, **__: object) -> Any:
    raise TypeError(
        'this is read only: a scenario is written by the paths of its keys, as scenario["shaft.mass"] = "6 kg"; '
        "copy.deepcopy makes a copy that can be changed"
    )


def _frozen_type(name: str, base: type, writing: str) -> Any:
    """A subclass whose methods that write refuse it, and whose copies in depth are of the base."""
    members = dict.fromkeys(writing.split(), _refused)
    return type(name, (base,), {**members, "__reduce__": lambda self: (base, (base(self),)), "__module__": __name__})


FrozenDict = _frozen_type(
    "FrozenDict", dict, "__setitem__ __delitem__ __ior__ clear pop popitem setdefault update"
)
FrozenList = _frozen_type(
    "FrozenList",
    list,
    "__setitem__ __delitem__ __iadd__ __imul__ append clear extend insert pop remove reverse sort",
)


def frozen(tree: Any) -> Any:
    """A tree of JSON whose dicts and lists cannot be changed; they are equal to those that can."""
    if isinstance(tree, dict):
        return FrozenDict({key: frozen(value) for key, value in tree.items()})
    if isinstance(tree, list):
        return FrozenList(map(frozen, tree))
    return tree
