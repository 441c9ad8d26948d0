"""What a BufferClient of tf2_ros gets from a buffer server, whatever that answers."""

import actionlib
import rospy
import tf2_ros
from geometry_msgs.msg import PointStamped
from tf2_msgs.msg import LookupTransformAction, LookupTransformResult

rospy.init_node("node")
asked = []


def serve(goal):
    asked.append(goal)
    result = LookupTransformResult()
    result.transform.header.frame_id = goal.target_frame
    result.transform.child_frame_id = goal.source_frame
    result.transform.header.stamp = goal.source_time
    if goal.source_frame == "late":
        rospy.sleep(1.0)
    if goal.source_frame == "abort":
        server.set_aborted(result)
        return
    if goal.source_frame.isdigit():
        result.error.error = int(goal.source_frame)
        result.error.error_string = f"error {goal.source_frame}"
    server.set_succeeded(result)


def attempt(text):
    begin = rospy.get_time()
    try:
        value = eval(text)
        if hasattr(value, "child_frame_id"):
            value = value.header.frame_id, value.child_frame_id, value.header.stamp.to_sec()
    except Exception as error:
        value = type(error).__mro__[:2], error
    print(text, "->", value, round(2 * (rospy.get_time() - begin)) / 2, flush=True)  # to half a second


client = tf2_ros.BufferClient("tf2_buffer_server", timeout_padding=rospy.Duration(0.5))
attempt("client.wait_for_server(rospy.Duration(0.5))")
attempt("client.lookup_transform('map', 'base', rospy.Time(3), rospy.Duration(0.3))")
attempt("client.can_transform('map', 'base', rospy.Time(3))")
server = actionlib.SimpleActionServer("tf2_buffer_server", LookupTransformAction, serve, False)
server.start()
rospy.sleep(1.0)
attempt("client.wait_for_server()")
attempt("client.lookup_transform('map', 'base', rospy.Time(3), rospy.Duration(0.3))")
attempt("client.lookup_transform(target_frame='map', source_frame='base', time=rospy.Time(3))")
print(asked[-1].timeout, asked[-1].advanced, asked[-2].timeout, asked[-1].fixed_frame == "")
attempt("client.lookup_transform_full('map', rospy.Time(5), 'base', rospy.Time(3), 'odom', rospy.Duration(1))")
print(asked[-1].timeout, asked[-1].advanced, asked[-1].target_time, asked[-1].fixed_frame)
for number in range(8):
    attempt(f"client.lookup_transform('map', '{number}', rospy.Time())")
attempt("client.can_transform('map', '0', rospy.Time()), client.can_transform('map', '3', rospy.Time())")
attempt("client.can_transform_full('map', rospy.Time(), '3', rospy.Time(), 'odom')")
attempt("client.lookup_transform('map', 'abort', rospy.Time())")
attempt("client.lookup_transform('map', 'late', rospy.Time())")
rospy.sleep(1.0)
attempt("client.lookup_transform('map', 'late', rospy.Time(), rospy.Duration(1))")
point = PointStamped()
point.header.frame_id = "base"
tf2_ros.TransformRegistration().add(PointStamped, lambda what, by: (by.header.frame_id, by.child_frame_id))
attempt("client.transform(point, 'map'), client.transform(point, 'map', rospy.Duration(1))")
tf2_ros.BufferClient("other", 10.0)
