"""C++ nodes that a test starts, and what faults do to them."""

from __future__ import annotations

import pytest

import rosspin
from rosspin.faults import Crash, Topic
from tests.helpers.tree import ROOT

PACKAGES = {1: "my_robotics_pkg", 2: "my_robotics_pkg_ros2_cpp"}
EVERY = pytest.mark.parametrize("ros", [1, 2])


def node(ros: int, name: str) -> str:
    return str(ROOT / "examples" / PACKAGES[ros] / "src" / f"{name}_cpp_node.cpp")


@EVERY
def test_a_node_in_steps_hears_late(ros: int) -> None:
    with rosspin.start(node(ros, "subscriber"), faults=[Topic("/counter", delay=0.25)]) as started:
        started.publish("/counter", data=5)
        started.advance(0.2)
        assert "counter = 5" not in started.run.console
        started.advance(0.1)
        assert "[SUBSCRIBER CPP NODE] counter = 5" in started.run.console


@EVERY
def test_a_node_in_steps_publishes(ros: int) -> None:
    with rosspin.start(node(ros, "publisher")) as started:
        assert started.messages("/counter") == []
        started.advance(1.1)
        assert [sent.message.data for sent in started.messages("/counter")] == [1, 2]


@EVERY
def test_a_node_crashes(ros: int) -> None:
    pair = [node(ros, "publisher"), node(ros, "subscriber")]
    run = rosspin.simulate(pair, 3.0, faults=[Crash("/publisher_cpp_node", at=1.2)])
    assert [sent.message.data for sent in run.messages if sent.topic == "/counter"] == [1, 2]
    assert "[SUBSCRIBER CPP NODE] counter = 2" in run.console
    assert "[SUBSCRIBER CPP NODE] counter = 3" not in run.console
