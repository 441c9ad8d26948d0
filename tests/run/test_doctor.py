"""What `rosspin doctor` says of the recordings beside the project's tests; nothing where these are not."""

from __future__ import annotations

import datetime
from pathlib import Path

import pytest

from rosspin import doctor


@pytest.fixture(autouse=True)
def no_ros(monkeypatch: pytest.MonkeyPatch) -> None:
    """What else can run here is none of these tests' business."""
    for name in ("rosspin.real.ros1.missing", "rosspin.real.ros2.missing"):
        monkeypatch.setattr(name, lambda cpp=True: [])


TODAY = datetime.date(2026, 3, 1)


def recorded() -> list[str]:
    return [line for line in doctor.report(TODAY) if line.startswith("recorded ")]


def test_it_says_how_old_the_recordings_are(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    batches = (1, TODAY, "new", 3), (1, datetime.date(2026, 2, 20), "old", 2), (2, TODAY, "Jazzy", 1)
    text = "".join(
        f'[[confirmed]]\nros = {ros}\ndate = {date}\nversion = "{version}"\n[confirmed.hashes]\n'
        + "".join(f'scenario_{number} = ""\n' for number in range(count))
        for ros, date, version, count in batches
    )
    (tmp_path / "ledger.toml").write_text(text)
    monkeypatch.setattr(doctor, "_LEDGER", tmp_path / "ledger.toml")
    assert recorded() == [
        "recorded  ROS 1: 5 scenarios, confirmed 9 days ago or later by old (make judge)",
        "recorded  ROS 2: 1 scenarios, confirmed today by Jazzy (make judge)",
    ]


def test_it_says_nothing_of_them_where_the_tests_are_not(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert len(recorded()) == 2
    monkeypatch.setattr(doctor, "_LEDGER", tmp_path / "ledger.toml")
    assert recorded() == []
