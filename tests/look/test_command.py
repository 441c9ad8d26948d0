"""``rosspin look``: what it prints, its plot and its JSON, and that bad input ends in a clear line."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from rosspin.__main__ import main
from tests.helpers.tree import ROOT, TESTS

VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
LOGS = TESTS / "look/recorded"
BLOCKED = str(LOGS / "r2_blocks_two.log")


def test_the_report(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["look", BLOCKED]) == 0
    assert capsys.readouterr() == (
        f"""\
{BLOCKED}: console, 430 entries in 15.4 s

entries    rate   period  late, 98%  missing  line
    296   25 Hz    40 ms    18.6 ms       90  base: odometry: #
    124   10 Hz   100 ms    72.2 ms       30  base: battery: #
     10  0.7 Hz  1429 ms   0.597 ms        0  base: map: #

A slow callback that blocks its neighbours (sure)
  “base: odometry: #” and “base: battery: #” were silent 10 times, for up to 0.429 s.
  “base: map: #” came just before 10 of these 10.
  While that callback works, the others of its thread or group wait.
  See docs/how-to/look-at-your-log.html#look-blocked
""",
        "",
    )


def test_standard_input(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(Path(BLOCKED).read_bytes())))
    assert main(["look", "-"]) == 0
    assert capsys.readouterr().out.startswith("standard input: console, 430 entries")


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["look", BLOCKED, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["verdicts"][0]["name"] == "blocked"
    assert found["series"][0]["period"] == pytest.approx(0.04, rel=1e-3)


def test_json_of_what_is_not_regular(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["look", str(LOGS / "r2_events.log"), "--json"]) == 0
    irregular = [each for each in json.loads(capsys.readouterr().out)["series"] if not each["period"]]
    assert irregular and not any(each["chosen"] or each["drift"] or each["late"] for each in irregular)


@pytest.mark.parametrize(("suffix", "begins"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")])
def test_a_plot(tmp_path: Path, suffix: str, begins: bytes) -> None:
    plot = tmp_path / f"look.{suffix}"
    assert main(["look", BLOCKED, "--plot", str(plot)]) == 0
    assert plot.read_bytes().startswith(begins)


def test_dollars_are_no_mathematics(tmp_path: Path) -> None:
    log = tmp_path / "log"
    log.write_text("".join(f"[INFO] [{n}.5]: costs $x_{{$ {n}\n" for n in range(20)))
    assert main(["look", str(log), "--plot", str(tmp_path / "a.png")]) == 0


def test_without_a_regular_line_there_is_no_plot(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    plot = tmp_path / "a.svg"
    assert main(["look", str(LOGS / "r2_events.log"), "--plot", str(plot)]) == 1
    out, err = capsys.readouterr()
    assert "I cannot tell" in out and err == f"rosspin: {plot} was not written: there are no ticks to plot\n"


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("a.log", b"", "the file is empty"),
        ("a.log", bytes(range(256)), "this is no text: give it a console log, a table of rostopic"),
        ("a.bag", (LOGS / "r1_bag_20.bag").read_bytes()[:3000], "this .bag is broken, or not whole"),
    ],
)
def test_bad_files(capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str, data: bytes, says: str) -> None:
    file = tmp_path / name
    file.write_bytes(data)
    assert main(["look", str(file)]) == 1
    out, err = capsys.readouterr()
    assert out == "" and err.startswith(f"rosspin: {file}: {says}") and err.count("\n") == 1


def test_no_such_file(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["look", "no/such.log"]) == 1
    assert capsys.readouterr().err == "rosspin: no/such.log: No such file or directory\n"


# --- what is printed and written --------------------------------------------------------------------------------------


@pytest.mark.parametrize("words", [["look", BLOCKED], ["look", BLOCKED, "--json"], ["--version"]])
def test_nobody_has_to_read_to_the_end(words: list[str]) -> None:
    """As with ``| head``: a shell gives 128 + 13 for it."""
    reader, writer = os.pipe()
    os.close(reader)
    with open(writer, "wb") as nobody:
        done = subprocess.run([sys.executable, "-m", "rosspin", *words], stdout=nobody, stderr=subprocess.PIPE)
    assert (done.returncode, done.stderr) == (141, b"")


def test_the_version(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert (ended.value.code, capsys.readouterr().out) == (0, f"rosspin {VERSION}\n")


# Files of more than 1000 bytes cannot be written, as on a disk that is full.
FULL = """
import resource, sys, matplotlib.font_manager
from rosspin.__main__ import main
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.parametrize(("option", "older"), [("--test", ()), ("--plot", ()), ("--plot", ("a.svg",))])
def test_on_a_full_disk_no_part_of_a_file_is_left(tmp_path: Path, option: str, older: tuple[str, ...]) -> None:
    for name in older:
        (tmp_path / name).write_text("older")
    target = tmp_path / ("a.svg" if option == "--plot" else "")
    done = subprocess.run(
        [sys.executable, "-B", "-c", FULL, "look", BLOCKED, option, str(target)], capture_output=True, text=True
    )
    assert done.returncode == 1 and "File too large" in done.stderr and str(tmp_path) in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(older)
    assert all((tmp_path / name).read_text() == "older" for name in older)
