"""With disable_signals a node may live in a thread, its timers and the shutdown as well."""

import threading

import rospy
from scenario import P, begin, block, mark, say


def run():
    begin("threads_init_node_in_thread", disable_signals=True)
    rospy.Timer(rospy.Duration(P), lambda event: mark("tick"))
    block(2.5)
    mark("end")
    rospy.signal_shutdown("enough")


thread = threading.Thread(target=run)
thread.start()
thread.join()
say("end", rospy.is_shutdown())
