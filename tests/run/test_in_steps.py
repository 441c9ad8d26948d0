"""What a node does in steps is what it does in one go, for all scenarios."""

from __future__ import annotations

import io
import os
import random
import re
import signal
from pathlib import Path
from unittest import mock

import pytest

from rosspin import NodeFailed, Run, simulate, start
from tests.helpers import corpus_ros2
from tests.helpers.corpus_ros1 import LONGEST, SCENARIO_LIST, SCENARIOS, Scenario
from tests.helpers.seeds import SEED

pytestmark = pytest.mark.shares(3)

ROS_2 = corpus_ros2.SCENARIOS

# In these a node looks at its connections, or no other node is connected: here the test is.
CONNECTED = {
    *(
        "topics_before_init",
        "topics_connections",
        "topics_first_lost",
        "topics_header",
        "topics_listener",
        "topics_names",
    ),
    *("topics_mismatch", "topics_publish_breaks", "topics_publish_unconnected", "topics_unregister_publisher"),
    *("qos_best_available", "qos_events_order", "qos_events_raise", "qos_incompatible", "qos_incompatible_callbacks"),
    "qos_matched",
}


def contents(run: Run) -> list[object]:
    """A run without what differs between equal ones: addresses, classes made again, and NaN."""
    messages = []
    for topic, node, when, message in run.messages:
        if not hasattr(message, "serialize"):  # of ROS 2
            messages.append((topic, node, when, type(message).__name__, repr(message).encode()))
            continue
        data = io.BytesIO()
        try:
            message.serialize(data)
        except Exception as error:
            data.write(str(error).encode())
        messages.append((topic, node, when, type(message).__name__, data.getvalue()))
    console = re.sub(" at 0x[0-9a-f]+>", ">", run.console)
    return [console, str(run.ticks), run.status, run.runtime, run.start, messages]


def in_steps(path: Path, seconds: float, args: tuple[str, ...], name: str) -> None:
    """Hold a node that is run in random steps against the same in one go."""
    choose = random.Random(f"{name} {SEED}")
    raised = 0
    whole = simulate(path, seconds, args)
    try:
        node = start(path, args)
    except Exception as error:
        assert type(error).__name__ in whole.console or (whole.status and isinstance(error, NodeFailed))
        return
    while (left := round((seconds - node.time) * 1e9)) > 0:
        step = min(choose.choice([0, 20_000_000, 400_000_000, choose.randrange(10**9)]), left)
        if node._host.processes[0].world.exit_status is not None:
            step = left  # it has ended: nothing more can come
        try:
            node.advance(step / 1e9)
        except Exception:
            raised += 1
    try:
        node.close()
    except Exception:
        raised += 1
    assert contents(node.run) == contents(whole)
    assert node.run.seconds == pytest.approx(seconds)
    if not (ROS_2 in path.parents and whole.status == 128 + signal.SIGINT):
        assert bool(raised) == bool(whole.status or node._host.processes[0].world.errors)


@pytest.mark.parametrize(
    "scenario", [each for each in SCENARIO_LIST if each.file not in CONNECTED], ids=lambda each: each.name
)
def test_a_node_does_in_steps_what_it_does_in_one_go(scenario: Scenario) -> None:
    in_steps(SCENARIOS / f"{scenario.file}.py", scenario.end or LONGEST, scenario.args, scenario.name)


# Garbage is collected at other moments, since whoever steps a node makes objects, too.
COLLECTED = {"life_collected"}


@pytest.mark.parametrize(
    "scenario",
    [each for each in corpus_ros2.SCENARIO_LIST if each.file not in CONNECTED | COLLECTED],
    ids=lambda each: each.name,
)
def test_a_node_of_ros_2_does_in_steps_what_it_does_in_one_go(scenario: corpus_ros2.Scenario) -> None:
    with mock.patch.dict(os.environ):  # a node may set the form of its log lines there
        in_steps(scenario.path, scenario.end or corpus_ros2.LONGEST, scenario.args, scenario.name)


@pytest.mark.parametrize("times", [[0.5, 0.5, 0.5, 0.5], [0.25, 1.75], [0.0, 2.0], [1 / 3] * 6])
def test_what_is_due_at_the_end_of_a_step_has_run(times: list[float]) -> None:
    with start(SCENARIOS.parents[1] / "examples/my_robotics_pkg/src/spinner_py_node.py") as node:
        passed = 0
        for seconds in times:
            run = node.advance(seconds)
            before, passed = passed, passed + round(seconds * 1e9)
            expected = [0.5 * number for number in range(1, 5) if before < 5e8 * number <= passed]
            assert [tick.real for tick in run.ticks] == expected
