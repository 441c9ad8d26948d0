"""At the end: first the threads, then what was registered with atexit, the last one first, rospy's hooks among it."""

import atexit
import threading

import rospy
from scenario import begin, block, mark, say

begin("threads_atexit")
rospy.on_shutdown(lambda: say("hook", rospy.is_shutdown()))
atexit.register(lambda: say("registered first", rospy.is_shutdown()))
atexit.register(lambda: mark("at_exit"))
threading.Thread(target=lambda: block(2)).start()
say("main ends")
