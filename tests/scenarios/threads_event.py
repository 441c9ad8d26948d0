"""Event.wait with and without a timeout, set, clear and is_set."""

import threading

import rospy
from scenario import P, begin, mark, say

event = threading.Event()
begin("threads_event")
rospy.Timer(rospy.Duration(2 * P), lambda _: event.set())
say("too short", event.wait(P), event.is_set())
mark("too_short")
say("set", event.wait(5 * P), event.is_set())
mark("set")
say("still set", event.wait(), event.wait(0))
event.clear()
say("cleared", event.is_set(), event.wait(0))
say("set again", event.wait())
mark("set_again")
