"""The page on which a reader shows a log."""

from __future__ import annotations

from playwright.sync_api import Page, expect

SHOW = "docs/show-your-log.html"


class LogPage:
    def __init__(self, page: Page, address: str) -> None:
        page.goto(address + SHOW)
        self.page = page
        place = page.locator(".rosspin-look")
        self.status = place.locator("> [role=status]")
        self.problem = place.locator("> [role=alert]")
        self.results = place.locator(".look-results")
        self.text = page.get_by_label("Or paste it here")

    def drop(self, *files: tuple[str, list[int] | str]) -> None:
        """Drop files: their names and texts, or bytes."""
        transfer = self.page.evaluate_handle(
            """files => {
                const transfer = new DataTransfer()
                for (const [name, data] of files) {
                    transfer.items.add(new File([typeof data === "string" ? data : new Uint8Array(data)], name))
                }
                return transfer
            }""",
            files,
        )
        zone = self.page.locator(".look-drop")
        zone.dispatch_event("dragover", {"dataTransfer": transfer})
        zone.dispatch_event("drop", {"dataTransfer": transfer})

    def press(self, name: str) -> None:
        self.page.get_by_role("button", name=name, exact=True).click()

    def shows(self, title: str) -> None:
        """Wait until a log is shown whose first verdict is this."""
        expect(self.status).to_contain_text(title)
        expect(self.results).to_be_visible()
        expect(self.problem).to_be_empty()

    def refuses(self, said: str) -> None:
        """Wait until a log is refused, in these words; nothing of the one before is left."""
        expect(self.problem).to_contain_text(said)
        expect(self.results).to_be_hidden()
        expect(self.status).to_be_empty()
