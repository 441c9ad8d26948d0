"""On a ROS time that is told: Rate raises when it goes back, sleep when the node shuts down, and 0 means not yet."""

import rospy
from scenario import begin, block

Time = rospy.Time
set_time = rospy.rostime._set_rostime


def loop(event):
    rate = rospy.Rate(1)
    while True:
        print("pass", rospy.get_time(), flush=True)
        try:
            rate.sleep()
        except rospy.ROSTimeMovedBackwardsException as error:
            print(type(error).__name__, error, error.time, flush=True)
        except rospy.ROSInterruptException as error:
            print(type(error).__name__, error, flush=True)
            return


begin("ros_time_rate")
rospy.Timer(rospy.Duration(0.1), loop, oneshot=True)
block(0.125)
set_time(Time(0))
for seconds in (0, 10, 11, 12.5, 13, 20, 5, 6, 7):
    block(1)
    print("clock", seconds, flush=True)
    set_time(Time.from_sec(seconds))
block(1)
rospy.signal_shutdown("end")
block(2)
