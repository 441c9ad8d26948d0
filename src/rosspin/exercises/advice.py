"""Explain errors to people who are learning rospy or rclpy."""

from __future__ import annotations

import sys
from types import FrameType

from ..clocks.frames import node_frames
from ..rospy.exceptions import ROSInitException

__all__ = ["advice", "lacking"]

# What each module of rospy passes to its callbacks, and what it is to be given.
_PASSED = {
    "timer": "A timer passes its callback one argument, the event: def callback(event), or (self, event) in a class.",
    "topics": "A subscriber passes its callback one argument: def callback(message), or (self, message) in a class.",
    "service": "A service passes its handler one argument: def handle(request), or (self, request) in a class.",
}
_ITSELF = {
    "timer": "Pass a timer the callback itself, without calling it: self.timerCallback, not self.timerCallback().",
    "topics": "Pass a subscriber the callback itself, without calling it: self.callback, not self.callback().",
    "service": "Pass a service the handler itself, without calling it: self.handle, not self.handle().",
}


def advice(error: BaseException) -> str:
    """Advise on an error in a node, in a sentence; an empty text stands for no advice."""
    frame = _innermost(error)
    if frame is None:
        return ""
    module = str(frame.f_globals["__name__"])
    return _on_rclpy(error, module, frame) if ".rclpy." in module else _on_rospy(error, module)


def lacking(error: ModuleNotFoundError) -> str:
    """Say why there is no such module in a page, whose Python has no packages, in a sentence."""
    if (error.name or "").partition(".")[0] in sys.stdlib_module_names:
        return f"Python has no {error.name} in a page."
    return f"This page has stand-ins for rospy and rclpy, and Python's standard library, but no {error.name}."


def _on_rospy(error: BaseException, module: str) -> str:
    if isinstance(error, ROSInitException) and "init_node()" in str(error):
        return 'Call rospy.init_node("a_name") before you use anything else from rospy.'
    if isinstance(error, ZeroDivisionError):
        return "Nothing can have a frequency of 0 Hz or a period of 0 s: give rospy.Rate and rospy.Timer more than 0."
    if isinstance(error, AttributeError) and error.name == "to_sec":
        return "The period of a rospy.Timer is a Duration: rospy.Timer(rospy.Duration(0.5), callback)"
    if isinstance(error, TypeError) and "positional argument" in str(error):
        return _PASSED.get(module.rpartition(".")[2], "")
    if isinstance(error, TypeError) and "not callable" in str(error):
        return _ITSELF.get(module.rpartition(".")[2], "")
    return ""


def _on_rclpy(error: BaseException, module: str, frame: FrameType) -> str:
    from ..rclpy.exceptions import (  # where an error comes from rclpy, it is there
        InvalidParameterTypeException,
        NotInitializedException,
        ParameterNotDeclaredException,
        RCLError,
    )

    if isinstance(error, NotInitializedException) or (isinstance(error, RCLError) and "rcl_init()" in str(error)):
        return "Call rclpy.init() before you make a node, and rclpy.shutdown() only at the end."
    if isinstance(error, AttributeError) and (error.name or "").startswith("_"):
        return 'A class of Node begins its __init__ with super().__init__("a_name").'
    if isinstance(error, ZeroDivisionError):
        return "Nothing can have a frequency of 0 Hz."
    if isinstance(error, ParameterNotDeclaredException):
        return 'Declare a parameter before you read it: self.declare_parameter("frequency", 2.0).'
    if isinstance(error, InvalidParameterTypeException):
        return "A parameter keeps the type with which it was declared. 5 is an integer, 5.0 is not."
    if isinstance(error, RCLError) and "timer period" in str(error):
        return "The period of a timer cannot be negative: give create_timer the seconds from one call to the next."
    if isinstance(error, TypeError) and "float()" in str(error) and frame.f_code.co_name == "create_timer":
        return "The period of a timer comes first and is a number of seconds: create_timer(0.5, self.timer_callback)"
    if isinstance(error, TypeError) and module.endswith(".executors"):
        if "not callable" in str(error):
            return "Pass the callback itself, without calling it: self.timer_callback, not self.timer_callback()."
        if "positional argument" in str(error):
            return "A timer passes its callback no argument: def timer_callback(), or (self) in a class."
    return ""


def _innermost(error: BaseException) -> FrameType | None:
    """Return the frame in which an error was raised, if that was in a stand-in and not in a line of the node."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace.tb_frame if trace and node_frames(trace) is None else None
