"""The fixture ``start_node``. Every run of pytest loads this module, so it imports the rest when it is needed."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from .clocks.explored import Order
    from .faults import Fault
    from .run.roslaunch.launch import Node
    from .run.source import NodeLike
    from .run.steps import StartedNode

__all__ = ["start_node"]

_started = pytest.StashKey[list["StartedNode"]]()


class _StartNode:
    """The fixture: it starts nodes in the ``order`` that a test is explored in, if it is."""

    # What fails a test.
    failures = (Exception, pytest.fail.Exception)

    def __init__(self, request: pytest.FixtureRequest, stack: ExitStack) -> None:
        self.order: Order | None = None
        self._folder = request.path.parent
        self._stack = stack
        self._started: list[StartedNode] = []
        request.node.stash[_started] = self._started

    def __call__(
        self,
        node: NodeLike | Sequence[NodeLike | Node],
        args: Sequence[str] = (),
        parameters: Mapping[str, Any] | None = None,
        *,
        faults: Sequence[Fault] = (),
        jitter: float = 0.0,
    ) -> StartedNode:
        __tracebackhide__ = True
        from .run.simulate import with_jitter
        from .run.steps import start_in_order

        started = start_in_order(self.order, self._resolved(node), args, parameters, with_jitter(faults, jitter))
        self._started.append(self._stack.enter_context(started))
        return started

    def _resolved(self, node: Any) -> Any:
        """Return a node, or several, whose relative paths are relative to the folder of the test's file."""
        if isinstance(node, (list, tuple)):
            return [self._resolved(each) for each in node]
        if isinstance(node, (str, os.PathLike)):
            return os.path.normpath(self._folder / os.fspath(node))
        from .run.roslaunch.launch import Node

        return dataclasses.replace(node, node=self._resolved(node.node)) if isinstance(node, Node) else node

    def end(self) -> None:
        """End the nodes now, as the fixture does after the test. Raises what that finds."""
        __tracebackhide__ = True
        self._stack.close()

    @contextmanager
    def in_order(self, order: Order) -> Iterator[None]:
        """Within this context it is as new, and starts nodes in an order. They end with the context."""
        before = self.order, self._stack
        try:
            with ExitStack() as stack:
                self.order, self._stack = order, stack
                yield
        finally:
            self.order, self._stack = before
            self._started.clear()


@pytest.fixture
def start_node(request: pytest.FixtureRequest) -> Iterator[Callable[..., StartedNode]]:
    """Start nodes as ``rosspin.start`` does. They end with the test; its report has their consoles if it fails.

    A relative path is relative to the folder of the test's file.
    """
    with ExitStack() as stack:
        yield _StartNode(request, stack)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Generator[None, Any, None]:
    """Report the consoles of a failed test's nodes, and end them silently: the fixture would report a second error."""
    report = (yield).get_result()
    if call.when == "call" and call.excinfo:
        for node in item.stash.get(_started, []):
            if console := node.run.console:
                report.sections.append((f"Console of {node.name}", console))
            node.__exit__(call.excinfo.type, call.excinfo.value, call.excinfo.tb)


@pytest.hookimpl
def pytest_exception_interact(call: pytest.CallInfo[None], report: pytest.CollectReport | pytest.TestReport) -> None:
    """Say what to do if a test, or its file, imports a ROS that is not installed."""
    error = call.excinfo and (call.excinfo.value.__cause__ or call.excinfo.value)
    if isinstance(error, ModuleNotFoundError) and error.name:
        from .run.kinds import is_of_a_ros

        if is_of_a_ros(error.name):
            text = (
                f"{error.name} is there only while a node runs. Import it in a node's file, or in the function that is "
                "the node, and start that with the fixture start_node, or with rosspin.simulate."
            )
            report.sections.append(("rosspin", text))
