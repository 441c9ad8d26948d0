"""``rosspin judge`` where something continues: an answer that never ends is ended, and so is the command by Ctrl-C."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

from tests.helpers.answers import CELLS
from tests.helpers.command_line import NEVER

ENDLESS = "sum(iter(int, 1))"  # gives way to nothing

# With a tenth of the time that an answer may take.
_SOON = "from rosspin.grading import pool; pool.TIME = 2; from rosspin.__main__ import main; raise SystemExit(main())"


def _class(folder: Path, **answers: str) -> None:
    made = {"format": "rosspin-answers", "version": 2, "name": "Eve", "id": "e"}
    made["answers"] = {name.replace("_", "-"): text for name, text in answers.items()}
    (folder / "eve.json").write_text(json.dumps(made))


def test_an_answer_that_never_ends_is_ended(tmp_path: Path) -> None:
    """As on the page, and the next one is judged; nothing of it continues."""
    _class(tmp_path, ten_hertz=ENDLESS, two_rates=ENDLESS, slow_timer=CELLS["slow-timer"][1].source)
    command = [sys.executable, "-c", _SOON, "judge", "eve.json", "--json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=NEVER)
    assert done.returncode == 1
    (eve,) = json.loads(done.stdout)["students"]
    said = {name: (answer["verdict"], answer["said"]) for name, answer in eve["answers"].items()}
    assert said["ten-hertz"] == said["two-rates"] == ("did not end", "It was ended after 2 s.")
    assert said["slow-timer"][0] == "solved"


def test_ctrl_c_keeps_what_has_been_judged(tmp_path: Path) -> None:
    _class(tmp_path, slow_timer=CELLS["slow-timer"][1].source, ten_hertz=ENDLESS)
    command = [sys.executable, "-m", "rosspin", "judge", "eve.json", "--csv", "table.csv", "--json"]
    screen, terminal = os.openpty()
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=terminal, text=True) as child:
        os.close(terminal)
        shown = b""
        while b"1 of 2 answers" not in shown:
            shown += os.read(screen, 1000)
        child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=NEVER)
    os.close(screen)
    assert child.returncode == 130
    (eve,) = json.loads(out)["students"]
    verdicts = {name: answer["verdict"] for name, answer in eve["answers"].items()}
    assert verdicts == {"slow-timer": "solved", "ten-hertz": "stopped"}
    assert "stopped" in (tmp_path / "table.csv").read_text()
