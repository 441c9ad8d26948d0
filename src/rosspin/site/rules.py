"""What the page's own script has to know of rosspin, as JSON for web/build.mjs: its exercises, and common rules.

``python -m rosspin.site.rules`` prints it.
"""

from __future__ import annotations

import json
from typing import Any

from .. import hand_ins
from ..cpp.faults import ADVICE, LENGTHS, NOTES, OF_NO_PLACE, WARNINGS
from ..exercises import EXERCISES
from ..hand_ins.archives import ON_PAGE
from ..hand_ins.files import NUMBERED
from ..plots import layout
from ..run.kinds.cpp import INCLUDES

__all__ = ["defined"]


def defined() -> dict[str, Any]:
    """Return the constants by the names that they have in JavaScript."""
    return {
        "EXERCISES": {each.name: {"number": each.number, "title": each.title} for each in EXERCISES},
        "RULES": {
            "numbered": NUMBERED,
            "handIns": {
                **{"file": hand_ins.MOST_FILE, "answer": hand_ins.MOST_ANSWER, "name": hand_ins.MOST_NAME},
                **{"time": hand_ins.TIME, "said": hand_ins.MOST_SAID, "entries": ON_PAGE.entries},
            },
            "timeline": layout.constants(),
            "cpp": {
                **{
                    "advice": ADVICE,
                    "warnings": WARNINGS,
                    "lengths": LENGTHS,
                    "notes": NOTES,
                    "ofNoPlace": OF_NO_PLACE,
                },
                "includes": INCLUDES.pattern,
            },
        },
    }


if __name__ == "__main__":
    print(json.dumps(defined()))
