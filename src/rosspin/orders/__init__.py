"""Run nodes under many orders of events, find one in which they fail, and show it beside the usual one."""
