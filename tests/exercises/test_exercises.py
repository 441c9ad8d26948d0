"""The exercises: each solution passes; the untouched start and typical wrong answers do not, and are told why."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from IPython.core.error import UsageError
from IPython.core.interactiveshell import InteractiveShell

from rosspin import Run, explore, simulate
from rosspin.exercises import EXERCISES, check
from rosspin.exercises.own import Answer, name_the_fault, rostopic_hz
from rosspin.measures import periods, topic_ticks
from rosspin.measures import rostopic_hz as rostopic_hz_of
from rosspin.results.console import read_ticks
from rosspin.results.recordings import load
from tests.helpers.answers import (
    CELLS,
    FILES,
    LATE,
    NAMES,
    NOTEBOOKS,
    ON_PAGE,
    RIGHT,
    WRONG,
    answer_in,
    late_listener,
    listings,
    number_of,
    solution_of,
    written,
)
from tests.helpers.python_texts import of_any_python
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

IN_PARTS = [exercise for exercise in EXERCISES if exercise.part]
PAGES = {ros: notebook.read_text(encoding="utf-8") for ros, notebook in NOTEBOOKS.items()}


@pytest.mark.parametrize("name", NAMES)
def test_solution_passes(name: str) -> None:
    feedback = check(name, answer_in(CELLS[name][1]))
    assert feedback.passed, feedback


@pytest.mark.parametrize("name", NAMES)
def test_untouched_start_does_not(name: str) -> None:
    feedback = check(name, answer_in(CELLS[name][0]))
    assert not feedback.passed
    assert "not yet" in repr(feedback)
    assert feedback.hint


@pytest.mark.parametrize(("name", "answer"), [(name, answer) for name in NAMES for answer in RIGHT[name]])
def test_right_answer_passes_however_it_is_written(name: str, answer: Answer) -> None:
    feedback = check(name, written(name, answer))
    assert feedback.passed, feedback


@pytest.mark.parametrize(("name", "wrong"), [(name, wrong) for name in NAMES for wrong in WRONG[name]])
def test_wrong_answer_is_told_what_is_wrong_and_how_to_go_on(
    name: str, wrong: tuple[Answer, str, str], request: pytest.FixtureRequest
) -> None:
    answer, said, hint = wrong
    if "stands still" in said:
        request.getfixturevalue("watchful")
    feedback = check(name, written(name, answer))
    assert not feedback.passed
    found = "\n".join(finding.text for finding in feedback.findings if not finding.right)
    assert said.lower() in of_any_python(found).lower()
    assert hint in feedback.hint


@pytest.mark.parametrize("name", [name for name in NAMES if FILES[name].language == "python"])
def test_a_node_of_the_other_ros_is_told_so(name: str) -> None:
    ros, other, root = (1, 2, "rclpy") if name in ON_PAGE[1] else (2, 1, "rospy")
    feedback = check(name, f"import {root}\n{root}.spin()\n")
    assert f"This node is for ROS {other}: it imports `{root}`." in repr(feedback)
    assert feedback.hint.startswith(f"This exercise is on ROS {ros}")


@pytest.mark.parametrize("name", NAMES)
def test_every_exercise_has_answers_enough(name: str) -> None:
    assert len(RIGHT[name]) >= 5
    assert len(WRONG[name]) >= 8


# --- what the page says of an exercise --------------------------------------------------------------------------------


def test_exercises_are_what_the_page_says() -> None:
    """Each has its number and its title, stands in its part, and links to the pages that it needs."""
    of: dict[tuple[int, str], str] = {}
    for ros, page in PAGES.items():
        parts = re.split(r"^## (.*)$", page, flags=re.MULTILINE)
        of |= {(ros, part): text for part, text in zip(parts[1::2], parts[2::2], strict=True)}
    for exercise in IN_PARTS:
        below = of[exercise.ros, exercise.part].partition(f"### {exercise.number}. {exercise.title}\n")[2]
        below = below.partition("\n###")[0]
        assert f"\n%answer {exercise.name}\n" in below and f"```{{exercise}} {exercise.name}\n:solution:\n" in below
        assert FILES[exercise.name].text.startswith("**You need**: ")
        assert exercise.needs
        for path in exercise.needs:
            assert (ROOT / f"{path}.rst").exists() or (ROOT / f"{path}.md").exists()


@pytest.mark.parametrize("ros", NOTEBOOKS)
def test_the_page_says_how_many_they_are(ros: int) -> None:
    assert len(ON_PAGE[ros]) == (21 if ros == 2 else 19)
    said = "twenty-one exercises in five parts" if ros == 2 else "nineteen exercises in four parts"
    assert said in " ".join(PAGES[ros].split())


def test_the_page_for_teachers_knows_the_exercises() -> None:
    page = (ROOT / "docs/for-teachers.rst").read_text(encoding="utf-8")
    tables = [table.partition("\n\n")[0] for table in page.split("Exercise that reveals it")[1:]]
    for ros, table in zip((2, 1), tables, strict=True):
        named = re.findall(r"\*([A-Z][^*\n]+)\*", table)
        assert set(named) == {exercise.title for exercise in IN_PARTS if exercise.ros == ros}


def test_the_parts_come_one_after_the_other() -> None:
    assert [exercise.ros for exercise in IN_PARTS] == [2] * len(ON_PAGE[2]) + [1] * len(ON_PAGE[1])
    assert ON_PAGE[2][0] == "make-it-10-hz"
    assert ON_PAGE[2][-3:] == ["wake-a-rate", "end-without-a-traceback", "outlive-nothing"]
    for ros, page in PAGES.items():
        parts = list(dict.fromkeys(exercise.part for exercise in IN_PARTS if exercise.ros == ros))
        assert re.findall(r"^## (.*)$", page, re.MULTILINE) == [*parts, "How it works", "See also"]
    assert [exercise.number for exercise in EXERCISES] == list(range(1, len(EXERCISES) + 1))
    assert len({exercise.title for exercise in EXERCISES}) == len(EXERCISES)


@pytest.mark.parametrize("ros", [1, 2])
def test_an_exercise_that_a_page_names_by_number_is_on_that_page(ros: int) -> None:
    numbers = {exercise.number for exercise in EXERCISES if exercise.ros == ros}
    text = (ROOT / "notebooks" / ("exercises.md", "ros2-exercises.md")[ros - 1]).read_text(encoding="utf-8")
    assert {int(number) for number in re.findall(r"[Ee]xercise (\d+)", text)} <= numbers


def test_each_exercise_has_a_name_of_its_own() -> None:
    names = [exercise.name for exercise in EXERCISES]
    assert len(set(names)) == len(EXERCISES)
    assert all(re.fullmatch("[a-z]+(-[a-z0-9]+)+", name) for name in names)


def test_an_exercise_is_named_or_numbered() -> None:
    answer = answer_in(CELLS["ten-hertz"][1])
    assert check("ten-hertz", answer) == check(number_of("ten-hertz"), answer)
    with pytest.raises(ValueError, match="there is no exercise 'nine-hertz'"):
        check("nine-hertz", answer)


@pytest.mark.parametrize("name", NAMES)
def test_every_exercise_has_hints_enough(name: str) -> None:
    assert len(FILES[name].hints) >= 3


def test_the_pages_have_no_roles_that_only_sphinx_reads() -> None:
    for page in (*PAGES.values(), *(file.text + file.after for file in FILES.values())):
        assert not re.search(r"\{(term|ref|doc)\}`", page)


@pytest.mark.parametrize(("index", "variable"), [(0, "timer"), (1, "loop"), (2, "busy_loop")])
def test_the_nodes_to_predict_do_what_the_solution_says(index: int, variable: str, tmp_path: Path) -> None:
    nodes = listings("first-ticks")
    nodes.append(nodes[1].replace("    loop_rate", "    rospy.sleep(0.1)\n    loop_rate"))  # described in words
    node = tmp_path / "node.py"
    node.write_text(nodes[index])
    assert times_of(simulate(node, 2.0).console, 1) == pytest.approx(solution_of("first-ticks")[variable])


@pytest.mark.parametrize("blocks_for", ["1.0", "1.8"])
def test_the_node_with_a_slow_callback_does_what_the_solution_says(blocks_for: str, tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(listings("after-a-slow-callback")[0])
    console = simulate(node, 5.5, [f"_blocks_for:={blocks_for}"]).console
    assert times_of(console, 4) == pytest.approx(
        solution_of("after-a-slow-callback")[f"after_{blocks_for.replace('.', '_')}_seconds"]
    )


@pytest.mark.parametrize(
    ("variable", "first", "old", "new", "args"),
    [
        ("after_1_0_seconds", 4, "", "", ["-p", "blocks_for:=1.0"]),
        ("after_1_8_seconds", 4, "", "", ["-p", "blocks_for:=1.8"]),
        ("always_slow", 1, "        if self.counter == 3:\n            time", "        time", []),
    ],
)
def test_the_node_of_ros_2_does_what_the_solution_says(
    variable: str, first: int, old: str, new: str, args: list[str], tmp_path: Path
) -> None:
    [text] = listings("slow-timer")
    assert old in text
    node = tmp_path / "node.py"
    node.write_text(text.replace(old, new) if old else text)
    ticks = simulate(node, 5.5, ["--ros-args", *args] if args else []).ticks
    assert [tick.real for tick in ticks][first - 1 : first + 2] == pytest.approx(solution_of("slow-timer")[variable])


SPIN_IN_MAIN = "    rclpy.spin(spinner_py_node)\n"


@pytest.mark.parametrize(("index", "variable"), [(1, "without_spin"), (2, "spin_once")])
def test_the_node_that_does_not_spin_does_what_the_solution_says(index: int, variable: str, tmp_path: Path) -> None:
    nodes = listings("who-calls")
    assert SPIN_IN_MAIN in nodes[0]
    node = tmp_path / "node.py"
    node.write_text(nodes[0].replace(SPIN_IN_MAIN, nodes[index]))
    assert [tick.real for tick in simulate(node, 2.0).ticks] == pytest.approx(solution_of("who-calls")[variable])


@pytest.mark.parametrize(("index", "variable"), [(0, "timer"), (1, "loop")])
def test_the_first_calls_come_when_the_solution_says(index: int, variable: str, tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(listings("first-call")[index])
    assert times_of(simulate(node, 2.0).console, 1) == pytest.approx(solution_of("first-call")[variable])


@pytest.mark.parametrize("variable", LATE)
def test_a_late_subscriber_hears_what_the_solution_says(variable: str, tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(late_listener(variable))
    heard = [tick.number for tick in read_ticks(simulate(node, 4.0).console)]
    assert heard[:3] == solution_of("late-listener")[variable]


AT_ONCE = "        self.timerCallback(None)\n"


@pytest.mark.parametrize(
    ("variable", "old", "new"),
    [
        ("without_latch", "", ""),
        ("with_latch", "UInt32, queue_size", "UInt32, latch=True, queue_size"),
        (
            "three_at_once",
            f"UInt32, queue_size=10)\n<SUB>{AT_ONCE}        rospy.Timer(rospy.Duration(0.5), self.timerCallback)\n",
            f"UInt32, latch=True, queue_size=10)\n<SUB>{AT_ONCE * 3}",
        ),
    ],
)
def test_the_node_that_publishes_at_once_does_what_the_solution_says(
    variable: str, old: str, new: str, tmp_path: Path
) -> None:
    [text] = listings("what-is-heard")
    subscriber = '        rospy.Subscriber("counter", UInt32, self.counterCallback)\n'
    old, new = (part.replace("<SUB>", subscriber) for part in (old, new))
    assert old in text
    node = tmp_path / "node.py"
    node.write_text(text.replace(old, new))
    heard = [tick.number for tick in read_ticks(simulate(node, 1.6).console)]
    assert heard[:3] == solution_of("what-is-heard")[variable]


SLOW_SUBSCRIBER = """import rospy
from std_msgs.msg import UInt32

def callback(message):
    rospy.loginfo("[PUBSUB PY NODE] counter = " + str(message.data))
    rospy.sleep(0.33)

def publish(event, counts=iter(range(100))):
    publisher.publish(next(counts))

rospy.init_node("pubsub_py_node")
publisher = rospy.Publisher("counter", UInt32, queue_size=10)
rospy.Subscriber("counter", UInt32, callback, queue_size=1)
rospy.sleep(0.5)
rospy.Timer(rospy.Duration(0.1), publish)
rospy.spin()
"""


def test_the_slow_subscriber_hears_what_the_solution_says(tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(SLOW_SUBSCRIBER)
    heard = [tick.number for tick in read_ticks(simulate(node, 2.0).console)]
    assert heard[:3] == solution_of("what-is-heard")["slow_callback"]


@pytest.mark.parametrize(("variable", "blocks_for"), [("after_0_6_seconds", 0.6), ("after_1_0_seconds", 1.0)])
def test_roscpp_gives_what_the_solution_says(variable: str, blocks_for: float) -> None:
    args = ["_period:=0.4", f"_block:={blocks_for}", "_block_call:=3"]
    ticks = simulate(ROOT / "examples/timing_probes/src/timer_probe.cpp", 6.0, args).ticks
    assert [tick.real for tick in ticks[3:6]] == pytest.approx(solution_of("cpp-ticks")[variable])


@pytest.mark.parametrize("name", name_the_fault.LOGS)
def test_a_log_with_a_fault_is_that_of_a_run(name: str, tmp_path: Path) -> None:
    seconds, text = name_the_fault.LOGS[name]
    node = tmp_path / "spinner_py_node.py"
    node.write_text(text)
    console = re.sub(r"\n[ ~^]+\n", "\n", simulate(node, seconds).console).replace(str(node), node.name)
    assert console in listings("name-the-fault", "text")


def publishing(pauses: list[float], offset: float | None) -> Callable[[], None]:
    """A node that publishes a message before each pause (s), in a second thread as well after an offset (s)."""

    def node() -> None:
        import threading

        import rospy  # type: ignore[import-not-found]
        from std_msgs.msg import UInt32

        def publish(start: float) -> None:
            rospy.sleep(start)
            for pause in pauses:
                publisher.publish(0)
                rospy.sleep(pause)

        rospy.init_node("a_node")
        publisher = rospy.Publisher("counter", UInt32, queue_size=10)
        rospy.sleep(0.5)
        if offset is not None:
            threading.Thread(target=publish, args=(offset,), daemon=True).start()
        publish(0)

    return node


@pytest.mark.parametrize("name", rostopic_hz.PAUSES)
def test_a_report_of_rostopic_hz_is_of_a_run_and_of_what_the_solution_says(name: str) -> None:
    ticks = topic_ticks(simulate(publishing(*rostopic_hz.PAUSES[name]), 60.6).messages, "/counter")
    until = {seconds: [tick for tick in ticks if tick.real <= ticks[0].real + seconds] for seconds in (10, 60)}
    said = [f"after {seconds} s: {rostopic_hz_of(seen)}\n" for seconds, seen in until.items()]
    assert f"{name}\n{''.join(said)}".expandtabs(4) in listings("rostopic-hz", "text")[0]
    solution: Any = solution_of("rostopic-hz")
    assert solution[name] == cause_of([round(step, 3) for step in periods(ticks)])


def cause_of(steps: list[float]) -> str:
    """The letter for a topic, by the times between its messages (s)."""
    causes = {
        "B": set(steps) == {0.03, 0.07},
        "C": set(steps[:199]) == {0.1} and set(steps[200:]) == {0.5},
        "D": steps[:10] == [0.0, 0.0, 0.0, 0.0, 0.5] * 2,
        "E": set(steps) == {0.105, 0.106},
    }
    return "".join(letter for letter, holds in causes.items() if holds)


def times_of(console: str, first: int) -> list[float]:
    """When three counters come."""
    return [tick.real for tick in read_ticks(console)][first - 1 : first + 2]


# --- C++ --------------------------------------------------------------------------------------------------------------


def test_roscpp_reports_no_ticks_as_missing() -> None:
    """What the page says below "Count the ticks that are missing": to roscpp, a late call is on time."""
    late = load(ROOT / "examples/recordings/timer_cpp_blocks_once_4.4.csv").ticks[3]
    assert late.real > 3.5
    assert late.lateness < 0.1


# --- strange answers --------------------------------------------------------------------------------------------------


ENDLESS = "import rospy\nrospy.init_node('n')\nwhile True:\n    pass"


@pytest.mark.parametrize("answer", [None, ..., 0, [], b"x", "", "\0", "def", print])
@pytest.mark.parametrize("name", ["after-a-slow-callback", "stop-after-five"])
def test_no_answer_is_too_strange(name: str, answer: Any) -> None:
    feedback = check(name, answer)
    assert not feedback.passed
    assert feedback.hint
    assert ("Open: " if answer in (None, ..., "") else "Wrong: ") in repr(feedback)


HOSTILE = """
class Hostile:
    def __iter__(self): raise RuntimeError
    __eq__ = __repr__ = __float__ = __iter__
"""


@pytest.mark.parametrize("value", ["Hostile()", "[Hostile()]", "[[]]", "[float('nan')]", "0", "print", "iter(int, 1)"])
def test_no_prediction_is_too_strange(value: str) -> None:
    assert not check("after-a-slow-callback", f"{HOSTILE}after_1_0_seconds = after_1_8_seconds = {value}").passed


def test_a_module_that_a_page_lacks_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where a listing imports it; on a computer it may be spelt wrong."""
    said = [str(check("ten-hertz", "import no_such_module"))]
    monkeypatch.setattr("sys.platform", "emscripten")
    said.append(str(check("ten-hertz", "import no_such_module")))
    assert "Is the module spelt right? No exercise needs others" in said[0]
    assert "and Python's standard library, but no no_such_module. No exercise needs it." in said[1]


@pytest.mark.parametrize(
    ("wrong", "hint"),
    [
        ("0.5", "a Duration: rospy.Timer(rospy.Duration(0.5), callback)"),
        ("None", "Pass a timer the callback itself"),
        ("(self)", "A timer passes its callback one argument"),
        ("rospy.log_info", "`rospy` has no `log_info`"),
        ("class SpinnerPyNode", "Python could not read the answer"),
        ("    pass", "The node ended by itself"),
        ("    # init_node", 'Call rospy.init_node("a_name")'),
    ],
)
def test_an_error_has_a_hint_of_its_own(wrong: str, hint: str) -> None:
    good = answer_in(CELLS["stop-after-five"][0])
    right = {
        "0.5": "rospy.Duration(0.5)",
        "None": "self.timerCallback",
        "(self)": "(self, event)",
        "rospy.log_info": "rospy.loginfo",
        "class SpinnerPyNode": "class SpinnerPyNode:",
        "    pass": "    rospy.spin()",
        "    # init_node": '    rospy.init_node("spinner_py_node")',
    }[wrong]
    assert right in good
    assert hint in check("stop-after-five", good.replace(right, wrong)).hint


@pytest.mark.parametrize(
    "error",
    [
        "NameError(name=[])",
        "AttributeError(name='(', obj=Odd())",
        "AttributeError('object has no attribute', name='x', obj=Odd())",
        "type('E', (TypeError,), {'__str__': lambda self: 1 / 0})()",
    ],
)
@pytest.mark.parametrize("name", ["ten-hertz", "make-it-10-hz"])
def test_no_error_is_too_strange(name: str, error: str) -> None:
    odd = "class Odd:\n    def __dir__(self): raise RuntimeError\n    def __getattr__(self, name): raise RuntimeError\n"
    assert "stopped in line" in repr(check(name, f"{odd}raise {error}"))


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("x = (1,", "Line 1 is not Python: '(' was never closed"),
        ("(" * 5000, "is not Python"),
        ("# later", "Open: No answer yet"),
        ("import rospy\n\n\0", "Line 3 is not Python: source code cannot contain null bytes."),
        ("import rospy\nx = ...", "Open: There is still a gap, `...`, in line 2"),
        ("def f():\n    x = 1\n    ...", "Open: There is still a gap, `...`, in line 3"),
        ("class A:\n    x = ...\n    def f(self): ...", "Open: There is still a gap, `...`, in line 2"),
        ("import rospy\nrospy.init_node('n')\n1 / 0", "stopped in line 3: `ZeroDivisionError: division by zero`."),
        (ENDLESS, "simulated time stands still at 0.0 s"),
        ("import rospy\nrospy.init_node('n')\nimport cv_bridge", "cv_bridge is not simulated"),
        ("import rospy\nrospy.init_node('n')\nwhile True:\n    rospy.sleep(1)", "did not end at Ctrl-C"),
        ("import sys\nsys.exit(3)", "ended with status 3 instead of 0"),
        ("import no_such_module", "No module named 'no_such_module'"),
        ("raise KeyboardInterrupt", "stopped in line 1: `KeyboardInterrupt`"),
    ],
)
def test_node_that_cannot_be_checked(answer: str, said: str, request: pytest.FixtureRequest) -> None:
    if answer == ENDLESS:
        request.getfixturevalue("watchful")
    feedback = check("ten-hertz", answer)
    assert not feedback.passed
    assert said in repr(feedback)


NO_GAPS = """
from typing import Callable
from typing import Protocol
from typing import Tuple
class Spins(Protocol):
    '''Whatever spins.'''
    ...
class Counts(Protocol):
    def count(self, by: int = ...) -> Tuple[int, ...]: ...
    async def later(self):
        '''Not now.'''
        ...
Callback = Callable[..., None]
def cell(table):
    return table[..., 0], table[...]
"""


def test_not_each_ellipsis_is_a_gap() -> None:
    assert check("ten-hertz", NO_GAPS + answer_in(CELLS["ten-hertz"][1])).passed


ODD_PYTHON = """from __future__ import annotations
import dataclasses, enum
from typing import ClassVar

class Kind(enum.Enum):
    A = 1

@dataclasses.dataclass
class Part:
    weight: float = 1.0
    kinds: ClassVar[dict[str, int]] = {}

    @property
    def heavy(self) -> bool:
        return self.weight > 2

    @heavy.setter
    def heavy(self, value: bool) -> None:
        self.weight += 3 * value

class Child(Part):
    def __init__(self):
        super().__init__(2.0)
        self.weights = [part.weight for part in (self,) if part.kinds is not None]

def kind(thing):
    match thing:
        case Part(weight=5.0):
            return f"{thing.weight:{Kind.A.value}.1f}"
        case Kind.A:
            return Kind.A
        case {"x": [first, *_]} if (twice := 2 * first.real):
            return twice

child = Child()
child.heavy = True
del child.weights[0]
assert (child.weights, kind(child), kind(Kind.A), kind({"x": [2]})) == ([], "5.0", Kind.A, 4)
assert [field.name for field in dataclasses.fields(Part)] == ["weight"]
"""


def test_taking_turns_changes_nothing_else() -> None:
    assert check("share-data", ODD_PYTHON + answer_in(CELLS["share-data"][1])).passed


def test_a_changed_console_or_namespace_does_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSCONSOLE_FORMAT", "${message}")
    monkeypatch.setenv("ROS_NAMESPACE", "/elsewhere")
    assert check("ten-hertz", answer_in(CELLS["ten-hertz"][1])).passed


@pytest.mark.parametrize(
    ("name", "answer", "said", "hint"),
    [
        (
            "call-back-once",
            "import rospy\n",
            "This node is for ROS 1: it imports `rospy`.",
            "where a node imports `rclpy`",
        ),
        ("call-back-once", "from rospy import spin\n", "This node is for ROS 1", "This exercise is on ROS 2"),
        ("ten-hertz", "import rclpy\n", "This node is for ROS 2: it imports `rclpy`.", "where a node imports `rospy`"),
        ("ten-hertz", "from rclpy.node import Node\n", "This node is for ROS 2", "This exercise is on ROS 1"),
        ("ten-hertz", "import rospy, rclpy\n", "imports both `rospy` (ROS 1) and `rclpy` (ROS 2)", "imports `rospy`"),
        ("call-back-once", "import rclpy\nimport rospy\n", "A node has one ROS", "imports `rclpy`"),
        ("slow-timer", "import rospy\n", "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
)
def test_an_answer_for_the_other_ros_is_told_so(name: str, answer: str, said: str, hint: str) -> None:
    feedback = check(name, answer)
    assert not feedback.passed
    assert said in repr(feedback)
    assert hint in feedback.hint


def test_ros_2_is_loaded_for_its_own_exercises_only() -> None:
    """The page starts from a memory snapshot that does not hold it."""
    code = """
import sys
from rosspin.exercises import check
for name, answer in (
    ("first-ticks", "timer = 0"), ("ten-hertz", "import rclpy"), ("ten-hertz", "import rospy"),
    ("call-back-once", "import rospy"),
):
    check(name, answer)
    assert not [name for name in sys.modules if name.startswith("rosspin.rclpy")], name
check("call-back-once", "import rclpy")
assert "rosspin.rclpy" in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_wrong_calls() -> None:
    with pytest.raises(ValueError, match=f"there is no exercise 99: they are numbered 1 to {len(EXERCISES)}"):
        check(99, "")


def test_notebook_shows_feedback_as_markdown() -> None:
    text = check("after-a-slow-callback", "after_1_0_seconds = [2.2, 2.2, 2.4]")._repr_markdown_()
    assert text.splitlines()[:3] == [
        f"**Exercise {number_of('after-a-slow-callback')}: not yet.**",
        "",
        "- Right: Blocked for 1.0 s: 2.2 s, 2.2 s, 2.4 s.",
    ]
    assert "**Hint:** " in text


@pytest.fixture(scope="module")
def shell() -> InteractiveShell:
    shell = InteractiveShell()
    shell.run_line_magic("load_ext", "rosspin")
    return shell


def test_the_magic_shows_the_console_and_returns_the_feedback(
    shell: InteractiveShell, capsys: pytest.CaptureFixture[str]
) -> None:
    feedback = shell.run_cell_magic("answer", "fire-once", answer_in(CELLS["fire-once"][1]))
    assert feedback.passed
    assert "You have solved 1 of 19 exercises." in feedback._repr_markdown_()
    assert capsys.readouterr().out == "[INFO] [1.500000]: [SPINNER PY NODE] counter = 1\n"


def test_the_magic_counts_the_exercises_of_each_page_by_themselves(shell: InteractiveShell) -> None:
    said = shell.run_cell_magic("answer", "slow-timer", answer_in(CELLS["slow-timer"][1]))._repr_markdown_()
    assert f"You have solved 1 of {len(ON_PAGE[2])} exercises." in said


def test_the_magic_counts_as_a_line(shell: InteractiveShell) -> None:
    assert "stopped in line 2:" in repr(shell.run_cell_magic("answer", "ten-hertz", "1 / 0"))


def test_the_magic_cuts_an_endless_console_short(shell: InteractiveShell, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell_magic("answer", "ten-hertz", "for n in range(1000):\n    print(n)")
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) < 100
    assert lines[-1] == f"... and {1001 - len(lines)} more lines"


@pytest.mark.parametrize("line", ["", "4", "one"])
def test_the_magic_needs_the_name_of_an_exercise(shell: InteractiveShell, line: str) -> None:
    with pytest.raises(UsageError, match="%%answer NAME: "):
        shell.run_cell_magic("answer", line, "pass")


def test_the_order_of_the_solution_is_one_that_exploring_finds(tmp_path: Path) -> None:
    node = tmp_path / "parts.py"
    node.write_text(listings("find-the-order")[0], encoding="utf-8")
    lines = node.read_text(encoding="utf-8").splitlines()
    first = lines.index("        parts = self.parts") + 1
    usual = simulate(str(node), 0.6)
    assert "parts = 10" in usual.console

    def is_whole(run: Run) -> None:
        assert "parts = 10" in run.console

    found = explore(str(node), 0.6, is_whole, deep=True, strategy="all")
    assert found.run
    assert "parts = 9" in found.run.console
    shown = re.findall(r"[*|] (ThreadPool\S+) +(\d+)  ", str(found))
    steps = [(thread, int(line) - first) for thread, line in dict.fromkeys(shown) if int(line) in (first, first + 1)]
    (one, _), (other, _) = steps[0], next(step for step in steps if step[0] != steps[0][0])
    assert steps in (
        [(one, 0), (other, 0), (one, 1), (other, 1)],
        [(one, 0), (other, 0), (other, 1), (one, 1)],
        [(one, 0), (one, 1), (other, 0), (other, 1)],  # thread 1 is in the call of its second line meanwhile
    )
