"""What the oracles of both ROSes need: a node imports the real one's own Python, not the stand-in."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any
from unittest.mock import patch

from rosspin.messages import MessageFinder
from rosspin.run.imports import Imports


def stub(name: str, **contents: Any) -> ModuleType:
    """Make and import a module; with a ``__path__`` among its contents, a package whose modules are found there."""
    module = sys.modules[name] = ModuleType(name)
    vars(module).update(contents)
    return module


@contextmanager
def without(ros: int, *packages: str) -> Iterator[None]:
    """Within this context nothing of these packages has been imported; what is imported meanwhile is forgotten.

    Of the stand-in for ROS 1 or 2 only the messages are found.
    """
    beginnings = tuple(f"{package}." for package in packages)

    def take() -> dict[str, ModuleType]:
        names = [name for name in sys.modules if f"{name}.".startswith(beginnings)]
        return {name: sys.modules.pop(name) for name in names}

    before = take()
    finders = [MessageFinder(ros) if isinstance(each, Imports) else each for each in sys.meta_path]
    try:
        with patch.object(sys, "meta_path", finders):
            yield
    finally:
        take()
        sys.modules.update(before)
