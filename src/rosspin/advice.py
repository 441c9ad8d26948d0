"""What someone who learns rospy may want to know of an error, beside its own words."""

from __future__ import annotations

from .frames import node_frames
from .rospy.exceptions import ROSInitException

__all__ = ["advice"]


def advice(error: BaseException) -> str:
    """A sentence on an error that a node has run into; "" if there is nothing to say."""
    if not _ends_in_rospy(error):
        return ""
    if isinstance(error, ROSInitException) and "init_node()" in str(error):
        return 'Call rospy.init_node("a_name") before anything else of rospy.'
    if isinstance(error, ZeroDivisionError):
        return "There is no frequency of 0 Hz and no period of 0 s: give rospy.Rate and rospy.Timer more than 0."
    if isinstance(error, AttributeError) and error.name == "to_sec":
        return "The period of a rospy.Timer is a Duration: rospy.Timer(rospy.Duration(0.5), callback)"
    if isinstance(error, TypeError) and "positional argument" in str(error):
        return "A timer hands its callback one argument, the event: def callback(event), or (self, event) in a class."
    if isinstance(error, TypeError) and "not callable" in str(error):
        return "Give a timer the callback itself, without calling it: self.timerCallback, not self.timerCallback()."
    return ""


def _ends_in_rospy(error: BaseException) -> bool:
    """Whether an error was raised by the stand-in, not by a line of the node."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace is not None and node_frames(trace) is None
