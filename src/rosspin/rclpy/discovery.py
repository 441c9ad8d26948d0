"""How processes of ROS 2 find and miss each other, as measured on Jazzy with Fast DDS on one machine.

Other processes know a context some time after its first node was made, and the endpoint of a topic, or of a service,
soon after it was made. Each side learns of the other by itself. Within a process all is known immediately.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from ..clocks.clock import LATE
from .context import RclContext

if TYPE_CHECKING:
    from .handle import RclNode

__all__ = ["ENDPOINT", "KEPT", "Participants", "discovery_delay"]

# How long (ns) it takes until ..., as measured most often.
ENDPOINT = 1_000_000  # another process knows an endpoint of a topic
PARTICIPANT = 115_000_000  # another process knows a context
KEPT = 12_000_000  # the messages that a publisher has kept come
END = 35_000_000  # a process that has ended is missed
LEASE = 20_000_000_000  # a process that was killed is missed


class Participants:
    """The contexts of a run that have a node. All processes of the run share one such list."""

    def __init__(self) -> None:
        self._contexts: list[RclContext] = []
        self._late: set[frozenset[RclContext]] = set()  # pairs that learn of each other later than usual

    def join(self, context: RclContext) -> None:
        """Add a context, unless it is there, that has its first node."""
        if context.joined is not None:
            return
        clock = context.state.clock
        context.joined = clock.now()
        context.leave = partial(self._leave, context)
        for other in self._contexts:
            if clock.explores and other.state is not context.state:
                pair = f"{context.state.world.name} and {other.state.world.name}"
                if clock.choose([f"{pair} connect", f"{pair} connect late"]):
                    self._late.add(frozenset((context, other)))
        self._contexts.append(context)

    def met(self, one: RclContext, other: RclContext) -> int:
        """Return when (ns) two contexts know each other."""
        assert one.joined is not None and other.joined is not None
        return max(one.joined, other.joined) + PARTICIPANT + (LATE if frozenset((one, other)) in self._late else 0)

    def _leave(self, context: RclContext, killed: bool) -> None:
        """Let the others miss a context that was shut down, or whose process has ended."""
        if context.left is None:
            context.left = context.state.clock.now() + (LEASE if killed else END)
            for node in context.nodes:
                for endpoint in list(node.endpoints):
                    if killed:
                        endpoint.fall_silent()
                    endpoint.be_missed(context.left)
                    if not killed:
                        endpoint.withdraw()

    def all_nodes(self) -> list[RclNode]:
        """The nodes of all processes, known or not."""
        return [node for context in self._contexts for node in context.nodes]

    def nodes(self, context: RclContext) -> Iterator[RclNode]:
        """Yield the nodes of other processes that a context knows now."""
        now = context.state.clock.now()
        for other in self._contexts:
            if other.state is not context.state and (other.left is None or now < other.left):
                met = self.met(context, other)
                for node in other.nodes:
                    if max(met, other.born[node] + ENDPOINT) + discovery_delay(context.state.world.name, node) <= now:
                        yield node


def discovery_delay(name: str, node: RclNode) -> int:
    """Return how much (ns) later than usual a node should be known to the node of a name, in another process."""
    faults = node.context.state.world.graph.faults
    return faults.discovery_delay(name, node.full_name) if faults else 0
