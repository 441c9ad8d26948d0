"""Quality of service: how messages are kept and sent (source: rclpy/qos.py)."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum, EnumType, IntEnum
from typing import Any, NamedTuple

from ..clocks.frames import warn
from .duration import Duration, Held
from .enumerations import PlainCppEnum

__all__ = [
    *("DeadlineBestAvailable", "DurabilityPolicy", "HistoryPolicy", "InvalidQoSProfileException"),
    *("LivelinessLeaseDurationeBestAvailable", "LivelinessPolicy", "QoSCompatibility", "QoSDurabilityPolicy"),
    *("QoSHistoryPolicy", "QoSLivelinessPolicy", "QoSPolicyKind", "QoSPresetProfiles", "QoSProfile"),
    *("QoSReliabilityPolicy", "ReliabilityPolicy", "qos_check_compatible", "qos_policy_name_from_kind"),
    *("qos_profile_action_status_default", "qos_profile_best_available"),
    *("qos_profile_default", "qos_profile_parameter_events", "qos_profile_parameters", "qos_profile_sensor_data"),
    *("qos_profile_services_default", "qos_profile_system_default", "qos_profile_unknown"),
]


class InvalidQoSProfileException(Exception):
    """A profile lacks what it needs."""

    def __init__(self, *args: Any) -> None:
        super().__init__("Invalid QoSProfile", *args)


class QoSPolicyKind(IntEnum):
    """The policies, by number."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return the name of a policy. Raises ValueError for a number that none has."""
    return QoSPolicyKind(policy_kind).name


class _ByShortKey(EnumType):
    """Enumerations whose values have short names."""

    def short_keys(cls) -> list[str]:
        """Return the short names of all values."""
        return [name.lower() for name in cls.__members__]

    def get_from_short_key(cls, name: str) -> Any:
        """Return the value with a short name, in whatever case. Raises KeyError if there is none."""
        return cls[name.upper()].value


class QoSPolicyEnum(IntEnum, metaclass=_ByShortKey):
    """Base of the policies."""

    @property
    def short_key(self) -> str:
        """Its short name."""
        return self.name.lower()


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
    """Whether a late subscription is given the kept messages. For that, both endpoints have to be reliable."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher shows that it is there: by its process, or by publishing and ``assert_liveliness()``."""

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


class rmw_qos_profile_t:
    """A profile as rclpy's C++ module has it, of which ``to_dict()`` can make another one."""

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    def to_dict(self) -> dict[str, Any]:
        """What QoSProfile takes."""
        return dict(self._fields)

    @staticmethod
    def predefined(name: str) -> rmw_qos_profile_t:
        """One of those that have names, as in qos_profile_default. Raises ValueError."""
        if name not in __all__ or not name.startswith("qos_profile_"):
            raise ValueError(f"Requested unknown rmw_qos_profile: {name}")
        profile: QoSProfile = globals()[name]
        return profile.get_c_qos_profile()


class QoSProfile(Held):
    """The policies of a publisher or a subscription, given by keyword: ``depth`` at least, or ``history``.

    A length of 0 has no end. Raises InvalidQoSProfileException if neither depth nor history is given, AssertionError
    for wrong names and types.
    """

    history: HistoryPolicy
    depth: int
    reliability: ReliabilityPolicy
    durability: DurabilityPolicy
    lifespan: Duration
    deadline: Duration
    liveliness: LivelinessPolicy
    liveliness_lease_duration: Duration

    _rosspin_held = "rcl_duration_t"

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
        elif type(self) is QoSProfile:  # which has slots in rclpy
            raise AttributeError(f"'QoSProfile' object has no attribute {name!r}")
        super().__setattr__(name, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, QoSProfile) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)}' for name in _FIELDS)})"

    def get_c_qos_profile(self) -> rmw_qos_profile_t:
        """The profile as rclpy's C++ module has it."""
        return rmw_qos_profile_t({name: getattr(self, name) for name in _FIELDS})

    @property
    def _rosspin_kept(self) -> int | None:
        """How many messages are kept; None for all."""
        return None if self.history is HistoryPolicy.KEEP_ALL else max(self.depth, 1)


DeadlineBestAvailable = Duration(nanoseconds=2**63 - 2)
LivelinessLeaseDurationeBestAvailable = Duration(nanoseconds=2**63 - 2)

FOR_EVER = 2**63 - 1  # ns


def length(duration: Duration, best: int = FOR_EVER) -> int:
    """Return a policy's length in ns; ``best`` is the best available."""
    return best if duration == DeadlineBestAvailable else duration.nanoseconds or FOR_EVER


class Policies(NamedTuple):
    """The policies of an endpoint as they take effect: the middleware (Fast DDS) settles those that are left open.

    An endpoint that asks for the best available looks at the others that exist when it is made. ``deadline`` and
    ``lease`` are in ns; ``manual`` is liveliness by topic.
    """

    reliable: bool
    transient_local: bool
    deadline: int
    manual: bool
    lease: int

    @property
    def with_kept(self) -> bool:
        """Whether it sends, or asks for, the messages that were kept."""
        return self.reliable and self.transient_local

    @classmethod
    def offered(cls, qos: QoSProfile, subscriptions: Sequence[Policies] = ()) -> Policies:
        """Return a publisher's policies."""
        return cls(
            qos.reliability is not ReliabilityPolicy.BEST_EFFORT,
            qos.durability is not DurabilityPolicy.VOLATILE,
            length(qos.deadline, min((each.deadline for each in subscriptions), default=FOR_EVER)),
            qos.liveliness is LivelinessPolicy.MANUAL_BY_TOPIC
            or (qos.liveliness is LivelinessPolicy.BEST_AVAILABLE and any(each.manual for each in subscriptions)),
            length(qos.liveliness_lease_duration, min((each.lease for each in subscriptions), default=FOR_EVER)),
        )

    @classmethod
    def requested(cls, qos: QoSProfile, publishers: Sequence[Policies] = ()) -> Policies:
        """Return a subscription's policies."""
        return cls(
            qos.reliability is ReliabilityPolicy.RELIABLE
            or (qos.reliability is ReliabilityPolicy.BEST_AVAILABLE and all(each.reliable for each in publishers)),
            qos.durability is DurabilityPolicy.TRANSIENT_LOCAL
            or (qos.durability is DurabilityPolicy.BEST_AVAILABLE and all(each.transient_local for each in publishers)),
            length(qos.deadline, max((each.deadline for each in publishers), default=FOR_EVER)),
            qos.liveliness is LivelinessPolicy.MANUAL_BY_TOPIC
            or (qos.liveliness is LivelinessPolicy.BEST_AVAILABLE and all(each.manual for each in publishers)),
            length(qos.liveliness_lease_duration, max((each.lease for each in publishers), default=FOR_EVER)),
        )


def incompatible_policy(offered: Policies, requested: Policies) -> QoSPolicyKind | None:
    """Return the last policy by which a subscription asks for more than a publisher offers; None: they match."""
    if requested.reliable and not offered.reliable:
        return QoSPolicyKind.RELIABILITY
    if (requested.manual and not offered.manual) or requested.lease < offered.lease:
        return QoSPolicyKind.LIVELINESS
    if requested.deadline < offered.deadline:
        return QoSPolicyKind.DEADLINE
    if requested.transient_local and not offered.transient_local:
        return QoSPolicyKind.DURABILITY
    return None


class QoSCompatibility(PlainCppEnum):
    """Whether a publisher and a subscription match; WARNING: that depends on the middleware."""

    OK = 0
    WARNING = 1
    ERROR = 2


# For each policy with values, the weak one and the strong one; what is said if a publisher offers the weak and a
# subscription requests the strong, if the former is left open, and if the latter is.
_CHECKS = (
    (
        *("reliability", ReliabilityPolicy.BEST_EFFORT, ReliabilityPolicy.RELIABLE),
        "Best effort publisher and reliable subscription",
        "Reliable subscription, but publisher is {}",
        "Best effort publisher, but subscription is {}",
    ),
    (
        *("durability", DurabilityPolicy.VOLATILE, DurabilityPolicy.TRANSIENT_LOCAL),
        "Volatile publisher and transient local subscription",
        "Transient local subscription, but publisher is {}",
        "Volatile publisher, but subscription is {}",
    ),
    (
        *("liveliness", LivelinessPolicy.AUTOMATIC, LivelinessPolicy.MANUAL_BY_TOPIC),
        "Publisher's liveliness is automatic and subscription's is manual by topic",
        "Subscription's liveliness is manual by topic, but publisher's is {}",
        "Publisher's liveliness is automatic, but subscription's is {}",
    ),
)


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return whether two profiles match, and the reasons why not (source: rmw_dds_common/qos.cpp)."""
    errors, warnings = [], []
    for name, weak, strong, both, publisher_open, subscription_open in _CHECKS:
        offered, requested = getattr(publisher_qos, name), getattr(subscription_qos, name)
        first, second = offered.short_key, requested.short_key
        if name == "liveliness":
            errors += _too_short("deadline", publisher_qos.deadline, subscription_qos.deadline)
        if (offered, requested) == (weak, strong):
            errors.append(both)
        elif {first, second} <= {"system_default", "unknown"}:
            misspelt = name.replace("durability", "durabilty")  # as in ROS
            warnings.append(f"Publisher {misspelt} is {first} and subscription {name} is {second}")
        elif first in ("system_default", "unknown") and requested is strong:
            warnings.append(publisher_open.format(first))
        elif second in ("system_default", "unknown") and offered is weak:
            warnings.append(subscription_open.format(second))
    leases = publisher_qos.liveliness_lease_duration, subscription_qos.liveliness_lease_duration
    errors += _too_short("liveliness lease duration", *leases)
    for kind, reasons in (QoSCompatibility.ERROR, errors), (QoSCompatibility.WARNING, warnings):
        if reasons:
            return kind, "".join(f"{kind.name}: {reason};" for reason in reasons)
    return QoSCompatibility.OK, ""


def _too_short(what: str, offered: Duration, requested: Duration) -> list[str]:
    """Say so if a subscription does not match by a length."""
    if requested.nanoseconds and not offered.nanoseconds:
        return [f"Subscription has a {what}, but publisher does not"]
    if requested.nanoseconds and requested < offered:
        return [f"Subscription {what} is less than publisher" + " deadline" * (what == "deadline")]
    return []


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
    deadline=DeadlineBestAvailable,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
    liveliness_lease_duration=LivelinessLeaseDurationeBestAvailable,
)
qos_profile_action_status_default = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class QoSPresetProfiles(Enum, metaclass=_ByShortKey):
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
