#!/usr/bin/env python3
"""A program that is no node."""

import sys

print("plain", sys.argv[1:], flush=True)
