"""``rosspin look``: what it prints, its plot and its JSON, and that bad input ends in a clear line."""

from __future__ import annotations

import io
import json
import sqlite3
import sys
from pathlib import Path
from typing import Any

import pytest
from tree import TESTS

from rosspin.__main__ import main
from rosspin.look import NoLog, look

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
  While that callback works, those of the same thread or group wait.
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
        ("a.bag", (LOGS / "r1_bag_20.bag").read_bytes()[:5000], "this .bag is broken, or not whole"),
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


# --- bags -------------------------------------------------------------------------------------------------------------

SPEED = [(1_700_000_000_000_000_000 + n * 50_000_000 + n % 5 * 100_000, n) for n in range(60)]


@pytest.mark.parametrize("suffix", ["db3", "mcap"])
def test_bags_of_ros_2(tmp_path: Path, suffix: str) -> None:
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    types = get_typestore(Stores.ROS2_JAZZY)
    plugin = {"db3": StoragePlugin.SQLITE3, "mcap": StoragePlugin.MCAP}[suffix]
    with Writer(tmp_path / "bag", version=9, storage_plugin=plugin) as bag:
        connection = bag.add_connection("/speed", "std_msgs/msg/Int64", typestore=types)
        for time, number in SPEED:
            bag.write(
                connection, time, types.serialize_cdr(types.types["std_msgs/msg/Int64"](number), connection.msgtype)
            )
    (file,) = (tmp_path / "bag").glob(f"*.{suffix}")
    found = look(file.read_bytes(), file.name)
    assert (found.kind, found.entries, found.series[0].name) == ("bag", 60, "/speed")
    assert found.series[0].period == pytest.approx(50e6, rel=1e-3)
    assert found.verdicts[0].name == "healthy"


def test_without_rosbags_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.look.bags.find_spec", lambda name: None)
    with pytest.raises(NoLog, match=r"a .bag needs the package rosbags: pip install 'rosspin\[bags\]'"):
        look((LOGS / "r1_bag_20.bag").read_bytes())


def test_in_a_page_it_says_where_bags_are_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rosspin.look.bags", None)
    with pytest.raises(NoLog, match="this is a bag, which is read on your computer only"):
        look((LOGS / "r1_bag_20.bag").read_bytes())


def test_a_database_that_is_no_bag(tmp_path: Path) -> None:
    database: Any = sqlite3.connect(tmp_path / "a.db3")
    database.execute("CREATE TABLE other (number)")
    database.commit()
    database.close()
    with pytest.raises(NoLog, match="this .db3 is broken, or not whole: no such table"):
        look((tmp_path / "a.db3").read_bytes())


@pytest.mark.parametrize(
    ("time", "topic", "says"),
    [
        (None, "/speed", "a message on '/speed' has the time None"),
        (1.5, "/speed", "a message on '/speed' has the time 1.5"),
        ("soon", "/speed", "a message on '/speed' has the time 'soon'"),
        (17, b"/speed", "a message on b'/speed' has the time 17"),
    ],
)
def test_a_db3_whose_columns_hold_something_else(tmp_path: Path, time: object, topic: object, says: str) -> None:
    database: Any = sqlite3.connect(tmp_path / "a.db3")
    database.execute("CREATE TABLE topics (id, name)")
    database.execute("CREATE TABLE messages (topic_id, timestamp)")
    database.execute("INSERT INTO topics VALUES (1, ?)", [topic])
    database.execute("INSERT INTO messages VALUES (1, ?)", [time])
    database.commit()
    database.close()
    with pytest.raises(NoLog, match=f"this .db3 is broken, or not whole: {says}"):
        look((tmp_path / "a.db3").read_bytes())
