"""Callbacks of one node never run at the same time: a belief that this reveals."""

from __future__ import annotations

from functools import partial

from .. import judges as by
from ..feedback import Finding
from ..judging import plain, say
from ..observed import ObservedRun

TITLE = "Share data between two callbacks"
TEXT = """
**You need**: [the timer node](timer.md) and [how to share data between callbacks](../docs/how-to/shared-data.rst).

One callback counts a part every 0.1 s; every 0.5 s the other reports how many are new. Each timer of rospy has a thread
of its own, so both can run at the same time, and the reports are wrong.

Report every part exactly once, even if the threads take turns at any point, or a busy computer loses ticks.
"""
REVEALS = "Callbacks of one node never run at the same time. A single line of Python cannot be interrupted."

NODE = """
import rospy


class SpinnerPyNode:
    def __init__(self):
        self.parts = 0
        rospy.Timer(rospy.Duration(0.1), self.countCallback)
        rospy.Timer(rospy.Duration(0.5), self.reportCallback)

    def countCallback(self, event):
        self.parts += 1

    def reportCallback(self, event):
        parts = self.parts
        rospy.sleep(0.05)  # sending the report takes a while
        rospy.loginfo("[SPINNER PY NODE] parts = " + str(parts))
        self.parts = 0


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    spinner_py_node = SpinnerPyNode()
    rospy.spin()
"""

HINTS = [
    "Both are due at 0.5 s. What becomes, at 0.55 s, of what `countCallback` counts while `reportCallback` sleeps?",
    "To reset it before the sleep is not enough: `self.parts += 1` reads, adds, writes, and the other thread may run "
    "in between.",
    "From reading `self.parts` to writing it, the other has to wait. A `threading.Lock` does that.",
    "Make one lock in `__init__`, and write `with self.lock:` in both callbacks.",
]
HINT = "While one callback reads the parts and writes them, the other has to keep away: both need one lock."


def _parts_add_up(run: ObservedRun, when: str) -> Finding:
    """Whether reports every 0.5 s add up to the parts, one every 0.1 s. The newest part may miss the report."""
    start = f"{when}: " if when else ""
    reports = run.values("SPINNER PY NODE", "parts")
    stuck = "Does a callback wait for a lock that is never released, or that it has already?"
    total = 0
    for number in range(1, 11):
        due = 0.5 * number
        if len(reports) < number or reports[number - 1].time > due + 0.1:
            return Finding(False, f"{start}the report due at {say(due)} did not come.", stuck)
        time, text, *_ = reports[number - 1]
        reported = by.as_whole(text)
        if reported is None:
            return Finding(False, f"{start}`parts = {plain(text)}` is not a number of parts.")
        total += reported
        passed = 5 * number
        if total not in (passed - 1, passed):
            wrong = "some are reported twice" if total > passed else "some are lost"
            sums = f"the reports up to {say(time)} add up to {total}, but {passed} parts have passed"
            return Finding(False, f"{start}{sums}: {wrong}.", HINT)
    if len(reports) > 10:
        return Finding(False, f"{start}a report came at {say(reports[10].time)}; it should not have come.")
    return Finding(True, "10 reports came, and they add up to the parts that have passed.")


_COUNTED = "Report what the callback has counted: a tick that is lost counts no part."


def _calls_add_up(run: ObservedRun, when: str, hint: str = _COUNTED) -> Finding:
    """Whether the reports of a node that was held up, and lost ticks, add up to the calls of its callback.

    The callback that counts is the one called most often. Its newest call may miss the report.
    """
    calls = max((timer.calls for timer in run.timers), key=len, default=())
    begun = {timer.number: timer.calls for timer in run.timers}
    total = 0
    for time, text, timer, _ in run.values("SPINNER PY NODE", "parts"):
        total += by.as_whole(text) or 0
        began = max((call for call in begun.get(timer, ()) if call <= time), default=time)
        least = sum(call < began - by.CLOSE for call in calls) - 1
        most = sum(call <= time for call in calls)
        if not least <= total <= most:
            text = f"{when}: the reports up to {say(time)} add up to {total}, but the parts were counted {most} times."
            return Finding(False, text, hint)
    return Finding(True, f"the reports are right as well {when}.")


check = by.until_wrong(
    by.run(5.2, _parts_add_up),
    by.shaken(5, 5.2, _parts_add_up, right="the reports are right as well"),
    by.run(5.2, _calls_add_up, when="when the computer is busy for a while", stalls_at=1.22),
    # A report that is being sent then ends when a part is counted.
    by.shaken(5, 5.2, partial(_calls_add_up, hint=HINT), stalls_at=1.52),
)

SOLUTION = {
    "import rospy\n": "import threading\n\nimport rospy\n",
    "    def __init__(self):\n        self.parts = 0\n": (
        "    def __init__(self):\n        self.parts = 0\n        self.lock = threading.Lock()\n"
    ),
    "        self.parts += 1\n": "        with self.lock:\n            self.parts += 1\n",
    "        parts = self.parts\n": (
        "        with self.lock:\n            parts = self.parts\n            self.parts = 0\n"
    ),
    (
        '        rospy.loginfo("[SPINNER PY NODE] parts = " + str(parts))\n        self.parts = 0\n'
    ): '        rospy.loginfo("[SPINNER PY NODE] parts = " + str(parts))\n',
}
AFTER = """
The solution releases the lock before it sends the report, so that the other callback does not wait.
"""


def parts(count: str, report: str, made: str = "", head: str = "") -> str:
    """A node, by what its callbacks do."""

    def body(text: str) -> str:
        return "\n".join(f"        {line}" for line in text.splitlines())

    return f"""import queue, threading
import rospy
{head}
class Node:
    def __init__(self):
        self.parts = 0
{body(made or "pass")}
        rospy.Timer(rospy.Duration(0.1), self.count)
        rospy.Timer(rospy.Duration(0.5), self.report)
    def count(self, event):
{body(count)}
    def report(self, event):
{body(report)}
rospy.init_node("n")
node = Node()
rospy.spin()
"""


SAY_PARTS = 'rospy.loginfo("[SPINNER PY NODE] parts = " + str(parts))'
TAKE_PARTS = SAY_PARTS.replace("str(parts)", 'str((self.parts, setattr(self, "parts", 0))[0])')
LOCK = "self.lock = threading.Lock()"
LOCKED_COUNT = "with self.lock:\n    self.parts += 1"
LOCKED_REPORT = f"with self.lock:\n    parts = self.parts\n    self.parts = 0\nrospy.sleep(0.05)\n{SAY_PARTS}"

RIGHT = [
    parts(LOCKED_COUNT, LOCKED_REPORT, LOCK.replace("Lock", "RLock")),
    parts(
        LOCKED_COUNT,
        f"with self.lock:\n    parts = self.parts\n    rospy.sleep(0.05)\n    {SAY_PARTS}\n    self.parts = 0",
        LOCK,
    ),
    parts("self.lock.acquire()\ntry:\n    self.parts += 1\nfinally:\n    self.lock.release()", LOCKED_REPORT, LOCK),
    parts(
        "self.queue.put(1)",
        f"parts = 0\nwhile not self.queue.empty():\n    parts += self.queue.get()\nrospy.sleep(0.05)\n{SAY_PARTS}",
        "self.queue = queue.Queue()",
    ),
    parts(
        LOCKED_COUNT,
        f"with self.lock:\n    parts = self.parts\nrospy.sleep(0.05)\n{SAY_PARTS}\n"
        "with self.lock:\n    self.parts -= parts",
        LOCK,
    ),
    parts(
        "with self.turn:\n    self.parts += 1\n    self.turn.notify()",
        LOCKED_REPORT.replace("lock", "turn"),
        "self.turn = threading.Condition()",
    ),
    parts(
        "with lock:\n    self.parts += 1",
        LOCKED_REPORT.replace("self.lock", "lock"),
        head="lock = threading.Semaphore()",
    ),
    # What one thread writes and the other only reads needs no lock.
    parts(
        "self.parts += 1",
        f"now = self.parts\nparts = now - self.told\nself.told = now\n{SAY_PARTS}",
        "self.told = 0",
    ),
]
WRONG = [
    (
        parts(LOCKED_COUNT, LOCKED_REPORT, LOCK + "\nself.parts = 1"),
        "parts have passed: some are reported twice",
        "both need one lock",
    ),
    (
        {"        with self.lock:\n            parts =": "        if True:\n            parts ="},
        "when the threads take turns at every line: the reports up to",
        "both need one lock",
    ),
    (
        {"        with self.lock:\n            self.parts += 1": "        self.parts += 1"},
        "when the threads take turns at every line",
        "both need one lock",
    ),
    (parts("self.parts += 1", f"parts = self.parts\nself.parts -= parts\n{SAY_PARTS}"), "take turns", "one lock"),
    # Here they meet only if the report is late.
    (
        parts(
            LOCKED_COUNT,
            f"with self.lock:\n    parts = self.parts\nrospy.sleep(0.05)\n{SAY_PARTS}\nself.parts -= parts",
            LOCK,
        ),
        "take turns at every line, and the computer is busy for a while",
        "both need one lock",
    ),
    (parts("self.parts += 1", f"parts, self.parts = self.parts, 0\n{SAY_PARTS}"), "take turns", "one lock"),
    (
        parts("with threading.Lock():\n    self.parts += 1", LOCKED_REPORT.replace("self.lock", "threading.Lock()")),
        "take turns",
        "one lock",
    ),
    (
        parts(LOCKED_COUNT, LOCKED_REPORT.replace("self.lock", "self.other"), LOCK + "\nself.other = threading.Lock()"),
        "take turns",
        "one lock",
    ),
    (
        parts("self.lock.acquire()\nself.parts += 1", LOCKED_REPORT, LOCK),
        "report due at 0.5 s did not come",
        "never released",
    ),
    (
        parts(LOCKED_COUNT, f"with self.lock:\n    with self.lock:\n        parts = self.parts\n{SAY_PARTS}", LOCK),
        "the report due at 0.5 s did not come",
        "or that it has already",
    ),
    (
        parts(
            LOCKED_COUNT,
            f"with self.lock:\n    parts = self.parts\nrospy.sleep(0.05)\n{SAY_PARTS}\n"
            "with self.lock:\n    self.parts = 0",
            LOCK,
        ),
        "some are lost",
        "both need one lock",
    ),
    (
        parts(LOCKED_COUNT, f"with self.lock:\n    parts = self.parts\n{SAY_PARTS}", LOCK),
        "reported twice",
        "one lock",
    ),
    (
        parts(
            "with self.lock:\n    parts = self.parts\nwith self.lock:\n    self.parts = parts + 1",
            LOCKED_REPORT,
            LOCK,
        ),
        "take turns",
        "one lock",
    ),
    ({"        self.lock = threading.Lock()\n": ""}, "has no attribute 'lock'", "with its `self.`"),
    # What a callback counts is not what it says.
    (
        {"parts = self.parts\n": "parts = 5\n"},
        "busy for a while: the reports up to",
        "what the callback has counted",
    ),
    (
        parts(
            "self.parts += 1",
            f"now = round(10 * rospy.get_time())\nparts = now - self.told\nself.told = now\n{SAY_PARTS}",
            "self.told = round(10 * rospy.get_time())",
        ),
        "but the parts were counted 14 times",
        "a tick that is lost counts no part",
    ),
    # Read and written within one expression.
    (parts('setattr(self, "parts", self.parts + 1)', TAKE_PARTS), "take turns", "one lock"),
    (parts('self.__dict__.update(parts=self.__dict__["parts"] + 1)', TAKE_PARTS), "take turns", "one lock"),
    (
        parts('(lambda: setattr(self, "parts", 1 + self.__dict__.get("parts")))()', TAKE_PARTS),
        "take turns",
        "one lock",
    ),
]
