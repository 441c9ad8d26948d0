"""Two Rate loops in two threads: each keeps a period of its own; one of them is blocked once."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark


def loop(name, hz, periods):
    rate = rospy.Rate(hz)
    number = 0
    while not rospy.is_shutdown():
        number += 1
        mark(name)
        if number == 2:
            block(periods)
        rate.sleep()


begin("threads_two_rates")
threading.Thread(target=loop, args=("quick", 1 / P, 1.6)).start()
threading.Thread(target=loop, args=("slow", 0.6 / P, 0.5)).start()
end_after(7.2)
