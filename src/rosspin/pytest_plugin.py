"""The fixture ``start_node``. Every run of pytest loads this module, so it imports the rest when it is needed."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from .faults import Fault
    from .run.source import NodeLike
    from .run.steps import StartedNode

__all__ = ["start_node"]

_started = pytest.StashKey[list["StartedNode"]]()


@pytest.fixture
def start_node(request: pytest.FixtureRequest) -> Iterator[Callable[..., StartedNode]]:
    """Start nodes as ``rosspin.start`` does. They end with the test; its report has their consoles if it fails.

    A relative path is relative to the folder of the test's file.
    """
    from .run.steps import start

    started = request.node.stash[_started] = []
    with ExitStack() as stack:

        def start_node(
            node: NodeLike,
            args: Sequence[str] = (),
            parameters: Mapping[str, Any] | None = None,
            *,
            faults: Sequence[Fault] = (),
        ) -> StartedNode:
            path = node if callable(node) else os.path.normpath(request.path.parent / os.fspath(node))
            started.append(stack.enter_context(start(path, args, parameters, faults=faults)))
            return started[-1]

        yield start_node


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Generator[None, Any, None]:
    """Report the consoles of a failed test's nodes, and end them silently: the fixture would report a second error."""
    report = (yield).get_result()
    if call.when == "call" and call.excinfo:
        for node in item.stash.get(_started, []):
            if console := node.run.console:
                report.sections.append((f"Console of {node.name}", console))
            node.__exit__(call.excinfo.type, call.excinfo.value, call.excinfo.tb)
