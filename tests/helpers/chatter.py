"""A node whose threads print at the same time."""

from __future__ import annotations

# A node whose threads print at the same time, on both streams.
CHATTER = """
import sys, threading
def chatter(word):
    for _ in range(2000):
        print(word)
        print(word, file=sys.stderr)
for word in 4 * ("one", "two"):
    threading.Thread(target=chatter, args=(word,)).start()
"""
