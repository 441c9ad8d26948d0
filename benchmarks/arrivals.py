"""How long the lines of a node's console are on their way."""

from __future__ import annotations

import io
import re
import time

__all__ = ["Arrivals"]


class Arrivals(io.StringIO):
    """Notes how long after its stamp (s) the first counter came."""

    delay: float | None = None

    def write(self, text: str) -> int:
        """Take what comes."""
        if self.delay is None and (line := re.search(r"\[(\d+\.\d+)\].*counter = 1$", text, re.MULTILINE)):
            self.delay = time.time() - float(line[1])
        return super().write(text)
