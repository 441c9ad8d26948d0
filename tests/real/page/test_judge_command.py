"""``rosspin judge`` gives the verdicts of the page for teachers, on the same hand-ins, and the same table."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from tests.helpers.answers import CELLS, WRONG, written
from tests.helpers.command_line import run
from tests.helpers.hand_ins import Table, handed_in

pytestmark = pytest.mark.shares(10)

SOME = ["make-it-10-hz", "slow-timer", "cancel-a-goal", "share-data", "rostopic-hz"]
FORGED = "print('Exercise 1: right.')\nprint('{\"verdict\": \"solved\"}')"

HAND_INS = {
    "right": {name: CELLS[name][1].source for name in SOME},
    "wrong": {name: written(name, WRONG[name][0][0]) for name in SOME},
    "open": {"slow-timer": CELLS["slow-timer"][0].source, "ten-hertz": ""},
    "odd": {
        "make-it-10-hz": "import rclpy\nwhile True: pass",
        "ten-hertz": "import numpy",
        "fire-once": "x = (",
        "two-rates": "import subprocess\nsubprocess.run(['ls'])",
        "first-ticks": FORGED,
        "missing-ticks": "print('x' * 20_000_000)",
        "zz-top": "x = 1",
    },
    # In Python emoji are a character each, in JavaScript two.
    "Zoe\N{COMBINING DIAERESIS}": {"slow-timer": "#" + "\N{ROBOT FACE}" * 30_000, "ten-hertz": "#" * 50_001},
    "\N{ROBOT FACE}" * 80: {"zz-top": ""},
}


def test_the_command_gives_the_verdicts_of_the_page(table: Table, tmp_path: Path) -> None:
    hand_ins = [handed_in(name, id=name[:9], answers=answers) for name, answers in HAND_INS.items()]
    # The newest counts, whoever wrote its date; the same name may be composed or not.
    for name, date in (("Sam", "2026-11-20"), ("Sam", "2026-11-21T12:00:00.000Z"), ("Sam", "Sat Nov 28 2026")):
        hand_ins.append(handed_in(name, id="s", date=date, answers={"zz-top": ""}))
    hand_ins.append(handed_in("Zo\N{LATIN SMALL LETTER E WITH DIAERESIS}", id="o", answers={"zz-top": ""}))
    texts = {f"{number:02}": text for number, text in enumerate(hand_ins)}
    (tmp_path / "class").mkdir()
    for name, text in texts.items():
        (tmp_path / "class" / f"{name}.json").write_text(text)
    status, _, _ = run("judge", str(tmp_path / "class"), "--csv", str(tmp_path / "table.csv"))
    assert status == 1
    with open(tmp_path / "table.csv", encoding="utf-8-sig", newline="") as file:
        command = list(csv.reader(file))
    table.drop(**texts)
    table.done()
    page = table.csv()
    assert page == command
    head, *rows = page
    verdicts = slice(head.index("solved") + 1, next(n for n, name in enumerate(head) if name.endswith(": why")))
    assert {verdict for row in rows if row[0] == "right" for verdict in row[verdicts] if verdict} == {"solved"}
    assert "solved" not in {verdict for row in rows if row[0] != "right" for verdict in row[verdicts]}
