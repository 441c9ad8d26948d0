"""Nodes in C++."""

from __future__ import annotations

import re
from collections.abc import Callable

from .language import Language, Program
from .ros import Words

__all__ = ["Cpp"]

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](ros|rclcpp|rclcpp_components)/', re.MULTILINE)


class Cpp(Language):
    name = "cpp"
    suffixes = (".cpp", ".cc", ".cxx")
    words = {
        1: Words("ros::ok()", "ros::Duration(0.1).sleep()"),
        2: Words("rclcpp::ok()", "rclcpp::sleep_for(100ms)"),
    }

    def recognises(self, text: str) -> bool:
        return bool(_INCLUDE.search(text))

    def program(self, path: str, waiting: Callable[[], object], text: str | None = None) -> Program:
        from ...cpp import build, program  # most runs go without

        return program(build(path, waiting, text), path)
