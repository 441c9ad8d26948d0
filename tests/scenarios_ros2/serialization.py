"""Messages as bytes and back. What lies between the fields differs on the real one, and is made equal here."""

from action_msgs.msg import GoalInfo
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, Point32, Polygon, PoseWithCovariance, TwistStamped
from rcl_interfaces.msg import Log, ParameterValue
from rclpy.serialization import deserialize_message, serialize_message
from scenario import attempt, say
from sensor_msgs.msg import CompressedImage, Imu, JointState, LaserScan, NavSatStatus, RegionOfInterest
from service_msgs.msg import ServiceEventInfo
from std_msgs.msg import (
    Bool,
    ByteMultiArray,
    ColorRGBA,
    Empty,
    Float32,
    Float64MultiArray,
    Header,
    Int16,
    Int64,
    MultiArrayDimension,
    MultiArrayLayout,
    String,
    UInt8,
    UInt8MultiArray,
)

for message in (
    String(data="abcd"),
    String(data="äß𝄞"),
    Int64(data=-2),
    Float32(data=0.1),
    Time(sec=-1, nanosec=7),
    Point(x=1.5, y=-2.0),
    Header(frame_id="xyz"),
    UInt8MultiArray(data=[1, 2, 3]),
    ByteMultiArray(data=[b"\1", b"\2"]),
    MultiArrayLayout(dim=[MultiArrayDimension(label="abc", size=3, stride=5)], data_offset=6),
):
    data = serialize_message(message)
    say(type(data).__name__, data, deserialize_message(data, type(message)) == message)

for message in (
    *(UInt8(data=3), Bool(data=True), Int16(data=-2), Empty(), Float64MultiArray(data=[1.0, 2.0]), TwistStamped()),
    *(PoseWithCovariance(covariance=[0.5] * 36), ColorRGBA(), GoalInfo(), NavSatStatus(status=-1, service=7)),
    *(RegionOfInterest(width=7, do_rectify=True), Imu(), LaserScan(ranges=[1.0]), JointState(name=["a", "bcd"])),
    *(CompressedImage(format="png", data=b"1234567"), Polygon(points=[Point32(x=1.0)] * 3), Log(level=20, msg="m")),
    *(ParameterValue(bool_array_value=[True, False]), ServiceEventInfo(sequence_number=-7)),
):
    data = serialize_message(message)
    say(type(message).__name__, len(data), data[:4], deserialize_message(data, type(message)) == message)

for text in (
    "serialize(3)",
    "serialize(String)",
    "deserialize(b'', String)",
    "deserialize(b'0123456789', String)",
    "deserialize(b'\\0\\1\\0\\0', String)",
    "deserialize(b'\\0\\1\\0\\0\\5\\0\\0\\0ab', String)",
    "deserialize(b'\\0\\1\\0\\0\\4\\0\\0\\0abcd and more', String)",
    "deserialize(b'\\0\\1\\0\\0\\0\\0\\0\\0', String)",
    "deserialize(b'\\0\\1\\0\\0\\2\\0\\0\\0\\xff\\0', String)",
    "deserialize(b'\\0\\0\\0\\0\\0\\0\\0\\2a\\0', String)",
    "deserialize(b'\\0\\1\\0\\0\\5', Bool)",
    "deserialize(b'\\0\\1\\0\\0', Int64)",
    "deserialize(b'\\0\\1\\0\\0', Empty)",
    "deserialize('abc', String)",
    "deserialize(b'\\0\\1\\0\\0', 3)",
):
    attempt(text, {**globals(), "serialize": serialize_message, "deserialize": deserialize_message})
