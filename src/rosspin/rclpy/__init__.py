"""The stand-in for rclpy: its names and its rules for time, on the wall clock or in simulated time.

What is here behaves as in rclpy 7.1 (Jazzy); the rest raises :class:`NotSimulated`.
"""

from __future__ import annotations

import os
import signal
import sys
import typing
from importlib import import_module
from types import ModuleType
from typing import Any

from ..clocks.frames import show_in
from ..world.world import World, current_world, refusing
from . import (
    action,
    callback_groups,
    clock,
    constants,
    context,
    deadlock,
    destroyable,
    duration,
    event_handler,
    exceptions,
    executors,
    experimental,
    impl,
    implementation,
    lifecycle,
    logging,
    logging_service,
    names,
    node,
    parameter,
    parameter_client,
    parameter_event_handler,
    parameter_service,
    qos,
    qos_event,
    qos_overriding_options,
    serialization,
    service_introspection,
    services,
    signals,
    task,
    time,
    time_source,
    timer,
    topic_endpoint_info,
    topics,
    type_description_service,
    type_hash,
    type_support,
    utilities,
    waitable,
)
from .context import Context, get_default_context
from .executors import Executor as _Executor
from .executors import SingleThreadedExecutor as _SingleThreadedExecutor
from .imported import brought_by as brought_by
from .parameter import Parameter
from .passed_on import PASSED_ON, passing_on
from .signals import SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers
from .task import Future
from .utilities import get_rmw_implementation_identifier, ok, try_shutdown
from .utilities import shutdown as _shutdown

__all__ = [
    "Context",
    "Future",
    "Parameter",
    "SignalHandlerOptions",
    "create_node",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "install_signal_handlers",
    "ok",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
    "uninstall_signal_handlers",
]


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> None:
    """Begin a context: read the command line ``args`` (default: the process's), and let Ctrl-C and SIGTERM end it.

    Raises RuntimeError if it was called before, RCLError and UnknownROSArgsError for what follows ``--ros-args``.
    """
    default = get_default_context()
    context = context or default
    if signal_handler_options is None:
        signal_handler_options = SignalHandlerOptions.ALL if context is default else SignalHandlerOptions.NO
    context.init(args, domain_id=domain_id)
    install_signal_handlers(signal_handler_options)


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """End a context: call the hooks and wake whoever waits. Signals do again what they did before ``init``.

    Raises RuntimeError before ``init`` and after ``shutdown``, RCLError after a signal.
    """
    is_default = context is None or context is get_default_context()
    _shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and is_default):
        uninstall_signal_handlers()


def create_node(node_name: str, **kwargs: Any) -> node.Node:
    """Make a :class:`rclpy.node.Node` with these arguments."""
    for word in kwargs.keys() - (node.Node.__init__.__kwdefaults__ or {}).keys():
        raise TypeError(f"create_node() got an unexpected keyword argument '{word}'")
    import_module("rclpy.node")  # from now on it is a name of the package, too
    return node.Node(node_name, **kwargs)


class _Global:
    """Of a process: the executor of :func:`get_global_executor`."""

    ROS = 2

    def __init__(self, world: World) -> None:
        self.executor: _Executor | None = None


def get_global_executor() -> _Executor:
    """The executor that ``spin``, ``spin_once`` and ``spin_until_future_complete`` use if they are given none."""
    own = current_world().part(_Global)
    if own.executor is None:
        import_module("rclpy.executors")  # from now on it is a name of the package, too
        own.executor = _SingleThreadedExecutor()

        def reset() -> None:
            if own.executor:
                own.executor.shutdown()
            own.executor = None

        get_default_context().on_shutdown(reset)
    return own.executor


def spin(node: node.Node, executor: _Executor | None = None) -> None:
    """Call what is due in a node until its context is shut down.

    Raises what a callback raises, and ExternalShutdownException if a signal shuts the context down while it waits.
    Ctrl-C raises KeyboardInterrupt in the main thread.
    """
    executor = executor or get_global_executor()
    try:
        executor.add_node(node)
        while executor.context.ok():
            executor.spin_once()
    finally:
        executor.remove_node(node)


def spin_once(node: node.Node, *, executor: _Executor | None = None, timeout_sec: float | None = None) -> None:
    """Wait until a call of a node is due, for at most ``timeout_sec`` (None: no limit), and make it."""
    executor = executor or get_global_executor()
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_once(timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def spin_until_future_complete(
    node: node.Node, future: Future, executor: _Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Call what is due in a node until a future is done, for at most ``timeout_sec``."""
    executor = executor or get_global_executor()
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


# The names that the modules here lack.
LACKING = {
    "rclpy.experimental": {"EventsExecutor"},
    "rclpy.type_description_service": {"TypeDescriptionService"},
}

# Names that differ from rclpy's, and how.
IN_PART = {
    "Context": "There is no network: ``domain_id`` has no effect.",
    "MultiThreadedExecutor": "Without ``num_threads`` it has 4 threads, not as many as there are processors.",
    "Client": "What was asked before the service is known is lost, also with ``TRANSIENT_LOCAL``.",
    "JumpHandle": "One that a node drops continues; on a real ROS the next jump then calls what is no longer there.",
    "LifecycleNode": "Managed entities come in the order in which they were added; on a real ROS in any.",
    "Node": "The service that describes its types is only named.",
    "Publisher": "Fields are always checked, as with ``ROS_PYTHON_CHECK_FIELDS=1``.",
    "PublisherEventCallbacks": "``incompatible_type`` is never called, as with Fast DDS.",
    "QoSProfile": "``avoid_ros_namespace_conventions`` has no effect.",
    "RcutilsLogger": "On the console and on ``/rosout``, not in a file. rcl itself says little.",
    "Service": "As ``Client``.",
    "SubscriptionEventCallbacks": "``message_lost`` is never called, as nothing is lost, nor is ``incompatible_type``, "
    "as with Fast DDS.",
    "Timer": "A period of less than 1 µs calls every 0.1 ms, about as often as a real machine can.",
    "TimerInfo": "It is there; on a real ROS 2 only from Kilted on.",
    "get_available_rmw_implementations": "Only the default one is there; on a real ROS those that are installed.",
    "serialize_message": "Bytes that mean nothing are 0; on a real ROS they are what happened to be there.",
    "signals": "A handler that the node sets itself is called immediately, not when the executor wakes.",
    "wait_for_message": "It gets the message even if another thread spins the node; on a real ROS the two race.",
}

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {
    "rclpy": sys.modules[__name__],
    "rclpy._rclpy_pybind11": implementation,
    "rclpy.action": action,
    "rclpy.action.client": action,
    "rclpy.action.graph": action,
    "rclpy.action.server": action,
    "rclpy.callback_groups": callback_groups,
    "rclpy.client": services,
    "rclpy.clock": clock,
    "rclpy.clock_type": time,
    "rclpy.constants": constants,
    "rclpy.context": context,
    "rclpy.destroyable": destroyable,
    "rclpy.duration": duration,
    "rclpy.event_handler": event_handler,
    "rclpy.exceptions": exceptions,
    "rclpy.executors": executors,
    "rclpy.expand_topic_name": names,
    "rclpy.experimental": experimental,
    "rclpy.experimental.events_executor": experimental,
    "rclpy.guard_condition": executors,
    "rclpy.impl": impl,
    "rclpy.impl.implementation_singleton": implementation,
    "rclpy.impl.logging_severity": logging,
    "rclpy.impl.rcutils_logger": logging,
    "rclpy.lifecycle": lifecycle,
    "rclpy.lifecycle.managed_entity": lifecycle,
    "rclpy.lifecycle.node": lifecycle,
    "rclpy.lifecycle.publisher": lifecycle,
    "rclpy.logging": logging,
    "rclpy.logging_service": logging_service,
    "rclpy.node": node,
    "rclpy.parameter": parameter,
    "rclpy.parameter_client": parameter_client,
    "rclpy.parameter_event_handler": parameter_event_handler,
    "rclpy.parameter_service": parameter_service,
    "rclpy.publisher": topics,
    "rclpy.qos": qos,
    "rclpy.qos_event": qos_event,
    "rclpy.qos_overriding_options": qos_overriding_options,
    "rclpy.serialization": serialization,
    "rclpy.service": services,
    "rclpy.service_introspection": service_introspection,
    "rclpy.signals": signals,
    "rclpy.subscription": topics,
    "rclpy.task": task,
    "rclpy.time": time,
    "rclpy.time_source": time_source,
    "rclpy.timer": timer,
    "rclpy.topic_endpoint_info": topic_endpoint_info,
    "rclpy.topic_or_service_is_hidden": names,
    "rclpy.type_description_service": type_description_service,
    "rclpy.type_hash": type_hash,
    "rclpy.type_support": type_support,
    "rclpy.utilities": utilities,
    "rclpy.validate_full_topic_name": names,
    "rclpy.validate_namespace": names,
    "rclpy.validate_node_name": names,
    "rclpy.validate_parameter_name": names,
    "rclpy.validate_topic_name": names,
    "rclpy.wait_for_message": topics,
    "rclpy.waitable": waitable,
}

for _name, _lacking in LACKING.items():
    MODULES[_name].__getattr__ = refusing(_name, _lacking)  # type: ignore[method-assign]
for _name, _sources in PASSED_ON.items():
    MODULES[_name].__getattr__ = passing_on(_name, _sources)  # type: ignore[method-assign]

# Says why something waits without end.
explain_waits = deadlock.explain


def _end_of_process() -> None:
    """Abort if a thread that still spins continues while the process ends, as daemon threads may.

    On a real ROS such a thread takes Python's lock back within C++ code, and Python ends it there, which C++ does not
    allow. Whoever continues later finds the process gone.
    """
    own = current_world().part(context.State)
    if any(executor._rosspin_wakes_within(_ENDING) for executor in list(own.executors)):
        sys.stderr.write("terminate called without an active exception\n")
        os._exit(128 + signal.SIGABRT)


# How long (ns) a process continues once its main thread has ended: 0.1 to 0.2 s were measured.
_ENDING = 150_000_000

# What importing rclpy registers with atexit.
AT_EXIT: list[Any] = [(_end_of_process, (), {})]

# Tracebacks and texts show the names of a real ROS.
_HOMES = {
    **dict.fromkeys(("ActionClient", "ClientGoalHandle"), "rclpy.action.client"),
    **dict.fromkeys(("ActionServer", "CancelResponse", "GoalResponse", "ServerGoalHandle"), "rclpy.action.server"),
    "Client": "rclpy.client",
    "ClockType": "rclpy.clock_type",
    "GuardCondition": "rclpy.guard_condition",
    **dict.fromkeys(("LifecycleNode", "LifecycleNodeMixin", "LifecycleState"), "rclpy.lifecycle.node"),
    "LifecyclePublisher": "rclpy.lifecycle.publisher",
    "LoggingSeverity": "rclpy.impl.logging_severity",
    "Publisher": "rclpy.publisher",
    "RcutilsLogger": "rclpy.impl.rcutils_logger",
    **dict.fromkeys(("ManagedEntity", "SimpleManagedEntity"), "rclpy.lifecycle.managed_entity"),
    "Service": "rclpy.service",
    "ServiceIntrospectionState": "rclpy._rclpy_pybind11.service_introspection",
    "Subscription": "rclpy.subscription",
    "Time": "rclpy.time",
    **dict.fromkeys(
        (
            *("NodeNameNonExistentError", "QoSCompatibility", "SignalHandlerOptions", "TransitionCallbackReturnType"),
            "UnsupportedEventTypeError",
        ),
        "rclpy._rclpy_pybind11",
    ),
}
for _name, _module in MODULES.items():
    for _value in [value for value in vars(_module).values() if isinstance(value, type)]:
        if _value.__module__ == _module.__name__:
            show_in(_value, _HOMES.get(_value.__name__, _name))


def for_process() -> ModuleType:
    """Make the module that a process gets as ``rclpy``: its names, and the modules that the process imports."""
    package = ModuleType("rclpy", __doc__)
    package.__file__ = __file__
    vars(package).update({name: globals()[name] for name in (*__all__, "_shutdown")})
    vars(package).update({name: getattr(typing, name) for name in ("List", "Optional", "TYPE_CHECKING")})
    return package
