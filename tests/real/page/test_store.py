"""What a student answers is kept, shown and handed in: in two tabs, beside shared links, where little can be kept."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, Page, expect

from tests.helpers.answers import CELLS, number_of
from tests.helpers.hand_ins import EXERCISE, RIGHT, WRONG
from tests.helpers.listings_in_page import TIMER, Cell, link, node, open_tutorial

pytestmark = pytest.mark.shares(10)

RECORD = "rosspin:/:answer:first-ticks"

# As where the reader lets pages keep nothing.
NO_STORAGE = """
Object.defineProperty(window, "localStorage", { get() { throw new DOMException("", "SecurityError") } })
"""

FILL = """() => {
    let size = 2 ** 20
    for (let count = 0; size >= 1; count++) {
        try {
            localStorage.setItem(`filled ${count}`, "x".repeat(size))
        } catch {
            size = Math.floor(size / 2)
        }
    }
}"""
EMPTY = """() => {
    for (const key of Object.keys(localStorage)) if (key.startsWith("filled")) localStorage.removeItem(key)
}"""


class Answer(Cell):
    """The answer to exercise 1, on its page."""

    def __init__(self, page: Page, address: str, fragment: str = "") -> None:
        page.goto(address + EXERCISE + fragment)
        super().__init__(page, 0)

    @property
    def shown(self) -> str:
        return self.element.locator("pre").first.text_content() or ""

    def shows(self, text: str) -> None:
        """Wait until it shows this text, in the editor too if that is open."""
        expect(self.element.locator("pre").first).to_have_text(text)
        if self.editor.count():
            expect(self.editor).to_have_text(text.replace("\n", ""))  # its lines are elements

    def handed_in(self) -> dict[str, str]:
        """What is handed in now."""
        self.page.get_by_label("Your name").fill("Ada")
        with self.page.expect_download() as found:
            self.page.get_by_role("button", name="Save answers").click()
        file = json.loads(Path(found.value.path()).read_text(encoding="utf-8"))
        self.student = file["id"]
        answers: dict[str, str] = file["answers"]
        return answers

    @property
    def progress(self) -> str:
        return self.page.locator("article .live-progress").text_content() or ""


def test_two_tabs(context: BrowserContext, page: Page, address: str) -> None:
    """Each shows what was written last in either, and hands that in; what it took the place of can be brought back."""
    one, other = Answer(page, address), Answer(context.new_page(), address)
    one.write(WRONG)
    other.shows(WRONG)
    expect(other.status).to_have_text("as you changed it in another tab")
    other.write(RIGHT)
    one.shows(RIGHT)
    assert one.handed_in() == other.handed_in() == {"first-ticks": RIGHT}
    assert one.student == other.student
    one.button("Restore earlier version").click()
    other.shows(WRONG)
    one.shows(WRONG)
    expect(one.status).to_have_text(re.compile(r"^an earlier version, last changed 2\d{3}-"))
    other.button("Reset").click()
    expect(one.element.locator("pre").first).to_have_text(CELLS["first-ticks"][0].source)
    one.page.reload()
    expect(one.element.locator("pre").first).to_have_text(CELLS["first-ticks"][0].source)
    one.button("Restore earlier version").click()
    other.shows(WRONG)


def test_a_tab_that_was_asleep_writes_nothing_over(page: Page, address: str) -> None:
    """No event has told it what another tab wrote meanwhile."""
    answer = Answer(page, address)
    answer.write(WRONG)
    newer = "%%answer first-ticks\nnewer = 1\n"
    record = {"solved": False, "versions": [{"id": "another.0", "time": 9e15, "text": newer}]}
    page.evaluate("([key, text]) => localStorage.setItem(key, text)", [RECORD, json.dumps(record)])
    answer.shows(WRONG)
    page.evaluate("dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))")
    answer.shows(newer)
    assert answer.handed_in() == {"first-ticks": newer}
    answer.button("Restore earlier version").click()
    answer.shows(WRONG)


def test_a_link_leaves_the_readers_own_answer_alone(page: Page, address: str) -> None:
    """It is handed in, not what came with the link; running that solves nothing, and Reset brings the own one back."""
    answer = Answer(page, address)
    answer.write(WRONG)
    kept = page.evaluate("key => localStorage.getItem(key)", RECORD)
    page.close()
    page = page.context.new_page()
    answer = Answer(page, address, link(cell=0, text=RIGHT))
    expect(answer.element.locator(".live-notice")).to_contain_text("neither kept nor handed in")
    answer.shows(RIGHT)
    answer.button("Run").click()
    answer.ends(rf"Exercise {number_of('first-ticks')}: right\. The code came with the link, so it does not count\.$")
    assert answer.progress == "0 of 19 solved"
    answer.write(RIGHT + "# changed\n")
    expect(answer.button("Restore earlier version")).to_be_hidden()
    assert answer.handed_in() == {"first-ticks": WRONG}
    assert page.evaluate("key => localStorage.getItem(key)", RECORD) == kept
    answer.button("Reset").click()
    answer.shows(WRONG)
    expect(answer.status).to_have_text("as you edited it")
    assert "#" not in page.url


def test_solved_is_the_text_that_solved_it(page: Page, address: str) -> None:
    """Another one is handed in as it stands, with a word about it; the exercise is still counted."""
    answer = Answer(page, address)
    answer.write(RIGHT)
    answer.button("Run").click()
    answer.ends(rf"Exercise {number_of('first-ticks')}: right\. You have solved 1 of 19\.")
    answer.editor.press("Control+End")
    page.keyboard.type("# and more")
    expect(answer.status).to_have_text("as you edited it; an earlier version was solved")
    page.reload()
    expect(answer.status).to_have_text("as you edited it; an earlier version was solved")
    assert answer.progress == "1 of 19 solved"
    assert answer.handed_in() == {"first-ticks": RIGHT + "# and more"}
    status = page.locator(".hand-in").get_by_role("status")
    solved = f"You have solved exercise {number_of('first-ticks')} with another text"
    expect(status).to_contain_text(f"{solved}, which Restore earlier version brings back.")
    answer.button("Restore earlier version").click()
    expect(answer.status).to_have_text(re.compile("^an earlier version, last changed .*, solved$"))
    assert answer.handed_in() == {"first-ticks": RIGHT}
    expect(status).not_to_contain_text("Restore earlier version")


def test_a_reload_while_one_types(page: Page, address: str) -> None:
    answer = Answer(page, address)
    answer.button("Edit").click()
    answer.editor.press("Control+End")
    page.keyboard.type("# half a wo")
    page.reload()
    answer.shows(CELLS["first-ticks"][0].source + "\n# half a wo")


def test_full_storage_is_said(page: Page, address: str) -> None:
    """The text can be copied and handed in; as soon as there is room it is kept."""
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    answer = Answer(page, address)
    page.evaluate(FILL)
    answer.write(RIGHT)
    expect(answer.status).to_have_text("as you edited it; your text is not kept: the browser's storage is full")
    answer.button("Copy text").click()
    expect(answer.status).to_have_text("copied; your text is not kept: the browser's storage is full")
    assert page.evaluate("navigator.clipboard.readText()") == RIGHT
    assert answer.handed_in() == {"first-ticks": RIGHT}
    page.evaluate(EMPTY)
    answer.editor.press("Control+End")
    page.keyboard.insert_text("# kept\n")
    expect(answer.status).to_have_text("as you edited it")
    expect(answer.button("Copy text")).to_be_hidden()
    page.reload()
    answer.shows(RIGHT + "# kept\n")


def test_a_browser_that_keeps_nothing(context: BrowserContext, address: str) -> None:
    """It is said in each kind of listing; what is on the page is handed in."""
    page = context.new_page()
    page.add_init_script(NO_STORAGE)
    answer = Answer(page, address)
    expect(answer.status).to_have_text("")
    answer.write(WRONG)
    expect(answer.status).to_have_text("as you edited it; your text is not kept: this browser keeps nothing here")
    assert answer.handed_in() == {"first-ticks": WRONG}
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    cell.write(node("print('mine')"))
    expect(cell.status).to_have_text("as you edited it; your text is not kept: this browser keeps nothing here")
    expect(cell.button("Copy text")).to_be_visible()


def test_answers_of_an_earlier_version_of_the_site(page: Page, address: str) -> None:
    """They are shown, handed in and counted; their keys go once they are kept again."""
    answer = Answer(page, address)
    old = {
        "rosspin:/notebooks/exercises.html:0:1a": WRONG.replace("first-ticks", "1"),
        "rosspin:/notebooks/exercises.html:0:1a:solved": "yes",
        "rosspin:/notebooks/ros2-exercises.html:1:1b": "%%answer 20\nticks = [1]\n",
    }
    page.evaluate("old => { for (const [key, text] of Object.entries(old)) localStorage.setItem(key, text) }", old)
    page.reload()
    answer.shows(WRONG)
    expect(answer.status).to_have_text("as you edited it; an earlier version was solved")
    assert answer.progress == "1 of 19 solved"
    assert answer.handed_in() == {"first-ticks": WRONG, "slow-timer": "%%answer slow-timer\nticks = [1]\n"}
    keys = page.evaluate("Object.keys(localStorage).filter((key) => key.includes('exercises.html:'))")
    assert keys == ["rosspin:/notebooks/ros2-exercises.html:1:1b"]


def test_answers_from_before_exercises_had_names(page: Page, address: str) -> None:
    """What was kept by a number is shown and handed in by the name of that exercise, and is solved as it was."""
    answer = Answer(page, address)
    versions = [{"id": "a.0", "time": 1, "text": RIGHT.replace("first-ticks", "1"), "solved": True}]
    record = json.dumps({"solved": True, "versions": versions})
    page.evaluate("record => localStorage.setItem('rosspin:/:answer:1', record)", record)
    page.reload()
    answer.shows(RIGHT)
    expect(answer.status).to_have_text("solved, as you edited it")
    assert answer.handed_in() == {"first-ticks": RIGHT}
    assert page.evaluate("Object.keys(localStorage).filter((key) => key.includes(':answer:'))") == [RECORD]


def test_what_no_teacher_could_read_is_said(page: Page, address: str) -> None:
    answer = Answer(page, address)
    answer.write("%%answer first-ticks\n# " + "x" * 50_000)
    answer.handed_in()
    status = page.locator(".hand-in").get_by_role("status")
    expect(status).to_contain_text(
        f"Too long to be judged, with more than 50000 characters: exercise {number_of('first-ticks')}."
    )


def test_what_others_have_written_there_is_bounded(context: BrowserContext, address: str) -> None:
    """The pages of another site can have the same storage: whatever they leave in it, this one's pages open."""
    page = context.new_page()
    open_tutorial(page, address)
    cell = Cell(page, TIMER)
    shown = cell.element.locator("pre").first
    original = shown.text_content()
    cell.write("mine")
    [key] = page.evaluate(
        "Object.keys(localStorage).filter(key => key.startsWith('rosspin:/docs/tutorial-timer.html:'))"
    )
    page.evaluate("key => localStorage.setItem(key, 'x'.repeat(200_000))", key)
    page.evaluate("localStorage.setItem('rosspin:progress:/docs/ros2-exercises.html', 'x'.repeat(9999))")
    page.evaluate("localStorage.setItem('rosspin:progress:/notebooks/exercises.html', '<b>3</b> of 3 solved')")
    open_tutorial(page, address)
    page.reload()
    expect(shown).to_have_text(original or "")
    assert page.locator(".live-progress").count() == 0
    about = {"name": {"a": 1}, "student": "x" * 200_000, "id": 5}
    page.evaluate("text => localStorage.setItem('rosspin:hand-in', text)", json.dumps(about))
    page.evaluate(
        "text => localStorage.setItem(...text)", [RECORD, '{"solved":true,"versions":[' + "[]," * 300_000 + "[]]}"]
    )
    answer = Answer(page, address)
    assert page.get_by_label("Your name").input_value() == page.get_by_label("Student ID").input_value() == ""
    answer.write("x")
    assert answer.handed_in() == {"first-ticks": "x"}
