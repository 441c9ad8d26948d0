"""What the master tells of the nodes of a run (sources: rospy/msproxy.py, rosmaster/master_api.py, paramserver.py)."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from ..world.world import NotSimulated, World, current_world
from . import client, names, rosgraph
from .state import State, state

__all__ = ["ALTERS", "CALLS", "OF_NAMES", "URI", "Master", "get_master"]

URI = "http://localhost:11311/"

ALTERS = ("register", "unregister", "subscribeParam", "unsubscribeParam")

Answer = tuple[int, str, Any]  # 1 if it went well, else -1; what the master says; a value


class Master:
    """The master, as a node asks it: ``getSystemState()`` and its like return 1 or -1, a text and a value.

    Its items are the parameters.
    """

    def __getattr__(self, key: str) -> Callable[..., list[Any]]:
        if key == "target" or key.startswith(ALTERS):
            raise NotSimulated(f"rospy.get_master().{key}")

        def ask(*args: Any) -> list[Any]:
            words = list(args)
            if key in OF_NAMES:
                words[0] = names.resolve_name(words[0])
            elif key not in CALLS:
                from xmlrpc.client import Fault  # slow to import

                raise Fault(1, f"<class 'Exception'>:method \"{key}\" is not supported")
            call, count = OF_NAMES.get(key) or CALLS[key]
            return list(call(state(), *words)) if len(words) == count else [-1, "Error: bad call arity", -1]

        return ask

    def __getitem__(self, key: str) -> Any:
        return client.get_param(key)

    def __setitem__(self, key: str, val: Any) -> None:
        client.set_param(key, val)

    def __delitem__(self, key: str) -> None:
        client.delete_param(key)

    def __contains__(self, key: str) -> bool:
        return client.has_param(key)

    def __iter__(self) -> Iterator[str]:
        return iter(client.get_param_names())


class _Own:
    """The master of a process."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.master = Master()


def get_master() -> Master:
    """Return what answers for the master of the run; see :class:`Master`. It can be called before ``init_node``."""
    return current_world().part(_Own).master


def _nodes(node: State) -> list[State]:
    return [each for each in node.master.nodes.values() if not each.shutdown]


def _published(node: State) -> list[tuple[str, str, str]]:
    """The topics with a publisher, as get_published_topics has them, their types and nodes."""
    logs = [(*client.LOG, each.name) for each in _nodes(node) if each.rosout]
    return [
        *logs,
        *((each.topic, each.type, each.node.name) for each in node.world.graph.endpoints()[0]),
    ]


def _subscribed(node: State) -> list[tuple[str, str, str]]:
    return [(each.topic, each.type, each.node.name) for each in node.world.graph.endpoints()[1]]


def _services(node: State) -> dict[str, State]:
    """The services of all nodes. As on a real ROS, each has two for its loggers, which only have names here."""
    loggers = {f"{each.name}/{service}": each for each in _nodes(node) for service in client.LOGGERS}
    return {**loggers, **{name: services.node for name, services in node.master.services.items()}}


def _by_name(pairs: Iterable[tuple[str, str]]) -> list[list[Any]]:
    found: dict[str, list[str]] = {}
    for name, node in pairs:
        found.setdefault(name, []).append(node)
    return [[name, nodes] for name, nodes in found.items()]


def _system_state(node: State) -> Answer:
    published = _by_name((topic, name) for topic, _, name in _published(node))
    subscribed = _by_name((topic, name) for topic, _, name in _subscribed(node))
    services = _by_name((name, of.name) for name, of in _services(node).items())
    return 1, "current system state", [published, subscribed, services]


def _topics(node: State, subgraph: str) -> Answer:
    return 1, "current topics", client.get_published_topics(subgraph)


def _types(node: State) -> Answer:
    known = {topic: kind for topic, kind, _ in [*_published(node), *_subscribed(node)] if kind != rosgraph.ANYTYPE}
    return 1, "current system state", [list(pair) for pair in known.items()]


def _node(node: State, name: str) -> Answer:
    found = {each.name: each for each in _nodes(node)}.get(name)
    return (1, "node api", found.uri) if found else (-1, f"unknown node [{name}]", "")


def _service(node: State, name: str) -> Answer:
    found = _services(node).get(name)
    if not found:
        return -1, "no provider", ""
    uri = str(found.uri).replace("http", "rosrpc").rstrip("/")
    return 1, f"rosrpc URI: [{uri}]", uri


def _get(node: State, name: str) -> Answer:
    try:
        return 1, f"Parameter [{name}]", client.get_param(name)
    except KeyError:
        return -1, f"Parameter [{name}] is not set", 0


def _set(node: State, name: str, value: Any) -> Answer:
    client.set_param(name, value)
    return 1, f"parameter {name} set", 0


def _search(node: State, name: str) -> Answer:
    if client.search_param(name):
        return 1, f"Found [{name}]", name
    return -1, f"Cannot find parameter [{name}] in an upwards search", ""


def _delete(node: State, name: str) -> Answer:
    try:
        client.delete_param(name)
    except KeyError:
        return -1, f"parameter [{name}] is not set", 0
    return 1, f"parameter {name} deleted", 0


# What the master answers: a function of the node that asks, and how many arguments the node gives.
CALLS: dict[str, tuple[Callable[..., Answer], int]] = {
    "getParamNames": (lambda node: (1, "Parameter names", client.get_param_names()), 0),
    "getPid": (lambda node: (1, "", os.getpid()), 0),
    "getSystemState": (_system_state, 0),
    "getTopicTypes": (_types, 0),
    "getUri": (lambda node: (1, "", URI), 0),
}

# The same for those whose first argument is a name.
OF_NAMES: dict[str, tuple[Callable[..., Answer], int]] = {
    "deleteParam": (_delete, 1),
    "getParam": (_get, 1),
    "getPublishedTopics": (_topics, 1),
    "hasParam": (lambda node, name: (1, name, client.has_param(name)), 1),
    "lookupNode": (_node, 1),
    "lookupService": (_service, 1),
    "searchParam": (_search, 1),
    "setParam": (_set, 2),
}
