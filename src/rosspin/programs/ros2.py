"""What a C++ node of ROS 2 asks its host: its nodes have topics and services among those in Python.

rclcpp's executors, timers, parameters and loggers are in the program (``runtime/rclcpp.cpp``). What is shared is
rclpy's stand-in: both find each other on one graph by the same rules, and read a command line alike.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from itertools import count
from typing import Any

from ..messages import cdr
from ..rclpy import context, logging, own_topics
from ..rclpy.duration import Duration
from ..rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from ..rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NameValidationException,
    RCLError,
    UnknownROSArgsError,
)
from ..rclpy.node import Node
from ..rclpy.parameter import Parameter
from ..rclpy.qos import QoSProfile
from ..rclpy.services import Client, Header, Service
from ..rclpy.topics import Publisher, Subscription
from ..world.world import World

__all__ = ["Ros2"]

Event = Callable[[str, list[Any]], None]

_NAMES = {
    InvalidNodeNameException: "node name",
    InvalidNamespaceException: "namespace",
    InvalidTopicNameException: "topic name",
    InvalidServiceNameException: "service name",
}

_POLICIES = ("history", "depth", "reliability", "durability", "liveliness")
_LENGTHS = ("deadline", "lifespan", "liveliness_lease_duration")


class Ros2:
    """The answers to a program in its ``world``. ``event(what, values)`` gives something to it when it comes."""

    def __init__(self, world: World, event: Event) -> None:
        self._event = event
        self._contexts: list[context.Context] = []
        self._nodes: list[_Node] = []
        self._publishers: list[Publisher] = []
        self._subscriptions: list[Subscription] = []
        self._services: list[Service] = []
        self._clients: list[Client] = []
        self._requests: dict[int, Header] = {}  # those that are not answered, by their numbers
        self._numbers = count(1)
        self._asked: dict[str, Callable[..., Any]] = {
            "init": self._init,
            "node": self._node,
            "resolve": self._resolve,
            "publisher": self._publisher,
            "subscription_count": lambda number: self._publishers[number].get_subscription_count(),
            "subscription": self._subscription,
            "publisher_count": lambda number: len(self._subscriptions[number]._rosspin.peers),
            "service": self._service,
            "client": self._client,
            "service_is_ready": lambda number: self._clients[number].service_is_ready(),
            "send_request": self._send_request,
            "node_names": lambda node: {"names": self._nodes[node].get_fully_qualified_node_names()},
            "graph": lambda node: _graph(self._nodes[node]),
            "topics": lambda node: {"types": dict(self._nodes[node].get_topic_names_and_types())},
            "services": lambda node: {"types": dict(self._nodes[node].get_service_names_and_types())},
            "services_of": lambda node, *name: {
                "types": dict(self._nodes[node].get_service_names_and_types_by_node(*name))
            },
            "count": lambda node, what, name: {"count": getattr(self._nodes[node], f"count_{what}")(name)},
            "infos": self._infos,
        }
        self._handlers: dict[str, Callable[..., object]] = {
            "shutdown": lambda number: self._contexts[number].try_shutdown(),
            "publish": lambda number, data: self._publishers[number].publish(data),
            "assert_liveliness": lambda number: self._publishers[number].assert_liveliness(),
            "respond": self._respond,
            "log": self._log,
            "child_logger": lambda name, suffix: logging.get_logger(name).get_child(suffix),
            "parameter_event": lambda number, data: self._nodes[number].tell_parameter_event(data),
            "end_node": lambda number: self._nodes[number].destroy_node(),
            "end_publisher": lambda number: self._publishers[number].destroy(),
            "end_subscription": lambda number: self._subscriptions[number].destroy(),
            "end_service": lambda number: self._services[number].destroy(),
            "end_client": lambda number: self._clients[number].destroy(),
        }

    def answer(self, what: str, values: list[Any]) -> Any:
        """Answer what the program asks: an error of rclpy as a dictionary with its kind, ``error``, and its text."""
        try:
            return self._asked[what](*values)
        except NameValidationException as error:
            kind = next(kind for each, kind in _NAMES.items() if isinstance(error, each))
            return {"error": kind, "text": f"{error}\n"}
        except UnknownROSArgsError as error:
            return {"error": "unknown arguments", "words": _listed(str(error))}
        except RCLError as error:
            return {"error": "arguments" if what == "init" else "rcl", "text": str(error)}

    def take(self, what: str, values: list[Any]) -> None:
        """Do what the program has told."""
        self._handlers[what](*values)

    def message(self, subscription: int, data: bytes) -> Any:
        """Return a message that a subscription was given."""
        return cdr.deserialize(data, self._subscriptions[subscription].msg_type)

    # --- contexts and nodes ---

    def _init(self, words: list[str], with_logging: bool) -> dict[str, Any]:
        made = context.Context()
        made.init(words, initialize_logging=with_logging)
        self._contexts.append(made)
        own = logging.logs()
        form = own.form or logging._read_form(own)
        stream = sys.stdout if form.to_stdout else sys.stderr
        return {
            "id": len(self._contexts) - 1,
            "level": int(own.level),
            "levels": {name: int(level) for name, level in own.levels.items()},
            "console": own.console,
            "rosout": own.rosout is not None,
            "form": form.line,
            "to_stdout": form.to_stdout,
            "coloured": stream.isatty() if form.coloured is None else form.coloured,
        }

    def _node(
        self, number: int, name: str, namespace: str, words: list[str], use_global: bool, on_rosout: bool
    ) -> dict[str, Any]:
        node = _Node(self._feed, self._contexts[number], name, namespace, words, use_global, on_rosout)
        self._nodes.append(node)
        own = node._rosspin
        values = [each.parameters(own.full_name) for each in reversed(own.arguments)]
        return {
            "id": len(self._nodes) - 1,
            "name": own.name,
            "namespace": own.namespace,
            "full name": own.full_name,
            "logger": own.logger_name,
            "overrides": {key: value for each in values for key, value in each.items()},
        }

    def _resolve(self, node: int, name: str, is_service: bool, only_expand: bool) -> dict[str, Any]:
        return {"name": self._nodes[node]._rosspin_resolve(name, only_expand, is_service)}

    def _infos(self, node: int, what: str, topic: str, no_mangle: bool) -> dict[str, Any]:
        found = getattr(self._nodes[node], f"get_{what}_info_by_topic")(topic, no_mangle)
        return {
            "infos": [
                [
                    each.node_name,
                    each.node_namespace,
                    each.topic_type,
                    int(each.endpoint_type),
                    _policies(each.qos_profile),
                ]
                for each in found
            ]
        }

    def _log(self, level: int, name: str, text: str, file: str, function: str, line: int) -> None:
        """Publish a message on /rosout, if its logger belongs to a node."""
        publish = (logging.logs().rosout or {}).get(name)
        if publish:
            publish(level, name, text, line, own_topics.Code(file, function))

    # --- topics and services ---

    def _publisher(
        self, node: int, topic: str, kind: str, profile: dict[str, int], events: list[str]
    ) -> dict[str, Any]:
        callbacks = PublisherEventCallbacks(
            use_default_callbacks=False, **self._events(True, len(self._publishers), events)
        )
        made = self._nodes[node].create_publisher(_class(kind), topic, _profile(profile), event_callbacks=callbacks)
        self._publishers.append(made)
        return {"id": len(self._publishers) - 1, "name": made.topic_name}

    def _subscription(
        self, node: int, topic: str, kind: str, profile: dict[str, int], events: list[str]
    ) -> dict[str, Any]:
        callbacks = SubscriptionEventCallbacks(
            use_default_callbacks=False, **self._events(False, len(self._subscriptions), events)
        )
        made = self._nodes[node].create_subscription(
            _class(kind), topic, _ignore, _profile(profile), raw=True, event_callbacks=callbacks
        )
        self._subscriptions.append(made)
        self._feed()
        return {"id": len(self._subscriptions) - 1, "name": made.topic_name}

    def _events(self, is_publisher: bool, number: int, names: list[str]) -> dict[str, Callable[[Any], None]]:
        """Return callbacks that tell the program of events of an endpoint: of publishers, or of subscriptions."""

        def teller(name: str) -> Callable[[Any], None]:
            def tell(info: Any) -> None:
                counts = {key: int(value) for key, value in vars(info).items()}
                self._event("happened", [is_publisher, number, name, counts])

            return tell

        return {name: teller(name) for name in names}

    def _service(self, node: int, name: str, kind: str, profile: dict[str, int]) -> dict[str, Any]:
        made = self._nodes[node].create_service(_class(kind), name, _ignore, qos_profile=_profile(profile))
        self._services.append(made)
        return {"id": len(self._services) - 1, "name": made.service_name}

    def _client(self, node: int, name: str, kind: str, profile: dict[str, int]) -> dict[str, Any]:
        made = self._nodes[node].create_client(_class(kind), name, qos_profile=_profile(profile))
        self._clients.append(made)
        endpoint = made._rosspin
        meet = endpoint.meet

        def meet_and_tell(other: Any) -> None:
            meet(other)
            self._event("service", [])

        endpoint.meet = meet_and_tell  # type: ignore[method-assign]
        return {"id": len(self._clients) - 1, "name": made.service_name}

    def _send_request(self, number: int, data: bytes) -> int:
        endpoint = self._clients[number]._rosspin
        return endpoint.send_request(cdr.deserialize(data, endpoint.srv_type.Request))

    def _respond(self, service: int, number: int, data: bytes) -> None:
        endpoint = self._services[service]._rosspin
        header = self._requests.pop(number, None)
        if header and not endpoint.is_destroyed:
            endpoint.send_response(cdr.deserialize(data, endpoint.srv_type.Response), header)

    def _feed(self) -> None:
        """Give the program all that has come for it."""
        for number, subscription in enumerate(self._subscriptions):
            while taken := subscription._rosspin.take():
                data, info = taken
                times = [
                    info[name] for name in ("source_timestamp", "received_timestamp", "publication_sequence_number")
                ]
                self._event("message", [number, data, *times])
        for number, service in enumerate(self._services):
            while taken := service._rosspin.take():
                request, header = taken
                key = next(self._numbers)
                self._requests[key] = service._rosspin.accept(request, header)
                self._event("request", [number, key, cdr.serialize(request)])
        for number, client in enumerate(self._clients):
            while taken := client._rosspin.take():
                sequence, response = taken
                if response:
                    self._event("response", [number, sequence, cdr.serialize(response)])
        for node in self._nodes:
            node.tell_events()


class _Node(Node):
    """What other nodes see of one in C++. It has no executor: ``feed()`` is called when something comes for it."""

    def __init__(
        self,
        feed: Callable[[], None],
        around: context.Context,
        name: str,
        namespace: str,
        words: list[str],
        use_global_arguments: bool,
        enable_rosout: bool,
    ) -> None:
        super().__init__(
            name,
            context=around,
            namespace=namespace,
            cli_args=_ros_arguments(words),
            use_global_arguments=use_global_arguments,
            enable_rosout=enable_rosout,
            start_parameter_services=False,
        )
        self._rosspin.nudge = feed  # type: ignore[method-assign]

    def tell_parameter_event(self, data: bytes) -> None:
        """Note which parameters are new, and publish which have changed, if something has looked."""
        for each in cdr.deserialize(data, _class("rcl_interfaces/msg/ParameterEvent")).new_parameters:
            self._parameters.setdefault(each.name, Parameter.from_parameter_msg(each))
        if publisher := self._parameter_event_publisher:
            publisher.publish(data)

    def _rosspin_tell_parameters(self, *changed: object) -> None:
        """Tell of the ones that the program makes; it has the same as this node from the beginning."""

    def tell_events(self) -> None:
        """Tell of what has happened to its endpoints."""
        for waitable in self._rosspin_waitables:
            if call := waitable._rosspin_take():
                function, arguments, _ = call
                function(*arguments)


def _ignore(*message: Any) -> None:
    """Stand in for a callback: the messages are taken otherwise."""


def _ros_arguments(words: list[str]) -> list[str] | None:
    """Return the arguments of a node from ``--ros-args`` on."""
    return words[words.index("--ros-args") :] if "--ros-args" in words else None


def _listed(text: str) -> list[str]:
    """Read a list as Python prints it: of options that are not known."""
    return [word.strip("'\" ") for word in text.strip("[]").split(",")]


def _graph(node: Node) -> dict[str, Any]:
    """Return all that a node knows of the graph."""
    topics = [name for name, _ in node.get_topic_names_and_types()]
    services = [name for name, _ in node.get_service_names_and_types()]
    return {
        "nodes": node.get_fully_qualified_node_names(),
        "topics": {each: [node.count_publishers(each), node.count_subscribers(each)] for each in topics},
        "services": {each: [node.count_services(each), node.count_clients(each)] for each in services},
    }


def _class(kind: str) -> Any:
    """Return the class of a message or a service, as in std_msgs/msg/UInt32."""
    package, folder, name = kind.split("/")
    return getattr(import_module(f"{package}.{folder}"), name)


def _policies(profile: QoSProfile) -> dict[str, int]:
    """Return what :func:`_profile` is given."""
    numbers = {name: int(getattr(profile, name)) for name in _POLICIES}
    return {**numbers, **{name: getattr(profile, name).nanoseconds for name in _LENGTHS}}


def _profile(given: dict[str, int]) -> QoSProfile:
    lengths = {name: Duration(nanoseconds=given[name]) for name in _LENGTHS}
    return QoSProfile(**{**given, **lengths})
