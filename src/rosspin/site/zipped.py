"""The built site as one zip, for a stick or a learning platform: ``python -m rosspin.site.zipped``, or ``make zip``.

The same site gives the same zip, byte for byte: its files are sorted, and have one time and one mode.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from ..results.saving import save_whole

__all__ = ["zipped"]

# The zip's one folder, and the page in it that says what to do.
NAME = "rosspin-site"
START = "START-HERE.html"

# What only the next build reads.
_LEFT_OUT = {".buildinfo", ".buildinfo.bak"}


def zipped(site: Path, start: Path, target: Path) -> int:
    """Write the ``site``, in a folder next to the page ``start``, into the file ``target``; return its size (bytes)."""
    files = {path.relative_to(site).as_posix(): path for path in site.rglob("*") if path.is_file()}
    named = {f"site/{name}": path for name, path in files.items() if name not in _LEFT_OUT} | {START: start}
    packed = io.BytesIO()
    with ZipFile(packed, "w", ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(named):
            info = ZipInfo(f"{NAME}/{name}")  # its time is the first that a zip knows
            info.compress_type = ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, named[name].read_bytes())
    save_whole(target, packed.getvalue())
    return target.stat().st_size


def _main() -> None:
    site, start, target = map(Path, ("build/html", "docs/start-here.html", f"build/{NAME}.zip"))
    sys.stdout.write(f"{target}: {zipped(site, start, target) / 1e6:.1f} MB\n")


if __name__ == "__main__":
    _main()
