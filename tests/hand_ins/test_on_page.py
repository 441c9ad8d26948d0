"""The table of the page for teachers, as Python keeps it: as in ``rosspin judge``, with other bounds."""

from __future__ import annotations

import csv
import io
import json
import zipfile
from pathlib import Path
from typing import IO, Any

from rosspin.hand_ins.archives import find_given
from rosspin.hand_ins.on_page import Table
from rosspin.hand_ins.reports import as_csv, write_csv
from rosspin.hand_ins.students import Class


def saved(name: str, id: str = "a1", **changed: Any) -> bytes:
    made = {"format": "rosspin-answers", "version": 2, "name": name, "id": id, "answers": {"ten-hertz": "x"}}
    return json.dumps(made | changed).encode()


def zipped(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return buffer.getvalue()


def read(table: Table, **files: bytes) -> dict[str, Any]:
    """Give files, each by its path with __ for / and _ for a full stop."""
    paths = {name.replace("__", "/").replace("_", "."): data for name, data in files.items()}
    return table.read((path, io.BytesIO(data)) for path, data in paths.items())


def test_a_table_is_that_of_the_command_line(tmp_path: Path) -> None:
    """Whatever names, dates and answers are: emoji, composed letters, dates as some browsers write them."""
    files = {
        "a.json": saved("Zoe\u0308", date="2026-11-20", answers={"ten-hertz": "%%answer ten-hertz\nx"}),
        "b.json": saved("Zo\u00eb", date="2026-11-21T12:00:00.000Z"),
        "c.json": saved("Zo\u00eb", date="Sat Nov 28 2026"),
        "d.json": saved("\N{ROBOT FACE}" * 80, "a2", answers={"slow-timer": "\N{ROBOT FACE}" * 30_000, "zz-top": "x"}),
        "e.json": saved("=1+1", "a3", student="s1"),
        "Ada_1_assignsubmission_file_/slow_timer.py": b"x = 1",
        "Ben_2_assignsubmission_file_/report.pdf": b"x",
        "node_modules/x.json": b"",
        "all.zip": zipped({"Cy_3_assignsubmission_file_/f.json": saved("Cy", "a1"), "odd.json": b"null"}),
    }
    for name, data in files.items():
        (tmp_path / "class" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "class" / name).write_bytes(data)
    command = Class()
    command.add(tmp_path / "class")
    table = Table()
    shown = table.read((f"class/{name}", io.BytesIO(data)) for name, data in files.items())
    assert table.report([])["csv"] == write_csv(as_csv(command)).decode()
    assert [row["name"] for row in shown["rows"]] == [row.name for row in command.rows]
    assert shown["exercises"] == command.exercises
    problems = [*command.notes, *(f"{file} is refused: {why}." for file, why in command.refused)]
    assert shown["problems"] == problems and shown["refused"] == len(command.refused) > 1
    answers = [[shown["exercises"][place] for place in row["answers"]] for row in shown["rows"]]
    assert answers == [list(row.answers) for row in command.rows]
    for row in shown["rows"]:
        for place in row["answers"]:
            assert table.answer(row["number"], shown["exercises"][place])["why"] == ""  # 30,000 emoji, too


def test_a_row_has_its_number_until_another_file_takes_its_place() -> None:
    def numbers(shown: dict[str, Any]) -> dict[str, int]:
        return {row["name"]: row["number"] for row in shown["rows"]}

    table = Table()
    first = numbers(read(table, a_json=saved("Ada", date="2026-11-20T12:00:00.000Z"), b_json=saved("Ben")))
    older = read(table, c_json=saved("Ada", date="2026-11-19T12:00:00.000Z"))
    assert numbers(older) == first
    assert older["problems"] == ["c.json is left out: Ada handed in a.json after it."]
    newer = read(table, d_json=saved("Ada", date="2026-11-21T12:00:00.000Z", answers={"ten-hertz": "new"}))
    assert newer["problems"][1:] == ["d.json takes the place of a.json, which Ada handed in before."]
    after = numbers(newer)
    assert after["Ben"] == first["Ben"] and after["Ada"] not in first.values()
    assert table.answer(after["Ada"], "ten-hertz") == {"text": "new", "why": ""}
    assert table.answer(first["Ada"], "ten-hertz") == {"text": "", "why": ""}


def test_students_in_one_browser_or_of_one_name_are_told_of() -> None:
    shown = read(Table(), a_json=saved("Sam"), b_json=saved("Sam", "a2"), c_json=saved("Al"), d_json=saved("Di", "a3"))
    told = [(row["name"], row["file"], row["others"], row["namesakes"]) for row in shown["rows"]]
    assert told == [
        ("Al", "c.json", ["Sam"], []),
        ("Di", "d.json", [], []),
        ("Sam", "a.json", ["Al"], ["b.json"]),
        ("Sam", "b.json", [], ["a.json"]),
    ]
    many = read(Table(), **{f"f{number}_json": saved(f"s{number}") for number in range(9)})
    assert many["rows"][0]["others"] == ["s1", "s2", "s3", "s4", "s5", "3 more"]


def test_verdicts_come_into_the_table_and_what_was_hard() -> None:
    table = Table()
    answers = {"slow-timer": "#" * 50_001, "ten-hertz": ""}
    shown = read(table, a_json=saved("Ada", answers=answers), b_json=saved("Ben", "a2", answers=answers))
    ada, ben = (row["number"] for row in shown["rows"])
    assert table.answer(ada, "slow-timer")["why"] == "It has 50001 characters; at most 50000 are judged."
    verdicts = [[ada, "slow-timer", "not yet", "too late", "h"], [ben, "slow-timer", "solved", "", ""]]
    found = table.report([*verdicts, [ada, "ten-hertz", "solved", "", "", 0.25]])
    assert found["hard"] == [["slow-timer", 2, 1, (("h", 1),)]]
    head, *rows = csv.reader(io.StringIO(found["csv"].removeprefix("\ufeff")))
    told = [dict(zip(head, row, strict=True)) for row in rows]
    assert [(row["name"], row["answers"], row["solved"]) for row in told] == [("Ada", "2", "1"), ("Ben", "2", "1")]
    assert (told[0]["slow-timer"], told[0]["slow-timer: why"], told[1]["ten-hertz"]) == ("not yet", "too late", "")
    assert head[:3] == ["name", "student ID", "sent by"] and told[0]["ten-hertz: off (m)"] == "0.25"


FULL = "this table has room for 1000 files, 10000 answers and 100 exercises; "
FULL += "rosspin judge, on your computer, takes more"


def many(count: int, answers: Any) -> dict[str, bytes]:
    return {f"{number:04}_json": saved(f"s{number:04}", "x", answers=answers(number)) for number in range(count)}


def test_there_is_room_for_so_much() -> None:
    """What is more is refused, and said; another file of a student has the place of the first."""
    table = Table()
    shown = read(table, **many(1003, lambda number: {"a": ""}))
    assert len(shown["rows"]) == 1000
    assert shown["problems"] == [f"{number}.json is refused: {FULL}." for number in (1000, 1001, 1002)]
    again = read(table, x_json=saved("s0000", "x", answers={"b": ""}))
    assert again["problems"][3:] == ["x.json takes the place of 0000.json, which s0000 handed in before."]
    fifty = {f"a-{number}": "" for number in range(50)}
    shown = read(Table(), **many(300, lambda number: fifty))
    assert (len(shown["rows"]), shown["refused"], len(shown["problems"]), shown["unlisted"]) == (200, 100, 50, 50)
    shown = read(Table(), **many(150, lambda number: {f"a-{number}": ""}))
    assert (len(shown["exercises"]), shown["refused"]) == (100, 50)


def test_a_page_reads_less_than_a_computer_and_no_more_than_is_there() -> None:
    class Gone(io.RawIOBase):
        def readable(self) -> bool:
            return True

        def readinto(self, buffer: Any) -> int:
            raise OSError(5, "the browser does not give it")

    why = "it cannot be read: the browser does not give it"
    shown = Table().read([("a.json", io.BufferedReader(Gone())), ("f/b.json", io.BufferedReader(Gone()))])
    assert shown["problems"] == [f"a.json is refused: {why}.", f"b.json is refused: {why}."]
    files: dict[tuple[str, ...], IO[bytes]] = {(f"{number}.json",): io.BytesIO() for number in range(20_001)}
    *_, last = find_given("all", files)
    assert (last.path, last.why) == ("all", "there is too much in all; have it judged in parts")
