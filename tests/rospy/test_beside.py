"""Packages next to rospy, compared with what the real ones have printed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rosspin import NotSimulated, simulate
from tests.helpers.runtimes import kept

NODES = sorted((Path(__file__).parent / "beside").glob("*.py"))

# Whether a client has noted its goal before the goal's first status comes is a race.
RACE = re.compile(r".*Got a transition callback on a goal handle that we're not tracking\n")


@pytest.mark.parametrize("node", NODES, ids=lambda node: node.stem)
def test_it_prints_what_the_real_one_has_printed(node: Path) -> None:
    console = kept(simulate(node, 90, start=1_700_000_000).console)
    assert RACE.sub("", console) == RACE.sub("", kept(node.with_suffix(".txt").read_text(encoding="utf-8")))


PACKAGES = """
import roslib
roslib.load_manifest("my_robot")
import rospkg, rospy
from rospkg import ResourceNotFound
from roslib.packages import get_pkg_dir
print(rospkg.RosPack().get_path("my_robot"), rospkg.RosPack.get_instance().get_path("my_robot"))
print(get_pkg_dir("my_robot"), get_pkg_dir("nothing_of_this", required=False))
for call in (rospkg.RosPack().get_path, get_pkg_dir):
    try:
        call("nothing_of_this")
    except Exception as error:
        print(type(error).__module__, type(error).__name__, str(error).splitlines()[0])
"""


def test_packages_are_found_around_the_node(tmp_path: Path) -> None:
    (tmp_path / "my_robot" / "scripts").mkdir(parents=True)
    (tmp_path / "my_robot" / "package.xml").write_text("<package><name>my_robot</name></package>")
    node = tmp_path / "my_robot" / "scripts" / "node.py"
    node.write_text(PACKAGES)
    for _ in range(2):
        assert simulate(node, 1).console.splitlines() == [
            f"{tmp_path}/my_robot {tmp_path}/my_robot",
            f"{tmp_path}/my_robot None",
            "rospkg.common ResourceNotFound nothing_of_this",
            "roslib.packages InvalidROSPkgException Cannot locate installation of package nothing_of_this",
        ]


@pytest.mark.parametrize(
    ("code", "name"),
    [
        ("rospkg.RosPack().get_depends('a')", "rospkg.RosPack.get_depends"),
        ("rospkg.RosStack()", "rospkg.RosStack"),
        ("rospkg.RosPack().get_path('std_msgs')", "the folder of the package std_msgs"),
        ("import roslib.manifest", "roslib.manifest"),
        ("import roslib.names; roslib.names.resource_name('a', 'b')", r"roslib\.names\.resource_name"),
        ("import rosgraph.network", r"rosgraph\.network"),
        (
            "import rosgraph; rosgraph.Master('a').registerPublisher()",
            r"rosgraph\.Master\.registerPublisher",
        ),
        ("import rosgraph; rosgraph.Master('a', 'http://other:11311/')", "the master http://other:11311/"),
        ("rospy.get_master().unregisterService('a', 'b')", r"rospy\.get_master\(\)\.unregisterService"),
        ("rospy.get_master().target", r"rospy\.get_master\(\)\.target"),
    ],
)
def test_what_packages_have_besides_is_not_simulated(code: str, name: str, tmp_path: Path) -> None:
    (tmp_path / "node.py").write_text(f"import rospy, rospkg\n{code}\n")
    with pytest.raises(NotSimulated, match=f"^{name} is not simulated; run this node on a real ROS"):
        simulate(tmp_path / "node.py", 1)


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
