"""Packages with messages of their own."""

from __future__ import annotations

from pathlib import Path

WHEEL = """# A wheel
float32 MAX_SPEED=1.5   # m/s
string NAME=front # left
byte FIRST=-1
bool YES=True

Header header
float32 speed       # m/s
int16[3] counts
duration since
"""


def write_package(parent: Path, name: str = "my_robotics_pkg", kind: str = "msg", **definitions: str) -> Path:
    """Write a package with messages (``kind`` srv or action: with these) below a folder; the folder of its nodes."""
    folder = parent / "ws" / "src" / "robots" / name
    for part in (kind, "scripts"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    for message, text in definitions.items():
        (folder / kind / f"{message}.{kind}").write_text(text)
    return folder / "scripts"
