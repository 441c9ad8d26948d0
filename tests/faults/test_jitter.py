"""Jitter: what falls due at one instant does not happen at that instant, and in the same way in each run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import rosspin
from rosspin.__main__ import main
from rosspin.faults import Fault, Jitter

TWO_TIMERS_1 = """
    import rospy
    rospy.init_node("two")
    for _ in range(2):
        rospy.Timer(rospy.Duration(0.1), lambda event: print(rospy.Time.now().to_nsec()))
    rospy.spin()
"""
TWO_TIMERS_2 = """
    import rclpy
    from rclpy.executors import ExternalShutdownException
    rclpy.init()
    node = rclpy.create_node("two")
    for _ in range(2):
        node.create_timer(0.1, lambda: print(node.get_clock().now().nanoseconds))
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
"""
TWO_LOOPS = """
    import threading, time
    def loop():
        for count in range(1, 4):
            time.sleep(0.1 * count - (time.time() - began))
            print(time.time_ns())
    began = time.time()
    threading.Thread(target=loop).start()
    loop()
"""
JITTERY = pytest.mark.parametrize("text", [TWO_TIMERS_1, TWO_TIMERS_2, TWO_LOOPS])


@JITTERY
def test_jitter_parts_what_is_due_at_one_instant(write: Callable[..., Path], text: str) -> None:
    node = write(text)
    usual = [int(word) for word in rosspin.simulate(node, 0.35).console.split()]
    late = [int(word) for word in rosspin.simulate(node, 0.35, jitter=0.001).console.split()]
    assert usual == [due for due in (100_000_000, 200_000_000, 300_000_000) for _ in range(2)]
    assert late == sorted(set(late))
    # Two wake-ups may come late one after the other, and then the callback.
    assert all(0 < real - due < 5_000_000 for real, due in zip(late, usual, strict=True))


@JITTERY
def test_jitter_is_the_same_in_each_run(write: Callable[..., Path], text: str) -> None:
    node = write(text)

    def times(*faults: Fault, jitter: float = 0.0) -> str:
        return rosspin.simulate(node, 0.35, faults=faults, jitter=jitter).console

    assert times(jitter=0.001) == times(jitter=0.001) == times(Jitter(0.001))
    assert times(Jitter(0.001, seed=1)) != times(Jitter(0.001))
    with rosspin.start(node, jitter=0.001) as started:
        assert started.advance(0.35).console == times(jitter=0.001)


@pytest.mark.parametrize("jitter", [-0.001, float("nan"), float("inf"), "1"])
def test_no_jitter(jitter: Any) -> None:
    with pytest.raises(ValueError, match="by must be a number above 0, in s"):
        rosspin.simulate(print, 1.0, jitter=jitter)


@JITTERY
def test_jitter_on_the_command_line(write: Callable[..., Path], capsys: pytest.CaptureFixture[str], text: str) -> None:
    node = write(text)
    options = ["run", str(node), "--seconds", "0.35", "--jitter", "0.001"]
    assert main([*options, "--simulated"]) == 0
    assert capsys.readouterr().out == rosspin.simulate(node, 0.35, jitter=0.001).console
    assert main(options) == 1
    assert "--jitter is for simulated time: --simulated" in capsys.readouterr().err
