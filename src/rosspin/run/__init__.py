"""Runs: processes on one clock."""
