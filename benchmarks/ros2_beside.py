"""The stand-in beside the real rclpy, measured in one run: how late a timer's callback is on the wall clock."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from rosspin.measures import quantile, say_time
from rosspin.real import ros2

from .ratios import line

# Calls back so often, and prints how late (s) each call was: of the period, what had passed when it came.
_NODE = """
import sys
import rclpy

hertz, ticks = float(sys.argv[1]), int(sys.argv[2])
period = round(1e9 / hertz)
late = []


def callback():
    late.append(period - timer.time_until_next_call())
    if len(late) == ticks:
        rclpy.shutdown()


rclpy.init(args=[])
node = rclpy.create_node("lateness")
timer = node.create_timer(1 / hertz, callback)
rclpy.spin(node)
print("late", *(ns / 1e9 for ns in late), flush=True)
"""

PATIENCE = 60.0  # s


def report(turns: Sequence[tuple[int, float]] = ((2, 5.0), (50, 2.0), (500, 1.0)), rounds: int = 2) -> Iterator[str]:
    """The lines of the report, for so many Hz and seconds; where ROS 2 is lacking, one line that says so."""
    yield "Beside the real ROS 2"
    if ros2.missing():
        yield f"  not measured: {ros2.Ros2Missing()}"
        return
    with ros2.Nodes() as nodes:
        file = Path(nodes.folder, "lateness.py")
        file.write_text(_NODE)
        commands = {
            "stand-in": [sys.executable, "-m", "rosspin", "run", str(file), "--"],
            "rclpy": [ros2.python(), str(file)],
        }
        for hertz, seconds in turns:
            late: dict[str, list[float]] = {name: [] for name in commands}
            for _ in range(rounds):
                for name, command in commands.items():
                    console = nodes.run([*command, str(hertz), str(round(hertz * seconds))], PATIENCE).console
                    (times,) = [words for words in map(str.split, console.splitlines()) if words[:1] == ["late"]]
                    late[name] += map(float, times[1:])
            for percent in (50, 99):
                at = {name: quantile(values, percent / 100) for name, values in late.items()}
                yield line(
                    f"  timer at {hertz} Hz, p{percent} of {len(late['rclpy'])} ticks, stand-in / rclpy",
                    at["stand-in"] / at["rclpy"],
                    most=1.0 if percent == 50 else None,
                    times=f"{say_time(at['stand-in'])} / {say_time(at['rclpy'])}",
                )
