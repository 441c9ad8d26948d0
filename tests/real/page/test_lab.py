"""`make lab` starts a JupyterLab in which notebooks/*.md open as notebooks. Asked of the real server."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.request import Request, urlopen

import pytest
from playwright.sync_api import BrowserContext, expect

from rosspin.real.ros1 import _free_port
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

TOKEN = "a-token-for-this-test"
PATIENCE = 120  # seconds until a server that does not answer is given up


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a JupyterLab started as a reader starts it, with an empty home.

    VENV and BIN: out of the environment that this test runs in, which make should not rebuild meanwhile.
    """
    port = _free_port()
    home = tmp_path_factory.mktemp("home")
    log = home.with_suffix(".log")
    arguments = f"--no-browser --port={port} --ServerApp.port_retries=0 --IdentityProvider.token={TOKEN}"
    if os.geteuid() == 0:
        arguments += " --allow-root"
    with log.open("w") as output:
        process = subprocess.Popen(
            ["make", "lab", f"ARGS={arguments}", "VENV=", f"BIN={sys.prefix}/bin"],
            cwd=ROOT,
            env=os.environ | {"HOME": str(home)},
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    try:
        address = f"http://127.0.0.1:{port}"
        _wait(process, address, log)
        yield address
    finally:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait(PATIENCE)
    left = {path.name for path in home.iterdir()} & {".ipython", ".jupyter", ".local"}
    assert not left, "JupyterLab wrote into the reader's home"


def _wait(process: subprocess.Popen[bytes], address: str, log: Path) -> None:
    end = time.monotonic() + PATIENCE
    while process.poll() is None and time.monotonic() < end:
        try:
            _ask(address, "api/status")
            return
        except OSError:
            time.sleep(0.1)
    pytest.fail(f"JupyterLab did not start:\n{log.read_text()}")


def _ask(address: str, path: str) -> Any:
    with urlopen(Request(f"{address}/{path}", headers={"Authorization": f"token {TOKEN}"})) as answer:
        return json.load(answer)


def test_markdown_opens_as_a_notebook(lab: str) -> None:
    viewers = _ask(lab, "lab/api/settings/@jupyterlab/docmanager-extension:plugin")["schema"]["properties"]
    assert viewers["defaultViewers"]["default"]["markdown"] == "Jupytext Notebook"


def test_the_viewer_is_there(lab: str) -> None:
    """Jupytext's extension, which brings the viewer of that name, is part of the page that Lab serves."""
    with urlopen(Request(f"{lab}/lab", headers={"Authorization": f"token {TOKEN}"})) as answer:
        assert b"jupyterlab-jupytext" in answer.read()


@pytest.mark.parametrize("name", [path.name for path in sorted((ROOT / "notebooks").glob("*.md"))])
def test_notebook_is_a_notebook(lab: str, name: str) -> None:
    model = _ask(lab, f"api/contents/notebooks/{name}?type=notebook")
    assert model["type"] == "notebook"
    assert {"code", "markdown"} <= {cell["cell_type"] for cell in model["content"]["cells"]}


def test_a_link_opens_the_next_notebook(lab: str, context: BrowserContext) -> None:
    """A plain Markdown link works in JupyterLab, too: there it opens the file, as a notebook."""
    page = context.new_page()
    page.goto(f"{lab}/lab/tree/notebooks/timer.md?token={TOKEN}")
    page.locator(".jp-MarkdownOutput").get_by_role("link", name="Spin in a loop with a rate").click()
    title = page.locator(".jp-Notebook:visible h1")
    expect(title).to_contain_text("Spin in a loop with a rate")


@pytest.mark.parametrize(
    ("name", "picture", "count"),
    [("ros2-executors", "figure.rosspin-scenes li", 15), ("slow-callback", "svg.rosspin-drawing", 1)],
)
def test_pictures_of_the_mechanism_are_outputs(
    lab: str, context: BrowserContext, name: str, picture: str, count: int
) -> None:
    """No directive, which only Sphinx reads, stands as raw text: without the page's script the steps are a list."""
    page = context.new_page()
    page.goto(f"{lab}/lab/tree/notebooks/{name}.md?token={TOKEN}&reset")
    expect(page.get_by_text(re.compile(r"Python 3.* \| Idle"))).to_be_visible()
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    expect(page.locator(f".jp-OutputArea-output {picture}")).to_have_count(count)
    assert not re.search(r"```|:::|\.\. \w+::", page.locator(".jp-Notebook:visible").inner_text())


@pytest.mark.parametrize("theme", ["JupyterLab Light", "JupyterLab Dark"])
def test_a_notebook_runs_and_shows_its_plots(lab: str, context: BrowserContext, theme: str) -> None:
    """As the page does, in the theme's colours, and as wide as there is room."""
    setting = json.dumps({"raw": json.dumps({"theme": theme})}).encode()
    url = f"{lab}/lab/api/settings/@jupyterlab/apputils-extension:themes"
    urlopen(Request(url, setting, {"Authorization": f"token {TOKEN}"}, method="PUT")).close()
    page = context.new_page()
    page.goto(f"{lab}/lab/tree/notebooks/rate.md?token={TOKEN}&reset")
    expect(page.locator(f"body[data-jp-theme-name='{theme}']")).to_be_attached()
    expect(page.locator(".jp-Notebook:visible h1")).to_contain_text("Spin in a loop")
    expect(page.get_by_text(re.compile(r"Python 3.* \| Idle"))).to_be_visible()
    page.get_by_role("menuitem", name="Run", exact=True).click()
    page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
    plots = page.locator(".jp-OutputArea-output figure.rosspin-plot")
    expect(plots).to_have_count(5)
    for index in range(5):
        picture = plots.nth(index).locator("svg[role=img]:visible")
        expect(picture).to_have_count(1)
        colour = picture.locator("text").first.evaluate("text => getComputedStyle(text).fill")
        assert (max(map(int, re.findall(r"\d+", colour)[:3])) > 150) == (theme == "JupyterLab Dark")
        box, place = picture.bounding_box(), plots.nth(index).bounding_box()
        assert box and place and box["width"] > place["width"] - 2 > 400
    assert not page.locator(".jp-OutputArea-output img").count()
    if folder := os.environ.get("ROSSPIN_SHOTS"):
        plots.nth(4).scroll_into_view_if_needed()
        page.screenshot(path=f"{folder}/lab-{theme[11:]}.png")
