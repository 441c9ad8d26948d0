"""What rosidl_runtime_py makes of messages."""

import rclpy  # noqa: F401
from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped, PoseWithCovariance
from rosidl_runtime_py import message_to_csv, message_to_ordereddict, message_to_yaml, set_message_fields
from rosidl_runtime_py.utilities import (
    get_action,
    get_interface,
    get_message,
    get_service,
    is_action,
    is_message,
    is_service,
)
from sensor_msgs.msg import JointState, LaserScan, PointCloud2
from std_msgs.msg import Bool, Header, String


def attempt(call, *args, **more):
    try:
        value = call(*args, **more)
    except Exception as error:
        value = type(error).__name__, str(error)
    print(call.__name__, args[1:] if hasattr(args[0], "get_fields_and_field_types") else args, more, "->", value)


joints = JointState(name=["a", "long name"], position=[1.0, 2.5, 3.0])
joints.header.frame_id = "a frame: with 'marks' and ünïcode"
scan = LaserScan(ranges=[0.5, 1.5, 2.5, 3.5], angle_min=0.25)
cloud = PointCloud2(data=bytes(range(6)))
for message in (joints, scan, cloud, PoseWithCovariance(), String(data=""), Bool(data=True), PoseStamped()):
    for more in ({}, {"truncate_length": 2}, {"no_arr": True}, {"no_str": True}):
        attempt(message_to_ordereddict, message, **more)
        attempt(message_to_csv, message, **more)
        attempt(message_to_yaml, message, **more)
attempt(message_to_yaml, joints, flow_style=True)
pose = PoseStamped()
values = {"header": {"frame_id": "map"}, "pose": {"position": {"x": 1.5}}}
print(set_message_fields(pose, values), pose.header.frame_id, pose.pose.position.x)
header = PoseStamped()
setters = set_message_fields(header, {"header": "auto"}, expand_header_auto=True)
for setter in setters:
    setter(Time(sec=5))
print(len(setters), header.header.stamp.sec)
setters = set_message_fields(header.header, {"stamp": "now"}, expand_time_now=True)
setters[0](Time(sec=6))
print(header.header.stamp.sec)
set_message_fields(joints, {"name": ["x"], "position": [4.0], "velocity": []})
print(joints.name, list(joints.position))
set_message_fields(cloud, {"fields": [{"name": "x", "offset": 4}], "is_dense": True})
print(cloud.fields[0].name, cloud.fields[0].offset, cloud.is_dense)
covariance = PoseWithCovariance()
set_message_fields(covariance, {"covariance": [0.5] * 36})
print(covariance.covariance.tolist()[:2])
attempt(set_message_fields, Header(), {"no_such_field": 1})
attempt(set_message_fields, Header(), {"stamp": 3})
attempt(set_message_fields, Header(), "text")
for name in ("std_msgs/msg/String", "std_msgs/String", "std_srvs/srv/SetBool"):
    attempt(get_message, name)
    attempt(get_interface, name)
attempt(get_service, "std_srvs/SetBool")
attempt(get_service, "std_msgs/msg/String")
attempt(get_action, "test_msgs/action/Fibonacci")
attempt(get_message, "std_msgs/msg/NoSuch")
kinds = String, get_service("std_srvs/srv/SetBool"), get_action("test_msgs/Fibonacci")
print([[bool(test(kind)) for test in (is_message, is_service, is_action)] for kind in kinds])
