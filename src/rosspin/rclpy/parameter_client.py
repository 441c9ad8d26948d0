"""Reads and sets the parameters of another node (source: rclpy/parameter_client.py)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

from .own_topics import PARAMETER_EVENTS
from .parameter import Parameter, parameter_dict_from_yaml_file
from .parameter_service import SERVICES
from .qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from .services import look_until

if TYPE_CHECKING:
    from .callback_groups import CallbackGroup
    from .node import Node
    from .services import Client
    from .task import Future
    from .topics import Subscription

__all__ = ["AsyncParameterClient"]

Callback = Callable[["Future"], Any]


class AsyncParameterClient:
    """Asks the parameter services of a node. Each method returns a future of the answer, a message.

    ``callback(future)`` is called when it is there. Parameters may be given as Parameters or as messages.
    """

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        self.node = node
        self.remote_node_name = remote_node_name
        self._rosspin_types = import_module("rcl_interfaces.srv")
        self._rosspin_clients: dict[str, Client] = {
            name: node.create_client(
                getattr(self._rosspin_types, kind),
                f"{remote_node_name}/{name}",
                qos_profile=qos_profile,
                callback_group=callback_group,
            )
            for name, kind in SERVICES.items()
        }

    def services_are_ready(self) -> bool:
        """Whether all services are there."""
        return all(client.service_is_ready() for client in self._rosspin_clients.values())

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Look every 0.25 s whether all services are there, for ``timeout_sec`` (None: no limit). Return whether."""
        return look_until(self.services_are_ready, None, timeout_sec)  # also after rclpy.shutdown()

    def _rosspin_ask(self, name: str, callback: Callback | None, **fields: Any) -> Future:
        future = self._rosspin_clients[name].call_async(getattr(self._rosspin_types, SERVICES[name]).Request(**fields))
        if callback:
            future.add_done_callback(callback)
        return future

    def list_parameters(
        self, prefixes: list[str] | None = None, depth: int | None = None, callback: Callback | None = None
    ) -> Future:
        """Ask for the names below any of the prefixes (None: all), with fewer than ``depth`` separators below it."""
        return self._rosspin_ask("list_parameters", callback, prefixes=prefixes or [], depth=depth or 0)

    def get_parameters(self, names: list[str], callback: Callback | None = None) -> Future:
        """Ask for values."""
        return self._rosspin_ask("get_parameters", callback, names=names)

    def describe_parameters(self, names: list[str], callback: Callback | None = None) -> Future:
        """Ask for descriptors."""
        return self._rosspin_ask("describe_parameters", callback, names=names)

    def get_parameter_types(self, names: list[str], callback: Callback | None = None) -> Future:
        """Ask for the numbers of types."""
        return self._rosspin_ask("get_parameter_types", callback, names=names)

    def set_parameters(self, parameters: Sequence[Any], callback: Callback | None = None) -> Future:
        """Set parameters one by one."""
        return self._rosspin_ask("set_parameters", callback, parameters=_messages(parameters))

    def set_parameters_atomically(self, parameters: Sequence[Any], callback: Callback | None = None) -> Future:
        """Set all parameters or none."""
        return self._rosspin_ask("set_parameters_atomically", callback, parameters=_messages(parameters))

    def delete_parameters(self, names: list[str], callback: Callback | None = None) -> Future:
        """Unset parameters, which only those with dynamic typing allow."""
        return self.set_parameters([Parameter(name) for name in names], callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callback | None = None
    ) -> Future:
        """Set, one by one, what a file says; see ``parameter_dict_from_yaml_file``."""
        return self.set_parameters([*parameter_dict_from_yaml_file(parameter_file, use_wildcard).values()], callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Callback | None = None
    ) -> Future:
        """Set all of what a file says, or nothing."""
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters_atomically([*found.values()], callback)

    def on_parameter_event(
        self, callback: Callable[[Any], Any], qos_profile: QoSProfile = qos_profile_parameter_events, **options: Any
    ) -> Subscription:
        """Subscribe to the events of all nodes; the options are as for ``create_subscription``."""
        kind = import_module("rcl_interfaces.msg").ParameterEvent
        return self.node.create_subscription(kind, PARAMETER_EVENTS, callback, qos_profile, **options)


def _messages(parameters: Sequence[Any]) -> list[Any]:
    return [each.to_parameter_msg() if isinstance(each, Parameter) else each for each in parameters]
