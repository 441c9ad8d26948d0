"""The examples for Gradescope, GitHub and nbgrader: what of them can be run here gives the points."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import jupytext
import nbformat
import pytest
import yaml
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

from tests.helpers.answers import CELLS
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

EXAMPLES = ROOT / "examples/grading"
HOW_TO = (ROOT / "docs/how-to/judge-hand-ins.rst").read_text(encoding="utf-8")

RIGHT = CELLS["slow-timer"][1].source
WRONG = "%%answer slow-timer\nafter_1_0_seconds = [1]\n"

ROSSPIN = Path(sys.prefix, "bin/rosspin")


def _handed_in(folder: Path, **answers: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in answers.items():
        (folder / f"{name.replace('_', '-')}.py").write_text(text)


# --- Gradescope -------------------------------------------------------------------------------------------------------


def _graded(root: Path) -> tuple[list[tuple[str, int, int]], dict[str, Any]]:
    """The points in a folder of Gradescope's shape, and all else that is shown there."""
    (root / "venv").symlink_to(sys.prefix)
    subprocess.run([sys.executable, EXAMPLES / "gradescope/run_autograder", root], check=True)
    found = json.loads((root / "results/results.json").read_text())
    return [(test["name"], test["score"], test["max_score"]) for test in found["tests"]], found


def test_gradescope(tmp_path: Path) -> None:
    _handed_in(tmp_path / "submission", slow_timer=RIGHT, two_timers="x = 1", make_it_10_hz="x = (")
    points, found = _graded(tmp_path)
    assert points == [("make-it-10-hz", 0, 1), ("slow-timer", 2, 2)]
    assert "is not Python" in found["tests"][0]["output"]
    assert set(found) == {"output", "stdout_visibility", "tests"}


def test_gradescope_without_an_answer(tmp_path: Path) -> None:
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission/report.pdf").write_text("")
    points, found = _graded(tmp_path)
    assert points == [("make-it-10-hz", 0, 1), ("slow-timer", 0, 2)]
    assert found["output"] == "report.pdf is refused: it is no file of answers."


def test_gradescope_says_why_the_command_failed(tmp_path: Path) -> None:
    (tmp_path / "venv").symlink_to(sys.prefix)
    command = [sys.executable, str(EXAMPLES / "gradescope/run_autograder"), str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and done.stderr.endswith("submission: No such file or directory\n")


def test_gradescope_s_students_do_not_see_that_answers_were_not_sealed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever set the autograder up does: on its output, which is hidden from students."""
    (tmp_path / "venv").symlink_to(sys.prefix)
    _handed_in(tmp_path / "submission", slow_timer=RIGHT)
    command = [sys.executable, str(EXAMPLES / "gradescope/run_autograder"), str(tmp_path)]
    monkeypatch.setenv("PATH", str(tmp_path))  # no bubblewrap
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    results = (tmp_path / "results/results.json").read_text()
    assert "The answers were NOT sealed" in done.stderr and "sealed" not in results
    assert json.loads(results)["stdout_visibility"] == "hidden"


def test_an_answer_writes_no_results_of_gradescope(tmp_path: Path) -> None:
    results = tmp_path / "results/results.json"
    _handed_in(tmp_path / "submission", slow_timer=f"open({str(results)!r}, 'w').write('{{}}')")
    assert _graded(tmp_path)[0][1] == ("slow-timer", 0, 2)


def test_gradescope_s_scripts_can_be_run() -> None:
    assert all(os.access(path, os.X_OK) for path in (EXAMPLES / "gradescope").iterdir())
    subprocess.run(["sh", "-n", EXAMPLES / "gradescope/setup.sh"], check=True)


# --- GitHub -----------------------------------------------------------------------------------------------------------


def test_github_judges_what_a_student_begins_with_and_what_is_right(tmp_path: Path) -> None:
    """Each step that judges, in a student's repository."""
    workflow = yaml.safe_load((EXAMPLES / "github/.github/workflows/judge.yml").read_text())
    steps = {
        step["name"].partition(",")[0]: step["run"] for step in workflow["jobs"]["judge"]["steps"] if "name" in step
    }
    shutil.copytree(EXAMPLES / "github", tmp_path / "spin")
    environment = os.environ | {"PATH": f"{ROSSPIN.parent}{os.pathsep}{os.environ['PATH']}"}
    for written, status in ((0, 1), (1, 0)):
        for name, command in steps.items():
            answer = CELLS[name][written].source.partition("\n")[2].rstrip() + "\n"
            if not written:
                assert (tmp_path / f"spin/{name}.py").read_text() == answer
            (tmp_path / f"spin/{name}.py").write_text(answer)
            assert subprocess.run(["sh", "-c", command], cwd=tmp_path / "spin", env=environment).returncode == status
    assert {path.stem for path in (EXAMPLES / "github").glob("*.py")} == steps.keys()


# --- nbgrader ---------------------------------------------------------------------------------------------------------


def _notebook() -> Any:
    return jupytext.read(EXAMPLES / "nbgrader/answers.md")


def _execute(folder: Path, answer: str) -> None:
    """As nbgrader's autograder does: in the folder of the notebook that was handed in."""
    notebook = _notebook()
    (cell,) = (cell for cell in notebook.cells if cell.source.startswith("%%answer"))
    cell.source = answer
    (folder / "answers.ipynb").write_text(nbformat.writes(notebook))
    NotebookClient(notebook, resources={"metadata": {"path": str(folder)}}, kernel_name="python3").execute()


def test_nbgrader(tmp_path: Path) -> None:
    _execute(tmp_path, RIGHT)
    with pytest.raises(CellExecutionError, match="Exercise .*not yet"):
        _execute(tmp_path, WRONG)


def test_the_notebook_of_nbgrader_has_its_solution_and_a_test_with_points() -> None:
    *_, answer, check = _notebook().cells
    begin, _, rest = answer.source.partition("### BEGIN SOLUTION\n")
    assert begin.startswith("%%answer slow-timer\n") and rest.endswith("### END SOLUTION")
    lines = [line for line in RIGHT.splitlines()[1:] if not line.startswith("#")]
    assert rest.splitlines()[:-1] == lines
    assert "judge" in check.source
    assert check.metadata.nbgrader.grade and check.metadata.nbgrader.points == 2
    nbformat.validate(_notebook())


# --- the page ---------------------------------------------------------------------------------------------------------


def test_the_page_shows_what_is_printed(tmp_path: Path) -> None:
    """Word by word, of the command on the page, typed where the class is."""
    command, *_ = re.findall(r"^   \$ (.*)", HOW_TO, re.MULTILINE)
    (tmp_path / "Downloads/ada").mkdir(parents=True)
    for name, answers in (
        ("Ada", {"slow-timer": RIGHT, "who-calls": CELLS["who-calls"][1].source}),
        ("Ben", {"slow-timer": WRONG}),
    ):
        made = {"format": "rosspin-answers", "version": 2, "name": name, "id": name, "answers": answers}
        (tmp_path / f"Downloads/ada/{name}.json").write_text(json.dumps(made))
    shutil.make_archive(str(tmp_path / "Downloads/answers"), "zip", tmp_path / "Downloads/ada")
    (tmp_path / ".venv/bin").mkdir(parents=True)
    (tmp_path / ".venv/bin/rosspin").symlink_to(ROSSPIN)
    done = subprocess.run(
        ["sh", "-c", command], cwd=tmp_path, env=os.environ | {"HOME": str(tmp_path)}, capture_output=True, text=True
    )
    assert done.returncode == 1
    shown = re.search(r"At the end.*?text\n\n(.*?)\n\n\*What was", HOW_TO, re.DOTALL)
    assert shown and done.stdout.splitlines() == [line[3:] for line in shown[1].splitlines()]
    assert (tmp_path / "table.csv").exists()
