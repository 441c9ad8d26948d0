"""The listings that run in the page, in Chromium: how long a reader waits, how much is loaded, how late ticks are."""

from __future__ import annotations

import gzip
import json
import re
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from statistics import median
from urllib.parse import unquote, urlsplit

from playwright.sync_api import Browser, FilePayload, Page, Request

from rosspin.doctor import chromium
from rosspin.measures import quantile, say_time

from .in_chromium import launched, served
from .ratios import Times, line, ratio

ROOT = Path(__file__).parent.parent
SITE = ROOT / "build" / "html"
TUTORIAL = "docs/tutorial-rate.html"
TEACHERS = "docs/for-teachers.html"
PYODIDE = ROOT / "build" / "npm" / "node_modules" / "pyodide"

# The listing in Python of that page, whose first counter comes at once: click, and wait for a text, but not for more
# than two minutes. By the page's clock.
CLICK = """([button, text]) => new Promise((resolve, reject) => {
    const cell = document.querySelector("div.live:not(.highlight-cpp, .highlight-xml)")
    const start = performance.now()
    const look = () => {
        const took = (performance.now() - start) / 1e3
        const said = cell.textContent.slice(cell.querySelector("pre").textContent.length)
        if (said.includes(text)) resolve(took)
        else if (took > 120) reject(new Error(`no "${text}" after ${button}: ${said.slice(-500)}`))
        else setTimeout(look, 1)
    }
    ;[...cell.querySelectorAll("button")].find(found => found.textContent === button).click()
    look()
})"""

# The same node for ROS 2, and what puts it in the place of that listing; and one that solves an exercise.
ROS2 = ROOT / "examples" / "my_robotics_pkg_ros2" / "my_robotics_pkg" / "spinner_rate_py_node.py"
ROS2_TIMER = ROS2.with_name("spinner_py_node.py")
WRITE = """text => {
    document.querySelector("div.live:not(.highlight-cpp, .highlight-xml) pre").textContent = text
}"""

# What the start of Python takes by itself, from Pyodide's own files.
BARE = """async ([base, lockFileContents]) => {
    const { loadPyodide } = await import(base + "pyodide.mjs")
    const start = performance.now()
    await loadPyodide({ lockFileContents, checkAPIVersion: false })
    return (performance.now() - start) / 1e3
}"""

# Tells the page's own time at each tick; that of the run begins when the node does.
TICKER = """
import rospy
from js import performance

rospy.init_node("ticker")
rospy.Timer(rospy.Duration(0.1), lambda event: print(performance.now()))
rospy.spin()
"""
RUN_TICKER = """async ([address, source, seconds]) => {
    const { Sandbox } = await import(address)
    const sandbox = new Sandbox()
    await sandbox.started
    const times = []
    return new Promise((resolve, reject) => {
        const job = { kind: "run", source, filename: "ticker.py", seconds, args: "", speed: 1, beside: [],
            programs: [], files: {} }
        setTimeout(() => reject(new Error("the ticker has not ended")), (seconds + 60) * 1e3)
        sandbox.do(job, message => {
            const texts = message.kind === "batch" ? message.chunks.map(([, text]) => text) : []
            times.push(...texts.map(Number).filter(time => time))
            if (message.kind === "end") resolve(times)
            if (message.kind === "failed") reject(new Error(message.reason))
        })
    })
}"""


def report(rounds: int = 5, seconds: float = 20.0, pause: float = 6.0) -> Iterator[str]:
    """The lines of the report. ``pause`` (s) is how long a reader looks on before Stop: a spare worker starts then."""
    executable = chromium()
    yield "Python in the page, in Chromium"
    if not executable or not (SITE / TUTORIAL).exists():
        yield "  not measured: it needs Chromium, and the site that `make html` builds"
        return
    with served(SITE) as address, served(PYODIDE) as bare, launched(executable) as browser:
        yield from _report(browser, address, bare, rounds, seconds, pause)


def _report(
    browser: Browser, address: str, bare_address: str, rounds: int, seconds: float, pause: float
) -> Iterator[str]:
    weights, ready, loaded = [], [], []
    times: Times = {
        name: [] for name in ("bare", "cold", "cold, ROS 2", "next page", "warm", "stopped", "again", "answer")
    }
    for _ in range(rounds):
        with browser.new_context() as context:
            page = context.new_page()
            page.goto(bare_address)
            times["bare"].append(page.evaluate(BARE, [bare_address, _lock()]))
        with browser.new_context() as context:
            page = context.new_page()
            _open(page, address + TUTORIAL)
            page.evaluate(WRITE, ROS2.read_text(encoding="utf-8"))
            times["cold, ROS 2"].append(_click(page, "Run", "counter = 1"))
        with browser.new_context() as context:
            page = context.new_page()
            asked: set[str] = set()  # by a second worker again, but then it comes from the browser's cache
            page.on("request", partial(_note, asked))
            _open(page, address + TUTORIAL)
            weights.append(_weight(asked))
            ready.append(page.evaluate("performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd") / 1e3)
            asked.clear()
            times["cold"].append(_click(page, "Run", "counter = 1"))
            loaded.append(_weight(asked))
            _choose(page, "real time")  # a run that one can still stop
            _click(page, "Run", "counter = 1")
            page.wait_for_timeout(pause * 1e3)
            times["stopped"].append(_click(page, "Stop", "stopped"))
            _choose(page, "instantly")
            times["again"].append(_click(page, "Run", "counter = 1"))
            page.get_by_text(re.compile("^done: ")).wait_for(state="attached")
            times["warm"].append(_click(page, "Run", "counter = 1"))
            _open(page, address)
            _open(page, address + TUTORIAL)
            times["next page"].append(_click(page, "Run", "counter = 1"))
        times["answer"].append(_judge(browser, address))
    with browser.new_context() as context:
        page = context.new_page()
        page.goto(address + TUTORIAL)
        ticked = page.evaluate(RUN_TICKER, [f"{address}_static/live/runs.js", TICKER, seconds])
    late = [time / 1e3 - number * 0.1 for number, time in enumerate(ticked)]
    late = [value - min(late) for value in late]

    bare = median(times["bare"])
    yield f"  the page untouched: ready after {median(ready):.2f} s"
    yield line("  MB gzipped, the page untouched", max(weights) / 1e6, most=0.35)
    yield line("  MB gzipped, loaded by the first click", max(loaded) / 1e6, most=9.14)
    for name, most in [("cold", 0.5), ("cold, ROS 2", 0.5), ("next page", 0.4)]:
        said = f"{median(times[name]):.2f} s / {bare:.2f} s"
        yield line(
            f"  click to counter 1, {name} / bare loadPyodide", ratio(times, name, "bare"), most=most, times=said
        )
    yield line("  s from click to counter 1, warm", median(times["warm"]), most=0.5)
    yield line("  s from Stop to stopped", median(times["stopped"]), most=0.1)
    yield line("  s from click to counter 1, after Stop", median(times["again"]), most=0.5)
    yield line("  s for each answer that a teacher drops", median(times["answer"]), most=1.3)
    middle, high = say_time(median(late)), say_time(quantile(late, 0.95))
    yield f"  10 Hz timer, {len(late)} ticks, later than the earliest of them: median {middle}, p95 {high}"


def _open(page: Page, address: str) -> None:
    """Go to a page, until all that it loads has come; Playwright's "networkidle" may never come, and it says so."""
    page.goto(address)
    page.evaluate("document.fonts.ready.then(() => null)")


def _lock() -> str:
    """A lock file without packages, as the pages have it."""
    lock = json.loads((PYODIDE / "pyodide-lock.json").read_text(encoding="utf-8"))
    return json.dumps({"info": lock["info"], "packages": {}})


def _note(asked: set[str], request: Request) -> None:
    asked.add(urlsplit(request.url).path)


def _click(page: Page, button: str, text: str) -> float:
    took: float = page.evaluate(CLICK, [button, text])
    return took


def _choose(page: Page, speed: str) -> None:
    """The speed of that listing's next run."""
    cell = page.locator("div.live:not(.highlight-cpp, .highlight-xml)").first
    cell.get_by_label("Speed").select_option(speed, force=True)  # its tab, or what is folded, may be closed


def _judge(browser: Browser, address: str, number: int = 24) -> float:
    """How long (s) the teachers' page takes for each of so many answers, of students with two each."""
    right = ROS2_TIMER.read_text(encoding="utf-8").replace("= 0.5", "= 0.1")
    answers = {"make-it-10-hz": f"%%answer make-it-10-hz\n{right}", "slow-timer": "%%answer slow-timer\nx = 1\n"}
    files: list[FilePayload] = []
    for name in map(str, range(number // len(answers))):
        made = {"format": "rosspin-answers", "version": 2, "name": name, "id": name, "answers": answers}
        files.append({"name": f"{name}.json", "mimeType": "application/json", "buffer": json.dumps(made).encode()})
    with browser.new_context() as context:
        page = context.new_page()
        _open(page, address + TEACHERS)
        begin = time.perf_counter()
        page.locator(".judge-drop input").set_input_files(files)
        page.get_by_text(f"Done: {number} judged").wait_for(timeout=number * 10_000)
        return (time.perf_counter() - begin) / number


def _weight(paths: set[str]) -> int:
    """The bytes of these files of the site, gzipped."""
    files = [SITE / unquote(path.lstrip("/")) for path in paths]
    return sum(len(gzip.compress(file.read_bytes())) for file in files if file.is_file())
