"""Where the site is published is read from the environment, and told: in each page and in a sitemap, or nowhere."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from bs4 import BeautifulSoup

from rosspin.site.published import Published, where
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(5)

PAGES = {"GITHUB_ACTIONS": "true", "GITHUB_REPOSITORY": "Someone/spin"}
READ_THE_DOCS = {"READTHEDOCS": "True", "READTHEDOCS_CANONICAL_URL": "https://spin.example/en/latest/"}


@pytest.mark.parametrize(
    ("environment", "address", "repository"),
    [
        ({}, "", ""),
        ({"GITHUB_REPOSITORY": "Someone/spin"}, "", ""),
        (PAGES, "https://someone.github.io/spin/", "Someone/spin"),
        (PAGES | {"GITHUB_REPOSITORY": "a/a.github.io"}, "https://a.github.io/", "a/a.github.io"),
        (READ_THE_DOCS, "https://spin.example/en/latest/", ""),
        (READ_THE_DOCS | {"READTHEDOCS_GIT_CLONE_URL": "https://github.com/a/b.git"}, None, "a/b"),
        (READ_THE_DOCS | {"READTHEDOCS_GIT_CLONE_URL": "git@github.com:a/b.c.git"}, None, "a/b.c"),
        (READ_THE_DOCS | {"READTHEDOCS_GIT_CLONE_URL": "https://gitlab.com/a/b.git"}, None, ""),
        ({"READTHEDOCS": "True"}, "", ""),
    ],
)
def test_what_the_environment_tells(environment: dict[str, str], address: str | None, repository: str) -> None:
    found = where(environment)
    assert found.repository == repository
    assert address is None or found.address == address


@pytest.mark.parametrize(("address", "path"), [("", "/"), ("https://a.example/", "/"), ("https://a.example/b/", "/b/")])
def test_the_path_of_an_address(address: str, path: str) -> None:
    assert Published(address, "").path == path


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small site, built with this one's settings as on GitHub."""
    folder = tmp_path_factory.mktemp("published")
    for name in ("conf.py", "docs/_static", "docs/_templates"):
        (folder / name).parent.mkdir(exist_ok=True)
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, folder / name)
    for name in ("README.md", "docs/vehicle.svg", "examples/ros2/timer_probe.py"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    (folder / "index.rst").write_text("Spin\n====\n\nOnce a second.\n\n.. toctree::\n\n   docs/page\n")
    (folder / "docs/page.rst").write_text("A page\n======\n\nWhat it says.\n")
    command = [sys.executable, "-m", "sphinx", "-q", "-n", "-W", str(folder), str(folder / "html")]
    subprocess.run(command, env=os.environ | PAGES, check=True)
    return folder / "html"


def _page(site: Path, name: str) -> BeautifulSoup:
    return BeautifulSoup((site / name).read_text(encoding="utf-8"), "html.parser")


def test_each_page_tells_its_address(published: Path) -> None:
    page = _page(published, "docs/page.html")
    (canonical,) = page.select("link[rel=canonical]")
    assert canonical["href"] == "https://someone.github.io/spin/docs/page.html"
    card = {str(tag["property"]): tag["content"] for tag in page.select("meta[property^='og:']")}
    assert card["og:url"] == canonical["href"]
    assert (card["og:title"], card["og:description"], card["og:site_name"]) == ("A page", "What it says.", "rosspin")
    assert page.select_one("meta[name=description]")


def test_a_link_to_a_page_has_a_picture(published: Path) -> None:
    """From the site itself, 1200 by 630 px, with its text alternative."""
    page = _page(published, "docs/page.html")
    card = {str(tag.get("property") or tag.get("name")): tag["content"] for tag in page.select("meta[content]")}
    assert card["og:image"] == "https://someone.github.io/spin/_static/preview.png"
    assert len(card["og:image:alt"]) > 40 and card["twitter:card"] == "summary_large_image"
    png = (published / "_static/preview.png").read_bytes()
    assert png.startswith(b"\x89PNG") and struct.unpack(">II", png[16:24]) == (1200, 630)


def test_each_page_can_be_edited(published: Path) -> None:
    (link,) = _page(published, "docs/page.html").select(".editthispage a")
    assert link["href"] == "https://github.com/Someone/spin/edit/main/docs/page.rst"


def test_the_sitemap_has_the_pages(published: Path) -> None:
    addresses = [tag.text for tag in ElementTree.parse(published / "sitemap.xml").iter() if tag.tag.endswith("}loc")]
    assert addresses == [f"https://someone.github.io/spin/{name}.html" for name in ("docs/page", "index")]


def test_the_page_for_wrong_addresses_knows_the_path(published: Path) -> None:
    page = _page(published, "404.html")
    targets = [str(tag.get("href") or tag.get("src")) for tag in page.select("[href], [src]")]
    assert {target.split("/")[1] for target in targets if not target.startswith(("#", "https:"))} == {"spin"}
    assert "/spin/docs/page.html" in targets and page.html and page.html["data-content_root"] == "/spin/"
