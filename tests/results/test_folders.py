"""Temporary folders: what a killed process leaves is removed by the next one, and nothing else is."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from rosspin.results.folders import TemporaryFolder, sweep
from tests.helpers.tree import ROOT

OWNER = """
import sys
from rosspin.results.folders import TemporaryFolder
folder = TemporaryFolder()
(folder.path / "sub").mkdir()
(folder.path / "sub" / "file").write_text("x")
print(folder.path, flush=True)
sys.stdin.read()
"""


@pytest.fixture(autouse=True)
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    return tmp_path


def test_a_folder_is_there_while_its_process_lives_and_gone_after_the_next_start(temporary: Path) -> None:
    with subprocess.Popen([sys.executable, "-c", OWNER], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as owner:
        assert owner.stdout
        folder = Path(owner.stdout.readline().decode().strip())
        sweep()
        assert (folder / "sub/file").exists() and folder.parent == temporary
        owner.kill()
    assert folder.exists()
    sweep()
    assert not folder.exists()


def test_an_own_folder_stays_until_it_is_left() -> None:
    with TemporaryFolder() as folder:
        sweep()
        assert folder.path.is_dir()
    assert not folder.path.exists()


def test_what_is_not_known_to_be_such_a_folder_stays(temporary: Path) -> None:
    (temporary / "rosspin-notes").mkdir()
    (temporary / "rosspin-notes/text").write_text("mine")
    (temporary / "elsewhere").mkdir()
    (temporary / "elsewhere/.owner").touch()
    (temporary / "rosspin-link").symlink_to(temporary / "elsewhere")
    (temporary / "rosspin-file").touch()
    sweep()
    assert len(list(temporary.iterdir())) == 4 and (temporary / "elsewhere/.owner").exists()


def test_whatever_is_in_a_folder_it_is_removed() -> None:
    """Folders that are deeper than Python's stack or a path, or closed to their owner; what links lead to stays."""
    before = os.open(".", os.O_RDONLY)
    with TemporaryFolder() as other, TemporaryFolder() as folder:
        (other.path / "mine").touch()
        os.chdir(folder.path)
        try:
            for _ in range(3000):
                os.mkdir("d")
                os.chdir("d")
            os.symlink(other.path, "link")
            Path("closed").mkdir()
            Path("closed/x").touch()
            os.chmod("closed", 0)
            folder.path.chmod(0)
        finally:
            os.fchdir(before)
            os.close(before)
        folder.remove()
        assert not folder.path.exists() and (other.path / "mine").exists()


def test_nothing_else_makes_a_folder_that_a_kill_would_leave() -> None:
    """But for a scratch that is left at once (``with tempfile.TemporaryDirectory``), of what is compiled."""
    texts = {path: path.read_text(encoding="utf-8") for path in (ROOT / "src").rglob("*.py")}
    assert [path.name for path, text in texts.items() if "mkdtemp" in text] == ["folders.py"]


DEEP = """
import os
from rosspin.results.folders import TemporaryFolder
folder = TemporaryFolder()
os.chdir(folder.path)
for _ in range(1500):
    os.mkdir("d")
    os.chdir("d")
os._exit(0)
"""
SWEEP = "from rosspin.results.folders import sweep; sweep()"


def test_folders_deeper_than_python_goes_do_not_stop_the_next_run(temporary: Path) -> None:
    for code in (DEEP, SWEEP):
        subprocess.run([sys.executable, "-c", code], check=True)
    assert list(temporary.iterdir()) == []
