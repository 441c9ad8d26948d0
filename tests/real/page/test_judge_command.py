"""``rosspin judge`` gives the verdicts of the page for teachers, on the same hand-ins."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from answers import CELLS, NAMES, number_of, written
from answers_ros1 import WRONG
from command_line import run
from hand_ins import Table, handed_in

pytestmark = pytest.mark.shares(2)

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
}


def test_the_command_gives_the_verdicts_of_the_page(table: Table, tmp_path: Path) -> None:
    texts = {name: handed_in(name, id=name, answers=answers) for name, answers in HAND_INS.items()}
    for name, text in texts.items():
        (tmp_path / f"{name}.json").write_text(text)
    status, out, _ = run("judge", str(tmp_path), "--json")
    assert status == 1
    command = {
        (student["name"], name): answer["verdict"]
        for student in json.loads(out)["students"]
        for name, answer in student["answers"].items()
    }
    table.drop(**texts)
    table.done()
    head, *rows = table.csv()
    names = {f"exercise {number_of(name)}" if name in NAMES else f"exercise {name}": name for _, name in command}
    page = {
        (row[0], names[column.partition(":")[0]]): verdict
        for row in rows
        for column, verdict in zip(head[9:], row[9:], strict=True)
        if verdict
    }
    assert page == command
    assert {verdict for (name, _), verdict in page.items() if name == "right"} == {"solved"}
    assert "solved" not in {verdict for (name, _), verdict in page.items() if name != "right"}
