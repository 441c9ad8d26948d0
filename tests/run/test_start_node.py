"""The pytest fixture ``start_node``, in tests of a package of its own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

from rosspin import StartedNode, pytest_plugin, start

NODE = """
import rospy
from std_msgs.msg import UInt32

rospy.init_node("echo")
publisher = rospy.Publisher("b", UInt32, queue_size=1)
rospy.Subscriber("a", UInt32, lambda heard: publisher.publish(heard.data))
rospy.loginfo("here I am")
rospy.spin()
"""


pytest_plugins = ["pytester"]


@pytest.fixture
def run_tests(pytester: pytest.Pytester) -> Callable[..., pytest.RunResult]:
    """Runs pytest in a package with the node src/echo.py and a test of this text."""

    def run(text: str, *options: str, node: str = NODE) -> pytest.RunResult:
        for name, content in (("src/echo.py", node), ("test/test_echo.py", text)):
            (pytester.path / name).parent.mkdir(exist_ok=True)
            (pytester.path / name).write_text(content)
        options = ("-q", "--disable-plugin-autoload", *options)
        return pytester.runpytest_inprocess(*options, "test", plugins=[pytest_plugin])

    return run


def test_the_fixture_starts_nodes_beside_the_test(run_tests: Callable[..., Any]) -> None:
    run = run_tests("""
def test_echo(start_node):
    node, other = start_node("../src/echo.py"), start_node("../src/echo.py", ["__name:=other"], {"rate": 5})
    node.publish("/a", data=5)
    node.advance(0)
    assert [sent.message.data for sent in node.messages("/b")] == [5]
    assert other.messages("/b") == []

def test_of_a_function(start_node):
    def function():
        print("hello")
    assert start_node(function).run.console == "hello\\n"
""")
    run.assert_outcomes(passed=2, warnings=0)


def test_a_test_that_fails_shows_the_console_and_one_error(run_tests: Callable[..., Any]) -> None:
    text = "def test_echo(start_node):\n    node = start_node('../src/echo.py')\n    assert node.time == 2"
    run = run_tests(text, node=NODE + "1 / 0\n")
    run.assert_outcomes(failed=1, warnings=0)
    assert "- Console of echo.py -" in run.stdout.str()
    assert "[INFO] [0.000000]: here I am" in run.stdout.str()
    assert "ZeroDivisionError" not in run.stdout.str()


def test_the_end_is_checked_after_a_test_that_has_passed(run_tests: Callable[..., Any]) -> None:
    text = "def test_echo(start_node):\n    start_node('../src/echo.py')\n"
    run = run_tests(text, node=NODE + "1 / 0\n")
    run.assert_outcomes(passed=1, errors=1, warnings=0)
    assert "src/echo.py:10: ZeroDivisionError" in run.stdout.str()
    assert "run/steps.py" not in run.stdout.str()


def test_an_exception_of_the_node_is_shown_with_its_line(run_tests: Callable[..., Any]) -> None:
    text = """def test_echo(start_node):
    node = start_node('../src/echo.py')
    node.publish('/a', 1)
    node.advance(1)
"""
    run = run_tests(text, node=NODE.replace("publisher.publish(heard.data)", "heard.dta"))
    run.assert_outcomes(failed=1, warnings=0)
    assert "test/test_echo.py:4" in run.stdout.str()
    assert "src/echo.py:7: AttributeError" in run.stdout.str()
    assert "raised in echo.py at 0.0 s" in run.stdout.str()
    assert "run/steps.py" not in run.stdout.str()


@pytest.mark.parametrize("option", ["-s", "--capture=sys", "--capture=fd", "-W error"])
def test_whatever_pytest_captures(run_tests: Callable[..., Any], option: str) -> None:
    run = run_tests("""
def test_echo(start_node, capfd, caplog):
    node = start_node("../src/echo.py")
    print("mine")
    node.advance(1)
    assert capfd.readouterr().out == "mine\\n"
    assert node.run.console == "[INFO] [0.000000]: here I am\\n"
""", *option.split())  # fmt: skip
    assert run.ret == 0


def test_the_plugin_loads_next_to_nothing() -> None:
    code = (
        "import sys, pytest; before = set(sys.modules); import rosspin.pytest_plugin; print(*set(sys.modules) - before)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert set(run.stdout.split()) == {"rosspin", "rosspin.pytest_plugin"}


def test_a_started_node_is_what_start_gives() -> None:
    def node() -> None:
        pass

    with start(node) as started:
        assert type(started) is StartedNode
        assert started.name == "node"


def test_the_fixture_takes_faults(run_tests: Callable[..., Any]) -> None:
    run = run_tests("""
from rosspin.faults import Slow, Topic

def test_late(start_node):
    node = start_node("../src/echo.py", faults=[Topic("/a", delay=0.5)])
    node.publish("/a", data=5)
    node.advance(1.0)
    assert [sent.time for sent in node.messages("/b")] == [0.5]

def test_of_a_name_that_is_wrong(start_node):
    start_node("../src/echo.py", faults=[Topic("/aa", delay=0.5)])
""")
    run.assert_outcomes(passed=2, errors=1)
    run.stdout.fnmatch_lines(["*ValueError: Topic('/aa', delay=0.5): no node had the topic /aa; there were /b, /a*"])


@pytest.mark.parametrize("module", ["rclpy", "rclpy.node", "rospy", "std_msgs.msg"])
@pytest.mark.parametrize("where", ["", "def test_it():\n    "])
def test_who_imports_a_ros_in_a_test_is_told_where_it_is(run_tests: Any, module: str, where: str) -> None:
    run = run_tests(f"{where}import {module}\n")
    advice = "* is there only while a node runs. Import it in a node's file, * start_node, or with rosspin.simulate."
    run.stdout.fnmatch_lines(["*ModuleNotFoundError: No module named *", "*- rosspin -*", advice])


def test_other_modules_are_left_to_python(run_tests: Callable[..., Any]) -> None:
    assert "while a node runs" not in run_tests("import there_is_none").stdout.str()
