"""The site as one zip."""

from __future__ import annotations

import re
from pathlib import Path
from zipfile import ZipFile

import pytest

from rosspin.site.zipped import zipped
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

START = ROOT / "docs/start-here.html"


def test_the_same_site_gives_the_same_zip(tmp_path: Path) -> None:
    """Whenever its files were written, in whatever order, and whoever may read them."""
    for order, folder in enumerate(("one", "two")):
        for name in ["b.html", "a/c.js"][:: 1 - 2 * order]:
            path = tmp_path / folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(name)
            path.chmod(0o600 + 0o44 * order)
        (tmp_path / folder / ".buildinfo").write_text(folder)
        size = zipped(tmp_path / folder, START, tmp_path / f"{folder}.zip")
        assert size == (tmp_path / f"{folder}.zip").stat().st_size
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()
    with ZipFile(tmp_path / "one.zip") as archive:
        assert archive.testzip() is None
        names = ["START-HERE.html", "site/a/c.js", "site/b.html"]
        assert archive.namelist() == [f"rosspin-site/{name}" for name in names]
        assert {info.date_time for info in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_nothing_of_the_site_is_left_out(site: Path, tmp_path: Path) -> None:
    zipped(site, START, tmp_path / "site.zip")
    with ZipFile(tmp_path / "site.zip") as archive:
        names = {name.removeprefix("rosspin-site/site/") for name in archive.namelist()}
    files = {path.relative_to(site).as_posix() for path in site.rglob("*") if path.is_file()}
    assert files - names <= {".buildinfo", ".buildinfo.bak"}


@pytest.mark.parametrize("browser", ["Chrome", "Firefox", "Safari"])
def test_the_start_page_names_the_browsers_of_the_first_page(browser: str) -> None:
    named = [
        re.findall(rf"{browser}\s+(?:or\s+Edge\s+)?(\d+)", path.read_text(encoding="utf-8"))
        for path in (START, ROOT / "index.rst")
    ]
    assert named[0] == named[1] != []
