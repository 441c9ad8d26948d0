"""The tasks in which an answer steers the vehicle: what is right, and what is said of what looks right."""

from __future__ import annotations

import re
import sys
import warnings

import pytest

from rosspin.exercises import check, judge, trace, verdict
from rosspin.exercises.own import FAULTS, Answer, Lesson
from tests.helpers.answers import TASKS
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

NAMES = ["follow-the-line", "lose-the-line", "look-while-driving", "stop-when-blind", "stop-at-ctrl-c"]
NAMES += ["share-the-wheel"]
FOLLOW = TASKS[0]


def cases(kind: str) -> list[object]:
    return [
        pytest.param(task, answer, id=f"{task.exercise.name} {number}")
        for task in TASKS
        for number, answer in enumerate(getattr(task, kind), 1)
    ]


def test_the_tasks_come_in_their_order() -> None:
    assert [task.exercise.name for task in TASKS] == NAMES and FAULTS == []
    assert all(task.exercise.ros == 2 for task in TASKS)


def test_the_notebook_has_them_in_that_order() -> None:
    notebook = (ROOT / "notebooks/drive.md").read_text(encoding="utf-8")
    assert re.findall(r"^%answer (\S+)$", notebook, re.MULTILINE) == NAMES


@pytest.mark.parametrize("task", TASKS, ids=NAMES)
def test_each_has_right_answers_in_odd_style_and_wrong_ones_that_look_right(task: Lesson) -> None:
    assert len(task.right) >= 4 and len(task.wrong) >= 5 and len(task.hints) >= 2
    assert not check(task.exercise.name, task.node).passed


@pytest.mark.parametrize(("task", "answer"), cases("right"))
def test_what_keeps_the_vehicle_in_hand_is_right(task: Lesson, answer: Answer) -> None:
    feedback = check(task.exercise.name, task.written(answer))
    assert feedback.passed, feedback


@pytest.mark.parametrize(("task", "wrong"), cases("wrong"))
def test_a_wrong_answer_is_told_what_is_wrong_with_it(task: Lesson, wrong: tuple[Answer, str]) -> None:
    answer, said = wrong
    feedback = check(task.exercise.name, task.written(answer))
    assert not feedback.passed and said in str(feedback), feedback


def test_the_drive_is_judged_where_nothing_of_the_answer_runs() -> None:
    name, answer = FOLLOW.exercise.name, FOLLOW.written(FOLLOW.right[0])
    traced = trace(name, answer)
    feedback = judge(name, answer, traced)
    assert feedback == check(name, answer)
    off = verdict(name, answer, traced).off
    assert off == round(feedback.drive.worst.off, 3) and off > 0


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"Twist()": "Twist"}, "stopped"),
        ({"x = 2.0": 'x = "2.0"'}, "Assertion"),
        ({"2.0  # m/s": "float('nan')"}, "speed of 0: the vehicle never moved"),
        ({"2.0  # m/s": "1e300"}, "keeps to its line"),
        ({'super().__init__("driver_py_node")': 'super().__init__("vehicle")'}, "keeps to its line"),
        ({"self.offset  #": "float('inf')  #"}, "leaves its line"),
        ({"from geometry_msgs.msg import Twist": "from geometry_msgs.msg import Vector3 as Twist"}, "stopped"),
    ],
)
def test_whatever_is_sent_is_judged(changed: dict[str, str], said: str) -> None:
    answer = FOLLOW.written(FOLLOW.right[0])
    for old, new in changed.items():
        assert old in answer
        answer = answer.replace(old, new)
    assert said in str(check(FOLLOW.exercise.name, answer))


def test_another_type_on_the_topic_does_not_reach_the_vehicle() -> None:
    answer = FOLLOW.written(FOLLOW.right[0]).replace("import Twist", "import Accel as Twist")
    said = str(check(FOLLOW.exercise.name, answer))
    assert "did not reach the vehicle" in said and "takes messages of the type `Twist`" in said


def test_an_executor_of_one_thread_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(warnings, "showwarning", lambda message, *more: sys.stderr.write(f"{message}\n"))
    name = "look-while-driving"
    task = next(task for task in TASKS if task.exercise.name == name)
    answer = task.written(task.right[0]).replace("MultiThreadedExecutor(2)", "MultiThreadedExecutor(1)")
    assert "The executor has one thread, as its warning says" in check(name, answer).hint


def test_near_the_limit_a_longer_period_can_be_better() -> None:
    task = next(task for task in TASKS if task.exercise.name == "lose-the-line")
    drives = [check("lose-the-line", task.node.replace("0.5, self", f"{period}, self")).drive for period in (0.3, 0.32)]
    assert drives[1].worst.off < drives[0].worst.off < 0.25
