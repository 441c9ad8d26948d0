"""What rosspin.page says is what web/src/protocol.js reads, and all of it."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from tests.helpers.answers import CELLS, answer_in
from tests.helpers.listings_in_page import node
from tests.helpers.page_python import Message, look_job, run_job, said
from tests.helpers.tree import EXAMPLES, ROOT, TESTS

pytestmark = pytest.mark.shares(3)

READ = f"""
import {{ readFileSync }} from "node:fs"
import {{ read }} from "{(ROOT / "web/src/protocol.js").as_uri()}"
for (const line of readFileSync(0, "utf8").split("\\n")) {{
  const [kind, message] = JSON.parse(line)
  console.log(JSON.stringify(read(JSON.stringify(message), kind)))
}}
"""

PUBLISHER, SUBSCRIBER = (
    (EXAMPLES / f"my_robotics_pkg/src/{name}_py_node.py").read_text(encoding="utf-8")
    for name in ("publisher", "subscriber")
)
SPINNER = (EXAMPLES / "my_robotics_pkg/src/spinner_py_node.py").read_text(encoding="utf-8")
LATE = node("rospy.Timer(rospy.Duration(0.1), lambda event: rospy.sleep(9))\nrospy.spin()")
JOBS = {
    "ticks": run_job(SPINNER),
    "scenes": run_job((EXAMPLES / "executors/own_groups_py_node.py").read_text(encoding="utf-8")),
    "a ring": run_job((EXAMPLES / "hangs/call_py_node.py").read_text(encoding="utf-8")),
    "lost ticks": run_job(LATE),
    "no ticks": run_job("print('a')"),
    "a warning": run_job(node("rospy.logwarn('late')")),
    "an error in a thread": run_job(node("rospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)\nrospy.spin()")),
    "an error": run_job("1 / 0"),
    "no Python": run_job("print("),
    "bad arguments": run_job("print(1)", "'"),
    "a first line": run_job(f"%%simulate 1\n{SPINNER}"),
    "two nodes": run_job(PUBLISHER, "", (SUBSCRIBER, "subscriber.py", "__ns:=/")),
    "an error in the other one": run_job(PUBLISHER, "", ("import rospy\n1 / 0", "subscriber.py", "")),
    "no Python in the other one": run_job(PUBLISHER, "", ("print(", "subscriber.py", "")),
    "a log": look_job((TESTS / "look/recorded/r2_blocks_two.log").read_text(encoding="utf-8")),
    "two counts in one line": look_job((TESTS / "look/recorded/r2_twins.log").read_text(encoding="utf-8")),
    "a log without periods": look_job((TESTS / "look/recorded/r2_events.log").read_text(encoding="utf-8")),
    "a log of more than is drawn": look_job(
        "\n".join(
            f"[INFO] [{1.7e9 + n / 100 + (n % 2 and n**5 % 997 / 1e4):.9f}] [a]: {'hit' if n % 2 else 'odometry'}"
            for n in range(80_000)
        )
    ),
    "no log": look_job("print()"),
    "a bag": look_job("#ROSBAG V2.0"),
    "an answer to nothing": {"kind": "trace", "exercise": "nothing", "text": ""},
    "a verdict on no trace": {"kind": "judge", "exercise": "first-ticks", "text": "", "trace": "{"},
    "hand-ins": {"kind": "read", "files": {"all/a/slow-timer.py": "x = 1", "all/b/slow-timer.py": "", "all/c.pdf": ""}},
    "one that was handed in": {"kind": "answer", "number": 0, "exercise": "slow-timer"},
    "one that is gone": {"kind": "answer", "number": 9, "exercise": "slow-timer"},
    "a table": {"kind": "report", "verdicts": [[0, "slow-timer", "not yet", "late", "a hint"]]},
}


def judging() -> dict[str, Message]:
    """Answers to the first exercise to judge, by their verdicts."""
    start, right = map(answer_in, CELLS["first-ticks"])
    answers = {"solved": right, "not yet": "timer = [0, 1, 2]\n", "open": start}
    given: list[Message] = [
        {"kind": "trace", "exercise": "first-ticks", "text": f"\n{text}"} for text in answers.values()
    ]
    traces = [end["result"] for _, end in said(given)]
    return {
        verdict: job | {"kind": "judge"} | trace for verdict, job, trace in zip(answers, given, traces, strict=True)
    }


def test_all_that_is_said_is_read(subtests: pytest.Subtests) -> None:
    verdicts = judging()
    jobs = JOBS | verdicts
    messages = said(list(jobs.values()))
    lost = messages[list(jobs).index("lost ticks")][1]["result"]["lost"]
    assert lost == [["<lambda>", round(0.1 * number, 9)] for number in range(3, 21)]
    assert [end["result"]["verdict"] for _, end in messages[-3:]] == list(verdicts)
    lines = [json.dumps([job["kind"], one]) for job, both in zip(jobs.values(), messages, strict=True) for one in both]
    command: list[str | Path] = [ROOT / ".venv/bin/node", "--input-type=module", "--eval", READ]
    run = subprocess.run(command, input="\n".join(lines), capture_output=True, text=True, check=True)
    read = map(json.loads, run.stdout.splitlines())
    for (name, job), (batch, end) in zip(jobs.items(), messages, strict=True):
        with subtests.test(name):
            assert next(read) == batch
            found = next(read)
            if job["kind"] in ("run", "look"):  # what one that went wrong leaves out is filled in
                assert found["result"].items() >= end["result"].items()
            else:
                assert found == end
