"""A reader shows a log: it is read in the page, what was found is shown, and nothing else happens."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from tests.helpers.axe import in_both_schemes
from tests.helpers.log_page import SHOW, LogPage
from tests.helpers.looks import FAINT, SCHEMES, TOO_WIDE, look
from tests.helpers.readers import reader
from tests.helpers.tree import TESTS

pytestmark = pytest.mark.shares(10)

LOGS = TESTS / "look/recorded"
SLEEPS = (LOGS / "r1_sleep_10_work_20.log").read_text(encoding="utf-8")
HEALTHY = (LOGS / "r2_timer_10.log").read_text(encoding="utf-8")

FAULTS = {
    "a healthy timer": "As it should be (likely)",
    "a sleep after the work": "A sleep of fixed length after the work (likely)",
    "a slow neighbour": "A slow callback that blocks its neighbours (sure)",
}


@pytest.fixture
def shown(page: Page, address: str) -> LogPage:
    return LogPage(page, address)


def test_examples(shown: LogPage, address: str, site: Path) -> None:
    """Each shows what it is called, with a page that explains it, which is there."""
    for name, title in FAULTS.items():
        shown.press(name)
        shown.shows(title)
        link = shown.results.get_by_role("link", name="What explains it").first.get_attribute("href") or ""
        path, _, label = link.removeprefix(address).partition("#")
        assert not label or f'id="{label}"' in (site / path).read_text(encoding="utf-8")
    table = shown.results.get_by_role("region", name="What repeats")
    expect(table.get_by_role("row", name="base: odometry: # 296 25 Hz 40 ms none 18.6 ms 90")).to_be_visible()
    expect(shown.results.get_by_role("img", name="Lateness of base: battery: #")).to_be_visible()
    expect(shown.results.get_by_role("img", name="Timeline from")).to_be_visible()


def test_the_part_that_is_shown_moves_by_the_keys(shown: LogPage) -> None:
    shown.press("a slow neighbour")
    shown.shows("A slow callback")
    slider = shown.results.get_by_role("slider")
    timeline = shown.results.get_by_role("img", name="Timeline from")
    expect(timeline).to_have_attribute("aria-label", re.compile(r"base: odometry: #: \d+ came, 9 missing\."))
    slider.press("Home")
    expect(timeline).to_have_attribute("aria-label", re.compile("^Timeline from 0.00 s to 1.71 s"))
    slider.press("ArrowRight")
    expect(timeline).to_have_attribute("aria-label", re.compile("^Timeline from 0.43 s to 2.14 s"))


def test_drop_choose_and_paste(shown: LogPage) -> None:
    shown.drop(("console.txt", SLEEPS))
    shown.shows("console.txt: ")
    expect(shown.status).to_contain_text("A sleep of fixed length after the work")
    file = LOGS / "r2_timer_10.log"
    shown.page.get_by_label("Drop a log anywhere").set_input_files(file)
    shown.shows("As it should be")
    shown.text.fill(SLEEPS)
    shown.press("Look at this text")
    shown.shows("the pasted text: ")
    shown.drop(("a.log", SLEEPS), ("b.log", HEALTHY))
    shown.refuses("Give one log at a time.")


def test_what_is_pasted_is_read_at_once(context: BrowserContext, shown: LogPage) -> None:
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    shown.page.evaluate("text => navigator.clipboard.writeText(text)", HEALTHY)
    shown.text.press("Control+v")
    shown.shows("the pasted text: 107 entries in 10.6 s. As it should be")


def test_what_is_no_log_gets_a_line(shown: LogPage) -> None:
    times = "1 2 3\n" * 50
    binary = [number % 256 for number in range(5000)]
    files: list[tuple[tuple[str, list[int] | str], str]] = [
        (("a.bin", binary), "a.bin: this is no text: give it a console log"),
        (("a.bag", "#ROSBAG V2.0\n"), "a.bag: this is a bag, which is read on your computer only: rosspin look FILE."),
        (("a.txt", times), "a.txt: no line has a time stamp."),
        (("empty.txt", ""), "empty.txt: the file is empty."),
        (("<img src=x onerror=alert(1)>.txt", "x"), "<img src=x onerror=alert(1)>.txt: no line has a time stamp."),
    ]
    for file, said in files:
        shown.drop(file)
        shown.refuses(said)
    shown.text.fill(" ")
    shown.press("Look at this text")
    shown.refuses("Paste a log first.")
    assert not shown.page.locator("img[src=x]").count()


def test_other_encodings_and_times_that_go_back(shown: LogPage) -> None:
    shown.drop(("utf16.txt", list(HEALTHY.encode("utf-16"))))
    shown.shows("utf16.txt: 107 entries")
    shown.drop(("latin.txt", list(HEALTHY.replace("wheel", "Räder").encode("latin-1"))))
    shown.shows("latin.txt: 107 entries")
    expect(shown.results).to_contain_text("Räder")
    shown.drop(("back.txt", (LOGS / "r2_clock_back.log").read_text(encoding="utf-8")))
    shown.shows("The clock was set")


def test_of_a_long_log_the_beginning_is_read(shown: LogPage) -> None:
    """200 MB, of which the browser reads no more than it needs."""
    shown.page.evaluate(
        """log => {
            const files = new DataTransfer()
            const filling = new Blob(Array(200).fill("no time stamp here\\n".repeat(55_000)))
            files.items.add(new File([log, filling], "big.log"))
            window.dispatchEvent(new DragEvent("drop", { dataTransfer: files, cancelable: true }))
        }""",
        HEALTHY,
    )
    shown.shows("big.log: 107 entries")
    expect(shown.results).to_contain_text("Only the first 5 MB were read; rosspin look FILE reads more.")
    shown.press("Copy a link to this")
    expect(shown.results).to_contain_text("The log was cut off, so it is too long for a link.")


def test_what_a_log_says_is_text(shown: LogPage) -> None:
    evil = "<script>document.title = 'stolen'</script><img src=x onerror=\"document.title = 'stolen'\">"
    lines = [f"[INFO] [{1.7e9 + n / 10:.9f}] [a]: {evil} {n}" for n in range(40)]
    shown.drop(("a.log", "\n".join(lines)))
    shown.shows("As it should be")
    expect(shown.results).to_contain_text("a: <script>document.title = 'stolen'</script>")
    shown.press("Make it a test")
    expect(shown.results).to_contain_text("self.get_logger().info(f'<script>")
    assert not shown.page.locator(".rosspin-look script, .rosspin-look img[src]").count()
    assert "stolen" not in shown.page.title()


def test_a_log_in_a_link(context: BrowserContext, shown: LogPage, address: str) -> None:
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    shown.drop(("my log.txt", SLEEPS))
    shown.shows("my log.txt: ")
    shown.press("Copy a link to this")
    expect(shown.results).to_contain_text("The link is copied. The whole log is in it")
    link = shown.page.evaluate("navigator.clipboard.readText()")
    assert link.startswith(f"{address}{SHOW}#log=") and len(link) < len(SLEEPS)
    other = context.new_page()
    other.goto(link)
    expect(other.get_by_text("This log came with the link that you opened.")).to_be_visible()
    expect(other.locator(".rosspin-look > [role=status]")).to_contain_text("my log.txt: ")
    expect(other.locator(".look-results")).to_be_visible()
    expect(other.get_by_label("Or paste it here")).to_have_value(SLEEPS)


def test_a_link_that_is_broken_or_too_long(shown: LogPage, address: str) -> None:
    shown.page.goto(f"{address}{SHOW}#log=AAAA")
    shown.refuses("The log in this link cannot be read: the link is broken.")
    noise = "\n".join(f"[INFO] [{1.7e9 + n / 10:.9f}] [a]: {n**9 % 10**40}{n**11}" for n in range(5000))
    shown.drop(("a.log", noise))
    shown.shows("a.log: 5000 entries")
    shown.press("Copy a link to this")
    expect(shown.results).to_contain_text("The log is too long for a link. Paste the part that matters")


def test_the_test_that_is_saved_passes(shown: LogPage, tmp_path: Path) -> None:
    """In a folder of its own, with pytest, for ROS 1 and for ROS 2."""
    for name, log in {"rospy": SLEEPS, "rclpy": HEALTHY}.items():
        shown.drop(("a.log", log))
        shown.shows("a.log: ")
        shown.press("Make it a test")
        folder = tmp_path / name
        for button in shown.results.get_by_role("button", name="Save").all():
            with shown.page.expect_download() as found:
                button.click()
            found.value.save_as(folder / found.value.suggested_filename)
        assert f"import {name}" in (folder / "node_of_the_log.py").read_text(encoding="utf-8")
        command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(folder)]
        run = subprocess.run(command, capture_output=True, text=True, cwd=folder)
        assert run.returncode == 0 and "1 passed" in run.stdout, run.stdout + run.stderr
        shown.page.reload()


def test_nothing_leaves_the_computer(page: Page, address: str) -> None:
    """What the page asks for are files of the site, by their names."""
    asked: list[str] = []
    page.on("request", lambda request: asked.append(f"{request.method} {request.url} {request.post_data or ''}"))
    shown = LogPage(page, address)
    shown.drop(("secret.log", HEALTHY))
    shown.shows("secret.log")
    assert all(each.startswith((f"GET {address}", "GET blob:", "GET data:")) and each.endswith(" ") for each in asked)
    assert not [each for each in asked if "secret" in each or "wheel" in each]


def test_without_javascript(browser: Browser, address: str) -> None:
    with reader(browser, java_script_enabled=False) as context:
        page = context.new_page()
        page.goto(address + SHOW)
        expect(page.get_by_text("To look at a log here, this page needs JavaScript.")).to_be_visible()


def test_axe_and_a_phone(shown: LogPage) -> None:
    shown.press("a slow neighbour")
    shown.shows("A slow callback")
    shown.press("Make it a test")
    assert in_both_schemes(shown.page) == []
    for scheme in SCHEMES:
        look(shown.page, scheme)
        assert shown.page.evaluate(FAINT) == []
    shown.page.set_viewport_size({"width": 390, "height": 844})
    shown.press("a slow neighbour")
    shown.shows("A slow callback")
    assert shown.page.evaluate(TOO_WIDE) == []
