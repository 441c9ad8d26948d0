"""Quality of service: how messages are kept and sent (source: rclpy/qos.py)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum, IntEnum
from typing import Any, NamedTuple

from ..clocks.frames import warn
from .duration import Duration

__all__ = [
    *("DurabilityPolicy", "HistoryPolicy", "InvalidQoSProfileException", "LivelinessPolicy", "QoSDurabilityPolicy"),
    *("QoSHistoryPolicy", "QoSLivelinessPolicy", "QoSPresetProfiles", "QoSProfile", "QoSReliabilityPolicy"),
    *("ReliabilityPolicy", "qos_profile_action_status_default", "qos_profile_best_available"),
    *("qos_profile_default", "qos_profile_parameter_events", "qos_profile_parameters", "qos_profile_sensor_data"),
    *("qos_profile_services_default", "qos_profile_system_default", "qos_profile_unknown"),
]


class InvalidQoSProfileException(Exception):
    """A profile lacks what it needs."""

    def __init__(self, *args: Any) -> None:
        super().__init__("Invalid QoSProfile", *args)


class _ShortKeys:
    """Gives the members of an enumeration short names: ``keep_last``, ``sensor_data``."""

    __members__: Mapping[str, Any]

    @classmethod
    def short_keys(cls) -> list[str]:
        """The short names."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> Any:
        """Return the value with a short name. Raises KeyError."""
        return cls.__members__[name.upper()].value


class QoSPolicyEnum(_ShortKeys, IntEnum):
    """Base of the policies."""


class HistoryPolicy(QoSPolicyEnum):
    """Which messages are kept: the last ones, or all."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether a message that was lost is sent again. Nothing is lost here."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether a late subscription is given the kept messages. For that, both ends have to be reliable."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher shows that it is there. It has no effect here."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

# The fields of a profile: their types and defaults.
_FIELDS: dict[str, tuple[Any, Any]] = {
    "history": (HistoryPolicy, HistoryPolicy.KEEP_LAST),
    "depth": (int, 10),
    "reliability": (ReliabilityPolicy, ReliabilityPolicy.RELIABLE),
    "durability": (DurabilityPolicy, DurabilityPolicy.VOLATILE),
    "lifespan": (Duration, Duration()),
    "deadline": (Duration, Duration()),
    "liveliness": (LivelinessPolicy, LivelinessPolicy.SYSTEM_DEFAULT),
    "liveliness_lease_duration": (Duration, Duration()),
    "avoid_ros_namespace_conventions": (bool, False),
}


class QoSProfile:
    """The policies of a publisher or a subscription, given by keyword: ``depth`` at least, or ``history``.

    ``history``, ``depth``, ``reliability`` and ``durability`` have an effect here. Raises InvalidQoSProfileException if
    neither depth nor history is given, AssertionError for wrong names and types.
    """

    history: HistoryPolicy
    depth: int
    reliability: ReliabilityPolicy
    durability: DurabilityPolicy

    def __init__(self, **kwargs: Any) -> None:
        assert kwargs.keys() <= _FIELDS.keys(), f"Invalid arguments passed to constructor: {kwargs.keys()!r}"
        if "history" not in kwargs and "depth" not in kwargs:
            raise InvalidQoSProfileException("History and/or depth settings are required.")
        if kwargs.get("history") == HistoryPolicy.KEEP_LAST and "depth" not in kwargs:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        for name, (_, default) in _FIELDS.items():
            setattr(self, name, kwargs.get(name, default))

    def __setattr__(self, name: str, value: Any) -> None:
        if name in _FIELDS:
            kind = _FIELDS[name][0]
            assert isinstance(value, (kind, int) if issubclass(kind, IntEnum) else kind)
            if issubclass(kind, IntEnum):
                value = kind(value)
            if name == "depth" and value == 0 and self.history is HistoryPolicy.KEEP_LAST:
                warn(
                    "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. "
                    "This will be interpreted as SYSTEM_DEFAULT",
                )
        super().__setattr__(name, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, QoSProfile) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)}' for name in _FIELDS)})"

    @property
    def kept(self) -> int | None:
        """How many messages are kept; None for all."""
        return None if self.history is HistoryPolicy.KEEP_ALL else max(self.depth, 1)


class Policies(NamedTuple):
    """The policies of an end as they take effect: the middleware (Fast DDS) settles those that are left open.

    A subscription that asks for the best available looks at the publishers that exist when it is made.
    """

    reliable: bool
    transient_local: bool

    @classmethod
    def offered(cls, qos: QoSProfile) -> Policies:
        """Return a publisher's policies."""
        return cls(
            qos.reliability is not ReliabilityPolicy.BEST_EFFORT, qos.durability is not DurabilityPolicy.VOLATILE
        )

    @classmethod
    def requested(cls, qos: QoSProfile, publishers: Sequence[Policies] = ()) -> Policies:
        """Return a subscription's policies."""
        best = cls(*map(all, zip(*publishers, strict=True))) if publishers else cls(True, True)
        return cls(
            qos.reliability is ReliabilityPolicy.RELIABLE
            or (qos.reliability is ReliabilityPolicy.BEST_AVAILABLE and best.reliable),
            qos.durability is DurabilityPolicy.TRANSIENT_LOCAL
            or (qos.durability is DurabilityPolicy.BEST_AVAILABLE and best.transient_local),
        )


def incompatible_policy(offered: Policies, requested: Policies) -> str | None:
    """Return the last policy by which a subscription asks for more than a publisher offers; None: they match."""
    if requested.reliable and not offered.reliable:
        return "RELIABILITY"
    if requested.transient_local and not offered.transient_local:
        return "DURABILITY"
    return None


_BEST_AVAILABLE = Duration(nanoseconds=2**63 - 2)

qos_profile_unknown = QoSProfile(history=3, depth=0, reliability=3, durability=3, liveliness=4)
qos_profile_default = QoSProfile(depth=10)
qos_profile_system_default = QoSProfile(history=0, depth=0, reliability=0, durability=0)
qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_best_available = QoSProfile(
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=_BEST_AVAILABLE,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=_BEST_AVAILABLE,
)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class QoSPresetProfiles(_ShortKeys, Enum):
    """The profiles that ROS has names for."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available
