"""The wheel, installed with what it asks for into a fresh environment, runs a node; and what a release says."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from tree import ROOT

NODE = ROOT / "examples/my_robotics_pkg/src/spinner_py_node.py"
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with the commands of an environment that has the wheel, and nothing else of this one."""
    folder = tmp_path_factory.mktemp("wheel")
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    build = [*pip, "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir", str(folder), str(ROOT)]
    subprocess.run(build, check=True)
    (wheel,) = folder.glob("*.whl")
    assert wheel.name == f"rosspin-{VERSION}-py3-none-any.whl"
    subprocess.run([sys.executable, "-m", "venv", folder / "venv"], check=True)
    install: list[str | Path] = [folder / "venv/bin/pip", "install", "--quiet", "-c", ROOT / "constraints.txt", wheel]
    run = subprocess.run(install, capture_output=True, text=True)
    if "NewConnectionError" in run.stderr:
        pytest.skip("pip can reach no package index")
    assert run.returncode == 0, run.stderr
    return folder / "venv" / "bin"


def _run(folder: Path, *command: str | Path) -> str:
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout + run.stderr


def test_it_runs_a_node_in_a_folder_with_nothing_else(installed: Path, tmp_path: Path) -> None:
    shutil.copy(NODE, tmp_path)
    said = _run(tmp_path, installed / "rosspin", "run", NODE.name, "--simulated", "--seconds", "1")
    assert [line[-11:] for line in said.splitlines()[1:]] == ["counter = 1", "counter = 2"]


def test_it_is_whole(installed: Path, tmp_path: Path) -> None:
    """Each file of the package is in it, among them those that are not Python."""
    where = _run(tmp_path, installed / "python", "-c", "import rosspin; print(*rosspin.__path__)").strip()
    source = ROOT / "src" / "rosspin"
    files = {path.relative_to(source) for path in source.rglob("*") if path.is_file() and path.suffix != ".pyc"}
    assert Path("py.typed") in files
    assert {file for file in files if not (Path(where) / file).is_file()} == set()


def test_the_changelog_begins_with_the_version() -> None:
    headings = re.findall(r"^## (.*)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert headings[0] == VERSION


def test_a_release_is_published_without_a_password() -> None:
    workflow = (ROOT / ".github/workflows/release.yml").read_text(encoding="utf-8")
    assert 'tags: ["v*"]' in workflow and "id-token: write" in workflow and "gh-action-pypi-publish" in workflow
    assert "secrets." not in workflow and "password:" not in workflow
