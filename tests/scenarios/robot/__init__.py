"""Neighbour modules that some scenarios import."""
