"""What random tests draw from."""

from __future__ import annotations

import os
import random

# What random tests draw from, Hypothesis's too if it is asked for. CI always draws the same, as Hypothesis does there.
# Processes that share the tests out among them draw once.
DRAWN = "0" if "CI" in os.environ else str(random.SystemRandom().randrange(10**6))

SEED = int(os.environ.get("ROSSPIN_SEED") or os.environ.setdefault("ROSSPIN_DRAWN_SEED", DRAWN))
