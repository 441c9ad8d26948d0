"""Nodes in C++."""

from __future__ import annotations

import re
from collections.abc import Callable

from .language import Language, Program
from .ros import Words

__all__ = ["INCLUDES", "Cpp"]

INCLUDES = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](?:(ros)|rclcpp|rclcpp_components)/', re.MULTILINE)


class Cpp(Language):
    name = "cpp"
    suffixes = (".cpp", ".cc", ".cxx")
    words = {
        1: Words("ros::ok()", "ros::Duration(0.1).sleep()", "ros::spin()"),
        2: Words("rclcpp::ok()", "rclcpp::sleep_for(100ms)", "rclcpp::spin(node)"),
    }

    def recognises(self, text: str) -> bool:
        return bool(INCLUDES.search(text))

    def named_in(self, text: str) -> set[int]:
        return {1 if ros else 2 for ros in INCLUDES.findall(text)}

    def program(
        self, path: str, waiting: Callable[[], object], text: str | None = None, closed: bool = False
    ) -> Program:
        from ...cpp import build, program  # most runs go without

        return program(build(path, waiting, text, closed), path)
