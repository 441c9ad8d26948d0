#!/usr/bin/env python3
"""Prints when each pass of a rospy.Rate loop begins, in the columns of examples/recordings.

Parameters: as those of rate_probe.cpp.
"""

import time

import rospy

if __name__ == "__main__":
    rospy.init_node("rate_probe")
    period = rospy.get_param("~period", 0.5)
    block = rospy.get_param("~block", 0.0)
    block_call = rospy.get_param("~block_call", 0)
    last = ["", "", ""]

    rate = rospy.Rate(1.0 / period)
    start = rate.last_time.to_sec()  # its grid begins when it was made
    print("start,%.6f" % start, flush=True)
    number = 0
    while not rospy.is_shutdown():
        number += 1
        real = rospy.get_time()
        now = ["%.6f" % (start + (number - 1) * period), "%.6f" % real]
        print(",".join(["Rate", str(number), *last[:2], *now, last[2]]), flush=True)
        if block_call in (0, number):
            time.sleep(block)
        last = [*now, "%.6f" % (rospy.get_time() - real)]
        rate.sleep()
