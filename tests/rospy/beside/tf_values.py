"""What a tf listener hears, and makes of messages."""

import math

import rospy
import tf
from geometry_msgs.msg import (
    Point,
    PointStamped,
    Pose,
    PoseStamped,
    Quaternion,
    QuaternionStamped,
    Vector3,
    Vector3Stamped,
)
from sensor_msgs.msg import PointCloud
from std_msgs.msg import Header
from tf.transformations import quaternion_from_euler

rospy.init_node("node")


def say(*words):
    print(*words, flush=True)


def attempt(text):
    try:
        value = eval(text)
    except Exception as error:
        value = type(error).__name__, str(error)
    say(text, "->", value)


def numbers(message):
    return [float(round(getattr(message, name), 9)) + 0.0 for name in message.__slots__]


broadcaster, listener = tf.TransformBroadcaster(), tf.TransformListener()
rospy.sleep(1)
attempt("listener.lookupTransform('map', 'base', rospy.Time(0))")
attempt("listener.waitForTransform('map', 'base', rospy.Time(0), rospy.Duration(0.1))")
attempt("listener.frameExists('base'), listener.getFrameStrings()")
for at in (5, 6):
    turn = quaternion_from_euler(0, 0, math.pi / 2 * (at - 5))
    broadcaster.sendTransform((at, 2, 3), turn, rospy.Time(at), "base", "map")
broadcaster.sendTransform([0, 0, 1], (0, 0, 0, 1), rospy.Time(5), "laser", "base")
rospy.sleep(1)
attempt("listener.waitForTransform('/map', '/base', rospy.Time(0), rospy.Duration(1))")
attempt("listener.lookupTransform('/map', 'base', rospy.Time(5))")
attempt("listener.lookupTransform('map', 'laser', rospy.Time(9))")
attempt("listener.lookupTransformFull('base', rospy.Time(5), 'base', rospy.Time(6), 'map')")
attempt("listener.canTransform('map', 'base', rospy.Time(5)), listener.canTransform('map', 'x', rospy.Time(5))")
attempt("listener.canTransformFull('base', rospy.Time(5), 'base', rospy.Time(6), 'map')")
attempt("listener.getLatestCommonTime('map', '/base')")
attempt("listener.frameExists('base'), listener.frameExists('map'), listener.getFrameStrings()")
attempt("listener.allFramesAsString()")
attempt("listener.getTFPrefix()")
attempt("tf.Transformer().waitForTransform('map', 'base', rospy.Time(0), rospy.Duration(0.1))")
attempt("isinstance(listener, tf.TransformerROS), isinstance(tf.TransformerROS(), tf.Transformer)")
header = Header(stamp=rospy.Time(6), frame_id="base")
say(numbers(listener.transformPoint("map", PointStamped(header, Point(1, 0, 0))).point))
say(numbers(listener.transformVector3("map", Vector3Stamped(header, Vector3(1, 0, 0))).vector))
say(numbers(listener.transformQuaternion("map", QuaternionStamped(header, Quaternion(0, 0, 0, 1))).quaternion))
pose = listener.transformPose("map", PoseStamped(header, Pose(Point(1, 0, 0), Quaternion(0, 0, 0, 1))))
say(numbers(pose.pose.position), numbers(pose.pose.orientation), pose.header.frame_id, pose.header.stamp)
cloud = listener.transformPointCloud("map", PointCloud(header=header, points=[Point(1, 0, 0), Point(0, 1, 0)]))
say([numbers(point) for point in cloud.points], cloud.header.frame_id)
say(listener.asMatrix("map", header).round(9) + 0.0)
attempt("listener.transformPoint('nowhere', PointStamped(header, Point(1, 0, 0)))")
attempt("[issubclass(each, tf.Exception) for each in (tf.LookupException, tf.ExtrapolationException)]")
own = tf.Transformer(True, rospy.Duration(10))
own.setTransform(listener._buffer.lookup_transform("map", "base", rospy.Time(6)))
attempt("own.lookupTransform('map', 'base', rospy.Time(6))[0]")
own.clear()
attempt("own.canTransform('map', 'base', rospy.Time(0))")
