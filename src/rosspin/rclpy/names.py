"""Check and expand names of the ROS 2 graph (sources: rcl and rmw, validate_*_name.c)."""

from __future__ import annotations

import re
from collections.abc import Iterable

from .exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidParameterException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    not_accepted,
)

__all__ = [
    "expand_topic_name",
    "topic_or_service_is_hidden",
    "validate_full_topic_name",
    "validate_namespace",
    "validate_node_name",
    "validate_parameter_name",
    "validate_topic_name",
]

# A rule: a pattern that must not be found, and what is said if it is. The fault is at the match, or at its group.
Rule = tuple[str, str]

_NODE_NAME: list[Rule] = [
    (r"^$", "node name must not be empty"),
    (r"\W", "node name must not contain characters other than alphanumerics or '_'"),
    (r"^\d", "node name must not start with a number"),
    (r"^.{254}(.).", "node name length should not exceed '255'"),
]
_NAMESPACE: list[Rule] = [
    (r"^$", "namespace must not be empty"),
    (r"^[^/]", "namespace must be absolute, it must lead with a '/'"),
    (r".(/)$", "namespace must not end with a '/', unless only a '/'"),
    (r"[^\w/]", "namespace must not contain characters other than alphanumerics, '_', or '/'"),
    (r"/(/)", "namespace must not contain repeated '/'"),
    (r"/(\d)", "namespace must not have a token that starts with a number"),
    (r"^.{244}(.).", "namespace should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'"),
]
_TOPIC: list[Rule] = [
    (r"^$", "topic name must not be empty string"),
    (r"^\d", "topic name token must not start with a number"),
    (r"/$", "topic name must not end with a forward slash"),
    (r"[^\w/~{}]", "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"),
    (r".(~)", "topic name must not have tilde '~' unless it is the first character"),
    (r"{(?!\w*})|^[^{]*(})", "topic name must not have unmatched (unbalanced) curly braces '{}'"),
    (r"^~([^/]).", "topic name must not have a tilde '~' that is not followed by a forward slash '/'"),
    (r"/(\d)", "topic name token must not start with a number"),
]
_FULL_TOPIC: list[Rule] = [
    (r"^$", "topic name must not be empty string"),
    (r"^[^/]", "topic name must be absolute, it must lead with a '/'"),
    (r"/$", "topic name must not end with a '/'"),
    (r"[^\w/]", "topic name must not contain characters other than alphanumerics, '_', or '/'"),
    (r"/(/)", "topic name must not contain repeated '/'"),
    (r"/(\d)", "topic name must not have a token that starts with a number"),
    (r"^.{246}(.).", "topic length should not exceed '255U - 8U'"),
]


def _fault(name: str, rules: Iterable[Rule]) -> tuple[str, int] | None:
    """Return what is wrong with a name, and where in it; None if it is valid."""
    for pattern, text in rules:
        if found := re.search(pattern, name, re.ASCII):
            return text, found.start(found.lastindex or 0)
    return None


def _check(name: str, rules: Iterable[Rule], error: type[Exception]) -> bool:
    if found := _fault(name, rules):
        raise error(name, *found)
    return True


def validate_node_name(node_name: str) -> bool:
    """Return True. Raises InvalidNodeNameException for a faulty name."""
    return _check(node_name, _NODE_NAME, InvalidNodeNameException)


def validate_namespace(namespace: str) -> bool:
    """Return True for a full namespace. Raises InvalidNamespaceException for a faulty one."""
    return _check(namespace, _NAMESPACE, InvalidNamespaceException)


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True if a node may call a topic, or a service, so.

    Raises InvalidTopicNameException or InvalidServiceNameException if not.
    """
    return _check(name, _TOPIC, InvalidServiceNameException if is_service else InvalidTopicNameException)


def validate_full_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True for the full name of a topic, or of a service. Raises as ``validate_topic_name``."""
    return _check(name, _FULL_TOPIC, InvalidServiceNameException if is_service else InvalidTopicNameException)


def topic_or_service_is_hidden(name: str) -> bool:
    """Whether a part of a name begins with an underscore."""
    return any(part.startswith("_") for part in name.split("/"))


def validate_parameter_name(name: str) -> bool:
    """Return True. Raises InvalidParameterException for an empty name."""
    if not name:
        raise InvalidParameterException(name)
    return True


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the full name of a topic in a node. Raises ValueError for a faulty name or an unknown {word}."""
    given = {"topic name": topic_name, "node name": node_name, "node namespace": node_namespace}
    for (what, name), rules in zip(given.items(), (_TOPIC, _NODE_NAME, _NAMESPACE), strict=True):
        if not isinstance(name, str):
            signature = "(arg0: str, arg1: str, arg2: str) -> str"
            raise not_accepted(signature, *given.values(), function="rclpy_expand_topic_name")
        if found := _fault(name, rules):
            raise ValueError(f"{what} '{name}' is invalid: {found[0]}")
    words = {"node": node_name, "ns": node_namespace, "namespace": node_namespace}

    def fill(match: re.Match[str]) -> str:
        if match[1] not in words:
            raise ValueError(f"topic name '{topic_name}' is invalid: unknown substitution: {match[0]}")
        return words[match[1]]

    name = re.sub(r"{(\w*)}", fill, topic_name)
    below = node_namespace.rstrip("/")
    if name.startswith("~"):
        return f"{below}/{node_name}{name[1:]}"
    return name if name.startswith("/") else f"{below}/{name}"
