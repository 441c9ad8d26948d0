"""Which version of the real ROS confirmed each recording, and when. `make judge` writes it.

A scenario whose recording was deleted, because it has changed or the real ROS has, is recorded again there.
"""

from __future__ import annotations

import datetime
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

from rosspin.results.saving import save_whole

from .corpus import Scenario
from .shares import SHARE, is_in
from .tree import TESTS

LEDGER = TESTS / "ledger.toml"

# The real ROS runs one of so many parts of the scenarios in the real lane, and all of them in `make judge`.
SHARES = 20

_HEAD = """# Which version of the real ROS confirmed each recording, and when: written by `make judge`.
# Of races it says how often each outcome has come.
"""


class Confirmed(Protocol):
    """What a recording is of: a scenario, of one process or of several."""

    @property
    def ros(self) -> int: ...
    @property
    def name(self) -> str: ...


class Entry(NamedTuple):
    """What the ledger has of a recording."""

    version: str
    date: datetime.date


class Ledger(NamedTuple):
    """The entries of each ROS by scenario, and how often each outcome of a race has come."""

    entries: dict[int, dict[str, Entry]]
    races: dict[str, list[int]]

    @classmethod
    def read(cls, file: Path = LEDGER) -> Ledger:
        """This checkout's; an empty one if there is none."""
        tables = tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        entries: dict[int, dict[str, Entry]] = {1: {}, 2: {}}
        for batch in tables.get("confirmed", ()):
            entries[batch["ros"]] |= dict.fromkeys(batch["scenarios"], Entry(batch["version"], batch["date"]))
        return cls(entries, tables.get("races", {}))

    def write(self, file: Path = LEDGER) -> None:
        """Write it, in an order that makes for small differences."""
        lines = [_HEAD]
        for ros, entries in self.entries.items():
            for each in sorted(set(entries.values()), key=lambda entry: (entry.date, entry.version)):
                lines.append(f'\n[[confirmed]]\nros = {ros}\nversion = "{each.version}"\ndate = {each.date}\n')
                lines.append("scenarios = [\n")
                lines += [f'  "{name}",\n' for name, entry in sorted(entries.items()) if entry == each]
                lines.append("]\n")
        lines.append("\n[races]\n")
        lines += [f'"{name}" = {counts}\n' for name, counts in sorted(self.races.items())]
        save_whole(file, "".join(lines).encode())

    def confirm(self, scenario: Confirmed, version: str) -> None:
        """Note that the real one has given today what is recorded."""
        self.entries[scenario.ros][scenario.name] = Entry(version, datetime.date.today())


def part(scenarios: Sequence[Scenario], share: int = SHARE) -> list[Scenario]:
    """Those that the real lane runs."""
    return [scenario for scenario in scenarios if is_in(scenario.name, SHARES, share)]
