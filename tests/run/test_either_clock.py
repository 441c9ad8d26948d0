"""In simulated time: what a run is on either clock."""

from __future__ import annotations

import pytest

from rosspin import simulate
from tests.helpers.either_clock import *  # noqa: F403
from tests.helpers.either_clock import Run


@pytest.fixture
def run() -> Run:
    return simulate
