"""The planted faults fit the sources: what each takes away is there, once."""

from __future__ import annotations

import ast
import tomllib

import pytest

from tests.helpers.tree import ROOT, TESTS

FAULTS = tomllib.loads((TESTS / "planted/faults.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_can_be_planted(name: str) -> None:
    fault = FAULTS[name]
    assert fault.keys() == {"file", "before", "after", "breaks", "tests"}
    text = (ROOT / fault["file"]).read_text(encoding="utf-8")
    assert text.count(fault["before"]) == 1
    planted = text.replace(fault["before"], fault["after"])
    assert planted != text
    if fault["file"].endswith(".py"):
        ast.parse(planted)


def test_the_likeliest_tests_are_there() -> None:
    for name, fault in FAULTS.items():
        assert fault["tests"] and all(any(TESTS.rglob(f"{stem}.py")) for stem in fault["tests"]), name


def test_the_faults_are_spread_over_the_house() -> None:
    files = [fault["file"] for fault in FAULTS.values()]

    def count(*starts: str) -> int:
        return sum(file.startswith(starts) for file in files)

    assert count("src/rosspin/rospy/") == count("src/rosspin/rclpy/") == 20
    assert count("src/rosspin/clocks/", "src/rosspin/run/process.py") == 10
    assert count("src/rosspin/cpp/") == 58
    assert len(files) == 118
