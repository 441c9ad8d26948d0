"""Policies and profiles by their short names, as a node reads them from a parameter."""

from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
)
from scenario import say

for policy in (HistoryPolicy, ReliabilityPolicy, DurabilityPolicy, LivelinessPolicy):
    say(policy.short_keys())
    for key in policy.short_keys():
        say(key, policy.get_from_short_key(key), policy(policy.get_from_short_key(key)).short_key)
say(QoSPresetProfiles.short_keys())
for key in ("sensor_data", "Services_Default", "PARAMETERS"):
    profile = QoSPresetProfiles.get_from_short_key(key)
    say(key, profile.reliability.short_key, profile.durability.short_key, profile.depth)
say(QoSProfile(depth=3, reliability=ReliabilityPolicy.get_from_short_key("best_effort")).reliability.short_key)
for enumeration in (HistoryPolicy, QoSPresetProfiles):
    try:
        enumeration.get_from_short_key("keep_some")
    except KeyError as error:
        say(type(error).__name__, error)
