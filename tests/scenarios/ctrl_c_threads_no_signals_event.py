"""With disable_signals a KeyboardInterrupt ends Event.wait; finally blocks run, and the status tells of it."""

import threading

import rospy
from scenario import begin, mark, say

begin("ctrl_c_threads_no_signals_event", disable_signals=True)
rospy.on_shutdown(lambda: say("hook"))
try:
    threading.Event().wait()
finally:
    mark("finally")
    say("finally")
