"""rosspin.page in CPython: what a sandbox would say of jobs."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

# The page's Python with nothing around it: jobs in, what the worker would send out, both as lines of JSON.
_PYTHON = """
import json, sys
from itertools import count
from types import SimpleNamespace
from unittest.mock import MagicMock

sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
sys.modules["js"].performance.now.return_value = 0.0
from rosspin import page

def blob(data):
    def read(start, end):
        return SimpleNamespace(to_bytes=lambda: data[start:end])
    return SimpleNamespace(size=len(data), read=read)

said = []
for job in map(json.loads, sys.stdin):
    kind = job.pop("kind")
    numbers, chunks, ticks = count(), [], []
    shown = SimpleNamespace(
        print=lambda text, is_error, line: chunks.append([is_error, text, next(numbers), line]),
        tick=lambda *tick: ticks.append([*tick, 0]),
    )
    if kind == "look":
        job["log"] = SimpleNamespace(to_bytes=job["log"].encode)
    if kind == "read":
        given = job.pop("files")
        job |= {"paths": json.dumps([*given]), "files": [blob(text.encode()) for text in given.values()]}
    if kind == "report":
        job["verdicts"] = json.dumps(job["verdicts"])
    made = getattr(page, kind)(**job | ({"page": shown} if kind == "run" else {}))
    result = {"trace": made} if kind == "trace" else json.loads(made)
    said.append([{"kind": "batch", "chunks": chunks, "leftOut": 0, "ticks": ticks}, {"kind": "end", "result": result}])
sys.__stdout__.write("\\n".join(map(json.dumps, said)))
"""

Message = dict[str, Any]


def run_job(source: str, args: str = "", *beside: tuple[str, str, str]) -> Message:
    """A text that is to be run for two seconds, immediately, maybe with others: text, file name, arguments."""
    node = {"source": source, "filename": "node.py", "seconds": 2, "args": args, "speed": 0}
    return {"kind": "run"} | node | {"beside": json.dumps(beside)}


def look_job(log: str) -> Message:
    """A log that is to be looked at."""
    return {"kind": "look", "log": log, "name": "console.txt"}


def said(jobs: list[Message]) -> list[tuple[Message, Message]]:
    """What is said of each job: what it printed and when it ticked, and what came of it."""
    given = "\n".join(map(json.dumps, jobs))
    run = subprocess.run([sys.executable, "-c", _PYTHON], input=given, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return [(batch, end) for batch, end in map(json.loads, run.stdout.splitlines())]
