"""The scenarios for ROS 1: their list."""

from __future__ import annotations

from .corpus import LONGEST, Args, Scenario, given, scenarios
from .tree import TESTS

__all__ = ["LENGTHS", "LONGEST", "SCENARIOS", "SCENARIO_LIST", "Scenario"]

SCENARIOS = TESTS / "scenarios"

# Lengths, in periods, around the limits of 1, 2 and 3.
LENGTHS = (0.5, 0.7, 1.3, 1.6, 2.4, 2.7, 3.3, 3.6, 4.4, 5.6)

_ARGS: dict[str, list[Args]] = {
    "timer_blocked_once": given("_block", LENGTHS),
    "timer_blocked_always": given("_block", (0.5, 1.6, 3.5)),
    "rate_blocked": given("_block", LENGTHS, "_pass:=2") + given("_block", (0.5, 1.6, 3.5), "_pass:=0"),
    "ros_time_backward": [("_reset:=false",), ("_reset:=true",)],
    "values_names": [
        (),
        ("__ns:=/mrp", "chatter:=other", "plain"),
        ("__ns:=a/b", "__name:=renamed", "/chatter:=/x/y", "_p:=1", "--flag"),
        ("__ns:=/c", "~a:=b", "bad:=two:=three"),
    ],
    "values_parameters": [
        (
            *("_rate:=10", "_text:=word", "_yes:=true", "_list:=[1, 2.5, a]", "_tree:={a: {b: 1}}"),
            *("_empty:=''", "_float:=1e3", "_quoted:='10'"),
        )
    ],
    "values_bad_parameter": [("_a:={",)],
    "log_levels": [(level,) for level in ("DEBUG", "INFO", "WARN", "ERROR", "FATAL")],
    "exit_status": [("0",), ("3",)],
    "topics_queue_size": [(f"_queue_size:={size}",) for size in (0, 1, 3)],
    "topics_publisher_queue_size": [(f"_queue_size:={size}",) for size in (1, 10, 0)],
    "topics_names_services": [
        (),
        ("services_old:=services_new", "~private:=/elsewhere/services"),
        ("__ns:=/mrp", "services_b:=services_c"),
    ],
    "topics_names": [(), ("old:=new", "~private:=/elsewhere/topics"), ("__ns:=/mrp", "b:=c")],
    "threads_outlive_main_that_exits": [("soft",), ("hard",)],
}

SCENARIO_LIST = scenarios(1, SCENARIOS, _ARGS)
