"""What is installed and run is pinned by its hash: packages, actions of workflows, what makes a release."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
import yaml

from tests.helpers.tree import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS = PROJECT["project"]["optional-dependencies"]
GROUPS = PROJECT["dependency-groups"]
NEEDED = {
    "html": [*PROJECT["project"]["dependencies"], *EXTRAS["docs"], *GROUPS["build"]],
    "lab": [*PROJECT["project"]["dependencies"], *EXTRAS["notebooks"], *GROUPS["build"]],
    "test": [each for extra in ("bags", "docs", "lint", "notebooks", "plot", "test") for each in EXTRAS[extra]],
    "release": [*GROUPS["build"], *GROUPS["release"]],
    "audit": GROUPS["audit"],
    "pins": GROUPS["pins"],
}
FILES = sorted((ROOT / "pins").glob("*.txt"))
WORKFLOWS = sorted([*ROOT.glob(".github/workflows/*.yml"), *ROOT.glob("examples/**/.github/workflows/*.yml")])


def plain(name: str) -> str:
    return re.sub(r"[-_.]+", "-", re.split(r"[^\w.-]", name)[0]).lower()


def pinned(path: Path) -> dict[str, str]:
    """The releases in a file, by name; each stands there with its hashes, and with nothing else."""
    entries = re.split(r"^(?=\S)", path.read_text(encoding="utf-8"), flags=re.M)[1:]
    found = {}
    for entry in entries:
        match = re.fullmatch(r"([\w.-]+)==([^\s;]+)( ; [^\\]*)?((?: \\\n    --hash=sha256:[0-9a-f]{64})+)\n", entry)
        assert match, entry
        found[plain(match[1])] = match[2]
    return found


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_each_release_has_its_hashes_and_no_index_is_named(path: Path) -> None:
    assert pinned(path)
    assert "://" not in path.read_text(encoding="utf-8")


@pytest.mark.parametrize("name", NEEDED)
def test_what_is_asked_for_is_pinned(name: str) -> None:
    assert {plain(each) for each in NEEDED[name]} <= pinned(ROOT / f"pins/{name}.txt").keys()


def test_the_site_and_its_tests_have_the_same_releases() -> None:
    tested = pinned(ROOT / "pins/test.txt").items()
    assert pinned(ROOT / "pins/html.txt").items() <= tested and pinned(ROOT / "pins/lab.txt").items() <= tested


def test_what_makes_the_package_is_pinned() -> None:
    assert PROJECT["build-system"]["requires"] == GROUPS["build"]


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_actions_are_named_by_their_commits(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    used = re.findall(r"uses: *(.*)", text)
    assert used and all(re.fullmatch(r"[\w./-]+@[0-9a-f]{40}  # v[\d.]+", each) for each in used)
    for job in yaml.safe_load(text)["jobs"].values():
        for step in job["steps"]:
            for line in step.get("run", "").splitlines():
                assert (
                    "pip install" not in line
                    or "--require-hashes" in line
                    or "--no-deps" in line
                    or "examples" in str(path)
                )
                assert not re.search(r"\b(pipx|uvx|npx|curl|wget)\b", line)
