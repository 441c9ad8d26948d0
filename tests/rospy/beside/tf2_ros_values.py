"""What tf2_ros answers, and what it hears."""

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped

rospy.init_node("node")


def transform(parent, child, x, stamp, turn=(0, 0, 0, 1)):
    made = TransformStamped(child_frame_id=child)
    made.header.frame_id = parent
    made.header.stamp = rospy.Time(stamp)
    made.transform.translation.x = x
    rotation = made.transform.rotation
    rotation.x, rotation.y, rotation.z, rotation.w = turn
    return made


def attempt(text, **more):
    try:
        value = eval(text, {**globals(), **more})
        if isinstance(value, TransformStamped):
            value = value.header.frame_id, value.child_frame_id, value.header.stamp, value.transform.translation.x
    except Exception as error:
        value = type(error).__mro__[:2], "" if isinstance(error, tf2_ros.TypeException) else error
    print(text, "->", value, flush=True)


buffer = tf2_ros.Buffer(rospy.Duration(5))
for at in range(1, 9):
    buffer.set_transform(transform("map", "base", 2.0 * at, at), "me")
buffer.set_transform_static(transform("base", "laser", 1.0, 0, (0, 0, 1, 0)), "me")
attempt("buffer.lookup_transform('map', 'laser', rospy.Time(4.5))")
attempt("buffer.lookup_transform('laser', 'map', rospy.Time(0))")
attempt("buffer.lookup_transform('map', 'base', rospy.Time(2))")
attempt("buffer.lookup_transform('map', 'base', rospy.Time(9))")
attempt("buffer.lookup_transform('map', 'nowhere', rospy.Time())")
attempt("buffer.lookup_transform_core('', 'map', rospy.Time())")
attempt("buffer.lookup_transform_core('/map', 'base', rospy.Time())")
attempt("buffer.lookup_transform('map', 'base', 4)")
attempt("buffer.lookup_transform('map', 'base', rospy.Duration(4))")
attempt("buffer.lookup_transform('map', 'base')")
attempt("buffer.lookup_transform_full('base', rospy.Time(7), 'base', rospy.Time(5), 'map')")
attempt("buffer.lookup_transform_full('base', rospy.Time(7), 'nowhere', rospy.Time(5), 'map')")
attempt("buffer.can_transform('map', 'base', rospy.Time(4))")
attempt("buffer.can_transform('map', 'nowhere', rospy.Time(), return_debug_tuple=True)")
attempt("buffer.can_transform('nowhere', 'neither', rospy.Time(), return_debug_tuple=True)")
attempt("buffer.can_transform('map', 'base', rospy.Time(10), rospy.Duration(0.1), return_debug_tuple=True)")
attempt("buffer.can_transform_full('a', rospy.Time(), 'b', rospy.Time(), 'c', return_debug_tuple=True)")
attempt("buffer.can_transform_full('map', rospy.Time(5), 'base', rospy.Time(99), 'laser', return_debug_tuple=True)")
attempt("buffer.get_latest_common_time('map', 'laser')")
attempt("buffer.get_latest_common_time('map', 'nowhere')")
attempt("buffer.all_frames_as_string()")
attempt("buffer.all_frames_as_yaml()")
attempt("buffer._frameExists('map'), buffer._getFrameStrings()")
attempt("buffer.transform(transform('map', 'x', 1.0, 5), 'base')")
attempt("tf2_ros.convert(1, str)")
tf2_ros.ConvertRegistration().add_convert((int, str), lambda number: f"number {number}")
attempt("tf2_ros.convert(1, str), tf2_ros.convert([1], list)")
tf2_ros.TransformRegistration().add(
    TransformStamped, lambda what, by: (what.child_frame_id, by.transform.translation.x)
)
attempt("buffer.transform(transform('map', 'x', 1.0, 5), 'base')")
attempt("buffer.transform(transform('map', 'x', 1.0, 5), 'base', rospy.Duration(0.1), tuple)")
attempt("tf2_ros.Stamped(TransformStamped(), rospy.Time(3), 'map').header.frame_id")
buffer.clear()
attempt("buffer.can_transform('map', 'base', rospy.Time()), buffer.can_transform('base', 'laser', rospy.Time())")
attempt("tf2_ros.BufferInterface().lookup_transform('a', 'b', rospy.Time())")

heard = tf2_ros.Buffer()
listener = tf2_ros.TransformListener(heard)
moving, fixed = tf2_ros.TransformBroadcaster(), tf2_ros.StaticTransformBroadcaster()
rospy.sleep(1)
moving.sendTransform(transform("map", "base", 3.0, 5))
moving.sendTransform([transform("map", "arm", 3.0, 5), transform("arm", "hand", 3.0, 5)])
fixed.sendTransform(transform("world", "map", 4.0, 0))
fixed.sendTransform([transform("world", "door", 5.0, 0)])
rospy.sleep(1)
attempt("heard.lookup_transform('world', 'base', rospy.Time())")
attempt("heard.lookup_transform('door', 'hand', rospy.Time())")
print(heard.all_frames_as_yaml())
late = tf2_ros.Buffer()
another = tf2_ros.TransformListener(late)
rospy.sleep(1)
attempt("sorted(late._getFrameStrings())")
listener.unregister()
moving.sendTransform(transform("map", "base", 30.0, 6))
rospy.sleep(1)
attempt("heard.lookup_transform('world', 'base', rospy.Time())")
attempt("late.lookup_transform('map', 'base', rospy.Time())")
