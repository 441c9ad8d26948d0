"""The sentences that help with errors, by the page's Python; how a page shows them is in real/page/test_errors.py."""

from __future__ import annotations

import re

import pytest

from tests.helpers.listings_in_page import node, node2
from tests.helpers.page_python import Message, run_job, said

FIRST_LINE = "the first line can be %%simulate SECONDS here"

# A text, the status and the number of errors with which its run ends, and what is said.
CASES = [
    (node("rospy.Rate(0)"), 1, 1, "Nothing can have a frequency of 0 Hz"),
    (node("rospy.Timer(rospy.Duration(0), print)\nrospy.spin()"), 0, 1, "Nothing can have a frequency of 0 Hz"),
    (node("rospy.Timer(0.5, print)\nrospy.spin()"), 0, 1, "rospy.Timer(rospy.Duration(0.5), callback)"),
    ("import rospy\nrospy.Rate(2)\n", 1, 1, 'Call rospy.init_node("a_name") before you use anything else'),
    ("import control_srvs.srv\n", 1, 0, "python -m rosspin run --ros1 FILE"),
    ("import control_srvs.srv\n", 1, 0, "control_srvs is not simulated; run this node on a real ROS"),
    (node("rospy.MasterProxy"), 1, 0, "node.py:4: rospy.MasterProxy is not simulated; run this node on a real ROS"),
    (node2("import rosbag2_py"), 1, 0, "On a computer with ROS 2, run: python -m rosspin run --ros2 FILE"),
    (node2("from control_srvs.srv import Empty"), 1, 0, "control_srvs is not simulated"),
    (node("rospy.Timer(rospy.Duration(0.5), print)"), 0, 0, "never called. Is rospy.spin() missing at its end?"),
    (node2("node.create_timer(0.5, print)"), 0, 0, "Nothing spun the node, so none of its timers"),
    (
        node2("from std_msgs.msg import String\nnode.create_subscription(String, 'text', print, 10)"),
        0,
        0,
        "services called back. Is rclpy.spin(node) missing at its end?",
    ),
    (
        node2("node.create_timer(0.5, lambda event: 1)\nrclpy.spin(node)"),
        1,
        1,
        "A timer passes its callback no argument",
    ),
    (
        node("def callback(event):\n    import cv_bridge\nrospy.Timer(rospy.Duration(1), callback)\nrospy.spin()"),
        1,
        0,
        "node.py:5: cv_bridge is not simulated; run this node on a real ROS",
    ),
    (
        node2(
            "from std_srvs.srv import Empty\nclient = node.create_client(Empty, 'work')\n"
            "node.create_service(Empty, 'work', lambda request, response: response)\n"
            "node.create_timer(0.5, lambda: client.call(Empty.Request()))\nrclpy.spin(node)"
        ),
        130,
        1,
        "the request has come, but the callback group of the service lets one callback run at a time:",
    ),
    ("%%answer 99\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%%answer\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%%answer x\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%%simulate 1.2.3\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%%measure 2\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%% -- a\nimport rospy\n", 1, 0, FIRST_LINE),
    ("%%simulate nan\nimport rospy\n", 1, 0, "seconds must be a number of at least 0, not nan"),
]


@pytest.fixture(scope="module")
def found() -> list[tuple[Message, Message]]:
    return said([run_job(text) for text, *_ in CASES])


@pytest.mark.parametrize("number", range(len(CASES)), ids=lambda number: CASES[number][-1])
def test_errors_end_in_a_sentence_that_helps(found: list[tuple[Message, Message]], number: int) -> None:
    _, status, errors, sentence = CASES[number]
    batch, end = found[number]
    console = "".join(text for _, text, *_ in batch["chunks"])
    assert sentence in console
    assert "rosspin/" not in console
    assert (end["result"]["status"], end["result"].get("errors", 0)) == (status, errors)
    assert any(is_error for is_error, *_ in batch["chunks"])


# What multiprocessing starts if it is not told how differs in a page: see real/page/test_errors.py.
PROCESSES = {
    "multiprocessing.get_context('fork').Process(target=print).start()": r"multiprocessing.Process \(fork\)",
    "multiprocessing.Pool(2)": "multiprocessing.Pool",
    "multiprocessing.Manager()": "multiprocessing.Manager",
    "multiprocessing.Queue()": "multiprocessing.Queue",
    "ProcessPoolExecutor(2).submit(pow, 2, 3)": "ProcessPoolExecutor",
    "subprocess.run(['ls'])": "subprocess",
    "os.fork()": r"os\.fork",
}
WHERE = ["{}", "threading.Thread(target=lambda: {}).start()\nrospy.spin()"]
IMPORTS = "import multiprocessing, os, subprocess, threading; from concurrent.futures import ProcessPoolExecutor\n"


def test_a_process_is_named() -> None:
    """In the same line as in simulated time elsewhere. To import what could start one is no fault."""
    calls = [(where.format(call), name) for where in WHERE for call, name in PROCESSES.items()]
    found = said([run_job(IMPORTS + node(call)) for call, _ in calls])
    for (_, name), (batch, end) in zip(calls, found, strict=True):
        assert re.fullmatch(
            rf"\S+\.py:5: {name} is not simulated; run this node on the wall clock or on a real ROS\n"
            r"On a computer, run: python -m rosspin run FILE\n",
            "".join(text for _, text, *_ in batch["chunks"]),
        )
        assert end["result"]["status"] == 1
