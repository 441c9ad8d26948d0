"""Imports point one way, and each room knows only what it may know."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from graphlib import TopologicalSorter

import pytest

from tests.helpers.tree import ROOT, SOURCE

PACKAGE = SOURCE / "rosspin"

# From the bottom up: a module may import what stands before it.
LAYERS = [
    "clocks",
    "results",
    "vehicle",
    "world",
    "faults",
    "messages",
    "tf2",
    "filters",
    "rospy",
    "rclpy",
    "programs",
    "cpp",
    "run",
    "orders",
    "measures",
    "look",
    "plots",
    "real",
    "doctor",
    "exercises",
    "hand_ins",
    "grading",
    "page",
    "site",
    "pytest_plugin",
    "__init__",
    "__main__",
]

# Whole modules, and parts that name them in annotations: an end of a topic has its node. In the real
# rclpy the modules context, executors, logging_service, parameter_service, qos_overriding_options, time_source, task
# and exceptions do so, too. There is no other circle, not even one of annotations.
PARTS = {
    "rclpy.node": {
        *("rclpy.action", "rclpy.executors", "rclpy.handle", "rclpy.logging_service", "rclpy.parameter_service"),
        *("rclpy.qos_overriding_options", "rclpy.time_source", "rclpy.topics"),
    },
    "rclpy.executors": {"rclpy.context", "rclpy.handle", "rclpy.task"},
    "rclpy.context": {"rclpy.handle"},
    "rclpy.endpoints": {"rclpy.handle"},
    "rclpy.parameter": {"rclpy.exceptions"},
    "run.ros2launch.service": {"run.ros2launch.context", "run.ros2launch.modules", "run.ros2launch.process"},
    "clocks.simulation": {"clocks.stacks"},
}

OF_SPHINX = {
    f"site.{name}"
    for name in (
        "checks",
        "compiling",
        "doctests",
        "exercise_pages",
        "lessons",
        "live",
        "notes",
        "pages",
        "paths",
        "published",
        "search",
        "slides",
        "times",
    )
}

# Packages that only these modules may import.
KEEPERS = {
    "greenlet": {"clocks.stacks"},
    "IPython": {"site.magics"},
    "matplotlib": {"plots", "plots.pictures", "plots.rows", "plots.driven", "plots.two_orders", "plots.vehicle"},
    "js": {"clocks.jspi", "page"},
    "pyodide": {"clocks.jspi", "page"},
    "sphinx": OF_SPHINX,
    "docutils": OF_SPHINX,
    "pytest": {"pytest_plugin"},
    "yaml": {
        *("run.roslaunch.launch", "run.ros2launch.frontend", "run.ros2launch.parameters"),
        *("run.ros2launch.substitutions", "rclpy.arguments", "rclpy.parameter", "messages.ros1", "world.yaml_texts"),
    },
}

MODULES = {
    ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix(".__init__"): path
    for path in PACKAGE.rglob("*.py")
}


@cache
def parsed(module: str) -> ast.Module:
    return ast.parse(MODULES[module].read_text(encoding="utf-8"))


def is_for_annotations(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def statements(node: ast.AST, with_annotations: bool) -> Iterator[ast.AST]:
    yield node
    for child in ast.iter_child_nodes(node):
        if with_annotations or not is_for_annotations(child):
            yield from statements(child, with_annotations)


@cache
def imports(module: str, with_annotations: bool = True) -> set[str]:
    """What a module imports: the package's own modules by their names in MODULES, others by their first word.

    Imports inside of functions count, too; ``with_annotations``: also those that only annotations need.
    """
    folder = list(MODULES[module].relative_to(PACKAGE).parent.parts)
    found = set()
    for node in statements(parsed(module), with_annotations):
        if isinstance(node, ast.Import):
            found |= {outside(alias.name) for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            found.add(outside(node.module or ""))
        elif isinstance(node, ast.ImportFrom):
            base = folder[: len(folder) - node.level + 1] + (node.module.split(".") if node.module else [])
            for alias in node.names:
                names = (".".join([*base, alias.name]), ".".join(base), "__init__")
                found.add(next(name for name in names if name in MODULES))
    return found


def outside(name: str) -> str:
    """The package of a module that is not ours, even if one of ours has its name, as rclpy has."""
    package = name.partition(".")[0]
    return f"the real {package}" if package in MODULES else package


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


def test_there_is_no_circle_but_of_parts_that_name_their_whole() -> None:
    graph = {module: (imports(module) & MODULES.keys()) - {module} for module in MODULES}
    for whole, parts in PARTS.items():
        for part in parts:
            graph[part].remove(whole)
            assert whole not in imports(part, with_annotations=False)
    list(TopologicalSorter(graph).static_order())


def test_the_root_is_small() -> None:
    assert len([path for path in PACKAGE.iterdir() if path.is_file()]) <= 8


def test_what_a_module_offers_is_listed_once() -> None:
    for tree in map(parsed, MODULES):
        for node in tree.body:
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
                names = [each.value for each in ast.walk(node.value) if isinstance(each, ast.Constant)]
                assert len(names) == len(set(names)), ast.unparse(node)


def test_benchmarks_need_nothing_of_the_tests() -> None:
    for path in (ROOT / "benchmarks").glob("*.py"):
        words = path.read_text(encoding="utf-8")
        assert "sys.path" not in words
        assert not re.search(r"^(from|import) tests\b", words, re.MULTILINE)


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


@pytest.mark.parametrize("room", ["tf2", "filters"])
def test_transforms_and_filters_know_nothing_of_ros(room: str) -> None:
    for module in MODULES:
        if layer(module) == room:
            assert {layer(name) for name in imports(module) & MODULES.keys()} <= {room}


def test_data_are_below_the_simulator() -> None:
    data = {"results", "vehicle", "measures", "look", "plots"}
    for module in MODULES:
        if layer(module) in data:
            assert {layer(name) for name in imports(module) & MODULES.keys()} <= data


def test_importing_rosspin_needs_greenlet_and_little_else() -> None:
    code = "import sys; before = set(sys.modules); import rosspin; print(*set(sys.modules) - before)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {module.partition(".")[0] for module in modules} - sys.stdlib_module_names <= {"rosspin", "greenlet"}
