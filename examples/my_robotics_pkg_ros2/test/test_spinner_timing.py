"""The timing of the spinner nodes, in simulated time: no ROS, no waiting."""

from pathlib import Path

import pytest
from rosspin import simulate

NODES = Path(__file__).parents[1] / "my_robotics_pkg"


def test_it_counts_twice_a_second():
    run = simulate(NODES / "spinner_py_node.py", 2.0)
    assert [tick.real for tick in run.ticks] == pytest.approx([0.5, 1.0, 1.5, 2.0])
    assert "[SPINNER PY NODE] counter = 4" in run.console


def test_it_does_not_drift():
    run = simulate(NODES / "spinner_py_node.py", 3600.0)
    assert len(run.ticks) == 7200
    assert max(tick.lateness for tick in run.ticks) == pytest.approx(0.0)


def test_it_ends_at_ctrl_c():
    run = simulate(NODES / "spinner_py_node.py", 1.0)
    assert run.status == 0
    assert "Traceback" not in run.console


@pytest.mark.parametrize("frequency", [1.0, 10.0, 50.0])
def test_it_takes_its_frequency_from_the_parameter(frequency):
    node = NODES / "spinner_param_py_node.py"
    run = simulate(node, 1.0, args=["--ros-args", "-p", f"frequency:={frequency}"])
    assert len(run.ticks) == frequency


def test_it_refuses_a_frequency_of_zero():
    node = NODES / "spinner_param_py_node.py"
    run = simulate(node, 1.0, args=["--ros-args", "-p", "frequency:=0.0"])
    assert run.status == 1
    assert "frequency must be above 0" in run.console
