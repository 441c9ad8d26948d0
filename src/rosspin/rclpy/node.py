"""Node (source: rclpy/node.py)."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any
from weakref import ref

from ..messages.ros2 import Message
from ..messages.ros2 import Service as Interface
from ..world.world import NotSimulated
from . import logging, names, own_topics
from .arguments import Arguments
from .callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from .clock import Clock, ROSClock
from .context import Context, get_default_context
from .discovery import Participants
from .event_handler import EventHandler, PublisherEventCallbacks, SubscriptionEventCallbacks
from .exceptions import (
    NameValidationException,
    NotInitializedException,
    RCLError,
    RCLInvalidROSArgsError,
    invalid_context,
    not_accepted,
)
from .executors import GuardCondition
from .handle import Handle, Life, RclNode
from .logging_service import LoggingService
from .parameter import Parameter, Parameters, check_value
from .parameter_service import ParameterService
from .parameter_service import look as look_for_parameters
from .qos import DurabilityPolicy, QoSProfile, qos_profile_services_default
from .qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from .services import Client, ClientEndpoint, ServerEndpoint, Service, ServiceEndpoint, ServiceEndpoints
from .time_source import TimeSource
from .timer import Rate, Timer
from .topic_endpoint_info import TopicEndpointInfo, info_of
from .topics import Publisher, PublisherEndpoint, Subscription, SubscriptionEndpoint, TopicEndpoint
from .type_description_service import START_TYPE_DESCRIPTION_SERVICE_PARAM
from .type_support import check_is_valid_msg_type, check_is_valid_srv_type

if TYPE_CHECKING:
    from .action import ActionClient, ActionServer
    from .endpoints import Endpoint
    from .executors import Executor

__all__ = ["Node"]

# What rcl says of a service with this durability.
_TRANSIENT_LOCAL = (
    "Warning: Setting QoS durability to 'transient local' for service servers can cause them to receive requests "
    "from clients that have since terminated."
)


class NodeNameNonExistentError(RCLError):
    """There is no such node."""


def _by_name(endpoints: Iterable[Endpoint], topics: Mapping[str, Set[str]]) -> list[tuple[str, list[str]]]:
    """Sort the topics, or services, of these endpoints, and the ``topics`` given, with their types."""
    found = {topic: set(types) for topic, types in topics.items()}
    for endpoint in endpoints:
        found.setdefault(endpoint.entry.topic, set()).add(endpoint.entry.type)
    return [(topic, sorted(types)) for topic, types in sorted(found.items())]


def _endpoints(node: RclNode, kind: type[Endpoint]) -> list[Endpoint]:
    """List the publishers, the subscriptions, the clients or the services of a node and of its actions."""
    if kind is ServerEndpoint and (made_by := node.node()) is not None:
        made_by._rosspin_start_services()
    return [endpoint for endpoint in node.endpoints if isinstance(endpoint, kind)]


def _describing(node: RclNode) -> dict[str, set[str]]:
    """The service that describes its types. It is only named here."""
    kind = {"type_description_interfaces/srv/GetTypeDescription"}
    return {f"{node.full_name}/get_type_description": kind} if node.describes else {}


def _class_of(msg_type: Any) -> type[Message]:
    """The class of a message that may be given by an instance, which rclpy takes until something is published."""
    return msg_type if isinstance(msg_type, type) else type(msg_type)


# What an executor asks a node for, in this order.
_SERVED = ("subscriptions", "timers", "clients", "services", "guards", "waitables")


def _nobody() -> None:
    return None


class _NotMade:
    """What a node has whose ``__init__`` has not called Node's (yet): the error that rclpy gives."""

    def __get__(self, node: Node, owner: type[Node]) -> RclNode:
        raise AttributeError(f"{owner.__name__!r} object has no attribute '_Node__node'")


class Node(Parameters):
    """A node has a name, makes timers, publishers, subscriptions, clients and services, and has to be spun.

    ``cli_args`` is a command line for it alone; ``use_global_arguments`` says whether the process's counts, too.
    Raises NotInitializedException before ``init``, InvalidNodeNameException and InvalidNamespaceException.
    """

    _rosspin: RclNode = _NotMade()  # type: ignore[assignment]
    _rosspin_lacking: ModuleType | None = None

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        self._context = context or get_default_context()
        if not self._context.ok():
            raise NotInitializedException("cannot create node")
        namespace = namespace or ""
        if not isinstance(node_name, str | bytes | None) or not isinstance(namespace, str | bytes):
            signature = (
                "Node(arg0: str, arg1: str, arg2: rclpy._rclpy_pybind11.Context, arg3: object, arg4: bool, arg5: bool)"
            )
            raise not_accepted(signature, node_name, namespace, "Context", cli_args, use_global_arguments, True)
        if node_name is None:
            raise RCLError("error creating node: name argument is null")
        node_name, namespace = (text.decode() if isinstance(text, bytes) else text for text in (node_name, namespace))
        names.validate_node_name(node_name)
        namespace = namespace if namespace.startswith("/") else f"/{namespace}"
        names.validate_namespace(namespace)
        try:
            arguments = [] if cli_args is None else [Arguments(list(cli_args))]
        except RCLError as error:
            why = str(error).replace("failed to initialize rcl", "Failed to parse ROS arguments", 1)
            raise RCLInvalidROSArgsError(why) from None
        if use_global_arguments and self._context._rosspin.arguments:
            arguments.append(self._context._rosspin.arguments)
        for each in reversed(arguments):
            node_name, namespace = each.name(node_name, namespace)
        own = self._rosspin = RclNode(self, self._context._rosspin, node_name, namespace, arguments)
        self._rosspin_life = Life(own.destroy)
        self._logger = logging.get_logger(own.logger_name)

        # What its class defines under these names is met where rclpy asks for them.
        self._rosspin_replaced = [name for name in _SERVED if self._rosspin_has_own(name)]
        self._publishers: list[Publisher] = []
        self._subscriptions: list[Subscription] = []
        self._clients: list[Client] = []
        self._services: list[Service] = []
        self._parameter_event_publisher: Publisher | None = None
        self._rosspin_events: list[EventHandler] = []
        self._rosspin_waitables: list[Any] = []  # its actions, and before them the events but for rare ones
        self._timers: list[Timer] = []
        self._guards: list[GuardCondition] = []
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._rate_group = ReentrantCallbackGroup()

        overrides: dict[str, Parameter] = {}
        for each in reversed(arguments):
            values = each.parameters(own.full_name)
            overrides |= {name: Parameter(name, value=value) for name, value in values.items()}
        overrides |= {parameter.name: parameter for parameter in parameter_overrides or ()}
        own.context.add_node(own)
        self._rosspin_participants.join(own.context)
        logs = own.context.logs
        on_rosout = enable_rosout and logs.rosout is not None
        own.topics = own_topics.OwnTopics(own, import_module("rcl_interfaces.msg"), on_rosout)
        if on_rosout:
            logging.publish_on_rosout(own.logger_name, own.name, own.topics.tell_log)
            own.at_end.append(partial(logging.leave_rosout, logs, own.logger_name))
        own.at_end.append(own.topics.end)
        with self.handle:  # as rclpy does, which makes the publisher of /parameter_events now
            if self._rosspin_has_own("create_publisher", "resolve_topic_name", "default_callback_group"):
                self._parameter_event_publisher = own.topics.make_with(self.create_publisher)
        own.topics.look()
        super().__init__(overrides, allow_undeclared_parameters)
        self._clock = ROSClock()
        try:
            if automatically_declare_parameters_from_overrides:
                entries = [(name, parameter.value) for name, parameter in overrides.items()]
                self.declare_parameters("", entries, ignore_override=True)
            self._time_source = TimeSource(node=self)
            self._time_source.attach_clock(self._clock)
            if not self.has_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM):
                self.declare_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM, True)
        except BaseException:  # a value that the command line gives may be refused
            self.destroy_node()
            raise
        own.describes = self.get_parameter(START_TYPE_DESCRIPTION_SERVICE_PARAM).value
        # Whoever looks for these services first may be another process, which would import classes of its own.
        self._rosspin_lacking = import_module("rcl_interfaces.srv") if start_parameter_services else None
        is_asked = own.full_name in own.context.state.world.graph.part(ServiceEndpoints).asked
        if is_asked or self._rosspin_has_own("create_service", "destroy_service", "get_name", "default_callback_group"):
            self._rosspin_start_services()
        if enable_logger_service:
            LoggingService(self)

    def _rosspin_has_own(self, *names: str) -> bool:
        """Whether its class defines any of these instead of Node's."""
        return any(getattr(type(self), name) is not getattr(Node, name) for name in names)

    # --- what it is ---------------------------------------------------------------------------------------------------

    @property
    def context(self) -> Context:
        """Its context."""
        return self._context

    @property
    def default_callback_group(self) -> CallbackGroup:
        """The group of what is made without one: one callback at a time."""
        return self._default_callback_group

    @property
    def executor(self) -> Executor | None:
        """The executor to which the node was last added. The node alone does not keep it."""
        if "_rosspin" not in vars(self):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute '_Node__executor_weakref'")
        return self._rosspin.executor()

    @executor.setter
    def executor(self, new_executor: Executor | None) -> None:
        current = self.executor
        if current is new_executor:
            return
        if current is not None:
            current.remove_node(self)
        if new_executor is None:
            self._rosspin.executor = _nobody
        else:
            new_executor.add_node(self)
            self._rosspin.executor = ref(new_executor)

    @property
    def publishers(self) -> Iterator[Publisher]:
        """Its publishers, also for /parameter_events."""
        self._rosspin.topics.make(own_topics.PARAMETER_EVENTS)
        yield from self._publishers

    def _rosspin_add_event_publisher(self, endpoint: PublisherEndpoint) -> None:
        """Keep the publisher of /parameter_events, which is made when someone looks, before all others."""
        events, group = PublisherEventCallbacks(), self._default_callback_group
        publisher = Publisher(endpoint, endpoint.msg_type, endpoint.entry.topic, endpoint.qos_profile, events, group)
        later, self._rosspin_events = self._rosspin_events, []
        self._rosspin_expect(publisher.event_handlers)
        self._rosspin_events += later
        self._publishers.insert(0, publisher)
        self._parameter_event_publisher = publisher

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        """Its subscriptions."""
        yield from self._subscriptions

    @property
    def clients(self) -> Iterator[Client]:
        """Its clients."""
        yield from self._clients

    @property
    def services(self) -> Iterator[Service]:
        """Its services."""
        self._rosspin_start_services()
        yield from self._services

    def _rosspin_start_services(self) -> None:
        """Make the services for its parameters, which few nodes are asked for: there are none until someone looks."""
        types, self._rosspin_lacking = self._rosspin_lacking, None
        if types and self._context.ok():
            own, self._services = self._services, []
            with self._rosspin.context.state.world.acting():
                self._parameter_service = ParameterService(self, types)
            self._services.extend(own)

    @property
    def waitables(self) -> Iterator[EventHandler | ActionServer | ActionClient]:
        """The events of its publishers and subscriptions, its action servers and action clients."""
        self._rosspin.topics.make(own_topics.PARAMETER_EVENTS)
        yield from self._rosspin_events
        yield from (waitable for waitable in self._rosspin_waitables if waitable not in self._rosspin_events)

    def add_waitable(self, waitable: Any) -> None:
        """Serve an action. Others that a node may wait for are not simulated."""
        if not hasattr(waitable, "_rosspin"):
            raise NotSimulated("Node.add_waitable")
        self._rosspin_waitables.append(waitable)
        self._wake_executor()

    def _rosspin_expect(self, handlers: list[EventHandler]) -> None:
        """Serve the events of an endpoint."""
        self._rosspin_events.extend(handlers)
        for handler in handlers:
            if not handler._rosspin_is_rare or handler._rosspin.messages:
                self._rosspin_serve(handler)

    def _rosspin_serve(self, handler: EventHandler) -> None:
        """Look for calls of an event, and let the executor look."""
        served = self._rosspin_waitables
        if handler not in served:
            events = [each for each in self._rosspin_events if each is handler or each in served]
            self._rosspin_waitables = [*events, *(each for each in served if each not in events)]
            self._wake_executor()
        self._rosspin_nudge()

    def remove_waitable(self, waitable: Any) -> None:
        """Stop serving an action or an event. Raises ValueError for one that it does not serve."""
        if waitable not in self._rosspin_events:
            self._rosspin_waitables.remove(waitable)
            return
        self._rosspin_events.remove(waitable)
        if waitable in self._rosspin_waitables:
            self._rosspin_waitables.remove(waitable)

    @property
    def timers(self) -> Iterator[Timer]:
        """Its timers, also its Rates'."""
        yield from self._timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """Its guard conditions."""
        yield from self._guards

    def get_name(self) -> str:
        """Its name. Raises InvalidHandle if the node was destroyed."""
        self._rosspin.check()
        return self._rosspin.name

    def get_namespace(self) -> str:
        """Its namespace: ``/``, or without a slash at the end. Raises InvalidHandle if the node was destroyed."""
        self._rosspin.check()
        return self._rosspin.namespace

    def get_fully_qualified_name(self) -> str:
        """Its namespace and name. Raises InvalidHandle if the node was destroyed."""
        self._rosspin.check()
        return self._rosspin.full_name

    def get_clock(self) -> Clock:
        """Its clock, which tells ROS time."""
        return self._clock

    def get_logger(self) -> logging.RcutilsLogger:
        """Its logger, named after its namespace and name: ``mrp.spinner``."""
        return self._logger

    @property
    def handle(self) -> Handle:
        """Its handle, which can be held and nothing else. It cannot be replaced."""
        return Handle(self._rosspin, self._rosspin_life)

    @handle.setter
    def handle(self, value: Any) -> None:
        raise AttributeError("handle cannot be modified after node creation")

    def _rosspin_tell_parameters(
        self, node: str, new: list[Parameter], changed: list[Parameter], deleted: list[Parameter]
    ) -> None:
        own = self._rosspin
        if not own.context.ok():
            raise RCLError("Failed to publish: publisher's context is invalid")
        for parameter in (*new, *changed):
            check_value(parameter)
        if publisher := self._parameter_event_publisher:
            own.topics.tell_parameters(publisher, self._clock.now(), node, new, changed, deleted)

    def _rosspin_nudge(self) -> None:
        """Let the executor look again: something may have become due."""
        self._rosspin.nudge()

    def _wake_executor(self) -> None:
        if executor := self.executor:
            executor.wake()

    def _rosspin_add(self, entity: Any, entities: list[Any]) -> None:
        """Let the executor call what has a callback."""
        entity.callback_group.add_entity(entity)
        entities.append(entity)
        self._wake_executor()

    # --- timers -------------------------------------------------------------------------------------------------------

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Call ``callback()`` every ``timer_period_sec``, while someone spins; see :class:`Timer`.

        Raises RCLError for a negative period, ValueError for NaN, OverflowError for infinity.
        """
        group = callback_group or self.default_callback_group
        period = int(float(timer_period_sec) * 1e9)
        timer = Timer(callback, group, period, clock or self._clock, context=self.context, autostart=autostart)
        timer._rosspin_nudge = self._rosspin.nudge
        self._rosspin_add(timer, self._timers)
        self._rosspin.context.state.world.await_spin(callback is not None and autostart)
        return timer

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Make a :class:`Rate` of ``frequency`` passes a second. Raises ValueError unless it is above 0."""
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        timer = self.create_timer(1.0 / frequency, None, self._rate_group, clock)
        return Rate(timer, context=self.context)

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Call ``callback()`` once after each ``trigger()``. Raises RCLError after shutdown."""
        if not self._context.ok():
            raise invalid_context("create guard_condition")
        group = callback_group or self.default_callback_group
        guard = GuardCondition(callback, group, self._context)
        guard._rosspin_nudge = self._rosspin.nudge
        self._rosspin_add(guard, self._guards)
        return guard

    # --- topics -------------------------------------------------------------------------------------------------------

    def create_publisher(
        self,
        msg_type: type[Message],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Publisher:
        """Publish messages of a class on a topic; ``qos_profile`` may be the depth.

        Raises InvalidTopicNameException, TypeError or ValueError if ``qos_profile`` is no QoS, AttributeError if
        ``msg_type`` is no message of ROS 2, and RCLError if the process uses the topic with another type.
        """
        group = callback_group or self.default_callback_group
        full_name, qos = self._rosspin_prepare("publisher", msg_type, topic, qos_profile, qos_overriding_options)
        if (other := self._rosspin_other_type(full_name, _class_of(msg_type))) is not None:
            raise RCLError(
                "Failed to create publisher: create_publisher() called for existing topic name "
                f"rt{full_name} with incompatible type {other}"
            )
        events = event_callbacks or PublisherEventCallbacks()
        endpoint = PublisherEndpoint(self._rosspin, _class_of(msg_type), full_name, qos)
        publisher = publisher_class(endpoint, msg_type, topic, qos, event_callbacks=events, callback_group=group)
        self._rosspin_expect(publisher.event_handlers)
        self._publishers.append(publisher)
        self._wake_executor()
        return publisher

    def create_subscription(
        self,
        msg_type: type[Message],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Call ``callback(message)`` for messages on a topic, while someone spins; ``raw`` ones are bytes.

        Raises as ``create_publisher``.
        """
        group = callback_group or self.default_callback_group
        full_name, qos = self._rosspin_prepare("subscription", msg_type, topic, qos_profile, qos_overriding_options)
        if self._rosspin_other_type(full_name, _class_of(msg_type)) is not None:
            raise RCLError("Failed to create subscription: invalid allocator")
        own_topics.look(self._rosspin, full_name)
        events = event_callbacks or SubscriptionEventCallbacks()
        endpoint = SubscriptionEndpoint(self._rosspin, _class_of(msg_type), full_name, qos, raw)
        subscription = Subscription(endpoint, msg_type, topic, callback, group, qos, raw, events)
        self._rosspin_expect(subscription.event_handlers)
        self._rosspin_add(subscription, self._subscriptions)
        self._rosspin.context.state.world.await_spin()
        return subscription

    def _rosspin_prepare(self, what: str, msg_type: Any, topic: Any, qos: Any, options: Any) -> tuple[str, QoSProfile]:
        """Return the topic's full name and the profile of what should be created."""
        if isinstance(qos, int):
            if qos < 0:
                raise ValueError("history depth must be greater than or equal to zero")
            qos = QoSProfile(depth=qos)
        if not isinstance(qos, QoSProfile):
            raise TypeError(f"Expected QoSProfile or int, but received {type(qos)!r}")
        try:
            final_topic = self.resolve_topic_name(topic)
        except RuntimeError:
            try:
                self._rosspin_resolve(topic)
            except NameValidationException as error:
                raise error from None
            raise
        if options is not None:
            kind = Publisher if what == "publisher" else Subscription
            _declare_qos_parameters(kind, self, final_topic, qos, options)
        check_is_valid_msg_type(msg_type)
        if not self._context.ok():
            raise RCLError(f"Failed to create {what}: rcl node's context is invalid")
        return self._rosspin_resolve(topic), qos

    def _rosspin_other_type(self, full_name: str, msg_type: type[Message]) -> str | None:
        """Return the type with which this process uses a topic, in DDS's words, if it is not ``msg_type``."""
        for node in self._rosspin.context.nodes:
            for each in node.endpoints:
                if isinstance(each, TopicEndpoint) and each.entry.topic == full_name and each.msg_type is not msg_type:
                    package, folder, *_ = msg_type.__module__.split(".")
                    return f"{package}::{folder}::dds_::{msg_type.__name__}_"
        return None

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the full name of a topic in this node. Raises RCLError if it is not valid, and InvalidHandle."""
        return self._rosspin_try_resolve(topic, only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the full name of a service in this node. Raises as ``resolve_topic_name``."""
        return self._rosspin_try_resolve(service, only_expand, is_service=True)

    def _rosspin_try_resolve(self, name: str, only_expand: bool, is_service: bool = False) -> str:
        self._rosspin.check()
        if not isinstance(name, str):
            signature = "(arg0: rclpy::Node, arg1: str, arg2: bool, arg3: bool) -> str"
            raise not_accepted(signature, "Node", name, only_expand, is_service, function="rclpy_resolve_name")
        try:
            return self._rosspin_resolve(name, only_expand, is_service)
        except NameValidationException as error:
            raise RCLError(f"failed to resolve name: {error.error_msg}") from None

    def _rosspin_resolve(self, name: str, only_expand: bool = False, is_service: bool = False) -> str:
        own = self._rosspin
        names.validate_topic_name(name, is_service=is_service)
        full_name = names.expand_topic_name(name, own.name, own.namespace)
        if not only_expand:
            for arguments in own.arguments:
                full_name = arguments.topic(full_name, own.name, own.namespace)
        names.validate_full_topic_name(full_name, is_service=is_service)
        return full_name

    def get_topic_names_and_types(self, no_demangle: bool = False) -> list[tuple[str, list[str]]]:
        """Return the published topics and their types. As on a real ROS, the topics of every node are among them.

        Raises InvalidHandle if the node was destroyed.
        """
        self._rosspin.check()
        self._rosspin_check_context("failed to get topic names and types")
        own = [node for context in self._rosspin.context.state.contexts for node in context.nodes]
        nodes = (*own, *self._rosspin_nodes())
        endpoints = {each: None for node in nodes for each in node.endpoints if isinstance(each, TopicEndpoint)}
        return _by_name(endpoints, own_topics.TYPES)

    def _rosspin_nodes(self) -> list[RclNode]:
        """The known nodes: its context's, and the ones found in other processes."""
        own = self._rosspin.context
        return [*own.nodes, *self._rosspin_participants.nodes(own)]

    @property
    def _rosspin_participants(self) -> Participants:
        return self._rosspin.context.state.world.graph.part(Participants)

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Return the topics that a node publishes, and their types. Raises NodeNameNonExistentError if unknown."""
        return _by_name(
            _endpoints(self._rosspin_find("publisher", node_name, node_namespace), PublisherEndpoint), own_topics.TYPES
        )

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> list[tuple[str, list[str]]]:
        """Return the topics that a node subscribes to, and their types. Raises NodeNameNonExistentError."""
        node = self._rosspin_find("subscriber", node_name, node_namespace)
        return _by_name(_endpoints(node, SubscriptionEndpoint), {})

    def _rosspin_find(self, what: str, name: str, namespace: str) -> RclNode:
        self._rosspin.check()
        self._rosspin_check_context(f"failed to get {what} names and types")
        for node in self._rosspin_nodes():
            if (node.name, node.namespace) == (name, namespace):
                return node
        raise NodeNameNonExistentError(f"cannot get {what} names and types for nonexistent node: error not set")

    def count_publishers(self, topic_name: str) -> int:
        """Count the known publishers of a topic; its name is not remapped. Raises ValueError and InvalidHandle."""
        return self._rosspin_count(topic_name, "publishers", PublisherEndpoint)

    def count_subscribers(self, topic_name: str) -> int:
        """Count the known subscriptions to a topic; its name is not remapped. Raises ValueError and InvalidHandle."""
        return self._rosspin_count(topic_name, "subscribers", SubscriptionEndpoint)

    def _rosspin_count(self, name: str, what: str, kind: type[Endpoint]) -> int:
        full_name = names.expand_topic_name(name, self.get_name(), self.get_namespace())
        names.validate_full_topic_name(full_name)
        self._rosspin_check_context(f"Error in rcl_count_{what}")
        own_topics.look(self._rosspin, full_name)
        return sum(each.entry.topic == full_name for node in self._rosspin_nodes() for each in _endpoints(node, kind))

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """Tell of the known publishers of a topic. Its name is remapped, unless it is one of DDS (``no_mangle``).

        Raises ValueError and InvalidHandle.
        """
        return self._rosspin_infos(topic_name, no_mangle, PublisherEndpoint)

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        """The same of the known subscriptions."""
        return self._rosspin_infos(topic_name, no_mangle, SubscriptionEndpoint)

    def _rosspin_infos(self, name: str, no_mangle: bool, kind: type[Endpoint]) -> list[TopicEndpointInfo]:
        self._rosspin.check()
        if no_mangle:
            name = name.removeprefix("rt") if name.startswith("rt/") else ""
        else:
            name = names.expand_topic_name(name, self.get_name(), self.get_namespace())
            names.validate_full_topic_name(name)
            name = self._rosspin_resolve(name)
            own_topics.look(self._rosspin, name)
        what = "publishers" if kind is PublisherEndpoint else "subscriptions"
        self._rosspin_check_context(f"Failed to get information by topic for {what}")
        nodes = self._rosspin_nodes()
        endpoints = [each for node in nodes for each in _endpoints(node, kind) if each.entry.topic == name]
        return [info_of(endpoint, endpoint.node, kind is PublisherEndpoint, no_mangle) for endpoint in endpoints]

    def _rosspin_check_context(self, error: str) -> None:
        if not self._context.ok():
            raise RCLError(f"{error}: rcl node's context is invalid")

    # --- services -----------------------------------------------------------------------------------------------------

    def create_client(
        self,
        srv_type: type[Interface],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Make a client that asks a service; see :class:`Client`.

        Raises InvalidServiceNameException, AttributeError or RuntimeError if ``srv_type`` is no service of ROS 2, and
        RCLError if the process uses the name with another type.
        """
        group = callback_group or self.default_callback_group
        full_name = self._rosspin_prepare_service("client", srv_type, srv_name, qos_profile)
        look_for_parameters(self._rosspin.context.state.world.graph, full_name)
        endpoint = ClientEndpoint(self._rosspin, srv_type, full_name, qos_profile)
        client = Client(self._context, endpoint, srv_type, srv_name, qos_profile, group)
        self._rosspin_add(client, self._clients)
        return client

    def create_service(
        self,
        srv_type: type[Interface],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Call ``callback(request, response)`` for requests, while someone spins, and send what it returns.

        Raises as ``create_client``.
        """
        group = callback_group or self.default_callback_group
        full_name = self._rosspin_prepare_service("service", srv_type, srv_name, qos_profile)
        if qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL:
            logging.get_logger("rcl").warning(_TRANSIENT_LOCAL)
        endpoint = ServerEndpoint(self._rosspin, srv_type, full_name, qos_profile)
        service = Service(endpoint, srv_type, srv_name, callback, group, qos_profile)
        self._rosspin_add(service, self._services)
        return service

    def _rosspin_prepare_service(self, what: str, srv_type: Any, name: Any, qos: Any) -> str:
        """Check what a client or service should be made of. Return the full name."""
        check_is_valid_srv_type(srv_type)
        self._rosspin.check()
        if not isinstance(qos, QoSProfile):
            raise AttributeError(f"{type(qos).__name__!r} object has no attribute 'get_c_qos_profile'")
        if not isinstance(name, str):
            signature = f"{what.title()}(arg0: rclpy::Node, arg1: object, arg2: str, arg3: object)"
            raise not_accepted(signature, "Node", srv_type, name, "rmw_qos_profile_t")
        if not self._context.ok():
            raise RCLError(f"failed to create {what}: rcl node's context is invalid")
        full_name = self._rosspin_resolve(name, is_service=True)
        for node in self._rosspin.context.nodes:
            for each in node.endpoints:
                if (
                    isinstance(each, ServiceEndpoint)
                    and each.entry.topic == full_name
                    and each.srv_type is not srv_type
                ):
                    kind = f"{srv_type.__module__.split('.')[0]}::srv::dds_::{srv_type.__name__}_Request_"
                    raise RCLError(
                        f"failed to create {what}: create_{what}() called for existing request topic name "
                        f"rq{full_name}Request with incompatible type {kind}"
                    )
        return full_name

    def get_service_names_and_types(self) -> list[tuple[str, list[str]]]:
        """Return the services that are offered or asked, and their types. Raises InvalidHandle, RCLError."""
        self._rosspin.check()
        self._rosspin_check_context("failed to get service names and types")
        nodes = self._rosspin_nodes()
        kinds = (ServerEndpoint, ClientEndpoint)
        endpoints = [each for node in nodes for kind in kinds for each in _endpoints(node, kind)]
        return _by_name(endpoints, {name: types for node in nodes for name, types in _describing(node).items()})

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> list[tuple[str, list[str]]]:
        """Return the services that a node offers, and their types. Raises NodeNameNonExistentError if unknown."""
        node = self._rosspin_find("service", node_name, node_namespace)
        return _by_name(_endpoints(node, ServerEndpoint), _describing(node))

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> list[tuple[str, list[str]]]:
        """Return the services that a node asks, and their types. Raises NodeNameNonExistentError if unknown."""
        return _by_name(_endpoints(self._rosspin_find("client", node_name, node_namespace), ClientEndpoint), {})

    def count_services(self, service_name: str) -> int:
        """Count the known servers of a service; its name is not remapped. Raises ValueError and InvalidHandle."""
        return self._rosspin_count(service_name, "services", ServerEndpoint)

    def count_clients(self, service_name: str) -> int:
        """Count the known clients of a service; its name is not remapped. Raises ValueError and InvalidHandle."""
        return self._rosspin_count(service_name, "clients", ClientEndpoint)

    # --- nodes --------------------------------------------------------------------------------------------------------

    def get_node_names(self) -> list[str]:
        """The names of the known nodes. Raises InvalidHandle if this one was destroyed, RCLError after shutdown."""
        return [node.name for node in self._rosspin_named_nodes()]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """The names and namespaces of the known nodes. Raises as ``get_node_names``."""
        return [(node.name, node.namespace) for node in self._rosspin_named_nodes()]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """The same with the enclaves, of which there is one. Raises as ``get_node_names``."""
        return [(*names, "/") for names in self.get_node_names_and_namespaces()]

    def get_fully_qualified_node_names(self) -> list[str]:
        """The full names of the known nodes. Raises as ``get_node_names``."""
        return [node.full_name for node in self._rosspin_named_nodes()]

    def _rosspin_named_nodes(self) -> list[RclNode]:
        self._rosspin.check()
        self._rosspin_check_context("Failed to get node names")
        return self._rosspin_nodes()

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        """Look for a node every 0.1 s, for at most ``timeout`` seconds. Return whether it is known.

        The name's first slash may be left out. A ``timeout`` of 0 or less does not look. Raises InvalidHandle.
        """
        name = (
            fully_qualified_node_name if fully_qualified_node_name.startswith("/") else f"/{fully_qualified_node_name}"
        )
        start, found = time.time(), False
        while time.time() - start < timeout and not found:
            found = name in self.get_fully_qualified_node_names()
            time.sleep(0.1)
        return found

    # --- the end ------------------------------------------------------------------------------------------------------

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer. Return whether this node had it."""
        return self._rosspin_destroy(timer, self._timers)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a Rate. Return whether this node had it."""
        success = self.destroy_timer(rate._timer)
        rate.destroy()
        return success

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition. Return whether this node had it."""
        return self._rosspin_destroy(guard, self._guards)

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Destroy a publisher. Return whether this node had it."""
        return self._rosspin_destroy(publisher, self._publishers)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client. Return whether this node had it."""
        return self._rosspin_destroy(client, self._clients)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service. Return whether this node had it."""
        return self._rosspin_destroy(service, self._services)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Destroy a subscription. Return whether this node had it."""
        return self._rosspin_destroy(subscription, self._subscriptions)

    def _rosspin_destroy(self, entity: Any, entities: list[Any]) -> bool:
        if entity not in entities:
            return False
        entities.remove(entity)
        for handler in getattr(entity, "event_handlers", ()):
            Node.remove_waitable(self, handler)
        entity.destroy()
        self._wake_executor()
        return True

    def destroy_node(self) -> None:
        """Destroy the node and all that it has made, but its logger and its actions.

        As on a real ROS, others know it as long as one of these is there.
        """
        self._rosspin_lacking = None
        if self._rosspin_has_own("destroy_publisher"):
            self._rosspin.topics.make(own_topics.PARAMETER_EVENTS)
        self._parameter_event_publisher = None
        all_entities: list[tuple[list[Any], Callable[[Any], Any]]] = [
            (self._publishers, self.destroy_publisher),
            (self._subscriptions, self.destroy_subscription),
            (self._clients, self.destroy_client),
            (self._services, self.destroy_service),
            (self._timers, self.destroy_timer),
            (self._guards, self.destroy_guard_condition),
        ]
        for entities, destroy in all_entities:
            while entities:
                destroy(entities[0])
        self._rosspin.describes = False
        self._rosspin.destroy()
        self._wake_executor()
