"""What the build puts into the pages for what runs there: read from its files, without a browser."""

from __future__ import annotations

import ast
import gzip
import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import pytest
import yaml

from rosspin.site.live import plot, policy
from tests.helpers.attacks import SANDBOX
from tests.helpers.built_pages import parsed
from tests.helpers.figures import FIGURES
from tests.helpers.hand_ins import EXERCISES, TEACHERS
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

PAGES = sorted({kind.page for kind in FIGURES})


def test_pages_without_such_a_listing_load_nothing(site: Path) -> None:
    text = (site / "index.html").read_text(encoding="utf-8")
    assert "live/live" not in text


def snapshot() -> Path:
    """What the site has been built with."""
    (kept,) = ROOT.glob("build/snapshot-*.zst")
    return kept


def build(folder: Path) -> Path:
    """Build what runs in the page, next to a kept snapshot; the folder with it."""
    out = folder / "web" / "live"
    node: list[str | Path] = [ROOT / ".venv/bin/node", "--experimental-wasm-jspi", ROOT / "web/build.mjs"]
    subprocess.run([*node, ROOT / "build/npm", *yaml.__path__, out, "{}"], check=True)
    return out


def zstd(does: str, data: bytes) -> bytes:
    """What Node.js makes of bytes: it compresses or decompresses them."""
    script = f"process.stdout.write(require('zlib').zstd{does}Sync(require('fs').readFileSync(0)))"
    return subprocess.run([ROOT / ".venv/bin/node", "-e", script], input=data, capture_output=True, check=True).stdout


def test_snapshot_is_made_anew_only_when_its_inputs_change(site: Path, tmp_path: Path) -> None:
    """And its address in the pages follows it."""
    kept = zstd("Compress", b"kept")
    (tmp_path / snapshot().name).write_bytes(kept)
    out = build(tmp_path)
    assert (out / "snapshot.zst").read_bytes() == kept
    for folder, data in ((out, kept), (site / "_static/live", snapshot().read_bytes())):
        assert hashlib.sha256(data).hexdigest() in (folder / "runs.js").read_text(encoding="utf-8")


def test_half_a_snapshot_is_made_anew(site: Path, tmp_path: Path) -> None:
    """What a full disk or a kill has left of it."""
    whole = snapshot().read_bytes()
    (tmp_path / snapshot().name).write_bytes(whole[: len(whole) // 2])
    made = (build(tmp_path) / "snapshot.zst").read_bytes()
    assert made == (tmp_path / snapshot().name).read_bytes()
    zstd("Decompress", made)  # which one that is cut cannot be; a page of its memory more or less is filled each time


def without_docstrings(text: str) -> tuple[str, list[tuple[str, int]]]:
    """What a module does, and in which lines."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            if ast.get_docstring(node, clean=False) is not None:
                del node.body[0]
    return ast.dump(tree), [(type(node).__name__, node.lineno) for node in ast.walk(tree) if hasattr(node, "lineno")]


def test_the_page_has_each_module_without_its_docstrings(site: Path) -> None:
    with ZipFile(site / "_static/live/rosspin.zip") as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist() if name.endswith(".py")}
    texts = {name: text for name, text in texts.items() if re.match(r"rosspin/(?!exercises/own/)", name)}
    sources = {name: (ROOT / "src" / name).read_text(encoding="utf-8") for name in texts}
    for name, text in texts.items():
        assert without_docstrings(text) == without_docstrings(sources[name]), name
    assert sum(map(len, texts.values())) < 0.9 * sum(map(len, sources.values()))


def test_plot_of_a_listing_that_says_for_how_long(watchful: None) -> None:
    text = (
        "import rospy\nrospy.init_node('a')\nrospy.Timer(rospy.Duration(rospy.get_param('~p')), print)\nrospy.spin()\n"
    )
    assert "print: 4 ticks" in plot(f"%%simulate 2 -- _p:=0.5\n{text}")
    assert "the first 2 s" in plot(f"%%simulate 2 -- _p:=0.5\n{text}")
    for other in (f"%%answer first-ticks\n{text}", "print(1)\n", "import rospy\n1 / 0\n", "while True: pass", "print("):
        assert plot(other) == ""


def test_the_page_is_interrupted_within_runs_only() -> None:
    """A check runs an answer several times; an interrupt in between, for the watchdog, must not end it."""
    code = """
import signal, sys
from unittest.mock import MagicMock
sys.modules.update({name: MagicMock() for name in ("js", "pyodide", "pyodide.ffi")})
import rosspin.page
assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_every_page_has_its_policy(site: Path) -> None:
    """What may be loaded comes from the site itself; inline scripts are the page's, by their hashes."""
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            text = path.read_text(encoding="utf-8")
            (found,) = re.findall(r'<meta http-equiv="Content-Security-Policy" content="(.*?)"', text)
            assert found == policy(text)
            assert not re.search(r"https?:|\*|'unsafe-eval'|script-src[^;]*'unsafe-inline'", found)
            assert not re.search(r"<[^>]* on[a-z]+=", text), "an inline handler, which the policy forbids"


def test_lock_file_has_no_addresses() -> None:
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    assert "node_modules/pyodide" in lock["packages"]
    assert not [name for name, package in lock["packages"].items() if "resolved" in package]


@pytest.mark.parametrize("name", PAGES)
def test_a_figure_is_small_and_brings_no_script(site: Path, name: str) -> None:
    page = parsed(site / name)
    figures = page.select("figure[data-positions]")
    assert len(figures) == sum(kind.page == name for kind in FIGURES)
    for figure in figures:
        assert len(gzip.compress(str(figure).encode())) < 30_000
        assert not figure.select("script, [onclick], [oninput]")
    policy = str(page.select_one("meta[http-equiv]"))
    assert "script-src 'self' 'wasm-unsafe-eval'" in policy
    assert "unsafe-inline" not in policy.partition("script-src")[2].partition(";")[0]


def test_all_figures_with_a_handle_are_tested(site: Path) -> None:
    pages = {path.relative_to(site).as_posix(): path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert {name for name, text in pages.items() if re.search("<figure [^>]*data-positions=", text)} == set(PAGES)


def test_only_pages_with_such_a_figure_load_the_script(site: Path) -> None:
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            loads = "handles/handles.js" in path.read_text(encoding="utf-8")
            assert loads == (path.relative_to(site).as_posix() in PAGES), path


def test_scenes_are_small_and_a_list_without_the_script(site: Path) -> None:
    """Each with the script and its style: 30 kB at most; only the pages that have some load these."""
    loaded = b"".join((site / f"_static/stepper/{name}").read_bytes() for name in ("steps.js", "stepper.css"))
    found = []
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            text = path.read_text(encoding="utf-8")
            figures = parsed(path).select("figure[data-scenes]") if " data-scenes='" in text else []
            assert ("stepper/steps.js" in text) == bool(figures), path
            found += figures
    assert found
    for figure in found:
        assert len(gzip.compress(str(figure).encode() + loaded)) < 30_000
        carried = json.loads(str(figure["data-scenes"]))
        said = [f"{time:g} s: {said}" for time, said, *_ in carried["steps"]]
        waits = [" ".join(link) for ring in carried["rings"] for link in ring["links"]]
        assert [item.text for item in figure.select("ol > li")] == (said or waits)


def test_policy_of_the_sandbox(site: Path) -> None:
    """It may ask for nothing. There is no other page without the policy of all."""
    text = (site / SANDBOX).read_text(encoding="utf-8")
    (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="(.*?)"', text)
    assert re.fullmatch(r"default-src 'none'; script-src 'sha256-[\w+/=]+' blob: 'wasm-unsafe-eval'", policy)
    pages = {path.relative_to(site).as_posix() for path in (site / "_static").rglob("*.html")}
    assert {name for name in pages if "live" in name or "hand-in" in name} == {SANDBOX}


def test_the_scripts_are_loaded_where_they_are_needed(site: Path) -> None:
    found = {name: set[str]() for name in ("hand-in", "judge")}
    for path in site.rglob("*.html"):
        for name in re.findall(r"hand-in/([\w-]+)\.js", path.read_text(encoding="utf-8")):
            found[name].add(path.relative_to(site).as_posix())
    notebooks = (ROOT / "notebooks").glob("*.md")
    asks = re.compile(r"^%%answer |^```\{exercise\} ", re.MULTILINE)
    asking = {f"notebooks/{path.stem}.html" for path in notebooks if asks.search(path.read_text(encoding="utf-8"))}
    assert EXERCISES in asking
    asking |= {path.relative_to(site).as_posix() for path in site.glob("exercises/*.html")}
    assert found == {"hand-in": asking, "judge": {TEACHERS}}


def test_policy_of_pages_has_no_plug_ins(site: Path) -> None:
    for path in site.rglob("*.html"):
        if "_static" not in path.parts:
            assert "object-src 'none'" in path.read_text(encoding="utf-8"), path
