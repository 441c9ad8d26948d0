"""Which recording was confirmed by which version of the real ROS, and when; and which scenarios have changed since.

A recording is stale once its key is another one: its scenario or the harness has changed, or the text itself. The real
ROS runs a part of the scenarios each time: those that a change touches, known by hash, and a twentieth of the others.
"""

from __future__ import annotations

import ast
import datetime
import hashlib
import re
import tomllib
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple, Protocol

from corpus import Scenario
from shares import SHARE, is_in
from tree import SOURCE, TESTS

from rosspin.results.saving import save_whole

LEDGER = TESTS / "ledger.toml"

# What renews a recording.
RENEW = ".venv/bin/pytest tests/real/judge/test_corpus.py -k ros{0.ros}-{0.name}"

# Of those that a change touches so many (of each ROS) are run each time, with those of the share.
MOST = 12
SHARES = 20

_HEAD = """# Which recording was confirmed by which version of the real ROS, and when: written by `make judge`.
# The first hash is of the scenario, the harness, the version and the recording, the second of what of the stand-in the
# scenario concerns. Of races it says how often each outcome has come.
"""


class Confirmed(Protocol):
    """What a recording is of: a scenario, of one process or of several."""

    @property
    def ros(self) -> int: ...
    @property
    def name(self) -> str: ...
    @property
    def args(self) -> Sequence[object]: ...
    @property
    def seconds(self) -> float: ...
    @property
    def sources(self) -> Sequence[Path]: ...
    @property
    def harness(self) -> Path: ...
    @property
    def recordings(self) -> Sequence[Path]: ...


class Entry(NamedTuple):
    """What the ledger has of a recording."""

    key: str
    stand_in: str
    version: str
    date: datetime.date


class Ledger(NamedTuple):
    """The entries of each ROS by scenario, and how often each outcome of a race has come."""

    entries: dict[int, dict[str, Entry]]
    races: dict[str, list[int]]

    @classmethod
    def read(cls, file: Path = LEDGER) -> Ledger:
        """The one of this checkout; an empty one if there is none."""
        tables = tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        entries: dict[int, dict[str, Entry]] = {1: {}, 2: {}}
        for batch in tables.get("confirmed", ()):
            for name, hashes in batch["hashes"].items():
                key, stand_in = hashes.split()
                entries[batch["ros"]][name] = Entry(key, stand_in, batch["version"], batch["date"])
        return cls(entries, tables.get("races", {}))

    def write(self, file: Path = LEDGER) -> None:
        """Write it, in an order that makes for small differences."""
        lines = [_HEAD]
        for ros, entries in self.entries.items():
            for date, version in sorted({(entry.date, entry.version) for entry in entries.values()}):
                lines.append(f'\n[[confirmed]]\nros = {ros}\nversion = "{version}"\ndate = {date}\n')
                lines.append("[confirmed.hashes]\n")
                lines += [
                    f'{name} = "{entry.key} {entry.stand_in}"\n'
                    for name, entry in sorted(entries.items())
                    if (entry.date, entry.version) == (date, version)
                ]
        lines.append("\n[races]\n")
        lines += [f'"{name}" = {counts}\n' for name, counts in sorted(self.races.items())]
        save_whole(file, "".join(lines).encode())

    def confirm(self, scenario: Confirmed, version: str) -> None:
        """Note that the real one has given today what is recorded."""
        row = Entry(key(scenario, version), stand_in(scenario), version, datetime.date.today())
        self.entries[scenario.ros][scenario.name] = row

    def is_stale(self, scenario: Confirmed) -> bool:
        """Whether the recording of a scenario is not what the real one gave with this scenario and this harness."""
        entry = self.entries[scenario.ros].get(scenario.name)
        return entry is None or entry.key != key(scenario, entry.version)

    def is_touched(self, scenario: Confirmed, version: str) -> bool:
        """Whether anything that it concerns has changed since the real one confirmed it."""
        entry = self.entries[scenario.ros].get(scenario.name)
        return entry is None or entry[:2] != (key(scenario, version or entry.version), stand_in(scenario))


def key(scenario: Confirmed, version: str) -> str:
    """The hash of a scenario, what it is run with, and what was recorded."""
    what = (scenario.args, scenario.seconds, version)
    files = [*scenario.sources, *_harness(scenario), *scenario.recordings]
    return _hash([repr(what), *map(_text, files)])


def _harness(scenario: Confirmed) -> list[Path]:
    """What shapes the run of any scenario: what stands beside it and is none, and what starts it and keeps the text."""
    folder = scenario.sources[0].parent
    beside = [path for path in folder.glob("*/*.py") if path.parent.name != "recorded"]
    return [scenario.harness, folder / "scenario.py", *sorted(beside), *sorted(folder.glob("*.yaml"))]


def stand_in(scenario: Confirmed) -> str:
    """The hash of what of the stand-in a scenario names, of clocks and of what runs nodes on the real one."""
    package = SOURCE / "rosspin"
    text = "".join(map(_text, scenario.sources))
    words = set(re.findall(r"\w+", text))
    concerned = [path for path in _modules(package / _STAND_INS[scenario.ros]) if words & _names(path)]
    has_messages = re.search(r"^(import|from) \w+_(msgs|srvs)", text, re.M)
    messages = _modules(package / "messages") if has_messages else ()
    runner = package / "real" / "children.py", package / "real" / f"ros{scenario.ros}.py"
    return _hash(map(_text, (*concerned, *messages, *_modules(package / "clocks"), *runner)))


_STAND_INS = {1: "rospy", 2: "rclpy"}


def _modules(package: Path) -> Sequence[Path]:
    return sorted(package.glob("*.py"))


@cache
def _names(module: Path) -> frozenset[str]:
    """What a module defines for nodes: functions, classes and their methods."""
    found = (node for node in ast.walk(ast.parse(_text(module))) if isinstance(node, ast.FunctionDef | ast.ClassDef))
    return frozenset(node.name for node in found if not node.name.startswith("_"))


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def _hash(texts: Iterable[str]) -> str:
    found = hashlib.sha256()
    for text in texts:
        found.update(text.encode() + b"\0")
    return found.hexdigest()[:12]


def part(scenarios: Sequence[Scenario], version: str) -> tuple[list[Scenario], int]:
    """Those to run this time, and how many that a change touches have to wait for `make judge`.

    ``version`` is that of the real ROS here, which may be another one than that of the recordings; "" if there is none.
    """
    ledger = Ledger.read()
    own = [scenario for scenario in scenarios if is_in(scenario.name, SHARES, SHARE)]
    touched = [scenario for scenario in scenarios if ledger.is_touched(scenario, version)]
    others = [scenario for scenario in touched if scenario not in own]
    most = max(0, MOST - (len(touched) - len(others)))
    begin = SHARE * MOST % (len(others) or 1)
    chosen = {*own, *(others[begin:] + others[:begin])[:most]}
    return [scenario for scenario in scenarios if scenario in chosen], max(0, len(others) - most)
