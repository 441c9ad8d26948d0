"""The page's JavaScript without a browser: its types, and what its models promise, in web/test."""

from __future__ import annotations

import subprocess
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

NODE = ROOT / ".venv/bin/node"
TSC = ROOT / "build/npm/node_modules/typescript/bin/tsc"


def test_types() -> None:
    """What the page, a sandbox, its worker and rosspin.page say to each other is typed in protocol.js."""
    run = subprocess.run([NODE, TSC, "--project", ROOT / "web"], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


def test_models(subtests: pytest.Subtests) -> None:
    files = sorted((ROOT / "web/test").glob("*.test.mjs"))
    command: list[str | Path] = [NODE, "--test", "--test-reporter=junit", *files]
    run = subprocess.run(command, capture_output=True, text=True)
    cases = list(ElementTree.fromstring(run.stdout).iter("testcase"))
    assert {Path(case.get("file", "")) for case in cases} == set(files), run.stderr
    for case in cases:
        failure = case.find("failure")
        with subtests.test(f"{Path(case.get('file', '')).stem}: {unescape(case.get('name', ''))}"):
            assert failure is None, failure.text
    assert run.returncode == 0, run.stdout
