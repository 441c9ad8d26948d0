"""Imports point one way, and each room knows only what it may know."""

from __future__ import annotations

import ast
import subprocess
import sys
from graphlib import TopologicalSorter

import pytest
from tree import SOURCE

PACKAGE = SOURCE / "rosspin"

# From the bottom up: a module may import what stands before it.
LAYERS = [
    "clocks",
    "results",
    "world",
    "faults",
    "messages",
    "tf2",
    "rospy",
    "rclpy",
    "run",
    "orders",
    "measures",
    "look",
    "plots",
    "real",
    "doctor",
    "exercises",
    "grading",
    "page",
    "site",
    "pytest_plugin",
    "__init__",
    "__main__",
]

# Packages that only these modules may import.
KEEPERS = {
    "greenlet": {"clocks.stacks"},
    "IPython": {"site.magics"},
    "rosbags": {"look.bags"},
    "matplotlib": {"plots", "plots.pictures", "plots.rows", "plots.two_orders", "plots.vehicle"},
    "js": {"clocks.jspi", "page"},
    "pyodide": {"clocks.jspi", "page"},
    "sphinx": {
        f"site.{name}" for name in ("checks", "doctests", "lessons", "live", "pages", "published", "slides", "times")
    },
    "docutils": {
        f"site.{name}" for name in ("checks", "doctests", "lessons", "live", "pages", "published", "slides", "times")
    },
    "pytest": {"pytest_plugin"},
    "yaml": {
        *("run.roslaunch.launch", "run.ros2launch.frontend", "run.ros2launch.parameters"),
        *("run.ros2launch.substitutions", "rospy.client", "rclpy.arguments", "rclpy.parameter", "messages.ros1"),
    },
}

FILES = {
    ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix(".__init__"): path
    for path in PACKAGE.rglob("*.py")
}
MODULES = {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in FILES.items()}


def imports(module: str, also_inside: bool = True) -> set[str]:
    """What a module imports: the package's own modules by their names in MODULES, others by their first word.

    ``also_inside``: also inside of functions.
    """
    tree = MODULES[module]
    folder = list(FILES[module].relative_to(PACKAGE).parent.parts)
    found = set()
    for node in ast.walk(tree) if also_inside else tree.body:
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            found.add((node.module or "").partition(".")[0])
        elif isinstance(node, ast.ImportFrom):
            base = folder[: len(folder) - node.level + 1] + (node.module.split(".") if node.module else [])
            for alias in node.names:
                names = (".".join([*base, alias.name]), ".".join(base), "__init__")
                found.add(next(name for name in names if name in MODULES))
    return found


def layer(module: str) -> str:
    return module.partition(".")[0]


def test_the_list_of_layers_is_whole() -> None:
    assert {layer(module) for module in MODULES} == set(LAYERS)


@pytest.mark.parametrize("module", MODULES)
def test_imports_point_down(module: str) -> None:
    height = LAYERS.index(layer(module))
    above = {name for name in imports(module) & MODULES.keys() if LAYERS.index(layer(name)) > height}
    if module == "__init__":
        above -= {"site.magics"}  # only when IPython loads them
    assert not above


def test_no_module_imports_itself_in_a_circle() -> None:
    graph = {module: (imports(module, also_inside=False) & MODULES.keys()) - {module} for module in MODULES}
    list(TopologicalSorter(graph).static_order())


@pytest.mark.parametrize("package", KEEPERS)
def test_who_may_import_what(package: str) -> None:
    assert {module for module in MODULES if package in imports(module)} <= KEEPERS[package]


def test_the_stand_ins_know_only_the_time_of_a_clock() -> None:
    for module in MODULES:
        if layer(module) in ("rospy", "rclpy"):
            assert {name for name in imports(module) if layer(name) == "clocks"} <= {"clocks.clock", "clocks.frames"}


def test_the_stand_ins_do_not_know_of_each_other() -> None:
    for one, other in (("rospy", "rclpy"), ("rclpy", "rospy")):
        for module in MODULES:
            if layer(module) == one:
                assert not {name for name in imports(module) & MODULES.keys() if layer(name) == other}


def test_transforms_know_nothing_of_ros() -> None:
    for module in MODULES:
        if layer(module) == "tf2":
            assert {layer(name) for name in imports(module) & MODULES.keys()} <= {"tf2"}


def test_data_are_below_the_simulator() -> None:
    data = {"results", "measures", "look", "plots"}
    for module in MODULES:
        if layer(module) in data:
            assert {layer(name) for name in imports(module) & MODULES.keys()} <= data


def test_importing_rosspin_needs_greenlet_and_little_else() -> None:
    code = "import sys; before = set(sys.modules); import rosspin; print(*set(sys.modules) - before)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {module.partition(".")[0] for module in modules} - sys.stdlib_module_names <= {"rosspin", "greenlet"}
