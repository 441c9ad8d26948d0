"""The examples for Gradescope, GitHub and nbgrader as a teacher uses them, by the commands of the how-to."""

from __future__ import annotations

import csv
import json
import os
import re
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path
from shlex import quote

import pytest
import yaml

from tests.helpers.answers import CELLS
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

EXAMPLES = ROOT / "examples/grading"

COMMANDS = re.findall(
    r"^   \$ (.*)", (ROOT / "docs/how-to/judge-hand-ins.rst").read_text(encoding="utf-8"), re.MULTILINE
)

RIGHT = CELLS["slow-timer"][1].source

OURS = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}


def typed(command: str, folder: Path, **environment: str) -> str:
    """What a command prints, without what of this environment Python would see; skipped without a package index."""
    done = subprocess.run(
        ["bash", "-e", "-c", command], cwd=folder, env=OURS | environment, capture_output=True, text=True
    )
    if "NewConnectionError" in done.stderr:
        pytest.skip("pip can reach no package index")
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def commands(*begins: str) -> list[str]:
    """The commands of the how-to that begin so, in its order."""
    found = [command for command in COMMANDS if command.startswith(begins)]
    assert len(found) == len(begins)
    return found


def tools(folder: Path, **scripts: str) -> Mapping[str, str]:
    """A PATH with these programs, in front of all others."""
    folder.mkdir()
    for name, text in scripts.items():
        (folder / name.replace("_", "-")).write_text(f"#!/bin/sh\n{text}\n")
        (folder / name.replace("_", "-")).chmod(0o755)
    return {"PATH": f"{folder}{os.pathsep}{os.environ['PATH']}"}


def test_gradescope_builds_its_image_and_judges(tmp_path: Path) -> None:
    """Their folder is another one, and what apt-get would install is here."""
    if not shutil.which("zip") or subprocess.run(["git", "rev-parse"], cwd=ROOT, capture_output=True).returncode:
        pytest.skip("git and zip, and a repository, are needed")
    repository = subprocess.run(["git", "rev-parse", "--absolute-git-dir"], cwd=ROOT, capture_output=True, text=True)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    for command in commands("git archive", "zip "):
        typed(command, tmp_path, GIT_DIR=repository.stdout.strip())
    root = tmp_path / "autograder"
    shutil.unpack_archive(tmp_path / "autograder.zip", root / "source")
    path = tools(tmp_path / "bin", apt_get="")
    typed(f"bash source/setup.sh {root}; cp source/run_autograder .; chmod +x run_autograder", root, **path)
    (root / "submission").mkdir()
    (root / "submission/slow-timer.py").write_text(RIGHT)
    typed(f"./run_autograder {root}", root)
    found = json.loads((root / "results/results.json").read_text())
    assert [(test["name"], test["score"]) for test in found["tests"]] == [("make-it-10-hz", 0), ("slow-timer", 2)]


def test_github_s_workflow_judges_what_was_pushed_and_the_teacher_the_clones(tmp_path: Path) -> None:
    """Its steps, in an environment of its own."""
    (tmp_path / ".venv").symlink_to(ROOT / ".venv")
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    copy, wheel = commands("cp -r", ".venv/bin/pip")
    typed(copy, tmp_path)
    typed(wheel.removesuffix(".") + quote(str(ROOT)), tmp_path)
    typed("python3 -m venv github", tmp_path)
    path = {"PATH": f"{tmp_path / 'github/bin'}{os.pathsep}{os.environ['PATH']}"}
    shutil.copytree(tmp_path / "spin-assignment", tmp_path / "clones/ben")
    (tmp_path / "spin-assignment").rename(tmp_path / "clones/ada")
    ada = tmp_path / "clones/ada"
    (ada / "slow-timer.py").write_text(RIGHT.partition("\n")[2])
    workflow = yaml.safe_load((ada / ".github/workflows/judge.yml").read_text())
    install, ten_hertz, slow_timer = (step["run"] for step in workflow["jobs"]["judge"]["steps"] if "run" in step)
    typed(install, ada, **path)
    assert "solved" in typed(slow_timer, ada, **path)
    assert "0 of 1 solved; not yet: make-it-10-hz" in typed(f"! {ten_hertz}", ada, **path)
    said = typed("! .venv/bin/rosspin judge clones --csv table.csv", tmp_path).splitlines()
    assert said[:2] == [
        "ada: 1 of 2 solved; not yet: make-it-10-hz",
        "ben: 0 of 2 solved; not yet: make-it-10-hz; open: slow-timer",
    ]
    rows = list(csv.reader((tmp_path / "table.csv").read_text(encoding="utf-8-sig").splitlines()))
    assert [row[0] for row in rows] == ["name", "ada", "ben"]


def test_nbgrader_makes_the_assignment_and_judges_it(tmp_path: Path) -> None:
    """Where it is installed, with what rosspin asks for: the project does not."""
    nbgrader = shutil.which("nbgrader")
    python = Path(nbgrader).with_name("python") if nbgrader else None
    if python is None or subprocess.run([python, "-c", "import greenlet, yaml"], capture_output=True).returncode:
        pytest.skip("nbgrader, greenlet and PyYAML are not installed beside each other")
    (tmp_path / "rosspin").symlink_to(ROOT)
    here = {"HOME": str(tmp_path), "PYTHONPATH": str(ROOT / "src")}
    folder = tmp_path / "course"
    folder.mkdir()
    make, copy, generate, grade, export = commands(
        "mkdir -p source", "jupytext", "nbgrader gen", "nbgrader auto", "nbgrader export"
    )
    typed(f"{make}; {copy}; {generate}", folder, **here)
    for name, answer in (("ada", RIGHT), ("ben", None)):
        notebook = json.loads((folder / "release/spin/answers.ipynb").read_text())
        (cell,) = (cell for cell in notebook["cells"] if cell["metadata"]["nbgrader"]["grade_id"] == "slow-timer")
        assert cell["source"][0] == "%%answer slow-timer\n" and "2.4" not in "".join(cell["source"])
        cell["source"] = answer or cell["source"]
        (folder / f"submitted/{name}/spin").mkdir(parents=True)
        (folder / f"submitted/{name}/spin/answers.ipynb").write_text(json.dumps(notebook))
    typed(f"{grade}; {export}", folder, **here)
    scores = {row["student_id"]: row["score"] for row in csv.DictReader((folder / "grades.csv").open())}
    assert scores == {"ada": "2.0", "ben": "0.0"}
