"""Where a node lies does not change what it does."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from unittest import mock

import pytest

from rosspin import simulate
from rosspin.run.explain import say_error
from tests.helpers import corpus_ros1, corpus_ros2
from tests.helpers.corpus import Scenario
from tests.helpers.places import PLACES, SITE, lay, looking_for_packages_in

pytestmark = pytest.mark.shares(3)

SCENARIOS = [*corpus_ros1.SCENARIO_LIST, *corpus_ros2.SCENARIO_LIST]


@pytest.fixture(scope="module")
def parent(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("places").resolve()


def seen(path: Path, seconds: float, args: tuple[str, ...] = ()) -> list[str]:
    """What a run gives, or why there is none; without the place, and where things lie in the memory."""
    try:
        with mock.patch.dict(os.environ):  # a node may set the form of its log lines there
            run = simulate(path, seconds, args)
        gave: list[object] = [run.console, run.status, list(run.ticks), *[message[:3] for message in run.messages]]
    except Exception as error:
        gave = [say_error(error)]
    texts = [re.sub(r"0x[0-9a-f]+", "0x", str(each)) for each in gave]
    places = str(path.parent), str(path.resolve().parent)
    return [text.replace(places[0], "HERE").replace(places[1], "HERE") for text in texts]


@pytest.mark.parametrize(
    ("scenario", "place"),
    [(each, list(PLACES)[number % len(PLACES)]) for number, each in enumerate(SCENARIOS)],
    ids=lambda each: each if isinstance(each, str) else f"ros{each.ros}-{each.name}",
)
def test_a_scenario_does_the_same_in_each_place(scenario: Scenario, place: str, parent: Path) -> None:
    """Each scenario in one of the places, its neighbours in the others."""
    folder = lay(scenario.path.parent, place, parent / f"ros{scenario.ros}")
    with looking_for_packages_in(parent / f"ros{scenario.ros}" / place / "user" / SITE):
        there = seen(folder / scenario.path.name, scenario.seconds, scenario.node_args)
    assert there == seen(scenario.path, scenario.seconds, scenario.node_args)


HELPER = """
import atexit, signal, threading
calls = []
atexit.register(lambda: print("the helper ends", len(calls)))

def fail():
    raise OSError("broken")

def wait(lock):
    with lock:
        pass

def mask():
    calls.append(signal.pthread_sigmask(signal.SIG_BLOCK, []))

def start(function):
    threading.Thread(target=function).start()
"""

ROS1 = """
import threading, rospy
import helper
rospy.init_node("n")
"""

ROS2 = """
import threading, rclpy
import helper
rclpy.init()
node = rclpy.create_node("n")
"""

# What ends, what is asked of the machine, what is not simulated, and whatever a message says of a place.
NODES = {
    "at_exit": "import atexit\nhelper.calls.append(1)\natexit.register(print, 'ends', helper.calls)\n",
    "mask": "helper.mask()\n",
    "raises": "helper.fail()\n",
    "raises_in_thread": "helper.start(helper.fail)\n",
    "no_callable": "threading.Thread(target=5).start()\n",
    "locked": "lock = threading.Lock()\nlock.acquire()\nhelper.wait(lock)\n",
    "locked_by_event": "threading.Event().wait()\n",
    "does_not_end": "while True:\n    try:\n        threading.Event().wait(1)\n    except BaseException: pass\n",
    "not_simulated": "import multiprocessing\nmultiprocessing.Pool(2)\n",
    "not_simulated_ros": "print(getattr(__import__('rospy', fromlist='x'), 'impl', '?'))\nimport rosbag\n",
    "a_ring": (
        "a, b = threading.Lock(), threading.Lock()\n"
        "def one():\n    with a:\n        import time; time.sleep(0.1)\n        helper.wait(b)\n"
        "helper.start(one)\nwith b:\n    import time; time.sleep(0.1)\n    helper.wait(a)\n"
    ),
    "warns": "import warnings\nwarnings.warn('mind')\n",
}


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("sources").resolve() / "src" / "robots"
    folder.mkdir(parents=True)
    (folder / "__init__.py").touch()
    (folder / "helper.py").write_text(HELPER)
    for name, text in NODES.items():
        (folder / f"{name}_1.py").write_text(ROS1 + text)
        (folder / f"{name}_2.py").write_text(ROS2 + text)
    return folder


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("ros", [1, 2])
@pytest.mark.parametrize("name", NODES)
def test_what_depends_on_whose_code_it_is_does_not_on_its_place(
    name: str, ros: int, place: str, sources: Path, parent: Path
) -> None:
    """Twice, for a module of the node's own begins with nothing each time."""
    folder = lay(sources, place, parent / "kinds")
    expected = seen(sources / f"{name}_{ros}.py", 1)
    with looking_for_packages_in(parent / "kinds" / place / "user" / SITE):
        assert seen(folder / f"{name}_{ros}.py", 1) == expected
        assert seen(folder / f"{name}_{ros}.py", 1) == expected


def test_a_node_in_the_user_s_own_packages_ends_as_elsewhere(sources: Path, tmp_path: Path) -> None:
    """In a Python that looks there by itself."""
    folder = tmp_path / ".local" / SITE / "robots"
    shutil.copytree(sources, folder)
    run = f"import rosspin; run = rosspin.simulate({str(folder / 'at_exit_2.py')!r}, 1); print([run.console])"
    found = subprocess.run(
        [sys.executable, "-c", run], capture_output=True, text=True, env={**os.environ, "HOME": str(tmp_path)}
    )
    assert [found.stdout, found.stderr] == ["['ends [1]\\nthe helper ends 1\\n']\n", ""]
