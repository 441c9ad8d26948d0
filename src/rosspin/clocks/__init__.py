"""Time: the wall clock, simulated time, and the parts of Python that run on either."""
