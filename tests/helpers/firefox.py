"""Firefox as Debian has it, by WebDriver BiDi: Playwright's own is another one, and moves no other."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any

from websocket import WebSocket, create_connection

PATIENCE = 300.0  # s

# Keys as WebDriver writes them.
KEYS = {"PageUp": "\ue00e", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012", "ArrowRight": "\ue014"}

# Firefox would otherwise look for updates and the like by itself.
_PREFERENCES = """
user_pref("app.normandy.enabled", false);
user_pref("app.update.disabledForTesting", true);
user_pref("browser.safebrowsing.malware.enabled", false);
user_pref("browser.safebrowsing.phishing.enabled", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("services.settings.server", "data:,");
"""


def firefox() -> str | None:
    """The path of Firefox; None where there is none."""
    return shutil.which("firefox-esr") or shutil.which("firefox")


_HAS_LOADED = "address => document.URL === new URL(address).href && document.readyState === 'complete'"


class Tab:
    """A page in Firefox. Its methods raise RuntimeError with what Firefox says."""

    def __init__(self, socket: WebSocket) -> None:
        self._socket = socket
        self._count = 0
        # When (ms since the epoch) the last page began and ended to be left.
        self._leaves = self._left = -math.inf
        self.wrong: list[str] = []  # errors, and requests that were answered with one
        self._send("session.new", capabilities={})
        self._send("session.subscribe", events=["log.entryAdded", "network.responseCompleted", "network.fetchError"])
        (tab,) = self._send("browsingContext.getTree")["contexts"]
        self._context = tab["context"]

    def _send(self, method: str, **params: Any) -> Any:
        self._count += 1
        self._socket.send(json.dumps({"id": self._count, "method": method, "params": params}))
        while (answer := json.loads(self._socket.recv())).get("id") != self._count:
            self._note(answer.get("method"), answer.get("params"))
        if answer["type"] == "error":
            raise RuntimeError(f"{method}: {answer['message']}")
        return answer["result"]

    def _note(self, event: str, params: Any) -> None:
        if self._leaves <= params["timestamp"] <= self._left:
            return
        if event == "log.entryAdded" and params["level"] == "error":
            self.wrong.append(params["text"])
        if event == "network.responseCompleted" and params["response"]["status"] >= 400:
            self.wrong.append(f"{params['response']['status']} {params['request']['url']}")
        # Of its own accord Firefox asks for an icon and for the next page, and gives that up.
        if event == "network.fetchError" and params["errorText"] != "NS_BINDING_ABORTED":
            self.wrong.append(f"{params['errorText']} {params['request']['url']}")

    def resize(self, width: int, height: int) -> None:
        """Make the page so large (px)."""
        viewport = {"width": width, "height": height}
        self._send("browsingContext.setViewport", context=self._context, viewport=viewport)

    def open(self, address: str) -> None:
        """Go to a page, and wait until it is loaded. What the last one had on its way is given up: that is no error."""
        self._leaves, self._left = 1e3 * time.time(), math.inf
        self._navigate("about:blank")
        self._left = 1e3 * time.time()
        self._navigate(address)

    def _navigate(self, address: str) -> None:
        """The page is asked whether it has loaded: Firefox may take a frame that the last one gives up for it."""
        with suppress(RuntimeError):
            self._send("browsingContext.navigate", context=self._context, url=address, wait="none")
        until = time.monotonic() + PATIENCE
        while not self._has_loaded(address):
            if time.monotonic() > until:
                raise RuntimeError(f"{address} has not loaded")
            time.sleep(0.02)

    def _has_loaded(self, address: str) -> bool:
        try:
            return bool(self.evaluate(_HAS_LOADED, address))
        except RuntimeError:  # the last page has ended, and what was asked there
            return False

    def evaluate(self, function: str, *arguments: Any) -> Any:
        """What a JavaScript function returns that is called with these arguments, or what it promises."""
        call = f"Promise.resolve(({function})(...{json.dumps(arguments)}))"
        expression = f"{call}.then(found => JSON.stringify(found) ?? 'null')"
        target = {"context": self._context}
        answer = self._send("script.evaluate", expression=expression, target=target, awaitPromise=True)
        if answer["type"] == "exception":
            raise RuntimeError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"]["value"])

    def press(self, key: str) -> None:
        """Press a key, named as in KEYS, or a character."""
        value = KEYS.get(key, key)
        self._act("key", [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}])

    def drag(self, places: Sequence[tuple[float, float]]) -> Iterator[None]:
        """Press the mouse's button at the first place (px, of the viewport), and yield at each one after it."""
        (x, y), *others = places
        self._act("pointer", [_move(x, y), {"type": "pointerDown", "button": 0}])
        for x, y in others:
            self._act("pointer", [_move(x, y)])
            yield
        self._act("pointer", [{"type": "pointerUp", "button": 0}])

    def _act(self, kind: str, actions: list[dict[str, Any]]) -> None:
        source = {"type": kind, "id": kind, "actions": actions}
        self._send("input.performActions", context=self._context, actions=[source])


def _move(x: float, y: float) -> dict[str, Any]:
    return {"type": "pointerMove", "x": round(x), "y": round(y)}


@contextmanager
def tab(executable: str) -> Iterator[Tab]:
    """A page in a Firefox without a window, which ends with this context."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        with open(f"{profile}/user.js", "w") as file:
            file.write(_PREFERENCES)
        command = [executable, "--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"]
        # It would not begin if it could not write into its user's home.
        environment = {**os.environ, "HOME": profile}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            address = f"ws://127.0.0.1:{_port(process, Path(profile))}/session"
            with closing(create_connection(address, PATIENCE, suppress_origin=True)) as socket:
                yield Tab(socket)
        finally:
            process.terminate()
            process.wait()


def _port(process: subprocess.Popen[bytes], profile: Path) -> int:
    """Where Firefox listens, which it writes into a file."""
    while process.poll() is None:
        try:
            return int(json.loads((profile / "WebDriverBiDiServer.json").read_text())["ws_port"])
        except (OSError, ValueError):
            time.sleep(0.05)
    raise RuntimeError(f"Firefox ended with status {process.returncode}")
