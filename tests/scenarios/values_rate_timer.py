"""Errors and values of Rate, Timer and sleep, before init_node and after."""

import rospy
from scenario import attempt

BOTH = """
rospy.Rate(2)
rospy.Rate(0)
rospy.Rate(0.0)
rospy.Rate('2')
rospy.Rate(None)
rospy.Rate()
rospy.Time.now()
rospy.get_time()
rospy.is_shutdown()
""".strip().splitlines()

for text in BOTH[1:] + ["rospy.spin()", "rospy.sleep(-1)", "rospy.sleep(0)", "rospy.sleep('a')"]:
    attempt(text)
rospy.init_node("values_rate_timer")
for text in BOTH[1:5] + [
    "rospy.Rate(2).sleep_dur",
    "rospy.Rate(3).sleep_dur",
    "rospy.Rate(0.3).sleep_dur",
    "rospy.Rate(1e12).sleep_dur",
    "rospy.Rate(float('inf')).sleep_dur",
    "rospy.Rate(float('nan')).sleep_dur",
    "rospy.Rate(True).sleep_dur",
    "rospy.Rate(-2).sleep_dur",
    "rospy.Rate(hz=4, reset=True).sleep_dur",
    "isinstance(rospy.Rate(2).sleep_dur, rospy.Duration)",
    "isinstance(rospy.Rate(2).last_time, rospy.Time)",
    "type(rospy.Rate(2).remaining()).__name__",
    "isinstance(rospy.Time.now(), rospy.Time)",
    "isinstance(rospy.get_rostime(), rospy.Time)",
    "type(rospy.get_time()).__name__",
    "rospy.Timer()",
    "rospy.sleep(0)",
    "rospy.sleep(-3)",
    "rospy.sleep(float('nan'))",
    "rospy.sleep(rospy.Time(1))",
    "rospy.timer.TimerEvent()",
    "vars(rospy.timer.TimerEvent(1, 2, 3, 4, 5))",
    "rospy.rostime.wallsleep(-1)",
    "rospy.rostime.wallsleep(0)",
]:
    attempt(text)
