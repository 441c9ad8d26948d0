"""The services by which others read and set the parameters of a node (source: rclpy/parameter_service.py)."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any
from weakref import ref

from .discovery import Participants
from .exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from .parameter import Parameter
from .qos import qos_profile_parameters
from .services import ServiceEndpoints

if TYPE_CHECKING:
    from ..world.graph import Graph
    from .node import Node

__all__ = ["ParameterService"]

# Below the node's own name, each with its type.
SERVICES = {
    "describe_parameters": "DescribeParameters",
    "get_parameters": "GetParameters",
    "get_parameter_types": "GetParameterTypes",
    "list_parameters": "ListParameters",
    "set_parameters": "SetParameters",
    "set_parameters_atomically": "SetParametersAtomically",
}


class ParameterService:
    """Offers these services of a node. What is not declared gives an empty answer, or a reason.

    ``types`` has their classes: the module ``rcl_interfaces.srv`` of the node's process.
    """

    def __init__(self, node: Node, types: ModuleType | None = None) -> None:
        self._node_weak_ref = ref(node)
        types = types or import_module("rcl_interfaces.srv")
        for name, kind in SERVICES.items():
            callback = getattr(self, f"_{name}")
            full_name = f"{node.get_name()}/{name}"
            node.create_service(getattr(types, kind), full_name, callback, qos_profile=qos_profile_parameters)

    @property
    def _rosspin_node(self) -> Node:
        if (node := self._node_weak_ref()) is None:
            raise ReferenceError("Expected valid node weak reference")
        return node

    def _describe_parameters(self, request: Any, response: Any) -> Any:
        response.descriptors = self._all(request.names, self._rosspin_node.describe_parameter)
        return response

    def _get_parameters(self, request: Any, response: Any) -> Any:
        node = self._rosspin_node
        response.values = self._all(request.names, lambda name: node.get_parameter(name).get_parameter_value())
        return response

    def _get_parameter_types(self, request: Any, response: Any) -> Any:
        response.types = self._all(request.names, self._rosspin_node.get_parameter_type)
        return response

    @staticmethod
    def _all(names: list[str], get: Callable[[str], Any]) -> list[Any]:
        try:
            return [get(name) for name in names]
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            return []

    def _list_parameters(self, request: Any, response: Any) -> Any:
        response.result = self._rosspin_node.list_parameters(request.prefixes, request.depth)
        return response

    def _set_parameters(self, request: Any, response: Any) -> Any:
        response.results = [self._set([parameter]) for parameter in request.parameters]
        return response

    def _set_parameters_atomically(self, request: Any, response: Any) -> Any:
        response.result = self._set(request.parameters)
        return response

    def _set(self, parameters: list[Any]) -> Any:
        try:
            return self._rosspin_node.set_parameters_atomically(list(map(Parameter.from_parameter_msg, parameters)))
        except ParameterNotDeclaredException as error:
            result = import_module("rcl_interfaces.msg").SetParametersResult
            return result(successful=False, reason=str(error))


def look(graph: Graph, service: str) -> None:
    """Let a node offer these services, also one that is still to come, if ``service`` is the full name of one."""
    of, _, word = service.rpartition("/")
    if word in SERVICES:
        graph.part(ServiceEndpoints).asked.add(of)
        for node in graph.part(Participants).all_nodes():
            if node.full_name == of and (made_by := node.node()):
                made_by._rosspin_start_services()
