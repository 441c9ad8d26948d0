"""The exercises: each solution passes; the untouched start and typical wrong answers do not, and are told why."""

from __future__ import annotations

import re
from typing import Any

import jupytext
import pytest
from conftest import ROOT
from IPython.core.error import UsageError
from IPython.core.interactiveshell import InteractiveShell

from rosspin.exercises import _EXERCISES, check

NUMBERS = sorted(_EXERCISES)


def _cells() -> dict[int, list[Any]]:
    """The cells of each exercise in the notebook that hold an answer."""
    notebook = jupytext.read(ROOT / "notebooks" / "exercises.md")
    found: dict[int, list[Any]] = {number: [] for number in NUMBERS}
    for cell in notebook.cells:
        if match := re.match(r"%%answer (\d+)\n", cell.source):
            found[int(match[1])].append(cell)
    return found


CELLS = _cells()


def answer_in(cell: Any) -> str:
    """What a cell answers."""
    text: str = cell.source.partition("\n")[2]
    return text


@pytest.mark.parametrize("number", NUMBERS)
def test_there_is_a_start_and_a_folded_solution(number: int) -> None:
    start, solution = CELLS[number]
    assert start.metadata["tags"] == ["live"]  # it can be run in the page
    assert solution.metadata["tags"] == ["hide-cell"]
    assert solution.metadata["jupyter"] == {"source_hidden": True, "outputs_hidden": True}
    assert solution.metadata["mystnb"]["code_prompt_show"] == f"Show the solution of exercise {number}"
    assert solution.metadata["mystnb"]["code_prompt_hide"] == f"Hide the solution of exercise {number}"


@pytest.mark.parametrize("number", NUMBERS)
def test_solution_passes(number: int) -> None:
    feedback = check(number, answer_in(CELLS[number][1]))
    assert feedback.passed, feedback


@pytest.mark.parametrize("number", NUMBERS)
def test_untouched_start_does_not(number: int) -> None:
    feedback = check(number, answer_in(CELLS[number][0]))
    assert not feedback.passed
    assert "not yet" in repr(feedback)
    assert feedback.hint


LOOPS_IN_A_ROW = """
import rospy
rospy.init_node("n")
fast = slow = 0
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    rate.sleep()
    fast += 1
    rospy.loginfo("[FAST] counter = " + str(fast))
rate = rospy.Rate(2)
while not rospy.is_shutdown():
    rate.sleep()
    slow += 1
    rospy.loginfo("[SLOW] counter = " + str(slow))
"""

WHILE_LATE = "        while deadline < time.monotonic():\n            deadline += period\n"
SLEEP = "        time.sleep(deadline - time.monotonic())"

# Exercise, what a wrong answer has in place of what the solution has, what the feedback says.
WRONG = [
    (1, {"= 0.1": "= 10"}, "no counter was printed"),
    (1, {"= 0.1": "= 0.01"}, "counter 1 came at 0.01 s, not at 0.1 s"),
    (1, {"= 0.1": "= 1 // 10"}, "died of `ZeroDivisionError: float division by zero`"),
    (1, {"rospy.Duration(timer_delta_t_in_seconds)": "timer_delta_t_in_seconds"}, "has no attribute 'to_sec'"),
    (2, {", oneshot=True": ""}, "counter 2 came at 3 s; it should not come"),
    (2, {"= 1.5": "= 0.5"}, "counter 1 came at 0.5 s, not at 1.5 s"),
    (2, {"oneshot=True": "oneshot"}, "NameError: name 'oneshot' is not defined` in line 10"),
    (3, {"== 5": "> 5"}, "counter 6 came at 3 s; it should not come"),
    (3, {"self.timer.shutdown()": "rospy.signal_shutdown('five')"}, "The heartbeat: counter"),
    (
        3,
        {"        if self.counter == 5:\n            self.timer.shutdown()\n": "",
         "        self.counter += 1": "        if self.counter == 5: return\n        self.counter += 1"},
        "were called 18 times",
    ),
    (3, {"self.timer.shutdown()": "self.timer.stop()"}, "'Timer' object has no attribute 'stop'` in line 15"),
    (4, {"    rospy.spin()": ""}, "no counter was printed"),
    (4, {"self.timerCallback)": "self.timerCallback())"}, "missing 1 required positional argument: 'event'"),
    (4, {"(self, event)": "(self)"}, "takes 1 positional argument but 2 were given"),
    (4, {"1.0 / frequency_in_hz": "frequency_in_hz"}, "counter 1 came at 2 s, not at 0.5 s"),
    (
        4,
        {"    rospy.spin()": "    rate = rospy.Rate(2.0)\n    while not rospy.is_shutdown():\n        rate.sleep()"},
        "a loop with a `rospy.Rate` still runs",
    ),
    (5, {'"~frequency"': '"frequency"'}, "With `_frequency:=10`: counter 1 came at 0.5 s, not at 0.1 s"),
    (5, {", 2.0)": ")"}, "KeyError: '~frequency'"),
    (5, {"1.0 / frequency_in_hz": "frequency_in_hz"}, "Without the parameter: counter 1 came at 2 s, not at 0.5 s"),
    (5, {"1.0 / frequency_in_hz": "1 // frequency_in_hz"}, "died of `ZeroDivisionError"),
    (6, {"slow_counter": "fast_counter"}, "where counter 5 was due, counter 6 came"),
    (6, {"Duration(0.5)": "Duration(2)"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s"),
    (6, {"Duration(0.1)": "Duration(0.5)", "Duration(0.5), self.slow": "Duration(0.1), self.slow"}, "counter 1 came"),
    (7, {"[3.7, 4.2, 4.7]": "[3.7, 3.7, 3.7]"}, "what a queue of calls would give; there is none"),
    (7, {"[2.7, 2.7, 3.0]": "[2.7, 3.2, 3.7]"}, "what roscpp does"),
    (7, {"[3.7, 4.2, 4.7]": "[3.7, 4.0, 4.5]"}, "it drops ticks and keeps to the grid"),
    (7, {"[2.7, 2.7, 3.0]": "[2.0, 2.5, 3.0]"}, "cannot be called again before it returns"),
    (7, {"[2.7, 2.7, 3.0]": "[2.7, 2.7]"}, "3 times are asked for, not 2"),
    (7, {"[3.7, 4.2, 4.7]": "[1.5 + 2.2, 4.3, 4.8]"}, "tick 5 does not come at 4.3 s"),
    (7, {"[3.7, 4.2, 4.7]": "'3.7, 4.2, 4.7'"}, "a list of three times in seconds, not a value of type `str`"),
    (7, {"[3.7, 4.2, 4.7]": "..."}, "blocked for 2.2 s: there is no prediction yet"),
    (7, {"after_2_2": "after_2"}, "blocked for 2.2 s: there is no prediction yet"),
    (7, {"[3.7, 4.2, 4.7]": "[3,7 4,2 4,7]"}, "line 5 is not Python: invalid syntax. Perhaps you forgot a comma?\n"),
    (7, {"[3.7, 4.2, 4.7]": "[seconds]"}, "NameError: name 'seconds' is not defined` in line 5"),
    (7, {"[3.7, 4.2, 4.7]": "__import__('itertools').count()"}, "3 times are asked for, not 100"),
    (8, {"int(lateness.to_sec() / 0.5)": "lateness.to_sec()"}, "callback 1 printed `missing = 0.0`, but 0 were"),
    (8, {"int(": "round("}, "callback 4 printed `missing = 1`, but 0 were missing"),
    (8, {"event.current_expected": "event.last_real"}, "died of `TypeError"),
    (8, {'"[SPINNER PY NODE] missing = "': '"missing: "'}, "no line with `missing = ` was printed"),
    (
        9,
        {WHILE_LATE: "", SLEEP: f"        try:\n    {SLEEP}\n        except ValueError:\n            pass"},
        "counter 4 came at 1.7 s, not at 2 s",
    ),
    (
        9,
        {WHILE_LATE: "", "time.sleep(deadline - time.monotonic())": "rospy.sleep(deadline - time.monotonic())"},
        "With `_work:=1.7`: counter 4 came at 2.7 s, not at 3 s",
    ),
    (9, {WHILE_LATE: "", "deadline += period": "deadline = time.monotonic() + period"}, "counter 4 came at 2.2 s"),
    (9, {WHILE_LATE: "", SLEEP: "        rospy.sleep(period)"}, "counter 4 came at 2.2 s, not at 2 s"),
]  # fmt: skip


@pytest.mark.parametrize(("number", "wrong", "said"), WRONG)
def test_wrong_answer_is_told_what_is_wrong(number: int, wrong: dict[str, str], said: str) -> None:
    answer = answer_in(CELLS[number][1])
    for old, new in wrong.items():
        assert old in answer
        answer = answer.replace(old, new)
    feedback = check(number, answer)
    assert not feedback.passed
    assert said.lower() in repr(feedback).lower()


def test_two_loops_in_a_row() -> None:
    assert "`[SLOW]`: no counter was printed" in repr(check(6, LOOPS_IN_A_ROW))


def test_every_exercise_has_two_wrong_answers() -> None:
    assert all(sum(number == other for other, _, _ in WRONG) >= 2 for number in NUMBERS)


ENDLESS = "import rospy\nrospy.init_node('n')\nwhile True:\n    pass"


@pytest.mark.parametrize("answer", [None, ..., 0, [], b"x", "", "\0", "def", print])
@pytest.mark.parametrize("number", [3, 7])
def test_no_answer_is_too_strange(number: int, answer: Any) -> None:
    feedback = check(number, answer)
    assert not feedback.passed
    assert feedback.hint
    assert "Wrong: " in repr(feedback)


HOSTILE = """
class Hostile:
    def __iter__(self): raise RuntimeError
    __eq__ = __repr__ = __float__ = __iter__
"""


@pytest.mark.parametrize("value", ["Hostile()", "[Hostile()]", "[[]]", "[float('nan')]", "0", "print", "iter(int, 1)"])
def test_no_prediction_is_too_strange(value: str) -> None:
    assert not check(7, f"{HOSTILE}after_1_2_seconds = after_2_2_seconds = {value}").passed


@pytest.mark.parametrize(
    ("wrong", "hint"),
    [
        ("0.5", "a Duration: rospy.Timer(rospy.Duration(0.5), callback)"),
        ("None", "Pass a timer the callback itself"),
        ("(self)", "A timer passes its callback one argument"),
        ("rospy.log_info", "Python names what it did not find"),
        ("class SpinnerPyNode", "Python could not read the answer"),
        ("    pass", "The node ended by itself"),
        ("    # init_node", 'Call rospy.init_node("a_name")'),
    ],
)
def test_an_error_has_a_hint_of_its_own(wrong: str, hint: str) -> None:
    good = answer_in(CELLS[3][0])
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
    assert hint in check(3, good.replace(right, wrong)).hint


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("x = (1,", "Line 1 is not Python: '(' was never closed"),
        ("(" * 5000, "is not Python"),
        ("import rospy\nx = ...", "There is still a gap, `...`, in line 2"),
        ("import rospy\nrospy.init_node('n')\n1 / 0", "died of `ZeroDivisionError: division by zero` in line 3"),
        (ENDLESS, "simulated time stands still at 0.0 s"),
        ("import rospy\nrospy.init_node('n')\nrospy.Publisher('/a', str)", "rospy.Publisher is not simulated"),
        ("import rospy\nrospy.init_node('n')\nwhile True:\n    rospy.sleep(1)", "did not end at Ctrl-C"),
        ("import sys\nsys.exit(3)", "ended with status 3 instead of 0"),
        ("import no_such_module", "No module named 'no_such_module'"),
        ("raise KeyboardInterrupt", "died of `KeyboardInterrupt` in line 1"),
    ],
)
def test_node_that_cannot_be_checked(answer: str, said: str) -> None:
    feedback = check(1, answer)
    assert not feedback.passed
    assert said in repr(feedback)


def test_a_changed_console_or_namespace_does_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSCONSOLE_FORMAT", "${message}")
    monkeypatch.setenv("ROS_NAMESPACE", "/elsewhere")
    assert check(1, answer_in(CELLS[1][1])).passed


def test_wrong_calls() -> None:
    with pytest.raises(ValueError, match="there is no exercise 99: they are numbered 1 to 9"):
        check(99, "")


def test_notebook_shows_feedback_as_markdown() -> None:
    text = check(7, "after_1_2_seconds = [2.7, 2.7, 3.0]")._repr_markdown_()
    assert text.splitlines()[:3] == [
        "**Exercise 7: not yet.**",
        "",
        "- Right: Blocked for 1.2 s: the ticks come at 2.7 s, 2.7 s, 3 s.",
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
    feedback = shell.run_cell_magic("answer", "2", answer_in(CELLS[2][1]))
    assert feedback.passed
    assert capsys.readouterr().out == "[INFO] [1.500000]: [SPINNER PY NODE] counter = 1\n"


def test_the_magic_counts_as_a_line(shell: InteractiveShell) -> None:
    assert "in line 2." in repr(shell.run_cell_magic("answer", "1", "1 / 0"))


def test_the_magic_cuts_an_endless_console_short(shell: InteractiveShell, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell_magic("answer", "1", "for n in range(1000):\n    print(n)")
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) < 100
    assert lines[-1] == f"... and {1001 - len(lines)} more lines"


@pytest.mark.parametrize("line", ["", "99", "one"])
def test_the_magic_needs_the_number_of_an_exercise(shell: InteractiveShell, line: str) -> None:
    with pytest.raises(UsageError, match="%%answer NUMBER: "):
        shell.run_cell_magic("answer", line, "pass")
