"""What is tracked and could go stale: the nodes in the notebooks, their frame of text, and the README's picture."""

from __future__ import annotations

import gzip
import json
import re
from itertools import pairwise
from pathlib import Path

import jupytext
import pytest

from rosspin.run.kinds import written_in
from tests.helpers.built_pages import parsed
from tests.helpers.notebook_nodes import IN_CPP, NODES
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

NOTEBOOKS = sorted(path.stem for path in (ROOT / "notebooks").glob("*.md"))
PATH = {"timer": "rate", "rate": "drift", "drift": "slow-callback", "slow-callback": "two-languages"}
PATH |= {"two-languages": "publish", "publish": "exercises"}
ROS2 = "timer timer-slow rate rate-slow publish executors groups services actions exercises".split()
PATH |= {f"ros2-{name}": f"ros2-{following}" for name, following in pairwise(ROS2)}


def cells(name: str, kind: str) -> list[str]:
    notebook = jupytext.read(ROOT / "notebooks" / f"{name}.md")
    return [cell.source for cell in notebook.cells if cell.cell_type == kind]


@pytest.mark.parametrize("name", NODES)
def test_the_node_is_the_tutorials(name: str) -> None:
    node = (ROOT / "examples" / NODES[name]).read_text(encoding="utf-8")
    first = next(cell for cell in cells(name, "code") if cell.startswith("%%simulate"))
    assert first.partition("\n")[2].strip() == node.strip()


@pytest.mark.parametrize("name", [*NODES, *(f"ros2-{name}" for name in ROS2[:-1])])
def test_each_node_in_python_can_be_run_in_the_page(name: str) -> None:
    notebook = jupytext.read(ROOT / "notebooks" / f"{name}.md")
    nodes = [cell for cell in notebook.cells if cell.cell_type == "code" and cell.source.startswith("%%simulate")]
    assert not [
        cell.source
        for cell in nodes
        if ("live" in cell.metadata.get("tags", [])) == (written_in(cell.source) is not None)
    ]


@pytest.mark.parametrize("name", IN_CPP)
def test_the_node_in_cpp_is_the_tutorials_and_drawn_beside_the_one_in_python(site: Path, name: str) -> None:
    node = (ROOT / "examples" / IN_CPP[name]).read_text(encoding="utf-8")
    [cell] = [cell for cell in cells(name, "code") if written_in(cell)]
    assert cell.partition("\n")[2].strip() == node.strip()
    page = parsed(site / "notebooks" / f"{name}.html")
    [listing] = [pre for pre in page.select("div.cell_input pre") if written_in(pre.get_text())]
    assert listing.select("span.cpf") and listing.find("span", class_="kt", string="int")  # as C++
    block = listing.find_parent("div", class_="cell")
    assert block and "tag_live" not in (block["class"] or ()) and not block.select(".live")
    assert "[SPINNER CPP NODE] counter = 4" in "".join(tag.get_text() for tag in block.select(".cell_output"))
    drawn = [svg["aria-label"] for svg in page.select(".cell_output svg[aria-label]")]
    assert [label for label in drawn if "Python" in label and "C++" in label]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_it_begins_with_what_it_is_for_and_ends_with_where_next(name: str) -> None:
    texts = cells(name, "markdown")
    for promise in ("What you will do", "What you will learn", "What you need", "Time"):
        assert f"**{promise}**" in texts[0]
    assert re.search(r"\d+ (to \d+ )?minutes", texts[0])
    assert texts[-1].startswith("## See also") or "\n## See also\n" in texts[-1]


@pytest.mark.parametrize(("name", "following"), PATH.items())
def test_the_end_names_the_notebook_that_comes_next(name: str, following: str) -> None:
    assert f"]({following}.md)" in cells(name, "markdown")[-1].partition("## See also")[2]


@pytest.mark.parametrize("name", [f"ros2-{name}" for name in ("timer", "timer-slow", "rate-slow", "executors")])
def test_a_quick_check_has_one_right_answer_which_a_run_gives(name: str) -> None:
    """Each answer is folded and says why it is wrong; the cell that follows makes the right one's words from a run."""
    notebook, checks = jupytext.read(ROOT / "notebooks" / f"{name}.md").cells, 0
    for cell, following in pairwise(notebook):
        parts = re.findall(r'<details name="(.+)"><summary>(.+)</summary>\n\n(Yes|No)\. [^<]+', cell.source)
        if cell.cell_type == "markdown" and parts:
            checks += 1
            [right] = [words for _, words, verdict in parts if verdict == "Yes"]
            assert len(parts) >= 3 and len(parts) == cell.source.count("<details name=") and "**Check**:" in cell.source
            assert len({group for group, *_ in parts}) == 1
            assert following.source.startswith("%%facts") and f'== "{right}"' in following.source
    assert checks == 1


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_no_role_stands_as_source_in_jupyterlab(name: str) -> None:
    """Sphinx would turn ``{term}`jitter``` into a link, JupyterLab shows it as it is."""
    assert not re.findall(r"\{[\w:-]+\}`", "\n".join(cells(name, "markdown")))


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_links_lead_to_files_that_jupyterlab_can_open(name: str) -> None:
    links = re.findall(r"\]\(([^)#]*)[^)]*\)", "\n".join(cells(name, "markdown")))
    assert links
    assert not [link for link in links if not (ROOT / "notebooks" / link).is_file()]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_the_page_offers_the_notebook_with_its_outputs(site: Path, name: str) -> None:
    page = (site / "notebooks" / f"{name}.html").read_text(encoding="utf-8")
    [link] = re.findall(r'<a class="reference download internal" download="" href="([^"]*)"', page)
    notebook = json.loads((site / "notebooks" / link).read_text(encoding="utf-8"))
    assert any(cell.get("outputs") for cell in notebook["cells"])


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_its_plots_are_matplotlibs_and_on_the_page_as_svg(site: Path, name: str) -> None:
    """What nothing else can do with them is shown once: limits, a second panel, two runs in one figure, a PDF."""
    notebook = jupytext.read(ROOT / "notebooks" / f"{name}.md")
    shown = [each for each in notebook.cells if "remove-cell" not in each.metadata.get("tags", [])]
    code = "\n".join(each.source for each in shown if each.cell_type == "code")
    page = parsed(site / "notebooks" / f"{name}.html")
    assert not page.select(".cell_output img")
    if "plots." in code:
        assert re.search(r"set_xlim|pyplot\.subplots\(2|plots\.compare|axvline", code)
        outputs = page.select(".cell_output figure.rosspin-plot")
        figures = re.findall(r"^(?:ax = )?plots\.(?!.*ax=)|pyplot\.subplots", code, re.MULTILINE)
        assert len(outputs) >= len(figures) > 0
        for plot in outputs:
            wide, narrow = plot.select(":scope > svg")
            assert wide["aria-label"] == narrow["aria-label"] and len(wide["aria-label"]) > 40
            assert len(gzip.compress(str(plot).encode())) < (30_000 if plot.has_attr("data-positions") else 12_000)
