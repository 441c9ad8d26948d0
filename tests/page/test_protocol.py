"""What rosspin.page says is what web/src/protocol.js reads, and all of it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from answers import CELLS, answer_in
from listings_in_page import node
from tree import EXAMPLES, ROOT

# The page's Python with nothing around it: jobs in, what the worker would send out, both as lines of JSON.
PYTHON = """
import json, sys
from types import SimpleNamespace
from unittest.mock import MagicMock

sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
sys.modules["js"].performance.now.return_value = 0.0
from rosspin import page

said = []
count = iter(range(10 ** 6))
chunks, ticks = [], []
shown = SimpleNamespace(
    print=lambda text, is_error, line: chunks.append([is_error, text, next(count), line]),
    tick=lambda *tick: ticks.append([*tick, 0]),
)
for job in map(json.loads, sys.stdin):
    kind = job.pop("kind")
    arguments = job | ({"page": shown} if kind == "run" else {})
    made = getattr(page, kind)(**arguments)
    result = {"trace": made} if kind == "trace" else json.loads(made)
    said.append([kind, {"kind": "batch", "chunks": chunks[:], "leftOut": 0, "ticks": ticks[:]}])
    said.append([kind, {"kind": "end", "result": result}])
    chunks.clear(), ticks.clear()
sys.__stdout__.write("\\n".join(map(json.dumps, said)))
"""

READ = f"""
import {{ read }} from "{(ROOT / "web/src/protocol.js").as_uri()}"
import {{ readFileSync }} from "node:fs"
for (const line of readFileSync(0, "utf8").split("\\n")) {{
  const [kind, message] = JSON.parse(line)
  console.log(JSON.stringify(read(JSON.stringify(message), kind)))
}}
"""


def run_job(source: str, args: str = "") -> dict[str, Any]:
    return {"kind": "run", "source": source, "filename": "node.py", "seconds": 2, "args": args, "speed": 0}


SPINNER = (EXAMPLES / "my_robotics_pkg/src/spinner_py_node.py").read_text(encoding="utf-8")
JOBS = {
    "ticks": run_job(SPINNER),
    "no ticks": run_job("print('a')"),
    "a warning": run_job(node("rospy.logwarn('late')")),
    "an error in a thread": run_job(node("rospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)\nrospy.spin()")),
    "an error": run_job("1 / 0"),
    "no Python": run_job("print("),
    "bad arguments": run_job("print(1)", "'"),
    "a first line": run_job(f"%%simulate 1\n{SPINNER}"),
    "an answer": {"kind": "trace", "number": 1, "text": "print(1)"},
    "an answer to nothing": {"kind": "trace", "number": 99, "text": ""},
    "a verdict for no trace": {"kind": "judge", "number": 1, "text": "", "trace": "{"},
}


def said(jobs: list[dict[str, Any]]) -> list[tuple[str, dict[str, Any]]]:
    given = "\n".join(map(json.dumps, jobs))
    run = subprocess.run([sys.executable, "-c", PYTHON], input=given, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


def test_all_that_is_said_is_read(subtests: pytest.Subtests) -> None:
    messages = said(list(JOBS.values()))
    start, right = CELLS[1]
    answers = [f"\n{text}" for text in (answer_in(right), "timer = [0, 1, 2]\n", answer_in(start))]
    traces = said([{"kind": "trace", "number": 1, "text": text} for text in answers])
    found = [result["result"]["trace"] for _, result in traces if result["kind"] == "end"]
    judging = zip(answers, found, strict=True)
    verdicts = said([{"kind": "judge", "number": 1, "text": text, "trace": trace} for text, trace in judging])
    assert [result["result"]["verdict"] for _, result in verdicts[1::2]] == ["solved", "not yet", "open"]

    everything = messages + verdicts
    lines = "\n".join(map(json.dumps, everything))
    command: list[str | Path] = [ROOT / ".venv/bin/node", "--input-type=module", "--eval", READ]
    run = subprocess.run(command, input=lines, capture_output=True, text=True, check=True)
    names = [name for name in [*JOBS, "solved", "not yet", "open"] for _ in range(2)]
    for name, (kind, message), line in zip(names, everything, run.stdout.splitlines(), strict=True):
        with subtests.test(f"{message['kind']}: {name}"):
            read = json.loads(line)
            if message["kind"] == "end" and kind == "run":  # what a run that went wrong leaves out is filled in
                assert read["result"].items() >= message["result"].items()
            else:
                assert read == message
