"""What contributors are told is true: files, commands, targets and hooks are there."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from tests.helpers.tree import ROOT, TESTS

pytestmark = pytest.mark.shares(3)

GUIDE = ROOT / ".github/CONTRIBUTING.md"
TEXTS = [GUIDE, ROOT / ".github/CODE_OF_CONDUCT.md", ROOT / ".github/pull_request_template.md"]
TEXTS += sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.md"))
TEXT = GUIDE.read_text(encoding="utf-8")
CODE = re.findall(r"`([^`\n]+)`", TEXT) + re.findall(r"(?m)^\$ (.+)", TEXT)


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.name)
def test_links_lead_to_files(path: Path) -> None:
    for target in re.findall(r"\]\(([^)]+)\)", path.read_text(encoding="utf-8")):
        assert target.startswith("https://") or (path.parent / target).exists(), target


def test_files_are_where_they_are_said_to_be() -> None:
    named = [text for text in CODE if re.fullmatch(r"tests(/[\w.]+)+", text)]
    assert len(named) >= 4
    assert [text for text in named if not (ROOT / text).exists()] == []
    assert (TESTS / "scenarios/scenario.py").exists() and (TESTS / "scenarios_ros2/scenario.py").exists()


def test_targets_of_make_are_there() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = {word for text in CODE if "make " in text for word in re.findall(r"make ([a-z]\w*)", text)}
    assert targets == {"html", "test", "ros1", "ros2", "judge", "outputs"}
    assert all(re.search(rf"(?m)^{target}\b.*:", makefile) for target in targets)


@pytest.mark.parametrize("command", [text for text in CODE if text.startswith(".venv/bin/pytest ")])
def test_commands_of_pytest_find_tests(command: str) -> None:
    _, path, *_ = shlex.split(command)
    found = [sys.executable, "-m", "pytest", "--collect-only", "-q", "-p", "no:cacheprovider", path]
    run = subprocess.run(found, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


def test_make_judge_takes_the_corpus_and_the_real_lane_once() -> None:
    (command,) = re.findall(
        r'(?m)^judge:.*\n\t"\$\(BIN\)/pytest" (.+) \$\(ARGS\)$', (ROOT / "Makefile").read_text("utf-8")
    )
    collect = [sys.executable, "-m", "pytest", *command.split(), "--collect-only", "-q", "-k", "timer_blocked_once"]
    first = {**os.environ, "ROSSPIN_SHARE": "0"}  # the share in which one of those is
    run = subprocess.run([*collect, "-p", "no:cacheprovider"], cwd=ROOT, capture_output=True, text=True, env=first)
    found = [line for line in run.stdout.splitlines() if "::" in line]
    assert {"tests/real/judge", "tests/real"} <= {test.rpartition("/")[0] for test in found}, run.stdout
    assert len(found) == len(set(found))


def test_hooks_are_what_make_test_runs_and_their_tools_are_there() -> None:
    (repo,) = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8"))["repos"]
    assert repo["repo"] == "local"  # whose versions are those in pins/
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for hook in repo["hooks"]:
        tool, *arguments = hook["entry"].split()
        assert (ROOT / tool).exists()
        assert hook["id"] == "tsc" or f'"$(BIN)/{hook["id"]}"' in makefile
        if hook["id"] == "tsc":
            assert (ROOT / arguments[0]).exists()


def test_templates_name_themselves() -> None:
    for path in (ROOT / ".github/ISSUE_TEMPLATE").glob("*.md"):
        _, front, _ = path.read_text(encoding="utf-8").split("---\n", 2)
        assert set(yaml.safe_load(front)) == {"name", "about"}
