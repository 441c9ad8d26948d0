"""The nodes that publish and listen, in simulated time."""

from pathlib import Path

import pytest
from rosspin import simulate

NODES = Path(__file__).parents[1] / "my_robotics_pkg"
PUBLISHER, SUBSCRIBER = NODES / "publisher_py_node.py", NODES / "subscriber_py_node.py"


def test_it_publishes_twice_a_second():
    run = simulate(PUBLISHER, 2.0)
    assert [sent.time for sent in run.messages] == pytest.approx([0.5, 1.0, 1.5, 2.0])
    assert [(sent.topic, sent.message.data) for sent in run.messages][-1] == ("/counter", 4)


@pytest.mark.parametrize("nodes", [[PUBLISHER, SUBSCRIBER], NODES / "both_py_nodes.py"], ids=["two", "one"])
def test_every_number_is_heard(nodes):
    run = simulate(nodes, 2.0)
    heard = [line.rpartition(" ")[2] for line in run.console.splitlines() if "SUBSCRIBER PY NODE] counter" in line]
    assert heard == ["1", "2", "3", "4"]


def test_they_end_at_ctrl_c():
    assert simulate(NODES / "both_py_nodes.py", 1.0).status == 0
