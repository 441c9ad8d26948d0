"""The recordings: complete, small, and of runs that went as runs on ROS do."""

from __future__ import annotations

import csv
import json
import math
import signal
from pathlib import Path

import pytest

from rosspin import Run, simulate
from rosspin.results import recordings
from tests.helpers.tree import ROOT

FOLDER = ROOT / "examples" / "recordings"
# No run's ticks; docs/how-timing-works.rst and docs/publish.rst check what they say.
TABLES = {"claims.csv", "clock_jump.csv", "endings.csv", "first_message.csv", "hz.csv", "pipe.csv", "queue.csv"}
# Those on ROS 2 are in a folder of their own.
ROS2 = FOLDER / "ros2"
FILES = sorted(file for file in [*FOLDER.glob("*.csv"), *FOLDER.glob("*.txt")] if file.name not in TABLES)

NAMES = {
    "launch.txt",
    "publish_cpp.txt",
    "publish_py.txt",
    *(
        f"{what}_{language}_{hertz}hz.csv"
        for what in ("timer", "rate")
        for language in ("cpp", "py")
        for hertz in (2, 50)
    ),
    *(f"timer_{language}_blocks_once_{periods}.csv" for language in ("cpp", "py") for periods in (1.4, 2.4, 4.4)),
    *(f"timer_cpp_blocks_{calls}_1.8.csv" for calls in ("once", "twice")),
    *(f"timer_py_blocks_{calls}_2.8.csv" for calls in ("once", "twice")),
    *(f"timer_cpp_blocks_random_{seed}.csv" for seed in (1, 2, 3)),
    *(f"timer_{language}_waits.csv" for language in ("cpp", "py")),
    *(f"timer_{language}_blocks_always_1.6.csv" for language in ("cpp", "py")),
    *(f"two_timers_{how}.csv" for how in ("py", "cpp_spin", "cpp_async")),
}

# The second tick train of a run in which callback number 3, due at 1.5 s, takes so many periods of 0.5 s.
AFTER = {
    ("cpp", 1.4): [2.2, 2.5, 3.0],
    ("cpp", 2.4): [2.7, 3.2, 3.7],
    ("cpp", 4.4): [3.7, 4.2, 4.7],
    ("py", 1.4): [2.2, 2.5, 3.0],
    ("py", 2.4): [2.7, 2.7, 3.0],
    ("py", 4.4): [3.7, 4.2, 4.7],
}


def test_the_set_is_complete() -> None:
    assert {file.name for file in FILES} == NAMES
    assert {file.stem for file in FOLDER.glob("*.json")} == {Path(name).stem for name in NAMES | TABLES}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_recording(file: Path) -> None:
    run = recordings.load(file)
    assert file.stat().st_size < 100_000
    assert (run.runtime, run.status) == ("ros1", 0)
    assert 0 <= min(tick.real for tick in run.ticks) and max(tick.real for tick in run.ticks) < run.seconds + 1
    for source in {tick.source for tick in run.ticks}:
        numbers = [tick.number for tick in run.ticks if tick.source == source]
        assert numbers == list(range(1, len(numbers) + 1))
    keys = {
        "what",
        "command",
        "date",
        "ros",
        "python",
        "compiler",
        "system",
        "processor",
        "cores",
        "load_before",
    }
    assert keys <= run.provenance.keys()
    assert run.caption.startswith("recorded on 20")
    assert run.provenance["ros"] in run.caption
    assert run.short_caption.startswith(run.caption[: len("recorded on 2026-11-21")])
    assert len(run.short_caption) < 80  # a line below a figure


def test_the_caption_of_a_run_made_now() -> None:
    run = Run("PARAMETERS\n * /rosversion: 1.15.15\n", (), 0, "ros1", 5.0, start=86400.0)
    long, short = recordings.live_caption(run), recordings.live_caption(run, short=True)
    assert long.startswith("measured on 1970-01-02 with ROS 1.15.15 on ")
    assert short.startswith("measured on 1970-01-02, ")
    assert long.endswith(short.partition(", ")[2])


@pytest.mark.parametrize(("language", "periods"), AFTER)
def test_ticks_after_a_block(language: str, periods: float) -> None:
    run = recordings.load(FOLDER / f"timer_{language}_blocks_once_{periods}.csv")
    blocked, *after = run.ticks[2:6]
    assert blocked.duration == pytest.approx(periods * 0.5, abs=0.05)
    assert [tick.real for tick in after] == pytest.approx(AFTER[language, periods], abs=0.1)


def test_who_waits_for_a_slow_callback() -> None:
    def periods(name: str) -> list[float]:
        ticks = [tick for tick in recordings.load(FOLDER / name).ticks if tick.source == "secondCallback"]
        return [later.real - earlier.real for earlier, later in zip(ticks, ticks[1:])]

    assert max(periods("two_timers_cpp_spin.csv")) > 0.7
    assert max(periods("two_timers_cpp_async.csv")) < 0.6
    assert max(periods("two_timers_py.csv")) < 0.6


def test_what_is_no_recording(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(json.dumps({"start": 0.0, "status": 0, "seconds": 1.0}))
    (tmp_path / "a.csv").write_text("number\n1\n")
    with pytest.raises(ValueError, match="columns"):
        recordings.load(tmp_path / "a.csv")
    with pytest.raises(ValueError, match="recording is"):
        recordings.load(tmp_path / "a.svg")
    with pytest.raises(FileNotFoundError):
        recordings.load(tmp_path / "b.csv")


def test_a_first_and_a_last_tick(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_text(json.dumps({"start": 5.0, "status": 0, "seconds": 1.0}))
    rows = ["timer,1,,,0.5,0.6,", "other,1,,,0.5,0.7,", "timer,2,0.5,0.6,1.0,1.1,0.25"]
    (tmp_path / "a.csv").write_text("\n".join([",".join(recordings.COLUMNS), *rows]))
    run = recordings.load(tmp_path / "a.csv")
    assert run.start == 5.0
    assert run.ticks[0] == ("timer", 1, 0.5, 0.6, 0.25)
    assert [tick.source for tick in run.ticks] == ["timer", "other", "timer"]
    assert all(math.isnan(tick.duration) for tick in run.ticks[1:])


# --- on ROS 2 ---------------------------------------------------------------------------------------------------------

ROS2_TABLES = {"claims", "clock_jump", "endings", "pipe", "signals", "topics"}
ROS2_CONSOLE = "spinner"
ROS2_NAMES = {
    *(f"{what}_{hertz}hz" for what in ("timer", "rate") for hertz in (2, 50)),
    *(f"{what}_blocks_once_{periods}" for what in ("timer", "rate") for periods in (1.4, 2.4, 4.4)),
    *("timer_blocks_always_1.6", "timer_waits", "timer_without_clock", "timer_overlaps"),
    *(f"two_timers_{how}" for how in ("spin", "spin_once", "multi_default", "multi_own", "multi_reentrant")),
}

# The ticks from the third on, of a timer or a Rate at 2 Hz whose call or pass number 3 takes so many periods.
ROS2_AFTER = {
    ("timer", 1.4): [1.5, 2.2, 2.5, 3.0],
    ("timer", 2.4): [1.5, 2.7, 3.0, 3.5],
    ("timer", 4.4): [1.5, 3.7, 4.0, 4.5],
    ("rate", 1.4): [1.0, 1.7, 2.0, 2.5],
    ("rate", 2.4): [1.0, 2.2, 2.5, 3.0],
    ("rate", 4.4): [1.0, 3.2, 3.5, 4.0],
}


def table(name: str) -> list[dict[str, str]]:
    with (ROS2 / f"{name}.csv").open() as rows:
        return list(csv.DictReader(rows))


def times(name: str, source: str) -> list[float]:
    return [tick.real for tick in recordings.load(ROS2 / f"{name}.csv").ticks if tick.source == source]


def test_the_set_of_ros_2_is_complete() -> None:
    """rclpy's; rclcpp's is in ``test_rclcpp.py``."""

    def names(ending: str) -> set[str]:
        return {file.stem for file in ROS2.glob(f"*.{ending}") if "_cpp" not in file.stem}

    assert names("csv") == ROS2_NAMES | ROS2_TABLES
    assert names("txt") == {ROS2_CONSOLE, "publish"}
    assert names("json") == names("csv") | names("txt")


@pytest.mark.parametrize("name", [*(f"{name}.csv" for name in sorted(ROS2_NAMES)), f"{ROS2_CONSOLE}.txt"])
def test_recording_of_ros_2(name: str) -> None:
    run = recordings.load(ROS2 / name)
    assert (run.runtime, run.status) == ("ros2", 0)
    assert "with ROS 2 Jazzy, rclpy 7" in run.caption
    assert bool(run.ticks) == (name != "timer_without_clock.csv")
    assert all(0 <= tick.real < run.seconds + 1 for tick in run.ticks)
    for source in {tick.source for tick in run.ticks}:
        numbers = [tick.number for tick in run.ticks if tick.source == source]
        assert numbers == list(range(1, len(numbers) + 1))


@pytest.mark.parametrize(("what", "periods"), ROS2_AFTER)
def test_rclpy_keeps_the_grid_after_a_block(what: str, periods: float) -> None:
    run = recordings.load(ROS2 / f"{what}_blocks_once_{periods}.csv")
    assert run.ticks[2].duration == pytest.approx(periods * 0.5, abs=0.05)
    assert [tick.real for tick in run.ticks[2:6]] == pytest.approx(ROS2_AFTER[what, periods], abs=0.1)


def test_who_waits_for_a_slow_callback_in_rclpy() -> None:
    assert times("two_timers_spin", "second_callback")[:3] == pytest.approx([1.3, 2.9, 4.5], abs=0.15)
    for how in ("spin_once", "multi_default"):
        assert times(f"two_timers_{how}", "second_callback") == []
    for how in ("multi_own", "multi_reentrant"):
        assert times(f"two_timers_{how}", "second_callback")[:4] == pytest.approx([0.5, 1.0, 1.5, 2.0], abs=0.15)
    assert times("timer_overlaps", "timer_callback")[:4] == pytest.approx([0.5, 1.0, 1.7, 2.2], abs=0.15)
    assert times("timer_waits", "timer_callback")[:3] == pytest.approx([2.2, 2.5, 3.0], abs=0.15)


def test_how_nodes_of_rclpy_end() -> None:
    statuses: dict[tuple[str, str], set[int]] = {}
    for row in table("endings"):
        statuses.setdefault((row["node"], row["signal"]), set()).add(int(row["status"]))
    interrupted, hangs = {128 + signal.SIGINT}, {128 + signal.SIGKILL}
    assert statuses == {
        ("exception", ""): {1},
        ("hooks", "SIGINT"): {0},
        ("hooks", "SIGTERM"): {0},
        ("in_callback", "SIGINT"): interrupted,
        ("in_callback", "SIGTERM"): {0},
        ("rate_in_main", "SIGINT"): interrupted | {128 + signal.SIGABRT},
        ("rate_in_main", "SIGTERM"): hangs,
        ("rate_in_thread", "SIGINT"): {0},
        ("rate_in_thread", "SIGTERM"): {0},
        ("rate_nobody_spins", "SIGINT"): interrupted,
        ("rate_nobody_spins", "SIGTERM"): hangs,
        ("shutdown_in_callback", ""): {0},
        ("sleep_until", "SIGINT"): interrupted,
        ("sleep_until", "SIGTERM"): {0},
        ("spin", "SIGINT"): interrupted,
        ("spin", "SIGTERM"): {1},
        ("spin_caught", "SIGINT"): {0},
        ("spin_caught", "SIGTERM"): {0},
        ("system_exit", ""): {3},
    }


def test_how_often_a_node_of_rclpy_meets_its_shutdown() -> None:
    """Mostly where a callback ends."""
    met = {"RCLError: failed to shutdown", "RCLError: failed to initialize wait set"}
    failed: dict[str, int] = {}
    for row in table("signals"):
        assert (row["status"], row["error"]) == ("0", "") or (row["status"] == "1" and row["error"] in met)
        failed[row["moment"]] = failed.get(row["moment"], 0) + (int(row["runs"]) if row["error"] else 0)
    assert failed["at its end"] > failed["during a callback"] + failed["between callbacks"]


def test_what_nodes_of_rclpy_say_is_what_they_say_in_simulated_time() -> None:
    """How many calls a period of 0 gives depends on the machine, in what order two threads speak on a race."""
    by_run: dict[str, list[dict[str, str]]] = {}
    for row in table("claims"):
        by_run.setdefault(row["run"], []).append(row)
    assert len(by_run) == 12
    for name, rows in by_run.items():
        file, *args = rows[0]["command"].split()
        run = simulate(ROOT / "examples" / "ros2" / file, float(rows[0]["ended_after"]), args)
        simulated = [line.split(",", 2)[1:] for line in run.console.splitlines() if line.startswith("said,")]
        assert {int(row["status"]) for row in rows} == {run.status}, name
        if name == "period_zero":
            assert all(int(what.removeprefix("calls: ")) > 1000 for what in (rows[0]["what"], simulated[0][1]))
        else:
            assert sorted(row["what"] for row in rows) == sorted(what for _, what in simulated), name
        assert [float(row["seconds"]) for row in rows] == pytest.approx([float(at) for at, _ in simulated], abs=0.1)


def test_rclpy_when_the_clock_jumps() -> None:
    """To 100: one tick at once. Back to 50: the next one a period later."""
    assert [float(row["ros_time"]) for row in table("clock_jump")] == [100, 101, 102, 103, 51, 52, 53]
