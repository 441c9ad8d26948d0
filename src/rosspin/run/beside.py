"""Run a node together with others, each as in a terminal of its own."""

from __future__ import annotations

from collections.abc import Sequence

from ..clocks.simulation import Simulation
from ..world.graph import TickLog
from .host import Host, Result, duration
from .roslaunch.launch import Node
from .source import Code, NodeLike, load
from .together import Together

__all__ = ["run_beside"]


def run_beside(
    node: Code, args: Sequence[str], others: Sequence[NodeLike], seconds: float, clock: Simulation, ticks: TickLog
) -> Result:
    """Run a loaded node for ``seconds`` on a simulated clock, together with others. The status is its own.

    Unlike :func:`rosspin.simulate`, it does so for nodes of ROS 1, too, without a roslaunch that speaks.
    """
    until = duration(seconds)
    codes = [node, *map(load, others)]
    host = Host(clock, ticks, several=True)
    host.supervisor = Together(
        host, [Node(code.main, () if number else args) for number, code in enumerate(codes)], codes
    )
    with host.inside():
        host.run(until)
    result = host.result()
    status = result.world.exit_status or 0
    result.status = status if status >= 0 else 128 - status
    return result
