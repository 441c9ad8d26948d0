"""The compiler of C++ that pages load: packed once, while pages are read."""

from __future__ import annotations

import hashlib
import json
import lzma
import os
from concurrent.futures import ThreadPoolExecutor
from itertools import repeat
from pathlib import Path

from ..cpp import Part, alone, compiler

__all__ = ["pack", "publish"]


def pack(root: Path) -> None:
    """Pack it for the site in this folder while all else goes first, the stand-ins last, which have to be compiled."""
    os.nice(10)
    for part in sorted(compiler(), key=lambda part: part.ros):
        _pack(part, root)


def _pack(part: Part, root: Path) -> bytes:
    """Return a part of the compiler, packed, and keep that; what another build is packing is waited for."""
    folder = root / f"build/cpp/pages/{part.name}{part.ros or ''}"
    packed = folder / f"{part.key}.xz"
    with alone(folder):
        if not packed.exists():
            beside = packed.with_suffix(".part")
            # A smaller one takes a third longer for 2%.
            beside.write_bytes(lzma.compress(part.make(), check=lzma.CHECK_CRC32, preset=7))
            beside.rename(packed)
    return packed.read_bytes()


def publish(folder: Path, root: Path) -> None:
    """Put the compiler into a folder of the site, packed, each file named by its SHA-256."""
    folder.mkdir(parents=True, exist_ok=True)
    files = {}
    parts = []
    several = sorted(compiler(), key=lambda part: -part.ros)
    with ThreadPoolExecutor(2) as packers:  # to pack takes hardly any of Python's own time
        packed = list(packers.map(_pack, several, repeat(root)))
    for part, data in zip(several, packed):
        digest = hashlib.sha256(data).hexdigest()
        files[f"{digest}.xz"] = data
        parts.append({"name": f"{part.name}.xz", "ros": part.ros, "bytes": len(data), "sha256": digest})
    files["parts.json"] = json.dumps(parts).encode()
    for name, data in files.items():
        (folder / name).write_bytes(data)
    for path in folder.iterdir():
        if path.name not in files:
            path.unlink()
