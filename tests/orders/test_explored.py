"""``@rosspin.explored``: a test that is run in many orders."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import rosspin
import rosspin.rclpy  # with all that it imports: pytester takes away what is imported only in its own runs
from benchmarks.planted_orders import PLANTS
from rosspin import pytest_plugin

pytest_plugins = ["pytester"]
pytestmark = pytest.mark.shares(9)

TEST = """
import pytest, rosspin
runs = []
@rosspin.explored(schedules=30, deep=True{more})
def test_count(start_node, tmp_path):
    runs.append(tmp_path)
    node = start_node("{node}")
    node.advance(0.5)
    assert "count 10\\n" in node.run.console
def test_after():
    assert len(runs) == {count}
    assert len(set(runs)) == 1
"""


@pytest.fixture
def run_tests(pytester: pytest.Pytester) -> Callable[..., pytest.RunResult]:
    """Runs pytest on a text."""

    def run(text: str) -> pytest.RunResult:
        pytester.makepyfile(text)
        options = ("-q", "--disable-plugin-autoload", "-p", "no:cacheprovider")
        return pytester.runpytest_inprocess(*options, plugins=[pytest_plugin])

    return run


def node(folder: Path, mended: bool) -> str:
    return PLANTS["ros1-lost-update"].write(folder, mended)[0]


def test_a_test_of_a_node_that_is_well_is_run_once_for_each_order(run_tests: Any, tmp_path: Path) -> None:
    run_tests(TEST.format(node=node(tmp_path, mended=True), more="", count=30)).assert_outcomes(passed=2)


def test_a_test_that_fails_names_the_order_and_is_run_again_in_it(run_tests: Any, tmp_path: Path) -> None:
    failing = node(tmp_path, mended=False)
    run = run_tests(TEST.format(node=failing, more="", count=0).partition("def test_after")[0])
    run.assert_outcomes(failed=1)
    run.stdout.fnmatch_lines(["*in the shortest order found, which deviates once from the usual one, after * orders*"])
    run.stdout.fnmatch_lines(["*Console of planted_0.py*", "count 9"])
    assert "__exit__" not in str(run.stdout)
    token = str(run.stdout).partition('@rosspin.explored(schedule="')[2].partition('"')[0]
    again = run_tests(TEST.format(node=failing, more=f', schedule="{token}"', count=1))
    again.assert_outcomes(failed=1, passed=1)
    again.stdout.fnmatch_lines([f'*in the order of its schedule; *schedule="{token}"*'])


def test_what_fails_as_the_nodes_end_names_the_order_too(run_tests: Any, tmp_path: Path) -> None:
    path = tmp_path / "ends.py"
    path.write_text("import sys, rospy\nrospy.init_node('ends')\nrospy.spin()\nsys.exit(3)\n")
    run = run_tests(
        f"import rosspin\n@rosspin.explored()\ndef test(start_node):\n    start_node({str(path)!r}).advance(0.1)\n"
    )
    run.assert_outcomes(failed=1)
    run.stdout.fnmatch_lines(['*schedule="1"*'])


@pytest.mark.parametrize("test", ["async def test(start_node):\n    assert 0", "def test(start_node):\n    yield"])
def test_what_pytest_would_not_run_is_refused(test: str) -> None:
    names: dict[str, Any] = {"rosspin": rosspin}
    with pytest.raises(TypeError, match="test is a coroutine or a generator"):
        exec(f"@rosspin.explored()\n{test}", names)


def test_a_schedule_that_does_not_fit_is_an_error(run_tests: Any, tmp_path: Path) -> None:
    run = run_tests(TEST.format(node=node(tmp_path, mended=True), more=', schedule="1d-999.1"', count=1))
    run.assert_outcomes(failed=1, passed=1)
    run.stdout.fnmatch_lines(["*ValueError: the schedule does not fit, from 999.1 on*"])


def test_what_fails_a_test_counts_and_what_skips_it_does_not(run_tests: Any) -> None:
    run = run_tests("""
import pytest, rosspin
@rosspin.explored(schedules=3)
def test_fails(start_node):
    pytest.fail("no")
@rosspin.explored(schedules=3)
def test_skips(start_node):
    pytest.skip("not here")
@rosspin.explored(schedules=3)
@pytest.mark.parametrize("number", [1, 2])
def test_given(number, start_node):
    assert number
@rosspin.explored(schedules=3)
def test_node_fails(start_node):
    def node():
        raise SystemExit(3)
    start_node(node).advance(1)
""")
    run.assert_outcomes(failed=2, skipped=1, passed=2)
    run.stdout.fnmatch_lines(["*in the usual order; to run the test*"])


def test_it_needs_the_fixture() -> None:
    with pytest.raises(TypeError, match="test_nothing has to take the fixture start_node"):

        @rosspin.explored()
        def test_nothing() -> None:
            pass


@pytest.mark.parametrize("folder", ["examples/orders", "examples/orders/ros2"])
def test_the_test_of_the_page_fails_as_the_page_says(folder: str, run_tests: Any) -> None:
    from tests.helpers.tree import ROOT

    text = (ROOT / folder / "test_parts.py").read_text(encoding="utf-8")
    run = run_tests(text.replace('"parts_py_node.py"', repr(str(ROOT / folder / "parts_py_node.py"))))
    run.assert_outcomes(failed=1)
    page = (ROOT / "docs/how-to/find-the-order.rst").read_text(encoding="utf-8")
    token = str(run.stdout).partition('schedule="')[2].partition('"')[0]
    assert f": {token}\n" in page


def test_a_test_of_several_nodes_finds_them_beside_its_file(run_tests: Any, pytester: Any) -> None:
    plant = PLANTS["ros2-two-topics"]
    nodes = [Path(node).name for node in plant.write(pytester.path, mended=False)]
    run = run_tests(f"""
import rosspin
@rosspin.explored(schedules=100)
def test_both(start_node):
    nodes = start_node([{nodes[0]!r}, rosspin.Node({nodes[1]!r})])
    nodes.advance({plant.seconds})
    assert nodes.run.console == "went to 7.0\\n"
""")
    run.assert_outcomes(failed=1)
    run.stdout.fnmatch_lines(["*in the shortest order found, which deviates once from the usual one*"])


RACE = """
import pytest, rosspin

def of_ros1():
    import rospy
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger, TriggerResponse
    count = [0]
    def tick(event):
        count[0] += 1
        assert count[0] < 2, "not reset in time"
    def reset(request):
        count[0] = 0
        return TriggerResponse()
    rospy.init_node("n")
    rospy.Timer(rospy.Duration(0.5), tick)
    rospy.Subscriber("/reset", Empty, reset)
    rospy.Service("/reset", Trigger, reset)
    rospy.spin()

def of_ros2():
    import rclpy
    from std_msgs.msg import Empty
    from std_srvs.srv import Trigger
    rclpy.init()
    node = rclpy.create_node("n")
    count = [0]
    def tick():
        count[0] += 1
        assert count[0] < 2, "not reset in time"
    def reset(request, response=None):
        count[0] = 0
        return response
    node.create_timer(0.5, tick)
    node.create_subscription(Empty, "/reset", reset, 10)
    node.create_service(Trigger, "/reset", reset)
    rclpy.spin(node)

@rosspin.explored({more})
def test_race(start_node):
    node = start_node({node})
    for _ in range(3):
        {step}
        node.{act}("/reset")
    node.advance(0.1)
"""


@pytest.mark.parametrize("node", ["of_ros1", "of_ros2"])
@pytest.mark.parametrize("act", ["call", "publish"])
def test_what_a_test_does_races_with_what_is_due(run_tests: Any, node: str, act: str) -> None:
    """What is due exactly at the end of a step comes before or after what the test does then."""
    text = RACE.format(node=node, act=act, step="node.advance(0.5)", more="schedules=300")
    run = run_tests(text)
    run.assert_outcomes(failed=1)
    run.stdout.fnmatch_lines(["*AssertionError: not reset in time", "*in the shortest order found, which deviates *"])
    token = str(run.stdout).partition('@rosspin.explored(schedule="')[2].partition('"')[0]
    again = run_tests(RACE.format(node=node, act=act, step="node.advance(0.5)", more=f'schedule="{token}"'))
    again.assert_outcomes(failed=1)
    again.stdout.fnmatch_lines(["*AssertionError: not reset in time"])


@pytest.mark.parametrize("node", ["of_ros1", "of_ros2"])
@pytest.mark.parametrize(
    "step", ["assert node.advance(0.5).ticks", "node.advance(0.5); assert len(node.run.ticks) == _ + 1"]
)
def test_what_a_test_looks_at_has_run(run_tests: Any, node: str, step: str) -> None:
    """Where a test looks at a step before it does something, all that was due has run, as it says."""
    run_tests(RACE.format(node=node, act="call", step=step, more="schedules=20")).assert_outcomes(passed=1)
