"""What an answer reaches for that no exercise needs is found, and no honest answer is suspected."""

from __future__ import annotations

import pytest

from rosspin.exercises.reach import reaches_for
from tests.helpers.answers import CELLS, NAMES, answer_in, written
from tests.helpers.answers import RIGHT as RIGHT_ANSWERS
from tests.helpers.answers import WRONG as WRONG_ANSWERS


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        ("import js", "js"),
        ("from pyodide.ffi import run_sync", "pyodide.ffi"),
        ("import pyodide_js, math", "pyodide_js"),
        ("import _pyodide_core", "_pyodide_core"),
        ("from rosspin.exercises.feedback import Feedback", "rosspin.exercises.feedback"),
        ("from . import feedback", "."),
        ("import gc", "gc"),
        ("import ctypes", "ctypes"),
        ("import importlib", "importlib"),
        ("import sys\nsys.modules['js']", "modules"),
        ("from sys import modules", "modules"),
        ("from threading import _sys", "_sys"),
        ("import sys\nsys._getframe()", "_getframe"),
        ("__import__('js')", "__import__"),
        ("__builtins__", "__builtins__"),
        ("eval('1')", "eval"),
        ("().__class__.__base__", "__base__"),
        ("import rospy\nrospy.Timer._oneshot", "_oneshot"),
        ("a._other", "_other"),
        ("open('x')", "open"),
        ("import _msgs", "_msgs"),
    ],
)
def test_what_no_exercise_needs_is_found(answer: str, name: str) -> None:
    assert reaches_for(answer) == name


HONEST = [
    "print(",
    "import rclpy.node\nfrom example_interfaces.msg import Int64\nfrom std_srvs.srv import SetBool",
    "import operator, asyncio\nfrom concurrent.futures import ThreadPoolExecutor",
    "import a_module_that_the_page_lacks, its_own_msgs.msg",
    "import collections.abc, re\ncollections.abc.Callable, re.compile('x')",
    "import datetime as dt\nfrom datetime import datetime, time\nfrom rclpy.time import Time\ndt.datetime.now()",
    "import rclpy.time, time, signal\nrclpy.time.Time(), time.time(), signal.signal(signal.SIGINT, print)",
    "import os\nos.environ['A'] = 'b'",
    "class A:\n    def __init__(self):\n        self.__x = self._y = 1\n        print(self.__x)",
    "class A:\n    _b = 1\n    def _f(self):\n        pass\na = A()\na._f(), a._b",
    "class A(B):\n    def __init__(self):\n        super().__init__()\n        super()._start()",
    "try:\n    f()\nexcept Exception as e:\n    print(e.__class__.__name__, type(e).__name__)",
    "__version__ = '1'\n__all__ = ['A']\nclass A:\n    __slots__ = ('x',)",
    "open = 3\nprint(open)\ngripper.open()\ndef f(open):\n    return open",
]


def test_no_honest_answer_is_suspected() -> None:
    for name in NAMES:
        wrong = [answer for answer, *_ in WRONG_ANSWERS[name]]
        for answer in [*RIGHT_ANSWERS[name], *wrong, *map(answer_in, CELLS[name])]:
            assert reaches_for(written(name, answer)) == ""
    for answer in HONEST:
        assert reaches_for(answer) == ""
