"""In simulated time: what a run is on either clock."""

from __future__ import annotations

import pytest
from either_clock import *  # noqa: F403
from either_clock import Run

from rosspin import simulate


@pytest.fixture
def run() -> Run:
    return simulate
