"""What tf2_geometry_msgs makes of messages."""

import random

import tf2_geometry_msgs
import tf2_ros
from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    Vector3Stamped,
)
from rclpy.duration import Duration


def show(message):
    """All numbers of a message, or of its parts, rounded; of its header the frame."""
    if hasattr(message, "frame_id"):
        return message.frame_id
    if hasattr(message, "get_fields_and_field_types"):
        return f"({', '.join(show(getattr(message, name)) for name in message.get_fields_and_field_types())})"
    if hasattr(message, "__len__"):
        return ", ".join(map(show, message))
    return f"{round(float(message), 6) + 0.0:.9g}"


def fill(part, values):
    for name, value in zip("xyzw", values):
        setattr(part, name, value)


def transform(translation, rotation):
    made = TransformStamped(child_frame_id="base")
    made.header.frame_id = "map"
    fill(made.transform.translation, translation)
    fill(made.transform.rotation, rotation)
    return made


draw = random.Random(7)
unit = []
for _ in range(12):
    one = [draw.gauss(0, 1) for _ in range(4)]
    length = sum(part * part for part in one) ** 0.5
    unit.append([part / length for part in one])
half = 0.5**0.5
turns = [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, half, half], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 2.0], *unit]
covariance = [draw.gauss(0, 1) for _ in range(36)]
for number, rotation in enumerate(turns):
    for turn in (turns[0], turns[2], turns[3], unit[number % 12], [-part for part in unit[(5 * number) % 12]]):
        by = transform((1.0, 2.0, 3.0), rotation)
        pose, wide = PoseStamped(), PoseWithCovarianceStamped()
        fill(pose.pose.position, (0.5, -1.0, 2.0))
        fill(pose.pose.orientation, turn)
        print(show(tf2_geometry_msgs.do_transform_pose_stamped(pose, by)))
    wide.pose.pose = pose.pose
    wide.pose.covariance = covariance
    print(show(tf2_geometry_msgs.do_transform_pose(pose.pose, by)))
    print(show(tf2_geometry_msgs.do_transform_pose_with_covariance_stamped(wide, by)))
    point, vector, polygon = PointStamped(), Vector3Stamped(), PolygonStamped()
    fill(point.point, (0.5, -1.0, 2.0))
    fill(vector.vector, (0.5, -1.0, 2.0))
    polygon.polygon.points = [Point32(x=0.5, y=-1.0, z=2.0), Point32()]
    print(show(tf2_geometry_msgs.do_transform_polygon_stamped(polygon, by)))
    print(show(tf2_geometry_msgs.do_transform_point(point, by)), point.header.frame_id == "")
    print(show(tf2_geometry_msgs.do_transform_vector3(vector, by)), show(by.transform.translation))

print(tf2_geometry_msgs.PointStamped is PointStamped, tf2_geometry_msgs.to_msg_msg(3))
print(tf2_ros.convert(point, Vector3Stamped) is point)
buffer = tf2_ros.BufferInterface()
buffer.lookup_transform = lambda target, source, time, timeout=None: transform((1.0, 0.0, 0.0), turns[1])
for each in (point, vector, pose, wide, polygon):
    print(show(buffer.transform(each, "map", Duration(seconds=1.0))))
for what in (TransformStamped(), 3):
    try:
        buffer.registration.get(type(what))
    except Exception as error:
        print(type(error).__name__)
