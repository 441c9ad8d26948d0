"""What tf2_geometry_msgs makes of messages."""

import random

import rospy
import tf2_geometry_msgs
import tf2_ros
from geometry_msgs.msg import PointStamped, PoseStamped, TransformStamped, Vector3Stamped, WrenchStamped


def show(message):
    """All numbers of a message, or of its parts, rounded; of its header the frame."""
    if hasattr(message, "frame_id"):
        return message.frame_id
    if hasattr(message, "__slots__") and message.__slots__:
        return f"({', '.join(show(getattr(message, name)) for name in message.__slots__)})"
    return f"{round(message, 9) + 0.0:.9g}" if isinstance(message, float) else str(message)


def transform(translation, rotation):
    made = TransformStamped(child_frame_id="base")
    made.header.frame_id = "map"
    for values, part in ((translation, made.transform.translation), (rotation, made.transform.rotation)):
        for name, value in zip("xyzw", values):
            setattr(part, name, value)
    return made


def fill(part, values):
    for name, value in zip("xyzw", values):
        setattr(part, name, value)


draw = random.Random(7)
unit = []
for _ in range(12):
    one = [draw.gauss(0, 1) for _ in range(4)]
    length = sum(part * part for part in one) ** 0.5
    unit.append([part / length for part in one])
half = 0.5**0.5
turns = [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, half, half], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 2.0]]
turns += unit
for number, rotation in enumerate(turns):
    for turn in (turns[0], turns[3], turns[4], unit[number % 12], [-part for part in unit[(5 * number) % 12]]):
        by = transform((1.0, 2.0, 3.0), rotation)
        pose = PoseStamped()
        fill(pose.pose.position, (0.5, -1.0, 2.0))
        fill(pose.pose.orientation, turn)
        print(show(tf2_geometry_msgs.do_transform_pose(pose, by)))
    point, vector, wrench = PointStamped(), Vector3Stamped(), WrenchStamped()
    fill(point.point, (0.5, -1.0, 2.0))
    fill(vector.vector, (0.5, -1.0, 2.0))
    fill(wrench.wrench.force, (0.5, -1.0, 2.0))
    fill(wrench.wrench.torque, (3.0, 0.0, -2.0))
    print(show(tf2_geometry_msgs.do_transform_point(point, by)), point.header.frame_id == "")
    print(show(tf2_geometry_msgs.do_transform_vector3(vector, by)), show(by.transform.translation))
    print(show(tf2_geometry_msgs.do_transform_wrench(wrench, by)), show(by.transform.translation))

print(tf2_geometry_msgs.PointStamped is PointStamped, tf2_geometry_msgs.to_msg_msg(3))
print(tf2_ros.convert(point, Vector3Stamped) is point)
buffer = tf2_ros.BufferCore()
buffer.set_transform_static(transform((1.0, 0.0, 0.0), turns[1]), "me")
both = tf2_ros.BufferInterface()
both.lookup_transform = lambda target, source, time, timeout=None: buffer.lookup_transform_core(target, source, time)
point.header.frame_id = "base"
print(show(both.transform(point, "map")))
pose.header.frame_id = "base"
print(show(both.transform(pose, "map", rospy.Duration(1))))
for what in (TransformStamped(), 3):
    try:
        both.registration.get(type(what))
    except Exception as error:
        print(type(error).__name__)
