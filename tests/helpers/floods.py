"""What code in a page may send without end, and how much of it there is to lay out."""

from __future__ import annotations

BATCH = '{{"kind": "batch", "chunks": [{chunks}], "leftOut": 0, "ticks": [{ticks}]}}'

# What no page takes, as Python that makes the message: of such messages one is enough.
TOO_MUCH = {
    "long lines": BATCH.format(chunks='[false, "%s", 0, 0]' % ("x" * 9), ticks="").replace(
        "x" * 9, "' + 'x' * 5_900_000 + '"
    ),
    "chunks": BATCH.format(chunks="' + ', '.join(['[false, \"x\\\\n\", 0, 0]'] * 60_000) + '", ticks=""),
    "ticks": BATCH.format(chunks="", ticks="' + ', '.join(['[\"a\", 2, 1, 1, 0]'] * 60_000) + '"),
    "lists": "[' + '[],' * 300_000 + '0]",
    "numbers": "[' + '0,' * 600_000 + '0]",
}

# What continues until Stop is pressed, each as much as a page takes.
GOES_ON = """import js, json, time
from pyodide.ffi import create_proxy

message = json.dumps({{"kind": "batch", "leftOut": 0, "chunks": {chunks}, "ticks": {ticks}}})
js.setInterval(create_proxy(lambda: js.postMessage(message)), {ms})
time.sleep(3000)
"""
AS_MUCH = {
    "a line without end": GOES_ON.format(chunks='[[False, "x" * 20_000, 0, 0]]', ticks=[], ms=50),
    "a line in another script": GOES_ON.format(chunks='[[False, "\\u0e01\\u0301" * 4000, 0, 0]]', ticks=[], ms=100),
    "parts of lines": GOES_ON.format(chunks='[[False, "x ", 0, 0]] * 2000', ticks=[], ms=100),
    "lines": GOES_ON.format(chunks='[[True, "x\\n", 0, 0]] * 2000', ticks=[], ms=100),
    "ticks": GOES_ON.format(
        chunks=[], ticks='[["a%d" % (n % 7), 2, n / 1e3, n / 1e3, 0] for n in range(2000)]', ms=200
    ),
    "rows": GOES_ON.format(chunks=[], ticks='[["a%d" % n, 2, n, n, 0] for n in range(2000)]', ms=200),
}

# How much there is to lay out: characters, lines, the longest line, elements of the plot.
SIZE = """cell => {
    const lines = [...cell.querySelectorAll(".live-console pre > *")].map(line => line.textContent.length)
    const plot = cell.querySelectorAll("figure:not(.live-made) svg *").length
    return [lines.reduce((sum, length) => sum + length, 0), lines.length, Math.max(0, ...lines), plot]
}"""
