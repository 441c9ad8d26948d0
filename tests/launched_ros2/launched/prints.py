"""Prints on both streams, and leaves its last line open."""

import sys


def main():
    print("to stdout", flush=True)
    print("to stderr", file=sys.stderr, flush=True)
    print("two\nlines", flush=True)
    print("the end", end="", flush=True)
