"""A process is asked to end as politely as it lets one."""

from __future__ import annotations

from signal import SIGINT, SIGKILL, SIGTERM, Signals

import pytest

from rosspin.clocks.ctrl_c import ALONE, ROS2_LAUNCH, ROSLAUNCH, Ending


@pytest.mark.parametrize(
    "heeds, sent", [(SIGINT, [SIGINT]), (SIGTERM, [SIGINT, SIGTERM]), (SIGKILL, [SIGINT, SIGTERM, SIGKILL])]
)
def test_signals_follow_one_another_until_one_is_heeded(heeds: Signals, sent: list[Signals]) -> None:
    took: list[Signals] = []
    waited: list[float] = []

    def ends_within(seconds: float) -> bool:
        waited.append(seconds)
        return took[-1] == heeds

    assert Ending(((SIGINT, 3.0), (SIGTERM, 1.0))).carry_out(took.append, ends_within) == heeds
    assert took == sent
    assert waited == [3.0, 1.0][: len(sent)]


def test_a_node_alone_has_as_long_as_under_roslaunch() -> None:
    """Sources: roslaunch/nodeprocess.py, launch/actions/execute_local.py."""
    assert (ALONE.patience, ROSLAUNCH.patience, ROS2_LAUNCH.patience) == (17, 17, 10)
