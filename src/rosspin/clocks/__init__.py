"""What time is: the clock on the wall, simulated time, and what of Python runs on either."""
