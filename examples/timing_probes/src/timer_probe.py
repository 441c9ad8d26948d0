#!/usr/bin/env python3
"""Prints every field of every TimerEvent, in the columns of examples/recordings.

Parameters: as those of timer_probe.cpp; a thread for each timer is what rospy always has.
"""

import time

import rospy


class Probe:
    def __init__(self, source, block, block_call, block_calls, blocks):
        self.source = source
        self.block = block
        self.block_call = block_call
        self.block_calls = block_calls
        self.blocks = [float(length) for length in blocks.split(",") if length]
        self.number = 0

    def callback(self, event):
        self.number += 1
        times = (event.last_expected, event.last_real, event.current_expected, event.current_real)
        fields = [self.source, str(self.number)]
        fields += ["" if stamp is None else "%.6f" % stamp.to_sec() for stamp in times]
        fields += ["" if event.last_duration is None else "%.6f" % event.last_duration]
        print(",".join(fields), flush=True)
        since = self.number - self.block_call
        if self.number <= len(self.blocks):
            time.sleep(self.blocks[self.number - 1])
        elif self.block_call == 0 or 0 <= since < self.block_calls:
            time.sleep(self.block)


if __name__ == "__main__":
    rospy.init_node("timer_probe")
    period = rospy.Duration(rospy.get_param("~period", 0.5))
    block, block_call = rospy.get_param("~block", 0.0), rospy.get_param("~block_call", 0)
    block_calls, blocks = rospy.get_param("~block_calls", 1), rospy.get_param("~blocks", "")
    first = Probe("timerCallback", block, block_call, block_calls, blocks)
    second = Probe("secondCallback", 0.0, 0, 1, "")

    print("start,%.6f" % rospy.get_time(), flush=True)
    rospy.Timer(period, first.callback)
    if rospy.get_param("~second_timer", False):
        rospy.Timer(period, second.callback)
    time.sleep(rospy.get_param("~wait", 0.0))
    rospy.spin()
