"""What the page on judging promises: each cell of its table is held by a test, unless there is nothing to hold."""

from __future__ import annotations

import re
from textwrap import dedent, indent

import pytest

from rosspin import hand_ins
from rosspin.grading import sealed, worker
from rosspin.grading.filtered import _PROCESSORS
from tests.helpers.tree import ROOT, TESTS

PAGE = (ROOT / "docs/how-to/judge-hand-ins.rst").read_text(encoding="utf-8")
HELD_IN = "\n".join(
    (TESTS / f"real/grading/test_{name}.py").read_text(encoding="utf-8") for name in ("judge", "sealed")
)

# Each of these attacks in tests/helpers/hostile.py, as root and as another user.
ATTACKS = "test_no_attack_gets_in"

SEALED = "bubblewrap, also as root"
LINUX, CONTAINER, MACOS = "without, Linux", "without, in a container", "without, macOS"
_KEPT = {
    LINUX: "test_what_is_kept_from_an_answer_without_bubblewrap",
    CONTAINER: "test_in_a_container_that_allows_no_bubblewrap",
}

# What holds the cells of a row, by its columns. On macOS nothing is tried.
HELD = {
    "is judged": {
        SEALED: "test_wherever_the_package_and_the_teacher_s_exercises_are",
        LINUX: "test_without_a_seal_nothing_is_judged_until_that_is_allowed",
        CONTAINER: _KEPT[CONTAINER],
    },
    "decides on its verdict": {SEALED: "test_nothing_that_an_answer_does_is_solved"},
    "changes or reads another answer": {SEALED: "test_an_answer_ends_nothing_of_the_next_one"},
    "reads": {SEALED: ATTACKS, CONTAINER: _KEPT[CONTAINER]},
    "writes": {SEALED: "test_an_answer_that_makes_files_without_end_is_ended", CONTAINER: _KEPT[CONTAINER]},
    "sees your environment": {SEALED: ATTACKS},
    "opens devices, or your terminal": {SEALED: ATTACKS, CONTAINER: _KEPT[CONTAINER]},
    "reaches the network, or services of yours through a socket": {SEALED: ATTACKS, **_KEPT},
    "starts or signals processes": {SEALED: ATTACKS, **_KEPT},
    "takes": {SEALED: "test_an_answer_that_never_ends_is_ended", **_KEPT},
    "continues after the command has ended, or was killed": dict.fromkeys(
        (SEALED, LINUX, CONTAINER), "test_nothing_outlives_the_judge"
    ),
}


def table() -> dict[str, dict[str, str]]:
    """The cells, by their rows and columns."""
    (text,) = re.findall(r":class: rosspin-promises\n\n(.*?)\n\n(?=\S)", PAGE, re.DOTALL)
    text = indent(dedent(text), "   ")
    (_, *columns), *rows = ([cell.strip() for cell in row.split("\n     - ")] for row in text.split("   * - ")[1:])
    return {name: dict(zip(columns, cells, strict=True)) for name, *cells in rows}


@pytest.mark.parametrize("row", HELD)
def test_each_cell_has_its_test(row: str) -> None:
    promises = re.compile(r"(?!no promise|what you can)")
    promised = {column for column, cell in table()[row].items() if promises.match(cell) and column != MACOS}
    assert promised == set(HELD[row])
    assert {test for test in HELD[row].values() if f"\ndef {test}(" not in HELD_IN} == set()


def test_no_row_is_left_out() -> None:
    assert list(table()) == list(HELD)


def test_the_limits_are_the_code_s() -> None:
    takes, writes = table()["takes"], table()["writes"]
    most = f"{hand_ins.TIME} s, {worker._MEMORY / 2**30:g} GiB"
    assert takes == {
        SEALED: f"{most}, {worker._THREADS} threads",
        **dict.fromkeys((LINUX, CONTAINER), most),
        MACOS: f"{hand_ins.TIME} s",
    }
    assert writes[SEALED].startswith(f"{sealed._FOLDER / 2**20:g} MiB and {worker._MADE} files ")
    assert f"Sealing needs {' or '.join(_PROCESSORS)}, " in PAGE
