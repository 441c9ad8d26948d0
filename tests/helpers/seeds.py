"""What random tests draw from."""

from __future__ import annotations

import os
import random

# The same numbers each time, Hypothesis's too; ROSSPIN_SEED is another number, or the word random. Processes that share
# the tests out among them draw once.
if os.environ.get("ROSSPIN_SEED") == "random":
    os.environ["ROSSPIN_SEED"] = str(random.SystemRandom().randrange(10**6))

SEED = int(os.environ.get("ROSSPIN_SEED") or 0)
