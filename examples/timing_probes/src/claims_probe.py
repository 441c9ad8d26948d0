#!/usr/bin/env python3
"""Says what becomes of odd timers, and when, as "said,SECONDS,WHAT".

Parameters: as those of claims_probe.cpp; rospy has no spinOnce.
"""

import time

import rospy


class Claims:
    def __init__(self, kind):
        self.raises = kind == "exception"
        self.start = time.time()
        self.calls = 0

    def say(self, what):
        now = time.time() - self.start
        print("said,%.3f,%s" % (now, what), flush=True)

    def timerCallback(self, event):
        self.calls += 1
        if self.raises and self.calls == 2:
            self.say("callback raises")
            raise ValueError("in a callback")

    def otherCallback(self, event):
        self.say("other timer")


if __name__ == "__main__":
    rospy.init_node("claims_probe")
    kind = rospy.get_param("~kind", "one_shot")
    period = rospy.Duration(rospy.get_param("~period", 0.5))
    claims = Claims(kind)
    rospy.Timer(period, claims.timerCallback, oneshot=kind == "one_shot")
    if kind == "exception":
        rospy.Timer(rospy.Duration(0.4), claims.otherCallback)

    if kind == "rate":
        rate = rospy.Rate(2.0)
        while not rospy.is_shutdown():
            try:
                rate.sleep()
            except rospy.ROSInterruptException:
                break
    else:
        rospy.spin()
    claims.say("calls: %d" % claims.calls)
