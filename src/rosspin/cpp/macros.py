"""The logging macros of roscpp and of rclcpp: there is one for each severity and each way to log."""

from __future__ import annotations

from collections.abc import Iterator

__all__ = ["ros1_macros", "ros2_macros"]

_SEVERITIES = ("Debug", "Info", "Warn", "Error", "Fatal")

# What follows the severity in the macro's name: its first parameters, and the condition under which it logs.
_ROS1 = {
    "": ("", "true"),
    "_COND": ("condition, ", "condition"),
    "_FILTER": ("filter, ", "(filter)->isEnabled()"),
    "_ONCE": ("", "ROSSPIN_ONCE"),
    "_THROTTLE": ("period, ", "ROSSPIN_THROTTLE(period, false)"),
    "_DELAYED_THROTTLE": ("period, ", "ROSSPIN_THROTTLE(period, true)"),
}
_ROS2 = {
    "": ("", "true"),
    "_ONCE": ("", "ROSSPIN_ONCE"),
    "_EXPRESSION": ("expression, ", "expression"),
    "_FUNCTION": ("function, ", "(*function)()"),
    "_SKIPFIRST": ("", "ROSSPIN_SKIPFIRST"),
    "_THROTTLE": ("clock, duration, ", "ROSSPIN_THROTTLE(clock, duration)"),
    "_SKIPFIRST_THROTTLE": ("clock, duration, ", "ROSSPIN_THROTTLE(clock, duration) && ROSSPIN_SKIPFIRST"),
}


def ros1_macros() -> str:
    """Return the header with ROS_DEBUG, ROS_INFO_STREAM_NAMED, and so on. A name makes no difference to the line."""
    return "\n".join(_ros1()) + "\n"


def ros2_macros() -> str:
    """Return the header with RCLCPP_DEBUG, RCLCPP_INFO_STREAM_THROTTLE, and so on."""
    return "\n".join(_ros2()) + "\n"


def _ros1() -> Iterator[str]:
    for severity in _SEVERITIES:
        level = f"::ros::console::levels::{severity}"
        for way, (parameters, condition) in _ROS1.items():
            for stream, values in (("", "..."), ("_STREAM", "values")):
                passed = "__VA_ARGS__" if values == "..." else values
                for named, name in (("", ""), ("_NAMED", "name, ")):
                    macro = f"ROS_{severity.upper()}{stream}{way}{named}({parameters}{name}{values})"
                    yield f"#define {macro} ROSSPIN_LOG{stream}({condition}, {level}, {passed})"


def _ros2() -> Iterator[str]:
    for severity in _SEVERITIES:
        level = f"RCUTILS_LOG_SEVERITY_{severity.upper()}"
        for way, (parameters, condition) in _ROS2.items():
            for stream, values in (("", "..."), ("_STREAM", "values")):
                passed = "__VA_ARGS__" if values == "..." else values
                macro = f"RCLCPP_{severity.upper()}{stream}{way}(logger, {parameters}{values})"
                yield f"#define {macro} ROSSPIN_LOG{stream}({condition}, {level}, logger, {passed})"
