"""With disable_signals Ctrl-C is Python's own: a KeyboardInterrupt, which is not caught here."""

import rospy
from scenario import P, begin

begin("ctrl_c_no_signals", disable_signals=True)
rospy.on_shutdown(lambda: print("hook", flush=True))
rospy.sleep(20 * P)
print("never")
