"""The exercises on a real ROS: what the solutions say is so there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosspin.real.ros1 import Workspace
from rosspin.results.console import read_ticks
from tests.helpers.answers import CELLS, LATE, answer_in, late_listener, solution_of
from tests.helpers.cpp_nodes import CppNodes
from tests.helpers.launches import NEVER, Until, launch
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(10)


def test_the_cpp_node_does_what_the_solution_says(cpp_nodes: CppNodes) -> None:
    with Workspace() as workspace:
        workspace.start_master()

        def ticks(node: str, blocks_for: str, *until: Any) -> list[float]:
            """When callbacks 3 to 6 come, as a recording of one; the third is due at 1.2 s."""
            output = workspace.run([cpp_nodes.program(node), f"_blocks_for:={blocks_for}"], *until)
            found = [tick.real for tick in read_ticks(output.console)][2:6]
            return [1.2 + time - found[0] for time in found]

        for blocks_for in ("0.6", "1.0"):
            after = solution_of("cpp-ticks")[f"after_{blocks_for.replace('.', '_')}_seconds"]
            wanted = pytest.approx([1.2, *after], abs=0.15)
            with control(bears=0.07):
                assert ticks("kept", blocks_for, NEVER, Until("counter = 6")) == wanted
        assert ticks("not_kept", "0.6", 4.5) == solution_of("cpp-ticks")["not_kept"]


@pytest.mark.parametrize("name", ["wake-a-rate", "end-without-a-traceback"])
def test_the_solution_ends_well_on_the_real_ros_2(name: str, require: Callable[[str], None], tmp_path: Path) -> None:
    """What the unchanged cells do, scenarios of their own hold: ``ctrl_c_spin``, ``ctrl_c_rate_nobody_spins``."""
    require("ros2")
    node = tmp_path / "node.py"
    node.write_text(answer_in(CELLS[name][1]))
    with control(bears=0.1):
        run = launch(node, 1.73)  # between passes of the one, within a callback of the other
        assert run.status == 0
        assert "Traceback" not in run.console
        assert run.console.endswith("speed = 0.0\n") or "counter = 2" in run.console


@pytest.mark.parametrize("variable", LATE)
def test_a_late_subscriber_hears_what_the_solution_says(
    variable: str, require: Callable[[str], None], tmp_path: Path
) -> None:
    require("ros2")
    node = tmp_path / "node.py"
    node.write_text(late_listener(variable))
    with control(bears=0.2):  # it subscribes 0.25 s after one message and before the next
        heard = [tick.number for tick in read_ticks(launch(node, 3.3).console)]
        assert heard[:3] == solution_of("late-listener")[variable]
