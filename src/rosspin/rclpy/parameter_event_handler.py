"""Calls back when parameters change, of any node (source: rclpy/parameter_event_handler.py)."""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Callable, Iterator
from importlib import import_module
from itertools import chain
from typing import TYPE_CHECKING, Any, NoReturn

from .own_topics import PARAMETER_EVENTS
from .qos import QoSProfile, qos_profile_parameter_events

if TYPE_CHECKING:
    from .node import Node

__all__ = ["ParameterCallbackHandle", "ParameterEventCallbackHandle", "ParameterEventHandler"]


class ParameterEventCallbackHandle:
    """A callback for all events."""

    def __init__(self, callback: Callable[[Any], None]) -> None:
        self.callback = callback
        self.mutex = threading.Lock()


class ParameterCallbackHandle(ParameterEventCallbackHandle):
    """A callback for one parameter of one node, by the node's full name."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Any], None]) -> None:
        super().__init__(callback)
        self.parameter_name = parameter_name
        self.node_name = node_name


class ParameterEventHandler:
    """Subscribes a node to /parameter_events; the options are as for ``create_subscription``.

    Of several callbacks the newest is called first, those for one parameter before those for all events.
    """

    class Callbacks:
        """The callbacks of a handler."""

        def __init__(self) -> None:
            self.parameter_callbacks: dict[tuple[str, str], list[ParameterCallbackHandle]] = defaultdict(list)
            self.event_callbacks: list[ParameterEventCallbackHandle] = []
            self.mutex = threading.Lock()

        def event_callback(self, event: Any) -> None:
            """Make the calls for an event, a message."""
            with self.mutex:
                for (name, node_name), handles in self.parameter_callbacks.items():
                    if parameter := ParameterEventHandler.get_parameter_from_event(event, name, node_name):
                        for handle in handles:
                            with handle.mutex:
                                handle.callback(parameter)
                for each in self.event_callbacks:
                    with each.mutex:
                        each.callback(event)

        def add_parameter_callback(
            self, parameter_name: str, node_name: str, callback: Callable[[Any], None]
        ) -> ParameterCallbackHandle:
            """Call ``callback(parameter)``, with a message, when a parameter has changed."""
            handle = ParameterCallbackHandle(parameter_name, node_name, callback)
            with self.mutex:
                self.parameter_callbacks[parameter_name, node_name].insert(0, handle)
            return handle

        def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
            """Stop calling it. Raises RuntimeError if it is not there."""
            key = handle.parameter_name, handle.node_name
            with self.mutex:
                if handle not in self.parameter_callbacks.get(key, ()):
                    _refuse()
                self.parameter_callbacks[key].remove(handle)
                if not self.parameter_callbacks[key]:
                    del self.parameter_callbacks[key]

        def add_parameter_event_callback(self, callback: Callable[[Any], None]) -> ParameterEventCallbackHandle:
            """Call ``callback(event)``, with a message, for each event."""
            handle = ParameterEventCallbackHandle(callback)
            with self.mutex:
                self.event_callbacks.insert(0, handle)
            return handle

        def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
            """Stop calling it. Raises RuntimeError if it is not there."""
            with self.mutex:
                if handle not in self.event_callbacks:
                    _refuse()
                self.event_callbacks.remove(handle)

    def __init__(self, node: Node, qos_profile: QoSProfile = qos_profile_parameter_events, **options: Any) -> None:
        self.node = node
        self.qos_profile = qos_profile
        self._callbacks = ParameterEventHandler.Callbacks()
        kind = import_module("rcl_interfaces.msg").ParameterEvent
        self.parameter_event_subscription = node.create_subscription(
            kind, PARAMETER_EVENTS, self._callbacks.event_callback, qos_profile, **options
        )

    def destroy(self) -> None:
        """Stop calling back."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(event: Any, parameter_name: str, node_name: str) -> Any:
        """Return a parameter that an event tells of, as a message, or None. ``node_name`` is the node's full name."""
        if event.node == node_name:
            for parameter in ParameterEventHandler.get_parameters_from_event(event):
                if parameter.name == parameter_name:
                    return parameter
        return None

    @staticmethod
    def get_parameters_from_event(event: Any) -> Iterator[Any]:
        """Yield the parameters that are new or changed, as messages."""
        yield from chain(event.new_parameters, event.changed_parameters)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Any], None]
    ) -> ParameterCallbackHandle:
        """Call ``callback(parameter)``, with a message, when a parameter of a node has changed.

        A name without a slash in front is below the node's own namespace; an empty one is the node itself.
        """
        return self._callbacks.add_parameter_callback(parameter_name, self._resolve_path(node_name), callback)

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Stop calling it. Raises RuntimeError if it is not there."""
        self._callbacks.remove_parameter_callback(handle)

    def add_parameter_event_callback(self, callback: Callable[[Any], None]) -> ParameterEventCallbackHandle:
        """Call ``callback(event)``, with a message, for each event."""
        return self._callbacks.add_parameter_event_callback(callback)

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Stop calling it. Raises RuntimeError if it is not there."""
        self._callbacks.remove_parameter_event_callback(handle)

    def _resolve_path(self, node_path: str | None = None) -> str:
        if not node_path:
            return self.node.get_fully_qualified_name()
        if node_path.startswith("/"):
            return node_path
        return f"{self.node.get_namespace().rstrip('/')}/{node_path}"


def _refuse() -> NoReturn:
    raise RuntimeError("Callback doesn't exist")
