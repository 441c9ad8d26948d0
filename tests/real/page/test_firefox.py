"""The site in Firefox: its figures move there as in Chromium, and its listings run."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.in_chromium import served
from rosspin import simulate
from tests.helpers.answers import number_of
from tests.helpers.attacks import ATTACK, SANDBOX, SCRIPT, WAYS, attempts, succeeded, tried
from tests.helpers.figures import FIGURES
from tests.helpers.figures_in_firefox import moves
from tests.helpers.firefox import Tab
from tests.helpers.floods import AS_MUCH, SIZE
from tests.helpers.hand_ins import ENDLESS, RIGHT, TEACHERS, WRONG, handed_in, impatient
from tests.helpers.listings_in_page import link
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(10)

SPINNER = ROOT / "examples/my_robotics_pkg/src/spinner_py_node.py"
SPINNER_CPP = ROOT / "examples/my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp"


def test_a_figure_moves(firefox_page: Tab, address: str) -> None:
    """One with ticks that are lost; all of them are moved in real/judge."""
    moves(firefox_page, address, FIGURES[3])


# The console of a page's first listing, of Python or C++, after a run.
RUN = """async (of, speed) => {
    const cell = document.querySelector("div.live" + of)
    cell.querySelector("select").value = speed
    cell.querySelector(".live-bar button").click()
    const status = cell.querySelector("[role=status]")
    while (!/^(done|error|stopped)/.test(status.textContent)) await new Promise(go => setTimeout(go, 50))
    return [status.textContent, cell.querySelector("[role=log] pre").textContent]
}"""


# The same of what came with a link.
RUN_LINKED = f"""async (of, speed) => {{
    const said = () => document.querySelector("div.live" + of + " .live-notice")?.textContent
    while (!said()) await new Promise(go => setTimeout(go, 50))
    return ({RUN})(of, speed)
}}"""


# What the teachers' page says of the answers in a file.
JUDGE = """async text => {
    const dataTransfer = new DataTransfer()
    dataTransfer.items.add(new File([text], "ada.json"))
    document.querySelector(".judge-drop").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }))
    const status = document.querySelector(".rosspin-judge [role=status]")
    while (!/^Done/.test(status.textContent)) await new Promise(go => setTimeout(go, 50))
    return [...document.querySelectorAll(".judge-scroll tbody button")].map(button => button.ariaLabel)
}"""


def test_a_listing_runs(firefox_page: Tab, address: str) -> None:
    firefox_page.open(address + "docs/tutorial.html")
    if not firefox_page.evaluate("() => 'Suspending' in WebAssembly"):
        assert "lacks JSPI" in firefox_page.evaluate("() => document.querySelector('.live-missing').textContent")
        return
    status, console = firefox_page.evaluate(RUN, ":not(.highlight-cpp)", "0")
    assert status == "done: 20 ticks"
    assert console == simulate(SPINNER, 10).console


@pytest.mark.parametrize("speed", ["0", "10"])
def test_a_listing_in_cpp_runs(firefox_page: Tab, address: str, speed: str) -> None:
    firefox_page.open(address + "docs/ros2/tutorial.html?lang=cpp")
    status, console = firefox_page.evaluate(RUN, ".highlight-cpp", speed)
    assert status == "done: 20 ticks"
    assert console == simulate(SPINNER_CPP, 10).console


# What is put in place of what in C++, and how the run ends then.
SPIN = "  rclcpp::spin("
CHANGES = {
    "faster": ({"(0.5)": "(0.25)"}, "done: 4 ticks"),
    "null": ({SPIN: f"  int* none = nullptr;\n  *none = 1;\n{SPIN}"}, "error: see the console"),
    "recursion": (
        {
            "int main(": "int deep(int n) { return n ? deep(n + 1) + deep(n + 2) : 0; }\nint main(",
            SPIN: f"  std::cout << deep(argc);\n{SPIN}",
        },
        "error: see the console",
    ),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_change_in_cpp_is_compiled(firefox_page: Tab, address: str, tmp_path: Path, change: str) -> None:
    """What came with a link is not what was compiled with the page; it runs, or is ended, as on a machine."""
    changes, ends = CHANGES[change]
    text = SPINNER_CPP.read_text(encoding="utf-8")
    for before, after in changes.items():
        text = text.replace(before, after)
    changed = tmp_path / SPINNER_CPP.name
    changed.write_text(text, encoding="utf-8")
    firefox_page.open(f"{address}docs/ros2/tutorial.html?lang=cpp{link(cell=1, text=text, seconds=1)}")
    said = simulate(changed, 1).console.replace(str(changed), changed.name)
    assert tuple(firefox_page.evaluate(RUN_LINKED, ".highlight-cpp", "0")) == (ends, said)


def test_answers_are_judged(firefox_page: Tab, site: Path) -> None:
    open_one = WRONG.replace("first-ticks", "after-a-slow-callback")
    answers = {"first-ticks": RIGHT, "after-a-slow-callback": open_one, "cpp-ticks": ENDLESS}
    with served(site, {"_static/hand-in/judge.js": impatient(site)}) as address:
        firefox_page.open(address + TEACHERS)
        said = firefox_page.evaluate(JUDGE, handed_in(answers=answers))
    verdicts = ("solved", "open", "did not end")
    assert said == [f"Ada, exercise {number_of(name)}: {each}" for name, each in zip(answers, verdicts, strict=True)]
    # Pyodide tries whether it may load a script: in the sandbox it may not.
    firefox_page.wrong[:] = [wrong for wrong in firefox_page.wrong if "data:text/javascript" not in wrong]


# --- floods -----------------------------------------------------------------------------------------------------------

# Runs what came with a link until some of it is left out, and stops it: how much there was to lay out.
FLOOD = f"""async index => {{
    const turn = () => new Promise(go => setTimeout(go, 50))
    const cell = document.querySelectorAll("div.live:not(.highlight-cpp, .highlight-xml)")[index]
    const status = cell.querySelector("[role=status]")
    const press = name => [...cell.querySelectorAll("button")].find(button => button.textContent === name).click()
    while (!cell.querySelector(".live-notice")?.textContent) await turn()
    cell.querySelector("select").value = "1" // real time
    press("Run")
    while (!/left out|ticks drawn/.test(cell.textContent)) await turn()
    const size = ({SIZE})(cell)
    press("Stop")
    while (!/^stopped/.test(status.textContent)) await turn()
    return size
}}"""


@pytest.mark.parametrize("name", AS_MUCH)
def test_what_is_shown_is_bounded_and_stop_ends_it(firefox_page: Tab, address: str, name: str) -> None:
    firefox_page.open(address)
    firefox_page.open(f"{address}docs/tutorial.html?lang=python{link(cell=0, text=AS_MUCH[name], seconds=3000)}")
    if not firefox_page.evaluate("() => 'Suspending' in WebAssembly"):
        return
    characters, lines, longest, elements = firefox_page.evaluate(FLOOD, 0)
    assert characters <= 100_000 and lines <= 1000 and longest <= 2001 and elements <= 8000
    assert characters + elements > 500
    firefox_page.wrong[:] = [wrong for wrong in firefox_page.wrong if "data:text/javascript" not in wrong]


# --- the adversary ----------------------------------------------------------------------------------------------------

# Attempts in which a worker starts another one. There Firefox now and then blocks the first one for good, even if it is
# all that the code does; a page can still stop it.
NESTED = ["worker", "worker of data", "worker of a blob", "caches of a blob"]

# What a text prints as a node, or why it ended. It is stopped after ``longest`` ms, if that is given.
RUN_TEXT = """async (address, source, longest) => {
    const { Sandbox } = await import(address)
    const sandbox = new Sandbox()
    const { kind, reason } = await sandbox.started
    if (kind !== "ready") return reason
    let text = ""
    await new Promise(resolve => {
        if (longest) setTimeout(resolve, longest)
        const job = { kind: "run", source, filename: "node.py", seconds: 1, args: "", speed: 0, beside: [],
            programs: [], files: {} }
        sandbox.do(job, message => {
            if (message.kind === "batch") text += message.chunks.map(([, text]) => text).join("")
            if (message.kind === "failed") text += message.reason
            if (message.kind !== "batch") resolve()
        })
    })
    sandbox.end()
    return text
}"""
RUN_TEXTS = f"(address, texts, longest) => Promise.all(texts.map(text => ({RUN_TEXT})(address, text, longest)))"
KEPT = """async () => {
    const cache = await caches.open("rosspin")
    return Promise.all((await cache.keys()).map(async key => [key.url, (await (await cache.match(key)).blob()).size]))
}"""


def test_code_reaches_nothing(firefox_page: Tab, address: str) -> None:
    firefox_page.open(address + "docs/tutorial.html")
    if not firefox_page.evaluate("() => 'Suspending' in WebAssembly"):
        return
    runs = f"{address}_static/live/runs.js"
    names = [name for name in WAYS if name not in NESTED]
    results = tried(firefox_page.evaluate(RUN_TEXT, runs, attempts(address, names), None))
    assert (list(results), succeeded(results)) == (names, {})
    # Where Firefox never comes back from such a call, code has reached nothing either.
    texts = [attempts(address, [name]) for name in NESTED]
    for console in firefox_page.evaluate(RUN_TEXTS, runs, texts, 10_000):
        assert succeeded(tried(console)) == {}
    firefox_page.wrong.clear()  # what was refused is an error each


def test_a_kept_snapshot_that_was_changed_is_loaded_anew(firefox_page: Tab, address: str) -> None:
    firefox_page.open(address + "docs/tutorial.html")
    if not firefox_page.evaluate("() => 'Suspending' in WebAssembly"):
        return
    runs = f"{address}_static/live/runs.js"
    assert firefox_page.evaluate(RUN_TEXT, runs, "print('first')", None) == "first\n"
    ((url, size),) = firefox_page.evaluate(KEPT)
    assert size > 1_000_000
    firefox_page.evaluate("async url => (await caches.open('rosspin')).put(url, new Response('another'))", url)
    firefox_page.open(address + "docs/tutorial.html")
    assert firefox_page.evaluate(RUN_TEXT, runs, "print('again')", None) == "again\n"
    assert firefox_page.evaluate(KEPT) == [[url, size]]
    firefox_page.wrong[:] = [wrong for wrong in firefox_page.wrong if "data:text/javascript" not in wrong]


@pytest.mark.parametrize("place", ["frame", "top"])
def test_page_of_a_sandbox_does_nothing_for_others(firefox_page: Tab, address: str, tmp_path: Path, place: str) -> None:
    """From another port of the same computer."""
    (tmp_path / "index.html").write_text("<!doctype html><title>elsewhere</title>", encoding="utf-8")
    firefox_page.open(address)
    before = firefox_page.evaluate(KEPT)
    script = SCRIPT.replace("SITE", address)
    with served(tmp_path) as elsewhere:
        if place == "top":
            firefox_page.open(address + SANDBOX)
            send = "window.postMessage({ script }, '*'), window.postMessage(script, '*')"
            firefox_page.evaluate(f"script => new Promise(go => ({send}, setTimeout(go, 1000)))", script)
        else:
            firefox_page.open(elsewhere)
            make = "Object.assign(document.createElement('iframe'), { src, onload: () => go() })"
            firefox_page.evaluate(f"src => new Promise(go => document.body.append({make}))", address + SANDBOX)
            assert firefox_page.evaluate(ATTACK.replace("[target, script]", "target, script"), place, script) == []
    firefox_page.open(address)
    assert firefox_page.evaluate(KEPT) == before
    firefox_page.wrong[:] = [wrong for wrong in firefox_page.wrong if "favicon" not in wrong]
