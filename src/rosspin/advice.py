"""Explain errors to people who are learning rospy."""

from __future__ import annotations

from .frames import node_frames
from .rospy.exceptions import ROSInitException

__all__ = ["advice"]


def advice(error: BaseException) -> str:
    """A sentence of advice on an error in a node; an empty string if there is none."""
    if not _ends_in_rospy(error):
        return ""
    if isinstance(error, ROSInitException) and "init_node()" in str(error):
        return 'Call rospy.init_node("a_name") before you use anything else from rospy.'
    if isinstance(error, ZeroDivisionError):
        return "Nothing can have a frequency of 0 Hz or a period of 0 s: give rospy.Rate and rospy.Timer more than 0."
    if isinstance(error, AttributeError) and error.name == "to_sec":
        return "The period of a rospy.Timer is a Duration: rospy.Timer(rospy.Duration(0.5), callback)"
    if isinstance(error, TypeError) and "positional argument" in str(error):
        return "A timer passes its callback one argument, the event: def callback(event), or (self, event) in a class."
    if isinstance(error, TypeError) and "not callable" in str(error):
        return "Pass a timer the callback itself, without calling it: self.timerCallback, not self.timerCallback()."
    return ""


def _ends_in_rospy(error: BaseException) -> bool:
    """Whether an error was raised by the stand-in, not by a line of the node."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace is not None and node_frames(trace) is None
