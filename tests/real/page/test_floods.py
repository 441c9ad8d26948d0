"""However much a run says, or a link or a log holds, the page answers its reader: in Chromium.

What has to be bounded is counted here, so that a busy machine fails no test; web/test counts the rest.
"""

from __future__ import annotations

import base64
import json
import zlib
from typing import Any

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from tests.helpers.floods import AS_MUCH, BATCH, SIZE, TOO_MUCH
from tests.helpers.listings_in_page import OTHER, TIMER, Cell, have_workers, node, open_tutorial
from tests.helpers.log_page import SHOW, LogPage

pytestmark = pytest.mark.shares(10)


def said(page: Page, text: str, status: str, index: int = TIMER) -> str:
    cell = Cell(page, index)
    cell.write(text)
    cell.run(1)
    return cell.ends(status)


@pytest.mark.parametrize("name", TOO_MUCH)
def test_one_message_of_too_much_ends_a_run(tutorial: Page, name: str) -> None:
    text = f"import js\nimport time\njs.postMessage('{TOO_MUCH[name]}')\ntime.sleep(0.5)"
    assert said(tutorial, text, "error: Python stopped") == "It was ended: it sent more than this page takes.\n"


SENDERS = ["js", "js.DedicatedWorkerGlobalScope.prototype", "js.Object.getPrototypeOf(js.self)"]


@pytest.mark.parametrize("sender", SENDERS)
def test_what_is_no_text_is_not_packed(tutorial: Page, sender: str) -> None:
    """Of what is packed, Firefox takes the parts out in the page's own thread, before it can be refused."""
    text = f"""import js, time
from pyodide.ffi import create_proxy
part = js.Object.fromEntries(js.Map.new([["get", create_proxy(lambda *a: print("packed"))], ["enumerable", True]]))
message = js.Object.defineProperty(js.Object.new(), "a", part)
(getattr({sender}, "postMessage", None) or js.postMessage)(message)
time.sleep(0.5)"""
    assert said(tutorial, text, "error: Python stopped") == "It was ended: it sent more than this page takes.\n"


@pytest.mark.parametrize("ticks", ["1e17, 1e17", "1e999, 1", "1, 1e300"])
@pytest.mark.parametrize("kind", ["batch", "end"])
def test_a_time_that_is_none_ends_a_run(tutorial: Page, kind: str, ticks: str) -> None:
    """Before, an axis was drawn to it without end, in the page's own thread."""
    tick = f'["a", 2, {ticks}, 0]'
    result = f'{{"status": 0, "errors": 0, "count": 1, "ticks": [{tick}], "end": 1, "alternative": ""}}'
    message = BATCH.format(chunks="", ticks=tick) if kind == "batch" else f'{{"kind": "end", "result": {result}}}'
    text = f"import js\nimport time\njs.postMessage('{message}')\ntime.sleep(0.5)"
    assert "said what this page does not understand" in said(tutorial, text, "error: Python stopped")


@pytest.mark.parametrize("name", AS_MUCH)
def test_what_is_shown_is_bounded_and_stop_ends_it(tutorial: Page, name: str) -> None:
    cell = Cell(tutorial, TIMER)
    cell.write(AS_MUCH[name])
    cell.run(3000, "real time")
    if name in ("ticks", "rows"):
        expect(cell.element.locator("figure:not(.live-made) figcaption")).to_contain_text("ticks drawn")
    else:
        expect(cell.console.get_by_text("left out")).to_be_visible()
    characters, lines, longest, elements = cell.element.evaluate(SIZE)
    assert characters <= 100_000 and lines <= 1000 and longest <= 2001 and elements <= 8000
    assert characters + elements > 500
    cell.button("Stop").click()
    cell.ends("stopped")
    have_workers(tutorial, 1)  # the next one's


def test_what_is_left_out_is_said(tutorial: Page) -> None:
    cell = Cell(tutorial, TIMER)
    printed = said(tutorial, "print('a')\nprint('x' * 60_000)", "done")
    assert printed.endswith(49_990 * "x" + "\n") and len(printed) < 50_010
    expect(cell.console.get_by_text("left out")).to_be_visible()
    said(tutorial, "for n in range(1005): print(n)", "done")
    expect(cell.console.get_by_text("5 earlier lines are left out.")).to_be_visible()
    said(tutorial, "for n in range(1000): print(n)", "done")
    expect(cell.console.get_by_text("left out")).to_be_hidden()


def test_a_file_that_is_needed_is_given_once(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url) if "python_stdlib" in request.url else None)
    open_tutorial(page, address)
    need = json.dumps({"kind": "need", "name": "python_stdlib.zip"})
    said(page, f"import js\nfor n in range(50): js.postMessage('{need}')", "done")
    said(page, f"import js\nfor n in range(50): js.postMessage('{need}')", "done", OTHER)
    assert len(asked) == 2  # by two runs


# --- what a link holds ------------------------------------------------------------------------------------------------


def log_link(text: str) -> str:
    packed = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = packed.compress(f"a.csv\n{text}".encode()) + packed.flush()
    return f"{SHOW}#log={base64.urlsafe_b64encode(data).decode().rstrip('=')}"


def stamps(*parts: tuple[int, int]) -> str:
    """A table of so many entries at 10 Hz from each of these times (s)."""
    return "".join(
        f"{first + n // 10},{n % 10 * 100_000_000 + 1_000_001},0.5\n" for first, count in parts for n in range(count)
    )


@pytest.mark.parametrize("far", [10**17, 3 * 10**17, 10**12])
def test_a_log_of_many_years_is_refused(page: Page, address: str, far: int) -> None:
    """In a link of 300 characters: before, an axis was drawn to it without end, and nothing had to be clicked."""
    shown = LogPage(page, address)
    page.goto("about:blank")
    page.goto(address + log_link(stamps((1_700_000_000, 60), (far, 9), (3 * far, 9))))
    shown.refuses("years apart, which no clock of ROS can say")


def test_a_log_of_a_long_time_is_drawn(page: Page, address: str) -> None:
    shown = LogPage(page, address)
    page.goto("about:blank")
    page.goto(address + log_link(stamps((1_700_000_000, 60), (1_700_100_000, 60))))
    expect(shown.results).to_be_visible()
    assert page.locator(".look-results svg *").count() < 8000


# --- what is left of a run --------------------------------------------------------------------------------------------

SPINS = """import js
url = js.URL.createObjectURL(js.Blob.new(js.Array.of("onmessage = null; for (;;) {}")))
js.kept = [js.Worker.new(url) for _ in range(5)]
print("started")
"""


def test_what_a_run_has_started_ends_with_it(context: BrowserContext, address: str) -> None:
    """Though the next Python cannot start: before, the last one was kept for that case."""
    page = context.new_page()
    open_tutorial(page, address)
    context.route("**/snapshot.zst*", lambda route: route.fallback())
    cell = Cell(page, TIMER)
    cell.button("Run").hover()
    have_workers(page, 1)
    context.route("**/sandbox.html*", lambda route: route.abort())
    assert said(page, SPINS, "done") == "started\n"
    have_workers(page, 0)
    assert "The frame in which Python runs did not open" in said(page, "print('next')", "error: Python stopped")
    context.unroute("**/sandbox.html*")
    assert said(page, "print('next')", "done") == "next\n"


FORGES = """import js, json
from pyodide.ffi import create_proxy
ticks = [["a", 1, 1, 1, 0]]
result = {"status": 0, "errors": 0, "count": 1, "ticks": ticks, "end": 1, "alternative": "", "test": "import os\\n"}
made = json.dumps({"kind": "end", "result": result})
print("seen")
js.JSON.stringify = create_proxy(lambda message: made)
"""


def test_a_run_does_not_write_its_test(context: BrowserContext, address: str) -> None:
    """The test has what the reader sees: the text that ran, what it printed, when it ticked."""
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    open_tutorial(page, address)
    assert said(page, FORGES, "done: 1 tick") == "seen"
    Cell(page, TIMER).button("Copy as test").click()
    Cell(page, TIMER).ends("the test is copied")
    copied: Any = page.evaluate("navigator.clipboard.readText()")
    names: dict[str, Any] = {}
    exec(copied, names)
    assert names["NODE"] == FORGES
    assert "('a', 1, 1.0, 1.0)" in copied and "'seen'" in copied
    assert not any(line.startswith("import") for line in copied.splitlines())


def test_two_runs_share_no_python(tutorial: Page) -> None:
    assert said(tutorial, "import builtins\nbuiltins.mine = 1\nprint('first')", "done") == "first\n"
    assert said(tutorial, node("import builtins\nprint(hasattr(builtins, 'mine'))"), "done") == "False\n"
