"""What a log shows as a node and a test: which lines come at which period, and how far off."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from os.path import commonprefix
from typing import TYPE_CHECKING

from ..measures import quantile, say_time
from .reading import shape
from .series import Series

if TYPE_CHECKING:
    from . import Look

__all__ = ["NODE", "TEST", "as_files"]

NS = 10**9

# What the two files are called. The test finds the node next to it.
NODE, TEST = "node_of_the_log.py", "test_the_log.py"

_MOST = 3  # lines; a node of more is no one's example
_SLOWEST = 100  # times the shortest period: what comes more seldom would make the test long
_PASSES = 20  # of the slowest line, which the test runs for

_HEADS = {
    1: """\
import rospy


class LogPyNode:
    def __init__(self):
""",
    2: """\
import rclpy
from rclpy.node import Node


class LogPyNode(Node):
    def __init__(self):
        super().__init__({name})
""",
}
_TIMERS = {
    1: "        self.timer_{n} = rospy.Timer(rospy.Duration({period!r}), self.callback_{n})\n",
    2: "        self.timer_{n} = self.create_timer({period!r}, self.callback_{n})\n",
}
_CALLBACKS = {
    1: """
    def callback_{n}(self, event):
        self.count_{n} += 1
        rospy.loginfo({text})
""",
    2: """
    def callback_{n}(self):
        self.count_{n} += 1
        self.get_logger().info({text})
""",
}
_TAILS = {
    1: """

if __name__ == "__main__":
    rospy.init_node({name})
    node = LogPyNode()
    rospy.spin()
""",
    2: """

def main():
    rclpy.init()
    node = LogPyNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
""",
}

_TEST = """\
# What a log should show, as a test. Run it with pytest, where rosspin is installed. It runs the node in simulated time.
from pathlib import Path

import pytest
from rosspin import simulate
from rosspin.look import look

NODE = Path(__file__).with_name({node})  # put the path of your own node here

# The lines, with # for each number: the period (s), and how far from its grid a line may be (s).
LINES = {{
{lines}}}


@pytest.mark.parametrize("line", LINES)
def test_the_line_keeps_its_period(line):
    period, tolerance = LINES[line]
    run = simulate(NODE, {seconds!r})
    found = {{series.line: series for series in look(run.console.encode()).series}}
    assert line in found, f"the node does not log it; it logs {{list(found)}}"
    series = found[line]
    assert series.period / 1e9 == pytest.approx(period, rel=0.005)
    assert max(abs(late) for late in series.late) / 1e9 <= tolerance
    assert not series.missing
"""


def as_files(look: Look) -> dict[str, str]:
    """Write a node that logs the regular lines of a log as they should come, and a pytest test that it passes.

    Returns the texts by the names of the files; none if nothing in the log is regular. The lines are from one
    node, namely of the first verdict; of a table or a bag, the line is of our making. The period is the one that the
    log has, or where a sleep came after the work, the one that was meant. So late as 98% of the log's lines they may
    be, but no later than a tenth of the period; at least 1 ms.
    """
    rows = _chosen(look)
    if not rows:
        return {}
    logged = [_Line(n, series, look) for n, series in enumerate(rows, 1)]
    name = re.sub(r"\W", "_", rows[0].node.rpartition(".")[2].strip("/"), flags=re.ASCII).strip("_").lower()
    name = name if name[:1].isalpha() else f"log_{name or 'node'}"
    ros = look.ros
    node = [_HEADS[ros].format(name=_quoted(name))]
    node += [f"        self.count_{line.n} = 0\n" for line in logged]
    node += [_TIMERS[ros].format(n=line.n, period=line.period) for line in logged]
    node += [_CALLBACKS[ros].format(n=line.n, text=line.text) for line in logged]
    node.append(_TAILS[ros].format(name=_quoted(name)))
    lines = "".join(
        f"    {_quoted(line.shape)}: ({line.period!r}, {line.tolerance!r}),{line.said}\n" for line in logged
    )
    seconds = round(_PASSES * max(line.period for line in logged), 6)
    return {NODE: "".join(node), TEST: _TEST.format(node=_quoted(NODE), lines=lines, seconds=seconds)}


def _chosen(look: Look) -> Sequence[Series]:
    """Return the regular lines of one node that the files are about: each once."""
    regular = [series for series in look.series if series.is_regular]
    if not regular:
        return []
    named = [name for verdict in look.verdicts for name in verdict.series]
    first = min(regular, key=lambda series: named.index(series.name) if series.name in named else len(named))
    rows = {series.line: series for series in reversed(regular) if series.node == first.node}
    shortest = min(series.period for series in rows.values())
    kept = [series for series in rows.values() if series.period <= _SLOWEST * shortest]
    kept.sort(key=lambda series: (series is not first, series.period))
    return kept[:_MOST]


class _Line:
    """What the files say of a series: the text as an f-string, its shape, and times (s)."""

    def __init__(self, n: int, series: Series, look: Look) -> None:
        slept = any(verdict.name == "sleep" and series.name in verdict.series for verdict in look.verdicts)
        meant = series.is_chosen or slept and 0 < series.drift < 0.6
        late = quantile([abs(late) for late in series.late], 0.98)
        self.n = n
        self.period = _round((series.chosen if meant else series.period) / NS)
        self.tolerance = _round(max(1e-3, min(late / NS, self.period / 10)))
        is_short = look.kind == "console" and len(series.texts[0]) <= 200
        example = series.texts[0] if is_short else f"message {n}: 1"
        self.shape = shape(example)[0]
        self.text = _counted(example, n)
        self.said = f"  # the log had {say_time(series.period / NS)}" if slept and meant else ""


def _round(seconds: float) -> float:
    return float(f"{seconds:.3g}") if seconds >= 1e-4 else math.ceil(seconds * 1e6) / 1e6


def _counted(text: str, n: int) -> str:
    """Return a text as an f-string in which a count replaces the first number."""
    line, numbers = shape(text)
    if not numbers:
        return _quoted(text)
    before = commonprefix([text, line])  # they differ where the first number is
    after = text[len(before) + len(numbers[0]) :]
    before, after = (part.replace("{", "{{").replace("}", "}}") for part in (before, after))
    return "f" + _quoted(f"{before}{{self.count_{n}}}{after}")


def _quoted(text: str) -> str:
    """Return a text as Python writes it, between double quotes if it has none; what cannot be seen is escaped."""
    return repr(text) if '"' in text else repr(text + "'")[:-2] + '"'
