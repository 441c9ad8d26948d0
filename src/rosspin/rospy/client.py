"""Starting and spinning a node, waiting for messages, parameters (sources: rospy/client.py, rospy/msproxy.py)."""

from __future__ import annotations

import logging
import os
import sys
import threading
import warnings
from collections.abc import Callable, Mapping
from copy import deepcopy
from importlib import import_module
from typing import Any

from ..clocks.clock import nanoseconds
from ..messages.genpy import Duration
from ..world import yaml_texts
from . import names, rosgraph
from .core import add_client_shutdown_hook, handle_signal, may_register, signal_shutdown
from .exceptions import ROSException, ROSInitException, ROSInterruptException
from .state import State, handle_signals, param_path, state
from .topics import LATER_PUBLISHER, Subscriber

__all__ = [
    "DEBUG",
    "ERROR",
    "FATAL",
    "INFO",
    "WARN",
    "delete_param",
    "get_param",
    "get_param_cached",
    "get_param_names",
    "get_published_topics",
    "has_param",
    "init_node",
    "myargv",
    "on_shutdown",
    "search_param",
    "set_param",
    "spin",
    "wait_for_message",
]

# Levels, numbered as in rosgraph_msgs/Log.
DEBUG, INFO, WARN, ERROR, FATAL = 1, 2, 4, 8, 16

_LEVELS = {
    DEBUG: logging.DEBUG,
    INFO: logging.INFO,
    WARN: logging.WARNING,
    ERROR: logging.ERROR,
    FATAL: logging.CRITICAL,
}

# The services for a node's loggers, which only have names here; and its log, of which only the name and the type are.
LOGGERS = ("get_loggers", "set_logger_level")
LOG = ("/rosout", "rosgraph_msgs/Log")

_unspecified: Any = object()

# How often (ns) wait_for_message looks.
_LOOK = 10_000_000


def init_node(
    name: str,
    argv: list[str] | None = None,
    anonymous: bool = False,
    log_level: int | None = None,
    disable_rostime: bool = False,
    disable_rosout: bool = False,
    disable_signals: bool = False,
    xmlrpc_port: int = 0,
    tcpros_port: int = 0,
) -> None:
    """Make this process the node ``name``; ``__name:=`` and ``__ns:=`` on the command line ``argv`` override it.

    ``anonymous`` makes the name unique; ``log_level`` is the lowest severity that is shown (default: rospy.INFO);
    ``disable_signals`` leaves SIGINT and SIGTERM to the caller. ``disable_rosout`` and the ports have no effect, as
    there is no network. A second call with the same arguments does nothing; with others it raises ROSException. Raises
    ValueError if the name is empty or contains ``/``, and ROSInitException if a private parameter is not YAML.
    """
    node = state()
    if argv is None:
        argv = node.world.argv
    else:
        names.reload_mappings(argv)
    if not name:
        raise ValueError("name must not be empty")
    if rosgraph.SEP in name:
        raise ValueError("namespaces are not allowed in node names")
    arguments = (name, argv, anonymous, log_level, disable_rostime, disable_signals)
    if node.init_args is not None:
        if node.init_args != arguments:
            raise ROSException(f"rospy.init_node() has already been called with different arguments: {node.init_args}")
        return
    node.init_args = arguments
    if not disable_signals:
        handle_signals(handle_signal)

    if "__name" in node.mappings:
        name, anonymous = node.mappings["__name"], False
    if anonymous:
        name = f"{name}_{os.getpid() + node.world.number}_{node.clock.system() // 1_000_000}"
    if not rosgraph.is_legal_base_name(name):
        warnings.warn(
            f"'{name}' is not a legal ROS base name. This may cause problems with other ROS tools.", stacklevel=2
        )
    parameters = {**node.private_parameters, **load_command_line_node_params(argv)}
    node.log_level = logging.INFO if log_level is None else _LEVELS[log_level]
    begin_node(rosgraph.resolve_name(name, node.name), parameters, not disable_rostime)
    node.rosout = not disable_rosout


def begin_node(name: str, parameters: Mapping[str, Any], follows_clock: bool = True) -> None:
    """Make this process the node with a full name, and set its private parameters. It may follow ``/clock``."""
    node = state()
    names._set_caller_id(name)
    names.initialize_mappings(name)
    for parameter, value in parameters.items():
        set_param(rosgraph.PRIV_NAME + parameter, value)
    _replace(node)
    node.initialized = True
    for register in node.at_init:
        register()
    for service in LOGGERS:
        may_register("service", "service", f"{node.name}/{service}")
    if follows_clock and get_param("/use_sim_time", False):
        _listen_to_clock(node)
    node.time_initialized = True


def _replace(node: State) -> None:
    """Register a node's name, and shut down any other node that has it (source: rosmaster/registrations.py)."""
    other = node.master.nodes.get(node.name)
    node.master.nodes[node.name] = node
    if other and not other.shutdown_requested:
        other.world.start(threading.Thread(target=_shut_down, args=(other,), daemon=True))


def _shut_down(node: State) -> None:
    node.clock.sleep(LATER_PUBLISHER)  # the master is as slow to tell it as to tell subscribers of a new publisher
    sys.stdout.write(f"shutdown request: [{node.name}] Reason: new node registered with same name\n")
    signal_shutdown("external shutdown request")


def _listen_to_clock(node: State) -> None:
    """Take ROS time from /clock; it is 0 until the first message comes (source: rospy/impl/simtime.py)."""
    Clock = import_module("rosgraph_msgs.msg").Clock
    Subscriber("/clock", Clock, lambda message: node.set_ros_time(message.clock.to_nsec()), queue_size=1)
    node.set_ros_time(0)


def load_command_line_node_params(argv: list[str]) -> dict[str, Any]:
    """Read the values of ``_name:=value`` on a command line as YAML."""
    try:
        pairs = [(name[1:], text) for name, text in rosgraph.split_remappings(argv) if rosgraph.is_parameter(name)]
        if not pairs:
            return {}
        return {name: yaml_texts.load(text) for name, text in pairs}
    except Exception as error:
        raise ROSInitException(f"invalid command-line parameters: {error}")


def myargv(argv: list[str] | None = None) -> list[str]:
    """Return the command line without its remappings."""
    return [arg for arg in (state().world.argv if argv is None else argv) if not rosgraph.is_legal_remap(arg)]


def on_shutdown(h: Callable[[], Any]) -> None:
    """Call ``h`` at shutdown, while ``is_shutdown()`` is still False. Raises TypeError if it is not callable."""
    add_client_shutdown_hook(h)


def spin() -> None:
    """Wait until the node is shut down. It calls no callbacks: timers and subscribers have threads of their own.

    Raises ROSInitException before ``init_node``.
    """
    node = state()
    if not node.initialized:
        raise ROSInitException("client code must call rospy.init_node() first")
    try:
        while not node.shutdown:
            node.clock.sleep(500_000_000)
    except KeyboardInterrupt:
        signal_shutdown("keyboard interrupt")


# --- topics -----------------------------------------------------------------------------------------------------------


def wait_for_message(topic: str, topic_type: Any, timeout: float | Duration | None = None) -> Any:
    """Subscribe to a topic, wait for one message, and return it. It looks for one every 10 ms.

    ``timeout`` is in seconds or a Duration. Raises ROSException if it is exceeded, ROSInterruptException at shutdown.
    """
    node = state()
    received: list[Any] = []
    subscriber = Subscriber(topic, topic_type, received.append)
    try:
        seconds = timeout.to_sec() if isinstance(timeout, Duration) else timeout
        until = None if seconds is None else node.clock.system() + nanoseconds(seconds)
        while not node.shutdown and not received:
            node.clock.sleep(_LOOK)
            if until is not None and node.clock.system() >= until:
                raise ROSException(f"timeout exceeded while waiting for message on topic {topic}")
    finally:
        subscriber.unregister()
    if node.shutdown:
        raise ROSInterruptException("rospy shutdown")
    return received[0]


def get_published_topics(namespace: str = "/") -> list[list[str]]:
    """Return the published topics below a namespace, and their types: [[name, type], ...].

    As on a real ROS, the node's own log, /rosout, is one of them, although nothing is published there.
    """
    node = state()
    topics = dict(node.world.graph.topics())
    if node.initialized and node.rosout:
        topics = dict([LOG, *topics.items()])
    below = rosgraph.make_global_ns(namespace)
    return [[topic, kind] for topic, kind in topics.items() if topic.startswith(below)]


# --- parameters -------------------------------------------------------------------------------------------------------
# The nodes of a run share one parameter server.


def _path(name: str) -> list[str]:
    return param_path(names.resolve_name(name))


def _find(node: State, path: list[str]) -> Any:
    """Return the value at a path. Raises KeyError if there is none."""
    value: Any = node.master.parameters
    for part in path:
        if not isinstance(value, dict):
            raise KeyError(part)
        value = value[part]
    return value


def get_param(param_name: str, default: Any = _unspecified) -> Any:
    """Return a parameter's value, or a namespace as a dict; else ``default``. Raises KeyError if there is neither."""
    try:
        node = state()
        node.sought.add(names.resolve_name(param_name))
        return deepcopy(_find(node, _path(param_name)))
    except KeyError:
        if default is _unspecified:
            raise KeyError(param_name) from None
        return default


get_param_cached = get_param


def set_param(param_name: str, param_value: Any) -> None:
    """Set a parameter, or a whole namespace with a dict.

    The value is stored as XML-RPC would deliver it: a tuple comes back as a list. Raises TypeError for None, and
    OverflowError for an integer of more than 32 bits.
    """
    if not rosgraph.is_legal_name(param_name):
        warnings.warn(
            f"'{param_name}' is not a legal ROS graph resource name. This may cause problems with other ROS tools",
            stacklevel=2,
        )
    state().master.set_param(names.resolve_name(param_name), param_value)


def has_param(param_name: str) -> bool:
    """Whether there is a parameter or a namespace of that name."""
    return get_param(param_name, None) is not None


def delete_param(param_name: str) -> None:
    """Delete a parameter or a namespace. Raises KeyError if there is none."""
    path = _path(param_name)
    try:
        del _find(state(), path[:-1])[path[-1]]
    except (KeyError, TypeError):
        raise KeyError(param_name) from None


def search_param(param_name: str) -> str | None:
    """Search for a parameter from the node's namespace upwards. Return the full name of the nearest one, or None.

    Raises ROSException for a private name.
    """
    node = state()
    return search_from(node.name, node.mappings.get(param_name, param_name))


def search_from(node_name: str, name: str) -> str | None:
    """Search for a parameter upwards from a node's name, or a namespace (source: rosmaster/paramserver.py)."""
    if rosgraph.is_private(name):
        raise ROSException("cannot search for parameter: Internal failure: invalid key")
    if not name or rosgraph.is_global(name):
        return name if name and has_param(name) else None
    namespace = node_name + rosgraph.SEP
    while True:
        first = name.split(rosgraph.SEP)[0]
        if has_param(namespace + first):
            return namespace + name
        if namespace == rosgraph.SEP:
            return None
        namespace = rosgraph.namespace(namespace)


def get_param_names() -> list[str]:
    """Return the full names of all parameters."""

    def leaves(prefix: str, value: Any) -> list[str]:
        if not isinstance(value, dict):
            return [prefix]
        return [leaf for key, item in value.items() for leaf in leaves(f"{prefix}/{key}", item)]

    return leaves("", state().master.parameters)
