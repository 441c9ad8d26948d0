"""_thread.interrupt_main is a Ctrl-C of the node's own making, which the main notices when it has slept."""

import _thread
import threading

import rospy
from scenario import P, begin, block, mark, say


def interrupt():
    block(1.5)
    _thread.interrupt_main()


begin("threads_interrupt_main")
rospy.on_shutdown(lambda: mark("hook"))
threading.Thread(target=interrupt).start()
rospy.sleep(3 * P)
say("is_shutdown", rospy.is_shutdown())
