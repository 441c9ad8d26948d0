"""Prints on both streams, and leaves its last line open."""

import sys
import time


def main():
    print("to stdout", flush=True)
    time.sleep(0.2)
    print("to stderr", file=sys.stderr, flush=True)
    time.sleep(0.2)
    print("two\nlines", flush=True)
    print("the end", end="", flush=True)
