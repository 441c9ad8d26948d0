"""``rosspin judge``: the verdicts of the site's own check, whatever an answer does, in words, as CSV and as JSON."""

from __future__ import annotations

import csv
import io
import json
import os
import re
import signal
import subprocess
import sys
import termios
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from rosspin.__main__ import main
from rosspin.exercises import Verdict, trace, verdict
from rosspin.grading.pool import Pool, Task
from tests.helpers.answers import CELLS, NAMES, WRONG, answer_in, written
from tests.helpers.command_line import NEVER

pytestmark = pytest.mark.shares(5)

SOLVED = CELLS["slow-timer"][1].source
OPEN = CELLS["slow-timer"][0].source
WRONG_TIMER = "%%answer slow-timer\nafter_1_0_seconds = [1]\n"


@pytest.fixture(scope="module", autouse=True)
def _patient(require: Callable[[str], None]) -> Iterator[None]:
    """Workers of this process, which are sealed, give an answer as long as a busy machine makes it take."""
    require("bwrap")
    with pytest.MonkeyPatch.context() as patient:
        patient.setattr("rosspin.grading.pool.TIME", 300)
        yield


@pytest.fixture(scope="module")
def pool() -> Iterator[Pool]:
    made = Pool()
    yield made
    made.close()


def judged(pool: Pool, *tasks: Task) -> list[Verdict]:
    found: dict[int, Verdict] = {}
    pool.judge(tasks, found.__setitem__)
    return [found[number] for number in range(len(tasks))]


def test_the_verdicts_are_those_of_the_check(pool: Pool) -> None:
    """For each exercise a right and a wrong answer, and one that is open."""
    right = [Task(name, CELLS[name][1].source) for name in NAMES]
    wrong = [Task(name, written(name, WRONG[name][0][0])) for name in NAMES if "still" not in WRONG[name][0][1]]
    *found, last = judged(pool, *right, *wrong, Task("slow-timer", OPEN))
    assert [each.verdict for each in found] == ["solved"] * len(right) + ["not yet"] * len(wrong)
    assert all(each.why and each.hint for each in found[len(right) :])
    text = f"\n{answer_in(CELLS['slow-timer'][0])}"
    assert last == verdict("slow-timer", text, trace("slow-timer", text))


# What an answer may try, and what is then said of it; nothing of it is solved.
HOSTILE = {
    "import os\nos.abort()": ("not judged", "Its Python broke down"),
    "import os\nos._exit(0)": ("not yet", "No counter was printed"),
    "import os\nos.kill(os.getppid(), 9)\nos.killpg(0, 9)": ("", ""),
    "import numpy": ("not yet", "No module named 'numpy'"),
    "import matplotlib": ("not yet", "No module named 'matplotlib'"),
    "import js": ("not yet", "No module named 'js'"),
    "import subprocess\nsubprocess.run(['true'])": ("not yet", "subprocess is not simulated"),
    "import os\nos.fork()": ("not yet", "os.fork is not simulated"),
    "x = 'a' * 10**11": ("not yet", "MemoryError"),
    "open('x', 'w').write('a')\nassert open('x').read() == 'a'": ("not yet", "No counter was printed"),
    "print('x' * 20_000_000)": ("not yet", "No counter was printed"),
    "x = (": ("not yet", "is not Python"),
    "-" * 49_000 + "1": ("not yet", "is not Python"),
    "#" * 50_001: ("not judged", "It has 50001 characters; at most 50000 are judged."),
    "": ("open", "No answer yet."),
    # The way to the teacher: it may write what it likes, and it is no trace; or the trace of a wrong answer.
    "import os\nos.write(3, b'solved')\nos._exit(0)": ("not judged", "The trace does not fit"),
    "import os\nos.write(3, b'[' * 3_000_000)": ("not judged", "Its Python broke down"),  # it sends too much
    'print(\'{"verdict": "solved"}\')': ("not yet", "No counter was printed"),
}


def test_nothing_that_an_answer_does_is_solved(pool: Pool) -> None:
    for text, found in zip(HOSTILE, judged(pool, *(Task("ten-hertz", text) for text in HOSTILE)), strict=True):
        kind, said = HOSTILE[text]
        assert not found.solved and found.verdict.startswith(kind) and said in found.said, (text[:99], found)


def test_an_answer_has_a_gigabyte(pool: Pool) -> None:
    tries = """for size in (1 << 29, 1 << 31):
    try:
        print(len(bytearray(size)))
    except MemoryError:
        print("no")"""
    (found,) = judged(pool, Task("ten-hertz", tries))
    assert found.console == f"{1 << 29}\nno\n"


def test_an_exercise_that_there_is_not(pool: Pool) -> None:
    (found,) = judged(pool, Task("zz-top", "x = 1"))
    assert found.verdict == "not judged" and "there is no exercise 'zz-top'" in found.said


def test_ctrl_c_keeps_what_is_done() -> None:
    own = Pool()
    found = {}
    before = signal.getsignal(signal.SIGINT)

    def done(number: int, verdict: Verdict) -> None:
        found[number] = verdict
        signal.raise_signal(signal.SIGINT)

    own.judge([Task("slow-timer", SOLVED)] * 50, done)
    own.close()
    assert own.stopped and 1 <= len(found) < 10
    assert signal.getsignal(signal.SIGINT) is before


# --- the command ------------------------------------------------------------------------------------------------------


def judge(*args: str, cwd: Path | None = None) -> tuple[int, str, str]:
    """Status, stdout and stderr of ``rosspin judge ARGS`` in a process of its own, as patient as this one."""
    code = "import sys, rosspin.grading.pool as p, rosspin.__main__ as m; p.TIME = 300; sys.exit(m.main())"
    words = [sys.executable, "-c", code, "judge", *args]
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, timeout=NEVER)
    return done.returncode, done.stdout, done.stderr


def handed_in(folder: Path, name: str, **answers: str) -> Path:
    made = {"format": "rosspin-answers", "version": 2, "name": name, "student": f"s-{name}", "id": name}
    made["answers"] = {key.replace("_", "-"): text for key, text in answers.items()}
    (folder / f"{name}.json").write_text(json.dumps(made))
    return folder / f"{name}.json"


def test_a_class(tmp_path: Path) -> None:
    (tmp_path / "all").mkdir()
    handed_in(tmp_path / "all", "Ada", slow_timer=SOLVED, who_calls=CELLS["who-calls"][1].source)
    handed_in(tmp_path / "all", "=Ben", slow_timer=WRONG_TIMER)
    handed_in(tmp_path / "all", "Cy", slow_timer=OPEN)
    (tmp_path / "all" / "film.mp4").write_text("")
    status, out, err = judge("all", "--csv", "table.csv", cwd=tmp_path)
    assert status == 1
    assert out.splitlines() == [
        "=Ben: 0 of 1 solved; not yet: slow-timer",
        "Ada: 2 of 2 solved",
        "Cy: 0 of 1 solved; open: slow-timer",
        "What was hard:",
        "  slow-timer: 1 of 3 solved",
        "    1 × The callback begins at 1.2 s and blocks for 1.0 s. Which ticks are overdue when it returns?",
    ]
    assert err.splitlines()[0] == "film.mp4 is refused: it is no file of answers."
    assert "\r" not in err  # no progress where it is not seen
    data = (tmp_path / "table.csv").read_bytes()
    head, ben, ada, cy, film = csv.reader(io.StringIO(data.decode("utf-8-sig")))
    assert data.startswith(b"\xef\xbb\xbf")
    assert head[:4] == ["name", "student ID", "sent by", "sender ID"] and head[8:] == [
        *("same browser as", "same name in another browser"),
        *("sealed", "answers", "solved", "who-calls", "slow-timer", "who-calls: why", "slow-timer: why"),
    ]
    assert ben[0] == "'=Ben" and ben[1] == "s-=Ben" and ben[13:15] == ["", "not yet"] and ben[-1]
    assert ada[8:] == ["", "", "yes", "2", "2", "solved", "solved", "", ""]
    assert film == [*[""] * 5, "film.mp4", "refused: it is no file of answers", *[""] * (len(head) - 7)]


def _all(screen: int) -> Iterator[str]:
    """What a terminal that is closed has shown."""
    with os.fdopen(screen, newline="") as stream, suppress(OSError):  # as its end is told
        while True:
            yield stream.read(1)


@pytest.mark.parametrize("columns", [80, 24, 0])
def test_progress_is_shown_on_a_terminal(
    columns: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In one line, whatever its width, which is empty in the end."""
    handed_in(tmp_path, "Ada", slow_timer=SOLVED, ten_hertz="x = 1")
    screen, terminal = os.openpty()
    termios.tcsetwinsize(terminal, (24, columns))
    with open(terminal, "w") as stream:
        monkeypatch.setattr(sys, "stderr", stream)
        assert main(["judge", str(tmp_path)]) == 1
        monkeypatch.undo()
    shown = "".join(_all(screen))
    *_, first, second, end = re.split(r"\r(?!\n)", shown)
    assert end == "\x1b[K"
    half, whole = ("#" * 10).ljust(20, "."), "#" * 20
    for line, said in ((first, f"[{half}] 1 of 2 answers, "), (second, f"[{whole}] 2 of 2 answers, 0 s")):
        assert line.startswith(said[: columns - 1 if columns else None]) and line.endswith("\x1b[K")
        assert len(line.removesuffix("\x1b[K")) < (columns or 80)
    assert "\r" not in capsys.readouterr().out


def test_json(tmp_path: Path) -> None:
    ada = handed_in(tmp_path, "Ada", slow_timer=SOLVED)
    status, out, _ = judge(str(ada), "--json")
    found = json.loads(out)
    assert status == 0
    (student,) = found["students"]
    assert (student["name"], student["student"], student["file"], student["solved"]) == ("Ada", "s-Ada", "Ada.json", 1)
    answer = student["answers"]["slow-timer"]
    assert (answer["verdict"], answer["solved"], answer["why"]) == ("solved", True, "")
    assert found["hard"] == found["refused"] == found["notes"] == []


def test_of_a_single_student_all_is_told(tmp_path: Path) -> None:
    (tmp_path / "slow-timer.py").write_text(WRONG_TIMER.partition("\n")[2])
    status, out, _ = judge("slow-timer.py", cwd=tmp_path)
    assert status == 1
    assert out.startswith("slow-timer: not yet\n  Exercise ") and "  - Wrong: " in out and "Hint: " in out
    assert out.endswith(f"{tmp_path.name}: 0 of 1 solved; not yet: slow-timer\n")


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (["nowhere.json"], "rosspin: nowhere.json: No such file or directory\n"),
        (
            [".", "--csv", "nowhere/a.csv"],
            "rosspin: --csv nowhere/a.csv: this is a folder, or there is no such folder\n",
        ),
        ([".", "--csv", "."], "rosspin: --csv .: this is a folder, or there is no such folder\n"),
    ],
)
def test_a_wrong_command_line(
    args: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["judge", *args]) == 2
    assert capsys.readouterr().err == said


def test_without_answers_the_status_is_1(tmp_path: Path) -> None:
    assert judge(".", cwd=tmp_path)[:2] == (1, "")
