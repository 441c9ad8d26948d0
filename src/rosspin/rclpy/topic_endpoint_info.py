"""What is known of an endpoint of a topic (source: rclpy/topic_endpoint_info.py)."""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from typing import Any

from .duration import Duration, Infinite
from .qos import (
    DurabilityPolicy,
    LivelinessPolicy,
    QoSHistoryPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
)
from .type_hash import TypeHash, hash_of

__all__ = ["TopicEndpointInfo", "TopicEndpointTypeEnum"]


class TopicEndpointTypeEnum(IntEnum):
    """Which endpoint of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """Whose endpoint it is, of which type, with which QoS.

    Raises AssertionError for other names, and for values of other types.
    """

    __slots__ = [
        "_endpoint_gid",
        "_endpoint_type",
        "_node_name",
        "_node_namespace",
        "_qos_profile",
        "_topic_type",
        "_topic_type_hash",
    ]

    def __init__(self, **kwargs: Any) -> None:
        assert all(f"_{name}" in self.__slots__ for name in kwargs), (
            f"Invalid arguments passed to constructor: {kwargs.keys()!r}"
        )
        self.node_name = kwargs.get("node_name", "")
        self.node_namespace = kwargs.get("node_namespace", "")
        self.topic_type = kwargs.get("topic_type", "")
        self.topic_type_hash = kwargs.get("topic_type_hash", TypeHash())
        self.endpoint_type = kwargs.get("endpoint_type", TopicEndpointTypeEnum.INVALID)
        self.endpoint_gid = kwargs.get("endpoint_gid", [])
        self.qos_profile = kwargs.get("qos_profile", QoSPresetProfiles.UNKNOWN.value)

    @property
    def node_name(self) -> str:
        """The name of its node."""
        return self._node_name

    @node_name.setter
    def node_name(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_name = value

    @property
    def node_namespace(self) -> str:
        """The namespace of its node."""
        return self._node_namespace

    @node_namespace.setter
    def node_namespace(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_namespace = value

    @property
    def topic_type(self) -> str:
        """The type, as in std_msgs/msg/String."""
        return self._topic_type

    @topic_type.setter
    def topic_type(self, value: str) -> None:
        assert isinstance(value, str)
        self._topic_type = value

    @property
    def topic_type_hash(self) -> TypeHash:
        """The hash of the type; it may be set as a dictionary."""
        return self._topic_type_hash

    @topic_type_hash.setter
    def topic_type_hash(self, value: Any) -> None:
        assert isinstance(value, (TypeHash, dict))
        self._topic_type_hash = TypeHash(**value) if isinstance(value, dict) else value

    @property
    def endpoint_type(self) -> TopicEndpointTypeEnum:
        """Which endpoint; it may be set as a number."""
        return self._endpoint_type

    @endpoint_type.setter
    def endpoint_type(self, value: Any) -> None:
        assert isinstance(value, int)
        self._endpoint_type = TopicEndpointTypeEnum(value)

    @property
    def endpoint_gid(self) -> Sequence[int]:
        """What tells it from all others."""
        return self._endpoint_gid

    @endpoint_gid.setter
    def endpoint_gid(self, value: Sequence[int]) -> None:
        assert all(isinstance(each, int) for each in value)
        self._endpoint_gid = value

    @property
    def qos_profile(self) -> QoSProfile:
        """Its QoS; it may be set as a dictionary."""
        return self._qos_profile

    @qos_profile.setter
    def qos_profile(self, value: Any) -> None:
        assert isinstance(value, (QoSProfile, dict))
        self._qos_profile = QoSProfile(**value) if isinstance(value, dict) else value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and all(
            getattr(self, name) == getattr(other, name) for name in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        qos = self.qos_profile
        gid = ".".join(f"{each:02x}" for each in self.endpoint_gid)
        depth = f" ({qos.depth})" if qos.history.value == QoSHistoryPolicy.KEEP_LAST else ""
        return "\n".join(
            (
                f"Node name: {self.node_name}",
                f"Node namespace: {self.node_namespace}",
                f"Topic type: {self.topic_type}",
                f"Topic type hash: {self.topic_type_hash}",
                f"Endpoint type: {self.endpoint_type.name}",
                f"GID: {gid}",
                "QoS profile:",
                f"  Reliability: {qos.reliability.name}",
                f"  History (Depth): {qos.history.name}{depth}",
                f"  Durability: {qos.durability.name}",
                f"  Lifespan: {qos.lifespan}",
                f"  Deadline: {qos.deadline}",
                f"  Liveliness: {qos.liveliness.name}",
                f"  Liveliness lease duration: {qos.liveliness_lease_duration}",
            )
        )


def info_of(endpoint: Any, node: Any, publishes: bool, mangled: bool = False) -> TopicEndpointInfo:
    """Tell of an endpoint of a topic; ``mangled``: its type as DDS names it. DDS does not tell of the history."""
    qos, policies, type_ = endpoint.qos_profile, endpoint.policies, endpoint.entry.type
    if mangled:
        *home, name = type_.split("/")
        type_ = "::".join((*home, "dds_", f"{name}_"))
    return TopicEndpointInfo(
        node_name=node.name,
        node_namespace=node.namespace,
        topic_type=type_,
        topic_type_hash=hash_of(endpoint.msg_type),
        endpoint_type=TopicEndpointTypeEnum.PUBLISHER if publishes else TopicEndpointTypeEnum.SUBSCRIPTION,
        endpoint_gid=list(endpoint.rosspin_gid),
        qos_profile=QoSProfile(
            history=QoSHistoryPolicy.UNKNOWN,
            depth=0,
            reliability=ReliabilityPolicy.RELIABLE if policies.reliable else ReliabilityPolicy.BEST_EFFORT,
            durability=DurabilityPolicy.TRANSIENT_LOCAL if policies.transient_local else DurabilityPolicy.VOLATILE,
            lifespan=_whole(qos.lifespan) if publishes else Infinite,
            deadline=Duration(nanoseconds=policies.deadline),
            liveliness=LivelinessPolicy.MANUAL_BY_TOPIC if policies.manual else LivelinessPolicy.AUTOMATIC,
            liveliness_lease_duration=Duration(nanoseconds=policies.lease),
        ),
    )


def _whole(duration: Duration) -> Duration:
    """A duration of a QoS, of which 0 means that there is no limit."""
    return Infinite if duration == Duration() else duration
