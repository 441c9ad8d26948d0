"""What the page says of a node that goes wrong, and that it bears what such a node does.

More of the sentences that help are in tests/page/test_sentences.py.
"""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from tests.helpers.listings_in_page import (
    TIMER,
    Cell,
    node,
    node2,
    open_tutorial,
)

pytestmark = pytest.mark.shares(10)


def test_flood(tutorial: Page) -> None:
    """The page answers all the while, keeps the last lines only, and the run comes to its end."""
    cell = Cell(tutorial, TIMER)
    cell.write(node("while True:\n    print('flood')\n    rospy.loginfo('flood')"))
    cell.run(2)
    expect(cell.console).to_contain_text("earlier lines are left out")
    assert tutorial.evaluate("1 + 1") == 2
    assert "simulated time stands still at 0.0 s" in cell.ends("error")
    assert cell.text().count("\n") <= 1000


@pytest.mark.parametrize(
    ("code", "status", "sentence"),
    [
        ("import rospy\nprint('a'\n", "error", "SyntaxError: '(' was never closed\nPython could not read"),
        ("import numpy\n", "error", "and Python's standard library, but no numpy. Run the node on your own computer"),
        (node("while True: pass"), "error", "node.py:4: simulated time stands still at 0.0 s"),
        (
            node("import threading\nwhile True: threading.Thread(target=rospy.sleep, args=[1]).start()"),
            "error",
            "node.py:5: simulated time stands still at 0.0 s, because 400 threads have not ended",
        ),
        (
            node("import multiprocessing\nmultiprocessing.Process(target=print).start()"),
            "error",
            "node.py:5: multiprocessing.Process (forkserver) is not simulated; run this node on the wall clock or on a "
            "real ROS",
        ),
        (node("input()"), "error", "EOFError"),
    ],
)
def test_errors_end_in_a_sentence_that_helps(tutorial: Page, code: str, status: str, sentence: str) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(code)
    cell.run(2)
    console = cell.ends(status)
    assert sentence in console
    assert "rosspin/" not in console and "pyodide" not in console
    assert cell.console.locator(".stderr").count()


@pytest.mark.parametrize(
    ("body", "status", "sentence"),
    [
        ("import curses", "error", "Python has no curses in a page"),
        ("node.create_timer(0.5, print)\nrclpy.spin(node)", "done: 4 ticks, ended by Ctrl-C", "KeyboardInterrupt"),
    ],
)
def test_errors_of_ros2_end_in_a_sentence_that_helps(tutorial: Page, body: str, status: str, sentence: str) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(node2(body))
    cell.run(2)
    console = cell.ends(status)
    assert sentence in console
    assert "rosspin/" not in console and "pyodide" not in console


def test_traceback_shows_the_readers_lines_only(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(node("def f(event):\n    g()\ndef g():\n    raise KeyError('mine')\nf(None)"))
    cell.run(2)
    lines = re.findall(r'  File "(.*)", line (\d+)', cell.ends("error"))
    assert lines == [("spinner_py_node.py", line) for line in ("8", "5", "7")]


def test_last_line_without_its_end_is_shown(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write("import sys\nprint('out', end='')\nprint('err', end='', file=sys.stderr)")
    cell.run(2)
    assert cell.ends("done") == "outerr"
    assert cell.console.locator(".stderr").all_text_contents() == ["err"]


def test_output_is_text(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    html = "<img src=x onerror=\"document.title='taken'\"><b>bold</b>"
    cell.write(f"print('''{html}''')")
    cell.run(2)
    assert cell.ends("done") == html + "\n"
    assert cell.console.locator("img, b").count() == 0


def test_python_breaks_down(context: BrowserContext, address: str) -> None:
    """It says so on the console of the page, and the next run finds a Python of its own."""
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write("import os\nos.abort()")
    cell.run(2)
    assert "Python itself broke down" in cell.ends("error")
    cell.write("print('next')")
    cell.run(2)
    assert cell.ends("done") == "next\n"
