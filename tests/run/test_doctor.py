"""What `rosspin doctor` says of the recordings in the project's tests; nothing where these are not."""

from __future__ import annotations

import datetime
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosspin import doctor
from rosspin.real import ros2
from tests.helpers.tree import ROOT


@pytest.fixture
def no_ros(monkeypatch: pytest.MonkeyPatch) -> None:
    """What else can run here is none of these tests' business."""
    for name in ("rosspin.real.ros1.missing", "rosspin.real.ros2.missing"):
        monkeypatch.setattr(name, lambda cpp=True: [])


TODAY = datetime.date(2026, 3, 1)


def recorded() -> list[str]:
    return [line for line in doctor.report() if line.startswith("recorded ")]


@pytest.mark.usefixtures("no_ros")
def test_it_says_how_old_the_recordings_are(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    batches = (1, TODAY, "new", 3), (1, datetime.date(2026, 2, 20), "old", 2), (2, TODAY, "Jazzy", 1)
    text = "".join(
        f'[[confirmed]]\nros = {ros}\ndate = {date}\nversion = "{version}"\n'
        f"scenarios = {[f'scenario_{number}' for number in range(count)]}\n"
        for ros, date, version, count in batches
    )
    (tmp_path / "ledger.toml").write_text(text)
    monkeypatch.setattr(doctor, "_LEDGER", tmp_path / "ledger.toml")
    assert recorded() == [
        "recorded  ROS 1: 5 scenarios, confirmed on 2026-02-20 or later by old (make judge)",
        "recorded  ROS 2: 1 scenarios, confirmed on 2026-03-01 or later by Jazzy (make judge)",
    ]


@pytest.mark.usefixtures("no_ros")
def test_it_says_nothing_of_them_where_the_tests_are_not(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert len(recorded()) == 2
    monkeypatch.setattr(doctor, "_LEDGER", tmp_path / "ledger.toml")
    assert recorded() == []


@pytest.fixture
def lacking(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A set-up was sourced, but the Python that it leads to has no rclpy."""
    ros2.python.cache_clear()
    ros2.version.cache_clear()
    monkeypatch.setattr(ros2, "_MADE", Path("/nowhere"))
    monkeypatch.setenv("AMENT_PREFIX_PATH", "/nowhere")
    monkeypatch.setattr(ros2, "python", lambda: sys.executable)
    yield
    ros2.version.cache_clear()


@pytest.mark.usefixtures("lacking")
@pytest.mark.parametrize(
    ("checkout", "says"),
    [
        (ROOT, "rclpy     no   lacks rclpy; make ros2"),
        (Path("/nowhere"), "rclpy     no   lacks rclpy; install ROS 2, and source its setup.bash"),
    ],
)
def test_a_set_up_without_rclpy_is_none(monkeypatch: pytest.MonkeyPatch, checkout: Path, says: str) -> None:
    monkeypatch.setattr(ros2, "_CHECKOUT", checkout)
    monkeypatch.setattr(ros2, "unavailable", lambda: "")
    assert says in list(doctor.report())
