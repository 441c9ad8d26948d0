"""On a ROS time that jumps forward: a timer gives two calls, and the rest is lost."""

import rospy
from scenario import begin, block

Time = rospy.Time
set_time = rospy.rostime._set_rostime


def callback(event):
    fields = (event.last_expected, event.last_real, event.current_expected, event.current_real)
    print("tick", *(field and field.to_sec() for field in fields), flush=True)


begin("ros_time_forward")
set_time(Time(100))
rospy.Timer(rospy.Duration(1), callback)
for seconds in (100.5, 101, 101.5, 102.25, 110.5, 111, 111.5, 112):
    block(1)
    print("clock", seconds, flush=True)
    set_time(Time.from_sec(seconds))
block(1)
