"""Files of answers, and the page on which a teacher has them judged."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, Locator, Page, Route, expect

from .answers import CELLS
from .attacks import FORGERIES

TEACHERS = "docs/for-teachers.html"

EXERCISES = "notebooks/exercises.html"
EXERCISE = "exercises/first-ticks.html"

RIGHT = CELLS["first-ticks"][1].source

WRONG = "%%answer first-ticks\ntimer = [0, 1, 2]\nloop = [0, 1, 2]\nbusy_loop = [0, 1, 2]\n"

ENDLESS = "%%answer first-ticks\nsum(iter(int, 1))\n"  # gives way to no interrupt

# What a sandbox does where a test is about the table: an answer is the verdict on it. Only where hand-ins are read
# Python starts, from what came before.
NO_RUNS = """
const say = (message) => postMessage(JSON.stringify(message))
const end = (result) => say({ kind: "end", result })
const python = () => { PYTHON }
let before = []
say({ kind: "ready" })
addEventListener("message", ({ data }) => {
    if (data.kind === "trace" && data.text.trim() !== "endless") end({ trace: "" })
    if (data.kind === "judge") return judge(data.text.replace(/^%%.*\\n/, "").trim())
    if (data.kind === "trace" || !before) return
    before.push(data)
    if (data.kind === "file") return
    const given = before
    before = null
    python()
    for (const data of given) dispatchEvent(new MessageEvent("message", { data }))
})
function judge(verdict) {
    const judged = { verdict, solved: verdict === "solved", status: "", console: "", said: verdict }
    const odd = {
        huge: { said: "x".repeat(1e7) },
        long: { said: "x".repeat(1e6) },
        number: { said: 5 },
        "not solved": { verdict: "solved" },
    }
    const solved = { ...judged, verdict: "solved", solved: verdict !== "not solved", ...odd[verdict] }
    if (verdict === "object") postMessage({ kind: "end", result: solved })
    else end(odd[verdict] ? solved : judged)
}
"""


def exchange(context: BrowserContext, site: Path, **files: bytes) -> None:
    """Serve other files in place of a site's own, from which Python starts, as if it had been built with them."""
    folder = site / "_static/live"
    script = (folder / "runs.js").read_text(encoding="utf-8")
    for name, data in files.items():
        found = next(path for path in folder.iterdir() if path.name.replace(".", "_") == name)
        before = hashlib.sha256(found.read_bytes()).hexdigest()
        assert before in script
        script = script.replace(before, hashlib.sha256(data).hexdigest())
        context.route(f"**/{found.name}*", partial(_answer, data))
    context.route("**/runs.js*", partial(_answer, script.encode()))


def _answer(data: bytes, route: Route) -> None:
    route.fulfill(body=data, content_type="text/javascript")


def handed_in(name: Any = "Ada", **changed: Any) -> str:
    """What is in a file."""
    made = {"format": "rosspin-answers", "version": 2, "name": name, "id": "a1", "answers": {"first-ticks": RIGHT}}
    return json.dumps(made | changed)


def impatient(site: Path) -> bytes:
    """The script of the teachers' page, with a quarter of the time that an answer may take."""
    script = (site / "_static/hand-in/judge.js").read_text(encoding="utf-8")
    script, found = re.subn(r"=20\*1e3\b", "=5*1e3", script)
    assert found == 1
    return script.encode()


class Table:
    """The teachers' page."""

    def __init__(self, page: Page, address: str) -> None:
        page.goto(address + TEACHERS)
        self.page = page
        self.input = page.get_by_label("Drop the files of your students")
        self.notes = page.locator(".rosspin-judge [role=alert] li")
        self.status = page.locator(".rosspin-judge [role=status]")
        self.detail = page.get_by_role("region", name="What the checker said")
        self.rows = page.locator(".judge-scroll tbody tr")

    def drop(self, **files: str) -> None:
        """Drop files with these names, without their endings, and texts."""
        transfer = self.page.evaluate_handle(
            """files => {
                const transfer = new DataTransfer()
                for (const [name, text] of Object.entries(files)) transfer.items.add(new File([text], `${name}.json`))
                return transfer
            }""",
            files,
        )
        zone = self.page.locator(".judge-drop")
        zone.dispatch_event("dragover", {"dataTransfer": transfer})
        zone.dispatch_event("drop", {"dataTransfer": transfer})

    def sign(self, title: str) -> Locator:
        return self.page.locator(".judge-scroll").get_by_role("button", name=title, exact=True)

    def done(self) -> None:
        expect(self.status).to_have_text(re.compile("^Done"))

    def said(self, title: str) -> str:
        """What is said of an answer whose sign has this title."""
        self.sign(title).click()
        expect(self.detail).to_be_focused()
        return self.detail.inner_text()

    def csv(self) -> list[list[str]]:
        with self.page.expect_download() as found:
            self.page.get_by_role("button", name="Save as CSV").click()
        assert found.value.suggested_filename == "answers.csv"
        data = Path(found.value.path()).read_bytes()
        assert data.startswith(b"\xef\xbb\xbf")
        return list(csv.reader(io.StringIO(data.decode("utf-8-sig"))))


def solves_nothing(table: Table, names: Iterable[str]) -> None:
    """No such forgery is a solution in the table."""
    answers = [f"%%answer first-ticks\n{FORGERIES[name]}\n" for name in names]
    table.drop(
        **{f"f{number}": handed_in(f"F{number}", answers={"first-ticks": text}) for number, text in enumerate(answers)}
    )
    table.done()
    expect(table.rows).to_have_count(len(answers))
    expect(table.page.locator(".judge-scroll button.judge-solved")).to_have_count(0)


HTML = "<img src=x onerror=\"document.title='taken'\"><script>document.title = 'taken'</script>"
