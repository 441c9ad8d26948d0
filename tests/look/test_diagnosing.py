"""Logs whose fault is known are told apart, by the numbers that the page gives; see known_logs.py."""

from __future__ import annotations

import json
from collections import Counter

import pytest
from known_logs import CASES, Case, draw
from known_logs_made import load

from rosspin.look import TITLES, Look, look
from rosspin.look.diagnosing import PAGES
from tree import SITE

# What is not right, and is known to be so: of the recordings, what each is said to be.
HELD_UP = {name for name in TITLES if name == "held-up"}


def verdict(case: Case) -> str:
    return look(load(case), case.name).verdicts[0].name


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_no_verdict_is_wrong(case: Case) -> None:
    assert case.outcome(verdict(case)) in ("right", "open")


def test_most_say_which_fault_it_is() -> None:
    outcomes = Counter(case.outcome(verdict(case)) for case in CASES)
    assert outcomes["right"] >= 0.85 * len(CASES), outcomes


def test_of_faults_drawn_at_random_few_are_wrong() -> None:
    """These seeds were used once, when all was written."""
    outcomes = Counter(case.outcome(verdict(case)) for case in map(draw, range(5000, 5040)))
    assert outcomes["wrong"] <= 2 and outcomes["right"] >= 30, outcomes
