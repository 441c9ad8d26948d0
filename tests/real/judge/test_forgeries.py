"""Whatever an answer says in place of what came of it, the teachers' table does not take it for a solution."""

from __future__ import annotations

from attacks import FORGERIES
from hand_ins import Table, solves_nothing
from playwright.sync_api import Browser
from readers import reader


def test_no_message_solves_an_exercise(browser: Browser, address: str) -> None:
    with reader(browser) as context:
        solves_nothing(Table(context.new_page(), address), FORGERIES)
