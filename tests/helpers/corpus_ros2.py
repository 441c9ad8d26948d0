"""The scenarios for ROS 2: their list."""

from __future__ import annotations

from .corpus import LONGEST, Args, Scenario, given, scenarios
from .tree import TESTS

__all__ = ["LONGEST", "SCENARIOS", "SCENARIO_LIST", "Scenario"]

SCENARIOS = TESTS / "scenarios_ros2"

_ARGS: dict[str, list[Args]] = {
    "timer_blocked_once": given("block", (0.6, 1.4, 1.6, 2.4, 3.6, 4.4)),
    "timer_blocked_always": given("block", (0.5, 1.6, 2.4)),
    "rate_in_thread": given("block", (0.6, 1.4, 2.4, 4.4)),
    "topics_depth": given("depth", (1, 3, 10)),
    "actions_feedback_depth": given("depth", (3, 10)),
    "actions_two_goals": given("reentrant", (0, 1)),
    "actions_result_late": given("timeout", (1, 900)),
    "topics_names": [(), ("--ros-args", "-r", "old:=new", "-r", "~/private:=/elsewhere", "-r", "__ns:=/mrp")],
    "services_names": [(), ("--ros-args", "-r", "old:=new", "-r", "~/private:=/elsewhere", "-r", "__ns:=/mrp")],
    "values_names": [
        (),
        ("--ros-args", "-r", "__ns:=/mrp", "-r", "chatter:=other"),
        ("plain", "--ros-args", "-r", "__node:=renamed", "-r", "/chatter:=/x/y", "--", "--flag"),
        ("--ros-args", "-r", "values_names:__ns:=/a/b", "-r", "other:__node:=another", "--remap", "a:=b"),
    ],
    "values_parameters": [(), ("word", "--ros-args", "-p", "rate:=10.5", "-p", "text:=from the command line")],
    "parameters_overrides": [
        (
            *("--ros-args", "-p", "rate:=10.0", "-p", "whole:=10", "-p", "dynamic:=word", "-p", "text:='10'"),
            *("-p", "list:=[1, 2, 3]", "-p", "flag:=true", "-p", "typed:=yes", "-p", "untyped:=[1.5, 2.5]"),
            *("-p", "ignored:=9", "-p", "another:other:=7", "-p", "parameters_overrides:other:=8"),
        ),
        ("--ros-args", "--param", "rate:=.5", "-p", "a.b:=1", "-p", "list:=[a, b]", "-p", "text:=1e3x"),
    ],
    "log_on_the_command_line": [
        ("--ros-args", "--log-level", "DEBUG"),
        ("--ros-args", "--log-level", "error"),
        ("--ros-args", "--log-level", "free:=debug", "--log-level", "warn"),
        ("--ros-args", "-r", "__ns:=/mrp", "--log-level", "mrp.node:=debug"),
    ],
}

SCENARIO_LIST = scenarios(2, SCENARIOS, _ARGS)
