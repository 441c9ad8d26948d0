"""What ``expectations.toml`` says is known to come out now one way, now another, or otherwise than recorded."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from typing import NamedTuple

from .tree import TESTS


class Expectation(NamedTuple):
    """One entry: where it is seen, in which scenarios, what comes out, why, and where to read on."""

    where: str
    outcomes: tuple[str, ...]
    reason: str
    link: str
    scenarios: tuple[str, ...] = ()


def _read() -> dict[str, list[Expectation]]:
    tables = tomllib.loads((TESTS / "expectations.toml").read_text(encoding="utf-8"))
    return {kind: [Expectation(**entry) for entry in entries] for kind, entries in tables.items()}


ALL = _read()


def _by_scenario(kind: str, where: str) -> Mapping[str, Expectation]:
    return {name: entry for entry in ALL[kind] if entry.where == where for name in entry.scenarios}


def differences(where: str) -> Mapping[str, Expectation]:
    """The scenarios that come out otherwise there."""
    return _by_scenario("difference", where)


def races(where: str) -> Mapping[str, Expectation]:
    """The scenarios whose outcome is a race there."""
    return _by_scenario("race", where)


def mishaps(where: str) -> re.Pattern[str]:
    """What the console of a run has that met a race which any node may meet there."""
    found = [outcome for entry in ALL["mishap"] if entry.where == where for outcome in entry.outcomes]
    return re.compile("|".join(found) or "(?!)")
