"""A folder on a local server, and Chromium to look at it; the tests use both, too."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from io import BytesIO
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from playwright.sync_api import Browser, sync_playwright

# Chromium would otherwise look for updates and the like by itself; without a screen it has no GPU.
_FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


@contextmanager
def served(folder: Path, instead: Mapping[str, bytes] = {}) -> Iterator[str]:
    """Serve a folder on this machine; within this context its address is the one given.

    ``instead`` has what is served in place of some of its files: path -> content.
    """
    handler = partial(_Handler, instead, directory=str(folder))
    with _Server(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


@contextmanager
def launched(executable: str, *flags: str) -> Iterator[Browser]:
    """Chromium, without a window, closed at the end of this context."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=[*_FLAGS, *flags])
        yield browser
        browser.close()


class _Server(ThreadingHTTPServer):
    def handle_error(self, *args: object) -> None:
        pass  # Stop ends a worker that may still be loading


class _Handler(SimpleHTTPRequestHandler):
    def __init__(self, instead: Mapping[str, bytes], *args: Any, **kwargs: Any) -> None:
        self._instead = instead
        super().__init__(*args, **kwargs)

    def send_head(self) -> Any:
        content = self._instead.get(urlsplit(self.path).path.lstrip("/"))
        if content is None:
            return super().send_head()
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(self.path))
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        return BytesIO(content)

    def log_message(self, *args: object) -> None:
        pass
