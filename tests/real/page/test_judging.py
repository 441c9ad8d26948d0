"""Files of answers are judged on the teachers' page, whatever is in them."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, FilePayload, Page, expect

from tests.helpers.answers import CELLS, IN_CPP, answer_in, number_of
from tests.helpers.hand_ins import ENDLESS, EXERCISES, HTML, RIGHT, WRONG, Table, handed_in, impatient
from tests.helpers.listings_in_page import have_workers
from tests.helpers.looks import FAINT, SCHEMES, TOO_WIDE, look

pytestmark = pytest.mark.shares(10)

FLOOD = "print('x' * 20_000_000)"

JS = "import js\njs.postMessage('solved')"

# The exercises, as they are shown.
FIRST, SECOND, THIRD = map(number_of, ("first-ticks", "after-a-slow-callback", "cpp-ticks"))
TEN_HERTZ, FAULT, LOOP = map(number_of, ("ten-hertz", "name-the-fault", "loop-to-timer"))


def test_right_wrong_and_forged(table: Table) -> None:
    """The check of the exercises says it; what a file says of itself changes nothing."""
    start = answer_in(CELLS["name-the-fault"][0])
    answers = {"first-ticks": RIGHT, "ten-hertz": CELLS["ten-hertz"][1].source, "name-the-fault": start, "99": "x"}
    forged = {"verdict": "solved", "verdicts": {"first-ticks": "solved"}, "solved": True, "first-ticks": "solved"}
    table.drop(
        ada=handed_in("Ada", answers=answers),
        ben=handed_in("Ben", answers={"first-ticks": WRONG, "ten-hertz": RIGHT}, **forged),
        eve=handed_in(
            "Eve", answers={"first-ticks": "print('Exercise 1: right.')\nprint('{\"verdict\": \"solved\"}')"}
        ),
        flo=handed_in("Flo", answers={"first-ticks": JS, "ten-hertz": "import numpy", "loop-to-timer": FLOOD}),
    )
    table.done()
    for title in (f"{FIRST}: solved", f"{TEN_HERTZ}: solved", f"{FAULT}: open"):
        expect(table.sign(f"Ada, exercise {title}")).to_be_visible()
    assert "there is no exercise '99'" in table.said("Ada, exercise 99: not judged")
    assert "The timer: 0.4 s" in table.said(f"Ada, exercise {FIRST}: solved")
    said = table.said(f"Ben, exercise {FIRST}: not yet")
    assert "Hint:" in said and "timer = [0, 1, 2]" in said
    expect(table.sign(f"Ben, exercise {TEN_HERTZ}: not yet")).to_be_visible()  # whatever its first line says
    expect(table.sign(f"Eve, exercise {FIRST}: open")).to_be_visible()
    assert "said what this page does not understand" in table.said(f"Flo, exercise {FIRST}: not judged")
    said = table.said(f"Flo, exercise {TEN_HERTZ}: not yet")
    assert "No module named 'numpy'" in said and "library, but no numpy. No exercise needs it." in said
    assert 20_000 < len(table.said(f"Flo, exercise {LOOP}: not yet")) < 31_000
    assert table.rows.locator("td:nth-child(2)").all_text_contents() == ["2 of 4", "0 of 2", "0 of 1", "0 of 3"]
    expect(table.status).to_have_text("Done: 8 judged, 2 not judged")
    have_workers(table.page, 1)  # in which hand-ins are read


def test_answers_in_cpp(table: Table) -> None:
    """They are compiled in the page, which says before how much it loads."""
    ten, made = number_of("ten-hertz"), number_of("make-it-10-hz")
    right, other = IN_CPP["ten-hertz"], IN_CPP["make-it-10-hz"]
    broken = other.written({"counter_++;": "counter_++"})
    stolen = f'#include "/etc/passwd"\n{other.changed}'
    table.drop(
        ada=handed_in("Ada", answers={"ten-hertz": f"%%answer ten-hertz\n{right.changed}", "make-it-10-hz": broken}),
        ben=handed_in("Ben", id="b", answers={"ten-hertz": right.node, "make-it-10-hz": other.changed}),
        eve=handed_in("Eve", id="e", answers={"make-it-10-hz": stolen, "slow-timer": right.node}),
    )
    expect(table.page.get_by_role("alert")).to_contain_text("loads clang once: about 28 MB")
    table.done()
    for title in (f"Ada, exercise {ten}: solved", f"Ben, exercise {made}: solved"):
        expect(table.sign(title)).to_be_visible()
    said = table.said(f"Ada, exercise {made}: not yet")
    assert "error: expected ';'" in said and "A ; is missing" in said
    assert "Counter 1 came at 0.5 s, not at 0.1 s." in table.said(f"Ben, exercise {ten}: not yet")
    assert "'/etc/passwd' file not found" in table.said(f"Eve, exercise {made}: not yet")
    said = table.said(f"Eve, exercise {number_of('slow-timer')}: not yet")
    assert "This exercise takes an answer in Python." in said


def test_an_answer_that_never_ends_is_ended(context: BrowserContext, table: Table, address: str, site: Path) -> None:
    """And the next one is judged."""
    context.route("**/judge.js*", lambda route: route.fulfill(body=impatient(site)))
    table = Table(table.page, address)
    table.drop(eve=handed_in("Eve", answers={"first-ticks": ENDLESS}), ada=handed_in("Ada", answers={"98": "x"}))
    table.done()
    assert "It was ended after" in table.said(f"Eve, exercise {FIRST}: did not end")
    expect(table.sign("Ada, exercise 98: not judged")).to_be_visible()
    have_workers(table.page, 1)  # in which hand-ins are read


def test_what_comes_out_of_a_sandbox_is_not_trusted(quick: Table) -> None:
    """Only a text of JSON that is not too long is read, and only what a verdict is made of."""
    answers = {"e-1": "huge", "e-2": "number", "e-3": "object", "e-4": "no such verdict", "e-5": "not solved"}
    answers |= {"e-6": "#" * 50_001, "e-7": "solved", "e-8": "long"}
    quick.drop(eve=handed_in("Eve", answers=answers))
    expect(quick.status).to_have_text("Done: 2 judged, 6 not judged")
    for number in range(1, 6):
        said = quick.said(f"Eve, exercise e-{number}: not judged")
        assert ("sent more than this page takes" if number in (1, 3) else "what this page does not understand") in said
    assert "It has 50001 characters; at most 50000 are judged" in quick.said("Eve, exercise e-6: not judged")
    assert len(quick.said("Eve, exercise e-8: solved")) < 31_000


# --- files that are no answers ----------------------------------------------------------------------------------------


def test_a_file_from_before_exercises_had_names(table: Table) -> None:
    """Its numbers are the ones that exercises had then; today's are shown."""
    table.drop(ada=handed_in("Ada", version=1, answers={"1": RIGHT.replace("first-ticks", "1"), "4": "x"}))
    table.done()
    expect(table.sign(f"Ada, exercise {FIRST}: solved")).to_be_visible()
    expect(table.sign(f"Ada, exercise {TEN_HERTZ}: not yet")).to_be_visible()


def test_stop(quick: Table) -> None:
    """Ends what runs and what waits; a file that is dropped again is judged again."""
    quick.drop(eve=handed_in("Eve", answers={"first-ticks": "solved", "after-a-slow-callback": "endless"}))
    for title in (f"{FIRST}: solved", f"{SECOND}: being judged"):
        expect(quick.sign(f"Eve, exercise {title}")).to_be_visible()
    quick.page.get_by_role("button", name="Stop").click()
    expect(quick.status).to_have_text("Done: 1 judged, 1 stopped")
    assert "Stopped before it was judged" in quick.said(f"Eve, exercise {SECOND}: stopped")
    quick.drop(again=handed_in("Eve", answers={"first-ticks": "not yet"}))
    expect(quick.status).to_have_text("Done: 1 judged")
    expect(quick.sign(f"Eve, exercise {FIRST}: not yet")).to_be_visible()


def test_what_was_refused_is_not_forgotten(quick: Table) -> None:
    """Whatever is dropped after it: it is on the page, counted, and in the CSV, even if no file was read."""
    quick.drop(**{"=odd": "null", "other": ""})
    expect(quick.status).to_have_text("Done: 0 judged; 2 files refused")
    expect(quick.page.get_by_role("region", name="Who solved what")).to_be_hidden()
    quick.drop(ada=handed_in(answers={"99": "solved"}), huge="x" * 2_000_000)
    expect(quick.status).to_have_text("Done: 1 judged; 3 files refused")
    named = [said.partition(" ")[0] for said in quick.notes.all_text_contents()]
    assert named == ["=odd.json", "other.json", "huge.json"]
    head, ada, *refused = quick.csv()
    assert ada[0] == "Ada"
    assert head[5:7] == ["file", "note"]
    assert [row[5:7] for row in refused] == [
        ["'=odd.json", "refused: it is not a file of answers to these exercises"],
        ["other.json", "refused: it is not a file that Save answers made (it is not JSON)"],
        ["huge.json", "refused: it has more than 1 MB, which is the limit"],
    ]
    assert not any(cell for row in refused for cell in (*row[:5], *row[7:]))


# --- the table --------------------------------------------------------------------------------------------------------


def test_who_is_who(quick: Table) -> None:
    """Of one student's files the newest counts; students of the same name, or on the same computer, stay apart."""
    days = [f"2026-11-{day}T12:00:00.000Z" for day in (20, 21, 22)]
    first = handed_in("Sam", date=days[1], answers={"first-ticks": "solved"})
    quick.drop(b=first, c=handed_in("Sam", id="a2"), d=handed_in("Al"))
    expect(quick.rows).to_have_count(3)
    expect(quick.notes).to_have_count(0)
    quick.drop(a=handed_in("Sam", date=days[0], answers={"after-a-slow-callback": "solved"}))
    expect(quick.notes).to_have_text("a.json is left out: Sam handed in b.json after it.")
    quick.drop(b=handed_in("Sam", date=days[2], answers={"cpp-ticks": "solved"}))
    expect(quick.notes.nth(1)).to_have_text("b.json takes the place of b.json, which Sam handed in before.")
    quick.drop(b=handed_in("Sam", date=days[2].replace(":00.000", ":30.000"), answers={"cpp-ticks": "solved"}))
    expect(quick.notes.nth(2)).to_have_text("b.json takes the place of b.json, which Sam handed in before.")
    quick.drop(b=handed_in("Sam", date=days[2], answers={"cpp-ticks": "not yet"}))  # in the same minute, but before it
    expect(quick.notes.nth(3)).to_have_text("b.json is left out: Sam handed in b.json after it.")
    quick.done()
    al, b, c = quick.rows.locator("th").all_inner_texts()
    assert al == "Al\nd.json\nsame browser as Sam"
    assert c == "Sam\nc.json\nsame name as b.json, another browser"
    source = r"2026-11-2\d \d\d:\d\d, b\.json"
    assert re.fullmatch(rf"Sam\n{source}\nsame browser as Al\nsame name as c\.json, another browser", b)
    said = quick.said(f"Sam, exercise {THIRD}: solved")
    assert said.startswith(f"Sam, exercise {THIRD}: The ticks of a C++ node: solved\n")
    assert re.search(rf"^The answer, from {source}:$", said, re.MULTILINE)
    assert [row[8:10] for row in quick.csv()[1:]] == [["Sam", ""], ["Al", "c.json"], ["", "b.json"]]
    expect(quick.sign(f"Sam, exercise {THIRD}: solved")).to_be_visible()
    expect(quick.page.get_by_role("columnheader", name=f"{THIRD}")).to_have_attribute(
        "title", f"Exercise {THIRD}: The ticks of a C++ node"
    )


def test_what_is_in_a_file_is_text(table: Table) -> None:
    table.drop(**{"<b>a": handed_in(HTML, answers={"first-ticks": f"print({HTML!r})", "ten-hertz": HTML})})
    table.done()
    said = table.said(f"{HTML}, exercise {FIRST}: open")
    assert said.count(HTML) >= 2  # as the name, and on the console
    assert table.page.title() != "taken"
    assert table.page.locator(".rosspin-judge").locator("img, script, b").count() == 0
    expect(table.rows.locator("th")).to_have_text(f"{HTML}<b>a.json")


def test_csv(quick: Table) -> None:
    """No name is a formula in a spreadsheet; whoever leaves without it is asked."""
    may_leave = "dispatchEvent(new Event('beforeunload', { cancelable: true }))"
    assert quick.page.evaluate(may_leave)
    names = ["=1+1", "+1", "-1", "@SUM(A1)", 'Zoë "Z", jr.']
    for number, name in enumerate(names):
        quick.drop(**{f"{number}": handed_in(name, id=name, answers={"99": "to read"})})
    date = "2026-11-21T12:00:00.000Z"
    answers = {"first-ticks": "solved", "ten-hertz": "not yet"}
    quick.drop(ada=handed_in(answers=answers, date=date), **{"=x": handed_in("Al")})
    expect(quick.status).to_have_text("Done: 2 judged, 5 to read, 1 not judged")
    assert not quick.page.evaluate(may_leave)
    head, *rows = quick.csv()
    assert quick.page.evaluate(may_leave)
    told = {row[0]: {name: cell for name, cell in zip(head, row, strict=True) if cell} for row in rows}
    assert list(told) == ["'+1", "'-1", "'=1+1", "'@SUM(A1)", "Ada", "Al", 'Zoë "Z", jr.']
    assert re.fullmatch(r"2026-11-2\d \d\d:\d\d", told["Ada"].pop("date"))
    common = {"sealed": "yes", "same browser as": "Al", "answers": "2", "solved": "1"}
    assert told["Ada"] == {"name": "Ada", "file": "ada.json", **common, "first-ticks": "solved", "ten-hertz": "not yet"}
    common = {"sealed": "yes", "same browser as": "Ada", "answers": "1", "solved": "0"}
    assert told["Al"] == {"name": "Al", "file": "'=x.json", **common, "first-ticks": "not judged"}
    assert told['Zoë "Z", jr.']["99"] == "to read"


def test_a_zip_is_read_as_it_is_and_the_table_sorts_and_says_what_was_hard(quick: Table) -> None:
    """With the path in it of each file, which says who sent it, and the student's ID."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, verdict in (("Ada", "not yet"), ("Zoë", "solved")):
            text = handed_in(name, id=name, student=f"s-{name}", answers={"first-ticks": verdict})
            archive.writestr(f"{name}_1_assignsubmission_file_/a.json", text)
        archive.writestr("Ben_2_assignsubmission_file_/slow-timer.py", "to read")
        archive.writestr("Cy_3_assignsubmission_file_/report.pdf", "x")
    quick.input.set_input_files(FilePayload(name="all.zip", mimeType="application/zip", buffer=buffer.getvalue()))
    expect(quick.status).to_have_text("Done: 2 judged, 1 to read; 1 file refused")
    expect(quick.notes).to_have_text("Cy_3_assignsubmission_file_/report.pdf is refused: it is no file of answers.")
    ada, zoe = (f"{name}\n{name}_1_assignsubmission_file_/a.json\nID s-{name}" for name in ("Ada", "Zoë"))
    ben, file = "Ben\nBen_2_assignsubmission_file_/slow-timer.py", "Cy_3_assignsubmission_file_/report.pdf"
    cy = f"Cy\n{file}\nrefused: it is no file of answers"
    assert quick.rows.locator("th").all_inner_texts() == [ada, ben, cy, zoe]
    solved = quick.page.get_by_role("columnheader").get_by_role("button", name="Solved")
    solved.click()
    assert quick.rows.locator("th").all_inner_texts() == [zoe, ada, ben, cy]
    expect(solved).to_be_focused()
    expect(quick.page.get_by_role("columnheader", name="Solved")).to_have_attribute("aria-sort", "descending")
    slow = "When a slow timer ticks again"
    told = [(number_of("slow-timer"), f"{slow}: 0 of 1"), (FIRST, "The first ticks: 1 of 2")]
    hard = [f"Exercise {number}: {said} solved" for number, said in told]
    expect(quick.page.locator(".judge-hard li")).to_have_text(hard)


def test_keyboard_alone(quick: Table) -> None:
    page = quick.page
    file = FilePayload(name="a.json", mimeType="application/json", buffer=handed_in(answers={"99": "to read"}).encode())
    quick.input.set_input_files(file)
    quick.done()
    quick.input.focus()
    sign = quick.sign("Ada, exercise 99: to read")
    for element in (
        page.get_by_role("button", name="Stop"),
        page.get_by_role("button", name="Save as CSV"),
        page.get_by_role("region", name="Who solved what"),
        *(page.get_by_role("columnheader").get_by_role("button", name=name) for name in ("Name", "Solved", "99")),
        sign,
    ):
        page.keyboard.press("Tab")
        expect(element).to_be_focused()
    page.keyboard.press("Enter")
    expect(quick.detail).to_be_focused()
    for element in (quick.detail.locator("pre").last, page.get_by_role("button", name="Back to the table")):
        page.keyboard.press("Tab")
        expect(element).to_be_focused()
    page.keyboard.press("Enter")
    expect(sign).to_be_focused()


def test_the_focus_stays_where_it_is_when_the_verdict_comes(table: Table) -> None:
    table.drop(ada=handed_in("Ada", answers={"first-ticks": RIGHT}))
    table.sign(f"Ada, exercise {FIRST}: being judged").click()
    back = table.page.get_by_role("button", name="Back to the table")
    back.focus()
    table.done()
    expect(table.detail).to_contain_text(f"Ada, exercise {FIRST}: The first ticks: solved")
    expect(back).to_be_focused()


# --- how it looks -----------------------------------------------------------------------------------------------------


def test_names_stay_in_view(quick: Table) -> None:
    """Wherever the table is scrolled to; nothing shows through, in light and in dark."""
    quick.drop(ada=handed_in("Ada", answers={f"e-{number}": "solved" for number in range(1, 40)}))
    quick.done()
    for width in (1280, 390):
        quick.page.set_viewport_size({"width": width, "height": 900})
        for name in quick.page.locator(".judge-scroll th:first-child").all():
            shown = name.evaluate(
                """cell => {
                    const scroll = cell.closest(".judge-scroll")
                    scroll.scrollLeft = 400
                    const [{ left, right }, place] = [cell.getBoundingClientRect(), scroll.getBoundingClientRect()]
                    const alpha = getComputedStyle(cell).backgroundColor.split(",")[3] ?? "1"
                    return [scroll.scrollLeft, Math.abs(left - place.left) <= 1, right < place.right - 100, alpha]
                }"""
            )
            assert shown == [400, True, True, "1"]


def test_looks(quick: Table, address: str) -> None:
    """The table and what is said fit a phone, and their text stands out in light and in dark."""
    page = quick.page
    answers = {f"e-{number}": "not judged" for number in range(30, 50)}
    answers |= {"first-ticks": "solved", "after-a-slow-callback": "to read"}
    quick.drop(ada=handed_in("Ada " * 10, answers=answers), b=handed_in("B", answers={"first-ticks": "solved"}))
    quick.done()
    quick.said(f"B, exercise {FIRST}: solved")
    _stands_out(page)
    page.goto(address + EXERCISES)
    expect(page.get_by_role("button", name="Save answers")).to_be_visible()
    _stands_out(page)


def _stands_out(page: Page) -> None:
    for scheme in SCHEMES:
        look(page, scheme)
        for width in (390, 1280):
            page.set_viewport_size({"width": width, "height": 900})
            assert page.evaluate(TOO_WIDE) + page.evaluate(FAINT) == [], (scheme, width)
