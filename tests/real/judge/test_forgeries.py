"""Whatever an answer says in place of what came of it, the teachers' table does not take it for a solution."""

from __future__ import annotations

from playwright.sync_api import Browser

from tests.helpers.attacks import FORGERIES
from tests.helpers.hand_ins import Table, solves_nothing
from tests.helpers.readers import reader


def test_no_message_solves_an_exercise(browser: Browser, address: str) -> None:
    with reader(browser) as context:
        solves_nothing(Table(context.new_page(), address), FORGERIES)
