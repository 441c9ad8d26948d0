"""Run nodes under many orders of events, find one in which they fail, and show it next to the usual one."""
