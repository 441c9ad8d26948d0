"""Scenarios run in a page's sandbox, in whatever browser: they print there what they print in simulated time here."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any
from unittest import mock

from rosspin import simulate

from . import corpus_pairs, corpus_ros1, corpus_ros2, expectations
from .corpus import Scenario
from .listings_in_page import lines_of

# A function of that name, which does jobs in one sandbox of those that the page's cells use; what one prints and how it
# ended.
RUN_JOBS = """async ([address, name]) => {
    const { Sandbox } = await import(address)
    window[`end ${name}`]?.()
    const sandbox = new Sandbox()
    await sandbox.started
    window[`end ${name}`] = () => sandbox.end()
    window[name] = job => new Promise(resolve => {
        let console = ""
        sandbox.do({ kind: "run", ...job }, message => {
            if (message.kind === "batch") console += message.chunks.map(([, text]) => text).join("")
            if (message.kind === "end") resolve([console, message.result])
            if (message.kind === "failed") resolve([message.reason, null])
        })
    })
}"""

# Next to the scenarios are modules that they share, and files.
PRELUDE = """
import pathlib
for name, text in {files}.items():
    path = pathlib.Path(name)
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
"""

# Next to the scenarios, by their folders.
BESIDE = {
    corpus_ros1.SCENARIOS: ("scenario.py", "robot/*.py"),
    corpus_ros2.SCENARIOS: ("scenario.py", "*.yaml"),
    corpus_pairs.PAIRS: ("*.py", "robot/*.py"),
}

# A node that runs together with another one: its text, the name of its file, its arguments.
Beside = tuple[str, str, Sequence[str]]

# What a browser's page returns of a JavaScript function that is called with an argument.
Evaluate = Callable[[str, Any], Any]


class Sandbox:
    """Runs texts as nodes in a page; all share one sandbox, in which nodes find what is next to a folder's."""

    def __init__(self, evaluate: Evaluate, address: str, folder: Path) -> None:
        self._evaluate = evaluate
        self._address = address
        self._name = f"run_{folder.name}"
        paths = [path for pattern in BESIDE[folder] for path in folder.glob(pattern)]
        self._files = {str(path.relative_to(folder)): path.read_text(encoding="utf-8") for path in paths}
        self._begin()

    def _begin(self) -> None:
        self._evaluate(RUN_JOBS, [f"{self._address}_static/live/runs.js", self._name])
        console, result = self._do(PRELUDE.format(files=self._files), "prelude.py", 1, (), ())
        assert result is not None, console

    def run(
        self, source: str, name: str, seconds: float, args: Sequence[str], beside: Sequence[Beside] = ()
    ) -> tuple[str, dict[str, Any]]:
        """The console and the result of a text that is run as a node, maybe with others."""
        console, result = self._do(source, name, seconds, args, beside)
        if result is None:  # Python broke down; the next run needs another
            self._begin()
        return console, result or {}

    def _do(
        self, source: str, name: str, seconds: float, args: Sequence[str], beside: Sequence[Beside]
    ) -> tuple[str, dict[str, Any] | None]:
        others = [[text, file, shlex.join(words)] for text, file, words in beside]
        node = {"source": source, "filename": name, "args": shlex.join(args)}
        job = node | {"seconds": seconds, "speed": 0, "beside": others, "programs": [], "files": {}}
        console, result = self._evaluate("([name, job]) => window[name](job)", [self._name, job])
        return console, result

    def differences(self, scenario: Scenario) -> list[str]:
        """What a scenario gives there otherwise than here: text, status, ticks."""
        with mock.patch.dict(os.environ):
            run = simulate(scenario.path, scenario.seconds, scenario.args)
        source = scenario.path.read_text(encoding="utf-8")
        console, result = self.run(source, scenario.path.name, scenario.seconds, scenario.args)
        there = [lines_of(console), result.get("status"), [tick[:4] for tick in result.get("ticks", ())]]
        said = run.console.replace(f"{scenario.path.parent}{os.sep}", "")  # a traceback; in the page it is nowhere else
        here = [lines_of(said), run.status, [list(tick[:4]) for tick in run.ticks]]
        return [f"{other} for {own}" for other, own in zip(there, here, strict=True) if other != own]


def check(sandbox: Sandbox, scenario: Scenario) -> None:
    """A scenario prints the same in the page, has the same ticks and ends with the same status."""
    found = sandbox.differences(scenario)
    is_expected = scenario.name in expectations.differences("page")
    assert bool(found) == is_expected, "\n".join(found) or "the difference that is expected no longer happens"
