"""Code that runs in a page reaches nothing of it, and nothing else runs there: in Chromium, by an adversary's ways."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from benchmarks.in_chromium import launched, served
from rosspin import doctor
from tests.helpers.answers import CELLS, number_of
from tests.helpers.attacks import ATTACK, FORGERIES, SANDBOX, SCRIPT, WAYS, attempts, succeeded, tried
from tests.helpers.floods import SIZE
from tests.helpers.hand_ins import EXERCISE, NO_RUNS, TEACHERS, Table, exchange, handed_in, solves_nothing
from tests.helpers.listings_in_page import OTHER, TIMER, TUTORIAL, Cell, link, open_tutorial
from tests.helpers.looks import faults

pytestmark = pytest.mark.shares(10)


@pytest.fixture(scope="module")
def browser(require: Callable[[str], None]) -> Iterator[Browser]:
    """Chromium as readers have it, with its windows and its compilers."""
    require("browser")
    with launched(doctor.chromium() or "") as browser:
        yield browser


def run(page: Page, index: int, text: str, status: str) -> str:
    """Run a text in place of a listing; the console once the status begins with these words."""
    cell = Cell(page, index)
    cell.write(text)
    cell.run(1)
    return cell.ends(status)


# --- what code in a page reaches --------------------------------------------------------------------------------------


def test_code_reaches_nothing(context: BrowserContext, address: str) -> None:
    """No file or address of the site or of another one, no store, no other page."""
    page = context.new_page()
    asked: list[str] = []
    context.on("response", lambda response: asked.append(response.url))
    context.on("page", lambda other: asked.append(f"stolen: {other.url}"))
    open_tutorial(page, address)
    page.evaluate(
        """async () => {
            window.heard = []
            window.channel = Object.assign(new BroadcastChannel("page"), { onmessage: ({ data }) => heard.push(data) })
            localStorage.setItem("mine", "1")
            await caches.open("mine")
        }"""
    )
    results = tried(run(page, TIMER, attempts(address), "done|error"))
    assert (results.keys(), succeeded(results)) == (WAYS.keys(), {})
    assert not [url for url in asked if "stolen" in url]
    assert page.url == address + TUTORIAL
    assert page.evaluate("heard") == []
    assert page.evaluate("[localStorage.mine, localStorage.a]") == ["1", None]
    assert set(page.evaluate("caches.keys()")) == {"mine", "rosspin"}
    assert page.evaluate("indexedDB.databases()") == []
    assert page.evaluate("navigator.serviceWorker.getRegistrations()") == []
    assert "next" in run(page, OTHER, "print('next')", "done")


def test_two_runs_do_not_hear_each_other(tutorial: Page) -> None:
    listens = (
        "import js, time\nfrom pyodide.ffi import create_proxy\nchannel = js.BroadcastChannel.new('a')\n"
        "channel.onmessage = create_proxy(lambda event: print('heard'))\nprint('listens')\ntime.sleep(20)"
    )
    cell = Cell(tutorial, OTHER)
    cell.write(listens)
    cell.run(20, "real time")
    expect(cell.console).to_contain_text("listens")
    for _ in range(2):
        run(tutorial, TIMER, "import js\njs.BroadcastChannel.new('a').postMessage(1)", "done")
    assert cell.text() == "listens\n"
    cell.button("Stop").click()


# --- the page of a sandbox --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("place", ["popup", "frame", "sandboxed frame", "top"])
def test_page_of_a_sandbox_does_nothing_for_others(
    context: BrowserContext, address: str, tmp_path: Path, place: str
) -> None:
    """From another port of the same computer, which is the same site: as a popup, in a frame, opened as a page."""
    (tmp_path / "index.html").write_text("<!doctype html><title>elsewhere</title>", encoding="utf-8")
    page = context.new_page()
    page.goto(address)
    page.evaluate(
        """async () => {
            window.heard = []
            window.channel = Object.assign(new BroadcastChannel("page"), { onmessage: ({ data }) => heard.push(data) })
            await caches.open("rosspin")
        }"""
    )
    asked: list[str] = []
    context.on("response", lambda response: asked.append(response.url))
    with served(tmp_path) as elsewhere:
        other = context.new_page()
        script = SCRIPT.replace("SITE", address)
        if place == "top":
            other.goto(address + SANDBOX)
            other.evaluate("script => { window.postMessage({ script }, '*'); window.postMessage(script, '*') }", script)
        else:
            other.goto(elsewhere)
            url = address + SANDBOX
            if place == "popup":
                with context.expect_page() as popup:
                    other.evaluate("url => { window.other = open(url, '', 'width=200') }", url)
                popup.value.wait_for_load_state()
            else:
                sandbox = ' sandbox="allow-scripts"' if place == "sandboxed frame" else ""
                other.set_content(f'<iframe src="{url}"{sandbox}></iframe>', wait_until="load")
            other.evaluate(ATTACK, [place, script])
        other.wait_for_timeout(500)
        if place != "sandboxed frame":  # there, a foreign script is as far from the site as on its own page
            assert not [worker.url for found in context.pages for worker in found.workers]
    assert not [url for url in asked if "stolen" in url]
    assert page.evaluate("async () => (await (await caches.open('rosspin')).keys()).map((key) => key.url)") == []
    assert page.evaluate("heard") == []


@pytest.mark.parametrize("name", [TUTORIAL, TEACHERS])
def test_in_a_foreign_frame_a_page_runs_nothing(
    context: BrowserContext, address: str, tmp_path: Path, name: str
) -> None:
    (tmp_path / "index.html").write_text(f'<!doctype html><iframe src="{address}{name}"></iframe>', encoding="utf-8")
    page = context.new_page()
    with served(tmp_path) as elsewhere:
        page.goto(elsewhere)
        inside = page.frame_locator("iframe")
        expect(inside.get_by_text("Shown inside another page, a page cannot").first).to_be_attached()
        expect(inside.get_by_role("button", name="Run", include_hidden=True)).to_have_count(0)
        expect(inside.locator("input[type=file]")).to_have_count(0)


# --- what runs is what was built --------------------------------------------------------------------------------------


def _kept(page: Page) -> str:
    """The SHA-256 of the snapshot that the browser keeps, once there is one."""
    found: str = page.evaluate(
        """async () => {
            const cache = await caches.open("rosspin")
            let kept
            while (!kept) {
                [kept] = await cache.matchAll()
                await new Promise((go) => setTimeout(go, 50))
            }
            const hash = await crypto.subtle.digest("SHA-256", await kept.arrayBuffer())
            return [...new Uint8Array(hash)].map((byte) => byte.toString(16).padStart(2, "0")).join("")
        }"""
    )
    return found


# A frame of zstd's that whoever unpacks it skips, without bytes.
SKIPPED = b"\x50\x2a\x4d\x18" + bytes(4)


def test_a_kept_snapshot_that_was_changed_is_loaded_anew(context: BrowserContext, address: str, site: Path) -> None:
    """One that Python would start from, but that is another one."""
    page = context.new_page()
    open_tutorial(page, address)
    assert run(page, TIMER, "print('first')", "done") == "first\n"
    right = _kept(page)
    page.close()
    page = context.new_page()
    open_tutorial(page, address)
    packed = (site / "_static/live/snapshot.zst").read_bytes() + SKIPPED
    context.route("**/another", lambda route: route.fulfill(body=packed))
    page.evaluate(
        """async () => {
            const cache = await caches.open("rosspin")
            for (const key of await cache.keys()) await cache.put(key, await fetch("/another"))
        }"""
    )
    assert _kept(page) != right
    asked: list[str] = []
    context.on("request", lambda request: asked.append(request.url) if "snapshot.zst" in request.url else None)
    assert run(page, TIMER, "print('again')", "done") == "again\n"
    assert len(asked) == 1
    assert _kept(page) == right


# How many snapshots are kept, once there are so many; it may still be on its way.
KEPT_IN_THE_END = """async wanted => {
    const cache = await caches.open("rosspin")
    const count = async () => (await cache.keys()).length
    for (let n = 0; n < 600 && (await count()) < wanted; n++) await new Promise(go => setTimeout(go, 50))
    return count()
}"""


@pytest.mark.parametrize("name", ["snapshot.zst", "pyodide.asm.wasm", "worker.js"])
def test_a_file_of_the_site_that_was_changed_is_not_used(context: BrowserContext, address: str, name: str) -> None:
    """It is asked for once more; then a line says which it is."""
    asked: list[str] = []

    def change(route: Any) -> None:
        asked.append(route.request.url)
        response = route.fetch()
        route.fulfill(response=response, body=response.body() + b"\n")

    context.route(f"**/live/{name}*", change)
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.button("Run").dispatch_event("click")  # pointing at it would already ask for them
    said = cell.ends("error: Python stopped")
    assert said.startswith(f"The file {name} of this site is not the one that belongs to this page")
    assert len(asked) == 2
    wanted = int(name != "snapshot.zst")
    assert page.evaluate(KEPT_IN_THE_END, wanted) == wanted
    context.unroute(f"**/live/{name}*")
    assert run(page, TIMER, "print('next')", "done") == "next\n"


def test_a_library_that_was_changed_is_not_used(context: BrowserContext, address: str) -> None:
    def change(route: Any) -> None:
        response = route.fetch()
        route.fulfill(response=response, body=response.body()[:-1] + b"\1")

    context.route("**/python_stdlib.zip*", change)
    page = context.new_page()
    open_tutorial(page, address)
    assert "A part of Python could not be loaded from this site" in run(page, TIMER, "import csv", "error")


def test_where_the_browser_has_no_hashes(context: BrowserContext, address: str) -> None:
    """As on plain http, except on one's own computer."""
    context.add_init_script("Object.defineProperty(crypto, 'subtle', { value: undefined }); delete window.caches")
    page = context.new_page()
    wrong = faults(page, address)
    open_tutorial(page, address)
    assert run(page, TIMER, "import csv\nprint('first')", "done") == "first\n"
    assert not wrong


# --- what comes out of a sandbox --------------------------------------------------------------------------------------


def test_no_message_solves_an_exercise(context: BrowserContext, address: str) -> None:
    page = context.new_page()
    page.goto(address + EXERCISE)
    cell = Cell(page, 0)
    for name, text in FORGERIES.items():
        cell.write(f"%%answer first-ticks\n{text}\n")
        cell.button("Run").click()
        cell.ends(f"Exercise {number_of('first-ticks')}: not|error")
        assert page.evaluate("Object.keys(localStorage).filter((key) => key.includes('solved')).length") == 0, name
    cell.write(CELLS["first-ticks"][1].source)
    cell.button("Run").click()
    cell.ends(f"Exercise {number_of('first-ticks')}: right")


def test_no_message_solves_an_exercise_in_the_table(table: Table) -> None:
    """The two that look most like what the table waits for; all of them are in judge/."""
    solves_nothing(table, ["a verdict for a trace", "feedback"])


def test_what_is_said_too_much_ends_a_run(tutorial: Page) -> None:
    for name in ("flood", "huge"):
        assert "it sent more than this page takes" in run(tutorial, TIMER, FORGERIES[name], "error: Python stopped")
    for text in ("[]", '{"kind": "end", "result": {"status": "0"}}', '{"kind": "toString"}', '{"kind": "batch"}'):
        said = run(tutorial, TIMER, f"import js\njs.postMessage({text!r})", "error: Python stopped")
        assert "said what this page does not understand" in said
    printed = run(tutorial, TIMER, "print('x' * 30_000_000)", "done")
    assert len(printed) <= 50_001


def test_memory_of_a_run_is_bounded(tutorial: Page) -> None:
    assert run(tutorial, TIMER, "print(len(bytearray(300_000_000)))", "done") == "300000000\n"
    grows = "kept = []\nwhile True: kept.append(bytearray(10_000_000))"
    assert run(tutorial, TIMER, grows, "error").endswith("MemoryError\n")
    assert run(tutorial, TIMER, "print('next')", "done") == "next\n"


GROWS = """\
#include <ros/ros.h>
#include <thread>
#include <vector>
extern "C" __attribute__((import_module("hasOwnProperty"), import_name("constructor"))) int function_of(int);
int deeper(volatile int depth) { return depth ? deeper(depth + 1) + depth : 0; }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::string what;
  ros::param::get("~what", what);
  if (what == "memory")
    for (std::vector<std::string> kept;;)
      kept.emplace_back(100'000'000, 'x');
  if (what == "recursion")
    return deeper(1);
  if (what == "import")
    return function_of(1);
  if (what == "loop")
    for (;;) {}
  if (what == "words")
    for (std::string line(3000, 'x');;)
      std::puts(line.c_str());
  std::vector<std::thread> threads;
  while (threads.size() < (what == "threads" ? 100'000 : 300))
    threads.emplace_back([] { ros::WallDuration(0.5).sleep(); });
  for (std::thread& each : threads)
    each.join();
  std::printf("%zu threads\\n", threads.size());
}
"""

GROWN = {
    "memory": "terminate called after throwing an instance of 'std::bad_alloc'",
    "recursion": "its stack has overflowed: a function may call itself without an end, in deeper(int)",
    "import": "it calls constructor of hasOwnProperty, which there is not",
    "threads": "what():  Resource temporarily unavailable",
    "words": "xxx",
    "few": "300 threads",
}


def test_what_grows_without_end_in_cpp_ends_its_run(page: Page, address: str) -> None:
    """Where memory, the stack or room for threads ends, or its time, or with Stop; the page runs the next one."""
    page.goto(f"{address}docs/tutorial.html?lang=cpp")
    cell = Cell(page, 0, "div.live.highlight-cpp")
    cell.write(GROWS)
    for what, said in GROWN.items():
        cell.element.get_by_role("textbox", name="Arguments").fill(f"_what:={what}")
        cell.run(1)
        assert said in cell.ends("done" if what in ("words", "few") else "error", 120_000)
        assert cell.element.evaluate(SIZE)[0] <= 100_000
    cell.element.get_by_role("textbox", name="Arguments").fill("_what:=loop")
    cell.run(1)
    cell.button("Stop").click()
    cell.ends("stopped")


# --- code that was received -------------------------------------------------------------------------------------------

ODD = "print('a\u202eb\u2066')  # \u200b\U000e0041\nx = 1" + 200 * " " + "; print('far')\n"
MARKS = ["U+202E", "U+2066", "U+200B", "U+E0041"]


def test_what_is_not_seen_is_marked_in_a_shared_listing(context: BrowserContext, address: str) -> None:
    """What runs is what came."""
    page = context.new_page()
    page.goto(f"{address}{TUTORIAL}?lang=python{link(text=ODD)}")
    cell = Cell(page, TIMER)
    pre = cell.element.locator("pre").first
    expect(pre.locator(".unseen").first).to_be_attached()
    assert pre.text_content() == ODD
    assert pre.locator(".unseen").evaluate_all("all => all.map(mark => mark.dataset.sign)") == MARKS
    assert pre.evaluate("pre => pre.scrollWidth <= pre.clientWidth")
    said = cell.element.locator(".live-notice")
    expect(said).to_contain_text("characters that are not seen or that turn the direction of the text: they are marked")
    expect(said).to_contain_text("Its long lines are wrapped.")
    cell.run(1)
    assert cell.ends("done") == "a\u202eb\u2066\nfar\n"
    cell.button("Edit").click()
    expect(cell.element.locator(".cm-content .unseen")).to_have_text(MARKS)
    cell.button("Reset").click()
    expect(pre.locator(".unseen")).to_have_count(0)


def test_what_is_not_seen_is_marked_in_the_table(context: BrowserContext, address: str, site: Path) -> None:
    failing = NO_RUNS.replace('end({ trace: "" })', "say({ kind: 'failed', reason: 'no\\u202e' })")
    worker = (site / "_static/live/worker.js").read_text(encoding="utf-8")
    exchange(context, site, worker_js=failing.replace("PYTHON", worker).encode())
    table = Table(context.new_page(), address)
    table.drop(eve=handed_in("Eve", answers={"first-ticks": f"%%answer first-ticks\n{ODD}"}))
    table.done()
    said = table.said(f"Eve, exercise {number_of('first-ticks')}: not judged")
    assert "Its long lines are wrapped." in said
    signs = table.detail.locator(".unseen").evaluate_all("all => all.map(mark => mark.dataset.sign)")
    assert signs == ["U+202E", *MARKS]


# --- where it cannot be -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lacking", "said"),
    [
        ("delete window.WebAssembly", "This browser cannot run this listing: it lacks JSPI"),
        ("Object.defineProperty(HTMLIFrameElement.prototype, 'sandbox', { set() {} })", "the browser sandbox frames?"),
    ],
)
def test_what_a_browser_lacks_is_said(context: BrowserContext, address: str, lacking: str, said: str) -> None:
    page = context.new_page()
    page.add_init_script(lacking)
    open_tutorial(page, address)
    if "WebAssembly" in lacking:
        expect(page.locator(".live-missing").nth(TIMER)).to_contain_text(said)
    else:
        assert said in run(page, TIMER, "print(1)", "error: Python stopped")
        assert not page.workers
