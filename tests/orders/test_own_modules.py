"""``deep`` reaches the modules that are the node's own: in its folder, and in its package."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

import rosspin

COUNTER = """
\"\"\"A count.\"\"\"
from __future__ import annotations
def one():
    return 1
class Counter:
    number = 0
    def add(self):
        self.number += one()
"""
NODE = """
import {ros}
import threading
from {where} import Counter
def main():
    counter = Counter()
    threads = [threading.Thread(target=counter.add) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(counter.number)
if __name__ == "__main__":
    main()
"""


def write(folder: Path, ros: str, module: str, where: str) -> Path:
    """Write a node, and its counter into a module, of which all folders are packages. Returns the node's path."""
    file = folder / module
    for each in [*file.parents][: len(Path(module).parents) - 1]:
        each.mkdir(parents=True, exist_ok=True)
        (each / "__init__.py").touch()
    file.write_text(dedent(COUNTER))
    node = folder / "robot/node.py" if where.startswith("robot.") else folder / "node.py"
    node.write_text(NODE.format(ros=ros, where=where))
    return node


def counts_both(run: rosspin.Run) -> None:
    assert run.console == "2\n"


@pytest.mark.parametrize("ros", ["rospy", "rclpy"])
@pytest.mark.parametrize(
    ("module", "where"),
    [
        ("counter.py", "counter"),
        ("tools/count/counter.py", "tools.count.counter"),
        ("robot/counter.py", "robot.counter"),
        ("robot/parts/counter.py", "robot.parts.counter"),
    ],
)
def test_a_race_in_a_module_of_the_nodes_own_is_found(tmp_path: Path, ros: str, module: str, where: str) -> None:
    node = write(tmp_path, ros, module, where)
    assert not rosspin.explore(node, 1.0, counts_both, schedules=20).failure
    found = rosspin.explore(node, 1.0, counts_both, deep=True, schedules=100)
    assert found.failure
    assert found.orders is not None
    (instant,) = found.orders.instants
    assert ("counter.py:9", "self.number += one()") in {(step.line, step.text) for step in instant.here}
    assert rosspin.simulate(node, 1.0, schedule=found.token).console == "1\n"
    assert rosspin.simulate(node, 1.0).console == "2\n"


def test_what_is_installed_is_left_alone(tmp_path: Path) -> None:
    """A folder that is on the path, but neither the node's nor its package's: nothing changes threads in it."""
    elsewhere = tmp_path / "site"
    elsewhere.mkdir()
    (elsewhere / "counter.py").write_text(dedent(COUNTER))
    node = tmp_path / "node.py"
    text = NODE.format(ros="rclpy", where="counter")
    node.write_text(f"import sys\nsys.path.append({str(elsewhere)!r})\n{text}")
    assert not rosspin.explore(node, 1.0, counts_both, deep=True, schedules=30).failure


def test_a_module_that_is_broken_says_where(tmp_path: Path) -> None:
    node = write(tmp_path, "rclpy", "counter.py", "counter")
    (tmp_path / "counter.py").write_text("x = = 1\n")
    found = rosspin.explore(node, 1.0, deep=True)
    assert found.failure == "uncaught: SyntaxError: invalid syntax (counter.py, line 1)"
