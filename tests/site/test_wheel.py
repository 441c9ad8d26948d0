"""The wheel has all files of the package; and what a release says."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

from tests.helpers.tree import ROOT
from tests.helpers.wheels import VERSION, built


def test_it_is_whole(tmp_path: Path) -> None:
    """Each file of the package is in it, among them those that are not Python."""
    source = ROOT / "src"
    files = {path.relative_to(source).as_posix() for path in source.rglob("*") if path.is_file()}
    files = {name for name in files if not name.endswith(".pyc")}
    assert "rosspin/py.typed" in files
    with zipfile.ZipFile(built(tmp_path)) as wheel:
        assert files - set(wheel.namelist()) == set()


def test_the_changelog_begins_with_the_version() -> None:
    headings = re.findall(r"^## (.*)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert headings[0] == VERSION


def test_a_release_is_published_without_a_password() -> None:
    workflow = (ROOT / ".github/workflows/release.yml").read_text(encoding="utf-8")
    assert 'tags: ["v*"]' in workflow and "id-token: write" in workflow and "gh-action-pypi-publish" in workflow
    assert "secrets." not in workflow and "password:" not in workflow
