"""The names of rclpy: those that a node must not use for its own, and those that the page lists."""

from __future__ import annotations

from pathlib import Path

from bs4 import BeautifulSoup

from .tree import HELPERS

# A node that prints the names that are taken; what it prints on the real ROS 2 is in the file next to it.
NAMES = HELPERS / "rclpy_names_probe.py"

# The same for a program that prints the names of the package after an import.
IMPORTS = HELPERS / "rclpy_imports_probe.py"


def names_of(console: str) -> dict[str, set[str]]:
    """What the probe printed, by kind."""
    return {kind: set(names) for kind, *names in map(str.split, console.splitlines())}


def names_on_page(site: Path) -> dict[str, list[str]]:
    """The names that the page lists, by module."""
    page = BeautifulSoup((site / "docs/reference/rclpy-names.html").read_text(encoding="utf-8"), "html.parser")
    rows = page.select("#supported tbody tr")
    cells = [[[code.get_text() for code in cell.select("code")] for cell in row.select("td")] for row in rows]
    return {module: names for [module], names in cells}
