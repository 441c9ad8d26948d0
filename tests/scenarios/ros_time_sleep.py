"""On a ROS time that is told: sleep cuts seconds to whole nanoseconds, and none reaches back to before 0."""

import threading

import rospy
from scenario import begin, block

Time = rospy.Time
set_time = rospy.rostime._set_rostime


def tell():
    for time in (Time(4, 299_999_998), Time(4, 299_999_999), Time(4, 300_000_000)):
        block(1)
        set_time(time)


begin("ros_time_sleep")
set_time(Time(2))
for seconds in (0, -1, -2, -2.5, rospy.Duration(-3)):
    try:
        rospy.sleep(seconds)
        print("slept", seconds, flush=True)
    except TypeError as error:
        print(seconds, error, flush=True)
for seconds in (2.3, rospy.Duration(2, 299_999_999), rospy.Duration(2.3)):
    set_time(Time(2))
    threading.Thread(target=tell).start()
    rospy.sleep(seconds)
    print("slept", seconds, rospy.Time.now(), flush=True)
    block(3)
