"""The logging macros of roscpp: there is one for each severity and each way to log."""

from __future__ import annotations

from collections.abc import Iterator

__all__ = ["ros1_macros"]

# What follows the severity in the macro's name: its first parameters, and the condition under which it logs.
_ROS1 = {
    "": ("", "true"),
    "_COND": ("condition, ", "condition"),
    "_ONCE": ("", "ROSSPIN_ONCE"),
    "_THROTTLE": ("period, ", "ROSSPIN_THROTTLE(period, false)"),
    "_DELAYED_THROTTLE": ("period, ", "ROSSPIN_THROTTLE(period, true)"),
}
_SEVERITIES = ("Debug", "Info", "Warn", "Error", "Fatal")


def ros1_macros() -> str:
    """Return the header with ROS_DEBUG, ROS_INFO_STREAM_NAMED, and so on. A name makes no difference to the line."""
    return "\n".join(_ros1()) + "\n"


def _ros1() -> Iterator[str]:
    for severity in _SEVERITIES:
        level = f"::ros::console::levels::{severity}"
        for way, (parameters, condition) in _ROS1.items():
            for stream, values in (("", "..."), ("_STREAM", "values")):
                passed = "__VA_ARGS__" if values == "..." else values
                for named, name in (("", ""), ("_NAMED", "name, ")):
                    macro = f"ROS_{severity.upper()}{stream}{way}{named}({parameters}{name}{values})"
                    yield f"#define {macro} ROSSPIN_LOG{stream}({condition}, {level}, {passed})"
