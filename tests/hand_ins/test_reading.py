"""What is handed in is read, and found in whatever learning platforms export; nothing of it is run."""

from __future__ import annotations

import io
import json
import os
import struct
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from rosspin.exercises import code
from rosspin.hand_ins.archives import ON_DISK, Bounds, FoundFile, find
from rosspin.hand_ins.files import HandIn, Refused, read
from rosspin.hand_ins.students import Class

pytestmark = pytest.mark.shares(3)

MADE = {"format": "rosspin-answers", "version": 2, "name": "Ada", "id": "a1", "answers": {"ten-hertz": "x"}}


def saved(**changed: Any) -> bytes:
    """What the site saves."""
    return json.dumps(MADE | changed).encode()


# --- the file of the site ---------------------------------------------------------------------------------------------


def test_what_the_site_saves_is_read() -> None:
    date = "2026-11-21T12:00:00.000Z"
    answers = {"ten-hertz": "%%answer ten-hertz\nä", "cpp-ticks": ""}
    found = read("a.json", saved(name="Zoë", student=" s123 ", date=date, answers=answers, verdict="solved"))
    assert found == HandIn(answers, "Zoë", "s123", "a1", datetime(2026, 11, 21, 12, tzinfo=UTC))
    assert read("a.json", b"\xef\xbb\xbf" + saved()) == HandIn({"ten-hertz": "x"}, "Ada", "", "a1")
    assert read("a.json", saved(answers={"ten-hertz": "a\ud800"})).answers == {"ten-hertz": "a\ufffd"}
    assert read("a.json", saved(student=5)).student == ""


def test_a_file_from_before_exercises_had_names() -> None:
    answers = {"1": "a", "4": "b", "20": "c", "30": "d", "99": "e"}
    names = ["first-ticks", "ten-hertz", "slow-timer", "cancel-a-goal", "99"]
    assert list(read("a.json", saved(version=1, answers=answers)).answers) == names


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("a\n\u202eb\0 " + "c" * 200, "a b " + "c" * 96),
        ("  ", "(no name)"),
        ("\u200b", "(no name)"),
        ("<b>Zoë</b>", "<b>Zoë</b>"),
        ("Zoe\u0308", "Zoë"),
        ("\N{ROBOT FACE}" * 80, "\N{ROBOT FACE}" * 80),
    ],
)
def test_names_are_one_short_line(name: str, expected: str) -> None:
    assert read("a.json", saved(name=name)).name == expected


@pytest.mark.parametrize("date", [None, 5, "yesterday", {}, "9999-99-99"])
def test_a_file_may_have_no_date(date: Any) -> None:
    assert read("a.json", saved(date=date)).date is None


NOT_JSON = "it is not a file that Save answers made (it is not JSON)"
NOT_THESE = "it is not a file of answers to these exercises"
LACKING = "its name or its answers are missing"
NO_ANSWER = "one of its answers is not a text with the name of an exercise"
REFUSED = [
    (b"x" * 3_000_000, "it has more than 1 MB, which is the limit"),
    (b"", NOT_JSON),
    (b"%%answer 1\n", NOT_JSON),
    (b"[" * 900_000, NOT_JSON),
    (b"1" * 10_000, NOT_JSON),
    (b"null", NOT_THESE),
    (b"[]", NOT_THESE),
    (saved(format="other"), NOT_THESE),
    (saved(version=3), "another version of this site wrote it"),
    (saved(version=True), "another version of this site wrote it"),
    (saved(version="constructor"), "another version of this site wrote it"),
    (saved(version=1, answers={"04": "x"}), NO_ANSWER),
    (saved(name=None), LACKING),
    (saved(id=5), LACKING),
    (saved(answers=None), LACKING),
    (saved(answers={"One two": "x"}), NO_ANSWER),
    (saved(answers={"a--b": "x"}), NO_ANSWER),
    (saved(answers={"a" * 101: "x"}), NO_ANSWER),
    (saved(version=1, answers={"1.5": "x"}), NO_ANSWER),
    (saved(answers={"a": ["x"]}), NO_ANSWER),
    (saved(answers={f"e-{n}": "" for n in range(101)}), "it has 101 answers, and at most 100 are read"),
]


@pytest.mark.parametrize(("data", "why"), REFUSED)
def test_what_is_no_such_file_is_refused(data: bytes, why: str) -> None:
    with pytest.raises(Refused) as refused:
        read("a.json", data)
    assert str(refused.value) == why


# --- other files ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "text", "exercise"),
    [
        ("slow-timer.py", "x = 1", "slow-timer"),
        ("slow_timer.py", "x = 1", "slow-timer"),
        ("slow-timer (2).py", "x = 1", "slow-timer"),
        ("move-to-ros-2.py", "x = 1", "move-to-ros-2"),
        ("move-to-ros-2-1.py", "x = 1", "move-to-ros-2"),
        ("mine.py", "%%answer slow-timer\nx = 1", "slow-timer"),
        ("slow-timer.py", "%%answer ten-hertz\nx = 1", "ten-hertz"),
    ],
)
def test_a_node_file_names_its_exercise(name: str, text: str, exercise: str) -> None:
    assert read(name, text.encode()).answers == {exercise: text}
    assert code(text) == text.replace(f"%%answer {exercise}", "")


def test_a_node_file_in_the_codings_of_windows() -> None:
    for coding in ("utf-16", "cp1252", "utf-8-sig"):
        assert read("slow-timer.py", "# ä".encode(coding)).answers == {"slow-timer": "# ä"}


@pytest.mark.parametrize("name", ["setup.py", "slow-timers.py", "answers.pdf", "notes.md", "a.ipynb"])
def test_what_holds_no_answer_is_refused(name: str) -> None:
    with pytest.raises(Refused, match="^(neither|it is no|it has no|it is not)"):
        read(name, b"x = 1")


CELLS = [("%%answer slow-timer\nmine", []), ("x", []), ("%%answer slow-timer\nlater", []), ("%%answer 4\nb", ["live"])]
CELLS += [("%%answer cpp-ticks\nsolution", ["hide-cell"])]


def test_a_notebook_s_cells_are_answers_but_for_the_solutions() -> None:
    cells = [{"cell_type": "code", "source": [text], "metadata": {"tags": tags}} for text, tags in CELLS]
    odd: list[Any] = [5, {}, {"source": 5, "metadata": 5}, {"source": [5], "metadata": {"tags": 5}}]
    expected = {"slow-timer": "%%answer slow-timer\nmine", "ten-hertz": "%%answer 4\nb"}
    assert read("a.ipynb", json.dumps({"cells": odd + cells}).encode()).answers == expected
    fences = [f"```{{code-cell}} ipython3\n:tags: [{', '.join(tags)}]\n\n{text}\n```\n" for text, tags in CELLS]
    expected = {name: f"{text}\n" for name, text in expected.items()}
    assert read("a.md", "\ntext\n".join(fences).encode()).answers == expected


# --- folders and archives ---------------------------------------------------------------------------------------------


def zipped(files: Mapping[str, bytes | str], **how: Any) -> bytes:
    """A zip archive."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", how.pop("compression", zipfile.ZIP_DEFLATED)) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name) if how.get("plain") else name, data)
    return buffer.getvalue()


def in_archive(data: bytes, folder: Path) -> list[FoundFile]:
    (folder / "all.zip").write_bytes(data)
    return list(find(folder / "all.zip"))


def test_archives_within_archives(tmp_path: Path) -> None:
    inner = zipped({"a.json": saved(), "deep.zip": zipped({"b.json": "x"})})
    found = in_archive(zipped({"Zoë Ö.zip": inner, "__MACOSX/._a.json": "x", ".DS_Store": "x", "c/": ""}), tmp_path)
    assert [file.parts for file in found] == [("Zoë Ö.zip", "a.json"), ("Zoë Ö.zip", "deep.zip", "b.json")]
    assert found[0].data == saved()


def test_names_without_a_coding(tmp_path: Path) -> None:
    """Windows writes them in its old code page, macOS in UTF-8; neither says so."""
    for coding in ("cp437", "utf-8"):
        data = zipped({"Mxller/a.json": "x", "x" * 9: ""}).replace(
            b"Mxller", "Müller".encode(coding).ljust(6, b"r")[:6]
        )
        name = in_archive(data, tmp_path)[0].parts[0]
        assert name == ("Müller" if coding == "cp437" else "Mülle")


def test_paths_in_archives_lead_nowhere(tmp_path: Path) -> None:
    found = in_archive(zipped({"../../etc/a.json": "x", "/root/b.json": "y", "c:\\d\\e.json": "z"}), tmp_path)
    assert {file.parts for file in found} == {("etc", "a.json"), ("root", "b.json"), ("c:", "d", "e.json")}
    assert [path.name for path in tmp_path.iterdir()] == ["all.zip"]


def _link() -> bytes:
    link = zipfile.ZipInfo("a.json")
    link.external_attr = 0o120777 << 16
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr(link, "/etc/passwd")
    return buffer.getvalue()


def _locked() -> bytes:
    data = bytearray(zipped({"a.json": "x"}))
    data[6] |= 1
    data[data.rindex(b"PK\x01\x02") + 8] |= 1
    return bytes(data)


def _within(depth: int) -> bytes:
    data = zipped({"a.json": "x"})
    for _ in range(depth):
        data = zipped({"z.zip": data})
    return data


ODD = {
    "link": (_link(), "it is a link, or no file"),
    "locked": (_locked(), "it is locked with a password"),
    "damaged": (
        zipped({"a.json": "xx"}, compression=zipfile.ZIP_STORED).replace(b"xx", b"xy"),
        "it is damaged in its archive",
    ),
    "broken off": (zipped({"a.json": "x" * 100})[:60], "it is no zip archive that can be read"),
    "empty": (b"", "it is no zip archive that can be read"),
    "too deep": (_within(4), "it is an archive within 4 others"),
    "other": (zipped({"a.tar.gz": "x"}), "unpack it first: of archives, zip is read"),
    "film": (zipped({"a.mp4": "x"}), "it is no file of answers"),
    "bzip2": (
        zipped({"a.json": "x"}, compression=zipfile.ZIP_BZIP2),
        "it is packed in a way that is not read here; unpack the archive first",
    ),
}


@pytest.mark.parametrize("what", ODD)
def test_an_odd_archive_is_named(what: str, tmp_path: Path) -> None:
    data, why = ODD[what]
    assert [file.why for file in in_archive(data, tmp_path)] == [why]


def test_a_bomb_is_read_no_further_than_answers_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (file,) = in_archive(zipped({"a.json": b"x" * 20_000_000}), tmp_path)
    assert len(file.data) == 1_000_001
    monkeypatch.setattr("rosspin.hand_ins.archives.ON_DISK", Bounds(1000, 1_500_000, 10_000_000, 1_000_000))
    many = zipped({f"{n}.json": b"x" * 1_000_000 for n in range(5)} | {"z.zip": zipped({"a.json": b"x" * 9_000_000})})
    assert "there is too much in all; have it judged in parts" in [file.why for file in in_archive(many, tmp_path)]


def test_links_in_folders_are_not_followed(tmp_path: Path) -> None:
    (tmp_path / "secret.json").write_bytes(saved())
    (tmp_path / "all" / "ada" / ".git").mkdir(parents=True)
    (tmp_path / "all" / "ada" / ".git" / "a.json").write_bytes(saved())
    (tmp_path / "all" / "ada" / "a.json").symlink_to(tmp_path / "secret.json")
    (tmp_path / "all" / "ben").symlink_to(tmp_path / "all")
    why = "it is a link, or no file"
    assert [(file.path, file.why) for file in find(tmp_path / "all")] == [("ben", why), ("ada/a.json", why)]


def many_names(number: int, name: bytes = b"a") -> bytes:
    """An archive whose list says that it has so many files, none of which is there."""
    entry = struct.pack("<IHHHHHHIIIHHHHHII", 0x02014B50, 20, 20, 0, 0, 0, 0x21, 0, 0, 0, len(name), *[0] * 6) + name
    size = len(entry) * number
    ends = struct.pack("<IQHHIIQQQQ", 0x06064B50, 44, 45, 45, 0, 0, number, number, size, 0)
    ends += struct.pack("<IIQI", 0x07064B50, 0, size, 1)
    return entry * number + ends + struct.pack("<IHHHHIIH", 0x06054B50, 0, 0, 0xFFFF, 0xFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0)


TOO_MUCH = {
    "names": lambda: many_names(1_000_000),
    "names of answers": lambda: many_names(100_000, b"slow-timer.py"),
    "archives": lambda: zipped({f"{number}.zip": many_names(15_000) for number in range(20)}),
    "within archives": lambda: zipped({"a.zip": zipped({"b.zip": many_names(300_000)})}),
    "bytes": lambda: zipped({f"{number}.py": b"#" * 1_000_000 for number in range(60)}),
    "zeros": lambda: zipped({"a.zip": bytes(300_000_000)}),
}


@pytest.mark.parametrize("what", TOO_MUCH)
def test_one_archive_with_too_much_in_it_costs_little_and_the_others_nothing(what: str, tmp_path: Path) -> None:
    right = zipped({"slow-timer.py": "x = 1"})
    found = in_archive(zipped({"ada.zip": right, "eve.zip": TOO_MUCH[what](), "zoe.zip": right}), tmp_path)
    ada, *eve, zoe = found
    assert ada.data == zoe.data == b"x = 1" and zoe.parts == ("zoe.zip", "slow-timer.py")
    assert eve[-1].why == "there is too much in it" and len(eve) <= 20_000
    assert sum(len(file.data) for file in eve) <= 40_000_000


@pytest.mark.parametrize("what", ["names", "names of answers"])
def test_too_much_in_all_is_said_once(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.hand_ins.archives.ON_DISK", ON_DISK._replace(entries=1000))
    (file,) = in_archive(TOO_MUCH[what](), tmp_path)
    assert file.why == "there is too much in all; have it judged in parts"
    (tmp_path / "all").mkdir()
    for number in range(1001):
        (tmp_path / "all" / str(number)).touch()
    assert [file.why for file in find(tmp_path / "all")] == ["there is too much in all; have it judged in parts"]


def test_folders_deeper_than_python_goes(tmp_path: Path) -> None:
    before = os.open(".", os.O_RDONLY)
    try:
        os.chdir(tmp_path)
        for _ in range(1500):
            os.mkdir("d")
            os.chdir("d")
        Path("slow-timer.py").write_text("x = 1")
        (file,) = find(tmp_path)
        # pytest could not remove them, three runs later.
        os.remove("slow-timer.py")
        for _ in range(1500):
            os.chdir("..")
            os.rmdir("d")
    finally:
        os.fchdir(before)
        os.close(before)
    assert len(file.parts) == 1501 and file.data == b"x = 1"


# Reads a file in 10 s of a processor, or is killed.
READS = """import resource, sys
from pathlib import Path
from rosspin.hand_ins.students import Class
resource.setrlimit(resource.RLIMIT_CPU, (10, 10))
found = Class()
found.add(Path(sys.argv[1]))
print(*(why for _, why in found.refused), *(len(row.answers) for row in found.rows))
"""
MARKS = "a" + "\u0301\u0316" * 150_000
SLOW: dict[str, tuple[str, str | bytes]] = {
    "cells that do not end": ("a.md", "```{code-cell}\n" * 66_000),
    "marks on a letter": ("a.json", json.dumps(MADE | {"name": MARKS}, ensure_ascii=False)),
    "marks in names of files": ("a.zip", zipped({f"{MARKS[:16_000]}{n}/slow-timer.py": "x = 1" for n in range(50)})),
}


@pytest.mark.parametrize("what", SLOW)
def test_no_file_takes_long_to_read(what: str, tmp_path: Path) -> None:
    name, data = SLOW[what]
    (tmp_path / name).write_bytes(data if isinstance(data, bytes) else data.encode())
    done = subprocess.run([sys.executable, "-c", READS, str(tmp_path / name)], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.strip(), done.stderr


def test_what_is_refused_is_not_said_of_ten_thousand_files(tmp_path: Path) -> None:
    (tmp_path / "all.zip").write_bytes(zipped({f"{number}.exe": "" for number in range(10_000)}))
    found = Class()
    found.add(tmp_path / "all.zip")
    assert len(found.refused) == 501
    assert found.refused[-1] == ("...", "9500 more files, for such reasons")


# --- who is who -------------------------------------------------------------------------------------------------------


def class_of(folder: Path, files: dict[str, bytes | str]) -> Class:
    """What was handed in as such files, by their paths."""
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())
    found = Class()
    found.add(folder)
    return found


def test_moodle_canvas_and_gradescope_say_who_sent_it(tmp_path: Path) -> None:
    found = class_of(
        tmp_path,
        {
            "Ada Müller_123_assignsubmission_file_/rosspin-answers-Ada.json": saved(),
            "Ben B_124_assignsubmission_file_answers.json": saved(name="Ben"),
            "Cy C_125_assignsubmission_file_/slow-timer.py": "x = 1",
            "Cy C_125_assignsubmission_file_/two-timers.py": "x = 1",
            "Di D_126_assignsubmission_file_/report.pdf": "x",
            "doeeve_LATE_5001_70001_slow-timer.py": "x = 1",
            "doeeve_5001_70002_slow-timer-1.py": "x = 2",
            "submission_77/answers.json": saved(name="Flo"),
            "roegus_5002_70003_all.zip": zipped({"answers/slow-timer.py": "x = 3"}),
        },
    )
    told = [(row.name, row.sender, row.late, list(row.answers), row.note) for row in found.rows]
    assert told == [
        ("Ada", "Ada Müller", False, ["ten-hertz"], ""),
        ("Ben", "Ben B", False, ["ten-hertz"], ""),
        ("Cy C", "Cy C", False, ["slow-timer", "two-timers"], ""),
        ("Di D", "Di D", False, [], "refused: it is no file of answers"),
        ("doeeve", "doeeve", True, ["slow-timer"], ""),
        ("Flo", "submission_77", False, ["ten-hertz"], ""),
        ("roegus", "roegus", False, ["slow-timer"], ""),
    ]
    assert [row.sender_id for row in found.rows] == ["123", "124", "125", "126", "5001", "77", "5002"]
    assert found.rows[4].answers == {"slow-timer": "x = 2"}
    assert found.notes == [
        "doeeve_LATE_5001_70001_slow-timer.py is left out: "
        "doeeve_5001_70002_slow-timer-1.py answers slow-timer after it."
    ]


def test_names_are_in_the_order_of_their_letters(tmp_path: Path) -> None:
    names = ["team 9", "Team 10", "Đorđe", "Ümit", "Øyvind", "Zoë", "Ada"]
    found = class_of(tmp_path, {f"{name}/slow-timer.py": "x = 1" for name in names})
    assert [row.name for row in found.rows] == ["Ada", "Đorđe", "Øyvind", "team 9", "Team 10", "Ümit", "Zoë"]


def test_a_folder_for_each_student(tmp_path: Path) -> None:
    """Files that name no student are whose folder they are in; those that do are theirs, wherever they are."""
    found = class_of(
        tmp_path / "class",
        {
            "ada/slow-timer.py": "x = 1",
            "ada/README.md": "mine",
            "ada/src/two-timers.py": "x = 2",
            "ben.zip": zipped({"answers/slow-timer.py": "x = 3"}),
            "week 1/a.json": saved(name="Cy"),
            "week 1/b.json": saved(name="Di"),
            "week 1/package.json": "{}",
            "eve/film.mp4": "",
            "list.csv": "",
        },
    )
    assert [(row.name, len(row.answers)) for row in found.rows] == [
        ("ada", 2),
        ("ben", 1),
        ("Cy", 1),
        ("Di", 1),
        ("eve", 0),
    ]
    assert [file for file, _ in found.refused] == ["list.csv", "eve/film.mp4"]


def test_the_folder_of_a_single_student(tmp_path: Path) -> None:
    found = class_of(tmp_path / "spin-ada", {"slow-timer.py": "x = 1", "README.md": "x", "test/check.py": "x"})
    assert [(row.name, list(row.answers)) for row in found.rows] == [("spin-ada", ["slow-timer"])]
    assert found.refused == [
        ("test/check.py", "neither its name nor its first line names an exercise, as slow-timer.py does")
    ]


def test_of_one_student_s_files_the_newest_counts_as_on_the_page(tmp_path: Path) -> None:
    days = [f"2026-11-{day}T12:00:00.000Z" for day in (20, 21, 22)]
    found = class_of(
        tmp_path,
        {
            "b.json": saved(name="Sam", date=days[1]),
            "c.json": saved(name="Sam", date=days[0]),
            "d.json": saved(name="Sam", date=days[2], answers={"cpp-ticks": ""}),
            "e.json": saved(name="Sam", id="a2"),
        },
    )
    assert [(row.name, row.file) for row in found.rows] == [("Sam", "d.json"), ("Sam", "e.json")]
    assert found.notes == [
        "c.json is left out: Sam handed in b.json after it.",
        "d.json takes the place of b.json, which Sam handed in before.",
    ]


def test_an_exercise_that_there_is_not_is_a_column_of_its_own(tmp_path: Path) -> None:
    found = class_of(tmp_path, {"a.json": saved(answers={"zz-top": "", "slow-timer": "", "make-it-10-hz": ""})})
    assert found.exercises == ["make-it-10-hz", "slow-timer", "zz-top"]
