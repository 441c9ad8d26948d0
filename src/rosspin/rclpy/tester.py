"""The node of a test: it is connected to every topic of the other nodes as soon as they have it."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from ..clocks.clock import NS, nanoseconds
from ..messages.ros2 import Message, received, transfer
from ..world import tester
from ..world.world import World
from .action import GoalIds
from .endpoints import GraphEntry, kind_of
from .parameter_service import look
from .qos import Policies, QoSProfile, qos_profile_services_default
from .services import Header, ServerEndpoint, ServiceEndpoints
from .topics import PublisherEndpoint, SubscriptionEndpoint

__all__ = ["Tester", "give_parameters"]

_TIMES = {"builtin_interfaces/Time", "builtin_interfaces/Duration"}


class Tester(tester.Tester):
    """A tester on ROS 2 in its own ``world``; ``messages`` makes classes, as in ``messages["std_msgs/UInt32"]``."""

    def __init__(self, world: World, messages: Any, fail: Callable[[Exception], None]) -> None:
        super().__init__(world, messages, fail)
        self._publications: list[_Counterpart] = []

    def publication(self, subscription: GraphEntry) -> GraphEntry:
        """The tester's endpoint for a subscription."""
        self._publications.append(_Counterpart(subscription.endpoint))
        return self._publications[-1].entry

    def _listen(self, publication: GraphEntry) -> GraphEntry:
        return _Counterpart(publication.endpoint).entry

    def message(self, type_: str, fields: Mapping[str, Any]) -> Any:
        """Make a message of a type such as std_msgs/UInt32 or std_msgs/msg/UInt32: see the base."""
        return super().message(type_.replace("/msg/", "/"), fields)

    def _publish(self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any]) -> bool:
        endpoints = [endpoint for endpoint in self._publications if endpoint.entry.topic == name and endpoint.peers]
        for endpoint in endpoints:
            endpoint.send(self._message(endpoint.msg_type, args, fields))
        return bool(endpoints)

    def _offered(self, name: str) -> dict[str, str]:
        look(self._graph, name)
        return {name: service.entry.type for name, service in self._graph.part(ServiceEndpoints).offered().items()}

    def _request(
        self, name: str, args: tuple[Any, ...], fields: Mapping[str, Any], then: tester.Then | None
    ) -> Callable[[], None]:
        service = self._graph.part(ServiceEndpoints).offered()[name]
        kind = service.srv_type.Request
        request = transfer(self._message(kind, args, fields), kind)

        def send() -> None:
            call = service.world.recording.add_call(name, tester.NAME, lambda: request)
            client = _Client(self._world, service, then)
            service.meet(client)
            service.receive(request, Header(client, 1, call))

        return send

    def send_goal(self, action: str, fields: Mapping[str, Any]) -> None:
        """See the base."""
        goal_id = {"uuid": self._graph.part(GoalIds).new()}
        result = f"/{action.removeprefix('/')}/_action/get_result"

        def ask_for_result(response: Any) -> None:
            if response.accepted and result in self._offered(result):
                self._request(result, (), {"goal_id": goal_id}, None)()

        self.call(f"{action}/_action/send_goal", (), {"goal_id": goal_id, "goal": fields}, ask_for_result)

    def serve(self, service: str, type_: str, handler: tester.Handler) -> None:
        """Offer a service of a type such as std_srvs/SetBool or std_srvs/srv/SetBool: see the base."""
        super().serve(service, type_.replace("/srv/", "/"), handler)

    def _serve(self, name: str, srv_type: Any, handler: tester.Handler) -> None:
        service = _Service(self._world, name, srv_type, partial(self._response, srv_type.Response, handler))
        for client in self._graph.part(ServiceEndpoints).add(service):
            service.meet(client)
            client.meet(service)

    def _message(self, data_class: type[Message], args: tuple[Any, ...], fields: Mapping[str, Any]) -> Message:
        """Make a message from what ``publish`` is given: a message, all of its fields, or some by name or in a dict."""
        if len(args) == 1 and isinstance(args[0], Message) and not fields:
            if repr(type(args[0])) != repr(data_class):  # each process has a class of its own with that name
                raise TypeError(f"Expected {data_class}, got {type(args[0])}")
            return args[0]
        if len(args) == 1 and hasattr(args[0], "get_fields_and_field_types") and not fields:
            if repr(type(args[0])) != repr(data_class):
                raise TypeError(f"Expected {data_class}, got {type(args[0])}")
            return data_class(**self._filled(data_class, _fields_of(args[0])))
        names = data_class.get_fields_and_field_types()
        if len(args) == 1 and isinstance(args[0], Mapping) and not fields and args[0].keys() <= names.keys():
            return data_class(**self._filled(data_class, args[0]))
        if args and (fields or len(args) != len(names)):
            raise TypeError(f"{data_class.__name__} has the fields {', '.join(names) or 'none'}: give all, or by name")
        return data_class(**self._filled(data_class, fields or dict(zip(names, args, strict=False))))

    @staticmethod
    def _types(data_class: type[Message]) -> dict[str, str]:
        kinds = {name: field.kind for name, field in data_class._rosspin_fields.items()}
        return {name: f"{kind.base}[]" if kind.array else kind.base for name, kind in kinds.items()}

    def _number(self, type_: str, value: float) -> Any:
        if type_ not in _TIMES:
            return value
        sec, nanosec = divmod(nanoseconds(value), NS)
        return self._messages[type_](sec=sec, nanosec=nanosec)


def _fields_of(value: Any) -> Any:
    """Take a message of a real ROS apart: a test next to which one is installed may have imported its class."""
    if hasattr(value, "get_fields_and_field_types"):
        return {name: _fields_of(getattr(value, name)) for name in value.get_fields_and_field_types()}
    return [_fields_of(each) for each in value] if isinstance(value, list) else value


class _Counterpart:
    """The tester's counterpart of a node's endpoint of a topic, with the same quality of service."""

    def __init__(self, other: PublisherEndpoint | SubscriptionEndpoint) -> None:
        self.world = other.world
        self.msg_type = other.msg_type
        self.entry = GraphEntry(other.entry.topic, other.entry.type, self)
        self.policies = other.policies
        self.peers: list[Any] = []
        self.kept: tuple[tuple[Message, int], ...] = ()

    def join(self, other: PublisherEndpoint | SubscriptionEndpoint) -> None:
        """Be connected to the node's endpoint."""
        self.peers.append(other)

    def part(self, other: PublisherEndpoint | SubscriptionEndpoint) -> None:
        """Learn that the node's endpoint is gone."""
        self.peers.remove(other)

    def receive(self, publisher: PublisherEndpoint, message: Message, sent: int) -> None:
        """Do nothing: the run has recorded the message."""

    def hear(self, publisher: PublisherEndpoint) -> None:
        """Do nothing: no one asks."""

    def send(self, message: Message) -> None:
        """Publish a message."""
        for peer in self.peers:
            peer.receive(self, message, self.world.clock.system())


class _ServiceEndpoint:
    """The tester's endpoint of a service. The nodes' endpoints know it immediately."""

    asks: bool
    is_gone = False
    gid = bytes(16)

    def __init__(self, world: World, name: str, kind: str, qos: QoSProfile) -> None:
        self.world = world
        self.entry = GraphEntry(name, kind, self)
        self.peers: list[Any] = []
        self._offered, self._requested = Policies.offered(qos), Policies.requested(qos)

    def meet(self, other: Any) -> None:
        """Learn of a node's endpoint."""
        self.peers.append(other)

    def part(self, other: Any) -> None:
        """Learn that a node's endpoint is gone."""
        self.peers.remove(other)

    def reaches_back(self, other: Any) -> bool:
        return True


class _Client(_ServiceEndpoint):
    """Asks a service once."""

    asks = True

    def __init__(self, world: World, service: ServerEndpoint, then: tester.Then | None) -> None:
        super().__init__(world, service.entry.topic, service.entry.type, service.qos_profile)
        self._service = service
        self._then = then

    def receive(self, service: Any, sequence: int, response: Message | None) -> None:
        """Take a response, which is the service's to another client if it is None."""
        if response:
            self._service.part(self)
            if self._then:
                self._then(response)


class _Service(_ServiceEndpoint):
    """Sends what ``answer(request)`` returns, called in a thread of its own for each request; nothing if it is None."""

    asks = False

    def __init__(self, world: World, name: str, srv_type: Any, answer: Callable[[Any], Message | None]) -> None:
        super().__init__(world, name, kind_of(srv_type), qos_profile_services_default)
        self._srv_type = srv_type
        self._answer = answer

    def receive(self, request: Message, header: Header) -> None:
        """Take a request."""
        request = received(request, self._srv_type.Request)
        with self.world.acting():
            threading.Thread(target=self._send, args=(request, header), daemon=True).start()

    def _send(self, request: Message, header: Header) -> None:
        response = self._answer(request)
        if response is None:
            return
        header.call.answer(tester.NAME, self.world.clock.now(), lambda: response)
        for client in list(self.peers):
            own = client is header.client
            client.receive(self, header.sequence if own else 0, response if own else None)


def give_parameters(world: World, parameters: Mapping[str, Any]) -> None:
    """Give a process's nodes parameters before it runs, on its command line. What is there takes precedence.

    Raises TypeError for a value that a parameter cannot have.
    """
    if parameters:
        words = (word for name, value in parameters.items() for word in ("-p", f"{name}:={_yaml(name, value)}"))
        world.argv[1:1] = ["--ros-args", *words, "--"]


def _yaml(name: str, value: Any) -> str:
    values = value if isinstance(value, (list, tuple)) else [value]
    if not all(isinstance(each, (bool, int, float, str)) for each in values):
        raise TypeError(f"the parameter {name} can be a bool, int, float, str, or a list of one of them, not {value!r}")
    # JSON is YAML, but it has no infinity.
    shown = [repr(each) if isinstance(each, float) else json.dumps(each) for each in values]
    return f"[{', '.join(shown)}]" if values is value else shown[0]
