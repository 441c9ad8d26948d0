"""Packages beside rospy, held to what the real ones have printed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from runtimes import kept

from rosspin import simulate

NODES = sorted((Path(__file__).parent / "beside").glob("*.py"))

# Whether a client has noted its goal before the goal's first status comes is a race.
RACE = re.compile(r".*Got a transition callback on a goal handle that we're not tracking\n")


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_it_prints_what_the_real_one_has_printed(node: Path) -> None:
    console = kept(simulate(node, 90, start=1_700_000_000).console)
    assert RACE.sub("", console) == RACE.sub("", kept(node.with_suffix(".txt").read_text(encoding="utf-8")))


def test_a_client_and_a_server_of_an_action_may_be_two_processes(tmp_path: Path) -> None:
    server, client = tmp_path / "server.py", tmp_path / "client.py"
    server.write_text(
        "import actionlib, rospy\n"
        "from actionlib_tutorials.msg import FibonacciAction, FibonacciResult\n"
        "rospy.init_node('server')\n"
        "def execute(goal):\n"
        "    rospy.sleep(goal.order / 10)\n"
        "    server.set_succeeded(FibonacciResult([0, 1, 1]))\n"
        "server = actionlib.SimpleActionServer('fibonacci', FibonacciAction, execute, False)\n"
        "server.start()\n"
        "rospy.spin()\n"
    )
    client.write_text(
        "import actionlib, rospy\n"
        "from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal\n"
        "rospy.init_node('client')\n"
        "client = actionlib.SimpleActionClient('fibonacci', FibonacciAction)\n"
        "client.wait_for_server()\n"
        "print(client.send_goal_and_wait(FibonacciGoal(order=3)), client.get_result().sequence)\n"
    )
    assert simulate([server, client], 5).console.splitlines()[0] == "3 (0, 1, 1)"
