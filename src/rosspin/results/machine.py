"""Describe the machine that something was measured on, and its software; never by the name of its host or user."""

from __future__ import annotations

import os
import platform
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

__all__ = ["describe"]


def describe(packages: Iterable[str] = ("rosspin",)) -> dict[str, str]:
    """Name the processor, its cores, the system, Python, and the version of each of the packages that is installed."""
    facts = {
        "Processor": _processor(),
        "Cores": str(os.cpu_count() or "unknown"),
        "System": _system(),
        "Python": f"{platform.python_implementation()} {platform.python_version()}",
    }
    for package in packages:
        try:
            facts[package] = version(package)
        except PackageNotFoundError:
            pass
    return facts


def _processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def _system() -> str:
    try:
        name = platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError):
        name = platform.system()
    return f"{name}, {platform.system()} {platform.release()}"
