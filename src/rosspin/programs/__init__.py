"""Compiled nodes as processes of a run: what they ask and tell, wherever they run themselves."""

from .running import Batch, Child, Program, Running

__all__ = ["Batch", "Child", "Program", "Running"]
