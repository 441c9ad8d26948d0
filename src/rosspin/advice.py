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
    caller = _innermost(error)
    if isinstance(error, TypeError) and caller.endswith(".topics"):
        if "positional argument" in str(error):
            return (
                "A subscriber passes its callback one argument: def callback(message), or (self, message) in a class."
            )
        if "not callable" in str(error):
            return "Pass a subscriber the callback itself, without calling it: self.callback, not self.callback()."
    if isinstance(error, TypeError) and "positional argument" in str(error):
        return "A timer passes its callback one argument, the event: def callback(event), or (self, event) in a class."
    if isinstance(error, TypeError) and "not callable" in str(error):
        return "Pass a timer the callback itself, without calling it: self.timerCallback, not self.timerCallback()."
    return ""


def _innermost(error: BaseException) -> str:
    """The module in which an error was raised."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return str(trace.tb_frame.f_globals.get("__name__", "")) if trace else ""


def _ends_in_rospy(error: BaseException) -> bool:
    """Whether an error was raised by the stand-in, not by a line of the node."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace is not None and node_frames(trace) is None
