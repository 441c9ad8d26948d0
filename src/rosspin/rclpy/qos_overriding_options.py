"""Parameters that override the QoS of a topic's endpoint (source: rclpy/qos_overriding_options.py)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import IntEnum
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeAlias

from .duration import Duration
from .exceptions import ParameterAlreadyDeclaredException
from .qos import QoSPolicyKind, QoSProfile

if TYPE_CHECKING:
    from .node import Node

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions", "QosCallbackType"]

QosCallbackType: TypeAlias = Callable[[QoSProfile], Any]


class InvalidQosOverridesError(Exception):
    """The callback has refused a profile."""


class QoSOverridingOptions:
    """Says which policies of a publisher or subscription can be overridden by parameters.

    Such a one is named ``qos_overrides./topic.publisher.depth``, with ``entity_id``
    ``qos_overrides./topic.publisher_ID.depth``. ``callback(profile)`` returns a SetParametersResult.
    """

    def __init__(
        self,
        policy_kinds: Iterable[QoSPolicyKind],
        *,
        callback: QosCallbackType | None = None,
        entity_id: str | None = None,
    ) -> None:
        self.policy_kinds = policy_kinds
        self.callback = callback
        self.entity_id = entity_id

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        """Let history, depth and reliability be overridden."""
        kinds = QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY
        return cls(kinds, callback=callback, entity_id=entity_id)


def __getattr__(name: str) -> Any:
    if name == "QosCallbackResult":
        return import_module("rcl_interfaces.msg").SetParametersResult
    raise AttributeError(f"module 'rclpy.qos_overriding_options' has no attribute '{name}'", name=name)


def _declare_qos_parameters(
    entity_type: type, node: Node, topic: str, qos: QoSProfile, options: QoSOverridingOptions
) -> None:
    """Declare the parameters of a Publisher or Subscription, and set its profile by them.

    Raises RuntimeError for a value that a policy does not have, InvalidQosOverridesError if the callback refuses.
    """
    what = entity_type.__name__.lower()
    of = what if options.entity_id is None else f"{what}_{options.entity_id}"
    description = f" for {what} `{topic}` with id `{options.entity_id}`"
    for kind in options.policy_kinds:
        policy = kind.name.lower()
        if (what, policy) == ("subscription", "lifespan"):
            continue
        name = f"qos_overrides.{topic}.{of}.{policy}"
        descriptor = import_module("rcl_interfaces.msg").ParameterDescriptor(
            description=f"{policy}{description}", read_only=True
        )
        try:
            node.declare_parameter(name, _get_qos_policy_parameter(qos, kind), descriptor)
        except ParameterAlreadyDeclaredException:
            pass
        value = node.get_parameter(name).value
        current = getattr(qos, policy)
        if isinstance(current, Duration):
            value = Duration(nanoseconds=value)
        elif isinstance(current, IntEnum):
            try:
                value = type(current)[value.upper()]
            except KeyError:
                raise RuntimeError(f"Unexpected QoS override for policy `{policy}`: `{value}`") from None
        setattr(qos, policy, value)
    if options.callback is not None:
        result = options.callback(qos)
        if not result.successful:
            text = f"Provided QoS overrides{description}, are not valid: {result.reason}"
            raise InvalidQosOverridesError(text)


def _get_qos_policy_parameter(profile: QoSProfile, policy: QoSPolicyKind) -> str | int | bool:
    """Return a policy as the parameter that overrides it."""
    value = getattr(profile, policy.name.lower())
    if isinstance(value, Duration):
        return value.nanoseconds
    if not isinstance(value, IntEnum):
        return value  # type: ignore[no-any-return]
    if value.name == "UNKNOWN":
        raise ValueError("User provided QoS profile is invalid")
    return value.name.lower()
