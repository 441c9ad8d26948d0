"""Managed nodes (sources: rclpy/lifecycle, rcl_lifecycle/src/default_state_machine.c)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, wraps
from importlib import import_module
from typing import Any, NamedTuple

from . import node as nodes
from .callback_groups import CallbackGroup
from .enumerations import CppEnum
from .exceptions import RCLError, not_accepted
from .handle import Life
from .logging import get_logger
from .qos import QoSProfile
from .topics import Publisher as TopicPublisher
from .topics import PublisherEndpoint

__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "SimpleManagedEntity",
]


class TransitionCallbackReturn(CppEnum):
    """What a callback of a transition returns. What it raises counts as ERROR."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99

    def to_label(self) -> str:
        """The label of the transition that follows."""
        return f"transition_{self.name.lower()}"


TransitionCallbackReturn.__name__ = TransitionCallbackReturn.__qualname__ = "TransitionCallbackReturnType"

Transition = tuple[int, str, int, str, int, str]

_STATES = {
    **{0: "unknown", 1: "unconfigured", 2: "inactive", 3: "active", 4: "finalized"},
    **{10: "configuring", 11: "cleaningup", 12: "shuttingdown", 13: "activating", 14: "deactivating"},
    15: "errorprocessing",
}


def _transition(number: int, label: str, start: int, goal: int) -> Transition:
    return number, label, start, _STATES[start], goal, _STATES[goal]


def _outcomes(number: int, start: int, *goals: int) -> list[Transition]:
    """What follows success, failure and error of the callback of a state."""
    return [
        _transition(number + n, code.to_label(), start, goals[n]) for n, code in enumerate(TransitionCallbackReturn)
    ]


_GRAPH = [
    *(_transition(1, "configure", 1, 10), *_outcomes(10, 10, 2, 1, 15)),
    *(_transition(2, "cleanup", 2, 11), *_outcomes(20, 11, 1, 2, 15)),
    *(_transition(3, "activate", 2, 13), *_outcomes(30, 13, 3, 2, 15)),
    *(_transition(4, "deactivate", 3, 14), *_outcomes(40, 14, 2, 3, 15)),
    *(_transition(number, "shutdown", start, 12) for number, start in ((5, 1), (6, 2), (7, 3))),
    *(*_outcomes(50, 12, 4, 4, 15), *_outcomes(60, 15, 1, 4, 4)),
]

# The state in which each callback is called.
_CALLBACKS = {10: "configure", 11: "cleanup", 12: "shutdown", 13: "activate", 14: "deactivate", 15: "error"}

# The services below the node's name, each with its type.
_SERVICES = {
    "change_state": "ChangeState",
    "get_state": "GetState",
    "get_available_states": "GetAvailableStates",
    "get_available_transitions": "GetAvailableTransitions",
    "get_transition_graph": "GetAvailableTransitions",
}


class LifecycleState(NamedTuple):
    """A state."""

    label: str
    state_id: int


class ManagedEntity:
    """What goes through the transitions of its node: its callbacks are called with the state before."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure it."""
        return TransitionCallbackReturn.SUCCESS

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Undo that."""
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """End it."""
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate it."""
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Undo that."""
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Repair what went wrong in a transition."""
        return TransitionCallbackReturn.SUCCESS


class SimpleManagedEntity(ManagedEntity):
    """Knows whether it is active."""

    def __init__(self) -> None:
        self._enabled = False

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._enabled = True
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self._enabled = False
        return TransitionCallbackReturn.SUCCESS

    @property
    def is_activated(self) -> bool:
        """Whether it is active."""
        return self._enabled

    @staticmethod
    def when_enabled(
        wrapped: Callable[..., Any] | None = None, *, when_not_enabled: Callable[[], Any] | None = None
    ) -> Any:
        """Let a method do nothing while its entity is not active, or call ``when_not_enabled()`` then.

        The method returns None, as on a real ROS.
        """

        def decorator(wrapped: Callable[..., Any]) -> Callable[..., None]:
            @wraps(wrapped)
            def only_when_enabled_wrapper(self: SimpleManagedEntity, *args: Any, **kwargs: Any) -> None:
                if self._enabled:
                    wrapped(self, *args, **kwargs)
                elif when_not_enabled is not None:
                    when_not_enabled()

            return only_when_enabled_wrapper

        return decorator if wrapped is None else decorator(wrapped)


class LifecyclePublisher(SimpleManagedEntity, TopicPublisher):
    """A publisher that publishes while it is active."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        TopicPublisher.__init__(self, *args, **kwargs)

    @SimpleManagedEntity.when_enabled
    def publish(self, msg: Any) -> None:
        """Publish a message if it is active. Raises as Publisher does."""
        TopicPublisher.publish(self, msg)


def _leave(endpoints: list[Any]) -> None:
    for endpoint in endpoints:
        endpoint.destroy()


class _StateMachine:
    """The states of a node, which publishes each step on ``~/transition_event``, also without the services."""

    initialized = True

    def __init__(self, node: nodes.Node, communicates: Any) -> None:
        if not hasattr(type(communicates), "__bool__"):
            signature = "LifecycleStateMachine(arg0: rclpy._rclpy_pybind11.Node, arg1: bool)"
            raise not_accepted(signature, "Node", communicates)
        self._types = import_module("lifecycle_msgs.msg")
        topic = node._rosspin_resolve("~/transition_event")
        self._publisher = PublisherEndpoint(
            node._rosspin, self._types.TransitionEvent, topic, QoSProfile(depth=10)
        ).begin()
        self._endpoints: list[Any] = [self._publisher]
        self._life = Life(partial(_leave, self._endpoints))
        self.current_state = 1, _STATES[1]
        self.available_states = list(_STATES.items())
        self.transition_graph = _GRAPH

    @property
    def available_transitions(self) -> list[Transition]:
        return [each for each in _GRAPH if each[2] == self.current_state[0]]

    def _find(self, given: int | str) -> Transition | None:
        """Find a transition of the current state by its number or its label, or log that it has none."""
        for each in self.available_transitions:
            if given in each[:2]:
                return each
        get_logger("rcl_lifecycle").warning(
            f"No transition matching {given} found for current state {self.current_state[1]}"
        )
        return None

    def get_transition_by_label(self, label: str) -> int:
        if found := self._find(label):
            return found[0]
        raise RCLError("Failed to get transition from label: error not set")

    def trigger(self, given: int | str) -> None:
        failed = "Failed to trigger lifecycle state machine transition"
        found = self._find(given)
        if found is None:
            raise RCLError(f"{failed}: Transition is not registered.")
        self.current_state = found[4:]
        if not self._publisher.node.context.ok():
            raise RCLError(f"{failed}: Could not publish transition: publisher's context is invalid")
        if not self._publisher.is_gone:
            start, goal = (self._types.State(id=number, label=label) for number, label in (found[2:4], found[4:]))
            self._publisher.publish(self._types.TransitionEvent(start_state=start, goal_state=goal))


class LifecycleNodeMixin(ManagedEntity):
    """What a managed node has besides what every node has. A class that uses it inherits from Node, too.

    Its callbacks, such as ``on_configure``, call the callbacks of what it manages, up to the first that does not
    succeed. Unless ``enable_communication_interface`` is false, it has services by which others change and ask its
    state, in a group of callbacks. Initialise it after Node. Raises TypeError for what is no bool.
    """

    # Of the other base class, Node.
    default_callback_group: CallbackGroup
    handle: Any

    def __init__(
        self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None
    ) -> None:
        self._callbacks = {number: getattr(self, f"on_{word}") for number, word in _CALLBACKS.items()}
        callback_group = callback_group or self.default_callback_group
        self._managed_entities: dict[ManagedEntity, None] = {}
        own: Any = self
        with self.handle:
            self._state_machine = _StateMachine(own, enable_communication_interface)
        types = import_module("lifecycle_msgs.srv")
        for name, kind in _SERVICES.items():
            service = None
            if enable_communication_interface:
                service = nodes.Node.create_service(
                    own,
                    getattr(types, kind),
                    f"~/{name}",
                    getattr(self, f"_LifecycleNodeMixin__on_{name}"),
                    callback_group=callback_group,
                )
                service.srv_name = service.service_name
                setattr(self, f"_service_{name}", service)
            setattr(self._state_machine, f"service_{name}", service)

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Go from unconfigured to inactive; return what the callback has returned. Raises RCLError elsewhere."""
        return self.__change_state(1)

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Go from inactive to unconfigured."""
        return self.__change_state(2)

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Go to finalized."""
        if self._state_machine.current_state[0] not in (1, 2, 3):
            raise RCLError("Shutdown transtion not possible")
        return self.__change_state(self._state_machine.current_state[0] + 4)

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Go from inactive to active."""
        return self.__change_state(3)

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Go from active to inactive."""
        return self.__change_state(4)

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Let an entity go through the node's transitions. Raises TypeError for what is none."""
        if not isinstance(entity, ManagedEntity):
            raise TypeError("Expected a rclpy.lifecycle.ManagedEntity instance.")
        self._managed_entities[entity] = None

    def _rosspin_call_entities(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in self._managed_entities:
            result = getattr(entity, name)(state)
            if not isinstance(result, TransitionCallbackReturn):
                raise TypeError(
                    f"{name}() return value of class {type(entity)} should be `TransitionCallbackReturn`.\n"
                    f"Instance of the class that caused the failure: {entity}"
                )
            if result != TransitionCallbackReturn.SUCCESS:
                return result
        return TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        return self._rosspin_call_entities("on_error", state)

    def create_lifecycle_publisher(self, *args: Any, **kwargs: Any) -> LifecyclePublisher:
        """Make a LifecyclePublisher, which goes with the node. Takes and raises what ``create_publisher`` does."""
        if "publisher_class" in kwargs:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        own: Any = self
        publisher: Any = nodes.Node.create_publisher(own, *args, **kwargs, publisher_class=LifecyclePublisher)
        self._managed_entities[publisher] = None
        return publisher  # type: ignore[no-any-return]

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        """Destroy a publisher, and manage it no more. Return whether this node had it."""
        self._managed_entities.pop(publisher, None)
        own: Any = self
        return nodes.Node.destroy_publisher(own, publisher)

    def __execute_callback(self, before: LifecycleState) -> TransitionCallbackReturn:
        try:
            return self._callbacks[self._state_machine.current_state[0]](before)  # type: ignore[no-any-return]
        except Exception:
            return TransitionCallbackReturn.ERROR

    def __change_state(self, given: int) -> TransitionCallbackReturn:
        machine = self._state_machine
        number, label = machine.current_state
        before = LifecycleState(state_id=number, label=label)
        machine.trigger(given)
        result = self.__execute_callback(before)
        machine.trigger(result.to_label())
        if result == TransitionCallbackReturn.ERROR:
            machine.trigger(self.__execute_callback(before).to_label())
        return result

    def __on_change_state(self, request: Any, response: Any) -> Any:
        given = request.transition.id
        if request.transition.label:
            try:
                given = self._state_machine.get_transition_by_label(request.transition.label)
            except RCLError:
                response.success = False
                return response
        response.success = self.__change_state(given) == TransitionCallbackReturn.SUCCESS
        return response

    def __on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state.id, response.current_state.label = self._state_machine.current_state
        return response

    def __on_get_available_states(self, request: Any, response: Any) -> Any:
        kind = import_module("lifecycle_msgs.msg").State
        response.available_states = [kind(id=number, label=label) for number, label in _STATES.items()]
        return response

    def __on_get_available_transitions(self, request: Any, response: Any) -> Any:
        return self._rosspin_list(self._state_machine.available_transitions, response)

    def __on_get_transition_graph(self, request: Any, response: Any) -> Any:
        return self._rosspin_list(_GRAPH, response)

    @staticmethod
    def _rosspin_list(transitions: list[Transition], response: Any) -> Any:
        kind = import_module("lifecycle_msgs.msg").TransitionDescription
        for transition in transitions:
            item = kind()
            item.transition.id, item.transition.label = transition[:2]
            item.start_state.id, item.start_state.label = transition[2:4]
            item.goal_state.id, item.goal_state.label = transition[4:]
            response.available_transitions.append(item)
        return response


class LifecycleNode(LifecycleNodeMixin, nodes.Node):
    """A managed node: others take it from state to state, or it does so itself. Takes and raises what Node does."""

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        nodes.Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)


# Other names of these.
Node = LifecycleNode
NodeMixin = LifecycleNodeMixin
Publisher = LifecyclePublisher
State = LifecycleState
