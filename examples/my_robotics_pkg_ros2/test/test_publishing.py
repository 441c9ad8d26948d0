"""The publisher and the subscriber, in simulated time."""

from pathlib import Path

import pytest
from rosspin import Node, simulate

NODES = Path(__file__).parents[1] / "my_robotics_pkg"
PUBLISHER = NODES / "publisher_py_node.py"
SUBSCRIBER = NODES / "subscriber_py_node.py"


def test_it_publishes_twice_a_second():
    run = simulate(PUBLISHER, 2.0)
    assert [sent.time for sent in run.messages] == pytest.approx([0.5, 1.0, 1.5, 2.0])
    assert [sent.message.data for sent in run.messages] == [1, 2, 3, 4]


def test_the_subscriber_hears_every_number():
    run = simulate([PUBLISHER, SUBSCRIBER], 2.0)
    for counter in (1, 2, 3, 4):
        assert f"[SUBSCRIBER PY NODE] counter = {counter}\n" in run.console


def test_it_hears_nothing_in_another_namespace():
    elsewhere = Node(SUBSCRIBER, ["--ros-args", "-r", "__ns:=/mrp"])
    run = simulate([PUBLISHER, elsewhere], 2.0)
    assert "counter" not in run.console
