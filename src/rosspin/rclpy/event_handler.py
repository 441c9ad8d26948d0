"""What the endpoints of topics tell a node: who comes and goes, and what is late (source: rclpy/event_handler.py)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import TYPE_CHECKING, Any, ClassVar

from ..clocks.frames import warn
from .exceptions import RCLError
from .logging import get_logger
from .qos import QoSPolicyKind, qos_policy_name_from_kind

if TYPE_CHECKING:
    from .callback_groups import CallbackGroup
    from .handle import RclNode

__all__ = [
    *("EventHandler", "IncompatibleTypeInfo", "PublisherEventCallbacks", "QoSEventHandler", "QoSLivelinessChangedInfo"),
    *("QoSLivelinessLostInfo", "QoSMessageLostInfo", "QoSOfferedDeadlineMissedInfo", "QoSOfferedIncompatibleQoSInfo"),
    *("QoSPublisherEventType", "QoSPublisherMatchedInfo", "QoSRequestedDeadlineMissedInfo"),
    *("QoSRequestedIncompatibleQoSInfo", "QoSSubscriptionEventType", "QoSSubscriptionMatchedInfo"),
    *("SubscriptionEventCallbacks", "UnsupportedEventTypeError"),
]


class UnsupportedEventTypeError(RCLError):
    """The middleware knows no such event. It is not raised: Fast DDS takes a callback for each."""


class QoSPublisherEventType(IntEnum):
    """What a publisher tells."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    """What a subscription tells."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


@dataclass(frozen=True)
class QoSRequestedDeadlineMissedInfo:
    """How often it has happened in all, and since the last call."""

    total_count: int
    total_count_change: int


@dataclass(frozen=True)
class QoSLivelinessChangedInfo:
    """How many publishers are alive, and how many are not; the changes since the last call."""

    alive_count: int
    alive_count_change: int
    not_alive_count: int
    not_alive_count_change: int


@dataclass(frozen=True)
class QoSRequestedIncompatibleQoSInfo(QoSRequestedDeadlineMissedInfo):
    """How many endpoints do not match, and the policy by which the last one does not."""

    last_policy_kind: QoSPolicyKind


@dataclass(frozen=True)
class QoSPublisherMatchedInfo(QoSRequestedDeadlineMissedInfo):
    """How many other endpoints have been met, and how many are there; the changes since the last call."""

    current_count: int
    current_count_change: int


QoSOfferedDeadlineMissedInfo = QoSRequestedDeadlineMissedInfo
QoSLivelinessLostInfo = QoSRequestedDeadlineMissedInfo
QoSMessageLostInfo = QoSRequestedDeadlineMissedInfo  # which is never given: nothing is lost
QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo
QoSSubscriptionMatchedInfo = QoSPublisherMatchedInfo
IncompatibleTypeInfo = QoSRequestedDeadlineMissedInfo  # which is never given: Fast DDS does not tell

# What a callback is given, by the name of its event; else a total.
_INFOS: dict[str, type[Any]] = {
    "RCL_SUBSCRIPTION_LIVELINESS_CHANGED": QoSLivelinessChangedInfo,
    "RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS": QoSRequestedIncompatibleQoSInfo,
    "RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS": QoSOfferedIncompatibleQoSInfo,
    "RCL_SUBSCRIPTION_MATCHED": QoSSubscriptionMatchedInfo,
    "RCL_PUBLISHER_MATCHED": QoSPublisherMatchedInfo,
}


class EventHandler:
    """Lets an executor call ``callback(info)`` after events of an endpoint: one call for all since the last."""

    _rosspin_is_rare = False  # whether executors look at it only from its first event on

    def __init__(
        self, *, callback_group: CallbackGroup, callback: Callable[[Any], Any], event_type: IntEnum, parent_impl: Any
    ) -> None:
        self.callback_group = callback_group
        self.callback = callback
        self.event_type = event_type
        self._executor_event = False
        self._futures: list[Any] = []  # as all that a node can wait for
        self._rosspin = _Listener(getattr(parent_impl, "_rosspin", parent_impl).node)
        callback_group.add_entity(self)

    def _rosspin_happen(self, policy: QoSPolicyKind = QoSPolicyKind.INVALID, **changes: int) -> None:
        """Let the executor tell of changes of the counts, and of the policy by which an endpoint does not fit."""
        own = self._rosspin
        if own.is_destroyed:
            return
        own.policy = policy
        for name, change in changes.items():
            own.counts[f"{name}_count"] += change
            own.counts[f"{name}_count_change"] += change
        own.messages = True
        if node := own.node.node():
            node._rosspin_serve(self)

    def _rosspin_take(self) -> Any:
        """Return the call to make, or None if there is nothing to tell any more."""
        own = self._rosspin
        if not own.messages:
            return None
        own.messages = False
        info = _INFOS.get(self.event_type.name, QoSRequestedDeadlineMissedInfo)
        values = {field.name: own.counts[field.name] for field in fields(info)}
        if "last_policy_kind" in values:
            values["last_policy_kind"] = own.policy
        for name in own.counts:
            if name.endswith("_change"):
                own.counts[name] = 0
        return self.callback, (info(**values),), None

    def destroy(self) -> None:
        """Tell nothing any more."""
        self._rosspin.messages = False
        self._rosspin.is_destroyed = True


class _Listener:
    """What an event handler has to tell: ``messages`` is whether there is anything."""

    endpoints = ()

    def __init__(self, node: RclNode) -> None:
        self.node = node
        self.messages = False
        self.is_destroyed = False
        self.counts: Counter[str] = Counter()  # by the names of the info's fields
        self.policy = QoSPolicyKind.INVALID


class QoSEventHandler(EventHandler):
    """The former name of :class:`EventHandler`."""

    def __init__(self, **kwargs: Any) -> None:
        warn("QoSEventHandler is deprecated, use EventHandler instead.", DeprecationWarning)
        super().__init__(**kwargs)


class _EventCallbacks:
    """What a publisher's callbacks and a subscription's have in common."""

    use_default_callbacks: bool
    _rosspin_types: ClassVar[Mapping[str, IntEnum]]  # by the name of the callback, in the order of the calls
    _rosspin_refusal: ClassVar[str]

    def create_event_handlers(
        self, callback_group: CallbackGroup, endpoint: Any, topic_name: str
    ) -> list[EventHandler]:
        """Make what tells the events of an endpoint, to the callbacks that were given or to the log."""

        def log_policy(info: QoSRequestedIncompatibleQoSInfo) -> None:
            policy = qos_policy_name_from_kind(info.last_policy_kind)
            get_logger(endpoint.node.logger_name).warn(self._rosspin_refusal.format(topic_name, policy))

        def log_type(info: Any) -> None:
            get_logger(endpoint.node.logger_name).warn(
                f"Incompatible type on topic '{topic_name}', no messages will be sent to it."
            )

        defaults = {"incompatible_qos": log_policy, "incompatible_type": log_type}
        handlers = []
        for name, event_type in self._rosspin_types.items():
            default = defaults.get(name) if self.use_default_callbacks else None
            if callback := getattr(self, name) or default:
                handler = EventHandler(
                    callback_group=callback_group, callback=callback, event_type=event_type, parent_impl=endpoint
                )
                handler._rosspin_is_rare = callback is default  # nearly each endpoint has it, hardly any needs it
                handlers.append(handler)
        return handlers


@dataclass(kw_only=True, eq=False)
class SubscriptionEventCallbacks(_EventCallbacks):
    """What a subscription calls. ``use_default_callbacks``: what does not match is logged, unless there is one."""

    deadline: Callable[[QoSRequestedDeadlineMissedInfo], Any] | None = None
    incompatible_qos: Callable[[QoSRequestedIncompatibleQoSInfo], Any] | None = None
    liveliness: Callable[[QoSLivelinessChangedInfo], Any] | None = None
    message_lost: Callable[[QoSMessageLostInfo], Any] | None = None
    incompatible_type: Callable[[IncompatibleTypeInfo], Any] | None = None
    matched: Callable[[QoSSubscriptionMatchedInfo], Any] | None = None
    use_default_callbacks: bool = True

    _rosspin_types: ClassVar[Mapping[str, IntEnum]] = {
        "deadline": QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED,
        "incompatible_qos": QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS,
        "liveliness": QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
        "message_lost": QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST,
        "incompatible_type": QoSSubscriptionEventType.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
        "matched": QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED,
    }
    _rosspin_refusal: ClassVar[str] = (
        "New publisher discovered on topic '{}', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: {}"
    )


@dataclass(kw_only=True, eq=False)
class PublisherEventCallbacks(_EventCallbacks):
    """What a publisher calls. ``use_default_callbacks``: what does not match is logged, unless there is one."""

    deadline: Callable[[QoSOfferedDeadlineMissedInfo], Any] | None = None
    liveliness: Callable[[QoSLivelinessLostInfo], Any] | None = None
    incompatible_qos: Callable[[QoSOfferedIncompatibleQoSInfo], Any] | None = None
    incompatible_type: Callable[[IncompatibleTypeInfo], Any] | None = None
    matched: Callable[[QoSPublisherMatchedInfo], Any] | None = None
    use_default_callbacks: bool = True

    _rosspin_types: ClassVar[Mapping[str, IntEnum]] = {
        "deadline": QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED,
        "liveliness": QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST,
        "incompatible_qos": QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS,
        "incompatible_type": QoSPublisherEventType.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
        "matched": QoSPublisherEventType.RCL_PUBLISHER_MATCHED,
    }
    _rosspin_refusal: ClassVar[str] = (
        "New subscription discovered on topic '{}', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: {}"
    )
