"""The sessions for teachers as slides: keys, notes, what runs and moves on them, and that all of it can be seen."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, Page, ViewportSize, expect

from benchmarks.in_chromium import served
from tests.helpers.author import copied, typed
from tests.helpers.axe import COLOURS, violations
from tests.helpers.listings_in_page import Cell
from tests.helpers.looks import faults, look
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

DECKS = ["ros2", "ros1"]

SIZES = [ViewportSize(width=1280, height=720), ViewportSize(width=1920, height=1080)]

NOW = ".now"

# What does not fit on the slide that is shown; a box that scrolls by itself is none of it.
OVER = """() => {
    const slide = document.querySelector(".now")
    const over = slide.scrollHeight > slide.clientHeight || slide.scrollWidth > slide.clientWidth
    return over ? [`${slide.id}: ${slide.scrollWidth} x ${slide.scrollHeight}`] : []
}"""

# Lettering that the last row cannot read (px): less than a fortieth of the height.
SMALL = """() => {
    const small = (element, scale) => parseFloat(getComputedStyle(element).fontSize) * scale < innerHeight / 41
    const drawn = [...document.querySelectorAll(".now > figure svg[role=img] text")].filter(text =>
        text.getBoundingClientRect().width && small(text, text.getScreenCTM().a))
    const written = [...document.querySelectorAll(".now > :is(h1, h2, p, ul, ol) , .now pre")].filter(element =>
        element.getBoundingClientRect().width && small(element, 1))
    return [...drawn, ...written].map(element => element.textContent.slice(0, 40))
}"""


def opened(page: Page, address: str, deck: str, size: ViewportSize = SIZES[0]) -> int:
    """Show a deck from its first slide; the number of its slides."""
    page.set_viewport_size(size)
    page.goto(f"{address}docs/slides/{deck}.html")
    sections = page.locator("article > section > section").count()
    page.get_by_role("link", name="Show as slides").click()
    expect(page.get_by_role("navigation", name="Slides").get_by_role("status")).to_have_text(f"1 of {sections + 1}")
    return sections + 1


def place(page: Page) -> str:
    return page.get_by_role("navigation", name="Slides").get_by_role("status").inner_text()


@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size['width']}")
@pytest.mark.parametrize("deck", DECKS)
def test_each_slide_fits_and_can_be_read(page: Page, address: str, deck: str, size: ViewportSize) -> None:
    """And axe-core finds nothing on it, in light; a dark one has its contrasts."""
    found = {}
    number = opened(page, address, deck, size)
    look(page, "light")
    for index in range(number):
        assert place(page) == f"{index + 1} of {number}"
        expect(page.locator(f"{NOW} :is(h1, h2)")).to_be_visible()
        assert page.locator(".rosspin-notes:visible").count() == 0
        seen = page.evaluate(OVER) + page.evaluate(SMALL)
        if size == SIZES[0]:
            seen += violations(page)
            look(page, "dark")
            seen += violations(page, COLOURS)
            look(page, "light")
        found[index] = seen
        page.keyboard.press("PageDown")
    assert not {index: what for index, what in found.items() if what}


def test_keys_go_on_and_back(page: Page, address: str) -> None:
    number = opened(page, address, "ros2")
    for key, at in [
        *(("PageDown", 2), ("ArrowRight", 3), ("ArrowLeft", 2), ("PageUp", 1), ("PageUp", 1)),
        *(("End", number), ("PageDown", number), ("Home", 1)),
    ]:
        page.keyboard.press(key)
        assert place(page) == f"{at} of {number}"
    page.keyboard.press("n")
    assert place(page) == f"1 of {number}"
    for _ in range(4):
        page.keyboard.press("PageDown")
    page.reload()
    assert place(page) == f"5 of {number}"


def test_the_contents_lead_to_each_slide(page: Page, address: str) -> None:
    number = opened(page, address, "ros1")
    page.get_by_role("button", name="Contents").click()
    listed = page.get_by_role("dialog", name="Contents").get_by_role("listitem")
    assert listed.count() == number
    page.keyboard.press("PageDown")
    assert violations(page) == []
    listed.nth(6).get_by_role("button").click()
    expect(page.get_by_role("dialog")).to_have_count(0)
    assert place(page) == f"7 of {number}"
    page.get_by_role("link", name="Leave").click()
    expect(page.get_by_role("link", name="Show as slides")).to_be_visible()


@pytest.mark.parametrize("deck", DECKS)
def test_a_listing_runs_and_a_figure_moves(page: Page, address: str, deck: str) -> None:
    """A key that a clicker sends leads on even from the handle; the arrows move it."""
    opened(page, address, deck)
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    cell = Cell(page, 0)
    cell.run(2)
    assert "counter = 4" in cell.ends("done: 4 ticks")
    expect(cell.console).to_be_in_viewport(ratio=1)
    expect(cell.plot).to_be_in_viewport(ratio=1)
    assert page.evaluate(OVER) == []
    cell.button("Edit").click()
    cell.editor.press("PageDown")
    assert place(page).startswith("3 of")
    cell.editor.press("Escape")
    page.keyboard.press("PageDown")
    page.keyboard.press("PageDown")
    figure = page.locator(f"{NOW} figure[data-positions]")
    figure.get_by_role("slider").press("ArrowRight")
    expect(figure.locator("b")).to_have_text("0.55 s")
    assert page.evaluate(OVER) + page.evaluate(SMALL) == []
    assert place(page).startswith("5 of")
    figure.get_by_role("slider").press("PageDown")
    assert place(page).startswith("6 of")


@pytest.mark.parametrize(
    ("deck", "lines"), [("ros2", ["self.create_timer(", "rclpy.spin("]), ("ros1", ["rospy.Timer("])]
)
def test_the_lines_that_matter_are_seen_and_all_are_printed(
    page: Page, address: str, deck: str, lines: list[str]
) -> None:
    opened(page, address, deck)
    page.keyboard.press("PageDown")
    page.keyboard.press("PageDown")
    for line in lines:
        expect(page.locator(f"{NOW} .hll", has_text=line).first).to_be_in_viewport()
        where = page.locator(f"{NOW} .hll", has_text=line).first.bounding_box()
        box = page.locator(f"{NOW} .live pre").first.bounding_box()
        assert (
            where
            and box
            and box["y"] <= where["y"] + 1
            and where["y"] + where["height"] <= box["y"] + box["height"] + 1
        )
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 1280, "height": 720})
    assert page.evaluate(OVER) == []
    assert page.locator(f"{NOW} .live pre").first.evaluate("pre => pre.scrollHeight <= pre.clientHeight + 1")


def test_the_speaker_s_window_follows_and_leads(context: BrowserContext, page: Page, address: str) -> None:
    opened(page, address, "ros2")
    page.keyboard.press("PageDown")
    with page.expect_popup() as popup:
        page.get_by_role("button", name="Notes").click()
    notes = popup.value
    wrong = faults(notes, address)
    expect(notes.get_by_role("navigation", name="Slides")).to_be_visible()
    expect(notes.locator(".rosspin-notes:visible")).to_contain_text("Hands up for each answer")
    expect(notes.get_by_text("Next: Run it")).to_be_visible()
    expect(notes.get_by_text(re.compile("^0 min gone; this slide: 2 to 6 of 90 min$"))).to_be_visible()
    assert violations(notes) == []
    page.keyboard.press("PageDown")
    expect(notes.locator("h2:visible")).to_contain_text("Run it")
    notes.keyboard.press("PageDown")
    expect(page.locator(f"{NOW} h2")).to_contain_text("In pairs")
    assert not wrong


@pytest.mark.parametrize("deck", DECKS)
def test_on_paper_each_slide_is_a_sheet(page: Page, address: str, deck: str) -> None:
    number = opened(page, address, deck)
    pdf = page.pdf(prefer_css_page_size=True, print_background=True)
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == number
    assert re.search(rb"/MediaBox\s*\[0 0 (?:960|959\.\d+) 540\b", pdf)


# --- a notebook -------------------------------------------------------------------------------------------------------

NOTEBOOK = """---
slides: true
jupytext: {text_representation: {extension: .md, format_name: myst}}
kernelspec: {display_name: Python 3, language: python, name: python3}
---

# A timer in class

```{notes}
:minutes: 1

Say *hello*.
```

## Run it

```{code-cell} ipython3
:tags: [remove-cell]

%load_ext rosspin
```

```{code-cell} ipython3
:tags: [live]

%%simulate 2
import rospy

rospy.init_node("n")
rospy.Timer(rospy.Duration(0.5), lambda event: print("tick", event.current_expected.to_sec()))
rospy.spin()
```

```{notes}
:minutes: 3

Who calls the callback?
```

## What it gave

```{code-cell} ipython3
sum(range(9))
```

## Move it

```{ticks} ../examples/my_robotics_pkg/src/spinner_py_node.py
:seconds: 2
:handle: Time delta, 0.1 to 1 by 0.05 s
:sets: timer_delta_t_in_seconds
```
"""


@pytest.fixture(scope="module")
def notebook(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site with a notebook that is marked, beside few other pages."""
    tree = copied(tmp_path_factory.mktemp("deck"), ["docs/glossary.rst"])
    for folder in ("notebooks", "build"):
        (tree / folder).mkdir(exist_ok=True)
    (tree / "notebooks/deck.md").write_text(NOTEBOOK)
    (tree / "build/web").symlink_to(ROOT / "build/web")
    with open(tree / "index.rst", "a") as index:
        index.write("   notebooks/deck\n")
    run = typed("make html", tree)
    assert run.returncode == 0, run.stdout + run.stderr
    return tree / "build/html"


def test_a_notebook_becomes_slides(context: BrowserContext, notebook: Path) -> None:
    """What its cells gave is there, a cell runs, and a figure moves."""
    page = context.new_page()
    with served(notebook) as address:
        wrong = faults(page, address)
        page.set_viewport_size(SIZES[0])
        page.goto(f"{address}notebooks/deck.html")
        page.get_by_role("link", name="Show as slides").click()
        assert place(page) == "1 of 4"
        expect(page.locator(".rosspin-notes")).to_have_count(2)
        assert page.locator(".rosspin-notes:visible").count() == 0
        page.keyboard.press("PageDown")
        cell = Cell(page, 0)
        cell.element.get_by_role("combobox").select_option("instantly")
        cell.button("Run").click()
        assert "tick 2" in cell.ends("done: 4 ticks")
        for part in (cell.console, cell.plot):
            expect(part).to_be_in_viewport(ratio=1)
        assert page.evaluate(OVER) == []
        page.keyboard.press("PageDown")
        expect(page.locator(f"{NOW} .cell_output")).to_contain_text("36")
        page.keyboard.press("PageDown")
        figure = page.locator(f"{NOW} figure[data-positions]")
        figure.get_by_role("slider").press("ArrowRight")
        expect(figure.locator("b")).to_have_text("0.55 s")
        assert page.evaluate(OVER) + page.evaluate(SMALL) == []
        with page.expect_popup() as popup:
            page.get_by_role("button", name="Notes").click()
        for at in ("4 of 4", "3 of 4"):
            expect(popup.value.get_by_role("status")).to_have_text(at)
            popup.value.keyboard.press("PageUp")
        expect(popup.value.locator(".rosspin-notes:visible")).to_contain_text("Who calls the callback?")
        assert not wrong
