"""The third verdict: neither as it should be nor not so, because the machine disturbed the run that was to tell."""

from __future__ import annotations

from typing import NoReturn

import pytest


def inconclusive(reason: str) -> NoReturn:
    """End a test as neither passed nor failed."""
    pytest.skip(f"inconclusive: {reason}")
