"""rosspin.page in CPython: what a sandbox would say of jobs."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from rosspin.cpp import build
from rosspin.cpp.building import node_command
from rosspin.run.kinds import language_of
from rosspin.site.launched import launched

_BESIDE = Path(__file__).parent / "beside_in_page.mjs"

# The page's Python with nothing around it: jobs in, what the worker would send out, both as lines of JSON.
_PYTHON = """
import base64, json, subprocess, sys
from itertools import count
from types import SimpleNamespace
from unittest.mock import MagicMock

sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
sys.modules["js"].performance.now.return_value = 0.0
sys.modules["pyodide.ffi"].run_sync = lambda promised: promised

class Beside:
    def __init__(self, command):
        self.child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def goOn(self, message):
        print(message, file=self.child.stdin, flush=True)
        return [batch(**each) for each in json.loads(self.child.stdout.readline())]

def batch(text, ticks=""):
    data = base64.b64decode(ticks)
    return SimpleNamespace(text=text, ticks=data and SimpleNamespace(to_bytes=lambda: data))

jobs = [json.loads(line) for line in sys.stdin]
programs = [{name: Beside(command) for name, command in job.pop("programs", {}).items()} for job in jobs]

from rosspin import page  # from then on, there are no processes

def blob(data):
    def read(start, end):
        return SimpleNamespace(to_bytes=lambda: data[start:end])
    return SimpleNamespace(size=len(data), read=read)

said = []
for job, compiled in zip(jobs, programs):
    kind = job.pop("kind")
    numbers, chunks, ticks = count(), [], []
    shown = SimpleNamespace(
        print=lambda text, is_error, line: chunks.append([is_error, text, next(numbers), line]),
        tick=lambda *tick: ticks.append([*tick, 0]),
        program=compiled.get,
    )
    if kind == "look":
        job["log"] = SimpleNamespace(to_bytes=job["log"].encode)
    if kind == "read":
        given = job.pop("files")
        job |= {"paths": json.dumps([*given]), "files": [blob(text.encode()) for text in given.values()]}
    if kind == "report":
        job["verdicts"] = json.dumps(job["verdicts"])
    made = getattr(page, kind)(**job | ({"page": shown} if kind in ("run", "trace") else {}))
    result = {"trace": made} if kind == "trace" else json.loads(made)
    said.append([{"kind": "batch", "chunks": chunks, "leftOut": 0, "ticks": ticks}, {"kind": "end", "result": result}])
sys.__stdout__.write("\\n".join(map(json.dumps, said)))
"""

Message = dict[str, Any]


def run_job(source: str, args: str = "", *beside: tuple[str, str, str]) -> Message:
    """A text to run for two seconds, immediately, maybe with others: text, file name, arguments."""
    node = {"source": source, "filename": "node.py", "seconds": 2, "args": args, "speed": 0}
    return {"kind": "run"} | node | {"beside": json.dumps(beside), "files": "{}"}


def together_job(*nodes: Path) -> Message:
    """Node files, in Python or compiled to C++, to run together for two seconds."""
    text, *others = [(node.read_text(encoding="utf-8"), node.name, "") for node in nodes]
    return run_job(text[0], "", *others) | {"filename": text[1], "programs": _programs(nodes)}


def _programs(nodes: Iterable[Path]) -> dict[str, list[str]]:
    command = [*node_command(), str(_BESIDE)]
    return {node.name: [*command, str(build(node).program)] for node in nodes if language_of(node.name)}


def launch_job(launch: Path) -> Message:
    """A launch file to run for two seconds."""
    name, files, folder = launched(launch)
    texts = {path: (folder / path).read_text(encoding="utf-8") for path in files}
    job = run_job(texts[name]) | {"filename": name, "files": json.dumps(texts)}
    return job | {"programs": _programs(folder / path for path in files)}


def look_job(log: str) -> Message:
    """A log to look at."""
    return {"kind": "look", "log": log, "name": "console.txt"}


def said(jobs: list[Message]) -> list[tuple[Message, Message]]:
    """What is said of each job: what it printed and when it ticked, and what came of it."""
    given = "\n".join(map(json.dumps, jobs))
    run = subprocess.run([sys.executable, "-c", _PYTHON], input=given, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return [(batch, end) for batch, end in map(json.loads, run.stdout.splitlines())]
