"""A teacher adds a lesson as the how-to says, word by word, in a copy of the site; the page runs and judges it."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from shlex import quote

import pytest

from tests.helpers.author import copied, listed_in, typed
from tests.helpers.lesson import COMMANDS, FILES

pytestmark = pytest.mark.shares(10)


def test_the_how_to_is_a_way_to_a_lesson(tmp_path: Path) -> None:
    tree = copied(tmp_path, ["docs/how-to/info-lines.rst", "docs/glossary.rst"])
    make, run_bit, listed_page, build, judge = COMMANDS
    assert (build, judge) == ("make html", ".venv/bin/rosspin judge faster-heartbeat.py")
    assert typed(make, tree).returncode == 0
    for path, text in FILES.items():
        (tree / path).write_text(text)

    # What is forgotten is listed: the run bit.
    run = typed(build, tree)
    assert run.returncode != 0
    assert run_bit in listed_in(run.stdout)
    assert typed(run_bit, tree).returncode == typed(listed_page, tree).returncode == 0
    assert "   A heartbeat <docs/heartbeat>\n" in (tree / "index.rst").read_text()
    run = typed(build, tree)
    assert run.returncode == 0, run.stdout + run.stderr
    page = (tree / "build/html/docs/heartbeat.html").read_text()
    assert "its heart beats 4 times" in page and "data-positions=" in page and 'id="faster-heartbeat"' in page
    hints = re.findall(r"<summary>(Hint \d|Show the solution)</summary>", page)
    assert hints == ["Hint 1", "Hint 2", "Show the solution"]
    assert re.search(r"<p class=\"rubric\">Exercise \d+: A faster heartbeat</p>", page)

    # What shows the exercise is made again with it, and nothing else.
    (tree / "lessons/faster_heartbeat.py").write_text(
        FILES["lessons/faster_heartbeat.py"].replace("in seconds", "in s")
    )
    run = typed(build, tree)
    assert run.returncode == 0, run.stdout + run.stderr
    plain = re.sub(r"\x1b\[[\d;]*m", "", run.stdout)  # in CI Sphinx writes in colours
    assert re.findall(r"reading sources\.\.\. \[ *\d+%\] (\S+)", plain) == ["docs/heartbeat"]
    assert "period, in s." in (tree / "build/html/docs/heartbeat.html").read_text()

    # Without its solution.
    (tree / "docs/heartbeat.rst").write_text(FILES["docs/heartbeat.rst"].replace("\n   :solution:\n", "\n"))
    assert typed(build, tree).returncode == 0
    assert "Show the solution" not in (tree / "build/html/docs/heartbeat.html").read_text()

    # An answer is judged.
    node = FILES["lessons/faster_heartbeat.py"].partition("NODE = '''\n")[2].partition("'''")[0]
    for period, status in (("0.5", 1), ("0.25", 0)):
        (tree / "faster-heartbeat.py").write_text(node.replace("0.5", period))
        run = typed(judge.replace(".venv/bin/rosspin", f"{quote(sys.executable)} -m rosspin"), tree)
        assert run.returncode == status, run.stdout + run.stderr
